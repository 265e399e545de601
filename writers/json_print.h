/*
 * JSON as text that grows. Nothing here fails: what memory refuses is
 * remembered, and json_text_status tells at the end.
 */
#ifndef TESSERA_JSON_PRINT_H
#define TESSERA_JSON_PRINT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "array.h"
#include "fault.h"
#include "tcs_field.h"

/* All zero is empty. */
struct json_text {
	TCS_ARRAY(char) bytes;
	bool failed; /* memory is out; the text is incomplete */
};

void json_text_clear(struct json_text *json);
void json_text_release(struct json_text *json);
enum tcs_status json_text_status(
	const struct json_text *json, struct tcs_fault *fault) TCS_CHECKED;

/* Punctuation as it is. */
void print_raw(struct json_text *json, const char *text);

/* "name": with a comma before it unless something opens right there. */
void print_key(struct json_text *json, const char *name);

/* A comma, unless something opens right there. */
void print_comma(struct json_text *json);

/* A string, quoted and escaped. */
void print_string(struct json_text *json, const char *text);

void print_unsigned(struct json_text *json, uint64_t value);

/* Shortest to read back; null for NaN, "inf" and "-inf" as strings. */
void print_double(struct json_text *json, double value);

/* [1,2,3] */
void print_doubles(struct json_text *json, const double *at, size_t count);

/* A string in base64. */
void print_bytes(
	struct json_text *json, const unsigned char *bytes, size_t count);

/*
 * The fields of an element as keys and values, those left out that the table
 * leaves out; no braces. `text` is the text array of the record.
 */
void print_fields(struct json_text *json, const struct tcs_fields *fields,
	const void *element, const char *text);

#endif
