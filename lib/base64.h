/* Bytes as text, RFC 4648 clause 4, with padding. */
#ifndef TESSERA_BASE64_H
#define TESSERA_BASE64_H

#include <stddef.h>

/* The characters that `length` bytes become; not terminated. */
#define BASE64_LENGTH(length) (((length) + 2) / 3 * 4)

/* Write BASE64_LENGTH(length) characters to `out`. */
void base64_encode(char *out, const unsigned char *bytes, size_t length);

/*
 * Write up to length / 4 * 3 bytes to `out`; *count says how many. Returns 0,
 * or -1 for what base64_encode does not write.
 */
int base64_decode(
	unsigned char *out, size_t *count, const char *text, size_t length);

#endif
