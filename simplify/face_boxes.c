#include "face_boxes.h"

#include <stdlib.h>

enum {
	NATURAL_ORDER = 64, /* faces that are left in the order they have */
	MAX_LEVELS = 11, /* 8^11 faces are more than there are */
	CURVE_BITS = 10, /* of a place along each axis */
	DIGIT_BITS = 8, /* that are sorted at once */
	DIGIT_MASK = (1 << DIGIT_BITS) - 1,
	MOST_EXTRACTED = 64, /* faces that are copied */
};

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
	static const int32_t place[BLOCK_BOXES] = {1, 2, 4, 8, 16, 32, 64, 128};
	int32_t bits = 0;

	for (int k = 0; k < BLOCK_BOXES; k++) {
		int32_t meets = (block->low[0][k] <= box->high[0]) &
			(block->high[0][k] >= box->low[0]) &
			(block->low[1][k] <= box->high[1]) &
			(block->high[1][k] >= box->low[1]) &
			(block->low[2][k] <= box->high[2]) &
			(block->high[2][k] >= box->low[2]);

		bits |= -meets & place[k];
	}
	return (unsigned)bits;
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

/* Blocks over the run that was added last; order[i] tells which of the boxes
   is the i-th. */
static enum tcs_status
add_blocks(struct face_boxes *boxes, const struct float_box *own,
	const uint64_t *order, size_t count, struct tcs_fault *fault)
{
	size_t level = blocks_over(count), first = boxes->blocks.count;
	enum tcs_status status = TCS_OK;

	if (first + 2 * level >= UINT32_MAX)
		return fault_set(fault, TCS_LIMIT, TCS_NOWHERE,
			"too many triangles in one object");
	if (array_grow(&boxes->blocks, level))
		return fault_memory(fault);
	boxes->blocks.count += level;
	for (size_t i = 0; i < level; i++)
		boxes->blocks.at[first + i] = empty_block;
	for (size_t i = 0; i < count; i++)
		block_put(&boxes->blocks.at[first + i / BLOCK_BOXES],
			i % BLOCK_BOXES, &own[order[i] & UINT32_MAX]);
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

/* The place of a box along the curve through the box around all. */
static uint64_t
curve_place(const struct float_box *all, const struct float_box *box)
{
	uint32_t place = 0;

	for (int i = 0; i < 3; i++) {
		double low = (double)all->low[i];
		double size = (double)all->high[i] - low;
		double at = ((double)box->low[i] + (double)box->high[i]) / 2;
		double most = (1 << CURVE_BITS) - 1;
		double cell = size > 0 ? (at - low) / size * most : 0;

		place |= spread_bits((uint32_t)(cell < 0 ? 0
					 : cell > most	 ? most
							 : cell))
			<< i;
	}
	return place;
}

/* The lower halves of the numbers stay as they stood where the upper ones are
   the same. `other` is as long; what is sorted may be in either, and returned. */
static uint64_t *
sort_by_upper_half(uint64_t *order, uint64_t *other, size_t count)
{
	for (unsigned shift = 32; shift < 32 + 3 * CURVE_BITS;
		shift += DIGIT_BITS) {
		size_t ends[1 << DIGIT_BITS] = {0}, end = 0;
		uint64_t *sorted = other;

		for (size_t i = 0; i < count; i++)
			ends[order[i] >> shift & DIGIT_MASK]++;
		for (size_t digit = 0; digit <= DIGIT_MASK; digit++) {
			size_t more = ends[digit];

			ends[digit] = end;
			end += more;
		}
		for (size_t i = 0; i < count; i++)
			sorted[ends[order[i] >> shift & DIGIT_MASK]++] =
				order[i];
		other = order;
		order = sorted;
	}
	return order;
}

/* The boxes by their places along the curve; the lower half of each number is
   which box it is. */
static uint64_t *
sort_boxes(uint64_t *order, uint64_t *other, const struct float_box *own,
	size_t count)
{
	struct float_box all = own[0];

	for (size_t i = 1; i < count; i++)
		for (int k = 0; k < 3; k++) {
			if (own[i].low[k] < all.low[k])
				all.low[k] = own[i].low[k];
			if (own[i].high[k] > all.high[k])
				all.high[k] = own[i].high[k];
		}
	for (size_t i = 0; i < count; i++)
		order[i] |= curve_place(&all, &own[i]) << 32;
	return sort_by_upper_half(order, other, count);
}

enum tcs_status
face_boxes_add(struct face_boxes *boxes, const uint32_t *faces,
	const struct float_box *own, size_t count, struct tcs_fault *fault)
{
	uint64_t *room = malloc((2 * count + 1) * sizeof *room);
	uint64_t *order = room;
	enum tcs_status status;

	if (!order || array_grow(&boxes->runs, 1) ||
		array_grow(&boxes->faces, count)) {
		free(room);
		return fault_memory(fault);
	}
	for (size_t i = 0; i < count; i++)
		order[i] = i;
	if (count > NATURAL_ORDER)
		order = sort_boxes(order, order + count, own, count);
	boxes->runs.at[boxes->runs.count++] =
		(struct face_run){(uint32_t)boxes->blocks.count,
			(uint32_t)boxes->faces.count, (uint32_t)count};
	for (size_t i = 0; i < count; i++)
		boxes->faces.at[boxes->faces.count++] =
			faces[order[i] & UINT32_MAX];
	status = add_blocks(boxes, own, order, count, fault);
	free(room);
	return status;
}

/* ---- components ---------------------------------------------------------- */

/* One component's faces and their boxes: a scratch. */
struct member {
	TCS_ARRAY(uint32_t) faces;
	TCS_ARRAY(struct float_box) own;
};

/* Faces stand component by component: those that begin at `face`. */
static enum tcs_status
add_component(struct face_boxes *boxes, const struct component_set *set,
	const struct sheets *sheets, uint32_t component, uint32_t *face,
	struct member *member, struct tcs_fault *fault)
{
	const uint32_t *triangles = sheets->face_triangles.at;

	member->faces.count = member->own.count = 0;
	for (; *face < sheets->face_triangles.count &&
		set->numbers.at[triangles[*face]] == component;
		++*face) {
		struct triangle_shape shape =
			component_set_shape(set, triangles[*face]);

		if (array_grow(&member->faces, 1) ||
			array_grow(&member->own, 1))
			return fault_memory(fault);
		member->faces.at[member->faces.count++] = *face;
		member->own.at[member->own.count++] = float_box_of(&shape);
	}
	return face_boxes_add(boxes, member->faces.at, member->own.at,
		member->faces.count, fault);
}

enum tcs_status
face_boxes_build(struct face_boxes *boxes, const struct component_set *set,
	const struct sheets *sheets, struct tcs_fault *fault)
{
	struct member member = {0};
	enum tcs_status status = TCS_OK;
	uint32_t face = 0;

	face_boxes_clear(boxes);
	if (array_grow(&boxes->faces, sheets->face_triangles.count))
		return fault_memory(fault);
	for (uint32_t i = 0; !status && i < set->components.count; i++)
		status = add_component(
			boxes, set, sheets, i, &face, &member, fault);
	array_release(&member.faces);
	array_release(&member.own);
	return status;
}

void
face_boxes_clear(struct face_boxes *boxes)
{
	array_clear(&boxes->runs);
	array_clear(&boxes->blocks);
	array_clear(&boxes->faces);
}

void
face_boxes_release(struct face_boxes *boxes)
{
	array_release(&boxes->runs);
	array_release(&boxes->blocks);
	array_release(&boxes->faces);
}

/* ---- growing ------------------------------------------------------------- */

static inline bool
box_holds(const struct box_block *block, size_t place,
	const struct float_box *other)
{
	for (int i = 0; i < 3; i++)
		if (other->low[i] < block->low[i][place] ||
			other->high[i] > block->high[i][place])
			return false;
	return true;
}

/* False when the box holds the other one already. */
static bool
grow_box(struct box_block *block, size_t place, const struct float_box *by)
{
	if (box_holds(block, place, by))
		return false;
	for (int i = 0; i < 3; i++) {
		float *low = &block->low[i][place];
		float *high = &block->high[i][place];

		*low = by->low[i] < *low ? by->low[i] : *low;
		*high = by->high[i] > *high ? by->high[i] : *high;
	}
	return true;
}

void
face_boxes_grow(struct face_boxes *boxes, uint32_t number, uint32_t place,
	const struct float_box *by)
{
	const struct face_run *run = &boxes->runs.at[number];
	struct box_block *level = boxes->blocks.at + run->first_block;
	size_t count = blocks_over(run->face_count);

	while (grow_box(&level[place / BLOCK_BOXES], place % BLOCK_BOXES, by) &&
		count > 1) {
		level += count;
		count = blocks_over(count);
		place /= BLOCK_BOXES;
	}
}

void
face_boxes_drop(struct face_boxes *boxes, uint32_t number, uint32_t place)
{
	const struct face_run *run = &boxes->runs.at[number];
	const struct float_box nothing = {{INFINITY, INFINITY, INFINITY},
		{-INFINITY, -INFINITY, -INFINITY}};

	block_put(&boxes->blocks.at[run->first_block + place / BLOCK_BOXES],
		place % BLOCK_BOXES, &nothing);
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

/* Go on with the blocks below one that the bits tell. */
static inline void
walk_down(struct block_walk *walk, struct block_place at, unsigned bits)
{
	for (uint32_t i = BLOCK_BOXES * at.number; bits; bits >>= 1, i++)
		if (bits & 1)
			walk->stack[walk->height++] =
				(struct block_place){at.level - 1, i};
}

enum tcs_status
face_boxes_near(const struct face_boxes *boxes, uint32_t number,
	const struct float_box *box, struct face_list *out,
	struct tcs_fault *fault)
{
	const struct face_run *run = &boxes->runs.at[number];
	const uint32_t *faces;
	struct block_walk walk;

	out->count = 0;
	if (!run->face_count)
		return TCS_OK;
	faces = boxes->faces.at + run->first_face;
	walk_begin(&walk, run);
	while (walk.height > 0) {
		struct block_place at = walk.stack[--walk.height];
		unsigned bits = block_meets(
			&boxes->blocks.at[walk.levels[at.level] + at.number],
			box);

		if (array_grow(out, BLOCK_BOXES))
			return fault_memory(fault);
		if (at.level) {
			walk_down(&walk, at, bits);
			continue;
		}
		for (uint32_t i = BLOCK_BOXES * at.number; bits;
			bits >>= 1, i++)
			if (bits & 1)
				out->at[out->count++] = faces[i];
	}
	return TCS_OK;
}

/* ---- extracts ------------------------------------------------------------ */

/* Put the boxes of a block that the bits tell behind those extracted. */
static void
extract_boxes(struct face_extract *extract, const struct box_block *block,
	unsigned bits, const uint32_t *faces)
{
	for (size_t i = 0; bits; bits >>= 1, i++) {
		size_t place = extract->faces.count;
		struct box_block *to;

		if (!(bits & 1))
			continue;
		to = &extract->blocks.at[place / BLOCK_BOXES];
		if (place % BLOCK_BOXES == 0)
			*to = empty_block;
		for (int k = 0; k < 3; k++) {
			to->low[k][place % BLOCK_BOXES] = block->low[k][i];
			to->high[k][place % BLOCK_BOXES] = block->high[k][i];
		}
		extract->faces.at[extract->faces.count++] = faces[i];
	}
}

enum tcs_status
face_extract_fill(struct face_extract *extract, const struct face_boxes *boxes,
	uint32_t number, const struct float_box *box, struct tcs_fault *fault)
{
	const struct face_run *run = &boxes->runs.at[number];
	struct block_walk walk;

	extract->boxes = boxes;
	extract->run = number;
	extract->is_copy = true;
	extract->faces.count = extract->blocks.count = 0;
	if (!run->face_count)
		return TCS_OK;
	if (array_grow(&extract->faces, MOST_EXTRACTED + BLOCK_BOXES) ||
		array_grow(&extract->blocks, MOST_EXTRACTED / BLOCK_BOXES + 1))
		return fault_memory(fault);
	walk_begin(&walk, run);
	while (walk.height > 0 && extract->faces.count <= MOST_EXTRACTED) {
		struct block_place at = walk.stack[--walk.height];
		const struct box_block *block =
			&boxes->blocks.at[walk.levels[at.level] + at.number];
		uint32_t first = BLOCK_BOXES * at.number;
		unsigned bits = block_meets(block, box);

		if (!at.level)
			extract_boxes(extract, block, bits,
				boxes->faces.at + run->first_face + first);
		else
			walk_down(&walk, at, bits);
	}
	extract->is_copy = extract->faces.count <= MOST_EXTRACTED;
	return TCS_OK;
}

enum tcs_status
face_extract_near(const struct face_extract *extract,
	const struct float_box *box, struct face_list *out,
	struct tcs_fault *fault)
{
	const uint32_t *faces = extract->faces.at;

	if (!extract->is_copy)
		return face_boxes_near(
			extract->boxes, extract->run, box, out, fault);
	out->count = 0;
	if (array_grow(out, MOST_EXTRACTED))
		return fault_memory(fault);
	for (size_t i = 0; i < extract->faces.count; i += BLOCK_BOXES) {
		const struct box_block *block =
			&extract->blocks.at[i / BLOCK_BOXES];
		unsigned bits = block_meets(block, box);

		for (size_t k = i; bits; bits >>= 1, k++)
			if (bits & 1)
				out->at[out->count++] = faces[k];
	}
	return TCS_OK;
}

void
face_extract_release(struct face_extract *extract)
{
	array_release(&extract->faces);
	array_release(&extract->blocks);
}
