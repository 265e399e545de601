#include "town_shape.h"

#include <assert.h>
#include <math.h>

struct frame
frame_at(long x, long y, long z, double degrees)
{
	double radians = degrees * acos(-1) / 180;

	return (struct frame){{x, y, z}, cos(radians), sin(radians)};
}

struct spot
frame_place(const struct frame *frame, struct local local)
{
	double x = local.u * frame->cosine - local.v * frame->sine;
	double y = local.u * frame->sine + local.v * frame->cosine;

	return (struct spot){
		frame->origin.x + lround(1000 * x),
		frame->origin.y + lround(1000 * y),
		frame->origin.z + lround(1000 * local.z),
	};
}

void
shape_begin(struct shape *shape, struct frame frame)
{
	shape->frame = frame;
	shape->spot_count = 0;
	shape->ring_count = 0;
	shape->face_count = 0;
	shape->opening_count = 0;
	shape->shell_faces = SHAPE_FACES;
	shape->top = frame.origin.z;
}

static void
ring_begin(struct shape *shape)
{
	assert(shape->ring_count < SHAPE_RINGS);
	shape->rings[shape->ring_count++] = (struct ring){shape->spot_count, 0};
}

size_t
shape_face(struct shape *shape, enum face_class class)
{
	struct face *face = &shape->faces[shape->face_count];

	assert(shape->face_count < SHAPE_FACES);
	*face = (struct face){
		.class = class,
		.first_ring = shape->ring_count,
		.ring_count = 1,
	};
	ring_begin(shape);
	return shape->face_count++;
}

void
shape_hole(struct shape *shape)
{
	ring_begin(shape);
	shape->faces[shape->face_count - 1].ring_count++;
}

void
shape_point(struct shape *shape, double u, double v, double z)
{
	struct spot spot = frame_place(&shape->frame, (struct local){u, v, z});

	assert(shape->spot_count < SHAPE_SPOTS);
	shape->spots[shape->spot_count++] = spot;
	shape->rings[shape->ring_count - 1].count++;
	if (spot.z > shape->top)
		shape->top = spot.z;
}

size_t
shape_polygon(struct shape *shape, enum face_class class,
	const struct local *points, size_t count)
{
	size_t face = shape_face(shape, class);

	for (size_t i = 0; i < count; i++)
		shape_point(shape, points[i].u, points[i].v, points[i].z);
	return face;
}

void
shape_opening(struct shape *shape, size_t face, struct local left,
	struct local right, double top, bool door)
{
	struct face *host = &shape->faces[face];
	struct opening *opening = &shape->openings[shape->opening_count];
	const struct local corners[] = {
		left,
		right,
		{right.u, right.v, top},
		{left.u, left.v, top},
	};

	assert(shape->opening_count < SHAPE_OPENINGS);
	assert(shape->spot_count + 4 <= SHAPE_SPOTS);
	if (host->opening_count == 0)
		host->first_opening = shape->opening_count;
	assert(host->first_opening + host->opening_count ==
		shape->opening_count);
	host->opening_count++;
	shape->opening_count++;
	*opening = (struct opening){{shape->spot_count, 4}, door};
	for (size_t i = 0; i < 4; i++)
		shape->spots[shape->spot_count++] =
			frame_place(&shape->frame, corners[i]);
}

static struct local
between(struct local left, struct local right, double part, double z)
{
	return (struct local){
		left.u + part * (right.u - left.u),
		left.v + part * (right.v - left.v),
		z,
	};
}

void
shape_windows(struct shape *shape, size_t face, struct local left,
	struct local right, unsigned storeys, unsigned bays, bool door)
{
	double width = hypot(right.u - left.u, right.v - left.v);
	double half = 0.55 / width;

	for (unsigned storey = 0; storey < storeys; storey++) {
		for (unsigned bay = 0; bay < bays; bay++) {
			bool is_door = door && !storey && bay == bays / 2;
			double z = left.z + 2.9 * storey;
			double at = (bay + 0.5) / bays;
			double foot = is_door ? z + 0.1 : z + 0.9;
			struct local a = between(left, right, at - half, foot);
			struct local b = between(left, right, at + half, foot);

			shape_opening(shape, face, a, b, z + 2.3, is_door);
		}
	}
}

static void
side_quad(struct shape *shape, enum face_class class, const double a[2],
	const double b[2], double u0, double u1)
{
	const struct local quad[] = {
		{u0, a[0], a[1]},
		{u0, b[0], b[1]},
		{u1, b[0], b[1]},
		{u1, a[0], a[1]},
	};

	shape_polygon(shape, class, quad, 4);
}

size_t
shape_extrude(struct shape *shape, const double (*profile)[2],
	const enum face_class *classes, size_t count, double u0, double u1)
{
	size_t first = shape->face_count;

	for (size_t i = 0; i < count; i++)
		side_quad(shape, classes[i], profile[i],
			profile[(i + 1) % count], u0, u1);
	shape_face(shape, FACE_WALL);
	for (size_t i = count; i-- > 0;)
		shape_point(shape, u0, profile[i][0], profile[i][1]);
	shape_face(shape, FACE_WALL);
	for (size_t i = 0; i < count; i++)
		shape_point(shape, u1, profile[i][0], profile[i][1]);
	return first;
}

size_t
shape_block(struct shape *shape, const double (*outline)[2], size_t count,
	double z0, double z1)
{
	size_t first = shape_face(shape, FACE_GROUND);

	for (size_t i = count; i-- > 0;)
		shape_point(shape, outline[i][0], outline[i][1], z0);
	for (size_t i = 0; i < count; i++) {
		const double *a = outline[i], *b = outline[(i + 1) % count];
		const struct local quad[] = {
			{a[0], a[1], z0},
			{b[0], b[1], z0},
			{b[0], b[1], z1},
			{a[0], a[1], z1},
		};

		shape_polygon(shape, FACE_WALL, quad, 4);
	}
	shape_face(shape, FACE_ROOF);
	for (size_t i = 0; i < count; i++)
		shape_point(shape, outline[i][0], outline[i][1], z1);
	return first;
}

void
shape_box(struct shape *shape, struct local low, struct local high)
{
	const double outline[][2] = {
		{low.u, low.v},
		{high.u, low.v},
		{high.u, high.v},
		{low.u, high.v},
	};

	shape_block(shape, outline, 4, low.z, high.z);
}

void
shape_cavity(struct shape *shape, struct local low, struct local high,
	enum face_class wall, enum face_class floor, enum face_class ceiling)
{
	const double outline[][2] = {
		{low.u, low.v},
		{low.u, high.v},
		{high.u, high.v},
		{high.u, low.v},
	};

	shape_face(shape, floor);
	for (size_t i = 4; i-- > 0;)
		shape_point(shape, outline[i][0], outline[i][1], low.z);
	for (size_t i = 0; i < 4; i++) {
		const double *a = outline[i], *b = outline[(i + 1) % 4];
		const struct local quad[] = {
			{a[0], a[1], low.z},
			{b[0], b[1], low.z},
			{b[0], b[1], high.z},
			{a[0], a[1], high.z},
		};

		shape_polygon(shape, wall, quad, 4);
	}
	shape_face(shape, ceiling);
	for (size_t i = 0; i < 4; i++)
		shape_point(shape, outline[i][0], outline[i][1], high.z);
}
