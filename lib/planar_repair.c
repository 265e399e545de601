#include "planar_repair.h"

#include <GL/glu.h>

struct repair {
	struct planar *polygon;
	const struct tcs_point *vertices;
	size_t vertex_count; /* without the extra ones */
	struct triangle_list *out;
	struct planar_rings *rings; /* in its stead, for outlines */
	struct point_list *extra;
	struct tcs_triangle corners; /* of the triangle that arrives */
	unsigned corner_count;
	bool no_memory;
	bool unsound;
};

/* GLU carries a vertex as a pointer, and NULL is none: its number plus one. */
static void *
handle_of(size_t vertex)
{
	return (void *)(uintptr_t)(vertex + 1);
}

static uint32_t
vertex_of(const void *handle)
{
	return (uint32_t)((uintptr_t)handle - 1);
}

static void GLAPIENTRY
on_vertex(void *handle, void *context)
{
	struct repair *repair = context;

	repair->corners.corner[repair->corner_count++] = vertex_of(handle);
	if (repair->corner_count < 3)
		return;
	repair->corner_count = 0;
	if (array_grow(repair->out, 1)) {
		repair->no_memory = true;
		return;
	}
	repair->out->at[repair->out->count++] = repair->corners;
}

static void GLAPIENTRY
on_ring_vertex(void *handle, void *context)
{
	struct repair *repair = context;
	struct planar_rings *rings = repair->rings;

	if (array_grow(&rings->vertices, 1))
		repair->no_memory = true;
	else
		rings->vertices.at[rings->vertices.count++] = vertex_of(handle);
}

static void GLAPIENTRY
on_ring_end(void *context)
{
	struct repair *repair = context;
	struct planar_rings *rings = repair->rings;

	if (array_grow(&rings->ends, 1))
		repair->no_memory = true;
	else
		rings->ends.at[rings->ends.count++] =
			(uint32_t)rings->vertices.count;
}

/* A callback for edge flags makes GLU give separate triangles. */
static void GLAPIENTRY
on_edge_flag(GLboolean flag, void *context)
{
	(void)flag;
	(void)context;
}

static struct tcs_point
position_of(const struct repair *repair, uint32_t vertex)
{
	if (vertex < repair->vertex_count)
		return repair->vertices[vertex];
	return repair->extra->at[vertex - repair->vertex_count];
}

/*
 * The point of the plane, and off it as far as its sources are on average:
 * GLU's weights are floats, too coarse for more.
 */
static struct tcs_point
position_at(const struct repair *repair, struct planar_point at,
	void *const handles[4], const GLfloat weights[4])
{
	const struct planar *polygon = repair->polygon;
	double off = 0;

	for (int i = 0; i < 4 && handles[i]; i++) {
		uint32_t vertex = vertex_of(handles[i]);

		off += (double)weights[i] *
			planar_height(&polygon->plane,
				polygon->points.at[vertex],
				position_of(repair, vertex));
	}
	return planar_lift(&polygon->plane, at, off);
}

/*
 * Where the edges from a to b and from c to d cross. GLU knows, but tells no
 * more than its weights say.
 */
static struct planar_point
crossing(struct planar_point a, struct planar_point b, struct planar_point c,
	struct planar_point d)
{
	double up = planar_orient(c, d, a);
	double down = planar_orient(c, d, b);
	double t = up == down ? 0 : up / (up - down);

	t = fmax(0, fmin(1, t));
	return (struct planar_point){
		a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

/* Two vertices coincide, or two edges cross. */
static void GLAPIENTRY
on_combine(GLdouble place[3], void *handles[4], GLfloat weights[4],
	void **result, void *context)
{
	struct repair *repair = context;
	struct planar *polygon = repair->polygon;
	struct planar_point ends[4], at;

	(void)place;
	*result = handles[0];
	if (!handles[2] || !handles[3]) {
		if (handles[1] && vertex_of(handles[1]) < vertex_of(*result))
			*result = handles[1];
		return;
	}
	for (int i = 0; i < 4; i++)
		ends[i] = polygon->points.at[vertex_of(handles[i])];
	at = crossing(ends[0], ends[1], ends[2], ends[3]);
	for (int i = 0; i < 4; i++) {
		if (ends[i].x == at.x && ends[i].y == at.y) {
			*result = handles[i];
			return;
		}
	}
	if (array_grow(repair->extra, 1) || array_grow(&polygon->points, 1)) {
		repair->no_memory = true;
		return;
	}
	*result = handle_of(polygon->points.count);
	repair->extra->at[repair->extra->count++] =
		position_at(repair, at, handles, weights);
	polygon->points.at[polygon->points.count++] = at;
}

static void GLAPIENTRY
on_error(GLenum error, void *context)
{
	struct repair *repair = context;

	if (error == GLU_OUT_OF_MEMORY)
		repair->no_memory = true;
	else
		repair->unsound = true;
}

/* To a multiple of the grid, which is a power of two; 0 is none. */
static double
snap(double value, double grid)
{
	return grid > 0 ? rint(value / grid) * grid : value;
}

static void
tessellate(struct repair *repair, double grid, GLUtesselator *tessellator)
{
	const struct planar *polygon = repair->polygon;

	gluTessProperty(
		tessellator, GLU_TESS_WINDING_RULE, GLU_TESS_WINDING_ODD);
	gluTessNormal(tessellator, 0, 0, 1);
	if (repair->rings) {
		gluTessProperty(tessellator, GLU_TESS_BOUNDARY_ONLY, GL_TRUE);
		gluTessCallback(tessellator, GLU_TESS_VERTEX_DATA,
			(_GLUfuncptr)on_ring_vertex);
		gluTessCallback(tessellator, GLU_TESS_END_DATA,
			(_GLUfuncptr)on_ring_end);
	} else {
		gluTessCallback(tessellator, GLU_TESS_VERTEX_DATA,
			(_GLUfuncptr)on_vertex);
		gluTessCallback(tessellator, GLU_TESS_EDGE_FLAG_DATA,
			(_GLUfuncptr)on_edge_flag);
	}
	gluTessCallback(
		tessellator, GLU_TESS_COMBINE_DATA, (_GLUfuncptr)on_combine);
	gluTessCallback(
		tessellator, GLU_TESS_ERROR_DATA, (_GLUfuncptr)on_error);
	gluTessBeginPolygon(tessellator, repair);
	for (size_t i = 0; i < polygon->firsts.count; i++) {
		uint32_t vertex = polygon->firsts.at[i];

		gluTessBeginContour(tessellator);
		do {
			struct planar_point at = polygon->points.at[vertex];
			GLdouble place[3] = {
				snap(at.x, grid), snap(at.y, grid), 0};

			gluTessVertex(tessellator, place, handle_of(vertex));
			vertex = polygon->next.at[vertex];
		} while (vertex != polygon->firsts.at[i]);
		gluTessEndContour(tessellator);
	}
	gluTessEndPolygon(tessellator);
}

/*
 * Drop the triangles without area. Inverted ones no larger than the grid and
 * GLU's rounding go with them.
 */
static void
triangles_check(struct repair *repair, size_t first)
{
	const struct planar_point *points = repair->polygon->points.at;
	double extent = repair->polygon->extent;
	size_t kept = first;

	for (size_t i = first; i < repair->out->count; i++) {
		struct tcs_triangle one = repair->out->at[i];
		double area = planar_orient(points[one.corner[0]],
			points[one.corner[1]], points[one.corner[2]]);

		if (area > 0)
			repair->out->at[kept++] = one;
		else if (area < -1e-9 * extent * extent)
			repair->unsound = true;
	}
	repair->out->count = kept;
}

enum tcs_status
planar_repair(struct planar *polygon, const struct tcs_point *vertices,
	double grid, struct triangle_list *out, struct point_list *extra,
	bool *sound, struct tcs_fault *fault)
{
	struct repair repair = {.polygon = polygon,
		.vertices = vertices,
		.vertex_count = polygon->points.count,
		.out = out,
		.extra = extra};
	GLUtesselator *tessellator = gluNewTess();
	size_t first = out->count;

	if (!tessellator)
		return fault_memory(fault);
	tessellate(&repair, grid, tessellator);
	gluDeleteTess(tessellator);
	if (repair.no_memory)
		return fault_memory(fault);
	triangles_check(&repair, first);
	*sound = !repair.unsound;
	return TCS_OK;
}

enum tcs_status
planar_outline(struct planar *polygon, const struct tcs_point *vertices,
	double grid, struct planar_rings *out, struct point_list *extra,
	bool *sound, struct tcs_fault *fault)
{
	struct repair repair = {.polygon = polygon,
		.vertices = vertices,
		.vertex_count = polygon->points.count,
		.rings = out,
		.extra = extra};
	GLUtesselator *tessellator = gluNewTess();

	if (!tessellator)
		return fault_memory(fault);
	tessellate(&repair, grid, tessellator);
	gluDeleteTess(tessellator);
	*sound = !repair.unsound;
	return repair.no_memory ? fault_memory(fault) : TCS_OK;
}

void
planar_rings_release(struct planar_rings *rings)
{
	array_release(&rings->vertices);
	array_release(&rings->ends);
}
