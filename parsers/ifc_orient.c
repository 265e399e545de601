#include "ifc_orient.h"

#include <stdlib.h>

#include "solid_points.h"

struct side {
	uint32_t low, high; /* numbers of its points */
	uint32_t group;
	bool forwards; /* from low to high */
};

/* Groups that hang together: each knows its leader, and whether it agrees. */
struct agreement {
	uint32_t *leaders;
	bool *against;
	size_t count;
};

TCS_ARRAY_TYPE(sides, struct side);

static int
sides_compare(const void *a, const void *b)
{
	const struct side *left = a, *right = b;

	if (left->low != right->low)
		return left->low < right->low ? -1 : 1;
	if (left->high != right->high)
		return left->high < right->high ? -1 : 1;
	return left->group < right->group ? -1 : left->group > right->group;
}

/* The leader of a group; *against as the group is to it. */
static uint32_t
leader_of(const struct agreement *all, uint32_t group, bool *against)
{
	*against = false;
	while (all->leaders[group] != group) {
		*against ^= all->against[group];
		group = all->leaders[group];
	}
	return group;
}

static void
groups_join(struct agreement *all, uint32_t a, uint32_t b, bool differ)
{
	bool against_a, against_b;
	uint32_t leader = leader_of(all, a, &against_a);
	uint32_t other = leader_of(all, b, &against_b);

	if (leader == other)
		return;
	if (other < leader) {
		uint32_t swap = other;

		other = leader;
		leader = swap;
	}
	all->leaders[other] = leader;
	all->against[other] = against_a ^ against_b ^ differ;
}

static enum ifc_outcome
face_sides(const struct ifc_faces *faces, const struct ifc_face *face,
	const uint32_t *numbers, uint32_t group, struct sides *out)
{
	for (uint32_t k = 0; k < face->ring_count; k++) {
		uint32_t count = faces->rings.at[face->first_ring + k];

		if (array_grow(out, count))
			return IFC_NO_MEMORY;
		for (uint32_t i = 0; i < count; i++) {
			uint32_t a = numbers[i], b = numbers[(i + 1) % count];

			if (a != b)
				out->at[out->count++] =
					(struct side){a < b ? a : b,
						a < b ? b : a, group, a < b};
		}
		numbers += count;
	}
	return IFC_SHAPED;
}

static enum ifc_outcome
sides_list(const struct ifc_faces *faces, const uint32_t *groups,
	size_t group_count, struct sides *out)
{
	size_t first_point = faces->faces.at[groups[0]].first_point;
	struct solid_points points = {.distinct = 0};
	enum ifc_outcome outcome = IFC_SHAPED;
	struct tcs_fault fault;
	uint32_t group = 0;

	if (solid_points_number(&points, faces->points.at + first_point,
		    faces->points.count - first_point, &fault))
		outcome = IFC_NO_MEMORY;
	for (uint32_t i = groups[0]; i < faces->faces.count && !outcome; i++) {
		const struct ifc_face *face = faces->faces.at + i;

		while (group + 1 < group_count && groups[group + 1] <= i)
			group++;
		outcome = face_sides(faces, face,
			points.numbers.at + face->first_point - first_point,
			group, out);
	}
	solid_points_release(&points);
	return outcome;
}

/* Where two sides, and no more, are on one edge, their groups are to differ. */
static void
sides_agree(struct sides *sides, struct agreement *all)
{
	const struct side *at = sides->at;
	size_t next;

	qsort(sides->at, sides->count, sizeof *sides->at, sides_compare);
	for (size_t i = 0; i < sides->count; i = next) {
		next = i + 1;
		while (next < sides->count && at[next].low == at[i].low &&
			at[next].high == at[i].high)
			next++;
		if (next == i + 2 && at[i].group != at[i + 1].group)
			groups_join(all, at[i].group, at[i + 1].group,
				at[i].forwards == at[i + 1].forwards);
	}
}

static void
group_turn(struct ifc_faces *faces, size_t first, size_t end)
{
	for (size_t i = first; i < end; i++) {
		const struct ifc_face *face = faces->faces.at + i;
		struct tcs_point *points = faces->points.at + face->first_point;

		for (uint32_t k = 0; k < face->ring_count; k++) {
			uint32_t count = faces->rings.at[face->first_ring + k];

			ifc_ring_reverse(points, count);
			points += count;
		}
	}
}

/* Turn, of those with one leader, the groups that are fewer. */
static enum ifc_outcome
groups_turn(const struct agreement *all, const uint32_t *groups,
	struct ifc_faces *faces)
{
	int64_t *votes = calloc(all->count + 1, sizeof *votes);
	bool against;

	if (!votes)
		return IFC_NO_MEMORY;
	for (uint32_t i = 0; i < all->count; i++) {
		uint32_t leader = leader_of(all, i, &against);

		votes[leader] += against ? 1 : -1;
	}
	for (uint32_t i = 0; i < all->count; i++) {
		uint32_t leader = leader_of(all, i, &against);
		size_t end =
			i + 1 < all->count ? groups[i + 1] : faces->faces.count;

		if (against == (votes[leader] <= 0))
			group_turn(faces, groups[i], end);
	}
	free(votes);
	return IFC_SHAPED;
}

enum ifc_outcome
ifc_groups_orient(
	const uint32_t *groups, size_t group_count, struct ifc_faces *faces)
{
	struct agreement all = {
		.leaders = calloc(group_count + 1, sizeof *all.leaders),
		.against = calloc(group_count + 1, sizeof *all.against),
		.count = group_count};
	struct sides sides = {.count = 0};
	enum ifc_outcome outcome = IFC_SHAPED;

	if (!all.leaders || !all.against)
		outcome = IFC_NO_MEMORY;
	for (uint32_t i = 0; i < group_count && !outcome; i++)
		all.leaders[i] = i;
	if (!outcome && group_count && groups[0] < faces->faces.count) {
		outcome = sides_list(faces, groups, group_count, &sides);
		if (!outcome) {
			sides_agree(&sides, &all);
			outcome = groups_turn(&all, groups, faces);
		}
	}
	array_release(&sides);
	free(all.leaders);
	free(all.against);
	return outcome;
}
