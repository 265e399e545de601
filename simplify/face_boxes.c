#include "face_boxes.h"

#include <stdlib.h>

enum {
	NATURAL_ORDER = 64, /* faces that are left in the order they have */
	MAX_LEVELS = 11, /* 8^11 faces are more than there are */
	CURVE_BITS = 10, /* of a place along each axis */
};

static double
lesser(double a, double b)
{
	return a < b ? a : b;
}

static double
greater(double a, double b)
{
	return a > b ? a : b;
}

static struct float_box
box_of_face(const struct component_set *set, const struct sheets *sheets,
	uint32_t face)
{
	struct triangle_shape shape =
		component_set_shape(set, sheets->face_triangles.at[face]);
	const struct tcs_point *p = shape.corner;
	struct tcs_point low = {lesser(p[0].x, lesser(p[1].x, p[2].x)),
		lesser(p[0].y, lesser(p[1].y, p[2].y)),
		lesser(p[0].z, lesser(p[1].z, p[2].z))};
	struct tcs_point high = {greater(p[0].x, greater(p[1].x, p[2].x)),
		greater(p[0].y, greater(p[1].y, p[2].y)),
		greater(p[0].z, greater(p[1].z, p[2].z))};

	return float_box_around(low, high, 0);
}

/* ---- blocks -------------------------------------------------------------- */

static const struct box_block empty_block = {
	{{INFINITY, INFINITY, INFINITY, INFINITY, INFINITY, INFINITY, INFINITY,
		 INFINITY},
		{INFINITY, INFINITY, INFINITY, INFINITY, INFINITY, INFINITY,
			INFINITY, INFINITY},
		{INFINITY, INFINITY, INFINITY, INFINITY, INFINITY, INFINITY,
			INFINITY, INFINITY}},
	{{-INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY,
		 -INFINITY, -INFINITY},
		{-INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY,
			-INFINITY, -INFINITY, -INFINITY},
		{-INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY,
			-INFINITY, -INFINITY, -INFINITY}}};

static void
block_put(struct box_block *block, size_t place, const struct float_box *box)
{
	for (int i = 0; i < 3; i++) {
		block->low[i][place] = box->low[i];
		block->high[i][place] = box->high[i];
	}
}

static struct float_box
box_of_block(const struct box_block *block)
{
	struct float_box box = {{INFINITY, INFINITY, INFINITY},
		{-INFINITY, -INFINITY, -INFINITY}};

	for (int i = 0; i < 3; i++)
		for (int k = 0; k < BLOCK_BOXES; k++) {
			float low = block->low[i][k], high = block->high[i][k];

			box.low[i] = low < box.low[i] ? low : box.low[i];
			box.high[i] = high > box.high[i] ? high : box.high[i];
		}
	return box;
}

/* A bit for each of its boxes that meets the other one. */
static inline unsigned
block_meets(const struct box_block *block, const struct float_box *box)
{
	int32_t meets[BLOCK_BOXES];
	unsigned bits = 0;

	for (int k = 0; k < BLOCK_BOXES; k++)
		meets[k] = (block->low[0][k] <= box->high[0]) &
			(block->high[0][k] >= box->low[0]) &
			(block->low[1][k] <= box->high[1]) &
			(block->high[1][k] >= box->low[1]) &
			(block->low[2][k] <= box->high[2]) &
			(block->high[2][k] >= box->low[2]);
	for (int k = 0; k < BLOCK_BOXES; k++)
		bits |= (unsigned)meets[k] << k;
	return bits;
}

static size_t
blocks_over(size_t count)
{
	return (count + BLOCK_BOXES - 1) / BLOCK_BOXES;
}

/* Blocks over the boxes in `from`, which follow each other. */
static enum tcs_status
add_level(struct face_boxes *boxes, size_t from, size_t count,
	struct tcs_fault *fault)
{
	size_t more = blocks_over(count), first = boxes->blocks.count;

	if (array_grow(&boxes->blocks, more))
		return fault_memory(fault);
	boxes->blocks.count += more;
	for (size_t i = 0; i < more; i++)
		boxes->blocks.at[first + i] = empty_block;
	for (size_t i = 0; i < count; i++) {
		struct float_box box =
			box_of_block(&boxes->blocks.at[from + i]);

		block_put(&boxes->blocks.at[first + i / BLOCK_BOXES],
			i % BLOCK_BOXES, &box);
	}
	return TCS_OK;
}

static enum tcs_status
add_blocks(struct face_boxes *boxes, const struct component_set *set,
	const struct sheets *sheets, struct face_run *run,
	struct tcs_fault *fault)
{
	size_t level = blocks_over(run->face_count);
	size_t first = boxes->blocks.count;
	enum tcs_status status = TCS_OK;

	if (first + 2 * level >= UINT32_MAX)
		return fault_set(fault, TCS_LIMIT, TCS_NOWHERE,
			"too many triangles in one object");
	run->first_block = (uint32_t)first;
	if (array_grow(&boxes->blocks, level))
		return fault_memory(fault);
	boxes->blocks.count += level;
	for (size_t i = 0; i < level; i++)
		boxes->blocks.at[first + i] = empty_block;
	for (size_t i = 0; i < run->face_count; i++) {
		struct float_box box = box_of_face(
			set, sheets, boxes->faces.at[run->first_face + i]);

		block_put(&boxes->blocks.at[first + i / BLOCK_BOXES],
			i % BLOCK_BOXES, &box);
	}
	while (!status && level > 1) {
		first = boxes->blocks.count - level;
		status = add_level(boxes, first, level, fault);
		level = blocks_over(level);
	}
	return status;
}

/* ---- the order of the faces ----------------------------------------------- */

/* The bits of a number, each followed by two zeros. */
static uint32_t
spread_bits(uint32_t bits)
{
	bits = (bits | bits << 16) & 0x030000ffu;
	bits = (bits | bits << 8) & 0x0300f00fu;
	bits = (bits | bits << 4) & 0x030c30c3u;
	return (bits | bits << 2) & 0x09249249u;
}

/* The place of a face along the curve through the component's box. */
static uint64_t
curve_place(const struct box *bounds, const struct float_box *box)
{
	uint32_t place = 0;

	for (int i = 0; i < 3; i++) {
		double size = bounds->high[i] - bounds->low[i];
		double at = ((double)box->low[i] + (double)box->high[i]) / 2 -
			bounds->low[i];
		double most = (1 << CURVE_BITS) - 1;
		double cell = size > 0 && isfinite(size) ? at / size * most : 0;

		place |= spread_bits((uint32_t)fmax(0, fmin(most, cell))) << i;
	}
	return place;
}

static int
by_key(const void *left, const void *right)
{
	const uint64_t *a = left, *b = right;

	return (*a > *b) - (*a < *b);
}

static enum tcs_status
sort_faces(struct face_boxes *boxes, const struct component_set *set,
	const struct sheets *sheets, size_t component, struct tcs_fault *fault)
{
	const struct face_run *run = &boxes->runs.at[component];
	uint32_t *faces = boxes->faces.at + run->first_face;
	uint64_t *keys = calloc(run->face_count, sizeof *keys);

	if (!keys)
		return fault_memory(fault);
	for (uint32_t i = 0; i < run->face_count; i++) {
		struct float_box box = box_of_face(set, sheets, faces[i]);

		keys[i] = curve_place(&set->components.at[component].box, &box)
				<< 32 |
			faces[i];
	}
	qsort(keys, run->face_count, sizeof *keys, by_key);
	for (uint32_t i = 0; i < run->face_count; i++)
		faces[i] = (uint32_t)(keys[i] & UINT32_MAX);
	free(keys);
	return TCS_OK;
}

/* Faces stand component by component. */
static enum tcs_status
list_runs(struct face_boxes *boxes, const struct component_set *set,
	const struct sheets *sheets, struct tcs_fault *fault)
{
	size_t count = sheets->face_triangles.count;

	if (array_grow(&boxes->runs, set->components.count) ||
		array_grow(&boxes->faces, count))
		return fault_memory(fault);
	boxes->runs.count = set->components.count;
	for (size_t i = 0; i < boxes->runs.count; i++)
		boxes->runs.at[i] = (struct face_run){0};
	for (uint32_t i = 0; i < count; i++) {
		uint32_t triangle = sheets->face_triangles.at[i];
		struct face_run *run =
			&boxes->runs.at[set->numbers.at[triangle]];

		if (!run->face_count++)
			run->first_face = i;
		boxes->faces.at[i] = i;
	}
	boxes->faces.count = count;
	return TCS_OK;
}

enum tcs_status
face_boxes_build(struct face_boxes *boxes, const struct component_set *set,
	const struct sheets *sheets, struct tcs_fault *fault)
{
	enum tcs_status status;

	array_clear(&boxes->runs);
	array_clear(&boxes->blocks);
	array_clear(&boxes->faces);
	status = list_runs(boxes, set, sheets, fault);
	for (size_t i = 0; !status && i < boxes->runs.count; i++) {
		struct face_run *run = &boxes->runs.at[i];

		if (run->face_count > NATURAL_ORDER)
			status = sort_faces(boxes, set, sheets, i, fault);
		if (!status && run->face_count > 0)
			status = add_blocks(boxes, set, sheets, run, fault);
	}
	return status;
}

void
face_boxes_release(struct face_boxes *boxes)
{
	array_release(&boxes->runs);
	array_release(&boxes->blocks);
	array_release(&boxes->faces);
}

/* ---- what is near -------------------------------------------------------- */

/* A block, counted within its level. */
struct block_place {
	uint32_t level, number;
};

struct block_walk {
	struct block_place stack[MAX_LEVELS * BLOCK_BOXES];
	size_t height;
	uint32_t levels[MAX_LEVELS]; /* the first block of each */
};

/* Begin at the block that is alone. */
static void
walk_begin(struct block_walk *walk, const struct face_run *run)
{
	uint32_t level = 0, at = run->first_block;
	size_t count = blocks_over(run->face_count);

	walk->levels[0] = at;
	while (count > 1) {
		at += (uint32_t)count;
		walk->levels[++level] = at;
		count = blocks_over(count);
	}
	walk->stack[0] = (struct block_place){level, 0};
	walk->height = 1;
}

enum tcs_status
face_boxes_near(const struct face_boxes *boxes, uint32_t component,
	const struct float_box *box, struct face_list *out,
	struct tcs_fault *fault)
{
	const struct face_run *run = &boxes->runs.at[component];
	const uint32_t *faces = boxes->faces.at + run->first_face;
	struct block_walk walk;

	out->count = 0;
	if (!run->face_count)
		return TCS_OK;
	walk_begin(&walk, run);
	while (walk.height > 0) {
		struct block_place at = walk.stack[--walk.height];
		unsigned bits = block_meets(
			&boxes->blocks.at[walk.levels[at.level] + at.number],
			box);

		if (array_grow(out, BLOCK_BOXES))
			return fault_memory(fault);
		for (uint32_t i = BLOCK_BOXES * at.number; bits;
			bits >>= 1, i++) {
			if (!(bits & 1))
				continue;
			if (at.level)
				walk.stack[walk.height++] =
					(struct block_place){at.level - 1, i};
			else
				out->at[out->count++] = faces[i];
		}
	}
	return TCS_OK;
}
