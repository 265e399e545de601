/* UTF-8, RFC 3629: no surrogates, no overlong forms, at most U+10FFFF. */
#ifndef TESSERA_UTF8_H
#define TESSERA_UTF8_H

#include <stdbool.h>
#include <stddef.h>

/* Whether all `length` bytes are valid UTF-8. NUL counts as a character. */
bool utf8_valid(const char *bytes, size_t length);

/*
 * The length in bytes of the valid character at `bytes`, 1 to 4, of which
 * `length` > 0 are readable; 0 where there is none.
 */
size_t utf8_length(const char *bytes, size_t length);

#endif
