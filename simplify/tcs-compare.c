/* tcs-compare: how one stream differs from another, or one LOD from another. */
#include "compare_html.h"
#include "compare_pairs.h"
#include "compare_print.h"
#include "crew.h"
#include "progress.h"
#include "stage.h"

struct options {
	struct compare_settings settings;
	uint64_t max_record;
	bool json, html;
};

/* A pair of objects on its way to the report. */
struct item {
	struct pair_object *pair[2];
	struct compare_result result;
};

struct run {
	const struct options *options;
	struct stage *stage;
	struct compare_settings settings;
	struct pair_reader pairs;
	struct compare_totals totals;
	struct gallery gallery;
	struct progress progress;
};

static void
clear_item(struct item *item)
{
	for (int i = 0; i < 2; i++) {
		pair_object_free(item->pair[i]);
		item->pair[i] = NULL;
	}
}

static enum tcs_status
read_item(void *context, void *slot, bool *done, struct tcs_fault *fault)
{
	struct run *run = context;
	struct item *item = slot;
	enum tcs_status status = pairs_next(&run->pairs, item->pair, fault);

	*done = !item->pair[0] && !item->pair[1];
	return status;
}

static enum tcs_status
compare_item(void *context, void *slot, void *worker, struct tcs_fault *fault)
{
	struct run *run = context;
	struct item *item = slot;
	struct compared_object pair[2] = {{NULL, NULL}, {NULL, NULL}};

	for (int i = 0; i < 2; i++)
		if (item->pair[i])
			pair[i] =
				(struct compared_object){&item->pair[i]->object,
					item->pair[i]->placed.at};
	return compare_objects(
		worker, &run->settings, pair, &item->result, fault);
}

static enum tcs_status
print_item(struct run *run, struct item *item, struct tcs_fault *fault)
{
	const struct compare_totals *totals = &run->totals;
	bool first = !totals->pairs && !totals->lost && !totals->added;
	FILE *to = run->stage->out.file;
	const struct tcs_object *before =
		item->pair[0] ? &item->pair[0]->object : NULL;
	const struct tcs_object *after =
		item->pair[1] ? &item->pair[1]->object : NULL;

	if (!run->options->html) {
		compare_print_object(&item->result, before, after,
			run->options->json, first, to);
		return TCS_OK;
	}
	html_print_object(&item->result, before, after, to);
	return before
		? gallery_take(&run->gallery, &item->result, before, fault)
		: TCS_OK;
}

static enum tcs_status
write_item(void *context, void *slot, struct tcs_fault *fault)
{
	struct run *run = context;
	struct item *item = slot;
	struct compare_totals *totals = &run->totals;
	const struct output *out = &run->stage->out;
	enum tcs_status status = print_item(run, item, fault);

	totals->pairs += item->pair[0] && item->pair[1];
	totals->lost += !item->pair[1];
	totals->added += !item->pair[0];
	metrics_add(&totals->metrics, &item->result.metrics);
	clear_item(item);
	progress_show(&run->progress,
		totals->pairs + totals->lost + totals->added, 0, 0);
	if (!status && ferror(out->file))
		return fault_system(fault, "cannot write", out->name);
	return status;
}

static void
release_item(void *slot)
{
	struct item *item = slot;

	clear_item(item);
	compare_result_release(&item->result);
}

static void
release_comparer(void *worker)
{
	comparer_release(worker);
}

/* Metres of the one must be metres of the other. */
static enum tcs_status
take_systems(struct run *run, struct tcs_fault *fault)
{
	for (int i = 0; i < 2; i++)
		run->settings.crs[i] = run->pairs.streams[i].head.crs.at[0];
	if (run->settings.crs[0].kind != run->settings.crs[1].kind ||
		run->settings.crs[0].epsg != run->settings.crs[1].epsg)
		return fault_set(fault, TCS_BAD_INPUT, TCS_NOWHERE,
			"the two streams have different reference systems");
	return TCS_OK;
}

static enum tcs_status
open_run(struct run *run, struct tcs_fault *fault)
{
	const struct command *command = run->stage->command;
	const char *const names[2] = {command->input, command->other};
	enum tcs_status status;

	run->settings = run->options->settings;
	run->settings.jobs = command->jobs;
	run->settings.pictures = run->options->html;
	status =
		pairs_open(&run->pairs, names, run->options->max_record, fault);
	if (!status)
		status = take_systems(run, fault);
	return status ? status
		      : output_open(&run->stage->out, command->output, fault);
}

static enum tcs_status
compare(struct run *run, struct tcs_fault *fault)
{
	const struct command *command = run->stage->command;
	const struct crew_plan plan = {
		.context = run,
		.slot_size = sizeof(struct item),
		.worker_size = sizeof(struct comparer),
		.read = read_item,
		.work = compare_item,
		.write = write_item,
		.worker_release = release_comparer,
		.slot_release = release_item,
	};
	enum tcs_status status;

	progress_begin(&run->progress, command->program->name, "objects",
		command->quiet);
	status = crew_run(&plan, command->jobs, fault);
	progress_end(&run->progress);
	return status;
}

static enum tcs_status
print_comparison(struct run *run, struct tcs_fault *fault)
{
	const struct options *options = run->options;
	FILE *to = run->stage->out.file;
	enum tcs_status status;

	if (options->html)
		html_print_begin(to);
	else
		compare_print_begin(options->json, to);
	status = compare(run, fault);
	if (status)
		return status;
	if (options->html)
		html_print_end(&run->totals, &run->gallery, to);
	else
		compare_print_end(&run->totals, options->json, to);
	return TCS_OK;
}

static enum tcs_status
report_totals(struct run *run, struct tcs_fault *fault)
{
	struct report *report = &run->stage->report;
	const struct compare_totals *totals = &run->totals;
	enum tcs_status status =
		report_add(report, "objects", totals->pairs, fault);

	if (!status)
		status =
			report_add(report, "objects lost", totals->lost, fault);
	return status
		? status
		: report_add(report, "objects added", totals->added, fault);
}

static enum tcs_status
convert(void *context, struct stage *stage, struct tcs_fault *fault)
{
	struct run run = {.options = context, .stage = stage};
	enum tcs_status status = open_run(&run, fault);

	if (!status)
		status = print_comparison(&run, fault);
	if (!status)
		status = report_totals(&run, fault);
	gallery_release(&run.gallery);
	pairs_close(&run.pairs);
	return status;
}

int
main(int argc, char **argv)
{
	struct options options = {
		.settings = {.lods = {SELECT_HIGHEST, SELECT_HIGHEST},
			.pixels = 192},
		.max_record = TCS_MAX_RECORD,
	};
	const struct option_row rows[] = {
		{OPTION_FLAG, 0, "json", NULL,
			"Report as one JSON object instead of text.",
			&options.json, 0, 0, NULL},
		{OPTION_FLAG, 0, "html", NULL,
			"Report as one page with pictures of the objects that "
			"differ most.",
			&options.html, 0, 0, NULL},
		{OPTION_NUMBER, 0, "eps", "METRES",
			"What still touches (default: a thousandth of the "
			"object's diagonal, from 0.01 to 0.1).",
			&options.settings.eps, 1e-6, 1000, NULL},
		{OPTION_PARSE, 0, "lod-a", "N",
			"Level of detail of A (default: the highest of each "
			"feature).",
			&options.settings.lods[0], 0, 0, lod_parse},
		{OPTION_PARSE, 0, "lod-b", "N", "Level of detail of B.",
			&options.settings.lods[1], 0, 0, lod_parse},
		{OPTION_UNSIGNED, 0, "pixels", "N",
			"Width and height of the pictures in which to see what "
			"is visible (default: 192; 0: none).",
			&options.settings.pixels, 0, 4096, NULL},
		{OPTION_BYTES, 0, "max-record", "BYTES",
			"Refuse records of more bytes (default: 8G).",
			&options.max_record, 0, 0, NULL},
		{0},
	};
	const struct program program = {
		.name = "tcs-compare",
		.synopsis = "[options] A B",
		.summary = "Report how stream B differs from stream A.",
		.options = rows,
		.flags = PROGRAM_READS_TWO | PROGRAM_BINARY_IN,
	};
	struct command command;
	int code;

	program_begin(&program, argc, argv, &command);
	if (options.json && options.html)
		program_usage(&command, "--json and --html exclude each other");
	code = stage_run(&command, convert, &options);
	program_end(&command);
	return code;
}
