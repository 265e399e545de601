#include "program.h"

#include <errno.h>
#include <fcntl.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "array.h"
#include "crew.h"
#include "number.h"
#include "plain.h"
#include "program_help.h"
#include "utf8.h"

enum { MAX_JOBS = 512, MAX_FAULT = 512, MAX_RANGE = 64, COMMON_ROWS = 9 };

/* What parsing has found beside the command itself. */
struct parse {
	struct command *command;
	struct option_row common[COMMON_ROWS];
	unsigned operands;
	const char *output; /* as the second operand */
	bool help, version;
	TCS_ARRAY(char) arguments;
};

/* ---- the end of it ------------------------------------------------------ */

static void say(const struct program *program, const char *format, va_list list)
	TCS_PRINTF(2, 0);
static void usage(const struct program *program, const char *format, ...)
	TCS_PRINTF(2, 3) TCS_NORETURN;

static void
say(const struct program *program, const char *format, va_list list)
{
	char text[MAX_FAULT];

	vsnprintf(text, sizeof text, format, list);
	fprintf(stderr, "%s: ", program->name);
	plain_print(stderr, text);
	putc('\n', stderr);
}

static void
usage(const struct program *program, const char *format, ...)
{
	va_list list;

	va_start(list, format);
	say(program, format, list);
	va_end(list);
	exit(EXIT_USAGE);
}

void
program_usage(const struct command *command, const char *format, ...)
{
	va_list list;

	va_start(list, format);
	say(command->program, format, list);
	va_end(list);
	exit(EXIT_USAGE);
}

static _Noreturn void
out_of_memory(const struct program *program)
{
	fprintf(stderr, "%s: out of memory\n", program->name);
	exit(EXIT_FAILED);
}

/* Leave after --help or --version, which a full disk may have cut. */
static _Noreturn void
leave_shown(const struct program *program)
{
	if (fflush(stdout) || ferror(stdout)) {
		fprintf(stderr, "%s: cannot write standard output: %s\n",
			program->name, strerror(errno));
		exit(EXIT_FAILED);
	}
	exit(EXIT_DONE);
}

/* ---- values ------------------------------------------------------------- */

/* Whole numbers in plain digits; -1 for anything else or over UINT64_MAX. */
static int
parse_digits(const char *text, const char **end, uint64_t *out)
{
	uint64_t value = 0;
	const char *at = text;

	for (; *at >= '0' && *at <= '9'; at++) {
		unsigned digit = (unsigned)(*at - '0');

		if (value > (UINT64_MAX - digit) / 10)
			return -1;
		value = value * 10 + digit;
	}
	*end = at;
	*out = value;
	return at == text ? -1 : 0;
}

static const char *
set_unsigned(const struct option_row *row, const char *text)
{
	uint64_t value;
	const char *end;

	if (parse_digits(text, &end, &value) || *end || value > UINT32_MAX)
		return "not a whole number";
	if ((double)value < row->low ||
		(row->high > 0 && (double)value > row->high))
		return "out of range";
	*(unsigned *)row->target = (unsigned)value;
	return NULL;
}

static const char *
set_number(const struct option_row *row, const char *text)
{
	const char *end = text + strlen(text);
	double value;

	if (number_parse(text, end, &value) != end || end == text)
		return "not a number";
	if (!(value >= row->low &&
		    value <= (row->high > 0 ? row->high : 1e308)))
		return "out of range";
	*(double *)row->target = value;
	return NULL;
}

static const char *
set_bytes(const struct option_row *row, const char *text)
{
	static const char units[] = "KMGT";
	uint64_t value;
	const char *end, *unit;
	unsigned shift = 0;

	if (parse_digits(text, &end, &value))
		return "not a number of bytes";
	if (*end) {
		unit = strchr(units, *end);
		if (!unit || end[1])
			return "not a number of bytes";
		shift = 10 * ((unsigned)(unit - units) + 1);
	}
	if (value > UINT64_MAX >> shift)
		return "out of range";
	*(uint64_t *)row->target = value << shift;
	return NULL;
}

static const char *
set_choice(const struct option_row *row, const char *text)
{
	size_t length = strlen(text);
	const char *name = row->argument;

	for (unsigned number = 0;; number++, name++) {
		size_t size = strcspn(name, "|");

		if (size == length && !memcmp(name, text, size)) {
			*(unsigned *)row->target = number;
			return NULL;
		}
		name += size;
		if (!*name)
			return "not one of ";
	}
}

static const char *
set_value(const struct option_row *row, const char *text)
{
	switch (row->type) {
	case OPTION_FLAG:
		*(bool *)row->target = true;
		return NULL;
	case OPTION_TEXT:
		*(const char **)row->target = text;
		return NULL;
	case OPTION_UNSIGNED:
		return set_unsigned(row, text);
	case OPTION_NUMBER:
		return set_number(row, text);
	case OPTION_BYTES:
		return set_bytes(row, text);
	case OPTION_CHOICE:
		return set_choice(row, text);
	case OPTION_PARSE:
		return row->parse(row->target, text);
	case OPTION_END:
		break;
	}
	abort(); /* no row of a table has another type */
}

/* ---- tables ------------------------------------------------------------- */

static const char *
count_verbose(void *target, const char *argument)
{
	(void)argument;
	++*(unsigned *)target;
	return NULL;
}

static const char *
set_file(void *target, const char *argument)
{
	if (!*argument)
		return "an empty file name";
	*(const char **)target = argument;
	return NULL;
}

static void
common_options(struct parse *parse)
{
	struct command *command = parse->command;
	const struct option_row rows[COMMON_ROWS] = {
		{OPTION_PARSE, 'o', "output", "FILE",
			"Write to FILE instead of standard output.",
			&command->output, 0, 0, set_file},
		{OPTION_UNSIGNED, 'j', "jobs", "N",
			"Use N threads (default: one per processor).",
			&command->jobs, 1, MAX_JOBS, NULL},
		{OPTION_FLAG, 'q', "quiet", NULL, "Print nothing but failures.",
			&command->quiet, 0, 0, NULL},
		{OPTION_PARSE, 'v', "verbose", NULL,
			"Say more; twice: even more.", &command->verbose, 0, 0,
			count_verbose},
		{OPTION_FLAG, 0, "strict", NULL,
			"Fail on the first thing that would be skipped.",
			&command->strict, 0, 0, NULL},
		{OPTION_PARSE, 0, "stats", "FILE",
			"Write counts as one JSON object to FILE.",
			&command->stats, 0, 0, set_file},
		{OPTION_FLAG, 0, "help", NULL, "Show this help and exit.",
			&parse->help, 0, 0, NULL},
		{OPTION_FLAG, 0, "version", NULL, "Show the version and exit.",
			&parse->version, 0, 0, NULL},
	};

	memcpy(parse->common, rows, sizeof rows);
}

static const struct option_row *
find_named(const struct option_row *rows, const char *name, size_t length)
{
	for (; rows && rows->type != OPTION_END; rows++)
		if (rows->name && !strncmp(rows->name, name, length) &&
			!rows->name[length])
			return rows;
	return NULL;
}

static const struct option_row *
find_lettered(const struct option_row *rows, char letter)
{
	for (; rows && rows->type != OPTION_END; rows++)
		if (rows->letter == letter)
			return rows;
	return NULL;
}

/* ---- parsing ------------------------------------------------------------ */

/* Bytes that are not UTF-8 become '?': the stream's text is UTF-8. */
static int
append_word(struct parse *parse, const char *before, const char *word)
{
	size_t length = strlen(word);

	if (array_grow(&parse->arguments, strlen(before) + length + 1))
		return -1;
	while (*before)
		parse->arguments.at[parse->arguments.count++] = *before++;
	while (length) {
		size_t size = utf8_length(word, length);
		size_t step = size ? size : 1;

		memcpy(parse->arguments.at + parse->arguments.count,
			size ? word : "?", step);
		parse->arguments.count += step;
		word += step;
		length -= step;
	}
	return 0;
}

/* Own options go to the stream's head; the common ones change nothing there. */
static int
remember(struct parse *parse, const struct option_row *row, const char *value)
{
	const char *blank = parse->arguments.count ? " " : "";
	char letter[] = {row->letter, '\0'};

	if (row >= parse->common && row < parse->common + COMMON_ROWS)
		return 0;
	if (append_word(parse, blank, row->name ? "--" : "-") ||
		append_word(parse, "", row->name ? row->name : letter))
		return -1;
	return value ? append_word(parse, " ", value) : 0;
}

/* "glb, gltf", cut where there is no more room. */
static void
list_choices(const char *names, char list[MAX_RANGE])
{
	size_t at = 0;

	for (; *names && at < MAX_RANGE - 2; names++) {
		list[at++] = *names;
		if (*names == '|') {
			list[at - 1] = ',';
			list[at++] = ' ';
		}
	}
	list[at] = '\0';
}

/* " (from 1 to 512)", " (at least 1)", "glb, gltf", or nothing. */
static const char *
range_of(const struct option_row *row, char range[MAX_RANGE])
{
	bool is_number =
		row->type == OPTION_UNSIGNED || row->type == OPTION_NUMBER;

	*range = '\0';
	if (row->type == OPTION_CHOICE)
		list_choices(row->argument, range);
	else if (is_number && row->high > 0)
		snprintf(range, MAX_RANGE, " (from %.15g to %.15g)", row->low,
			row->high);
	else if (is_number)
		snprintf(range, MAX_RANGE, " (at least %.15g)", row->low);
	return range;
}

static void
apply(struct parse *parse, const struct option_row *row, const char *value)
{
	const struct program *program = parse->command->program;
	char letter[] = {row->letter, '\0'};
	char range[MAX_RANGE];
	const char *wrong = set_value(row, value);

	if (wrong)
		usage(program, "%s%s%s%s%s: %s%s", row->name ? "--" : "-",
			row->name ? row->name : letter, value ? " '" : "",
			value ? value : "", value ? "'" : "", wrong,
			range_of(row, range));
	if (remember(parse, row, value))
		out_of_memory(program);
}

/* "--name", "--name=value", "--name value"; returns the words it took. */
static int
take_long(struct parse *parse, const char *word, const char *next)
{
	const struct program *program = parse->command->program;
	const char *name = word + 2;
	size_t length = strcspn(name, "=");
	const char *value = name[length] ? name + length + 1 : NULL;
	const struct option_row *row =
		find_named(program->options, name, length);

	if (!row)
		row = find_named(parse->common, name, length);
	if (!row)
		usage(program, "unknown option --%.*s (see --help)",
			(int)(length < 80 ? length : 80), name);
	if (!row->argument) {
		if (value)
			usage(program, "--%s takes no argument", row->name);
		apply(parse, row, NULL);
		return 1;
	}
	if (!value && !next)
		usage(program, "--%s needs an argument: %s", row->name,
			row->argument);
	apply(parse, row, value ? value : next);
	return value ? 1 : 2;
}

/* "-q", "-qv", "-j4", "-j 4", "-qj 4"; returns the words it took. */
static int
take_short(struct parse *parse, const char *word, const char *next)
{
	const struct program *program = parse->command->program;

	for (const char *at = word + 1; *at; at++) {
		const struct option_row *row =
			find_lettered(program->options, *at);

		if (!row)
			row = find_lettered(parse->common, *at);
		if (!row)
			usage(program, "unknown option -%c (see --help)", *at);
		if (!row->argument) {
			apply(parse, row, NULL);
			continue;
		}
		if (!at[1] && !next)
			usage(program, "-%c needs an argument: %s", *at,
				row->argument);
		apply(parse, row, at[1] ? at + 1 : next);
		return at[1] ? 1 : 2;
	}
	return 1;
}

static void
take_operand(struct parse *parse, const char *word)
{
	struct command *command = parse->command;
	const struct program *program = command->program;
	bool reads_two = program->flags & PROGRAM_READS_TWO;
	bool reads = program->flags & PROGRAM_READS || reads_two;
	unsigned number = parse->operands++;

	if (!*word)
		usage(program, "an empty file name");
	if (reads && number == 0) {
		command->input = word;
	} else if (reads_two && number == 1) {
		command->other = word;
	} else if (!reads_two && number == (reads ? 1U : 0U)) {
		parse->output = word;
	} else {
		usage(program, "one file too many: %s", word);
	}
}

static void
take_words(struct parse *parse, int argc, char **argv)
{
	bool only_operands = false;
	int i = 1;

	while (i < argc) {
		const char *word = argv[i];
		const char *next = i + 1 < argc ? argv[i + 1] : NULL;

		if (only_operands || word[0] != '-' || !word[1]) {
			take_operand(parse, word);
			i++;
		} else if (!strcmp(word, "--")) {
			only_operands = true;
			i++;
		} else if (word[1] == '-') {
			i += take_long(parse, word, next);
		} else {
			i += take_short(parse, word, next);
		}
	}
}

/*
 * A standard descriptor that is closed would be given to the next file opened.
 * One that cannot be used the right way round fails as a closed one should.
 */
static void
hold_descriptors(const struct program *program)
{
	for (int fd = STDIN_FILENO; fd <= STDERR_FILENO; fd++) {
		int flags = fd == STDIN_FILENO ? O_WRONLY : O_RDONLY;

		if (fcntl(fd, F_GETFD) >= 0 || errno != EBADF)
			continue;
		if (open("/dev/null", flags) != fd) {
			fprintf(stderr, "%s: cannot open /dev/null: %s\n",
				program->name, strerror(errno));
			exit(EXIT_FAILED);
		}
	}
}

static const char *
named_or_null(const char *name)
{
	return name && strcmp(name, "-") != 0 ? name : NULL;
}

static void
check_terminals(const struct command *command)
{
	const struct program *program = command->program;

	if (program->flags & PROGRAM_BINARY_OUT && !command->output &&
		isatty(STDOUT_FILENO))
		usage(program,
			"the output is binary and standard output is a "
			"terminal; use -o FILE or a pipe");
	if (program->flags & PROGRAM_BINARY_IN &&
		(!command->input ||
			(program->flags & PROGRAM_READS_TWO &&
				!command->other)) &&
		isatty(STDIN_FILENO))
		usage(program,
			"the input is binary and standard input is a "
			"terminal; name a file or use a pipe");
}

void
program_begin(const struct program *program, int argc, char **argv,
	struct command *out)
{
	struct parse parse = {.command = out};

	*out = (struct command){.program = program, .jobs = crew_processors()};
	if (out->jobs > MAX_JOBS)
		out->jobs = MAX_JOBS;
	hold_descriptors(program);
	common_options(&parse);
	take_words(&parse, argc, argv);
	if (parse.help) {
		program_help(program, parse.common, stdout);
		leave_shown(program);
	}
	if (parse.version) {
		printf("%s (tessera) %s\n", program->name, TESSERA_VERSION);
		leave_shown(program);
	}
	if (parse.output && out->output)
		usage(program, "the output is named twice: %s and %s",
			out->output, parse.output);
	if (parse.output)
		out->output = parse.output;
	if (program->flags & PROGRAM_READS_TWO && parse.operands < 2)
		usage(program, "two inputs are needed");
	out->input = named_or_null(out->input);
	out->other = named_or_null(out->other);
	if (program->flags & PROGRAM_READS_TWO && !out->input && !out->other)
		usage(program, "only one input can be standard input");
	out->output = named_or_null(out->output);
	check_terminals(out);
	if (array_grow(&parse.arguments, 1))
		out_of_memory(program);
	parse.arguments.at[parse.arguments.count] = '\0';
	out->arguments = parse.arguments.at;
}

/* ---- what is said ------------------------------------------------------- */

void
program_warn(const struct command *command, const char *format, ...)
{
	va_list list;

	if (command->quiet)
		return;
	va_start(list, format);
	say(command->program, format, list);
	va_end(list);
}

/* Faults of what arrived; the others name their file themselves. */
static bool
is_of_input(const struct command *command, const struct tcs_fault *fault)
{
	return command->program->flags & PROGRAM_READS &&
		(fault->status == TCS_BAD_INPUT ||
			fault->status == TCS_TRUNCATED ||
			fault->status == TCS_LIMIT);
}

int
program_fail(const struct command *command, const struct tcs_fault *fault)
{
	fprintf(stderr, "%s: ", command->program->name);
	if (is_of_input(command, fault)) {
		plain_print(stderr,
			command->input ? command->input : "standard input");
		fputs(": ", stderr);
	}
	plain_print(stderr, fault->text);
	if (fault->at != TCS_NOWHERE)
		fprintf(stderr, " at byte %" PRIu64, fault->at);
	putc('\n', stderr);
	return EXIT_FAILED;
}

void
program_end(struct command *command)
{
	free(command->arguments);
	command->arguments = NULL;
}
