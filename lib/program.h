/*
 * The command line that every program shares.
 *
 * A program describes itself in one struct program: its name, what it does,
 * and a table of its own options. program_begin parses the arguments against
 * that table and the common options, which mean the same everywhere:
 *
 *     -o, --output FILE   write to FILE instead of standard output
 *     -j, --jobs N        use N threads (default: one per processor)
 *     -q, --quiet         print nothing but failures
 *     -v, --verbose       say more; twice: even more
 *         --strict        fail on the first thing that would be skipped
 *         --stats FILE    write counts as one JSON object to FILE
 *         --help, --version
 *
 * These functions are for a program's main thread: they print and exit.
 */
#ifndef TESSERA_PROGRAM_H
#define TESSERA_PROGRAM_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "fault.h"

#define TESSERA_VERSION "0.1.0"

enum { EXIT_DONE = 0, EXIT_FAILED = 1, EXIT_USAGE = 2 };

enum option_type {
	OPTION_END, /* closes a table: the zero row */
	OPTION_FLAG, /* bool *: set true */
	OPTION_TEXT, /* const char **: the argument itself */
	OPTION_UNSIGNED, /* unsigned *: a whole number within low…high */
	OPTION_NUMBER, /* double *: a number within low…high */
	OPTION_BYTES, /* uint64_t *: a whole number, K, M, G = 1024ⁿ */
	OPTION_CHOICE, /* unsigned * or enum *: which of the names, from 0, that
	                  stand in `argument`: "glb|gltf" */
	OPTION_PARSE, /* by `parse` */
};

/*
 * One option. With a `parse` function, it gets the target and the argument
 * (NULL for none) and returns NULL, or what is wrong in a few words
 * ("not one of 1.0, 2.0, 3.0").
 */
struct option_row {
	enum option_type type;
	char letter; /* -o; 0 for none */
	const char *name; /* --output, without the dashes */
	const char *argument; /* its placeholder, "FILE"; NULL: takes none */
	const char *help; /* one sentence, shown by --help */
	void *target;
	double low, high; /* OPTION_UNSIGNED, OPTION_NUMBER; high 0: no limit */
	const char *(*parse)(void *target, const char *argument);
};

enum program_input {
	PROGRAM_READS = 1, /* takes an input operand; else standard input */
	PROGRAM_BINARY_OUT = 2, /* refuses to write to a terminal */
	PROGRAM_BINARY_IN = 4, /* refuses to read from a terminal */
	PROGRAM_READS_TWO = 8, /* takes two inputs, and no output operand */
};

struct program {
	const char *name;
	const char *synopsis; /* "[options] [in [out]]" */
	const char *summary; /* one line: what it does */
	const struct option_row *options; /* its own; ends with a zero row */
	unsigned flags; /* PROGRAM_… */
};

/* What the command line said. Strings are borrowed from argv. */
struct command {
	const struct program *program;
	const char *input; /* NULL: standard input */
	const char *other; /* the second input; NULL: standard input */
	const char *output; /* NULL: standard output */
	const char *stats; /* NULL: none wanted */
	unsigned jobs; /* at least 1 */
	unsigned verbose;
	bool quiet;
	bool strict;
	char *arguments; /* the program's own options as given, separated by
	                    blanks, for the stream's head; UTF-8; owned. File
	                    names and common options are left out: they change
	                    nothing of the stream, and so neither its head */
};

/*
 * Parse. --help and --version print on standard output and exit 0; wrong usage
 * prints one line that names the fault and exits 2. Options may stand between
 * and behind operands; "--" ends them; "-" is a standard stream.
 */
void program_begin(const struct program *program, int argc, char **argv,
	struct command *out);

/* Wrong usage that only the program can see: "name: text" and exit 2. */
void program_usage(const struct command *command, const char *format, ...)
	TCS_PRINTF(2, 3) TCS_NORETURN;

/* "name: text", to standard error unless quiet. */
void program_warn(const struct command *command, const char *format, ...)
	TCS_PRINTF(2, 3);

/*
 * Print "name: [input:]text[ at byte N]" for the fault and return EXIT_FAILED,
 * so that main ends in `return program_fail(&command, &fault);`.
 */
int program_fail(const struct command *command, const struct tcs_fault *fault);

void program_end(struct command *command);

#endif
