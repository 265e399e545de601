/* tcs2gltf: a component stream as glTF 2.0. */
#include <math.h>
#include <string.h>

#include "gltf_city.h"
#include "gltf_file.h"
#include "gltf_name.h"
#include "gltf_stream.h"
#include "progress.h"
#include "stage.h"

/* As the option table lists them. */
enum format { FORMAT_GLB, FORMAT_GLTF, FORMAT_BY_NAME };
enum texture_choice { TEXTURES_KEEP, TEXTURES_DROP };
enum origin_choice { ORIGIN_EXTRAS, ORIGIN_TRANSLATION };

struct options {
	struct stream_settings stream;
	enum format format;
	enum texture_choice textures;
	enum origin_choice origin;
	double crease; /* degrees */
	unsigned max_columns;
	const char *images;
	uint64_t max_image;
};

struct run {
	struct options options;
	struct gltf_file file;
};

static const struct options defaults = {
	.stream = {.convert = {.lod = SELECT_HIGHEST,
			   .triangle_limit = 256 << 20},
		.max_record = TCS_MAX_RECORD},
	.format = FORMAT_BY_NAME,
	.crease = 30,
	.max_columns = 1024,
	.max_image = 256 << 20,
};

static const char *
parse_lod(void *target, const char *argument)
{
	int *lod = target;

	if (!strcmp(argument, "highest"))
		*lod = SELECT_HIGHEST;
	else if (!strcmp(argument, "all"))
		*lod = SELECT_ALL;
	else if (lod_parse(lod, argument))
		return "not one of 0, 1, 2, 3, 4, highest, all";
	return NULL;
}

static bool
wants_pair(const struct command *command, const struct options *options)
{
	if (options->format == FORMAT_BY_NAME)
		return command->output && name_is_gltf(command->output);
	return options->format == FORMAT_GLTF;
}

static enum tcs_status
write_city(struct run *run, struct city *city, struct stage *stage,
	struct tcs_fault *fault)
{
	const struct command *command = stage->command;
	const struct options *options = &run->options;
	struct stream_head head = {.origin = {0, 0, 0}};
	struct progress progress;
	enum tcs_status status;

	progress_begin(
		&progress, command->program->name, "objects", command->quiet);
	status = stream_to_city(command->input, &options->stream, city, &head,
		&stage->report, &progress, fault);
	progress_end(&progress);
	if (!status)
		status = file_write(&run->file, city, &head,
			options->origin == ORIGIN_TRANSLATION, fault);
	stream_head_release(&head);
	return status;
}

static enum tcs_status
convert(void *context, struct stage *stage, struct tcs_fault *fault)
{
	struct run *run = context;
	const struct options *options = &run->options;
	struct output *bin =
		wants_pair(stage->command, options) ? &stage->beside : NULL;
	enum tcs_status status = file_open(
		&run->file, stage->command->output, &stage->out, bin, fault);
	const struct city_settings settings = {
		.beside = file_beside(&run->file),
		.image_folder = options->images,
		.image_limit = options->max_image,
		.column_limit = options->max_columns,
		.drop_textures = options->stream.convert.drop_textures,
		.gpu_instances =
			options->stream.convert.instances == INSTANCES_GPU,
	};
	struct city city;

	if (status)
		return status;
	status = city_begin(&city, &settings, fault);
	if (!status)
		status = write_city(run, &city, stage, fault);
	city_release(&city);
	return status;
}

int
main(int argc, char **argv)
{
	struct run run = {.options = defaults};
	struct options *options = &run.options;
	struct convert_settings *settings = &options->stream.convert;
	const struct option_row rows[] = {
		{OPTION_CHOICE, 0, "format", "glb|gltf",
			"Write GLB, or .gltf and .bin (default: by the "
			"output's name, else glb).",
			&options->format, 0, 0, NULL},
		{OPTION_PARSE, 0, "lod", "N|highest|all",
			"Draw this level of detail (default: the highest of "
			"each feature).",
			&settings->lod, 0, 0, parse_lod},
		{OPTION_TEXT, 0, "theme", "NAME",
			"Colour by this appearance theme (default: the first "
			"of each object).",
			&settings->theme, 0, 0, NULL},
		{OPTION_CHOICE, 0, "textures", "keep|drop",
			"Keep texture images, or colour by material and class "
			"only (default: keep).",
			&options->textures, 0, 0, NULL},
		{OPTION_TEXT, 0, "images", "DIR",
			"Read texture images from DIR, the folder of the "
			"source, and from nowhere else.",
			&options->images, 0, 0, NULL},
		{OPTION_CHOICE, 0, "instances", "baked|nodes|gpu",
			"Draw prototypes as part of each object, as nodes that "
			"share a mesh, or by EXT_mesh_gpu_instancing (default: "
			"baked).",
			&settings->instances, 0, 0, NULL},
		{OPTION_CHOICE, 0, "normals", "flat|smooth|none",
			"One normal per polygon, averaged within a surface, "
			"or none (default: flat).",
			&settings->normals, 0, 0, NULL},
		{OPTION_NUMBER, 0, "crease", "DEGREES",
			"Keep edges of this angle in smooth normals (default: "
			"30).",
			&options->crease, 0, 180, NULL},
		{OPTION_CHOICE, 0, "origin", "extras|translation",
			"Note the origin in extras only, or also move the "
			"root node there (default: extras).",
			&options->origin, 0, 0, NULL},
		{OPTION_UNSIGNED, 0, "max-columns", "N",
			"Most columns of attributes in a table (default: "
			"1024).",
			&options->max_columns, 0, 65535, NULL},
		{OPTION_BYTES, 0, "max-triangles", "N",
			"Most triangles of one object (default: 256M).",
			&settings->triangle_limit, 0, 0, NULL},
		{OPTION_BYTES, 0, "max-image", "BYTES",
			"Largest texture image (default: 256M).",
			&options->max_image, 0, 0, NULL},
		{OPTION_BYTES, 0, "max-record", "BYTES",
			"Largest record of the stream (default: 8G).",
			&options->stream.max_record, 0, 0, NULL},
		{.type = OPTION_END},
	};
	const struct program program = {
		.name = "tcs2gltf",
		.synopsis = "[options] [in [out]]",
		.summary = "Write a component stream as glTF 2.0 with ids and "
			   "attributes.",
		.options = rows,
		.flags = PROGRAM_READS | PROGRAM_BINARY_IN | PROGRAM_BINARY_OUT,
	};
	struct command command;
	int code;

	program_begin(&program, argc, argv, &command);
	if (wants_pair(&command, options) && !command.output)
		program_usage(&command,
			"--format gltf writes two files and needs an output "
			"name");
	options->stream.jobs = command.jobs;
	options->stream.strict = command.strict;
	settings->drop_textures = options->textures == TEXTURES_DROP;
	settings->crease_cosine = cos(options->crease * acos(-1) / 180);
	code = stage_run(&command, convert, &run);
	file_release(&run.file);
	program_end(&command);
	return code;
}
