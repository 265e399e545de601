/* The text of --help, generated from a program's option tables. */
#ifndef TESSERA_PROGRAM_HELP_H
#define TESSERA_PROGRAM_HELP_H

#include <stdio.h>

#include "program.h"

/*
 * Usage, summary, the program's own options, then `common`, in lines of at
 * most 80 columns. Errors are the stream's.
 */
void program_help(const struct program *program,
	const struct option_row *common, FILE *to);

#endif
