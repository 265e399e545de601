/*
 * The text of a STEP string, decoded to UTF-8.
 *
 * '' stands for a quote and \\ for a backslash; \X\hh for a character of ISO
 * 8859-1, \X2\hhhh…\X0\ for UTF-16 (a pair of surrogates is one character),
 * \X4\hhhhhhhh…\X0\ for UTF-32; \S\c for the character 128 behind c in the part
 * of ISO 8859 that the last \PA\ … \PI\ of the string named, at first part 1.
 * Print control directives and the bytes below 32, but for a tab, are left out.
 *
 * Real files bend this. Bytes from 128 on are taken as UTF-8 where they are,
 * else as windows-1252. A backslash that begins no directive stands for itself.
 * A byte order mark within \X2\ and digits too few for a character before \X0\
 * are left out. What is no character becomes U+FFFD. The text never contains NUL.
 *
 * source: ISO 10303-21 6.4.3.
 */
#ifndef TESSERA_STEP_STRING_H
#define TESSERA_STEP_STRING_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "array.h"

/* Text under construction. */
TCS_ARRAY_TYPE(step_text, char);

/* What had to be assumed: bits that step_decode adds. */
enum step_trouble {
	STEP_RAW_BYTES = 1, /* bytes from 128 on, as UTF-8 */
	STEP_GUESSED_BYTES = 2, /* … as windows-1252 */
	STEP_STRAY_BACKSLASH = 4,
	STEP_NO_CHARACTER = 8,
};

/*
 * Append the decoded string and a terminator, which does not count. `string`
 * is what stands between the quotes: value.text and value.length of a
 * STEP_STRING. Fails with TCS_NO_MEMORY.
 */
enum tcs_status step_decode(struct step_text *out, const char *string,
	size_t length, unsigned *trouble, struct tcs_fault *fault) TCS_CHECKED;

/* Whether the string decodes to what it is: nothing but printable ASCII. */
bool step_is_plain(const char *string, size_t length);

/* U+00A0 to U+00FF of ISO 8859-1 … 8859-9; 0 where there is no character. */
extern const uint16_t step_pages[9][96];

#endif
