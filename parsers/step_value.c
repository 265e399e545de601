#include "step_value.h"

#include <math.h>
#include <string.h>

#include "number.h"
#include "step_lex.h"

static enum step_kind
value_bad(
	struct step_cursor *cursor, struct step_value *value, const char *where)
{
	cursor->state = STEP_BROKEN;
	cursor->at = where;
	value->kind = STEP_BAD;
	value->text = where;
	value->length = 0;
	return STEP_BAD;
}

/* The cursor of the list whose parenthesis ends before `at`. */
static struct step_cursor
cursor_within(const struct step_cursor *cursor, const char *at)
{
	return (struct step_cursor){.at = at,
		.end = cursor->end,
		.depth = cursor->depth + 1,
		.state = cursor->depth < STEP_MAX_NESTING ? STEP_BEGINS
							  : STEP_BROKEN};
}

/* ---- one value: each returns what is behind it, or NULL ------------------ */

static const char *
read_number(struct step_cursor *cursor, struct step_value *value)
{
	const char *at = cursor->at, *end = cursor->end, *behind;

	behind = number_parse_integer(at, end, &value->integer);
	value->kind = STEP_INTEGER;
	if (!behind ||
		(behind < end &&
			(*behind == '.' || *behind == 'E' || *behind == 'e'))) {
		behind = number_parse(at, end, &value->real);
		value->kind = STEP_REAL;
		if (!behind || !isfinite(value->real))
			return NULL;
	}
	value->length = (size_t)(behind - at);
	return behind;
}

static const char *
read_reference(struct step_cursor *cursor, struct step_value *value)
{
	const char *at = cursor->at + 1, *end = cursor->end;
	uint64_t id = 0;

	for (; at < end && *at >= '0' && *at <= '9'; at++) {
		unsigned digit = (unsigned)(*at - '0');

		if (id > (UINT64_MAX - digit) / 10)
			return NULL;
		id = id * 10 + digit;
	}
	if (at == cursor->at + 1)
		return NULL;
	value->kind = STEP_REFERENCE;
	value->reference = id;
	value->length = (size_t)(at - cursor->at);
	return at;
}

static const char *
read_string(struct step_cursor *cursor, struct step_value *value)
{
	const char *behind = step_string_end(cursor->at + 1, cursor->end);

	if (!behind)
		return NULL;
	value->kind = STEP_STRING;
	value->text = cursor->at + 1;
	value->length = (size_t)(behind - 1 - value->text);
	return behind;
}

static const char *
read_enumeration(struct step_cursor *cursor, struct step_value *value)
{
	const char *at = step_keyword_end(cursor->at + 1, cursor->end);

	if (at == cursor->at + 1 || at == cursor->end || *at != '.')
		return NULL;
	value->kind = STEP_ENUMERATION;
	value->text = cursor->at + 1;
	value->length = (size_t)(at - value->text);
	return at + 1;
}

static const char *
read_binary(struct step_cursor *cursor, struct step_value *value)
{
	const char *at = step_keyword_end(cursor->at + 1, cursor->end);

	if (at == cursor->end || *at != '"')
		return NULL;
	value->kind = STEP_BINARY;
	value->text = cursor->at + 1;
	value->length = (size_t)(at - value->text);
	return at + 1;
}

static const char *
read_typed(struct step_cursor *cursor, struct step_value *value)
{
	const char *at = step_keyword_end(cursor->at, cursor->end);

	if (at == cursor->at)
		return NULL;
	value->kind = STEP_TYPED;
	value->length = (size_t)(at - cursor->at);
	at = step_blank(at, cursor->end);
	if (at == cursor->end || *at != '(')
		return NULL;
	value->list = cursor_within(cursor, at + 1);
	return at + 1;
}

static const char *
read_list(struct step_cursor *cursor, struct step_value *value)
{
	value->kind = STEP_LIST;
	value->length = 1;
	value->list = cursor_within(cursor, cursor->at + 1);
	return cursor->at + 1;
}

static const char *
read_nothing(struct step_cursor *cursor, struct step_value *value)
{
	value->kind = *cursor->at == '$' ? STEP_UNSET : STEP_DERIVED;
	value->length = 1;
	return cursor->at + 1;
}

static const char *
read_value(struct step_cursor *cursor, struct step_value *value)
{
	switch (*cursor->at) {
	case '$':
	case '*':
		return read_nothing(cursor, value);
	case '#':
		return read_reference(cursor, value);
	case '\'':
		return read_string(cursor, value);
	case '(':
		return read_list(cursor, value);
	case '"':
		return read_binary(cursor, value);
	case '.':
		if (cursor->end - cursor->at > 1 &&
			(cursor->at[1] < '0' || cursor->at[1] > '9'))
			return read_enumeration(cursor, value);
		return read_number(cursor, value);
	case '+':
	case '-':
	case '0':
	case '1':
	case '2':
	case '3':
	case '4':
	case '5':
	case '6':
	case '7':
	case '8':
	case '9':
		return read_number(cursor, value);
	default:
		return read_typed(cursor, value);
	}
}

/* ---- the walk ------------------------------------------------------------ */

/* A value stops where a parameter may: 1.#INF and 'a'b are not values. */
static bool
value_stops(const char *at, const char *end)
{
	return at < end &&
		(*at == ',' || *at == ')' || *at == '/' || *at == '\\' ||
			(unsigned char)*at <= ' ');
}

enum step_kind
step_next(struct step_cursor *cursor, struct step_value *value)
{
	const char *end = cursor->end, *at = cursor->at, *behind;

	value->kind = STEP_END;
	value->text = at;
	value->length = 0;
	if (cursor->state == STEP_OVER)
		return STEP_END;
	if (cursor->state == STEP_BROKEN)
		return value_bad(cursor, value, at);
	if (cursor->state == STEP_INSIDE) {
		at = step_list_end(at, end);
		if (!at)
			return value_bad(cursor, value, cursor->at);
	}
	at = step_blank(at, end);
	if (at < end && *at == ')') {
		cursor->at = at + 1;
		cursor->state = STEP_OVER;
		return STEP_END;
	}
	if (cursor->state != STEP_BEGINS) {
		if (at == end || *at != ',')
			return value_bad(cursor, value, at);
		at = step_blank(at + 1, end);
	}
	if (at == end)
		return value_bad(cursor, value, at);
	cursor->at = at;
	value->text = at;
	behind = read_value(cursor, value);
	if (!behind)
		return value_bad(cursor, value, at);
	cursor->at = behind;
	if (value->kind >= STEP_LIST)
		cursor->state = STEP_INSIDE;
	else if (!value_stops(behind, end))
		return value_bad(cursor, value, at);
	else
		cursor->state = STEP_BEHIND;
	return value->kind;
}

size_t
step_fetch(struct step_cursor *cursor, struct step_value *values, size_t room)
{
	size_t count = 0;

	while (count < room && step_next(cursor, values + count) > STEP_END)
		count++;
	return count;
}

struct step_value
step_untyped(const struct step_value *value)
{
	struct step_value inner = *value;

	while (inner.kind == STEP_TYPED) {
		struct step_cursor list = inner.list;

		step_next(&list, &inner);
	}
	return inner;
}

bool
step_number(const struct step_value *value, double *out)
{
	struct step_value inner = step_untyped(value);

	if (inner.kind == STEP_REAL)
		*out = inner.real;
	else if (inner.kind == STEP_INTEGER)
		*out = (double)inner.integer;
	else
		return false;
	return true;
}

bool
step_integer(const struct step_value *value, int64_t *out)
{
	struct step_value inner = step_untyped(value);

	if (inner.kind == STEP_INTEGER)
		*out = inner.integer;
	else if (inner.kind == STEP_REAL && inner.real == trunc(inner.real) &&
		fabs(inner.real) < 0x1p62)
		*out = (int64_t)inner.real;
	else
		return false;
	return true;
}

bool
step_is(const struct step_value *value, const char *name)
{
	if (value->kind != STEP_ENUMERATION && value->kind != STEP_TYPED)
		return false;
	if (strlen(name) != value->length)
		return false;
	for (size_t i = 0; i < value->length; i++) {
		char byte = value->text[i];

		if (byte >= 'a' && byte <= 'z')
			byte = (char)(byte - 'a' + 'A');
		if (byte != name[i])
			return false;
	}
	return true;
}

size_t
step_numbers(struct step_cursor *cursor, double *out, size_t room)
{
	struct step_value value;
	size_t count = 0;

	while (count < room && step_next(cursor, &value) > STEP_END)
		if (!step_number(&value, out + count++))
			return count - 1;
	return count;
}
