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
print_append(struct json_text *json, const char *text, size_t length)
{
	char *at = json_room(json, length);

	if (!at)
		return;
	memcpy(at, text, length);
	json->bytes.count += length;
}

void
print_raw(struct json_text *json, const char *text)
{
	print_append(json, text, strlen(text));
}

void
print_comma(struct json_text *json)
{
	size_t count = json->bytes.count;
	char last = count ? json->bytes.at[count - 1] : '{';

	if (last != '{' && last != '[')
		print_append(json, ",", 1);
}

void
print_key(struct json_text *json, const char *name)
{
	print_comma(json);
	print_append(json, "\"", 1);
	print_raw(json, name);
	print_append(json, "\":", 2);
}

static void
print_escape(struct json_text *json, unsigned char character)
{
	static const char named[] = "\bb\ff\nn\rr\tt\"\"\\\\";
	char out[8];

	for (size_t i = 0; named[i]; i += 2) {
		if ((unsigned char)named[i] != character)
			continue;
		out[0] = '\\';
		out[1] = named[i + 1];
		print_append(json, out, 2);
		return;
	}
	snprintf(out, sizeof out, "\\u%04x", character);
	print_append(json, out, 6);
}

void
print_string(struct json_text *json, const char *text)
{
	const char *from = text;

	print_append(json, "\"", 1);
	for (; *text; text++) {
		unsigned char character = (unsigned char)*text;

		if (character >= ' ' && character != '"' && character != '\\')
			continue;
		print_append(json, from, (size_t)(text - from));
		print_escape(json, character);
		from = text + 1;
	}
	print_append(json, from, (size_t)(text - from));
	print_append(json, "\"", 1);
}

void
print_unsigned(struct json_text *json, uint64_t value)
{
	char digits[20];
	size_t at = sizeof digits;

	do {
		digits[--at] = (char)('0' + value % 10);
		value /= 10;
	} while (value);
	print_append(json, digits + at, sizeof digits - at);
}

void
print_double(struct json_text *json, double value)
{
	char *at;

	if (isnan(value)) {
		print_raw(json, "null");
		return;
	}
	if (isinf(value)) {
		print_raw(json, value < 0 ? "\"-inf\"" : "\"inf\"");
		return;
	}
	at = json_room(json, NUMBER_LENGTH);
	if (at)
		json->bytes.count += number_print(at, value);
}

void
print_doubles(struct json_text *json, const double *at, size_t count)
{
	print_append(json, "[", 1);
	for (size_t i = 0; i < count; i++) {
		if (i)
			print_append(json, ",", 1);
		print_double(json, at[i]);
	}
	print_append(json, "]", 1);
}

/* The fewest digits that come back as the same float by way of a double. */
static void
print_float(struct json_text *json, float value)
{
	char digits[32];

	if (!isfinite(value)) {
		print_double(json, (double)value);
		return;
	}
	for (int precision = 1; precision <= 9; precision++) {
		snprintf(digits, sizeof digits, "%.*g", precision,
			(double)value);
		if ((float)strtod(digits, NULL) == value)
			break;
	}
	print_raw(json, digits);
}

void
print_bytes(struct json_text *json, const unsigned char *bytes, size_t count)
{
	size_t length = BASE64_LENGTH(count);
	char *at;

	print_append(json, "\"", 1);
	at = json_room(json, length);
	if (at) {
		base64_encode(at, bytes, count);
		json->bytes.count += length;
	}
	print_append(json, "\"", 1);
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
print_flags(struct json_text *json, uint64_t flags, const char *const *names)
{
	print_raw(json, "[");
	for (; *names; names++, flags >>= 1) {
		if (!(flags & 1))
			continue;
		print_comma(json);
		print_string(json, *names);
	}
	/* bits without a name, as they stand behind the named ones */
	if (flags) {
		print_comma(json);
		print_unsigned(json, flags);
	}
	print_raw(json, "]");
}

static void
print_class(struct json_text *json, uint64_t class)
{
	if (class < TCS_CLASS_COUNT)
		print_string(json, label_of((unsigned)class)->name);
	else
		print_unsigned(json, class);
}

static void
print_numbers(
	struct json_text *json, const struct tcs_field *field, const char *at)
{
	if (field->count > 1)
		print_raw(json, "[");
	for (size_t i = 0; i < field->count; i++, at += field->size) {
		double wide;
		float narrow;

		if (i)
			print_raw(json, ",");
		if (field->type == FIELD_DOUBLE) {
			memcpy(&wide, at, sizeof wide);
			print_double(json, wide);
		} else {
			memcpy(&narrow, at, sizeof narrow);
			print_float(json, narrow);
		}
	}
	if (field->count > 1)
		print_raw(json, "]");
}

static void
print_integer(struct json_text *json, int32_t value)
{
	if (value < 0)
		print_raw(json, "-");
	print_unsigned(json, (uint64_t)(value < 0 ? -(int64_t)value : value));
}

static void
print_field(struct json_text *json, const struct tcs_field *field,
	const void *element, const char *text)
{
	uint64_t value = field->count == 1 ? field_get(field, element) : 0;

	switch (field->type) {
	case FIELD_TEXT:
		print_string(json, text + value);
		break;
	case FIELD_CLASS:
		print_class(json, value);
		break;
	case FIELD_YES:
		print_raw(json, "true");
		break;
	case FIELD_INTEGER:
		print_integer(json, (int32_t)(uint32_t)value);
		break;
	case FIELD_NAMED:
		print_string(json, field->names[value]);
		break;
	case FIELD_FLAGS:
		print_flags(json, value, field->names);
		break;
	case FIELD_DOUBLE:
	case FIELD_FLOAT:
		print_numbers(json, field, (const char *)element + field->at);
		break;
	default:
		print_unsigned(json, value);
		break;
	}
}

void
print_fields(struct json_text *json, const struct tcs_fields *fields,
	const void *element, const char *text)
{
	for (size_t i = 0; i < fields->count; i++) {
		const struct tcs_field *field = &fields->at[i];

		if (is_left_out(field, element))
			continue;
		print_key(json, field->name);
		print_field(json, field, element, text);
	}
}
