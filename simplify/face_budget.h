/*
 * How many triangles of an object a level may keep.
 *
 * source: L, budget from structure (Liu, Li, Zhao, Liu, Texture feature
 * preserving simplification): a multiple of the sum of open edges, feature
 * lines and feature corners. A line is a sharp edge or a border between
 * surfaces. A corner has three edges or more, and two of them are lines that
 * do not run straight on into each other: else every vertex that divides a
 * line would be one.
 */
#ifndef TESSERA_FACE_BUDGET_H
#define TESSERA_FACE_BUDGET_H

#include "collapses.h"

enum budget_kind {
	BUDGET_RATE, /* amount: share of triangles that go, 0 to 1 */
	BUDGET_TRIANGLES, /* amount: triangles that stay */
	BUDGET_STRUCTURE, /* amount: the multiple */
	BUDGET_ERROR, /* none: as few as the largest error allows */
};

struct face_budget {
	enum budget_kind kind;
	double amount;
};

struct structure_counts {
	size_t open_edges, lines, corners;
};

/* Of the mesh as it came. Fails with TCS_NO_MEMORY. */
enum tcs_status structure_count(const struct collapses *work,
	struct structure_counts *out, struct tcs_fault *fault) TCS_CHECKED;

/* How many of the triangles the set has may stay. Fails with TCS_NO_MEMORY. */
enum tcs_status face_budget_find(const struct face_budget *budget,
	const struct collapses *work, size_t *faces,
	struct tcs_fault *fault) TCS_CHECKED;

#endif
