/* tcs-simplify: levels of detail that do not fall apart. */
#include <stdlib.h>

#include "number.h"
#include "object_simplifier.h"
#include "object_stream.h"

struct options {
	struct simplify_settings settings;
	double rate, triangles, lambda; /* -1: not given */
	bool expand;
	uint64_t max_record;
};

static void
begin(void *context, const struct tcs_crs *crs)
{
	struct options *options = context;

	options->settings.crs = *crs;
}

static enum tcs_status
simplify(void *context, void *worker, struct tcs_object *object,
	const struct tcs_object **out, struct report *report,
	struct tcs_fault *fault)
{
	const struct options *options = context;

	return simplify_object(
		worker, &options->settings, object, out, report, fault);
}

static void
release_simplifier(void *worker)
{
	object_simplifier_release(worker);
}

static enum tcs_status
convert(void *context, struct stage *stage, struct tcs_fault *fault)
{
	struct options *options = context;
	const struct object_work work = {
		.context = options,
		.max_record = options->max_record,
		.expand = options->expand,
		.worker_size = sizeof(struct object_simplifier),
		.worker_release = release_simplifier,
		.begin = begin,
		.filter = simplify,
	};

	options->settings.jobs = stage->command->jobs;
	return object_stream_run(&work, stage, fault);
}

/* ---- the command line ---------------------------------------------------- */

/* Shares that go by default, from the middle of what each level is meant to
   lose; source: W, levels of detail. */
static const double default_rates[] = {-1, 0.85, 0.5, 0.15, -1};

static int
by_rate(const void *left, const void *right)
{
	const struct simplify_level *a = left, *b = right;

	return (a->budget.amount > b->budget.amount) -
		(a->budget.amount < b->budget.amount);
}

static const char *
add_level(struct simplify_settings *settings, int lod, double rate)
{
	for (size_t i = 0; i < settings->level_count; i++)
		if (settings->levels[i].lod == lod)
			return "this level is wanted twice";
	settings->levels[settings->level_count++] =
		(struct simplify_level){{BUDGET_RATE, rate}, lod};
	return NULL;
}

/* "N" or "N:RATE" */
static const char *
parse_level(void *target, const char *argument)
{
	struct simplify_settings *settings = target;
	int lod = argument[0] - '0';
	double rate;
	char *end;

	if (lod < 0 || lod > 4 || (argument[1] && argument[1] != ':'))
		return "not N or N:RATE with N one of 0, 1, 2, 3, 4";
	rate = default_rates[lod];
	if (!argument[1])
		return rate < 0 ? "levels 0 and 4 have no rate by default"
				: add_level(settings, lod, rate);
	rate = strtod(argument + 2, &end);
	if (end == argument + 2 || *end || !(rate >= 0) || !(rate < 1))
		return "its rate is not a number from 0 to below 1";
	return add_level(settings, lod, rate);
}

/* What is put in the place of the original, when no level beside it is
   wanted. */
static struct face_budget
choose_budget(const struct options *options)
{
	if (options->rate >= 0)
		return (struct face_budget){BUDGET_RATE, options->rate};
	if (options->triangles >= 0)
		return (struct face_budget){
			BUDGET_TRIANGLES, options->triangles};
	if (options->lambda >= 0)
		return (struct face_budget){BUDGET_STRUCTURE, options->lambda};
	if (options->settings.max_error > 0)
		return (struct face_budget){BUDGET_ERROR, 0};
	return (struct face_budget){BUDGET_RATE, 0.5};
}

static void
settle_levels(const struct command *command, struct options *options)
{
	struct simplify_settings *settings = &options->settings;
	int goals = (options->rate >= 0) + (options->triangles >= 0) +
		(options->lambda >= 0) + (settings->level_count > 0);

	if (goals > 1)
		program_usage(command,
			"--rate, --triangles, --lambda and --lod exclude each "
			"other");
	if (!settings->level_count)
		settings->levels[settings->level_count++] =
			(struct simplify_level){
				choose_budget(options), LOD_IN_PLACE};
	qsort(settings->levels, settings->level_count, sizeof *settings->levels,
		by_rate);
}

int
main(int argc, char **argv)
{
	struct options options = {
		.settings = {.source = SELECT_HIGHEST, .base_ratio = 1},
		.rate = -1,
		.triangles = -1,
		.lambda = -1,
		.max_record = TCS_MAX_RECORD,
	};
	const struct option_row rows[] = {
		{OPTION_NUMBER, 0, "rate", "R",
			"Remove this share of each object's triangles, 0 to 1 "
			"(default: 0.5).",
			&options.rate, 0, 1, NULL},
		{OPTION_NUMBER, 0, "triangles", "N",
			"Leave each object at most so many triangles.",
			&options.triangles, 0, 0, NULL},
		{OPTION_NUMBER, 0, "lambda", "L",
			"Leave each object L triangles for every open edge, "
			"feature line and corner.",
			&options.lambda, 0, 1e6, NULL},
		{OPTION_NUMBER, 0, "max-error", "METRES",
			"Keep the surface this near to the original; alone, go "
			"as far as that allows.",
			&options.settings.max_error, 1e-6, 1e6, NULL},
		{OPTION_PARSE, 0, "lod", "N[:RATE]",
			"Add a level of detail beside the original, several "
			"times if wanted.",
			&options.settings, 0, 0, parse_level},
		{OPTION_PARSE, 0, "from", "N",
			"Level that is simplified (default: the highest of "
			"each feature).",
			&options.settings.source, 0, 0, lod_parse},
		{OPTION_FLAG, 0, "expand", NULL,
			"Make placed prototypes geometry of the objects, and "
			"simplify it with them.",
			&options.expand, 0, 0, NULL},
		{OPTION_CHOICE, 0, "placement", "half-edge|optimal",
			"Leave vertices where they are, or move what touches "
			"nothing to the best place (default: half-edge).",
			&options.settings.placement, 0, 0, NULL},
		{OPTION_NUMBER, 0, "a", "RATIO",
			"How much dearer boundary vertices are (default: 1).",
			&options.settings.base_ratio, 1, 1000, NULL},
		{OPTION_FLAG, 0, "keep-interior", NULL,
			"Do not take parts away sooner where they are not "
			"seen.",
			&options.settings.keep_interior, 0, 0, NULL},
		{OPTION_BYTES, 0, "max-record", "BYTES",
			"Refuse records of more bytes (default: 8G).",
			&options.max_record, 0, 0, NULL},
		{0},
	};
	const struct program program = {
		.name = "tcs-simplify",
		.synopsis = "[options] [in [out]]",
		.summary = "Simplify objects without tearing them apart.",
		.options = rows,
		.flags = PROGRAM_READS | PROGRAM_BINARY_IN | PROGRAM_BINARY_OUT,
	};
	struct command command;
	int code;

	program_begin(&program, argc, argv, &command);
	settle_levels(&command, &options);
	code = stage_run(&command, convert, &options);
	program_end(&command);
	return code;
}
