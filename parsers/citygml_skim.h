/*
 * Where the global appearances and the bounds of the model stand, found by
 * looking at bytes: much faster than a parser, for a pass that reads nothing
 * else.
 *
 * source: XML 1.0, fifth edition: 2.4 to 2.7, 3.1, 4.3.3.
 */
#ifndef TESSERA_CITYGML_SKIM_H
#define TESSERA_CITYGML_SKIM_H

#include "citygml_parts.h"
#include "input.h"

enum skim_result {
	SKIM_NONE, /* there are none */
	SKIM_PARTS, /* these are all */
	SKIM_UNSURE, /* there may be some: in an encoding without ASCII's
	                bytes, behind a document type, in what is no XML */
};

/* Look through all of the input; append the places found to `parts`, those of
 * the bounds only if there are appearances. */
enum tcs_status skim_appearances(struct input *input,
	struct document_parts *parts, enum skim_result *result,
	struct tcs_fault *fault) TCS_CHECKED;

#endif
