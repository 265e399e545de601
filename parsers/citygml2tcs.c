/* CityGML to a component stream: the option table and the loop. */
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "citygml_convert.h"
#include "stage.h"

struct asked {
	struct convert_options options;
	enum { EXTENSIONS_KEEP, EXTENSIONS_DROP } extensions;
	uint64_t max_bytes;
};

/* "highest", "all", or numbers as in "0,2". */
static const char *
parse_lods(void *target, const char *argument)
{
	struct lod_choice *choice = target;

	*choice = (struct lod_choice){0};
	if (!strcmp(argument, "highest")) {
		choice->highest = true;
		return NULL;
	}
	if (!strcmp(argument, "all")) {
		memset(choice->lods, true, sizeof choice->lods);
		return NULL;
	}
	for (;; argument++) {
		if (*argument < '0' || *argument > '4')
			return "neither highest, all, nor a list of 0…4";
		choice->lods[*argument++ - '0'] = true;
		if (!*argument)
			return NULL;
		if (*argument != ',')
			return "neither highest, all, nor a list of 0…4";
	}
}

/* The folder of a file: "." without a slash in its name; the caller frees. */
static char *
folder_of(const char *name)
{
	const char *slash = strrchr(name, '/');

	if (!slash)
		return strdup(".");
	return strndup(name, slash == name ? 1 : (size_t)(slash - name));
}

/* What is read from a pipe has no folder, unless one is given. */
static enum tcs_status
choose_folder(struct convert_options *options, const struct command *command,
	char **own, struct tcs_fault *fault)
{
	const char *given = options->reading.folder;

	*own = NULL;
	if (given && !*given)
		options->reading.folder = NULL;
	if (given || !command->input)
		return TCS_OK;
	options->reading.folder = *own = folder_of(command->input);
	return *own ? TCS_OK : fault_memory(fault);
}

static enum tcs_status
convert(void *context, struct stage *stage, struct tcs_fault *fault)
{
	const struct command *command = stage->command;
	struct asked *asked = context;
	struct input input = {0};
	char *folder;
	enum tcs_status status =
		choose_folder(&asked->options, command, &folder, fault);

	if (!status)
		status = input_open(&input, command->input, fault);
	input.max_bytes = asked->max_bytes;
	if (!status)
		status = output_open(&stage->out, command->output, fault);
	if (!status)
		status = citygml_convert(&input, stage->out.file,
			&asked->options, command, &stage->report, fault);
	input_close(&input);
	free(folder);
	return status;
}

int
main(int argc, char **argv)
{
	struct asked asked = {
		.options = {
			.lods.highest = true,
			.reading.xml = {.depth = 512, .tag = 64 << 20},
			.reading.max_feature = (uint64_t)2 << 30,
			.reading.max_library = 16 << 20,
		}};
	struct gml_options *reading = &asked.options.reading;
	const struct option_row rows[] = {
		{.type = OPTION_PARSE,
			.name = "lod",
			.argument = "LIST",
			.help = "Read these levels of detail: highest (of each "
				"feature, the default), all, or numbers as "
				"in 0,2.",
			.target = &asked.options.lods,
			.parse = parse_lods},
		{.type = OPTION_CHOICE,
			.name = "ade",
			.argument = "keep|drop",
			.help = "What extensions add: keep (the default) or "
				"drop.",
			.target = &asked.extensions},
		{.type = OPTION_TEXT,
			.name = "images",
			.argument = "DIR",
			.help = "Folder of the images and other files that the "
				"document names (default: its own).",
			.target = &reading->folder},
		{.type = OPTION_FLAG,
			.letter = 'z',
			.name = "compress",
			.help = "Compress the records, for storage.",
			.target = &asked.options.compress},
		{.type = OPTION_UNSIGNED,
			.name = "max-depth",
			.argument = "N",
			.help = "Fail when elements nest deeper than N "
				"(default: 512).",
			.target = &reading->xml.depth,
			.low = 8,
			.high = 1000000},
		{.type = OPTION_BYTES,
			.name = "max-tag",
			.argument = "N",
			.help = "Fail when a tag or comment is longer than N "
				"bytes (default: 64M).",
			.target = &reading->xml.tag},
		{.type = OPTION_BYTES,
			.name = "max-feature",
			.argument = "N",
			.help = "Fail when a top-level feature is longer than "
				"N bytes (default: 2G).",
			.target = &reading->max_feature},
		{.type = OPTION_BYTES,
			.name = "max-library",
			.argument = "N",
			.help = "Skip library objects of more than N bytes "
				"(default: 16M).",
			.target = &reading->max_library},
		{.type = OPTION_BYTES,
			.name = "max-bytes",
			.argument = "N",
			.help = "Fail when the document, uncompressed, is "
				"longer than N bytes (default: no limit).",
			.target = &asked.max_bytes},
		{0},
	};
	const struct program program = {
		.name = "citygml2tcs",
		.synopsis = "[options] [in [out]]",
		.summary = "Read CityGML, write a component stream.",
		.options = rows,
		.flags = PROGRAM_READS | PROGRAM_BINARY_OUT,
	};
	struct command command;
	int code;

	program_begin(&program, argc, argv, &command);
	reading->drop_extensions = asked.extensions == EXTENSIONS_DROP;
	code = stage_run(&command, convert, &asked);
	program_end(&command);
	return code;
}
