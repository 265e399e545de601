#include "program_help.h"

#include <string.h>

enum {
	WIDTH = 80,
	MIN_INDENT = 16,
	MAX_INDENT = 28, /* a longer option pushes its text to the next line */
	GAP = 2,
};

/* Columns of "  -o, --output FILE". */
static size_t
head_width(const struct option_row *row)
{
	size_t width = strlen("  -o, ");

	if (row->name)
		width += strlen("--") + strlen(row->name);
	if (row->argument)
		width += 1 + strlen(row->argument);
	return width;
}

static size_t
widest(const struct option_row *rows, size_t width)
{
	for (; rows && rows->type != OPTION_END; rows++) {
		size_t own = head_width(rows) + GAP;

		if (own > width && own <= MAX_INDENT)
			width = own;
	}
	return width;
}

/* The words of `text` from column `at` on, further lines at `indent`. */
static void
print_wrapped(const char *text, size_t at, size_t indent, FILE *to)
{
	bool first = true;

	while (*text) {
		size_t length = strcspn(text, " ");

		if (!first && at + 1 + length > WIDTH) {
			fprintf(to, "\n%*s", (int)indent, "");
			at = indent;
		} else if (!first) {
			putc(' ', to);
			at++;
		}
		fwrite(text, 1, length, to);
		at += length;
		text += length;
		text += strspn(text, " ");
		first = false;
	}
	putc('\n', to);
}

static void
print_option(const struct option_row *row, size_t indent, FILE *to)
{
	size_t width = head_width(row);

	if (row->letter)
		fprintf(to, "  -%c%s", row->letter, row->name ? ", " : "  ");
	else
		fputs("      ", to);
	if (row->name)
		fprintf(to, "--%s", row->name);
	if (row->argument)
		fprintf(to, " %s", row->argument);
	if (width + GAP > indent) {
		putc('\n', to);
		width = 0;
	}
	fprintf(to, "%*s", (int)(indent - width), "");
	print_wrapped(row->help, indent, indent, to);
}

static void
print_table(const char *title, const struct option_row *rows, size_t indent,
	FILE *to)
{
	if (!rows || rows->type == OPTION_END)
		return;
	fprintf(to, "\n%s:\n", title);
	for (; rows->type != OPTION_END; rows++)
		print_option(rows, indent, to);
}

void
program_help(const struct program *program, const struct option_row *common,
	FILE *to)
{
	size_t indent = widest(common, widest(program->options, MIN_INDENT));

	fprintf(to, "Usage: %s %s\n", program->name, program->synopsis);
	print_wrapped(program->summary, 0, 0, to);
	print_table("Options", program->options, indent, to);
	print_table("Common options", common, indent, to);
}
