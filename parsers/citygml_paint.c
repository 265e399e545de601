/*
 * Paints: from what themes name to the polygons they colour, and texture
 * coordinates for the vertices of these.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "citygml_build.h"
#include "citygml_numbers.h"

/* ---- which polygon has which paint -------------------------------------------- */

static enum tcs_status
paint_target(struct builder *builder, const struct raw_object *raw,
	const struct raw_target *target, size_t paint, struct tcs_fault *fault)
{
	for (uint32_t i = target->first_member; i < target->member_end; i++) {
		uint32_t polygon = raw->members.at[i].polygon;

		if (polygon == TCS_NONE)
			continue;
		if (array_grow(&builder->paints, 1))
			return fault_memory(fault);
		builder->paints.at[builder->paints.count++] =
			(struct build_paint){polygon, (uint32_t)paint};
	}
	return TCS_OK;
}

static int
compare_paints(const void *a, const void *b)
{
	const struct build_paint *one = a, *two = b;

	if (one->polygon != two->polygon)
		return one->polygon < two->polygon ? -1 : 1;
	return one->paint < two->paint ? -1 : one->paint > two->paint;
}

/* A target may be large, and be named again and again. */
static bool
too_many(const struct builder *builder, const struct raw_object *raw)
{
	return builder->paints.count / MOST_THEMES >
		raw->polygons.count + raw->paints.count;
}

enum tcs_status
paints_collect(struct builder *builder, const struct raw_object *raw,
	struct report *report, struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	array_clear(&builder->paints);
	for (size_t i = 0; !status && i < raw->paints.count; i++) {
		const char *id =
			object_text(&raw->tree, raw->paints.at[i].target);
		const struct raw_target *target =
			index_find(&builder->links.targets, raw, id);

		if (target && !too_many(builder, raw))
			status = paint_target(builder, raw, target, i, fault);
		else if (target && report)
			status = report_item(report, REPORT_SKIPPED, "paint",
				"the feature is painted over 64 times", id,
				TCS_NOWHERE, fault);
		else if (report)
			status = report_item(report, REPORT_SKIPPED, "paint",
				"its target is not in the feature", id,
				TCS_NOWHERE, fault);
	}
	if (!status && builder->paints.count)
		qsort(builder->paints.at, builder->paints.count,
			sizeof *builder->paints.at, compare_paints);
	return status;
}

/* ---- texture coordinates ---------------------------------------------------------- */

static const struct raw_texring *
texring_find(const struct raw_object *raw, const struct raw_paint *paint,
	const char *id)
{
	for (uint32_t i = 0; *id && i < paint->ring_count; i++) {
		const struct raw_texring *ring =
			&raw->texrings.at[paint->first_ring + i];

		if (!strcmp(object_text(&raw->tree, ring->ring), id))
			return ring;
	}
	return NULL;
}

/* A closed ring repeats its first coordinate, or does not. */
static const char *
texring_read(struct builder *builder, const struct raw_object *raw,
	const struct raw_texring *ring, size_t vertices,
	struct tcs_texcoord *out)
{
	size_t want = 2 * (vertices + 1);
	struct tcs_fault fault;
	size_t count;
	bool bad;

	if (!ring)
		return "a ring has no texture coordinates";
	if (numbers_read(&builder->texcoords, raw->positions.at + ring->first,
		    ring->length, &bad, &fault))
		return "out of memory";
	count = builder->texcoords.count;
	if (bad || (count != want && count != want - 2))
		return "its texture coordinates do not fit its rings";
	for (size_t i = 0; i < vertices; i++)
		out[i] = (struct tcs_texcoord){builder->texcoords.at[2 * i],
			builder->texcoords.at[2 * i + 1]};
	return NULL;
}

static const char *
texcoords_of_list(struct builder *builder, const struct raw_object *raw,
	const struct raw_paint *paint, struct tcs_texcoord *out)
{
	for (size_t i = 0; i < builder->ring_sizes.count; i++) {
		const char *id =
			object_text(&raw->tree, builder->ring_ids.at[i]);
		const char *problem =
			texring_read(builder, raw, texring_find(raw, paint, id),
				builder->ring_sizes.at[i], out);

		if (problem)
			return problem;
		out += builder->ring_sizes.at[i];
	}
	return NULL;
}

static const char *
texcoords_of_order(struct builder *builder, const struct raw_object *raw,
	const struct raw_paint *paint, uint32_t raw_polygon,
	struct tcs_texcoord *out)
{
	uint32_t before = raw->polygons.at[raw_polygon].first_ring -
		raw->polygons.at[paint->first_polygon].first_ring;

	for (size_t i = 0; i < builder->ring_sizes.count; i++) {
		uint32_t place = before + builder->ring_places.at[i];
		const char *problem = texring_read(builder, raw,
			place < paint->ring_count
				? &raw->texrings.at[paint->first_ring + place]
				: NULL,
			builder->ring_sizes.at[i], out);

		if (problem)
			return problem;
		out += builder->ring_sizes.at[i];
	}
	return NULL;
}

/* `written_north`: the file writes northing first. */
static const char *
texcoords_of_matrix(const struct builder *builder,
	const struct raw_texmatrix *matrix, bool written_north,
	struct tcs_texcoord *out)
{
	bool swap = written_north && !matrix->east_first;
	const double *m = matrix->at;

	for (size_t i = 0; i < builder->points.count; i++) {
		const struct tcs_point *p = &builder->points.at[i];
		double x = swap ? p->y : p->x, y = swap ? p->x : p->y;
		double q = m[8] * x + m[9] * y + m[10] * p->z + m[11];

		out[i].s = (m[0] * x + m[1] * y + m[2] * p->z + m[3]) / q;
		out[i].t = (m[4] * x + m[5] * y + m[6] * p->z + m[7]) / q;
		if (!isfinite(out[i].s) || !isfinite(out[i].t))
			return "its texture matrix maps it nowhere";
	}
	return NULL;
}

static struct tcs_point
difference(struct tcs_point a, struct tcs_point b)
{
	return (struct tcs_point){a.x - b.x, a.y - b.y, a.z - b.z};
}

static double
dot(struct tcs_point a, struct tcs_point b)
{
	return a.x * b.x + a.y * b.y + a.z * b.z;
}

/*
 * A vertex that a repair added lies in the polygon's plane: its coordinates
 * follow from the map that three of the ring's vertices, far apart, define.
 */
static void
texcoords_extend(
	const struct builder *builder, size_t given, struct tcs_texcoord *out)
{
	const struct tcs_point *points = builder->points.at;
	size_t one = 0, two = 0;
	double best = 0, uu, uv, vv, det;
	struct tcs_point u, v;

	for (size_t i = 1; i < given; i++) {
		u = difference(points[i], points[0]);
		if (dot(u, u) > best) {
			best = dot(u, u);
			one = i;
		}
	}
	u = difference(points[one], points[0]);
	best = 0;
	for (size_t i = 1; i < given; i++) {
		v = difference(points[i], points[0]);
		det = dot(u, u) * dot(v, v) - dot(u, v) * dot(u, v);
		if (det > best) {
			best = det;
			two = i;
		}
	}
	v = difference(points[two], points[0]);
	uu = dot(u, u), uv = dot(u, v), vv = dot(v, v);
	det = uu * vv - uv * uv;
	for (size_t i = given; i < builder->points.count; i++) {
		struct tcs_point w = difference(points[i], points[0]);
		double a = 0, b = 0;

		if (det > 0) {
			a = (dot(w, u) * vv - dot(w, v) * uv) / det;
			b = (dot(w, v) * uu - dot(w, u) * uv) / det;
		}
		out[i].s = out[0].s + a * (out[one].s - out[0].s) +
			b * (out[two].s - out[0].s);
		out[i].t = out[0].t + a * (out[one].t - out[0].t) +
			b * (out[two].t - out[0].t);
	}
}

/* One coordinate for every vertex of the polygon; what is wrong, or NULL. */
static const char *
texcoords_find(struct builder *builder, const struct raw_object *raw,
	const struct raw_paint *paint, uint32_t raw_polygon,
	struct tcs_texcoord *out)
{
	const char *problem = "its texture has no coordinates of its own";
	size_t given = 0;

	for (size_t i = 0; i < builder->ring_sizes.count; i++)
		given += builder->ring_sizes.at[i];
	if (paint->mapping == MAPPING_MATRIX)
		return texcoords_of_matrix(builder,
			&raw->texmatrices.at[paint->matrix],
			raw->polygons.at[raw_polygon].swap, out);
	if (paint->mapping == MAPPING_LIST)
		problem = texcoords_of_list(builder, raw, paint, out);
	if (paint->mapping == MAPPING_ORDER)
		problem = texcoords_of_order(
			builder, raw, paint, raw_polygon, out);
	if (!problem)
		texcoords_extend(builder, given, out);
	return problem;
}

/* ---- paints of one polygon -------------------------------------------------------------- */

static size_t
first_paint(const struct builder *builder, uint32_t raw_polygon)
{
	size_t low = 0, high = builder->paints.count;

	while (low < high) {
		size_t middle = low + (high - low) / 2;

		if (builder->paints.at[middle].polygon < raw_polygon)
			low = middle + 1;
		else
			high = middle;
	}
	return low;
}

/* A material and a texture of one theme on one side are one paint. */
static bool
paint_joins(const struct tcs_object *out, const struct tcs_paint *last,
	const struct tcs_paint *paint)
{
	return last->polygon == paint->polygon && last->flags == paint->flags &&
		(last->material == TCS_NONE) == (paint->image == TCS_NONE) &&
		(last->image == TCS_NONE) == (paint->material == TCS_NONE) &&
		!strcmp(object_text(out, last->theme),
			object_text(out, paint->theme));
}

enum { MOST_JOINED = 64 }; /* paints of the polygon that are looked at */

/* The paint of the polygon that this one completes, or NULL. */
static struct tcs_paint *
paint_partner(struct tcs_object *out, const struct tcs_paint *paint)
{
	for (size_t i = out->paints.count, left = MOST_JOINED; i > 0 && left;
		i--, left--) {
		struct tcs_paint *other = &out->paints.at[i - 1];

		if (other->polygon != paint->polygon)
			break;
		if (paint_joins(out, other, paint))
			return other;
	}
	return NULL;
}

/* The coordinates of paints follow each other in the order of the paints. */
static void
partner_take_image(struct tcs_object *out, struct tcs_paint *partner,
	const struct tcs_paint *paint)
{
	struct tcs_paint *end = &out->paints.at[out->paints.count];

	partner->image = paint->image;
	partner->first_texcoord = paint->first_texcoord;
	if (partner + 1 == end)
		return;
	*end = *partner;
	memmove(partner, partner + 1,
		(size_t)(end - partner) * sizeof *partner);
}

static enum tcs_status
paint_append(struct tcs_object *out, const struct tcs_paint *paint,
	struct tcs_fault *fault)
{
	struct tcs_paint *partner;

	if (array_grow(&out->paints, 1))
		return fault_memory(fault);
	partner = paint_partner(out, paint);
	if (!partner)
		out->paints.at[out->paints.count++] = *paint;
	else if (partner->image == TCS_NONE)
		partner_take_image(out, partner, paint);
	else
		partner->material = paint->material;
	return TCS_OK;
}

static enum tcs_status
paint_write(struct builder *builder, const struct raw_object *raw,
	uint32_t raw_polygon, const struct raw_paint *from,
	struct tcs_object *out, struct report *report, struct tcs_fault *fault)
{
	const struct raw_polygon *polygon = &raw->polygons.at[raw_polygon];
	size_t vertices = builder->points.count;
	struct tcs_paint paint = {
		.polygon = (uint32_t)out->polygons.count - 1,
		.material = from->material,
		.image = from->image,
		.first_texcoord = TCS_NONE,
		.flags = from->back ? TCS_PAINT_BACK : 0,
	};
	enum tcs_status status =
		text_carry(out, &raw->tree, from->theme, &paint.theme, fault);
	const char *problem;

	if (status || from->image == TCS_NONE)
		return status ? status : paint_append(out, &paint, fault);
	if (array_grow(&out->texcoords, vertices))
		return fault_memory(fault);
	problem = texcoords_find(builder, raw, from, raw_polygon,
		out->texcoords.at + out->texcoords.count);
	if (problem)
		return raw_report(report, REPORT_SKIPPED, "texture", problem,
			object_text(&raw->tree, polygon->id), polygon->line,
			fault);
	paint.first_texcoord = (uint32_t)out->texcoords.count;
	out->texcoords.count += vertices;
	return paint_append(out, &paint, fault);
}

enum tcs_status
paints_write(struct builder *builder, const struct raw_object *raw,
	uint32_t raw_polygon, struct tcs_object *out, struct report *report,
	struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	for (size_t i = first_paint(builder, raw_polygon);
		!status && i < builder->paints.count &&
		builder->paints.at[i].polygon == raw_polygon;
		i++) {
		const struct raw_paint *paint =
			&raw->paints.at[builder->paints.at[i].paint];

		if (paint->material != TCS_NONE || paint->image != TCS_NONE)
			status = paint_write(builder, raw, raw_polygon, paint,
				out, report, fault);
	}
	return status;
}
