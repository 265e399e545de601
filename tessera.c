#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>

#include "crew.h"
#include "output.h"
#include "pipeline.h"
#include "program.h"

enum { MAX_TAKERS = 5, MAX_NAME = 4096, MAX_NUMBER = 24, MAX_OPTION = 64 };

/* A format by the end of a file's name, and who reads and writes it. */
struct format {
	const char *suffix;
	const char *reader; /* into the stream; NULL: nobody */
	const char *writer; /* out of it; NULL: nobody */
	bool packs; /* the reader takes ".gz" behind the suffix */
};

#define STREAM "" /* the format is the stream: no program is needed */

static const struct format formats[] = {
	{"gml", "citygml2tcs", "tcs2citygml", true},
	{"xml", "citygml2tcs", "tcs2citygml", true},
	{"citygml", "citygml2tcs", "tcs2citygml", true},
	{"ifc", "ifc2tcs", NULL, true},
	{"ifcxml", "ifc2tcs", NULL, true},
	{"ifczip", "ifc2tcs", NULL, false},
	{"tcs", STREAM, STREAM, false},
	{"json", "json2tcs", "tcs2json", true},
	{"jsonl", "json2tcs", "tcs2json", true},
	{"glb", NULL, "tcs2gltf", false},
	{"gltf", NULL, "tcs2gltf", false},
};

enum { FORMATS = sizeof formats / sizeof *formats };

/* An option handed on to the first stage of the pipe that takes it, or to all
 * that do. */
struct passed {
	const char *name; /* without its dashes; NULL ends a table */
	const char *argument, *help;
	const char *takers[MAX_TAKERS];
	const char *value; /* as given; NULL: not given */
	bool by_all;
	bool taken; /* by a stage of the pipe */
};

/* What to run, and how. */
struct plan {
	struct command command;
	struct pipeline pipeline;
	const char *from, *to; /* suffixes that --from and --to name */
	bool dry_run;
	bool exterior; /* tcs-exterior is one of the stages */
	char folder[MAX_NAME]; /* of the stages' --stats; "" for none */
	char images[MAX_NAME]; /* the folder of the input */
};

/* ---- formats ------------------------------------------------------------ */

/* The format whose suffix `name` of `length` ends in, behind a dot. */
static const struct format *
format_of_length(const char *name, size_t length)
{
	for (size_t i = 0; i < FORMATS; i++) {
		size_t own = strlen(formats[i].suffix);

		if (length > own + 1 && name[length - own - 1] == '.' &&
			!strncasecmp(
				name + length - own, formats[i].suffix, own))
			return &formats[i];
	}
	return NULL;
}

static const struct format *
format_of(const char *name)
{
	size_t length = strlen(name);
	const struct format *format = format_of_length(name, length);

	if (format || length < 3 || strcasecmp(name + length - 3, ".gz") != 0)
		return format;
	format = format_of_length(name, length - 3);
	return format && format->packs ? format : NULL;
}

static const char *
note_suffix(void *target, const char *argument)
{
	for (size_t i = 0; i < FORMATS; i++)
		if (!strcasecmp(formats[i].suffix, argument)) {
			*(const char **)target = formats[i].suffix;
			return NULL;
		}
	return "not a format: gml, ifc, tcs, json, glb, gltf";
}

/* By the option, else by the file's name; wrong usage when neither tells. */
static const struct format *
choose_format(const struct command *command, const char *suffix,
	const char *name, const char *option)
{
	const struct format *format = NULL;

	for (size_t i = 0; suffix && i < FORMATS; i++)
		if (!strcmp(formats[i].suffix, suffix))
			return &formats[i];
	if (name)
		format = format_of(name);
	if (!format && name)
		program_usage(command,
			"%s: the name tells no format; name one with %s", name,
			option);
	if (!format)
		program_usage(command, "a standard stream needs its format: %s",
			option);
	return format;
}

/* ---- stages ------------------------------------------------------------- */

static enum tcs_status
add_option(struct plan *plan, size_t stage, const char *option,
	const char *value, struct tcs_fault *fault)
{
	enum tcs_status status =
		pipeline_argument(&plan->pipeline, stage, option, fault);

	if (!status && value)
		status =
			pipeline_argument(&plan->pipeline, stage, value, fault);
	return status;
}

static bool
takes(const struct passed *passed, const char *program)
{
	for (int i = 0; i < MAX_TAKERS && passed->takers[i]; i++)
		if (!strcmp(passed->takers[i], program))
			return true;
	return false;
}

/* A stage with the passed options that it takes; most only the first does. */
static enum tcs_status
add_stage(struct plan *plan, const char *program, struct passed *passed,
	struct tcs_fault *fault)
{
	size_t stage = plan->pipeline.stages.count;
	enum tcs_status status = pipeline_add(&plan->pipeline, program, fault);

	for (; !status && passed->name; passed++) {
		char option[MAX_OPTION];

		if (!passed->value || !takes(passed, program))
			continue;
		snprintf(option, sizeof option, "--%s", passed->name);
		status = add_option(plan, stage, option, passed->value, fault);
		passed->taken = true;
		if (!passed->by_all)
			passed->value = NULL;
	}
	if (!status && plan->to && !strcmp(program, "tcs2gltf"))
		status = add_option(plan, stage, "--format", plan->to, fault);
	return status;
}

static struct passed *
find_passed(struct passed *passed, const char *name)
{
	while (strcmp(passed->name, name) != 0)
		passed++;
	return passed;
}

/* Images are named relative to the input: its folder, unless told another. */
static void
choose_images(struct plan *plan, struct passed *all)
{
	struct passed *passed = find_passed(all, "images");
	const char *input = plan->command.input;
	const char *slash = input ? strrchr(input, '/') : NULL;
	size_t length = slash ? (size_t)(slash - input) : 0;

	if (!input || passed->value || length >= sizeof plan->images)
		return;
	strcpy(plan->images, slash ? "/" : ".");
	if (length) {
		memcpy(plan->images, input, length);
		plan->images[length] = '\0';
	}
	passed->value = plan->images;
}

/* What writes all levels gets all, unless told which. */
static void
choose_levels(struct passed *all)
{
	struct passed *passed = find_passed(all, "lod");

	if (!passed->value)
		passed->value = "all";
}

static enum tcs_status
make_plan(struct plan *plan, struct passed *passed, struct tcs_fault *fault)
{
	const struct command *command = &plan->command;
	const struct format *from = choose_format(
		command, plan->from, command->input, "--from FORMAT");
	const struct format *to = choose_format(
		command, plan->to, command->output, "--to FORMAT");
	const char *reader = from->reader, *writer = to->writer;
	bool simplified = find_passed(passed, "rate")->value != NULL;
	enum tcs_status status = TCS_OK;

	if (!reader)
		program_usage(
			command, ".%s is written, not read", from->suffix);
	if (!writer)
		program_usage(command, ".%s is read, not written", to->suffix);
	if (!*reader && !*writer && !simplified && !plan->exterior)
		program_usage(
			command, "from .tcs to .tcs there is nothing to do");
	if (!strcmp(reader, "citygml2tcs") && !strcmp(writer, "tcs2citygml"))
		choose_levels(passed);
	if (*reader)
		status = add_stage(plan, reader, passed, fault);
	if (!status && plan->exterior)
		status = add_stage(plan, "tcs-exterior", passed, fault);
	if (!status && simplified)
		status = add_stage(plan, "tcs-simplify", passed, fault);
	if (!strcmp(writer, "tcs2gltf"))
		choose_images(plan, passed);
	if (!status && *writer)
		status = add_stage(plan, writer, passed, fault);
	for (; !status && passed->name; passed++)
		if (passed->value && !passed->taken)
			program_usage(command,
				"no stage of this pipe takes --%s",
				passed->name);
	return status;
}

/* ---- what every stage takes --------------------------------------------- */

static void
stats_name(const struct plan *plan, size_t stage, char name[], size_t room)
{
	snprintf(name, room, "%s/%zu", plan->folder, stage + 1);
}

static enum tcs_status
add_common(struct plan *plan, size_t stage, struct tcs_fault *fault)
{
	const struct command *command = &plan->command;
	enum tcs_status status = TCS_OK;
	char text[MAX_NAME + MAX_NUMBER];

	if (command->jobs != crew_processors()) {
		snprintf(text, sizeof text, "%u", command->jobs);
		status = add_option(plan, stage, "-j", text, fault);
	}
	if (!status && command->quiet)
		status = add_option(plan, stage, "-q", NULL, fault);
	for (unsigned i = 0; !status && i < command->verbose; i++)
		status = add_option(plan, stage, "-v", NULL, fault);
	if (!status && command->strict)
		status = add_option(plan, stage, "--strict", NULL, fault);
	if (!status && *plan->folder) {
		stats_name(plan, stage, text, sizeof text);
		status = add_option(plan, stage, "--stats", text, fault);
	}
	return status;
}

static enum tcs_status
add_files(struct plan *plan, struct tcs_fault *fault)
{
	const struct command *command = &plan->command;
	size_t last = plan->pipeline.stages.count - 1;
	enum tcs_status status = TCS_OK;

	if (command->output)
		status = add_option(plan, last, "-o", command->output, fault);
	if (!status && command->input)
		status = *command->input == '-'
			? add_option(plan, 0, "--", command->input, fault)
			: add_option(plan, 0, command->input, NULL, fault);
	return status;
}

/* ---- statistics --------------------------------------------------------- */

static enum tcs_status
make_folder(struct plan *plan, struct tcs_fault *fault)
{
	const char *parent = getenv("TMPDIR");
	int length = snprintf(plan->folder, sizeof plan->folder,
		"%s/tessera-XXXXXX", parent && *parent ? parent : "/tmp");

	if (length >= (int)sizeof plan->folder)
		errno = ENAMETOOLONG;
	else if (mkdtemp(plan->folder))
		return TCS_OK;
	*plan->folder = '\0';
	return fault_system(fault, "cannot write", "a temporary folder");
}

static void
remove_folder(const struct plan *plan)
{
	char name[MAX_NAME + MAX_NUMBER];

	if (!*plan->folder)
		return;
	for (size_t i = 0; i < plan->pipeline.stages.count; i++) {
		stats_name(plan, i, name, sizeof name);
		unlink(name);
	}
	rmdir(plan->folder);
}

static enum tcs_status
copy_file(const char *name, FILE *to, struct tcs_fault *fault)
{
	char bytes[4096];
	FILE *file = fopen(name, "rb");
	size_t got;
	bool bad;

	if (!file)
		return fault_system(fault, "cannot read", name);
	while ((got = fread(bytes, 1, sizeof bytes, file)) > 0)
		fwrite(bytes, 1, got, to);
	bad = ferror(file);
	fclose(file);
	return bad ? fault_system(fault, "cannot read", name) : TCS_OK;
}

/* One object, the stages' own objects in an array in it. */
static enum tcs_status
write_stats(const struct plan *plan, struct tcs_fault *fault)
{
	struct output output;
	enum tcs_status status =
		output_open(&output, plan->command.stats, fault);

	if (status)
		return status;
	fputs("{\"program\": \"tessera\", \"version\": \"" TESSERA_VERSION
	      "\",\n \"stages\": [\n",
		output.file);
	for (size_t i = 0; !status && i < plan->pipeline.stages.count; i++) {
		char name[MAX_NAME + MAX_NUMBER];

		if (i)
			fputs(",\n", output.file);
		stats_name(plan, i, name, sizeof name);
		status = copy_file(name, output.file, fault);
	}
	if (status) {
		output_discard(&output);
		return status;
	}
	fputs("]}\n", output.file);
	return output_commit(&output, fault);
}

/* ---- the run ------------------------------------------------------------ */

/*
 * A stage has said itself what is wrong; this adds which one it was. A signal
 * is passed on to ourselves once everything is cleaned up.
 */
static int
run(struct plan *plan)
{
	struct tcs_fault fault = {.at = TCS_NOWHERE};
	int exit_status, number;
	enum tcs_status status =
		pipeline_run(&plan->pipeline, &exit_status, &number, &fault);

	if (!status && *plan->folder) {
		status = write_stats(plan, &fault);
		exit_status = status ? EXIT_FAILED : EXIT_DONE;
	}
	remove_folder(plan);
	if (number) {
		signal(number, SIG_DFL);
		raise(number);
	}
	if (status)
		program_fail(&plan->command, &fault);
	return exit_status == EXIT_DONE || exit_status == EXIT_USAGE
		? exit_status
		: EXIT_FAILED;
}

static int
prepare_and_run(struct plan *plan, struct passed *passed)
{
	const struct command *command = &plan->command;
	struct tcs_fault fault = {.at = TCS_NOWHERE};
	enum tcs_status status = make_plan(plan, passed, &fault);

	if (!status && command->stats && !plan->dry_run)
		status = make_folder(plan, &fault);
	for (size_t i = 0; !status && i < plan->pipeline.stages.count; i++)
		status = add_common(plan, i, &fault);
	if (!status)
		status = add_files(plan, &fault);
	if (status) {
		remove_folder(plan);
		return program_fail(command, &fault);
	}
	if (!plan->dry_run)
		return run(plan);
	pipeline_print(&plan->pipeline, stdout);
	return fflush(stdout) ? EXIT_FAILED : EXIT_DONE;
}

static const struct passed passed_options[] = {
	{"lod", "LIST",
		"Levels of detail to take (default: the highest of each "
		"feature; to CityGML: all).",
		{"citygml2tcs", "tcs2gltf"}, .value = NULL},
	{"rate", "R", "Simplify: remove this share of each object's triangles.",
		{"tcs-simplify"}, .value = NULL},
	{"ade", "HOW", "What extensions of CityGML add: keep, drop.",
		{"citygml2tcs"}, .value = NULL},
	{"max-bytes", "N", "Longest document to read, uncompressed.",
		{"citygml2tcs"}, .value = NULL},
	{"max-feature", "N", "Longest top-level feature to read.",
		{"citygml2tcs"}, .value = NULL},
	{"max-tag", "N", "Longest tag or comment to read.", {"citygml2tcs"},
		.value = NULL},
	{"max-depth", "N", "Deepest nesting of elements to read.",
		{"citygml2tcs"}, .value = NULL},
	{"max-library", "N", "Largest library object to read.", {"citygml2tcs"},
		.value = NULL},
	{"max-record", "BYTES", "Largest record of the stream.",
		{"json2tcs", "tcs-simplify", "tcs2json", "tcs2gltf",
			"tcs2citygml"},
		.value = NULL},
	{"citygml", "VERSION", "CityGML to write: 1.0, 2.0, 3.0.",
		{"tcs2citygml"}, .value = NULL},
	{"max-triangles", "N", "Most triangles of one object.", {"tcs2gltf"},
		.value = NULL},
	{"max-columns", "N", "Most columns of attributes in a table.",
		{"tcs2gltf"}, .value = NULL},
	{"theme", "NAME", "Appearance theme for colours.", {"tcs2gltf"},
		.value = NULL},
	{"textures", "WHICH", "Texture images: keep, drop.", {"tcs2gltf"},
		.value = NULL},
	{"images", "DIR",
		"Folder of the texture images (default: that of the input).",
		{"citygml2tcs", "tcs2gltf"}, .by_all = true},
	{"max-image", "BYTES", "Largest texture image.", {"tcs2gltf"},
		.value = NULL},
	{"instances", "HOW", "Repeated shapes: baked, nodes, gpu.",
		{"tcs2gltf"}, .value = NULL},
	{"normals", "KIND", "Normals: flat, smooth, none.", {"tcs2gltf"},
		.value = NULL},
	{"crease", "DEGREES", "Angle from which smooth normals keep an edge.",
		{"tcs2gltf"}, .value = NULL},
	{"origin", "PLACE", "Where the origin stands: extras, translation.",
		{"tcs2gltf"}, .value = NULL},
};

enum {
	PASSED = sizeof passed_options / sizeof *passed_options,
	OWN = 4,
};

/* The driver's own options, then those it hands on, then the zero row. */
static void
fill_options(struct option_row rows[OWN + PASSED + 1], struct plan *plan,
	struct passed passed[PASSED + 1])
{
	const struct option_row own[OWN] = {
		{OPTION_PARSE, 0, "from", "FORMAT",
			"Read FORMAT, whatever the input is called.",
			&plan->from, 0, 0, note_suffix},
		{OPTION_PARSE, 0, "to", "FORMAT",
			"Write FORMAT, whatever the output is called.",
			&plan->to, 0, 0, note_suffix},
		{OPTION_FLAG, 0, "exterior", NULL,
			"Keep only what is seen from outside.", &plan->exterior,
			0, 0, NULL},
		{OPTION_FLAG, 'n', "dry-run", NULL,
			"Print the pipe instead of running it.", &plan->dry_run,
			0, 0, NULL},
	};

	memcpy(rows, own, sizeof own);
	for (size_t i = 0; i < PASSED; i++) {
		passed[i] = passed_options[i];
		rows[OWN + i] = (struct option_row){
			.type = OPTION_TEXT,
			.name = passed[i].name,
			.argument = passed[i].argument,
			.help = passed[i].help,
			.target = &passed[i].value,
		};
	}
	rows[OWN + PASSED] = (struct option_row){.type = OPTION_END};
	passed[PASSED] = (struct passed){.name = NULL};
}

int
main(int argc, char **argv)
{
	struct plan plan = {.folder = ""};
	struct passed passed[PASSED + 1];
	struct option_row options[OWN + PASSED + 1];
	const struct program program = {"tessera", "[options] in -o out",
		"Convert a city or building model, by its file names, through "
		"the programs for its formats.",
		options, PROGRAM_READS};
	int result;

	fill_options(options, &plan, passed);
	program_begin(&program, argc, argv, &plan.command);
	result = prepare_and_run(&plan, passed);
	pipeline_release(&plan.pipeline);
	program_end(&plan.command);
	return result;
}
