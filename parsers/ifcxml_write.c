#include "ifcxml_write.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "ifcxml_names.h"
#include "number.h"

enum tcs_status
ifcxml_put(struct step_bytes *out, const char *bytes, size_t length,
	struct tcs_fault *fault)
{
	if (!length)
		return TCS_OK;
	if (array_grow(out, length))
		return fault_memory(fault);
	memcpy(out->at + out->count, bytes, length);
	out->count += length;
	return TCS_OK;
}

static enum tcs_status
put_string(struct step_bytes *out, const char *string, struct tcs_fault *fault)
{
	return ifcxml_put(out, string, strlen(string), fault);
}

void
ifcxml_instance_release(struct ifcxml_instance *instance)
{
	array_release(&instance->slots);
	array_release(&instance->text);
}

enum tcs_status
ifcxml_instance_begin(struct ifcxml_instance *instance,
	enum ifc_version version, enum ifc_entity entity, uint32_t number,
	struct tcs_fault *fault)
{
	size_t count =
		entity == IFC_NONE ? 0 : ifc_attribute_count(version, entity);

	instance->entity = entity;
	instance->number = number;
	instance->text.count = 0;
	instance->slots.count = 0;
	if (array_grow(&instance->slots, count + 1))
		return fault_memory(fault);
	memset(instance->slots.at, 0, count * sizeof *instance->slots.at);
	instance->slots.count = count;
	return TCS_OK;
}

struct ifcxml_slot *
ifcxml_slot_begin(
	struct ifcxml_instance *instance, int position, const char *attribute)
{
	struct ifcxml_slot *slot = instance->slots.at + position;

	*slot = (struct ifcxml_slot){.at = instance->text.count,
		.end = instance->text.count,
		.row = ifcxml_row_length(instance->entity, attribute),
		.list = ifcxml_is_list(instance->entity, attribute)};
	return slot;
}

/* ---- values -------------------------------------------------------------- */

static bool
is_blank(char byte)
{
	return byte == ' ' || byte == '\t' || byte == '\n' || byte == '\r';
}

/* Take the blanks at both ends away. */
static void
trim(const char **text, size_t *length)
{
	while (*length && is_blank(**text))
		(*text)++, (*length)--;
	while (*length && is_blank((*text)[*length - 1]))
		(*length)--;
}

/* Behind the next word; *begin is where it begins. */
static const char *
word_next(const char *at, const char *end, const char **begin)
{
	while (at < end && is_blank(*at))
		at++;
	*begin = at;
	while (at < end && !is_blank(*at))
		at++;
	return at;
}

/* How many words there are, if all are finite numbers; else 0. */
static size_t
count_numbers(const char *text, size_t length)
{
	const char *end = text + length, *begin;
	size_t count = 0;

	for (const char *at = text;;) {
		double number;

		at = word_next(at, end, &begin);
		if (begin == at)
			return count;
		if (number_parse(begin, at, &number) != at || !isfinite(number))
			return 0;
		count++;
	}
}

/* What stands between a value and the one before it. */
static enum tcs_status
value_begin(struct ifcxml_instance *instance, struct ifcxml_slot *slot,
	struct tcs_fault *fault)
{
	bool row = slot->row && slot->values % slot->row == 0;
	const char *between = slot->values ? row ? "),(" : "," : row ? "(" : "";

	slot->values++;
	return put_string(&instance->text, between, fault);
}

static enum tcs_status
put_character(struct step_bytes *out, unsigned code, struct tcs_fault *fault)
{
	char spelled[24];

	snprintf(spelled, sizeof spelled, "\\X4\\%08X\\X0\\", code);
	return put_string(out, spelled, fault);
}

/* The character at `text`, valid UTF-8; *length is that of its bytes. */
static unsigned
character_at(const char *text, size_t *length)
{
	unsigned char first = (unsigned char)*text;
	unsigned code;

	*length = first < 0x80 ? 1 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
	code = *length == 1 ? first : first & (0x7fu >> *length);
	for (size_t i = 1; i < *length; i++)
		code = code << 6 | ((unsigned char)text[i] & 0x3f);
	return code;
}

/* In quotes; libxml2's text is UTF-8 throughout. */
static enum tcs_status
put_quoted(struct step_bytes *out, const char *text, size_t length,
	struct tcs_fault *fault)
{
	enum tcs_status status = put_string(out, "'", fault);
	size_t step;

	for (size_t i = 0; i < length && !status; i += step) {
		unsigned code = character_at(text + i, &step);

		if (code < ' ' || code >= 0x7f)
			status = put_character(out, code, fault);
		else
			status = ifcxml_put(out, text + i, 1, fault);
		if (!status && (code == '\'' || code == '\\'))
			status = ifcxml_put(out, text + i, 1, fault);
	}
	return status ? status : put_string(out, "'", fault);
}

static enum tcs_status
put_enumeration(struct step_bytes *out, const char *text, size_t length,
	struct tcs_fault *fault)
{
	enum tcs_status status = put_string(out, ".", fault);

	for (size_t i = 0; i < length && !status; i++) {
		char byte = text[i];

		if (byte >= 'a' && byte <= 'z')
			byte = (char)(byte - 'a' + 'A');
		status = ifcxml_put(out, &byte, 1, fault);
	}
	return status ? status : put_string(out, ".", fault);
}

static bool
is_word(const char *text, size_t length)
{
	for (size_t i = 0; i < length; i++)
		if (!(text[i] >= 'a' && text[i] <= 'z') &&
			!(text[i] >= 'A' && text[i] <= 'Z') &&
			!(text[i] >= '0' && text[i] <= '9') && text[i] != '_')
			return false;
	return length > 0;
}

static const char *
truth_of(const char *text, size_t length)
{
	static const char *const words[][2] = {
		{"true", ".T."}, {"false", ".F."}, {"unknown", ".U."}};

	for (size_t i = 0; i < sizeof words / sizeof *words; i++)
		if (strlen(words[i][0]) == length &&
			!memcmp(words[i][0], text, length))
			return words[i][1];
	return NULL;
}

static enum tcs_status
put_plain(struct step_bytes *out, const char *text, size_t length,
	struct tcs_fault *fault)
{
	const char *truth = truth_of(text, length);

	if (truth)
		return put_string(out, truth, fault);
	if (count_numbers(text, length) == 1)
		return ifcxml_put(out, text, length, fault);
	return put_quoted(out, text, length, fault);
}

/* ---- attributes ---------------------------------------------------------- */

enum tcs_status
ifcxml_put_link(struct ifcxml_instance *instance, int position, uint32_t number,
	struct tcs_fault *fault)
{
	struct ifcxml_slot *slot = instance->slots.at + position;
	enum tcs_status status = value_begin(instance, slot, fault);
	char spelled[16];

	snprintf(spelled, sizeof spelled, "#%u", (unsigned)number);
	if (!status)
		status = put_string(&instance->text, spelled, fault);
	slot->end = instance->text.count;
	return status;
}

static enum tcs_status
put_words(struct ifcxml_instance *instance, struct ifcxml_slot *slot,
	const char *text, size_t length, struct tcs_fault *fault)
{
	const char *end = text + length, *begin;
	enum tcs_status status = TCS_OK;

	while (!status) {
		text = word_next(text, end, &begin);
		if (begin == text)
			break;
		status = value_begin(instance, slot, fault);
		if (!status)
			status = put_plain(&instance->text, begin,
				(size_t)(text - begin), fault);
	}
	return status;
}

enum tcs_status
ifcxml_put_text(struct ifcxml_instance *instance, int position,
	const char *attribute, const char *text, size_t length,
	struct tcs_fault *fault)
{
	struct ifcxml_slot *slot = instance->slots.at + position;
	enum ifcxml_kind kind = ifcxml_kind_of(instance->entity, attribute);
	size_t numbers = count_numbers(text, length);
	enum tcs_status status;

	if (kind == IFCXML_PLAIN && (numbers > 1 || (slot->list && numbers))) {
		slot->list = true;
		status = put_words(instance, slot, text, length, fault);
	} else {
		status = value_begin(instance, slot, fault);
		if (kind != IFCXML_STRING)
			trim(&text, &length);
		if (!status && kind == IFCXML_ENUMERATION &&
			is_word(text, length))
			status = put_enumeration(
				&instance->text, text, length, fault);
		else if (!status && kind == IFCXML_PLAIN)
			status =
				put_plain(&instance->text, text, length, fault);
		else if (!status)
			status = put_quoted(
				&instance->text, text, length, fault);
	}
	slot->end = instance->text.count;
	return status;
}

static bool
type_is_list(const char *type)
{
	return !strcmp(type, "IFCLINEINDEX") || !strcmp(type, "IFCARCINDEX") ||
		!strcmp(type, IFCXML_SEQUENCE);
}

/* The words of a list. */
static enum tcs_status
put_sequence(struct step_bytes *out, const char *text, size_t length,
	struct tcs_fault *fault)
{
	const char *end = text + length, *begin;
	enum tcs_status status = put_string(out, "(", fault);

	for (bool first = true; !status; first = false) {
		text = word_next(text, end, &begin);
		if (begin == text)
			break;
		if (!first)
			status = put_string(out, ",", fault);
		if (!status)
			status = ifcxml_put(
				out, begin, (size_t)(text - begin), fault);
	}
	return status ? status : put_string(out, ")", fault);
}

static enum tcs_status
put_value(struct step_bytes *out, const char *type, const char *text,
	size_t length, struct tcs_fault *fault)
{
	if (ifcxml_type_is_text(type))
		return put_quoted(out, text, length, fault);
	trim(&text, &length);
	if (type_is_list(type) && count_numbers(text, length))
		return put_sequence(out, text, length, fault);
	return put_plain(out, text, length, fault);
}

enum tcs_status
ifcxml_put_typed(struct ifcxml_instance *instance, int position,
	const char *type, const char *text, size_t length,
	struct tcs_fault *fault)
{
	struct ifcxml_slot *slot = instance->slots.at + position;
	struct step_bytes *out = &instance->text;
	enum tcs_status status = value_begin(instance, slot, fault);
	bool bare = !*type || !strcmp(type, IFCXML_SEQUENCE);

	if (!status && !bare)
		status = put_string(out, type, fault);
	if (!status && !bare)
		status = put_string(out, "(", fault);
	if (!status)
		status = put_value(out, type, text, length, fault);
	if (!status && !bare)
		status = put_string(out, ")", fault);
	slot->end = out->count;
	return status;
}

/* ---- instances ----------------------------------------------------------- */

static enum tcs_status
slot_write(const struct ifcxml_instance *instance,
	const struct ifcxml_slot *slot, struct step_bytes *out,
	struct tcs_fault *fault)
{
	enum tcs_status status;

	if (!slot->values)
		return put_string(out, "$", fault);
	status = put_string(out, slot->list ? "(" : "", fault);
	if (!status)
		status = ifcxml_put(out, instance->text.at + slot->at,
			slot->end - slot->at, fault);
	if (!status && slot->row)
		status = put_string(out, ")", fault);
	return status ? status : put_string(out, slot->list ? ")" : "", fault);
}

enum tcs_status
ifcxml_instance_write(const struct ifcxml_instance *instance,
	struct step_bytes *out, struct tcs_fault *fault)
{
	char begin[80];
	enum tcs_status status;

	if (instance->entity == IFC_NONE)
		return TCS_OK;
	snprintf(begin, sizeof begin, "#%u=%s(", (unsigned)instance->number,
		ifc_name(instance->entity));
	status = put_string(out, begin, fault);
	for (size_t i = 0; i < instance->slots.count && !status; i++) {
		status = put_string(out, i ? "," : "", fault);
		if (!status)
			status = slot_write(
				instance, instance->slots.at + i, out, fault);
	}
	return status ? status : put_string(out, ");\n", fault);
}
