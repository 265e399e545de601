/*
 * Georeferenced textures: images that lie on the map.
 *
 * The texture says where itself, or a world file beside the image does: the
 * first is taken. What the image itself may say (GeoTIFF) is not read.
 *
 * The standard has orientation correspond to a world file, from pixels to the
 * map, and in a formula go from the map to the texture; files do either. In a
 * world file rows run down and the map's northing up, so that orientation
 * turns the image over; the formula's texture space runs up as the map does.
 * The sign of the determinant tells one from the other.
 *
 * source: CityGML 2.0 (OGC 12-019) 9.4.
 */
#include <math.h>
#include <string.h>
#include <unistd.h>

#include "citygml_numbers.h"
#include "citygml_reader.h"
#include "image_kind.h"

/* The affine map from pixels, counted from the centre of the upper left one,
 * right and down, to the map: x = at[0] column + at[1] row + at[2], … */
struct world {
	double at[6];
};

/* ---- what the texture says ------------------------------------------------ */

enum tcs_status
georeference_child(struct gml_reader *reader, struct frame *frame,
	const struct xml_attribute *attributes, size_t count,
	struct tcs_fault *fault)
{
	const struct xml_attribute *srs =
		attribute_find(attributes, count, "srsName");

	frame->wants_text |= frame->name->kind == NAME_TEXTURE_ORIENTATION ||
		frame->name->kind == NAME_POS ||
		frame->name->kind == NAME_COORDINATES;
	if (frame->name->kind == NAME_IMPLICIT_ANCHOR)
		reader->geometry_srs = TCS_NONE;
	if (!srs || !srs->length || frame->name->kind == NAME_TEXTURE_MATRIX)
		return TCS_OK;
	return gml_srs(
		reader, srs->value, srs->length, &reader->geometry_srs, fault);
}

void
georeference_end(struct gml_reader *reader, const struct frame *frame)
{
	struct georeference *georeference = &reader->georeference;
	const char *at = reader->text.at;
	size_t length = reader->text.count;
	uint32_t system;

	switch (frame->name->kind) {
	case NAME_TEXTURE_ORIENTATION:
		georeference->has_orientation =
			numbers_first(
				at, length, georeference->orientation, 4) == 4;
		return;
	case NAME_POS:
	case NAME_COORDINATES:
		georeference->has_anchor =
			numbers_first(at, length, georeference->anchor, 2) == 2;
		system = gml_system(reader, reader->geometry_srs);
		georeference->north_first = system != TCS_NONE &&
			gml_north_first(reader, system, at, length);
		return;
	default:
		return;
	}
}

/* ---- files beside the document ----------------------------------------------- */

static enum tcs_status
beside_open(struct gml_reader *reader, const char *uri, uint64_t limit,
	struct image_bytes *out, struct tcs_fault *fault)
{
	const struct folder_limit most = {limit, "too large"};
	struct folder_file file = {.file = -1};
	const char *reason = "there is no folder";
	enum tcs_status status = TCS_OK;

	if (reader->folder.name)
		status = folder_open_file(
			&reader->folder, uri, &most, &file, &reason, fault);
	*out = (struct image_bytes){NULL, reason ? -1 : file.file, file.size};
	return status;
}

static enum tcs_status
image_size(struct gml_reader *reader, uint32_t size[2], struct tcs_fault *fault)
{
	struct image_bytes bytes;
	enum tcs_status status = beside_open(
		reader, reader->texture.uri.at, UINT64_MAX, &bytes, fault);

	size[0] = size[1] = 0;
	if (status || bytes.file < 0)
		return status;
	if (!image_pixels(&bytes, &size[0], &size[1]))
		size[0] = size[1] = 0;
	close(bytes.file);
	return TCS_OK;
}

enum { MOST_WORLD = 4096, MOST_NAME = 1024 }; /* bytes */

static enum tcs_status
world_read(struct gml_reader *reader, const char *uri, struct world *world,
	bool *found, struct tcs_fault *fault)
{
	char text[MOST_WORLD];
	struct image_bytes bytes;
	double lines[6];
	enum tcs_status status =
		beside_open(reader, uri, sizeof text, &bytes, fault);
	size_t length;

	if (status || bytes.file < 0)
		return status;
	length = image_read(&bytes, 0, text, sizeof text);
	close(bytes.file);
	*found = numbers_first(text, length, lines, 6) == 6;
	*world = (struct world){
		{lines[0], lines[2], lines[4], lines[1], lines[3], lines[5]}};
	return TCS_OK;
}

/* "a.tif" may have its world file in a.tfw, a.tifw or a.wld. */
static enum tcs_status
world_find(struct gml_reader *reader, struct world *world, bool *found,
	struct tcs_fault *fault)
{
	const char *uri = reader->texture.uri.at;
	const char *dot = strrchr(uri, '.');
	char names[3][MOST_NAME];
	enum tcs_status status = TCS_OK;
	int base;

	if (!dot || strlen(dot) < 3 || strchr(dot, '/') ||
		strlen(uri) > MOST_NAME - 8)
		return TCS_OK;
	base = (int)(dot + 1 - uri);
	snprintf(names[0], MOST_NAME, "%.*s%c%cw", base, uri, dot[1],
		uri[strlen(uri) - 1]);
	snprintf(names[1], MOST_NAME, "%sw", uri);
	snprintf(names[2], MOST_NAME, "%.*swld", base, uri);
	for (int i = 0; i < 3 && !*found && !status; i++)
		status = world_read(reader, names[i], world, found, fault);
	return status;
}

/* ---- the mapping --------------------------------------------------------------- */

static double
determinant(const struct world *world)
{
	return world->at[0] * world->at[4] - world->at[1] * world->at[3];
}

/* The rows of the texture matrix from the inverse of the map. */
static bool
matrix_of_world(const struct world *world, const uint32_t size[2],
	struct raw_texmatrix *matrix)
{
	const double *w = world->at;
	double d = determinant(world), width = size[0], height = size[1];
	double column[3] = {w[4] / d, -w[1] / d, 0};
	double row[3] = {-w[3] / d, w[0] / d, 0};

	column[2] = 0.5 - column[0] * w[2] - column[1] * w[5];
	row[2] = 0.5 - row[0] * w[2] - row[1] * w[5];
	*matrix = (struct raw_texmatrix){
		.at = {column[0] / width, column[1] / width, 0,
			column[2] / width, -row[0] / height, -row[1] / height,
			0, 1 - row[2] / height, 0, 0, 0, 1},
		.east_first = true,
	};
	return width > 0 && height > 0;
}

/* The standard's formula: (s, t) = orientation · (point - anchor). */
static void
matrix_of_formula(const struct georeference *from, struct raw_texmatrix *matrix)
{
	const double *o = from->orientation, *p = from->anchor;
	bool swap = from->north_first;

	*matrix = (struct raw_texmatrix){
		.at = {o[swap], o[!swap], 0, -o[0] * p[0] - o[1] * p[1],
			o[2 + swap], o[2 + !swap], 0,
			-o[2] * p[0] - o[3] * p[1], 0, 0, 0, 1},
		.east_first = true,
	};
}

static bool
is_finite(const struct raw_texmatrix *matrix)
{
	for (int i = 0; i < 12; i++)
		if (!isfinite(matrix->at[i]))
			return false;
	return true;
}

/* As written in the texture, with easting first. */
static struct world
world_of_texture(const struct georeference *from)
{
	const double *o = from->orientation, *p = from->anchor;

	return from->north_first
		? (struct world){{o[2], o[3], p[1], o[0], o[1], p[0]}}
		: (struct world){{o[0], o[1], p[0], o[2], o[3], p[1]}};
}

/* *problem is NULL with *matrix filled, or static text. */
static enum tcs_status
georeference_find(struct gml_reader *reader, struct raw_texmatrix *matrix,
	const char **problem, struct tcs_fault *fault)
{
	const struct georeference *inside = &reader->georeference;
	bool found = inside->has_anchor && inside->has_orientation;
	struct world world = world_of_texture(inside);
	enum tcs_status status = TCS_OK;
	bool of_file = !found;
	uint32_t size[2];

	if (!found)
		status = world_find(reader, &world, &found, fault);
	*problem = NULL;
	if (status)
		return status;
	if (!found) {
		*problem = "neither it nor a world file says where it lies";
		return TCS_OK;
	}
	if (!of_file && determinant(&world) > 0) {
		matrix_of_formula(inside, matrix);
	} else {
		status = image_size(reader, size, fault);
		if (!status && !matrix_of_world(&world, size, matrix))
			*problem = "georeferenced, its image's size is not "
				   "known";
	}
	if (!status && !*problem && !is_finite(matrix))
		*problem = "its georeference maps it nowhere";
	return status;
}

enum tcs_status
georeference_apply(struct gml_reader *reader, struct tcs_fault *fault)
{
	struct raw_object *raw = reader->raw;
	struct raw_texmatrix matrix;
	const char *problem;
	enum tcs_status status;

	if (gml_out_of_turn(reader))
		return TCS_OK;
	status = georeference_find(reader, &matrix, &problem, fault);
	if (status)
		return status;
	if (problem) {
		raw->paints.count = reader->first_paint;
		return gml_skipped(reader, "texture", problem,
			reader->texture.uri.at, fault);
	}
	if (array_grow(&raw->texmatrices, 1))
		return fault_memory(fault);
	for (size_t i = reader->first_paint; i < raw->paints.count; i++) {
		raw->paints.at[i].mapping = MAPPING_MATRIX;
		raw->paints.at[i].matrix = (uint32_t)raw->texmatrices.count;
	}
	raw->texmatrices.at[raw->texmatrices.count++] = matrix;
	return TCS_OK;
}
