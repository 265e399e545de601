#include "ifc_curved_face.h"

#include <math.h>

#include "ifc_domain.h"
#include "ifc_edge.h"
#include "ifc_unrolled.h"
#include "solid_points.h"

enum { BOUNDS, SURFACE, SENSE };

enum { LOOP, ORIENTATION };

/* The loops of a face, unrolled. */
static enum ifc_outcome
bounds_unroll(struct ifc_shaper *shaper, uint32_t face,
	const struct ifc_surface *surface, struct ifc_unrolled *out)
{
	const struct ifc_file *file = shaper->file;
	struct step_value bounds = ifc_value(file, face, BOUNDS), item;
	struct ifc_points points = {.count = 0};
	enum ifc_outcome outcome = IFC_SHAPED;

	while (!outcome && bounds.kind == STEP_LIST &&
		step_next(&bounds.list, &item) > STEP_END) {
		uint32_t bound = step_target(file->step, &item);
		struct step_value orientation =
			ifc_value(file, bound, ORIENTATION);

		array_clear(&points);
		outcome = ifc_loop_points(
			shaper, ifc_target(file, bound, LOOP), &points);
		if (outcome)
			break;
		if (step_is(&orientation, "F"))
			ifc_ring_reverse(points.at, points.count);
		outcome = ifc_unroll(
			shaper, surface, points.at, points.count, out);
	}
	array_release(&points);
	return outcome;
}

/* Where a surface is straight, all of the face is one step. */
static void
domain_scale(const struct ifc_surface *surface,
	const struct ifc_unrolled *rings, struct ifc_domain *domain)
{
	for (int k = 0; k < 2; k++) {
		double low = HUGE_VAL, high = -HUGE_VAL;

		for (size_t i = 0; i < rings->points.count; i++) {
			low = fmin(low, rings->points.at[i].uv.at[k]);
			high = fmax(high, rings->points.at[i].uv.at[k]);
		}
		domain->scale[k] = surface->step[k] > 0 ? surface->step[k]
			: high > low			? high - low
							: 1;
	}
}

static enum ifc_outcome
domain_make(struct ifc_shaper *shaper, const struct ifc_surface *surface,
	const struct ifc_unrolled *rings, struct ifc_domain *domain,
	bool *turned)
{
	TCS_ARRAY(uint32_t) all = {.count = 0};
	enum ifc_outcome outcome = IFC_SHAPED;

	domain_scale(surface, rings, domain);
	for (size_t i = 0; i < rings->points.count && !outcome; i++)
		outcome = ifc_domain_add(shaper, surface, domain,
			rings->points.at[i].at, rings->points.at[i].uv);
	if (!outcome && array_grow(&all, rings->rings.count + 1))
		outcome = IFC_NO_MEMORY;
	for (size_t i = 0; i < rings->rings.count && !outcome; i++)
		all.at[all.count++] = rings->rings.at[i].count;
	if (!outcome)
		outcome = ifc_domain_triangulate(
			shaper, surface, domain, all.at, all.count, turned);
	array_release(&all);
	return outcome;
}

static bool
is_same(struct tcs_point a, struct tcs_point b)
{
	return a.x == b.x && a.y == b.y && a.z == b.z;
}

/* The triangles, without those that a pinch has made an edge. */
static enum ifc_outcome
domain_faces(struct ifc_shaper *shaper, const struct ifc_domain *domain,
	bool turned, struct ifc_faces *out)
{
	enum ifc_outcome outcome = IFC_SHAPED;

	for (size_t i = 0; i < domain->triangles.count && !outcome; i++) {
		const uint32_t *corners = domain->triangles.at[i].corners;
		struct tcs_point a = domain->points.at[corners[0]].at;
		struct tcs_point b = domain->points.at[corners[1]].at;
		struct tcs_point c = domain->points.at[corners[2]].at;

		if (is_same(a, b) || is_same(b, c) || is_same(c, a))
			continue;
		outcome = ifc_points_room(shaper, &out->points, 3);
		if (outcome)
			break;
		out->points.at[out->points.count++] = a;
		out->points.at[out->points.count++] = turned ? c : b;
		out->points.at[out->points.count++] = turned ? b : c;
		outcome = ifc_ring_end(shaper, out, NULL);
		if (!outcome)
			outcome = ifc_face_end(shaper, out);
	}
	return outcome;
}

static enum ifc_outcome
face_on(struct ifc_shaper *shaper, uint32_t face,
	const struct ifc_surface *surface, struct ifc_faces *out)
{
	struct step_value sense = ifc_value(shaper->file, face, SENSE);
	struct ifc_unrolled rings = {.points = {.count = 0}};
	struct ifc_domain domain = {.points = {.count = 0}};
	bool forwards = !step_is(&sense, "F"), bare, turned = false;
	enum ifc_outcome outcome = bounds_unroll(shaper, face, surface, &rings);

	bare = !rings.rings.count;
	if (!outcome)
		outcome = ifc_unrolled_close(shaper, surface, forwards, &rings);
	if (!outcome)
		outcome =
			domain_make(shaper, surface, &rings, &domain, &turned);
	if (!outcome)
		outcome = ifc_domain_refine(shaper, surface, &domain);
	if (!outcome)
		outcome = domain_faces(
			shaper, &domain, bare ? !forwards : turned, out);
	ifc_unrolled_release(&rings);
	ifc_domain_release(&domain);
	return outcome;
}

/* The points of the first loop of a face. */
static enum ifc_outcome
first_loop(struct ifc_shaper *shaper, uint32_t face, struct ifc_points *out)
{
	const struct ifc_file *file = shaper->file;
	struct step_value bounds = ifc_value(file, face, BOUNDS), item;

	if (bounds.kind != STEP_LIST ||
		step_next(&bounds.list, &item) <= STEP_END)
		return IFC_SHAPED;
	return ifc_loop_points(shaper,
		ifc_target(file, step_target(file->step, &item), LOOP), out);
}

static double
farthest_off(const struct ifc_surface *surface, const struct ifc_points *points)
{
	double off = 0;

	for (size_t i = 0; i < points->count; i++) {
		struct tcs_point at;
		struct ifc_uv uv;

		(void)ifc_surface_locate(surface, points->at[i], NULL, &uv);
		at = point_minus(ifc_surface_at(surface, uv), points->at[i]);
		off = fmax(off, sqrt(point_dot(at, at)));
	}
	return off;
}

/* The surface of a face; a swept one as its first loop fits better. */
static enum ifc_outcome
surface_read(struct ifc_shaper *shaper, uint32_t face, struct ifc_surface *out)
{
	uint32_t surface = ifc_target(shaper->file, face, SURFACE);
	struct ifc_surface other = {.radius = 0};
	struct ifc_points points = {.count = 0};
	double off;
	enum ifc_outcome outcome = ifc_surface_read(shaper, surface, true, out);

	if (outcome || !out->curve.count)
		return outcome;
	outcome = first_loop(shaper, face, &points);
	off = farthest_off(out, &points);
	if (!outcome && off > 2 * shaper->deflection)
		outcome = ifc_surface_read(shaper, surface, false, &other);
	if (!outcome && other.curve.count &&
		farthest_off(&other, &points) < off) {
		struct ifc_surface swap = *out;

		*out = other;
		other = swap;
	}
	ifc_surface_release(&other);
	array_release(&points);
	return outcome;
}

enum ifc_outcome
ifc_curved_face(struct ifc_shaper *shaper, uint32_t face, struct ifc_faces *out)
{
	struct ifc_surface surface;
	enum ifc_outcome outcome = surface_read(shaper, face, &surface);

	if (!outcome)
		outcome = face_on(shaper, face, &surface, out);
	ifc_surface_release(&surface);
	if (outcome == IFC_REFUSED && shaper->culprit == STEP_NONE)
		shaper->culprit = face;
	return outcome;
}
