#include "citygml_head.h"

#include <math.h>
#include <string.h>

#include "citygml_numbers.h"

static enum tcs_status
head_append(struct tcs_head *head, const char *text, tcs_text *out,
	struct tcs_fault *fault)
{
	return text_append(head, text, text ? strlen(text) : 0, out, fault);
}

/* ---- where the data lies ------------------------------------------------------- */

/* The text of the first ring of the object that is in no template. */
static const struct raw_ring *
first_ring(const struct raw_object *raw)
{
	for (size_t i = 0; raw && i < raw->polygons.count; i++) {
		const struct raw_polygon *polygon = &raw->polygons.at[i];

		if (polygon->ring_count &&
			!raw->geometries.at[polygon->geometry].is_template)
			return &raw->rings.at[polygon->first_ring];
	}
	return NULL;
}

/* The first position of an object, as written: of a ring or an instance. */
static bool
first_position(const struct raw_object *raw, double out[3])
{
	const struct raw_ring *ring = first_ring(raw);
	int count = 0;

	out[2] = 0;
	if (ring)
		count = numbers_first(
			raw->positions.at + ring->first, ring->length, out, 3);
	else if (raw && raw->instances.count &&
		raw->instances.at[0].has_anchor) {
		memcpy(out, raw->instances.at[0].anchor, 3 * sizeof *out);
		count = 3;
	}
	for (int i = 0; i < count; i++)
		if (!isfinite(out[i]))
			return false;
	return count >= 2;
}

static struct tcs_point
point_of(const double position[3], bool north_first)
{
	return (struct tcs_point){
		position[north_first], position[!north_first], position[2]};
}

static bool
in_order(const double lower[3], const double upper[3])
{
	for (int i = 0; i < 3; i++)
		if (!isfinite(lower[i]) || !isfinite(upper[i]) ||
			lower[i] > upper[i])
			return false;
	return true;
}

/* Whole metres, or a ten-thousandth of a degree, near the data. */
static struct tcs_point
origin_near(struct tcs_point point, enum tcs_crs_kind kind)
{
	double step = kind == TCS_CRS_GEOGRAPHIC ? 1e4 : 1;

	return (struct tcs_point){floor(point.x * step) / step,
		floor(point.y * step) / step, floor(point.z)};
}

static void
crs_set_place(struct tcs_crs *crs, const struct gml_reader *reader,
	const struct raw_object *first, bool north_first)
{
	bool bounded = reader->has_corner[0] && reader->has_corner[1] &&
		in_order(reader->corner[0], reader->corner[1]);
	double position[3];

	if (bounded) {
		crs->flags |= TCS_HAS_BOUNDS;
		crs->lower = point_of(reader->corner[0], north_first);
		crs->upper = point_of(reader->corner[1], north_first);
	}
	if (first_position(first, position)) {
		crs->flags |= TCS_HAS_ORIGIN;
		crs->origin =
			origin_near(point_of(position, north_first), crs->kind);
	} else if (bounded) {
		crs->flags |= TCS_HAS_ORIGIN;
		crs->origin = origin_near(crs->lower, crs->kind);
	}
}

/* ---- which system ---------------------------------------------------------------- */

static enum tcs_status
crs_set_system(struct tcs_head *head, struct tcs_crs *crs,
	struct gml_srs *system, struct gml_reader *reader,
	struct tcs_fault *fault)
{
	const char *texts[2] = {system->srs.assumed, system->assumed};
	enum tcs_status status;
	char assumed[400] = "";

	crs->metres_per_unit = system->srs.metres_per_unit;
	crs->metres_per_unit_up = system->srs.metres_per_unit_up;
	crs->epsg = system->srs.epsg;
	crs->epsg_up = system->srs.epsg_up;
	crs->kind = system->srs.kind;
	if (system->north_first)
		crs->flags |= TCS_CRS_NORTH_FIRST;
	for (int i = 0; i < 2; i++) {
		if (!texts[i] || !*texts[i])
			continue;
		if (*assumed)
			strncat(assumed, "; ",
				sizeof assumed - strlen(assumed) - 1);
		strncat(assumed, texts[i],
			sizeof assumed - strlen(assumed) - 1);
	}
	if (*assumed)
		crs->flags |= TCS_CRS_ASSUMED;
	status = head_append(head, system->name, &crs->name, fault);
	if (!status)
		status = head_append(head, assumed, &crs->assumed, fault);
	if (!status && *assumed)
		status = report_item(&reader->report, REPORT_NOTE,
			"coordinate system",
			"assumptions were made about it; the head says which",
			system->name, TCS_NOWHERE, fault);
	return status;
}

static enum tcs_status
crs_set_unknown(
	struct tcs_head *head, struct tcs_crs *crs, struct tcs_fault *fault)
{
	crs->kind = TCS_CRS_UNKNOWN;
	crs->metres_per_unit = crs->metres_per_unit_up = 1;
	crs->flags = TCS_CRS_ASSUMED;
	return head_append(head,
		"no srsName: taken as a plane in metres, easting first",
		&crs->assumed, fault);
}

/* The model's system, unless only the geometry names one. */
static enum tcs_status
head_set_crs(struct tcs_head *head, struct gml_reader *reader,
	const struct raw_object *first, struct tcs_fault *fault)
{
	uint32_t index = reader->first_srs != TCS_NONE ? reader->first_srs
						       : reader->model_srs;
	struct tcs_crs crs = {0};
	enum tcs_status status;
	bool north_first = false;

	if (array_grow(&head->crs, 1))
		return fault_memory(fault);
	if (index == TCS_NONE) {
		status = crs_set_unknown(head, &crs, fault);
	} else {
		if (first_ring(first))
			gml_north_first(reader, index,
				first->positions.at + first_ring(first)->first,
				first_ring(first)->length);
		north_first = reader->systems.at[index].north_first;
		status = crs_set_system(
			head, &crs, &reader->systems.at[index], reader, fault);
	}
	crs_set_place(&crs, reader, first, north_first);
	head->crs.at[head->crs.count++] = crs;
	return status;
}

/* ---- where it comes from ------------------------------------------------------------ */

static enum tcs_status
head_set_source(struct tcs_head *head, const struct gml_reader *reader,
	const struct command *command, struct tcs_fault *fault)
{
	const char *version = reader->names.spelled;
	const char *name = command->input ? command->input : "";
	const char *slash = strrchr(name, '/');
	char format[32] = "CityGML";
	struct tcs_source *source;
	enum tcs_status status;

	if (version) {
		strcat(format, " ");
		strncat(format, version, 8);
	}
	if (array_grow(&head->sources, 1))
		return fault_memory(fault);
	source = &head->sources.at[head->sources.count++];
	*source = (struct tcs_source){0};
	status = head_append(head, format, &source->format, fault);
	if (!status)
		status = head_append(
			head, slash ? slash + 1 : name, &source->name, fault);
	return status;
}

/* A model that says nothing of itself is not listed. */
static enum tcs_status
head_set_model(struct tcs_head *head, const struct gml_reader *reader,
	struct tcs_fault *fault)
{
	struct tcs_model model = {0};
	const struct {
		const struct kept_text *from;
		tcs_text *to;
	} texts[] = {
		{&reader->model_id, &model.id},
		{&reader->model_name, &model.name},
		{&reader->model_description, &model.description},
	};
	enum tcs_status status = TCS_OK;

	for (size_t i = 0; !status && i < sizeof texts / sizeof *texts; i++)
		status = text_append(head, texts[i].from->at,
			texts[i].from->count, texts[i].to, fault);
	if (status || !(model.id || model.name || model.description))
		return status;
	if (array_grow(&head->models, 1))
		return fault_memory(fault);
	head->models.at[head->models.count++] = model;
	return TCS_OK;
}

enum tcs_status
head_build(struct tcs_head *head, struct gml_reader *reader,
	const struct raw_object *first, const struct command *command,
	struct tcs_fault *fault)
{
	enum tcs_status status;

	status = head_set_crs(head, reader, first, fault);
	if (!status)
		status = head_set_source(head, reader, command, fault);
	if (!status)
		status = head_set_model(head, reader, fault);
	if (!status)
		status = head_sign(head, command->program->name,
			TESSERA_VERSION, command->arguments, fault);
	return status;
}
