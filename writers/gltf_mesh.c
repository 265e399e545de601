#include "gltf_mesh.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Triangles this much smaller than the polygon say nothing of its shape. */
#define SLIVER 1e-4
/* Normals further apart than this (18 degrees) make a polygon bent. */
#define BENT_COSINE 0.95

static struct tcs_point
cross(struct tcs_point a, struct tcs_point b)
{
	return (struct tcs_point){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z,
		a.x * b.y - a.y * b.x};
}

static double
dot(struct tcs_point a, struct tcs_point b)
{
	return a.x * b.x + a.y * b.y + a.z * b.z;
}

/* ISO 19136: point = anchor + matrix * (x, y, z, 1), the matrix by rows. */
static struct tcs_point
place_point(const struct mesh_place *place, struct tcs_point p)
{
	const struct tcs_instance *by = place->instance;
	const double *m;
	struct tcs_point moved, anchor;

	if (!place->frame)
		return p;
	if (!by)
		return frame_to_local(place->frame, p);
	m = by->matrix;
	moved.x = m[0] * p.x + m[1] * p.y + m[2] * p.z + m[3];
	moved.y = m[4] * p.x + m[5] * p.y + m[6] * p.z + m[7];
	moved.z = m[8] * p.x + m[9] * p.y + m[10] * p.z + m[11];
	if (place->frame->kind == TCS_CRS_GEOGRAPHIC) {
		anchor = frame_to_local(place->frame, by->anchor);
		return (struct tcs_point){anchor.x + moved.x,
			anchor.y + moved.y, anchor.z + moved.z};
	}
	moved.x += by->anchor.x;
	moved.y += by->anchor.y;
	moved.z += by->anchor.z;
	return frame_to_local(place->frame, moved);
}

/* A mirroring matrix turns every triangle inside out. */
static bool
place_mirrors(const struct mesh_place *place)
{
	const double *m;

	if (!place->instance)
		return false;
	m = place->instance->matrix;
	return m[0] * (m[5] * m[10] - m[6] * m[9]) -
		m[1] * (m[4] * m[10] - m[6] * m[8]) +
		m[2] * (m[4] * m[9] - m[5] * m[8]) <
		0;
}

static bool
fits_float(struct tcs_point p)
{
	return fabs(p.x) <= FLT_MAX && fabs(p.y) <= FLT_MAX &&
		fabs(p.z) <= FLT_MAX;
}

static int
place_polygon(struct mesh *mesh, const struct tcs_object *object,
	const struct tcs_polygon *polygon, const struct mesh_place *place,
	bool *fits)
{
	const struct tcs_point *from =
		object->vertices.at + polygon->first_vertex;

	*fits = true;
	mesh->mirrored = place_mirrors(place);
	array_clear(&mesh->local);
	array_clear(&mesh->used);
	if (array_grow(&mesh->local, polygon->vertex_count) ||
		array_grow(&mesh->used, polygon->vertex_count))
		return -1;
	for (uint32_t i = 0; i < polygon->vertex_count; i++) {
		struct tcs_point p = place_point(place, from[i]);

		*fits = *fits && fits_float(p);
		mesh->local.at[i] =
			(struct mesh_point){(float)p.x, (float)p.y, (float)p.z};
		mesh->used.at[i] = TCS_NONE;
	}
	mesh->local.count = polygon->vertex_count;
	mesh->used.count = polygon->vertex_count;
	return 0;
}

static struct tcs_point
between(struct mesh_point from, struct mesh_point to)
{
	return (struct tcs_point){(double)to.x - (double)from.x,
		(double)to.y - (double)from.y, (double)to.z - (double)from.z};
}

/*
 * Twice the area times the normal, from positions as the glTF will hold them:
 * zero for a triangle that is flat there.
 */
static struct tcs_point
triangle_normal(const struct mesh *mesh, const struct tcs_polygon *polygon,
	const struct tcs_triangle *triangle)
{
	const struct mesh_point *local = mesh->local.at;
	uint32_t first = polygon->first_vertex;
	struct mesh_point a = local[triangle->corner[0] - first];
	struct mesh_point b = local[triangle->corner[1] - first];
	struct mesh_point c = local[triangle->corner[2] - first];

	return mesh->mirrored ? cross(between(a, c), between(a, b))
			      : cross(between(a, b), between(a, c));
}

static struct tcs_point
unit(struct tcs_point n, double length)
{
	return (struct tcs_point){n.x / length, n.y / length, n.z / length};
}

struct polygon_shape {
	struct tcs_point normal; /* unit; zero when there is none */
	uint32_t triangles; /* with an area */
	bool bent;
};

static struct polygon_shape
polygon_shape(const struct mesh *mesh, const struct tcs_polygon *polygon,
	const struct tcs_triangle *triangles)
{
	struct polygon_shape shape = {.bent = false};
	struct tcs_point sum = {0, 0, 0};
	double total = 0, length;

	for (uint32_t i = 0; i < polygon->triangle_count; i++) {
		struct tcs_point n =
			triangle_normal(mesh, polygon, triangles + i);
		double size = sqrt(dot(n, n));

		shape.triangles += size > 0;
		total += size;
		sum.x += n.x;
		sum.y += n.y;
		sum.z += n.z;
	}
	length = sqrt(dot(sum, sum));
	if (length > 0 && length > total * SLIVER)
		shape.normal = unit(sum, length);
	else
		shape.bent = true;
	for (uint32_t i = 0; !shape.bent && shape.triangles > 1 &&
		i < polygon->triangle_count;
		i++) {
		struct tcs_point n =
			triangle_normal(mesh, polygon, triangles + i);
		double size = sqrt(dot(n, n));

		shape.bent = size > total * SLIVER &&
			dot(n, shape.normal) < BENT_COSINE * size;
	}
	return shape;
}

/* glTF counts t from the upper edge of the image. */
static void
mesh_push_texcoord(struct mesh *mesh, const struct tcs_texcoord *from)
{
	float *to = mesh->texcoords.at + mesh->texcoords.count;

	to[0] = from ? (float)from->s : 0;
	to[1] = from ? (float)(1 - from->t) : 0;
	mesh->texcoords.count += 2;
}

static void
mesh_push_vertex(struct mesh *mesh, struct mesh_point at,
	struct tcs_point normal, uint32_t feature, bool with_normal)
{
	float *position = mesh->positions.at + mesh->positions.count;

	position[0] = at.x;
	position[1] = at.y;
	position[2] = at.z;
	mesh->positions.count += 3;
	if (with_normal) {
		float *to = mesh->normals.at + mesh->normals.count;

		to[0] = (float)normal.x;
		to[1] = (float)normal.y;
		to[2] = (float)normal.z;
		mesh->normals.count += 3;
	}
	mesh->features.at[mesh->features.count++] = feature;
}

/* Texture coordinates begin with the first image: those before get zeros. */
static int
mesh_texcoord_room(struct mesh *mesh, bool textured, size_t corners)
{
	size_t vertices = mesh->features.count;

	if (!textured && !mesh->texcoords.count)
		return 0;
	if (array_grow(&mesh->texcoords,
		    2 * (vertices + corners) - mesh->texcoords.count))
		return -1;
	while (mesh->texcoords.count < 2 * vertices)
		mesh->texcoords.at[mesh->texcoords.count++] = 0;
	return 0;
}

static enum tcs_status
mesh_room(struct mesh *mesh, const struct polygon_shape *shape, bool textured,
	struct tcs_fault *fault)
{
	uint64_t corners = (uint64_t)shape->triangles * 3;
	uint64_t most = mesh->triangle_limit && mesh->triangle_limit < 1u << 30
		? mesh->triangle_limit
		: 1u << 30;

	if (mesh->indices.count / 3 + shape->triangles > most)
		return fault_set(fault, TCS_LIMIT, TCS_NOWHERE,
			"more than %llu triangles in one object",
			(unsigned long long)most);
	if (array_grow(&mesh->positions, (size_t)corners * 3) ||
		array_grow(&mesh->normals, (size_t)corners * 3) ||
		array_grow(&mesh->features, (size_t)corners) ||
		mesh_texcoord_room(mesh, textured, (size_t)corners) ||
		array_grow(&mesh->indices, (size_t)corners) ||
		array_grow(&mesh->runs, 1))
		return fault_memory(fault);
	return TCS_OK;
}

static void
mesh_draw(struct mesh *mesh, const struct tcs_polygon *polygon,
	const struct tcs_triangle *triangles, struct polygon_shape shape,
	uint32_t feature, const struct tcs_texcoord *texcoords,
	bool with_normals)
{
	bool with_texcoords = texcoords || mesh->texcoords.count;

	for (uint32_t i = 0; i < polygon->triangle_count; i++) {
		struct tcs_point n =
			triangle_normal(mesh, polygon, triangles + i);
		double size = sqrt(dot(n, n));

		if (!(size > 0)) {
			mesh->flat_triangles++;
			continue;
		}
		for (int k = 0; k < 3; k++) {
			int corner = mesh->mirrored ? 2 - k : k;
			uint32_t from = triangles[i].corner[corner] -
				polygon->first_vertex;
			uint32_t *to = mesh->used.at + from;

			if (*to == TCS_NONE || shape.bent) {
				*to = (uint32_t)mesh->features.count;
				mesh_push_vertex(mesh, mesh->local.at[from],
					shape.bent ? unit(n, size)
						   : shape.normal,
					feature, with_normals);
				if (with_texcoords)
					mesh_push_texcoord(mesh,
						texcoords ? texcoords + from
							  : NULL);
			}
			mesh->indices.at[mesh->indices.count++] = *to;
		}
	}
}

enum tcs_status
mesh_add_polygon(struct mesh *mesh, const struct tcs_object *object,
	const struct tcs_polygon *polygon, const struct mesh_place *place,
	uint32_t feature, const struct mesh_paint *paint,
	enum mesh_normals normals, enum mesh_outcome *outcome,
	struct tcs_fault *fault)
{
	const struct tcs_triangle *triangles =
		object->triangles.at + polygon->first_triangle;
	size_t first = mesh->indices.count;
	struct polygon_shape shape;
	enum tcs_status status;
	bool textured = paint->image != TCS_NONE;
	bool fits;

	if (place_polygon(mesh, object, polygon, place, &fits))
		return fault_memory(fault);
	*outcome = MESH_TOO_FAR;
	if (!fits)
		return TCS_OK;
	shape = polygon_shape(mesh, polygon, triangles);
	*outcome = MESH_NO_AREA;
	if (!shape.triangles)
		return TCS_OK;
	status = mesh_room(mesh, &shape, textured, fault);
	if (status)
		return status;
	mesh_draw(mesh, polygon, triangles, shape, feature,
		textured ? paint->texcoords : NULL, normals != MESH_PLAIN);
	mesh->runs.at[mesh->runs.count++] = (struct mesh_run){
		.image = paint->image,
		.paint = paint->paint,
		.first = (uint32_t)first,
		.count = (uint32_t)(mesh->indices.count - first),
	};
	*outcome = MESH_DRAWN;
	return TCS_OK;
}

static int
compare_looks(const struct mesh_run *a, const struct mesh_run *b)
{
	if (a->image != b->image)
		return a->image < b->image ? -1 : 1;
	return a->paint < b->paint ? -1 : a->paint > b->paint;
}

static int
compare_runs(const void *left, const void *right)
{
	const struct mesh_run *a = left, *b = right;
	int order = compare_looks(a, b);

	if (order)
		return order;
	return a->first < b->first ? -1 : a->first > b->first;
}

static bool
runs_are_ordered(const struct mesh_runs *runs)
{
	for (size_t i = 1; i < runs->count; i++)
		if (compare_looks(runs->at + i - 1, runs->at + i) > 0)
			return false;
	return true;
}

static int
sort_indices(struct mesh *mesh)
{
	struct mesh_indices swap = mesh->sorted;

	array_clear(&mesh->sorted);
	if (array_grow(&mesh->sorted, mesh->indices.count))
		return -1;
	swap = mesh->sorted;
	qsort(mesh->runs.at, mesh->runs.count, sizeof *mesh->runs.at,
		compare_runs);
	for (size_t i = 0; i < mesh->runs.count; i++) {
		struct mesh_run *run = mesh->runs.at + i;

		memcpy(swap.at + swap.count, mesh->indices.at + run->first,
			run->count * sizeof *swap.at);
		run->first = (uint32_t)swap.count;
		swap.count += run->count;
	}
	mesh->sorted = mesh->indices;
	mesh->indices = swap;
	return 0;
}

enum tcs_status
mesh_group(struct mesh *mesh, struct tcs_fault *fault)
{
	size_t kept = 0;

	if (!runs_are_ordered(&mesh->runs) && sort_indices(mesh))
		return fault_memory(fault);
	for (size_t i = 0; i < mesh->runs.count; i++) {
		const struct mesh_run *run = mesh->runs.at + i;

		if (kept && !compare_looks(mesh->runs.at + kept - 1, run))
			mesh->runs.at[kept - 1].count += run->count;
		else
			mesh->runs.at[kept++] = *run;
	}
	mesh->runs.count = kept;
	return TCS_OK;
}

void
mesh_bounds(const struct mesh *mesh, float lower[3], float upper[3])
{
	const float *at = mesh->positions.at;

	memcpy(lower, at, 3 * sizeof *at);
	memcpy(upper, at, 3 * sizeof *at);
	for (size_t i = 3; i < mesh->positions.count; i += 3)
		for (int k = 0; k < 3; k++) {
			if (lower[k] > at[i + (size_t)k])
				lower[k] = at[i + (size_t)k];
			if (upper[k] < at[i + (size_t)k])
				upper[k] = at[i + (size_t)k];
		}
}

enum tcs_status
mesh_count_features(struct mesh *mesh, size_t feature_count, uint32_t *out,
	struct tcs_fault *fault)
{
	uint32_t different = 0;

	array_clear(&mesh->used);
	if (array_grow(&mesh->used, feature_count))
		return fault_memory(fault);
	if (feature_count)
		memset(mesh->used.at, 0, feature_count * sizeof *mesh->used.at);
	for (size_t i = 0; i < mesh->features.count; i++) {
		uint32_t *seen = mesh->used.at + mesh->features.at[i];

		different += !*seen;
		*seen = 1;
	}
	*out = different;
	return TCS_OK;
}

void
mesh_clear(struct mesh *mesh)
{
	array_clear(&mesh->positions);
	array_clear(&mesh->normals);
	array_clear(&mesh->texcoords);
	array_clear(&mesh->features);
	array_clear(&mesh->indices);
	array_clear(&mesh->runs);
	array_clear(&mesh->instances);
	mesh->flat_triangles = 0;
}

void
mesh_release(struct mesh *mesh)
{
	array_release(&mesh->positions);
	array_release(&mesh->normals);
	array_release(&mesh->texcoords);
	array_release(&mesh->features);
	array_release(&mesh->indices);
	array_release(&mesh->runs);
	array_release(&mesh->instances);
	array_release(&mesh->local);
	array_release(&mesh->used);
	array_release(&mesh->sorted);
}
