#include "ifc_polygons.h"

#include <math.h>
#include <string.h>

/* One body on its way into an object. */
struct placing {
	struct triangulator *triangulator;
	const struct ifc_body *body;
	const struct ifc_target_feature *target;
	struct tcs_object *out;
	struct report *report;
	bool mirrored;
};

/* ---- one face ------------------------------------------------------------ */

/* The points of a face behind the vertices there are; not counted yet. */
static enum tcs_status
face_place(const struct placing *placing, const struct ifc_face *face,
	size_t count, bool *finite, struct tcs_fault *fault)
{
	const struct ifc_faces *faces = &placing->body->faces;
	const struct tcs_point *points = faces->points.at + face->first_point;
	const uint32_t *rings = faces->rings.at + face->first_ring;
	struct tcs_object *out = placing->out;
	struct tcs_point *at;

	if (array_grow(&out->vertices, count))
		return fault_memory(fault);
	at = out->vertices.at + out->vertices.count;
	for (size_t i = 0; i < count; i++) {
		at[i] = ifc_transform(placing->target->matrix, points[i]);
		if (!isfinite(at[i].x) || !isfinite(at[i].y) ||
			!isfinite(at[i].z))
			*finite = false;
	}
	for (uint32_t i = 0; placing->mirrored && i < face->ring_count; i++) {
		ifc_ring_reverse(at, rings[i]);
		at += rings[i];
	}
	return TCS_OK;
}

static enum tcs_status
face_skip(const struct placing *placing, const char *reason,
	struct tcs_fault *fault)
{
	return report_item(placing->report, REPORT_SKIPPED, "face", reason,
		placing->target->id, TCS_NOWHERE, fault);
}

static enum tcs_status
rings_write(const struct placing *placing, const struct ifc_face *face,
	struct tcs_fault *fault)
{
	const uint32_t *sizes =
		placing->body->faces.rings.at + face->first_ring;
	struct tcs_object *out = placing->out;
	uint32_t first = (uint32_t)out->vertices.count;

	if (array_grow(&out->rings, face->ring_count))
		return fault_memory(fault);
	for (uint32_t i = 0; i < face->ring_count; i++) {
		out->rings.at[out->rings.count++] =
			(struct tcs_ring){0, first, sizes[i]};
		first += sizes[i];
	}
	return TCS_OK;
}

static enum tcs_status
paint_write(
	const struct placing *placing, uint32_t paint, struct tcs_fault *fault)
{
	struct tcs_object *out = placing->out;

	if (!paint)
		return TCS_OK;
	if (array_grow(&out->paints, 1))
		return fault_memory(fault);
	out->paints.at[out->paints.count++] = (struct tcs_paint){
		.polygon = (uint32_t)out->polygons.count - 1,
		.material = paint - 1,
		.image = TCS_NONE,
		.first_texcoord = TCS_NONE,
	};
	return TCS_OK;
}

/* The polygon of a face whose points are placed. */
static enum tcs_status
polygon_write(const struct placing *placing, const struct ifc_face *face,
	size_t count, const struct triangulation *cut, struct tcs_fault *fault)
{
	struct tcs_object *out = placing->out;
	uint32_t first = (uint32_t)out->vertices.count;
	size_t vertices = count + cut->extra_count;

	if (array_grow(&out->polygons, 1) ||
		array_grow(&out->triangles, cut->triangle_count) ||
		array_grow(&out->vertices, vertices))
		return fault_memory(fault);
	out->polygons.at[out->polygons.count++] = (struct tcs_polygon){
		.surface = placing->target->feature,
		.first_vertex = first,
		.vertex_count = (uint32_t)vertices,
		.first_ring = (uint32_t)out->rings.count,
		.ring_count = face->ring_count,
		.first_triangle = (uint32_t)out->triangles.count,
		.triangle_count = (uint32_t)cut->triangle_count,
		.flags = cut->outcome == TRIANGULATION_REPAIRED
			? TCS_POLYGON_REPAIRED
			: 0,
	};
	if (rings_write(placing, face, fault))
		return TCS_NO_MEMORY;
	if (cut->extra_count)
		memcpy(out->vertices.at + first + count, cut->extra,
			cut->extra_count * sizeof *cut->extra);
	out->vertices.count += vertices;
	for (size_t i = 0; i < cut->triangle_count; i++) {
		struct tcs_triangle triangle = cut->triangles[i];

		for (int k = 0; k < 3; k++)
			triangle.corner[k] += first;
		out->triangles.at[out->triangles.count++] = triangle;
	}
	return paint_write(placing, face->paint, fault);
}

static enum tcs_status
face_write(const struct placing *placing, const struct ifc_face *face,
	struct tcs_fault *fault)
{
	const struct ifc_faces *faces = &placing->body->faces;
	struct tcs_object *out = placing->out;
	size_t count = ifc_face_points(faces, face);
	struct triangulation cut;
	enum tcs_status status;
	bool finite = true;

	if (out->vertices.count + count > UINT32_MAX / 2)
		return fault_set(fault, TCS_LIMIT, TCS_NOWHERE,
			"an object has too many vertices");
	status = face_place(placing, face, count, &finite, fault);
	if (!status && !finite)
		return face_skip(placing, "a coordinate is not finite", fault);
	if (!status)
		status = triangulate(placing->triangulator,
			out->vertices.at + out->vertices.count,
			faces->rings.at + face->first_ring, face->ring_count,
			&cut, fault);
	if (!status && cut.outcome == TRIANGULATION_EMPTY)
		return face_skip(placing, cut.reason, fault);
	if (!status && cut.outcome == TRIANGULATION_REPAIRED)
		status = report_item(placing->report, REPORT_REPAIRED, "face",
			cut.reason, placing->target->id, TCS_NOWHERE, fault);
	return status ? status
		      : polygon_write(placing, face, count, &cut, fault);
}

/* ---- geometries ---------------------------------------------------------- */

static enum tcs_status
part_write(const struct placing *placing, size_t part, struct tcs_fault *fault)
{
	const struct ifc_body *body = placing->body;
	size_t end = ifc_part_end(body, part);
	enum tcs_status status = TCS_OK;

	for (size_t i = body->parts.at[part].first_face; i < end && !status;
		i++)
		status = face_write(placing, body->faces.faces.at + i, fault);
	return status;
}

/* A shell of the last geometry; solids count from 1 in *solids. */
static enum tcs_status
shell_write(const struct placing *placing, size_t part, uint32_t *solids,
	struct tcs_fault *fault)
{
	bool is_void = placing->body->parts.at[part].kind == IFC_PART_VOID;
	struct tcs_object *out = placing->out;
	size_t first = out->polygons.count;
	enum tcs_status status = part_write(placing, part, fault);

	if (status || out->polygons.count == first)
		return status;
	if (array_grow(&out->shells, 1))
		return fault_memory(fault);
	if (!is_void || !*solids) {
		++*solids;
		is_void = false;
	}
	out->shells.at[out->shells.count++] = (struct tcs_shell){
		.first_polygon = (uint32_t)first,
		.polygon_count = (uint32_t)(out->polygons.count - first),
		.solid = *solids - 1,
		.interior = is_void,
	};
	return TCS_OK;
}

static enum tcs_status
geometry_write(
	const struct placing *placing, bool solid, struct tcs_fault *fault)
{
	struct tcs_object *out = placing->out;
	struct tcs_geometry geometry = {
		.feature = placing->target->feature,
		.first_shell = (uint32_t)out->shells.count,
		.first_polygon = (uint32_t)out->polygons.count,
		.lod = placing->target->lod,
		.kind = TCS_MULTI_SURFACE,
	};
	enum tcs_status status = TCS_OK;
	uint32_t solids = 0;

	for (size_t i = 0; i < placing->body->parts.count && !status; i++) {
		if ((placing->body->parts.at[i].kind != IFC_PART_SURFACE) !=
			solid)
			continue;
		status = solid ? shell_write(placing, i, &solids, fault)
			       : part_write(placing, i, fault);
	}
	geometry.shell_count =
		(uint32_t)out->shells.count - geometry.first_shell;
	geometry.polygon_count =
		(uint32_t)out->polygons.count - geometry.first_polygon;
	if (solid)
		geometry.kind = solids > 1 ? TCS_MULTI_SOLID : TCS_SOLID;
	if (status || !geometry.polygon_count)
		return status;
	if (array_grow(&out->geometries, 1))
		return fault_memory(fault);
	out->geometries.at[out->geometries.count++] = geometry;
	return TCS_OK;
}

enum tcs_status
ifc_polygons_add(struct triangulator *triangulator, const struct ifc_body *body,
	const struct ifc_target_feature *target, struct tcs_object *out,
	struct report *report, struct tcs_fault *fault)
{
	struct placing placing = {triangulator, body, target, out, report,
		ifc_determinant(target->matrix) < 0};
	enum tcs_status status = geometry_write(&placing, true, fault);

	return status ? status : geometry_write(&placing, false, fault);
}
