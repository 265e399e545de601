/*
 * Text of somebody else on a terminal: ids and names out of a file may hold
 * control characters, which must not reach it.
 */
#ifndef TESSERA_PLAIN_H
#define TESSERA_PLAIN_H

#include <stdio.h>

/*
 * Print `text` with '?' for every control character (C0, DEL, and C1 in
 * UTF-8) and for every byte that is not UTF-8. Errors are the stream's.
 */
void plain_print(FILE *to, const char *text);

#endif
