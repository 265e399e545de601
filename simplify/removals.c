#include "removals.h"

#include <math.h>
#include <stdlib.h>

#include "removal_price.h"
#include "visible.h"

/* A contact is worth a square of this share of the object's diagonal as wide,
   off by that share of it. */
#define CONTACT_WIDTH 0.15
#define CONTACT_DEPTH 0.0075

/* Beyond this share of the diagonal from what stays the price rises steeply. */
#define FAR 0.004

/* From where it is looked at: see visible.h. */
#define LOWEST_VIEW (-0.1)

/* The shape of a component nothing of which is seen counts for so much when it
   collapses. */
#define HIDDEN_SHAPE 0.5F

/* On average over all sides a face in the open shows a quarter of its area. What
   is seen counts so many times as much. */
#define SHOWN_FACTOR 1.5

enum { VIEWS = 24 };

/* Pixels: pictures are as wide as the root of the number of triangles, but not
   less or more than so. */
enum { SMALLEST_VIEW = 64, LARGEST_VIEW = 2048 };

/* ---- in the queue -------------------------------------------------------- */

static enum tcs_status
judge(struct removals *removals, uint32_t number, struct tcs_fault *fault)
{
	double price;
	enum tcs_status status = removal_price(removals, number, &price, fault);

	removals->with_stack.at[number] = false;
	if (!status)
		node_queue_set(&removals->queue, number, price);
	return status;
}

/* ---- looking closer ------------------------------------------------------- */

/* Pixels of a picture: as many as there are triangles. */
static unsigned
picture_size(size_t triangles)
{
	double size = sqrt((double)triangles);

	return size < SMALLEST_VIEW   ? SMALLEST_VIEW
		: size < LARGEST_VIEW ? (unsigned)size
				      : LARGEST_VIEW;
}

/* The triangles as they are looked at. */
struct looked_at {
	uint32_t *groups; /* their parts */
	signed char *fronts; /* see visible.h */
	double *areas; /* that are seen of them */
};

static void
sort_triangles(const struct removals *removals, const struct looked_at *all)
{
	const struct component_set *set = removals->work->set;
	const struct parts *parts = &removals->parts;
	const uint32_t *faces = removals->work->sheets->triangle_faces.at;

	for (size_t i = 0; i < set->triangles.count; i++) {
		double volume = set->components.at[set->numbers.at[i]].volume;

		all->groups[i] = faces[i] == TCS_NONE
			? (uint32_t)parts->count
			: parts->numbers.at[faces[i]];
		all->fronts[i] = (signed char)((volume > 0) - (volume < 0));
	}
}

static enum tcs_status
see_triangles(const struct removals *removals, const struct looked_at *all,
	struct tcs_fault *fault)
{
	const struct component_set *set = removals->work->set;
	const struct visible_views views = {.directions = VIEWS,
		.lowest = LOWEST_VIEW,
		.size = picture_size(set->triangles.count),
		.jobs = set->jobs,
		.groups = all->groups,
		.group_count = removals->parts.count + 1,
		.fronts = all->fronts};

	sort_triangles(removals, all);
	return visible_find(set->points.at, set->points.count,
		set->triangles.at, set->triangles.count, &views, all->areas,
		fault);
}

/* What is seen of every part. */
static enum tcs_status
look_at_parts(struct removals *removals, struct tcs_fault *fault)
{
	const struct sheets *sheets = removals->work->sheets;
	size_t count = removals->work->set->triangles.count;
	struct looked_at all = {calloc(count + 1, sizeof *all.groups),
		calloc(count + 1, sizeof *all.fronts),
		calloc(count + 1, sizeof *all.areas)};
	enum tcs_status status = all.groups && all.fronts && all.areas
		? see_triangles(removals, &all, fault)
		: fault_memory(fault);

	for (size_t i = 0; !status && i < sheets->face_triangles.count; i++)
		removals->visible.at[removals->parts.numbers.at[i]] +=
			SHOWN_FACTOR * all.areas[sheets->face_triangles.at[i]];
	free(all.groups);
	free(all.fronts);
	free(all.areas);
	return status;
}

/* Contacts between components that are seen count for more. */
static enum tcs_status
weigh_contacts(
	struct removals *removals, const bool *seen, struct tcs_fault *fault)
{
	struct collapses *work = removals->work;
	size_t count = removals->list->count;

	if (array_grow(&work->worths, count + 1))
		return fault_memory(fault);
	for (size_t i = 0; i < count; i++) {
		const struct contact *own = &removals->list->at[i];

		work->worths.at[i] =
			seen[own->a] && seen[own->b] ? SEEN_FACTOR : 1;
	}
	work->worths.at[count] = 1; /* so that it is never empty */
	work->worths.count = count + 1;
	return TCS_OK;
}

/* Those that are not seen may lose their shape sooner. */
static enum tcs_status
weigh_shapes(
	struct removals *removals, const bool *seen, struct tcs_fault *fault)
{
	struct collapses *work = removals->work;
	size_t count = work->set->components.count;
	bool all = true;

	if (array_grow(&work->shares, count))
		return fault_memory(fault);
	for (size_t i = 0; i < count; i++) {
		work->shares.at[i] = seen[i] ? 1 : HIDDEN_SHAPE;
		all = all && seen[i];
	}
	if (all)
		return TCS_OK;
	work->shares.count = count;
	collapses_resume(work, &work->settings);
	return TCS_OK;
}

static enum tcs_status
weigh_components(struct removals *removals, struct tcs_fault *fault)
{
	const struct parts *parts = &removals->parts;
	size_t count = removals->work->set->components.count;
	bool *seen = calloc(count + 1, sizeof *seen);
	enum tcs_status status;

	if (!seen)
		return fault_memory(fault);
	for (size_t i = 0; i < parts->count; i++)
		seen[parts->at.at[i].component] |= removals->visible.at[i] > 0;
	status = weigh_contacts(removals, seen, fault);
	if (!status)
		status = weigh_shapes(removals, seen, fault);
	free(seen);
	return status;
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
	return status ? status : weigh_components(removals, fault);
}

static enum tcs_status
make_room(struct removals *removals, struct tcs_fault *fault)
{
	size_t contacts = removals->work->seams->counts.count;

	array_clear(&removals->held);
	array_clear(&removals->roots);
	array_clear(&removals->measured);
	array_clear(&removals->with_stack);
	if (array_grow(&removals->distances, removals->parts.count) ||
		array_grow(&removals->measured, removals->parts.count) ||
		array_grow(&removals->with_stack, removals->parts.count) ||
		array_grow(&removals->roots, removals->parts.count) ||
		array_grow(&removals->held, contacts))
		return fault_memory(fault);
	removals->held.count = contacts;
	for (size_t i = 0; i < contacts; i++)
		removals->held.at[i] = 0;
	for (size_t i = 0; i < removals->parts.count; i++) {
		removals->roots.at[i] = TCS_NONE;
		removals->measured.at[i] = removals->with_stack.at[i] = false;
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

		removals->measured.at[other] = false;
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
	removals->measured.at[host] = false;
	removals->roots.at[host] = TCS_NONE;
	return judge(removals, host, fault);
}

/* What was priced goes, what stands on others first. */
static enum tcs_status
take_stack(struct removals *removals, struct tcs_fault *fault)
{
	const struct parts *parts = &removals->parts;
	enum tcs_status status = TCS_OK;

	for (size_t i = parts->hanging.count; !status && i-- > 0;)
		status = removals_take(removals, parts->hanging.at[i], fault);
	return status;
}

/* With all that hangs in the air without it. */
static enum tcs_status
try_stack(struct removals *removals, struct queue_entry own,
	struct tcs_fault *fault)
{
	double price;
	enum tcs_status status =
		removal_stack_price(removals, own.node, &price, fault);

	if (status)
		return status;
	if (price <= own.cost)
		return take_stack(removals, fault);
	removals->with_stack.at[own.node] = true;
	node_queue_set(&removals->queue, own.node, price);
	return TCS_OK;
}

static enum tcs_status
try_alone(struct removals *removals, struct queue_entry own,
	struct tcs_fault *fault)
{
	double price;
	enum tcs_status status = removal_measure(removals, own.node, fault);

	if (!status)
		status = removal_price(removals, own.node, &price, fault);
	if (status)
		return status;
	if (price > own.cost) {
		node_queue_set(&removals->queue, own.node, price);
		return TCS_OK;
	}
	status = removals_take(removals, own.node, fault);
	return status || removals->parts.at.at[own.node].gone
		? status
		: try_stack(removals, own, fault);
}

enum tcs_status
removals_try(struct removals *removals, struct tcs_fault *fault)
{
	struct queue_entry first = *node_queue_first(&removals->queue);
	enum tcs_status status = removals_look(removals, fault);

	if (status)
		return status;
	return removals->with_stack.at[first.node]
		? try_stack(removals, first, fault)
		: try_alone(removals, first, fault);
}

void
removals_release(struct removals *removals)
{
	parts_release(&removals->parts);
	node_queue_release(&removals->queue);
	array_release(&removals->visible);
	array_release(&removals->distances);
	array_release(&removals->measured);
	array_release(&removals->with_stack);
	triangle_tree_release(&removals->tree);
	array_release(&removals->roots);
	array_release(&removals->items);
	array_release(&removals->contacts);
	array_release(&removals->held);
	array_release(&removals->runs);
	array_release(&removals->around);
}
