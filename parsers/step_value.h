/*
 * The parameters of a STEP instance, decoded when asked for.
 *
 * A cursor walks one list of parameters. It is a plain value: a copy walks on
 * by itself, and nothing is to be released.
 *
 *     struct step_cursor points = step_parameters(file, polyline);
 *     struct step_value list, item;
 *
 *     if (step_next(&points, &list) == STEP_LIST)
 *             while (step_next(&list.list, &item) > STEP_END)
 *                     if (item.kind == STEP_REFERENCE)
 *                             …step_find(file, item.reference)…
 *
 * A list comes as a cursor of its own, and what is in it is looked at only
 * when that cursor, or the one around it, moves on. So the last parameter of an
 * instance, often a long list of coordinates, is read once. Values point into
 * the text of the file and live as long as it does.
 *
 * Whatever the text, a cursor stays within its statement and ends: with
 * STEP_END behind the last parameter, or with STEP_BAD where the text breaks
 * the format, and then with STEP_BAD for ever. Lists may be STEP_MAX_NESTING
 * deep; deeper ones are bad when entered, and passed over without harm.
 *
 * source: ISO 10303-21 7 and 10.
 */
#ifndef TESSERA_STEP_VALUE_H
#define TESSERA_STEP_VALUE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { STEP_MAX_NESTING = 64 };

enum step_kind {
	STEP_BAD = -1, /* the text at `text` is no parameter */
	STEP_END = 0, /* the list is over */
	STEP_UNSET, /* $ */
	STEP_DERIVED, /* * */
	STEP_INTEGER,
	STEP_REAL, /* finite */
	STEP_STRING, /* see step_string.h */
	STEP_ENUMERATION, /* .T. and .F. are such */
	STEP_BINARY,
	STEP_REFERENCE, /* #id: step_find */
	STEP_LIST,
	STEP_TYPED, /* NAME(value) */
};

struct step_cursor {
	const char *at;
	const char *end; /* of the text */
	unsigned depth; /* of lists, this one counted */
	enum {
		STEP_BEGINS, /* `at` is behind the opening parenthesis */
		STEP_BEHIND, /* … behind a value */
		STEP_INSIDE, /* … behind the parenthesis that opens a value */
		STEP_OVER,
		STEP_BROKEN,
	} state;
};

struct step_value {
	enum step_kind kind;
	/*
	 * STRING, ENUMERATION, BINARY: what stands between the delimiters;
	 * TYPED: the name; else where the value begins, and its length, which
	 * for a LIST is 1.
	 */
	const char *text;
	size_t length;
	union {
		int64_t integer;
		double real;
		uint64_t reference; /* an id */
		struct step_cursor list; /* LIST; TYPED: of one value */
	};
};

/* The next parameter, or why there is none. Returns value->kind. */
enum step_kind step_next(struct step_cursor *cursor, struct step_value *value);

/*
 * Fetch up to `room` parameters. Returns how many there were; fewer than there
 * should be when the list is over or broken, which cursor->state tells.
 */
size_t step_fetch(
	struct step_cursor *cursor, struct step_value *values, size_t room);

/*
 * The value within a typed one, NAME(NAME(2.5)) included; any other value as
 * it is.
 */
struct step_value step_untyped(const struct step_value *value);

/* A number, whole or not, typed or not. */
bool step_number(const struct step_value *value, double *out);

/* A whole number; 3. is one, too. */
bool step_integer(const struct step_value *value, int64_t *out);

/* Whether it is the enumeration value or the type `name`, in capitals. */
bool step_is(const struct step_value *value, const char *name);

/*
 * Fetch up to `room` numbers of what is left of the list. Returns how many
 * there were before the list ended, broke or held something else, of which
 * cursor->state is STEP_OVER for the first only.
 */
size_t step_numbers(struct step_cursor *cursor, double *out, size_t room);

#endif
