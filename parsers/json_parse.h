/*
 * Values of one parsed line: typed, checked, and blamed by their place when
 * they are wrong: "line 3: geometries[0].polygons[2].surface: not a whole
 * number".
 */
#ifndef TESSERA_JSON_PARSE_H
#define TESSERA_JSON_PARSE_H

#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "fault.h"
#include "tcs_field.h"

#define JSON_PLACE_DEPTH 6 /* more than records nest */

/* Where in the line the parser is. */
struct json_place {
	uint64_t line;
	size_t depth;
	struct {
		const char *key;
		size_t index; /* in its array; JSON_NO_INDEX: no array */
	} steps[JSON_PLACE_DEPTH];
	struct tcs_fault *fault;
};

#define JSON_NO_INDEX SIZE_MAX

void json_enter(struct json_place *place, const char *key, size_t index);
void json_leave(struct json_place *place);

/* TCS_BAD_INPUT at the place, or at `key` below it unless that is NULL. */
enum tcs_status json_fault(struct json_place *place, const char *key,
	const char *what) TCS_CHECKED;

/* A whole number from 0 to `high`. */
enum tcs_status json_get_index(struct json_place *place, const char *key,
	const json_t *value, uint64_t high, uint64_t *out) TCS_CHECKED;

/* `count` numbers in an array; all must be finite. */
enum tcs_status json_get_doubles(struct json_place *place, const char *key,
	const json_t *value, double *out, size_t count) TCS_CHECKED;

/*
 * The array under `key`, or *out = NULL where there is none. Anything else
 * there is a fault.
 */
enum tcs_status json_get_array(struct json_place *place, const json_t *object,
	const char *key, const json_t **out) TCS_CHECKED;

/*
 * Fill an element from the object `value`: the fields of the table, those
 * missing as they are by default, text appended to the record's text array.
 * Every other key must be one of `nested`, a list up to NULL.
 */
enum tcs_status json_get_fields(struct json_place *place, const json_t *value,
	const struct tcs_fields *fields, const char *const *nested,
	void *element, struct tcs_strings *text_array) TCS_CHECKED;

#endif
