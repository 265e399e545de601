#include "seams.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

#include "number_sort.h"
#include "split_work.h"
#include "vector.h"

/* Metres: what is this near touches in an object of any size. */
#define TOUCHING 0.01

/* Planes this parallel are one. */
#define SAME_PLANE 0.999

enum { PAIRS = 128, PIECES = 16 }; /* looked at in one go, and at once */

/* Two components whose boxes meet. */
struct box_pair {
	uint32_t a, b; /* a < b */
};

/* What one piece of the work found. */
struct piece {
	struct touches touches;
	enum tcs_status status;
	struct tcs_fault fault;
};

struct search {
	struct touch_scene scene;
	struct seams *seams;
	struct contact_list *contacts;
	struct piece *pieces;
	TCS_ARRAY(struct touch_face) faces;
	TCS_ARRAY(uint32_t) others; /* scratch: beside one component */
	TCS_ARRAY(struct box_pair) pairs; /* by a, then b */
	uint32_t component; /* being looked around */
	bool failed; /* for want of memory */
	struct tcs_fault *fault;
};

/* ---- what is kept -------------------------------------------------------- */

static bool
is_known_plane(const struct search *search, const struct touch_plane *plane)
{
	const struct seams *seams = search->seams;
	const struct tcs_point *normals = search->scene.sheets->normals.at;

	for (uint32_t i = seams->nodes.at[plane->node]; i != TCS_NONE;
		i = seams->planes.at[i].next)
		if (seams->planes.at[i].component == plane->component &&
			fabs(vector_dot(normals[seams->planes.at[i].face],
				normals[plane->face])) > SAME_PLANE)
			return true;
	return false;
}

static enum tcs_status
keep_planes(struct search *search, const struct touches *touches)
{
	struct seams *seams = search->seams;

	for (size_t i = 0; i < touches->planes.count; i++) {
		const struct touch_plane *plane = &touches->planes.at[i];

		if (is_known_plane(search, plane))
			continue;
		if (array_grow(&seams->planes, 1))
			return fault_memory(search->fault);
		seams->planes.at[seams->planes.count] =
			(struct seam_plane){seams->nodes.at[plane->node],
				plane->component, plane->face};
		seams->nodes.at[plane->node] = (uint32_t)seams->planes.count++;
	}
	return TCS_OK;
}

static enum tcs_status
keep_place(struct search *search, const struct touch *touch, uint32_t contact)
{
	struct seams *seams = search->seams;
	double limit = touch->gap > TOUCHING
		? fmax(SEAM_LIMIT, SEAM_REACHES * search->scene.reach)
		: SEAM_LIMIT;

	if (array_grow(&seams->points, 1) || array_grow(&seams->holds, 2))
		return fault_memory(search->fault);
	seams->points.at[seams->points.count++] =
		(struct seam_point){touch->at, (float)limit, contact};
	seams->counts.at[contact].points++;
	for (uint32_t side = 0; side < 2; side++) {
		uint32_t hold = (uint32_t)seams->holds.count++;

		seams->holds.at[hold].face = TCS_NONE;
		seams_move_hold(seams, hold, touch->faces[side],
			(double)touch->offs[side]);
	}
	return TCS_OK;
}

static enum tcs_status
keep(struct search *search, const struct touches *touches)
{
	size_t count = touches->contacts.count, place = 0;
	enum tcs_status status = keep_planes(search, touches);

	if (!status &&
		(array_grow(search->contacts, count) ||
			array_grow(&search->seams->counts, count)))
		status = fault_memory(search->fault);
	for (size_t i = 0; !status && i < count; i++) {
		uint32_t contact = (uint32_t)search->contacts->count;

		search->contacts->at[search->contacts->count++] =
			touches->contacts.at[i];
		search->seams->counts.at[search->seams->counts.count++] =
			(struct seam_count){0, 0};
		for (; !status && place < touches->ends.at[i]; place++)
			status = keep_place(
				search, &touches->places.at[place], contact);
	}
	return status;
}

/* ---- pairs of components ------------------------------------------------- */

static void
look_at_some(void *context, size_t number, size_t first, size_t end)
{
	struct search *search = context;
	struct piece *piece = &search->pieces[number];

	piece->status = TCS_OK;
	touches_clear(&piece->touches);
	for (size_t i = first; !piece->status && i < end; i++)
		piece->status = touches_add(&piece->touches, &search->scene,
			search->pairs.at[i].a, search->pairs.at[i].b,
			&piece->fault);
}

static enum tcs_status
look_at_pairs(struct search *search)
{
	size_t pieces = split_pieces(search->pairs.count, PAIRS);
	enum tcs_status status = split_work(search->pairs.count, PAIRS,
		search->scene.set->jobs, look_at_some, search, search->fault);

	for (size_t i = 0; !status && i < pieces; i++) {
		status = search->pieces[i].status;
		if (status)
			*search->fault = search->pieces[i].fault;
		else
			status = keep(search, &search->pieces[i].touches);
	}
	search->pairs.count = 0;
	return status;
}

static bool
take_other(void *context, uint32_t position)
{
	struct search *search = context;
	const struct component_set *set = search->scene.set;
	uint32_t other = set->boxes.items.at[position];
	double reach = search->scene.reach;

	if (other <= search->component ||
		box_gap_squared(&set->components.at[other].box,
			&set->components.at[search->component].box) >
			reach * reach)
		return true;
	search->failed = array_grow(&search->others, 1);
	if (!search->failed)
		search->others.at[search->others.count++] = other;
	return !search->failed;
}

/* Every pair of components is looked at from the one with the lower number. */
static enum tcs_status
look_around(struct search *search, uint32_t component)
{
	const struct component_set *set = search->scene.set;
	enum tcs_status status = TCS_OK;

	search->component = component;
	search->others.count = 0;
	box_tree_near(&set->boxes, set->box_root,
		&set->components.at[component].box, search->scene.reach,
		take_other, search);
	if (search->failed)
		return fault_memory(search->fault);
	number_sort(search->others.at, search->others.count);
	for (size_t i = 0; !status && i < search->others.count; i++) {
		search->pairs.at[search->pairs.count++] =
			(struct box_pair){component, search->others.at[i]};
		if (search->pairs.count == (size_t)PAIRS * PIECES)
			status = look_at_pairs(search);
	}
	return status;
}

/* ---- all of it ----------------------------------------------------------- */

static enum tcs_status
clear(struct search *search)
{
	const struct sheets *sheets = search->scene.sheets;
	struct seams *seams = search->seams;
	size_t faces = sheets->face_triangles.count, nodes = sheets->node_count;
	enum tcs_status status;

	array_clear(search->contacts);
	array_clear(&seams->points);
	array_clear(&seams->holds);
	array_clear(&seams->faces);
	array_clear(&seams->counts);
	array_clear(&seams->planes);
	array_clear(&seams->nodes);
	if (array_grow(&seams->faces, faces) ||
		array_grow(&seams->nodes, nodes) ||
		array_grow(&search->faces, faces) ||
		array_grow(&search->pairs, (size_t)PAIRS * PIECES))
		return fault_memory(search->fault);
	/* TCS_NONE is all ones. */
	seams->faces.count = faces;
	seams->nodes.count = nodes;
	if (faces > 0) {
		memset(seams->faces.at, 0xff, faces * sizeof *seams->faces.at);
		memset(seams->nodes.at, 0xff, nodes * sizeof *seams->nodes.at);
	}
	search->scene.faces = search->faces.at;
	status = touch_faces_fill(
		search->faces.at, search->scene.set, sheets, search->fault);
	return status ? status
		      : face_boxes_build(&seams->boxes, search->scene.set,
				sheets, search->fault);
}

static void
search_release(struct search *search)
{
	for (size_t i = 0; search->pieces && i < PIECES; i++)
		touches_release(&search->pieces[i].touches);
	free(search->pieces);
	array_release(&search->faces);
	array_release(&search->others);
	array_release(&search->pairs);
}

enum tcs_status
seams_find(struct seams *seams, const struct component_set *set,
	const struct sheets *sheets, double reach,
	struct contact_list *contacts, struct tcs_fault *fault)
{
	struct search search = {
		.scene = {.set = set, .sheets = sheets, .reach = reach},
		.seams = seams,
		.contacts = contacts,
		.pieces = calloc(PIECES, sizeof *search.pieces),
		.fault = fault};
	enum tcs_status status =
		search.pieces ? clear(&search) : fault_memory(fault);

	search.scene.boxes = &seams->boxes;
	for (uint32_t i = 0; !status && i < set->components.count; i++)
		status = look_around(&search, i);
	if (!status)
		status = look_at_pairs(&search);
	search_release(&search);
	return status;
}

/* ---- holding ------------------------------------------------------------- */

static void
let_go(struct seams *seams, uint32_t hold)
{
	uint32_t *link = &seams->faces.at[seams->holds.at[hold].face];

	while (*link != hold)
		link = &seams->holds.at[*link].next;
	*link = seams->holds.at[hold].next;
}

void
seams_move_hold(struct seams *seams, uint32_t hold, uint32_t face, double off)
{
	struct seam_hold *moved = &seams->holds.at[hold];

	moved->off = (float)(off * (1 + FLT_EPSILON));
	if (moved->face == face)
		return;
	if (moved->face != TCS_NONE)
		let_go(seams, hold);
	moved->face = face;
	moved->next = TCS_NONE;
	if (face != TCS_NONE) {
		moved->next = seams->faces.at[face];
		seams->faces.at[face] = hold;
	}
}

void
seams_open(struct seams *seams, uint32_t point)
{
	seams_move_hold(seams, 2 * point, TCS_NONE, INFINITY);
	seams_move_hold(seams, 2 * point + 1, TCS_NONE, INFINITY);
	seams->counts.at[seams->points.at[point].contact].open++;
}

void
seams_forget(struct seams *seams, uint32_t point)
{
	struct seam_count *count =
		&seams->counts.at[seams->points.at[point].contact];

	seams_open(seams, point);
	count->open--;
	count->points--;
}

void
seams_release(struct seams *seams)
{
	array_release(&seams->points);
	array_release(&seams->holds);
	array_release(&seams->faces);
	array_release(&seams->counts);
	array_release(&seams->planes);
	array_release(&seams->nodes);
	face_boxes_release(&seams->boxes);
}
