#include "inner_outlines.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "forest.h"
#include "vector.h"

/* A flat face is this flat: by its normals, and by metres. */
#define FLAT_COSINE 0.9998 /* 1 degree */
#define FLAT_HEIGHT 0.005

/* Square metres: an outline around less is rounding. */
#define LEAST_AREA 1e-4

struct search {
	struct inner_outlines *to;
	const struct component_set *set;
	const struct sheets *sheets;
	bool *rings; /* per face, for a flat one's first: it may have any */
	struct tcs_fault *fault;
};

static struct tcs_point
corner_place(const struct search *search, uint32_t corner)
{
	const struct sheets *sheets = search->sheets;
	uint32_t node = sheets->vertex_nodes.at[sheets->corners.at[corner]];

	return search->set->points.at[sheets->nodes.at[node].point];
}

static uint32_t
next_corner(uint32_t corner)
{
	return corner % 3 == 2 ? corner - 2 : corner + 1;
}

/* ---- flat faces ---------------------------------------------------------- */

/* Whether a face lies in the plane of the first of a flat one: its corner
   `apex` does, and so do the others, which are corners of that one, too. */
static bool
is_flat_with(const struct search *search, uint32_t first, uint32_t apex)
{
	struct tcs_point normal = search->sheets->normals.at[first];
	struct tcs_point own = search->sheets->normals.at[apex / 3];
	struct tcs_point from = corner_place(search, 3 * first);

	return !(vector_dot(own, own) > 0 &&
		       vector_dot(own, normal) < FLAT_COSINE) &&
		!(fabs(vector_dot(normal,
			  vector_difference(corner_place(search, apex),
				  from))) > FLAT_HEIGHT);
}

/* Where no edge joins faces of the flat one beside those that each was reached
   over, it is a disc, which has no inner outline. */
static void
spread(struct search *search, uint32_t first)
{
	struct inner_outlines *to = search->to;
	const uint32_t *opposites = search->sheets->opposites.at;
	size_t faces = 0, joined = 0;

	to->stack.count = 0;
	to->stack.at[to->stack.count++] = first;
	to->flats.at[first] = first;
	while (to->stack.count > 0) {
		uint32_t face = to->stack.at[--to->stack.count];

		faces++;
		for (uint32_t c = 3 * face; c < 3 * face + 3; c++) {
			uint32_t back = opposites[c], other = back / 3;

			if (back == HALF_EDGE_NONE)
				continue;
			if (to->flats.at[other] == TCS_NONE &&
				is_flat_with(search, first,
					next_corner(next_corner(back)))) {
				to->flats.at[other] = first;
				to->stack.at[to->stack.count++] = other;
			}
			joined += to->flats.at[other] == first;
		}
	}
	search->rings[first] = joined > 2 * (faces - 1);
}

static enum tcs_status
find_flats(struct search *search)
{
	struct inner_outlines *to = search->to;
	size_t faces = search->sheets->face_triangles.count;

	array_clear(&to->flats);
	array_clear(&to->stack);
	if (array_grow(&to->flats, faces) || array_grow(&to->stack, faces))
		return fault_memory(search->fault);
	to->flats.count = faces;
	for (size_t i = 0; i < faces; i++)
		to->flats.at[i] = TCS_NONE;
	for (uint32_t i = 0; i < faces; i++)
		if (to->flats.at[i] == TCS_NONE)
			spread(search, i);
	return TCS_OK;
}

/* ---- outlines ------------------------------------------------------------ */

static bool
is_outline(const struct search *search, uint32_t corner)
{
	uint32_t back = search->sheets->opposites.at[corner];
	const uint32_t *flats = search->to->flats.at;

	return back == HALF_EDGE_NONE || flats[back / 3] != flats[corner / 3];
}

/* The corner whose edge follows on the same outline. */
static uint32_t
next_on_outline(const struct search *search, uint32_t corner)
{
	corner = next_corner(corner);
	while (!is_outline(search, corner))
		corner = next_corner(search->sheets->opposites.at[corner]);
	return corner;
}

/* Twice what an outline goes around, against the normal where it is an inner
   one; 0 if any of it is open. Those seen are marked. */
static double
outline_area(const struct search *search, uint32_t first, bool *seen)
{
	struct tcs_point from = corner_place(search, first), sum = {0};
	uint32_t corner = first;
	bool open = false;

	do {
		struct tcs_point a =
			vector_difference(corner_place(search, corner), from);
		struct tcs_point b = vector_difference(
			corner_place(search, next_corner(corner)), from);

		open |= search->sheets->opposites.at[corner] == HALF_EDGE_NONE;
		seen[corner] = true;
		sum = vector_sum(sum, vector_cross(a, b));
		corner = next_on_outline(search, corner);
	} while (corner != first);
	return open ? 0
		    : vector_dot(sum,
			      search->sheets->normals
				      .at[search->to->flats.at[first / 3]]);
}

static void
cut_along(struct search *search, uint32_t first)
{
	uint32_t corner = first;

	do {
		search->to->cut.at[corner] = true;
		search->to->cut.at[search->sheets->opposites.at[corner]] = true;
		corner = next_on_outline(search, corner);
	} while (corner != first);
}

static enum tcs_status
find_outlines(struct search *search)
{
	struct inner_outlines *to = search->to;
	size_t corners = search->sheets->corners.count;
	bool *seen = calloc(corners + 1, sizeof *seen);

	array_clear(&to->outlines);
	array_clear(&to->cut);
	if (!seen || array_grow(&to->cut, corners)) {
		free(seen);
		return fault_memory(search->fault);
	}
	to->cut.count = corners;
	if (corners > 0)
		memset(to->cut.at, 0, corners * sizeof *to->cut.at);
	for (uint32_t i = 0; i < corners; i++) {
		if (!search->rings[to->flats.at[i / 3]] || seen[i] ||
			!is_outline(search, i) ||
			outline_area(search, i, seen) >= -2 * LEAST_AREA)
			continue;
		if (array_grow(&to->outlines, 1)) {
			free(seen);
			return fault_memory(search->fault);
		}
		to->outlines.at[to->outlines.count++] = i;
		cut_along(search, i);
	}
	free(seen);
	return TCS_OK;
}

/* ---- pieces -------------------------------------------------------------- */

static enum tcs_status
find_pieces(struct search *search)
{
	struct inner_outlines *to = search->to;
	const struct sheets *sheets = search->sheets;
	size_t faces = sheets->face_triangles.count;

	if (array_grow(&to->pieces, faces))
		return fault_memory(search->fault);
	to->pieces.count = faces;
	for (uint32_t i = 0; i < faces; i++)
		to->pieces.at[i] = i;
	for (uint32_t i = 0; i < 3 * faces; i++) {
		uint32_t back = sheets->opposites.at[i];

		if (back != HALF_EDGE_NONE && back > i && !to->cut.at[i])
			forest_join(to->pieces.at, i / 3, back / 3);
	}
	for (uint32_t i = 0; i < faces; i++)
		to->pieces.at[i] = forest_root(to->pieces.at, i);
	return TCS_OK;
}

/* A piece has one host and is none, or has none. */
static enum tcs_status
find_hosts(struct search *search)
{
	struct inner_outlines *to = search->to;
	size_t faces = search->sheets->face_triangles.count;
	bool *spoilt = calloc(faces + 1, sizeof *spoilt);

	if (!spoilt || array_grow(&to->hosts, faces)) {
		free(spoilt);
		return fault_memory(search->fault);
	}
	to->hosts.count = faces;
	for (size_t i = 0; i < faces; i++)
		to->hosts.at[i] = TCS_NONE;
	for (size_t i = 0; i < to->outlines.count; i++) {
		uint32_t corner = to->outlines.at[i];
		uint32_t host = to->pieces.at[corner / 3];
		uint32_t piece =
			to->pieces.at[search->sheets->opposites.at[corner] / 3];

		spoilt[piece] |= piece == host ||
			(to->hosts.at[piece] != TCS_NONE &&
				to->hosts.at[piece] != host);
		spoilt[host] = true;
		to->hosts.at[piece] = host;
	}
	for (size_t i = 0; i < faces; i++)
		if (spoilt[i])
			to->hosts.at[i] = TCS_NONE;
	free(spoilt);
	return TCS_OK;
}

enum tcs_status
inner_outlines_find(struct inner_outlines *outlines,
	const struct component_set *set, const struct sheets *sheets,
	struct tcs_fault *fault)
{
	struct search search = {.to = outlines,
		.set = set,
		.sheets = sheets,
		.rings = calloc(sheets->face_triangles.count + 1, sizeof(bool)),
		.fault = fault};
	enum tcs_status status =
		search.rings ? find_flats(&search) : fault_memory(fault);

	array_clear(&outlines->pieces);
	array_clear(&outlines->hosts);
	if (!status)
		status = find_outlines(&search);
	free(search.rings);
	if (status || !outlines->outlines.count)
		return status;
	status = find_pieces(&search);
	return status ? status : find_hosts(&search);
}

void
inner_outlines_release(struct inner_outlines *outlines)
{
	array_release(&outlines->pieces);
	array_release(&outlines->hosts);
	array_release(&outlines->flats);
	array_release(&outlines->outlines);
	array_release(&outlines->cut);
	array_release(&outlines->stack);
}
