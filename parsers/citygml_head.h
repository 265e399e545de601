/*
 * The head of a stream that comes from CityGML: which coordinate system, what
 * was assumed about it, where the data lies.
 */
#ifndef TESSERA_CITYGML_HEAD_H
#define TESSERA_CITYGML_HEAD_H

#include "citygml_reader.h"
#include "program.h"
#include "tcs.h"

/*
 * Fill an empty head from what the reader knows once the first object is
 * complete; `first` is that object, NULL when the document has none. Notes
 * about assumptions go to the reader's report.
 */
enum tcs_status head_build(struct tcs_head *head, struct gml_reader *reader,
	const struct raw_object *first, const struct command *command,
	struct tcs_fault *fault) TCS_CHECKED;

#endif
