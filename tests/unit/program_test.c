#include "program.h"

#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "crew.h"
#include "program_help.h"

enum { MAX_WORDS = 16 };

/* A program with an option of every kind, and what it was given. */
struct sample {
	struct option_row rows[9];
	struct program program;
	struct command command;
	bool flag;
	const char *text;
	unsigned whole;
	double number;
	uint64_t bytes;
	unsigned choice;
	int parsed;
};

static const char *
parse_side(void *target, const char *argument)
{
	*(int *)target = !strcmp(argument, "left") ? -1 : 1;
	return NULL;
}

/* Parse "prog" and the words of `line`, separated by single blanks. */
static void
sample_begin(struct sample *sample, const char *line)
{
	static char words[256], name[] = "prog";
	char *argv[MAX_WORDS + 1] = {name};
	int argc = 1;

	*sample = (struct sample){.whole = 7};
	const struct option_row rows[] = {
		{OPTION_FLAG, 'f', "flag", NULL, "A flag.", &sample->flag, 0, 0,
			NULL},
		{OPTION_TEXT, 0, "text", "TEXT", "A text.", &sample->text, 0, 0,
			NULL},
		{OPTION_UNSIGNED, 'w', "whole", "N", "A whole number.",
			&sample->whole, 0, 9, NULL},
		{OPTION_NUMBER, 'n', "number", "X", "A number.",
			&sample->number, -10, 10, NULL},
		{OPTION_BYTES, 0, "max-bytes", "N", "Bytes.", &sample->bytes, 0,
			0, NULL},
		{OPTION_PARSE, 's', NULL, "SIDE", "Left or right.",
			&sample->parsed, 0, 0, parse_side},
		{OPTION_CHOICE, 'c', "choice", "one|two|three", "One of them.",
			&sample->choice, 0, 0, NULL},
		{.type = OPTION_END},
	};
	memcpy(sample->rows, rows, sizeof rows);
	sample->program = (struct program){"prog", "[options] [in [out]]",
		"Do it.", sample->rows, PROGRAM_READS};
	snprintf(words, sizeof words, "%s", line);
	for (char *word = strtok(words, " "); word; word = strtok(NULL, " "))
		argv[argc++] = word;
	program_begin(&sample->program, argc, argv, &sample->command);
}

static void
nothing_given_is_the_defaults(void)
{
	struct sample s;

	sample_begin(&s, "");
	CHECK(!s.command.input && !s.command.output && !s.command.stats);
	CHECK(s.command.jobs == crew_processors());
	CHECK(!s.command.quiet && !s.command.strict && !s.command.verbose);
	CHECK(!strcmp(s.command.arguments, "") && s.whole == 7);
	program_end(&s.command);
}

static void
values_arrive_however_they_are_spelt(void)
{
	static const char *const lines[] = {
		"--flag --text=a=b --whole=3 --number=-2.5 --max-bytes=2K -sleft",
		"-f --text a=b -w3 -n-2.5 --max-bytes 2048 -s left",
		"-fw3 -n -2.5 -s left in --text a=b out --max-bytes 2K",
		"-fw 3 in out -n -2.5 --max-bytes 2K --text a=b -s left",
	};

	for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) {
		struct sample s;

		sample_begin(&s, lines[i]);
		CHECK(s.flag && s.text && !strcmp(s.text, "a=b"));
		CHECK(s.whole == 3 && s.number == -2.5 && s.parsed == -1);
		CHECK(s.bytes == 2048);
		program_end(&s.command);
	}
}

static void
operands_are_input_and_output(void)
{
	struct sample s;

	sample_begin(&s, "in out -q");
	CHECK(!strcmp(s.command.input, "in") && s.command.quiet);
	CHECK(!strcmp(s.command.output, "out"));
	program_end(&s.command);
	sample_begin(&s, "-vv -- -in -");
	CHECK(!strcmp(s.command.input, "-in") && !s.command.output);
	CHECK(s.command.verbose == 2);
	program_end(&s.command);
	sample_begin(&s, "- -o out --stats st -j5 --strict");
	CHECK(!s.command.input && !strcmp(s.command.output, "out"));
	CHECK(!strcmp(s.command.stats, "st") && s.command.jobs == 5);
	CHECK(s.command.strict);
	program_end(&s.command);
}

/* The head of a stream must not tell -j 1 from -j 2, or a pipe from a file. */
static void
the_head_learns_own_options_only(void)
{
	struct sample s;

	sample_begin(&s, "in -j 2 --whole=3 -o out -q -f --stats x -sleft -v");
	CHECK(!strcmp(s.command.arguments, "--whole 3 --flag -s left"));
	program_end(&s.command);
	sample_begin(&s, "--text a\xff\xc3\xa4z");
	CHECK(!strcmp(s.command.arguments, "--text a?\xc3\xa4z"));
	program_end(&s.command);
}

static void
a_choice_is_the_number_of_its_name(void)
{
	static const char *const names[] = {"one", "two", "three"};

	for (unsigned i = 0; i < 3; i++) {
		char line[32];
		struct sample s;

		snprintf(line, sizeof line, "--choice %s", names[i]);
		sample_begin(&s, line);
		CHECK(s.choice == i);
		program_end(&s.command);
	}
}

static void
units_of_bytes_are_powers_of_1024(void)
{
	struct sample s;

	sample_begin(&s, "--max-bytes 3M");
	CHECK(s.bytes == 3145728);
	program_end(&s.command);
	sample_begin(&s, "--max-bytes 16777215T");
	CHECK(s.bytes == UINT64_C(16777215) << 40);
	program_end(&s.command);
}

static void
no_line_of_help_is_wider_than_80_columns(void)
{
	const struct option_row rows[] = {
		{OPTION_TEXT, 'l', "a-name-that-is-longer-than-most",
			"ARGUMENT",
			"Words that go on until they have to be broken, and "
			"then go on for a while, and then some more.",
			NULL, 0, 0, NULL},
		{OPTION_FLAG, 0, "short", NULL, "Short.", NULL, 0, 0, NULL},
		{.type = OPTION_END},
	};
	const struct option_row none[] = {{.type = OPTION_END}};
	const struct program program = {"prog", "", "Do it.", rows, 0};
	char *text = NULL;
	size_t size;
	FILE *file = open_memstream(&text, &size);

	program_help(&program, none, file);
	fclose(file);
	for (char *at = text; *at; at += *at != '\0') {
		size_t length = strcspn(at, "\n");

		CHECK(length <= 80);
		at += length;
	}
	CHECK(strstr(text, "ARGUMENT\n                Words that") != NULL);
	CHECK(strstr(text, "      --short   Short.\n") != NULL);
	free(text);
}

static const struct check_test tests[] = {
	CHECK_TEST(nothing_given_is_the_defaults),
	CHECK_TEST(values_arrive_however_they_are_spelt),
	CHECK_TEST(operands_are_input_and_output),
	CHECK_TEST(the_head_learns_own_options_only),
	CHECK_TEST(a_choice_is_the_number_of_its_name),
	CHECK_TEST(units_of_bytes_are_powers_of_1024),
	CHECK_TEST(no_line_of_help_is_wider_than_80_columns),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
