/*
 * Records from parsed lines of JSON; json2tcs(1) says what these hold.
 */
#ifndef TESSERA_JSON_BUILD_H
#define TESSERA_JSON_BUILD_H

#include <jansson.h>

#include "json_parse.h"
#include "tcs.h"

/* What building needs; one per thread, reused. All zero is empty. */
struct json_builder {
	struct tcs_head head;
	struct tcs_palette palette;
	struct tcs_object object;
};

void json_builder_release(struct json_builder *builder);

/*
 * Build the record that a line describes. The end line gives a record of type
 * TCS_END without bytes and fills *claimed. The runs of an object are right by
 * construction; the other rules are for the decoder to check. Fails with
 * TCS_BAD_INPUT, TCS_LIMIT, TCS_NO_MEMORY; the text names the line.
 */
enum tcs_status json_build_line(struct json_builder *builder, const char *line,
	size_t length, uint64_t number, struct tcs_record *record,
	struct tcs_tally *claimed, struct tcs_fault *fault) TCS_CHECKED;

/* The keys of an object or prototype into an empty object. */
enum tcs_status json_build_object(struct json_place *place, const json_t *line,
	struct tcs_object *object) TCS_CHECKED;

#endif
