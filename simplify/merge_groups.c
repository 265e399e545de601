#include "merge_groups.h"

#include <stdlib.h>

#include "face_directions.h"
#include "forest.h"

/* Metres that every part is taken to be larger by, so that thin ones count. */
#define PADDING 0.01

/* Parts that are joined so far, in the frame of all that touch. */
struct cluster {
	struct box box;
	double filled; /* cubic metres */
	uint32_t first, last; /* parts, see search.next */
	uint32_t count;
};

struct cluster_pair {
	uint32_t a, b; /* clusters, a < b */
};

struct search {
	struct merge_groups *groups;
	const struct collapses *work;
	const struct parts *parts;
	uint32_t *roots; /* per part: the first of those that touch */
	uint32_t *next; /* per part: of its cluster; TCS_NONE */
	uint32_t *places; /* per part: its cluster; then in groups->parts */
	TCS_ARRAY(struct queue_entry) sorted; /* parts, by their roots */
	TCS_ARRAY(struct cluster) clusters;
	TCS_ARRAY(struct cluster_pair) pairs;
	struct tcs_fault *fault;
};

/* ---- who touches whom ---------------------------------------------------- */

/* The surface of a closed part that has but one; TCS_NONE. */
static uint32_t
feature_of(const struct search *search, const struct part *part)
{
	const struct sheets *sheets = search->work->sheets;
	const uint32_t *faces = search->parts->faces.at + part->first;
	uint32_t feature = search->work->features.at[faces[0]];

	for (uint32_t i = 0; i < part->count; i++) {
		if (search->work->features.at[faces[i]] != feature)
			return TCS_NONE;
		for (int k = 0; k < 3; k++)
			if (sheets->opposites.at[3 * (size_t)faces[i] +
				    (size_t)k] == HALF_EDGE_NONE)
				return TCS_NONE;
	}
	return feature;
}

static void
join_links(struct search *search, uint32_t *features)
{
	const struct parts *parts = search->parts;

	for (uint32_t i = 0; i < parts->count; i++) {
		features[i] = feature_of(search, &parts->at.at[i]);
		search->roots[i] = i;
	}
	for (uint32_t i = 0; i < parts->count; i++) {
		const struct part *own = &parts->at.at[i];

		for (uint32_t k = 0; k < own->link_count; k++) {
			uint32_t other = parts->links.at[own->first_link + k];

			if (features[i] != TCS_NONE &&
				features[i] == features[other])
				forest_join(search->roots, i, other);
		}
	}
}

static int
by_root(const void *left, const void *right)
{
	const struct queue_entry *a = left, *b = right;

	if (a->cost < b->cost || b->cost < a->cost)
		return a->cost < b->cost ? -1 : 1;
	return (a->node > b->node) - (a->node < b->node);
}

/* Parts by what they touch. */
static enum tcs_status
sort_parts(struct search *search)
{
	size_t count = search->parts->count;
	uint32_t *features = calloc(count + 1, sizeof *features);

	if (!features || array_grow(&search->sorted, count + 1)) {
		free(features);
		return fault_memory(search->fault);
	}
	join_links(search, features);
	for (uint32_t i = 0; i < count; i++)
		if (features[i] != TCS_NONE)
			search->sorted.at[search->sorted.count++] =
				(struct queue_entry){
					forest_root(search->roots, i), i};
	if (search->sorted.count > 0)
		qsort(search->sorted.at, search->sorted.count,
			sizeof *search->sorted.at, by_root);
	free(features);
	return TCS_OK;
}

/* ---- boxes --------------------------------------------------------------- */

struct frame {
	struct tcs_point axes[3];
};

static struct tcs_point
any_across(struct tcs_point way)
{
	struct tcs_point across = vector_cross(way,
		fabs(way.z) < 0.9 ? (struct tcs_point){0, 0, 1}
				  : (struct tcs_point){1, 0, 0});

	return vector_scaled(across, 1 / vector_length(across));
}

/* Along most of the faces, and across. */
static struct frame
frame_of(const struct search *search, const struct queue_entry *own,
	size_t count)
{
	const struct collapses *work = search->work;
	struct face_directions directions = {0};
	struct frame frame = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

	for (size_t i = 0; i < count; i++) {
		const struct part *part = &search->parts->at.at[own[i].node];

		for (uint32_t k = 0; k < part->count; k++) {
			uint32_t face =
				search->parts->faces.at[part->first + k];
			struct triangle_shape shape =
				component_set_shape(work->set,
					work->sheets->face_triangles.at[face]);

			face_directions_add(&directions,
				work->sheets->normals.at[face],
				triangle_area(&shape));
		}
	}
	face_directions_sort(&directions);
	if (directions.count == 0)
		return frame;
	frame.axes[0] = directions.at[0].way;
	frame.axes[1] = any_across(frame.axes[0]);
	for (unsigned i = directions.count; i-- > 1;)
		if (fabs(vector_dot(frame.axes[0], directions.at[i].way)) <
			0.01)
			frame.axes[1] = directions.at[i].way;
	frame.axes[2] = vector_cross(frame.axes[0], frame.axes[1]);
	return frame;
}

static struct box
box_in(const struct search *search, const struct frame *frame, uint32_t number)
{
	const struct collapses *work = search->work;
	const struct part *part = &search->parts->at.at[number];
	struct box box = BOX_EMPTY;

	for (uint32_t i = 0; i < part->count; i++) {
		uint32_t face = search->parts->faces.at[part->first + i];
		struct triangle_shape shape = component_set_shape(
			work->set, work->sheets->face_triangles.at[face]);

		for (int k = 0; k < 3; k++)
			box_add_point(&box,
				(struct tcs_point){vector_dot(shape.corner[k],
							   frame->axes[0]),
					vector_dot(shape.corner[k],
						frame->axes[1]),
					vector_dot(shape.corner[k],
						frame->axes[2])});
	}
	return box;
}

static double
room_in(const struct box *box, double padding)
{
	double room = 1;

	for (int i = 0; i < 3; i++)
		room *= box->high[i] - box->low[i] + padding;
	return room;
}

static double
room_wasted(const struct cluster *a, const struct cluster *b)
{
	struct box both = a->box;

	box_add(&both, &b->box);
	return room_in(&both, PADDING) - room_in(&a->box, PADDING) -
		room_in(&b->box, PADDING);
}

/* ---- one set of parts that touch ----------------------------------------- */

static enum tcs_status
begin_clusters(
	struct search *search, const struct queue_entry *own, size_t count)
{
	struct frame frame = frame_of(search, own, count);

	search->clusters.count = 0;
	if (array_grow(&search->clusters, count))
		return fault_memory(search->fault);
	for (uint32_t i = 0; i < count; i++) {
		uint32_t part = own[i].node;
		const struct part *at = &search->parts->at.at[part];

		search->places[part] = i;
		search->next[part] = TCS_NONE;
		search->clusters.at[i] =
			(struct cluster){box_in(search, &frame, part),
				at->depth * at->area / 3, part, part, 1};
	}
	search->clusters.count = count;
	return TCS_OK;
}

static enum tcs_status
list_pairs(struct search *search, const struct queue_entry *own, size_t count)
{
	const struct parts *parts = search->parts;

	search->pairs.count = 0;
	for (uint32_t i = 0; i < count; i++) {
		const struct part *part = &parts->at.at[own[i].node];
		uint32_t root = forest_root(search->roots, own[i].node);

		if (array_grow(&search->pairs, part->link_count))
			return fault_memory(search->fault);
		for (uint32_t k = 0; k < part->link_count; k++) {
			uint32_t other = parts->links.at[part->first_link + k];

			if (forest_root(search->roots, other) == root &&
				search->places[other] > i)
				search->pairs.at[search->pairs.count++] =
					(struct cluster_pair){
						i, search->places[other]};
		}
	}
	return TCS_OK;
}

/* The pair that leaves the least room empty, the first of equal ones. */
static struct cluster_pair
best_pair(const struct search *search)
{
	struct cluster_pair best = search->pairs.at[0];
	double least = INFINITY;

	for (size_t i = 0; i < search->pairs.count; i++) {
		struct cluster_pair pair = search->pairs.at[i];
		double wasted = room_wasted(&search->clusters.at[pair.a],
			&search->clusters.at[pair.b]);

		if (wasted < least) {
			least = wasted;
			best = pair;
		}
	}
	return best;
}

/* The second becomes part of the first. */
static void
join(struct search *search, struct cluster_pair pair)
{
	struct cluster *a = &search->clusters.at[pair.a];
	const struct cluster *b = &search->clusters.at[pair.b];
	size_t kept = 0;

	search->next[a->last] = b->first;
	a->last = b->last;
	a->count += b->count;
	a->filled += b->filled;
	box_add(&a->box, &b->box);
	for (size_t i = 0; i < search->pairs.count; i++) {
		struct cluster_pair own = search->pairs.at[i];

		own.a = own.a == pair.b ? pair.a : own.a;
		own.b = own.b == pair.b ? pair.a : own.b;
		if (own.a != own.b)
			search->pairs.at[kept++] = own;
	}
	search->pairs.count = kept;
}

/* Groups know their first part until the order of all is known. */
static enum tcs_status
add_group(struct search *search, const struct cluster *cluster)
{
	struct merge_groups *groups = search->groups;

	if (array_grow(&groups->at, 1))
		return fault_memory(search->fault);
	groups->at.at[groups->at.count++] =
		(struct merge_group){cluster->first, cluster->count,
			fmax(0, room_in(&cluster->box, 0) - cluster->filled)};
	return TCS_OK;
}

static enum tcs_status
put_in_order(struct search *search, const struct cluster *all, size_t group)
{
	struct merge_groups *groups = search->groups;

	if (array_grow(&groups->parts, all->count))
		return fault_memory(search->fault);
	for (uint32_t part = all->first; part != TCS_NONE;
		part = search->next[part]) {
		search->places[part] = (uint32_t)groups->parts.count;
		groups->parts.at[groups->parts.count++] = part;
	}
	for (; group < groups->at.count; group++)
		groups->at.at[group].first =
			search->places[groups->at.at[group].first];
	return TCS_OK;
}

static enum tcs_status
nest(struct search *search, const struct queue_entry *own, size_t count)
{
	size_t first = search->groups->at.count;
	enum tcs_status status = begin_clusters(search, own, count);
	uint32_t all = 0;

	if (!status)
		status = list_pairs(search, own, count);
	while (!status && search->pairs.count > 0) {
		struct cluster_pair pair = best_pair(search);

		join(search, pair);
		all = pair.a;
		status = add_group(search, &search->clusters.at[all]);
	}
	return status ? status
		      : put_in_order(search, &search->clusters.at[all], first);
}

/* ---- all of them --------------------------------------------------------- */

static enum tcs_status
nest_all(struct search *search)
{
	enum tcs_status status = sort_parts(search);
	uint32_t *families = search->groups->families.at;

	for (size_t i = 0, end; !status && i < search->sorted.count; i = end) {
		const struct queue_entry *own = search->sorted.at + i;
		uint32_t root = forest_root(search->roots, own->node);

		for (end = i; end < search->sorted.count &&
			forest_root(search->roots,
				search->sorted.at[end].node) == root;)
			end++;
		if (end - i == 1 || end - i > MERGE_MOST_PARTS)
			continue;
		for (size_t k = i; k < end; k++)
			families[search->sorted.at[k].node] = root;
		status = nest(search, own, end - i);
	}
	return status;
}

enum tcs_status
merge_groups_find(struct merge_groups *groups, const struct collapses *work,
	const struct parts *parts, struct tcs_fault *fault)
{
	struct search search = {.groups = groups,
		.work = work,
		.parts = parts,
		.roots = calloc(parts->count + 1, sizeof(uint32_t)),
		.next = calloc(parts->count + 1, sizeof(uint32_t)),
		.places = calloc(parts->count + 1, sizeof(uint32_t)),
		.fault = fault};
	enum tcs_status status;

	array_clear(&groups->at);
	array_clear(&groups->parts);
	array_clear(&groups->families);
	if (!search.roots || !search.next || !search.places ||
		array_grow(&groups->families, parts->count)) {
		status = fault_memory(fault);
	} else {
		groups->families.count = parts->count;
		for (size_t i = 0; i < parts->count; i++)
			groups->families.at[i] = TCS_NONE;
		status = nest_all(&search);
	}
	free(search.roots);
	free(search.next);
	free(search.places);
	array_release(&search.sorted);
	array_release(&search.clusters);
	array_release(&search.pairs);
	return status;
}

void
merge_groups_release(struct merge_groups *groups)
{
	array_release(&groups->at);
	array_release(&groups->parts);
	array_release(&groups->families);
}
