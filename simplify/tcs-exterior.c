/* tcs-exterior: objects as they are seen from outside. */
#include <stdlib.h>

#include "exterior.h"
#include "object_stream.h"

struct options {
	struct exterior_settings settings;
	uint64_t max_record;
};

static void
begin(void *context, const struct tcs_crs *crs)
{
	struct options *options = context;

	options->settings.crs = *crs;
}

static enum tcs_status
keep_exterior(void *context, void *worker, struct tcs_object *object,
	const struct tcs_object **out, struct report *report,
	struct tcs_fault *fault)
{
	const struct options *options = context;

	*out = object;
	return exterior_keep(worker, &options->settings, object, report, fault);
}

static void
release_worker(void *worker)
{
	exterior_release(worker);
}

static enum tcs_status
filter(void *context, struct stage *stage, struct tcs_fault *fault)
{
	struct options *options = context;
	const struct object_work work = {
		.context = options,
		.max_record = options->max_record,
		.expand = true,
		.worker_size = sizeof(struct exterior),
		.worker_release = release_worker,
		.begin = begin,
		.filter = keep_exterior,
	};

	options->settings.jobs = stage->command->jobs;
	return object_stream_run(&work, stage, fault);
}

int
main(int argc, char **argv)
{
	struct options options = {
		.settings = {.least = 0.01, .pixel = 0.05},
		.max_record = TCS_MAX_RECORD,
	};
	const struct option_row rows[] = {
		{OPTION_FLAG, 0, "faces", NULL,
			"Take out single faces, rather than whole parts.",
			&options.settings.faces, 0, 0, NULL},
		{OPTION_NUMBER, 0, "least", "SHARE",
			"Keep that of which at least this share is seen, 0 to "
			"1 (default: 0.01).",
			&options.settings.least, 0, 1, NULL},
		{OPTION_NUMBER, 0, "pixel", "METRES",
			"Look at pictures with pixels this wide (default: "
			"0.05).",
			&options.settings.pixel, 1e-4, 1000, NULL},
		{OPTION_BYTES, 0, "max-record", "BYTES",
			"Refuse records of more bytes (default: 8G).",
			&options.max_record, 0, 0, NULL},
		{0},
	};
	const struct program program = {
		.name = "tcs-exterior",
		.synopsis = "[options] [in [out]]",
		.summary = "Keep what is seen of objects from outside.",
		.options = rows,
		.flags = PROGRAM_READS | PROGRAM_BINARY_IN | PROGRAM_BINARY_OUT,
	};
	struct command command;
	int code;

	program_begin(&program, argc, argv, &command);
	code = stage_run(&command, filter, &options);
	program_end(&command);
	return code;
}
