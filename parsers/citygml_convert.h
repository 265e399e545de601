/*
 * A whole CityGML document to a stream: the passes over the input, the crew
 * that works on objects, the head.
 *
 * Pass by pass: global appearances first, if a quick look finds any; then the
 * objects, written as they come. Objects that link to other top-level features
 * wait: one pass collects what they link to, one more writes them, after all
 * others. All but the second read only those parts of the document that they
 * need, wherever these are known.
 */
#ifndef TESSERA_CITYGML_CONVERT_H
#define TESSERA_CITYGML_CONVERT_H

#include <stdio.h>

#include "citygml_build.h"
#include "citygml_reader.h"
#include "input.h"
#include "program.h"
#include "report.h"

struct convert_options {
	struct lod_choice lods;
	struct gml_options reading;
	bool compress; /* the records */
};

/*
 * Read all of `input` and write the stream to `file`, with `command` giving
 * the name of the source, the jobs, and what the head is signed with. What
 * happened is in *report, also after a failure.
 */
enum tcs_status citygml_convert(struct input *input, FILE *file,
	const struct convert_options *options, const struct command *command,
	struct report *report, struct tcs_fault *fault) TCS_CHECKED;

#endif
