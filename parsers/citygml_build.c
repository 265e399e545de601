#include "citygml_build.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "labels.h"

enum tcs_status
builder_init(struct builder *builder, struct tcs_fault *fault)
{
	*builder = (struct builder){.triangulator = triangulator_new()};
	return builder->triangulator ? TCS_OK : fault_memory(fault);
}

void
builder_release(struct builder *builder)
{
	triangulator_free(builder->triangulator);
	link_work_release(&builder->links);
	array_release(&builder->numbers);
	array_release(&builder->points);
	array_release(&builder->scaled);
	array_release(&builder->ring_sizes);
	array_release(&builder->ring_ids);
	array_release(&builder->ring_places);
	array_release(&builder->paints);
	array_release(&builder->texcoords);
	array_release(&builder->order);
	array_release(&builder->attributes);
}

enum tcs_status
text_carry(struct tcs_object *out, const struct tcs_object *from, tcs_text text,
	tcs_text *to, struct tcs_fault *fault)
{
	const char *string;

	*to = text;
	if (out == from)
		return TCS_OK;
	string = object_text(from, text);
	return text_append(out, string, strlen(string), to, fault);
}

/* What every step of one object needs. */
struct build {
	struct builder *builder;
	const struct build_plan *plan;
	struct raw_object *raw;
	struct tcs_object *out; /* &raw->tree, or a prototype */
	struct report *report; /* &raw->report */
	uint32_t shell, solid; /* of the solid being written: raw numbers */
	bool is_prototype;
	uint64_t polygons, shared, holes, voids;
};

/* ---- one polygon ------------------------------------------------------------------- */

static enum tcs_status
rings_write(struct build *build, const struct raw_use *use, uint32_t vertex,
	struct tcs_fault *fault)
{
	const struct builder *builder = build->builder;
	struct tcs_object *out = build->out;
	enum tcs_status status = TCS_OK;

	if (array_grow(&out->rings, builder->ring_sizes.count))
		return fault_memory(fault);
	for (size_t i = 0; !status && i < builder->ring_sizes.count; i++) {
		struct tcs_ring *ring = &out->rings.at[out->rings.count++];
		tcs_text id = builder->ring_ids.at[i];

		*ring = (struct tcs_ring){
			.id = id,
			.first_vertex = vertex,
			.vertex_count = builder->ring_sizes.at[i],
		};
		vertex += ring->vertex_count;
		status =
			text_carry(out, &use->home->tree, id, &ring->id, fault);
	}
	return status;
}

static enum tcs_status
vertices_write(struct build *build, struct tcs_fault *fault)
{
	const struct builder *builder = build->builder;
	struct tcs_object *out = build->out;
	size_t count = builder->points.count;

	if (out->vertices.count + count >= TCS_NONE)
		return fault_set(fault, TCS_LIMIT, TCS_NOWHERE,
			"an object has more than 4 G vertices");
	if (array_grow(&out->vertices, count))
		return fault_memory(fault);
	memcpy(out->vertices.at + out->vertices.count, builder->points.at,
		count * sizeof *builder->points.at);
	out->vertices.count += count;
	return TCS_OK;
}

static enum tcs_status
triangles_write(struct build *build, const struct triangulation *triangulation,
	uint32_t vertex, bool reversed, struct tcs_fault *fault)
{
	struct tcs_object *out = build->out;
	size_t count = triangulation->triangle_count;

	if (array_grow(&out->triangles, count))
		return fault_memory(fault);
	for (size_t i = 0; i < count; i++) {
		const uint32_t *from = triangulation->triangles[i].corner;
		uint32_t *to = out->triangles.at[out->triangles.count++].corner;

		to[0] = from[0] + vertex;
		to[1] = from[reversed ? 2 : 1] + vertex;
		to[2] = from[reversed ? 1 : 2] + vertex;
	}
	return TCS_OK;
}

static enum tcs_status
polygon_write(struct build *build, const struct raw_use *use,
	const struct triangulation *triangulation, struct tcs_fault *fault)
{
	const struct raw_polygon *from = &use->home->polygons.at[use->polygon];
	const struct builder *builder = build->builder;
	struct tcs_object *out = build->out;
	struct tcs_polygon polygon = {
		.id = from->id,
		.surface = build->is_prototype ? 0 : use->surface,
		.first_vertex = (uint32_t)out->vertices.count,
		.vertex_count = (uint32_t)builder->points.count,
		.first_ring = (uint32_t)out->rings.count,
		.ring_count = (uint32_t)builder->ring_sizes.count,
		.first_triangle = (uint32_t)out->triangles.count,
		.triangle_count = (uint32_t)triangulation->triangle_count,
	};
	enum tcs_status status;

	if (use->reversed)
		polygon.flags |= TCS_POLYGON_REVERSED;
	if (use->shared)
		polygon.flags |= TCS_POLYGON_SHARED;
	if (triangulation->outcome == TRIANGULATION_REPAIRED)
		polygon.flags |= TCS_POLYGON_REPAIRED;
	status =
		text_carry(out, &use->home->tree, from->id, &polygon.id, fault);
	if (!status)
		status = rings_write(build, use, polygon.first_vertex, fault);
	if (!status)
		status = vertices_write(build, fault);
	if (!status)
		status = triangles_write(build, triangulation,
			polygon.first_vertex, use->reversed, fault);
	if (status)
		return status;
	if (array_grow(&out->polygons, 1))
		return fault_memory(fault);
	out->polygons.at[out->polygons.count++] = polygon;
	if (use->home != build->raw)
		return TCS_OK;
	return paints_write(build->builder, build->raw, use->polygon, out,
		build->report, fault);
}

static void
polygon_count(struct build *build, const struct raw_use *use)
{
	if (use->home->polygons.at[use->polygon].shape != RAW_AREA)
		return;
	if (use->shared) {
		build->shared++;
		return;
	}
	build->polygons++;
	build->holes += build->builder->ring_sizes.count - 1;
}

#define FLAT 0.01 /* metres off the plane that pass without a note */

static enum tcs_status
polygon_note(struct build *build, const struct raw_use *use,
	const struct triangulation *triangulation, struct tcs_fault *fault)
{
	const struct raw_polygon *from = &use->home->polygons.at[use->polygon];
	const char *id = object_text(&use->home->tree, from->id);
	enum report_severity severity = REPORT_REPAIRED;
	const char *reason = triangulation->reason;

	if (use->shared || from->shape != RAW_AREA)
		return TCS_OK;
	if (triangulation->outcome == TRIANGULATION_WHOLE) {
		if (triangulation->flatness <= FLAT)
			return TCS_OK;
		severity = REPORT_NOTE;
		reason = "not planar to 1 cm";
	}
	return raw_report(build->report, severity, "polygon", reason, id,
		from->line, fault);
}

/* Write what a use keeps, unless the polygon is beyond use. */
static enum tcs_status
use_write(
	struct build *build, const struct raw_use *use, struct tcs_fault *fault)
{
	const struct raw_polygon *from = &use->home->polygons.at[use->polygon];
	struct triangulation triangulation = {0};
	enum tcs_status status;
	const char *problem;
	const char *id;

	status = rings_read(build->builder, use->home, from, &problem,
		build->report, fault);
	if (!status && !problem) {
		status = polygon_triangulate(
			build->builder, from, &triangulation, fault);
		if (triangulation.outcome == TRIANGULATION_EMPTY)
			problem = triangulation.reason;
	}
	if (status)
		return status;
	if (!problem) {
		polygon_count(build, use);
		status = polygon_note(build, use, &triangulation, fault);
		return status
			? status
			: polygon_write(build, use, &triangulation, fault);
	}
	if (use->shared)
		return TCS_OK;
	id = object_text(&use->home->tree, from->id);
	return raw_report(build->report, REPORT_SKIPPED,
		from->shape == RAW_AREA ? "polygon" : "line", problem, id,
		from->line, fault);
}

/* ---- shells and geometries ------------------------------------------------------------ */

static bool
is_solid_kind(uint8_t kind)
{
	return kind == TCS_SOLID || kind == TCS_MULTI_SOLID ||
		kind == TCS_COMPOSITE_SOLID;
}

/* The shell that a use belongs to, begun when it differs from the last. */
static enum tcs_status
shell_enter(struct build *build, const struct raw_use *use, size_t first_shell,
	struct tcs_fault *fault)
{
	const struct raw_object *raw = build->raw;
	struct tcs_object *out = build->out;
	bool first = out->shells.count == first_shell;
	const struct raw_shell *from =
		use->shell == TCS_NONE ? NULL : &raw->shells.at[use->shell];
	const struct raw_shell *last = first || build->shell == TCS_NONE
		? NULL
		: &raw->shells.at[build->shell];

	if (!first && use->shell == build->shell)
		return TCS_OK;
	if (array_grow(&out->shells, 1))
		return fault_memory(fault);
	if (first)
		build->solid = 0;
	else if (!from || !last || from->geometry != last->geometry ||
		from->solid != last->solid)
		build->solid++;
	build->shell = use->shell;
	out->shells.at[out->shells.count++] = (struct tcs_shell){
		.first_polygon = (uint32_t)out->polygons.count,
		.solid = build->solid,
		.interior = from && from->interior,
	};
	build->voids += from && from->interior;
	if (!from)
		return TCS_OK;
	return text_carry(out, &raw->tree, from->id,
		&out->shells.at[out->shells.count - 1].id, fault);
}

static uint8_t
kind_of(const struct build *build, const struct raw_geometry *geometry,
	enum raw_shape shape, const struct raw_use *first)
{
	if (shape == RAW_LINE)
		return TCS_MULTI_CURVE;
	if (shape == RAW_POINT)
		return TCS_MULTI_POINT;
	if (geometry->kind == RAW_KIND_UNKNOWN)
		return first->shell != TCS_NONE && first->home == build->raw
			? TCS_SOLID
			: TCS_MULTI_SURFACE;
	if (geometry->kind == TCS_MULTI_CURVE ||
		geometry->kind == TCS_MULTI_POINT)
		return TCS_MULTI_SURFACE;
	return geometry->kind;
}

static enum tcs_status
uses_write(struct build *build, uint32_t index, enum raw_shape shape,
	struct tcs_geometry *geometry, struct tcs_fault *fault)
{
	const struct link_work *links = &build->builder->links;
	const struct raw_geometry *from = &build->raw->geometries.at[index];
	struct tcs_object *out = build->out;
	bool begun = false;

	for (uint32_t i = links->first_use.at[index];
		i < links->first_use.at[index + 1]; i++) {
		const struct raw_use *use = &links->uses.at[i];
		size_t before = out->polygons.count;
		enum tcs_status status = TCS_OK;

		if (use->state != USE_KEPT ||
			use->home->polygons.at[use->polygon].shape != shape)
			continue;
		if (!begun)
			geometry->kind = kind_of(build, from, shape, use);
		begun = true;
		if (is_solid_kind(geometry->kind))
			status = shell_enter(
				build, use, geometry->first_shell, fault);
		if (!status)
			status = use_write(build, use, fault);
		array_trim(&build->builder->points);
		array_trim(&build->builder->scaled);
		if (status)
			return status;
		if (is_solid_kind(geometry->kind))
			out->shells.at[out->shells.count - 1].polygon_count +=
				(uint32_t)(out->polygons.count - before);
	}
	return TCS_OK;
}

/* A geometry of areas, of lines and of points becomes one of each. */
static enum tcs_status
geometry_write(struct build *build, uint32_t index, enum raw_shape shape,
	struct tcs_fault *fault)
{
	const struct raw_geometry *from = &build->raw->geometries.at[index];
	struct tcs_object *out = build->out;
	struct tcs_geometry geometry = {
		.feature = build->is_prototype ? 0 : from->feature,
		.first_shell = (uint32_t)out->shells.count,
		.first_polygon = (uint32_t)out->polygons.count,
		.lod = build->builder->links.lods.at[index],
	};
	enum tcs_status status =
		uses_write(build, index, shape, &geometry, fault);

	if (status)
		return status;
	geometry.polygon_count =
		(uint32_t)out->polygons.count - geometry.first_polygon;
	if (!geometry.polygon_count) {
		out->shells.count = geometry.first_shell;
		return TCS_OK;
	}
	geometry.shell_count =
		(uint32_t)out->shells.count - geometry.first_shell;
	if (geometry.kind == TCS_SOLID && build->solid > 0)
		geometry.kind = TCS_MULTI_SOLID;
	status = text_carry(
		out, &build->raw->tree, from->id, &geometry.id, fault);
	if (!status)
		status = text_carry(out, &build->raw->tree, from->role,
			&geometry.role, fault);
	if (status)
		return status;
	if (array_grow(&out->geometries, 1))
		return fault_memory(fault);
	out->geometries.at[out->geometries.count++] = geometry;
	return TCS_OK;
}

/* ---- counts --------------------------------------------------------------------------- */

static const char *const class_counts[] = {
#define CLASS_COUNT(number, label, kind, m2, n2, m3, n3, colour) \
	[number] = "class:" #label,
	TCS_CLASSES(CLASS_COUNT)
#undef CLASS_COUNT
};

static enum tcs_status
count_features(struct build *build, struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	for (size_t i = 0; !status && i < build->out->features.count; i++)
		status = report_add(build->report,
			class_counts[build->out->features.at[i].class], 1,
			fault);
	return status;
}

static enum tcs_status
count_all(struct build *build, struct tcs_fault *fault)
{
	const struct tcs_object *out = build->out;
	const struct {
		const char *name;
		uint64_t count;
	} counts[] = {
		{"objects", 1},
		{"features", out->features.count},
		{"attributes", out->attributes.count},
		{"geometries", out->geometries.count},
		{"polygons", build->polygons},
		{"shared polygons", build->shared},
		{"polygons of other LODs", build->builder->links.left_out},
		{"holes", build->holes},
		{"voids", build->voids},
		{"triangles", out->triangles.count},
		{"instances", out->instances.count},
		{"implicit geometries", build->raw->instances.count},
	};
	enum tcs_status status = TCS_OK;

	for (size_t i = 0; !status && i < sizeof counts / sizeof *counts; i++)
		status = report_add(
			build->report, counts[i].name, counts[i].count, fault);
	return status ? status : count_features(build, fault);
}

/* ---- instances ------------------------------------------------------------------ */

static bool
is_finite(const double *numbers, int count)
{
	for (int i = 0; i < count; i++)
		if (!isfinite(numbers[i]))
			return false;
	return true;
}

static const char *
instance_problem(const struct raw_instance *instance)
{
	if (!instance->has_anchor)
		return "no reference point";
	if (!is_finite(instance->anchor, 3) || !is_finite(instance->matrix, 16))
		return "a coordinate is no finite number";
	return NULL;
}

static enum tcs_status
instance_write(struct build *build, const struct raw_instance *from,
	struct tcs_fault *fault)
{
	struct tcs_object *out = build->out;
	struct tcs_instance *to;

	if (array_grow(&out->instances, 1))
		return fault_memory(fault);
	to = &out->instances.at[out->instances.count++];
	*to = (struct tcs_instance){
		.anchor = {from->anchor[from->swap], from->anchor[!from->swap],
			from->anchor[2]},
		.feature = from->feature,
		.prototype = from->prototype,
		.id = from->id,
		.lod = from->lod,
	};
	memcpy(to->matrix, from->matrix, sizeof to->matrix);
	return TCS_OK;
}

/* A template in a file of its own was reported when it was met. */
static enum tcs_status
instances_write(struct build *build, struct tcs_fault *fault)
{
	const struct raw_object *raw = build->raw;
	enum tcs_status status = TCS_OK;

	for (size_t i = 0; !status && i < raw->instances.count; i++) {
		const struct raw_instance *from = &raw->instances.at[i];
		const char *problem = instance_problem(from);
		const char *id = object_text(&raw->tree, from->id);

		if (build->builder->links.unwanted.at[i])
			continue;
		if (from->prototype == TCS_NONE && from->href)
			problem = "its template is not in the document";
		else if (from->prototype == TCS_NONE)
			continue;
		if (problem)
			status = raw_report(build->report, REPORT_SKIPPED,
				"implicit geometry", problem, id, from->line,
				fault);
		else
			status = instance_write(build, from, fault);
	}
	return status;
}

/* ---- all of it --------------------------------------------------------------------------- */

enum tcs_status
build_object(struct builder *builder, const struct build_plan *plan,
	struct raw_object *raw, struct tcs_fault *fault)
{
	struct build build = {
		.builder = builder,
		.plan = plan,
		.raw = raw,
		.out = &raw->tree,
		.report = &raw->report,
	};
	enum tcs_status status;

	status = links_resolve(&builder->links, raw, plan->library, &plan->lods,
		&raw->report, fault);
	if (!status)
		status = paints_collect(builder, raw, &raw->report, fault);
	for (uint32_t i = 0; !status && i < raw->geometries.count; i++) {
		build.solid = 0;
		status = geometry_write(&build, i, RAW_AREA, fault);
		if (!status)
			status = geometry_write(&build, i, RAW_LINE, fault);
		if (!status)
			status = geometry_write(&build, i, RAW_POINT, fault);
	}
	if (!status)
		status = instances_write(&build, fault);
	if (!status)
		status = attributes_sort(builder, &raw->tree, fault);
	return status ? status : count_all(&build, fault);
}

static enum tcs_status
prototype_begin(const struct raw_object *raw, uint32_t geometry,
	struct tcs_object *out, struct tcs_fault *fault)
{
	object_clear(out);
	if (array_grow(&out->features, 1))
		return fault_memory(fault);
	out->features.at[out->features.count++] = (struct tcs_feature){
		.parent = TCS_NONE, .class = TCS_CLASS_Unknown};
	return text_carry(out, &raw->tree, raw->geometries.at[geometry].id,
		&out->features.at[0].id, fault);
}

enum tcs_status
build_prototype(struct builder *builder, const struct build_plan *plan,
	struct raw_object *raw, uint32_t geometry, struct tcs_object *out,
	struct report *report, struct tcs_fault *fault)
{
	struct build build = {
		.builder = builder,
		.plan = plan,
		.raw = raw,
		.out = out,
		.report = report,
		.is_prototype = true,
	};
	enum tcs_status status;

	status = prototype_begin(raw, geometry, out, fault);
	if (!status)
		status = links_resolve_template(&builder->links, raw,
			plan->library, geometry, report, fault);
	if (!status)
		status = paints_collect(builder, raw, NULL, fault);
	if (!status)
		status = geometry_write(&build, geometry, RAW_AREA, fault);
	if (!status)
		status = geometry_write(&build, geometry, RAW_LINE, fault);
	if (!status)
		status = geometry_write(&build, geometry, RAW_POINT, fault);
	if (!status)
		status = report_add(report, "prototypes", 1, fault);
	if (!status)
		status = report_add(
			report, "prototype polygons", build.polygons, fault);
	return status ? status
		      : report_add(report, "holes", build.holes, fault);
}
