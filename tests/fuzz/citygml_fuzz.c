/*
 * CityGML of any bytes: what comes through keeps the rules of the stream. The
 * first byte says how large the pieces are that the parser gets.
 */
#include <assert.h>
#include <stdint.h>
#include <stdlib.h>

#include "parsers/citygml_build.h"
#include "parsers/citygml_reader.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

struct target {
	struct gml_reader reader;
	struct builder builder;
	struct build_plan plan;
	struct tcs_object prototype;
	struct tcs_fault fault;
};

static enum tcs_status
build_all(struct target *target, struct raw_object *raw)
{
	enum tcs_status status = TCS_OK;

	for (size_t i = 0; !status && i < raw->templates.count; i++) {
		status = build_prototype(&target->builder, &target->plan, raw,
			raw->templates.at[i].geometry, &target->prototype,
			&raw->report, &target->fault);
		if (!status)
			status = object_check(
				&target->prototype, &target->fault);
	}
	if (!status)
		status = build_object(
			&target->builder, &target->plan, raw, &target->fault);
	return status ? status : object_check(&raw->tree, &target->fault);
}

/* Whatever the document, a complete object can be built and is sound. */
static void
take_all(struct target *target)
{
	struct raw_object *raw;

	while ((raw = gml_take(&target->reader))) {
		enum tcs_status status = build_all(target, raw);

		if (status)
			fprintf(stderr, "%s\n", target->fault.text);
		if (status)
			abort();
		gml_recycle(&target->reader, raw);
	}
}

static void
run_pass(struct target *target, enum gml_pass pass, const char *bytes,
	size_t size, size_t piece)
{
	enum tcs_status status =
		gml_start_pass(&target->reader, pass, &target->fault);

	while (!status) {
		size_t length = size < piece ? size : piece;

		status = gml_feed(
			&target->reader, bytes, length, &target->fault);
		take_all(target);
		if (!length)
			return;
		bytes += length;
		size -= length;
	}
}

int
LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
	const struct gml_options options = {
		.xml = {.depth = 64, .tag = 4096},
		.drop_extensions = size && data[0] & 2,
	};
	struct target *target;
	size_t piece;

	if (size < 2)
		return 0;
	piece = data[0] + 1u;
	target = calloc(1, sizeof *target);
	if (!target)
		return 0;
	target->plan.lods.highest = data[0] & 1;
	for (int i = 0; i < 5; i++)
		target->plan.lods.lods[i] = true;
	if (!gml_begin(&target->reader, &options, &target->fault) &&
		!builder_init(&target->builder, &target->fault)) {
		const char *bytes = (const char *)data + 1;

		run_pass(target, PASS_APPEARANCES, bytes, size - 1, piece);
		run_pass(target, PASS_OBJECTS, bytes, size - 1, piece);
	}
	gml_release(&target->reader);
	builder_release(&target->builder);
	object_release(&target->prototype);
	free(target);
	return 0;
}
