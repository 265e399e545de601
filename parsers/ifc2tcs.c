/* IFC to a component stream: the option table and the loop. */
#include <ctype.h>
#include <string.h>

#include "ifc_convert.h"
#include "stage.h"

/* "IfcWall,IfcSlab", in capitals or not. */
static const char *
parse_types(void *target, const char *argument)
{
	struct ifc_keep *keep = target;

	keep->type_count = 0;
	for (;;) {
		char name[64] = "";
		size_t length = strcspn(argument, ",");

		for (size_t i = 0; i < length && i + 1 < sizeof name; i++)
			name[i] = (char)toupper((unsigned char)argument[i]);
		if (ifc_find(name) == IFC_NONE)
			return "not a list of IFC's entities";
		if (keep->type_count == IFC_MOST_TYPES)
			return "too many entities";
		keep->types[keep->type_count++] = ifc_find(name);
		if (!argument[length])
			return NULL;
		argument += length + 1;
	}
}

/* "Ground floor,Attic". */
static const char *
parse_storeys(void *target, const char *argument)
{
	struct ifc_keep *keep = target;

	for (;;) {
		size_t length = strcspn(argument, ",");

		if (!length)
			return "not a list of names";
		if (keep->storey_count == IFC_MOST_STOREYS)
			return "too many storeys";
		keep->storeys[keep->storey_count++] =
			(struct ifc_storey_name){argument, length};
		if (!argument[length])
			return NULL;
		argument += length + 1;
	}
}

static enum tcs_status
convert(void *context, struct stage *stage, struct tcs_fault *fault)
{
	const struct command *command = stage->command;
	const struct ifc_options *options = context;
	struct input input = {0};
	enum tcs_status status = input_open(&input, command->input, fault);

	if (!status)
		status = output_open(&stage->out, command->output, fault);
	if (!status)
		status = ifc_convert(&input, stage->out.file, options, command,
			&stage->report, fault);
	input_close(&input);
	return status;
}

int
main(int argc, char **argv)
{
	struct ifc_options options = {.deflection = 0.001};
	const struct option_row rows[] = {
		{.type = OPTION_FLAG,
			.name = "local",
			.help = "Keep the file's own coordinates, in metres, "
				"whatever place on the map it tells.",
			.target = &options.local},
		{.type = OPTION_FLAG,
			.name = "no-spaces",
			.help = "Leave out rooms and other spaces.",
			.target = &options.keep.no_spaces},
		{.type = OPTION_PARSE,
			.name = "storeys",
			.argument = "LIST",
			.help = "Keep these storeys of buildings, by name or "
				"GlobalId, and what is in them, only.",
			.target = &options.keep,
			.parse = parse_storeys},
		{.type = OPTION_PARSE,
			.name = "types",
			.argument = "LIST",
			.help = "Of the products, keep these entities and "
				"their subtypes only, as in "
				"IfcWall,IfcSlab.",
			.target = &options.keep,
			.parse = parse_types},
		{.type = OPTION_FLAG,
			.name = "bake",
			.help = "Give every product geometry of its own, "
				"rather than instances of prototypes.",
			.target = &options.bake},
		{.type = OPTION_FLAG,
			.name = "layers",
			.help = "Cut walls, slabs and the like into the layers "
				"of their material.",
			.target = &options.layers},
		{.type = OPTION_NUMBER,
			.name = "deflection",
			.argument = "METRES",
			.help = "Let chords be off their curves by this much "
				"at most (default: 0.001).",
			.target = &options.deflection,
			.low = 1e-6,
			.high = 1000},
		{.type = OPTION_FLAG,
			.letter = 'z',
			.name = "compress",
			.help = "Compress the records, for storage.",
			.target = &options.compress},
		{.type = OPTION_BYTES,
			.name = "max-bytes",
			.argument = "N",
			.help = "Fail when the file, unpacked, is longer than "
				"N bytes (default: no limit).",
			.target = &options.max_bytes},
		{0},
	};
	const struct program program = {
		.name = "ifc2tcs",
		.synopsis = "[options] [in [out]]",
		.summary = "Read IFC, write a component stream.",
		.options = rows,
		.flags = PROGRAM_READS | PROGRAM_BINARY_OUT,
	};
	struct command command;
	int code;

	program_begin(&program, argc, argv, &command);
	code = stage_run(&command, convert, &options);
	program_end(&command);
	return code;
}
