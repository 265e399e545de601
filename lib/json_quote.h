/* Text as a JSON string, RFC 8259 clause 7. */
#ifndef TESSERA_JSON_QUOTE_H
#define TESSERA_JSON_QUOTE_H

#include <stdio.h>

/*
 * Print `text` in quotes; a byte that is not UTF-8 becomes U+FFFD. Errors are
 * the stream's.
 */
void json_quote(const char *text, FILE *to);

#endif
