/*
 * Which faces are near a box: boxes of the faces in single precision, eight to
 * a block, and blocks of blocks above them, for each component or for any other
 * run of faces. Those of a large run stand along a curve that fills space, so
 * that a block is compact.
 *
 * source: I. Wald et al., Getting rid of packets: efficient SIMD single-ray
 * traversal using multi-branching BVHs, 2008; G. Morton, A computer oriented
 * geodetic data base and a new technique in file sequencing, 1966.
 */
#ifndef TESSERA_FACE_BOXES_H
#define TESSERA_FACE_BOXES_H

#include <float.h>
#include <math.h>

#include "sheets.h"

enum { BLOCK_BOXES = 8 };

/* Not smaller than what it is around. */
struct float_box {
	float low[3], high[3];
};

/* Room that is not used has boxes that meet nothing. */
struct box_block {
	float low[3][BLOCK_BOXES], high[3][BLOCK_BOXES];
};

/* The blocks of a run: those over its faces, then level by level those
   over blocks; the last is alone. */
struct face_run {
	uint32_t first_block;
	uint32_t first_face, face_count; /* of `faces` */
};

/* All zero is empty; reused from object to object. */
struct face_boxes {
	TCS_ARRAY(struct face_run) runs; /* by number */
	TCS_ARRAY(struct box_block) blocks;
	TCS_ARRAY(uint32_t) faces; /* in the order of their boxes */
};

TCS_ARRAY_TYPE(face_list, uint32_t);

static inline float
rounded_down(double value)
{
	float near = (float)(value < -FLT_MAX ? -FLT_MAX
			: value > FLT_MAX     ? FLT_MAX
					      : value);

	return near - (fabsf(near) * FLT_EPSILON + FLT_MIN);
}

static inline float
rounded_up(double value)
{
	return -rounded_down(-value);
}

/* The box around two points and all that is within `reach` of them. */
static inline struct float_box
float_box_around(struct tcs_point a, struct tcs_point b, double reach)
{
	return (struct float_box){
		{rounded_down((a.x < b.x ? a.x : b.x) - reach),
			rounded_down((a.y < b.y ? a.y : b.y) - reach),
			rounded_down((a.z < b.z ? a.z : b.z) - reach)},
		{rounded_up((a.x > b.x ? a.x : b.x) + reach),
			rounded_up((a.y > b.y ? a.y : b.y) + reach),
			rounded_up((a.z > b.z ? a.z : b.z) + reach)}};
}

static inline double
least_of(double a, double b, double c)
{
	double least = a < b ? a : b;

	return c < least ? c : least;
}

static inline struct float_box
float_box_of(const struct triangle_shape *shape)
{
	const struct tcs_point *p = shape->corner;

	return (struct float_box){
		{rounded_down(least_of(p[0].x, p[1].x, p[2].x)),
			rounded_down(least_of(p[0].y, p[1].y, p[2].y)),
			rounded_down(least_of(p[0].z, p[1].z, p[2].z))},
		{rounded_up(-least_of(-p[0].x, -p[1].x, -p[2].x)),
			rounded_up(-least_of(-p[0].y, -p[1].y, -p[2].y)),
			rounded_up(-least_of(-p[0].z, -p[1].z, -p[2].z))}};
}

static inline struct float_box
float_box_at(struct tcs_point point)
{
	return float_box_around(point, point, 0);
}

static inline bool
float_box_holds(const struct float_box *box, struct tcs_point point)
{
	return point.x >= (double)box->low[0] &&
		point.x <= (double)box->high[0] &&
		point.y >= (double)box->low[1] &&
		point.y <= (double)box->high[1] &&
		point.z >= (double)box->low[2] &&
		point.z <= (double)box->high[2];
}

static inline bool
float_boxes_meet(const struct float_box *a, const struct float_box *b)
{
	return a->low[0] <= b->high[0] && a->high[0] >= b->low[0] &&
		a->low[1] <= b->high[1] && a->high[1] >= b->low[1] &&
		a->low[2] <= b->high[2] && a->high[2] >= b->low[2];
}

/* A run for each component of the sheets, in turn. Takes n log n steps. Fails with
   TCS_NO_MEMORY. */
enum tcs_status face_boxes_build(struct face_boxes *boxes,
	const struct component_set *set, const struct sheets *sheets,
	struct tcs_fault *fault) TCS_CHECKED;

/* Add a run of faces, or of none, in the order of their boxes. Takes n log n
   steps. Fails with TCS_NO_MEMORY, TCS_LIMIT. */
enum tcs_status face_boxes_add(struct face_boxes *boxes, const uint32_t *faces,
	const struct float_box *own, size_t count,
	struct tcs_fault *fault) TCS_CHECKED;

/* The box of face number `place` of a run, as `faces` has them, grows to hold
   the other one. */
void face_boxes_grow(struct face_boxes *boxes, uint32_t run, uint32_t place,
	const struct float_box *by);

/* That face is gone: its box meets nothing until it grows again. */
void face_boxes_drop(struct face_boxes *boxes, uint32_t run, uint32_t place);

void face_boxes_clear(struct face_boxes *boxes);

/* List the faces of a run whose boxes meet `box`, always in the same order.
   Fails with TCS_NO_MEMORY. */
enum tcs_status face_boxes_near(const struct face_boxes *boxes, uint32_t run,
	const struct float_box *box, struct face_list *out,
	struct tcs_fault *fault) TCS_CHECKED;

void face_boxes_release(struct face_boxes *boxes);

/* The faces of a run that are near a box, of which more is asked: few of them
   are copied. All zero is empty; reused. */
struct face_extract {
	const struct face_boxes *boxes; /* borrowed */
	uint32_t run;
	bool is_copy; /* else the run is asked */
	struct face_list faces;
	TCS_ARRAY(struct box_block) blocks; /* over the faces, in turn */
};

/* Extract the faces of a run whose boxes meet `box`. Fails with
   TCS_NO_MEMORY. */
enum tcs_status face_extract_fill(struct face_extract *extract,
	const struct face_boxes *boxes, uint32_t run,
	const struct float_box *box, struct tcs_fault *fault) TCS_CHECKED;

/* As face_boxes_near, for a box within that of the extract. */
enum tcs_status face_extract_near(const struct face_extract *extract,
	const struct float_box *box, struct face_list *out,
	struct tcs_fault *fault) TCS_CHECKED;

void face_extract_release(struct face_extract *extract);

#endif
