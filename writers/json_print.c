#include "json_print.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base64.h"
#include "labels.h"
#include "number.h"

void
json_text_clear(struct json_text *json)
{
	array_clear(&json->bytes);
	json->failed = false;
}

void
json_text_release(struct json_text *json)
{
	array_release(&json->bytes);
}

enum tcs_status
json_text_status(const struct json_text *json, struct tcs_fault *fault)
{
	return json->failed ? fault_memory(fault) : TCS_OK;
}

/* Room for `length` more bytes, or NULL. */
static char *
json_room(struct json_text *json, size_t length)
{
	if (json->failed || array_grow(&json->bytes, length)) {
		json->failed = true;
		return NULL;
	}
	return json->bytes.at + json->bytes.count;
}

static void
json_append(struct json_text *json, const char *text, size_t length)
{
	char *at = json_room(json, length);

	if (!at)
		return;
	memcpy(at, text, length);
	json->bytes.count += length;
}

void
json_raw(struct json_text *json, const char *text)
{
	json_append(json, text, strlen(text));
}

void
json_comma(struct json_text *json)
{
	size_t count = json->bytes.count;
	char last = count ? json->bytes.at[count - 1] : '{';

	if (last != '{' && last != '[')
		json_append(json, ",", 1);
}

void
json_key(struct json_text *json, const char *name)
{
	json_comma(json);
	json_append(json, "\"", 1);
	json_raw(json, name);
	json_append(json, "\":", 2);
}

static void
json_escape(struct json_text *json, unsigned char character)
{
	static const char named[] = "\bb\ff\nn\rr\tt\"\"\\\\";
	char out[8];

	for (size_t i = 0; named[i]; i += 2) {
		if ((unsigned char)named[i] != character)
			continue;
		out[0] = '\\';
		out[1] = named[i + 1];
		json_append(json, out, 2);
		return;
	}
	snprintf(out, sizeof out, "\\u%04x", character);
	json_append(json, out, 6);
}

void
json_string(struct json_text *json, const char *text)
{
	const char *from = text;

	json_append(json, "\"", 1);
	for (; *text; text++) {
		unsigned char character = (unsigned char)*text;

		if (character >= ' ' && character != '"' && character != '\\')
			continue;
		json_append(json, from, (size_t)(text - from));
		json_escape(json, character);
		from = text + 1;
	}
	json_append(json, from, (size_t)(text - from));
	json_append(json, "\"", 1);
}

void
json_unsigned(struct json_text *json, uint64_t value)
{
	char digits[20];
	size_t at = sizeof digits;

	do {
		digits[--at] = (char)('0' + value % 10);
		value /= 10;
	} while (value);
	json_append(json, digits + at, sizeof digits - at);
}

void
json_double(struct json_text *json, double value)
{
	char *at;

	if (isnan(value)) {
		json_raw(json, "null");
		return;
	}
	if (isinf(value)) {
		json_raw(json, value < 0 ? "\"-inf\"" : "\"inf\"");
		return;
	}
	at = json_room(json, NUMBER_LENGTH);
	if (at)
		json->bytes.count += number_print(at, value);
}

void
json_doubles(struct json_text *json, const double *at, size_t count)
{
	json_append(json, "[", 1);
	for (size_t i = 0; i < count; i++) {
		if (i)
			json_append(json, ",", 1);
		json_double(json, at[i]);
	}
	json_append(json, "]", 1);
}

/* The fewest digits that come back as the same float by way of a double. */
static void
json_float(struct json_text *json, float value)
{
	char digits[32];

	if (!isfinite(value)) {
		json_double(json, (double)value);
		return;
	}
	for (int precision = 1; precision <= 9; precision++) {
		snprintf(digits, sizeof digits, "%.*g", precision,
			(double)value);
		if ((float)strtod(digits, NULL) == value)
			break;
	}
	json_raw(json, digits);
}

void
json_bytes(struct json_text *json, const unsigned char *bytes, size_t count)
{
	size_t length = BASE64_LENGTH(count);
	char *at;

	json_append(json, "\"", 1);
	at = json_room(json, length);
	if (at) {
		base64_encode(at, bytes, count);
		json->bytes.count += length;
	}
	json_append(json, "\"", 1);
}

/* ---- fields ---------------------------------------------------------- */

static bool
is_left_out(const struct tcs_field *field, const void *element)
{
	static const char zero[128];
	const char *at = (const char *)element + field->at;

	switch (field->type) {
	case FIELD_RUN:
		return true;
	case FIELD_CLASS:
	case FIELD_INDEX:
	case FIELD_NAMED:
		return false;
	case FIELD_LINK:
		return field_get(field, element) == TCS_NONE;
	case FIELD_LOD:
		return field_get(field, element) == TCS_LOD_NONE;
	default:
		return !memcmp(at, zero, field->size * field->count);
	}
}

static void
json_flags(struct json_text *json, uint64_t flags, const char *const *names)
{
	json_raw(json, "[");
	for (; *names; names++, flags >>= 1) {
		if (!(flags & 1))
			continue;
		json_comma(json);
		json_string(json, *names);
	}
	/* bits without a name, as they stand behind the named ones */
	if (flags) {
		json_comma(json);
		json_unsigned(json, flags);
	}
	json_raw(json, "]");
}

static void
json_class(struct json_text *json, uint64_t class)
{
	if (class < TCS_CLASS_COUNT)
		json_string(json, label_of((unsigned)class)->name);
	else
		json_unsigned(json, class);
}

static void
json_numbers(
	struct json_text *json, const struct tcs_field *field, const char *at)
{
	if (field->count > 1)
		json_raw(json, "[");
	for (size_t i = 0; i < field->count; i++, at += field->size) {
		double wide;
		float narrow;

		if (i)
			json_raw(json, ",");
		if (field->type == FIELD_DOUBLE) {
			memcpy(&wide, at, sizeof wide);
			json_double(json, wide);
		} else {
			memcpy(&narrow, at, sizeof narrow);
			json_float(json, narrow);
		}
	}
	if (field->count > 1)
		json_raw(json, "]");
}

static void
json_integer(struct json_text *json, int32_t value)
{
	if (value < 0)
		json_raw(json, "-");
	json_unsigned(json, (uint64_t)(value < 0 ? -(int64_t)value : value));
}

static void
json_field(struct json_text *json, const struct tcs_field *field,
	const void *element, const char *text)
{
	uint64_t value = field->count == 1 ? field_get(field, element) : 0;

	switch (field->type) {
	case FIELD_TEXT:
		json_string(json, text + value);
		break;
	case FIELD_CLASS:
		json_class(json, value);
		break;
	case FIELD_YES:
		json_raw(json, "true");
		break;
	case FIELD_INTEGER:
		json_integer(json, (int32_t)(uint32_t)value);
		break;
	case FIELD_NAMED:
		json_string(json, field->names[value]);
		break;
	case FIELD_FLAGS:
		json_flags(json, value, field->names);
		break;
	case FIELD_DOUBLE:
	case FIELD_FLOAT:
		json_numbers(json, field, (const char *)element + field->at);
		break;
	default:
		json_unsigned(json, value);
		break;
	}
}

void
json_fields(struct json_text *json, const struct tcs_fields *fields,
	const void *element, const char *text)
{
	for (size_t i = 0; i < fields->count; i++) {
		const struct tcs_field *field = &fields->at[i];

		if (is_left_out(field, element))
			continue;
		json_key(json, field->name);
		json_field(json, field, element, text);
	}
}
