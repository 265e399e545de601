#include "removals.h"

#include <math.h>
#include <stdlib.h>

#include "visible.h"

/* A contact is worth a square of this share of the object's diagonal as wide,
   off by that share of it. */
#define CONTACT_WIDTH 0.15
#define CONTACT_DEPTH 0.0075

/* A contact of which both sides are seen, or a surface that is, is worth so
   many times as much. */
#define SEEN_FACTOR 4

/* Beyond this share of the diagonal from what stays the price rises steeply. */
#define FAR 0.01

/* From where it is looked at: see visible.h. */
#define LOWEST_VIEW (-0.1)

enum { MOST_SAMPLES = 16, VIEWS = 24 };

/* Pixels: pictures are so wide, by the root of the number of triangles. */
enum { SMALLEST_VIEW = 64, LARGEST_VIEW = 2048, PER_ROOT = 2 };

/* ---- how far its surface is from what stays ------------------------------- */

/* A tree over the triangles of a part; grown when it is first asked for. */
static enum tcs_status
root_of(struct removals *removals, uint32_t part, uint32_t *root,
	struct tcs_fault *fault)
{
	const struct component_set *set = removals->work->set;
	const struct part *own = &removals->parts.at.at[part];
	const uint32_t *faces = removals->parts.faces.at + own->first;
	enum tcs_status status = TCS_OK;

	if (removals->roots.at[part] == TCS_NONE) {
		array_clear(&removals->items);
		if (array_grow(&removals->items, own->count))
			return fault_memory(fault);
		for (uint32_t i = 0; i < own->count; i++)
			removals->items.at[i] =
				removals->work->sheets->face_triangles
					.at[faces[i]];
		status = triangle_tree_add(&removals->tree, set->points.at,
			set->triangles.at, removals->items.at, own->count,
			&removals->roots.at[part], fault);
	}
	*root = removals->roots.at[part];
	return status;
}

enum tcs_status
removals_distance(struct removals *removals, uint32_t part,
	struct tcs_point from, double reach, double *distance,
	struct tcs_fault *fault)
{
	uint32_t root = TCS_NONE;
	enum tcs_status status = root_of(removals, part, &root, fault);

	if (!status)
		*distance = triangle_tree_nearest(
			&removals->tree, root, from, reach)
				    .distance;
	return status;
}

/* How far the surface of a part is from what stays of those linked to it. */
struct reaching {
	struct removals *removals;
	const struct part *own;
	uint32_t nearest; /* link: what was nearest to the last point */
	double most; /* of the points so far; INFINITY: none of them stays */
};

/* A point that is not farther than another was does not matter. As far as the
   part is long is as far as need be looked. */
static enum tcs_status
reach_from(struct reaching *reaching, struct tcs_point from,
	struct tcs_fault *fault)
{
	struct removals *removals = reaching->removals;
	const struct parts *parts = &removals->parts;
	uint32_t first = reaching->own->first_link;
	uint32_t count = reaching->own->link_count;
	uint32_t begin = reaching->nearest;
	double least = box_diagonal(&reaching->own->box);
	bool any = false;

	for (uint32_t i = 0; i < count; i++) {
		uint32_t link =
			begin + i < count ? begin + i : begin + i - count;
		uint32_t other = parts->links.at[first + link];
		enum tcs_status status;
		double distance;

		if (parts->at.at[other].gone)
			continue;
		any = true;
		status = removals_distance(
			removals, other, from, least, &distance, fault);
		if (status)
			return status;
		if (distance < least) {
			least = distance;
			reaching->nearest = link;
		}
		if (least <= reaching->most)
			return TCS_OK;
	}
	reaching->most = any ? least : INFINITY;
	return TCS_OK;
}

static enum tcs_status
distance_of(struct removals *removals, const struct part *own, double *distance,
	struct tcs_fault *fault)
{
	const struct collapses *work = removals->work;
	struct reaching reaching = {.removals = removals, .own = own};
	uint32_t step = own->count / MOST_SAMPLES + 1;
	enum tcs_status status = TCS_OK;

	for (uint32_t i = 0; !status && i < own->count; i += step) {
		uint32_t face = removals->parts.faces.at[own->first + i];
		struct triangle_shape shape = component_set_shape(
			work->set, work->sheets->face_triangles.at[face]);

		status = reach_from(&reaching, triangle_centre(&shape), fault);
		for (int k = 0; !status && k < 3; k++)
			status = reach_from(&reaching, shape.corner[k], fault);
	}
	*distance = reaching.most;
	return status;
}

/* Nothing that stays comes nearer: what was found out holds until something goes
   that a part is linked to. */
static enum tcs_status
know_distance(struct removals *removals, uint32_t part, struct tcs_fault *fault)
{
	double distance;
	enum tcs_status status;

	if (removals->asked.at[part])
		return TCS_OK;
	status = distance_of(
		removals, &removals->parts.at.at[part], &distance, fault);
	if (status)
		return status;
	removals->asked.at[part] = true;
	removals->distances.at[part] =
		fmax(removals->distances.at[part], distance);
	return TCS_OK;
}

/* ---- what breaks --------------------------------------------------------- */

/* The contacts of the points that a part holds, and how many of each. */
static enum tcs_status
list_contacts(struct removals *removals, const struct part *part,
	struct tcs_fault *fault)
{
	const struct seams *seams = removals->work->seams;

	removals->contacts.count = 0;
	for (uint32_t i = 0; i < part->count; i++) {
		uint32_t face = removals->parts.faces.at[part->first + i];

		for (uint32_t hold = seams->faces.at[face]; hold != TCS_NONE;
			hold = seams->holds.at[hold].next) {
			uint32_t contact = seams->points.at[hold / 2].contact;

			if (removals->held.at[contact]++)
				continue;
			if (array_grow(&removals->contacts, 1))
				return fault_memory(fault);
			removals->contacts.at[removals->contacts.count++] =
				contact;
		}
	}
	return TCS_OK;
}

/* For how many a contact counts, as far as that is known. */
static double
worth_of(const struct removals *removals, uint32_t contact)
{
	const struct collapses *work = removals->work;

	return work->worths.count > 0 ? (double)work->worths.at[contact] : 1;
}

/* How many contacts break, by their worth, and parts of contacts as parts. The
   list is used up. */
static double
count_broken(struct removals *removals, const struct part *part)
{
	const struct seams *seams = removals->work->seams;
	double broken = 0;

	for (size_t i = 0; i < removals->contacts.count; i++) {
		uint32_t contact = removals->contacts.at[i];
		const struct seam_count *count = &seams->counts.at[contact];
		uint32_t open = count->open + removals->held.at[contact];

		removals->held.at[contact] = 0;
		broken += (seam_broken(count, open) -
				  seam_broken(count, count->open)) *
			worth_of(removals, contact);
	}
	removals->contacts.count = 0;
	if (removals->parts.left.at[part->component] == 1)
		broken += removals->parts.enclosed.at[part->component];
	return broken;
}

/* How many surfaces have no face outside of a part: those of its faces are
   together, as a rule. */
static double
count_vanishing(const struct removals *removals, const struct part *part)
{
	const struct collapses *work = removals->work;
	double vanishing = 0;
	uint32_t faces = 0, corners[3];

	for (uint32_t i = 0; i < part->count; i++) {
		uint32_t face = removals->parts.faces.at[part->first + i];
		uint32_t feature = work->features.at[face];

		if (i > 0 &&
			feature !=
				work->features.at[removals->parts.faces
							  .at[part->first + i -
								  1]])
			faces = 0;
		if (!half_edges_corners(work->mesh, face, corners))
			continue;
		vanishing += ++faces == work->surfaces.at[feature];
	}
	return vanishing;
}

/* ---- the price ----------------------------------------------------------- */

uint32_t
removals_faces(const struct removals *removals, uint32_t number)
{
	const struct part *part = &removals->parts.at.at[number];
	uint32_t count = 0, corners[3];

	for (uint32_t i = 0; i < part->count; i++)
		count += half_edges_corners(removals->work->mesh,
			removals->parts.faces.at[part->first + i], corners);
	return count;
}

/* With what is known so far of how far it is and how much of it is seen. */
static enum tcs_status
price_of(struct removals *removals, uint32_t number, double *price,
	struct tcs_fault *fault)
{
	const struct part *part = &removals->parts.at.at[number];
	double distance = removals->distances.at[number];
	double visible =
		removals->visible.count ? removals->visible.at[number] : 0;
	double allowed = removals->work->settings.max_error;
	uint32_t faces = removals_faces(removals, number);
	enum tcs_status status;
	double broken, covered = 0;

	*price = INFINITY;
	if (!faces || distance == INFINITY ||
		(allowed > 0 && distance > allowed))
		return TCS_OK;
	status = cover_watch_worth(removals->work,
		removals->parts.faces.at + part->first, part->count, &covered,
		fault);
	if (!status)
		status = list_contacts(removals, part, fault);
	if (status)
		return status;
	broken = covered + count_broken(removals, part) +
		count_vanishing(removals, part) *
			(visible > 0 ? SEEN_FACTOR : 1);
	*price = (fmax(visible, HIDDEN_SHARE * part->area) *
				 removals_steep(removals, distance) +
			 broken * removals->contact_cost) /
		(0.5 * faces);
	return TCS_OK;
}

static enum tcs_status
judge(struct removals *removals, uint32_t number, struct tcs_fault *fault)
{
	double price;
	enum tcs_status status = price_of(removals, number, &price, fault);

	if (!status)
		node_queue_set(&removals->queue, number, price);
	return status;
}

/* ---- looking closer ------------------------------------------------------- */

/* Pixels of a picture: some for each triangle. */
static unsigned
picture_size(size_t triangles)
{
	double size = PER_ROOT * sqrt((double)triangles);

	return size < SMALLEST_VIEW   ? SMALLEST_VIEW
		: size < LARGEST_VIEW ? (unsigned)size
				      : LARGEST_VIEW;
}

/* areas[i] is what is seen of triangle i; groups is scratch. */
static enum tcs_status
look_at_triangles(const struct removals *removals, uint32_t *groups,
	double *areas, struct tcs_fault *fault)
{
	const struct component_set *set = removals->work->set;
	const struct parts *parts = &removals->parts;
	const uint32_t *faces = removals->work->sheets->triangle_faces.at;
	const struct visible_views views = {.directions = VIEWS,
		.lowest = LOWEST_VIEW,
		.size = picture_size(set->triangles.count),
		.jobs = set->jobs,
		.groups = groups,
		.group_count = parts->count + 1};

	for (size_t i = 0; i < set->triangles.count; i++)
		groups[i] = faces[i] == TCS_NONE ? (uint32_t)parts->count
						 : parts->numbers.at[faces[i]];
	return visible_find(set->points.at, set->points.count,
		set->triangles.at, set->triangles.count, &views, areas, fault);
}

/* The mean area, as projected, that is seen of every part. */
static enum tcs_status
look_at_parts(struct removals *removals, struct tcs_fault *fault)
{
	const struct sheets *sheets = removals->work->sheets;
	size_t count = removals->work->set->triangles.count;
	double *areas = calloc(count + 1, sizeof *areas);
	uint32_t *groups = calloc(count + 1, sizeof *groups);
	enum tcs_status status = areas && groups
		? look_at_triangles(removals, groups, areas, fault)
		: fault_memory(fault);

	for (size_t i = 0; !status && i < sheets->face_triangles.count; i++)
		removals->visible.at[removals->parts.numbers.at[i]] +=
			areas[sheets->face_triangles.at[i]];
	free(areas);
	free(groups);
	return status;
}

/* Contacts between components that are seen count for more. */
static enum tcs_status
weigh_contacts(struct removals *removals, struct tcs_fault *fault)
{
	const struct parts *parts = &removals->parts;
	struct collapses *work = removals->work;
	size_t count = removals->list->count;
	bool *seen = calloc(work->set->components.count + 1, sizeof *seen);

	if (!seen || array_grow(&work->worths, count + 1)) {
		free(seen);
		return fault_memory(fault);
	}
	for (size_t i = 0; i < parts->count; i++)
		seen[parts->at.at[i].component] |= removals->visible.at[i] > 0;
	for (size_t i = 0; i < count; i++) {
		const struct contact *own = &removals->list->at[i];

		work->worths.at[i] =
			seen[own->a] && seen[own->b] ? SEEN_FACTOR : 1;
	}
	work->worths.at[count] = 1; /* so that it is never empty */
	work->worths.count = count + 1;
	free(seen);
	return TCS_OK;
}

static enum tcs_status
find_visible(struct removals *removals, struct tcs_fault *fault)
{
	size_t count = removals->parts.count;
	enum tcs_status status = TCS_OK;

	if (array_grow(&removals->visible, count))
		return fault_memory(fault);
	removals->visible.count = count;
	for (size_t i = 0; i < count; i++)
		removals->visible.at[i] =
			removals->all_seen ? removals->parts.at.at[i].area : 0;
	if (!removals->all_seen)
		status = look_at_parts(removals, fault);
	return status ? status : weigh_contacts(removals, fault);
}

static enum tcs_status
make_room(struct removals *removals, struct tcs_fault *fault)
{
	size_t contacts = removals->work->seams->counts.count;

	array_clear(&removals->held);
	array_clear(&removals->roots);
	array_clear(&removals->asked);
	if (array_grow(&removals->distances, removals->parts.count) ||
		array_grow(&removals->asked, removals->parts.count) ||
		array_grow(&removals->roots, removals->parts.count) ||
		array_grow(&removals->held, contacts))
		return fault_memory(fault);
	removals->held.count = contacts;
	for (size_t i = 0; i < contacts; i++)
		removals->held.at[i] = 0;
	for (size_t i = 0; i < removals->parts.count; i++) {
		removals->roots.at[i] = TCS_NONE;
		removals->asked.at[i] = false;
	}
	return TCS_OK;
}

double
contact_cost(const struct component_set *set)
{
	double diagonal = box_diagonal(&set->bounds);
	double side = CONTACT_WIDTH * diagonal, off = CONTACT_DEPTH * diagonal;

	return side * side * off * off;
}

enum tcs_status
removals_begin(struct removals *removals, struct collapses *work,
	const struct contact_list *contacts, double reach, bool all_seen,
	struct tcs_fault *fault)
{
	enum tcs_status status;

	removals->work = work;
	removals->list = contacts;
	removals->all_seen = all_seen;
	removals->reach = reach;
	removals->far = FAR * box_diagonal(&work->set->bounds);
	removals->contact_cost = contact_cost(work->set);
	array_clear(&removals->visible);
	triangle_tree_release(&removals->tree);
	status = parts_find(&removals->parts, work->set, work->sheets,
		work->seams, contacts, reach, fault);
	if (!status)
		status = node_queue_reset(
			&removals->queue, removals->parts.count, fault);
	if (!status)
		status = make_room(removals, fault);
	for (uint32_t i = 0; !status && i < removals->parts.count; i++) {
		removals->distances.at[i] = removals->parts.at.at[i].depth;
		status = judge(removals, i, fault);
	}
	return status;
}

double
removals_next_cost(const struct removals *removals)
{
	const struct queue_entry *first = node_queue_first(&removals->queue);

	return first ? first->cost : INFINITY;
}

/* ---- taking away --------------------------------------------------------- */

/* Those linked to a part that is gone have fewer contacts now. One with many
   links is judged when its turn comes, or judging would take too long. */
static enum tcs_status
judge_linked(struct removals *removals, uint32_t gone, struct tcs_fault *fault)
{
	const struct parts *parts = &removals->parts;
	const struct part *own = &parts->at.at[gone];
	enum tcs_status status = TCS_OK;

	for (uint32_t i = 0; !status && i < own->link_count; i++) {
		uint32_t other = parts->links.at[own->first_link + i];

		removals->asked.at[other] = false;
		if (!parts->at.at[other].gone &&
			parts->at.at[other].link_count <= MOST_LINKS)
			status = judge(removals, other, fault);
	}
	return status;
}

enum tcs_status
removals_take(
	struct removals *removals, uint32_t number, struct tcs_fault *fault)
{
	const struct part *part = &removals->parts.at.at[number];
	enum tcs_status status;
	bool gone;

	node_queue_set(&removals->queue, number, INFINITY);
	status = parts_take_away(&removals->parts, number, &gone, fault);
	if (status || !gone)
		return status;
	status = collapses_take_away(removals->work,
		removals->parts.faces.at + part->first, part->count, fault);
	return status ? status : judge_linked(removals, number, fault);
}

enum tcs_status
removals_look(struct removals *removals, struct tcs_fault *fault)
{
	if (removals->visible.count > 0)
		return TCS_OK;
	return find_visible(removals, fault);
}

enum tcs_status
removals_hide(struct removals *removals, uint32_t part, struct tcs_fault *fault)
{
	removals->visible.at[part] = 0;
	return removals->parts.at.at[part].gone ? TCS_OK
						: judge(removals, part, fault);
}

enum tcs_status
removals_join(struct removals *removals, const uint32_t *parts, size_t count,
	uint32_t host, struct tcs_fault *fault)
{
	double visible = 0;

	for (size_t i = 0; i < count; i++) {
		visible += removals->visible.at[parts[i]];
		node_queue_set(&removals->queue, parts[i], INFINITY);
	}
	removals->visible.at[host] = visible;
	removals->distances.at[host] = removals->parts.at.at[host].depth;
	removals->asked.at[host] = false;
	removals->roots.at[host] = TCS_NONE;
	return judge(removals, host, fault);
}

enum tcs_status
removals_try(struct removals *removals, struct tcs_fault *fault)
{
	struct queue_entry first = *node_queue_first(&removals->queue);
	enum tcs_status status = removals_look(removals, fault);
	double price;

	if (!status)
		status = know_distance(removals, first.node, fault);
	if (!status)
		status = price_of(removals, first.node, &price, fault);
	if (status)
		return status;
	if (price > first.cost) {
		node_queue_set(&removals->queue, first.node, price);
		return TCS_OK;
	}
	return removals_take(removals, first.node, fault);
}

void
removals_release(struct removals *removals)
{
	parts_release(&removals->parts);
	node_queue_release(&removals->queue);
	array_release(&removals->visible);
	array_release(&removals->distances);
	array_release(&removals->asked);
	triangle_tree_release(&removals->tree);
	array_release(&removals->roots);
	array_release(&removals->items);
	array_release(&removals->contacts);
	array_release(&removals->held);
}
