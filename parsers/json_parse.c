#include "json_parse.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "labels.h"
#include "tcs.h"

void
json_enter(struct json_place *place, const char *key, size_t index)
{
	place->steps[place->depth].key = key;
	place->steps[place->depth].index = index;
	place->depth++;
}

void
json_leave(struct json_place *place)
{
	place->depth--;
}

enum tcs_status
json_fault(struct json_place *place, const char *key, const char *what)
{
	char path[160] = "";
	size_t used = 0;

	for (size_t i = 0; i < place->depth && used < sizeof path; i++) {
		const char *dot = used ? "." : "";
		int length = place->steps[i].index == JSON_NO_INDEX
			? snprintf(path + used, sizeof path - used, "%s%s", dot,
				  place->steps[i].key)
			: snprintf(path + used, sizeof path - used, "%s%s[%zu]",
				  dot, place->steps[i].key,
				  place->steps[i].index);

		used += (size_t)length;
	}
	if (key && used < sizeof path)
		snprintf(path + used, sizeof path - used, "%s%.60s",
			used ? "." : "", key);
	return fault_set(place->fault, TCS_BAD_INPUT, TCS_NOWHERE,
		"line %llu: %s%s%s", (unsigned long long)place->line, path,
		*path ? ": " : "", what);
}

/* ---- values ---------------------------------------------------------- */

/* Numbers arrive as reals throughout: no integer loses its sign or range. */
enum tcs_status
json_get_index(struct json_place *place, const char *key, const json_t *value,
	uint64_t high, uint64_t *out)
{
	double number = json_real_value(value);

	if (!json_is_real(value) || !(number >= 0) || number != floor(number) ||
		number > (double)high)
		return json_fault(
			place, key, "not a whole number, or one out of range");
	*out = (uint64_t)number;
	return TCS_OK;
}

/* A number, null for NaN, "inf", "-inf". */
/* From here on doubles round to no finite float; the shortest digits of the
   largest float are between the two. */
#define FLOAT_END 0x1.ffffffp127

static bool
get_double(const json_t *value, double *out)
{
	if (json_is_real(value))
		*out = json_real_value(value);
	else if (json_is_null(value))
		*out = NAN;
	else if (json_is_string(value) &&
		!strcmp(json_string_value(value), "inf"))
		*out = INFINITY;
	else if (json_is_string(value) &&
		!strcmp(json_string_value(value), "-inf"))
		*out = -INFINITY;
	else
		return false;
	return true;
}

enum tcs_status
json_get_doubles(struct json_place *place, const char *key, const json_t *value,
	double *out, size_t count)
{
	if (!json_is_array(value) || json_array_size(value) != count)
		return json_fault(
			place, key, "not an array of so many numbers");
	for (size_t i = 0; i < count; i++) {
		const json_t *number = json_array_get(value, i);

		if (!json_is_real(number))
			return json_fault(place, key, "not a number");
		out[i] = json_real_value(number);
	}
	return TCS_OK;
}

enum tcs_status
json_get_array(struct json_place *place, const json_t *object, const char *key,
	const json_t **out)
{
	*out = json_object_get(object, key);
	if (*out && !json_is_array(*out))
		return json_fault(place, key, "not an array");
	return TCS_OK;
}

/* ---- fields ---------------------------------------------------------- */

static enum tcs_status
get_text(struct json_place *place, const struct tcs_field *field,
	const json_t *value, void *element, struct tcs_strings *text_array)
{
	enum tcs_status status;
	tcs_text text;

	if (!json_is_string(value))
		return json_fault(place, field->name, "not a string");
	status = text_append_to(text_array, json_string_value(value),
		json_string_length(value), &text, place->fault);
	if (!status)
		field_set(field, element, text);
	return status;
}

static enum tcs_status
get_class(struct json_place *place, const struct tcs_field *field,
	const json_t *value, void *element)
{
	uint64_t class;
	enum tcs_status status;

	if (json_is_string(value)) {
		const char *name = json_string_value(value);

		class = label_find(name, strlen(name));
		if (class == TCS_CLASS_Unknown && strcmp(name, "Unknown") != 0)
			return json_fault(place, field->name, "no such class");
		field_set(field, element, class);
		return TCS_OK;
	}
	status = json_get_index(place, field->name, value, UINT16_MAX, &class);
	if (!status)
		field_set(field, element, class);
	return status;
}

/* The position of a string in the list; the list's length for none. */
static size_t
find_name(const char *const *names, const json_t *value)
{
	const char *name = json_string_value(value);
	size_t i = 0;

	while (names[i] && (!name || strcmp(names[i], name) != 0))
		i++;
	return i;
}

static size_t
count_names(const char *const *names)
{
	size_t count = 0;

	while (names[count])
		count++;
	return count;
}

static enum tcs_status
get_named(struct json_place *place, const struct tcs_field *field,
	const json_t *value, void *element)
{
	size_t at = find_name(field->names, value);

	if (!field->names[at])
		return json_fault(place, field->name, "no such name");
	field_set(field, element, at);
	return TCS_OK;
}

/* Names of bits, and a number for those behind the named ones. */
static enum tcs_status
get_flags(struct json_place *place, const struct tcs_field *field,
	const json_t *value, void *element)
{
	size_t named = count_names(field->names);
	uint64_t high = (((uint64_t)1 << 8 * field->size) - 1) >> named;
	uint64_t flags = 0;

	if (!json_is_array(value))
		return json_fault(place, field->name, "not an array");
	for (size_t i = 0; i < json_array_size(value); i++) {
		const json_t *item = json_array_get(value, i);
		size_t at = find_name(field->names, item);
		uint64_t more = 0;

		if (field->names[at]) {
			flags |= (uint64_t)1 << at;
			continue;
		}
		if (json_get_index(place, field->name, item, high, &more))
			return place->fault->status;
		flags |= more << named;
	}
	field_set(field, element, flags);
	return TCS_OK;
}

static enum tcs_status
get_integer(struct json_place *place, const struct tcs_field *field,
	const json_t *value, void *element)
{
	double number = json_real_value(value);

	if (!json_is_real(value) || number != floor(number) ||
		number < INT32_MIN || number > INT32_MAX)
		return json_fault(place, field->name,
			"not a whole number, or one out of range");
	field_set(field, element, (uint32_t)(int32_t)number);
	return TCS_OK;
}

static enum tcs_status
get_numbers(struct json_place *place, const struct tcs_field *field,
	const json_t *value, void *element)
{
	char *at = (char *)element + field->at;

	if (field->count > 1 &&
		(!json_is_array(value) ||
			json_array_size(value) != field->count))
		return json_fault(
			place, field->name, "not an array of so many numbers");
	for (size_t i = 0; i < field->count; i++, at += field->size) {
		double wide;
		float narrow;

		if (!get_double(
			    field->count > 1 ? json_array_get(value, i) : value,
			    &wide))
			return json_fault(place, field->name, "not a number");
		if (field->type == FIELD_FLOAT && isfinite(wide) &&
			fabs(wide) >= FLOAT_END)
			return json_fault(place, field->name, "out of range");
		narrow = (float)wide;
		memcpy(at,
			field->type == FIELD_DOUBLE ? (void *)&wide
						    : (void *)&narrow,
			field->size);
	}
	return TCS_OK;
}

static enum tcs_status
get_yes(struct json_place *place, const struct tcs_field *field,
	const json_t *value, void *element)
{
	if (!json_is_boolean(value))
		return json_fault(place, field->name, "not true or false");
	field_set(field, element, json_is_true(value));
	return TCS_OK;
}

static enum tcs_status
get_count(struct json_place *place, const struct tcs_field *field,
	const json_t *value, void *element)
{
	uint64_t most = field->size == 8 ? (uint64_t)1 << 53
					 : ((uint64_t)1 << 8 * field->size) - 1;
	uint64_t number;
	enum tcs_status status =
		json_get_index(place, field->name, value, most, &number);

	if (!status)
		field_set(field, element, number);
	return status;
}

static enum tcs_status
get_field(struct json_place *place, const struct tcs_field *field,
	const json_t *value, void *element, struct tcs_strings *text_array)
{
	switch (field->type) {
	case FIELD_TEXT:
		return get_text(place, field, value, element, text_array);
	case FIELD_CLASS:
		return get_class(place, field, value, element);
	case FIELD_NAMED:
		return get_named(place, field, value, element);
	case FIELD_FLAGS:
		return get_flags(place, field, value, element);
	case FIELD_INTEGER:
		return get_integer(place, field, value, element);
	case FIELD_DOUBLE:
	case FIELD_FLOAT:
		return get_numbers(place, field, value, element);
	case FIELD_YES:
		return get_yes(place, field, value, element);
	default:
		return get_count(place, field, value, element);
	}
}

static bool
is_required(const struct tcs_field *field)
{
	return field->type == FIELD_CLASS || field->type == FIELD_INDEX ||
		field->type == FIELD_NAMED;
}

static bool
is_listed(const char *const *names, const char *name)
{
	for (; *names; names++)
		if (!strcmp(*names, name))
			return true;
	return false;
}

enum tcs_status
json_get_fields(struct json_place *place, const json_t *value,
	const struct tcs_fields *fields, const char *const *nested,
	void *element, struct tcs_strings *text_array)
{
	const char *key;
	json_t *item;

	if (!json_is_object(value))
		return json_fault(place, NULL, "not an object");
	json_object_foreach((json_t *)(uintptr_t)value, key,
		item) if (!fields_find(fields, key) &&
		!is_listed(nested, key)) return json_fault(place, key,
		"no such key here");
	fields_default(fields, element);
	for (size_t i = 0; i < fields->count; i++) {
		const struct tcs_field *field = &fields->at[i];
		enum tcs_status status;

		item = field->type == FIELD_RUN
			? NULL
			: json_object_get(value, field->name);
		if (!item && is_required(field))
			return json_fault(place, field->name, "missing");
		if (!item)
			continue;
		status = get_field(place, field, item, element, text_array);
		if (status)
			return status;
	}
	return TCS_OK;
}
