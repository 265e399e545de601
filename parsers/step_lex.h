/*
 * What lies between the tokens of a STEP physical file, and where statements
 * end. Internal to the STEP reader.
 *
 * Inside a statement, strings and comments alone can hide a semicolon. A quote
 * within a comment begins no string, and a comment within a string is none;
 * that a doubled quote stands for one needs no thought here: it ends a string
 * and begins the next. Every function reads within [at, end) and takes a time
 * linear in what it passes.
 *
 * source: ISO 10303-21 5 and 6.
 */
#ifndef TESSERA_STEP_LEX_H
#define TESSERA_STEP_LEX_H

#include <stdbool.h>

/* The slow path of step_blank. */
const char *step_blank_more(const char *at, const char *end);

/*
 * Behind white space, comments and print control directives; `end` behind a
 * comment that does not end.
 */
static inline const char *
step_blank(const char *at, const char *end)
{
	if (at < end && (unsigned char)*at > ' ' && *at != '/' && *at != '\\')
		return at;
	return step_blank_more(at, end);
}

/* Behind the string whose first quote `at` is behind; NULL: it has no end. */
const char *step_string_end(const char *at, const char *end);

/* The semicolon that ends the statement around `at`; NULL: it has none. */
const char *step_statement_end(const char *at, const char *end);

/*
 * Behind the parenthesis that closes the list whose opening one `at` is
 * behind, at any depth; NULL where the statement ends before it does.
 */
const char *step_list_end(const char *at, const char *end);

/* Behind the keyword at `at`: letters, digits, "_", "!"; `at` for none. */
const char *step_keyword_end(const char *at, const char *end);

#endif
