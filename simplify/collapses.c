#include "placement.h"

#include <stdlib.h>
#include <string.h>

/* ---- beginning ----------------------------------------------------------- */

/* How many of the faces that are left each feature has. */
static enum tcs_status
count_surfaces(struct collapses *work, struct tcs_fault *fault)
{
	uint32_t most = 0, corners[3];

	for (size_t i = 0; i < work->features.count; i++)
		if (work->features.at[i] > most)
			most = work->features.at[i];
	array_clear(&work->surfaces);
	if (array_grow(&work->surfaces, (size_t)most + 1))
		return fault_memory(fault);
	work->surfaces.count = (size_t)most + 1;
	memset(work->surfaces.at, 0,
		work->surfaces.count * sizeof *work->surfaces.at);
	for (uint32_t i = 0; i < work->features.count; i++)
		if (half_edges_corners(work->mesh, i, corners))
			work->surfaces.at[work->features.at[i]]++;
	return TCS_OK;
}

/* The surface of every face, as it came. */
static enum tcs_status
copy_features(struct collapses *work, struct tcs_fault *fault)
{
	const struct sheets *sheets = work->sheets;

	array_clear(&work->sources);
	array_clear(&work->features);
	if (array_grow(&work->features, work->face_count))
		return fault_memory(fault);
	for (size_t i = 0; i < work->face_count; i++)
		work->features.at[i] =
			work->set->features.at[sheets->face_triangles.at[i]];
	work->features.count = work->face_count;
	return count_surfaces(work, fault);
}

static enum tcs_status
make_room(struct collapses *work, struct tcs_fault *fault)
{
	size_t nodes = work->sheets->node_count;

	array_clear(&work->positions);
	array_clear(&work->quadrics);
	array_clear(&work->border_places);
	array_clear(&work->areas);
	array_clear(&work->targets);
	if (array_grow(&work->positions, nodes) ||
		array_grow(&work->quadrics, nodes) ||
		array_grow(&work->border_places, nodes) ||
		array_grow(&work->areas, nodes) ||
		array_grow(&work->targets, nodes))
		return fault_memory(fault);
	work->positions.count = work->quadrics.count =
		work->border_places.count = work->areas.count =
			work->targets.count = nodes;
	return node_queue_reset(&work->queue, nodes, fault);
}

enum tcs_status
spokes_of(struct collapses *work, uint32_t vertex, size_t *count,
	struct tcs_fault *fault)
{
	*count = half_edges_spokes(
		work->mesh, vertex, work->spokes.at, work->spokes.room);
	if (*count <= work->spokes.room)
		return TCS_OK;
	if (array_grow(&work->spokes, *count))
		return fault_memory(fault);
	*count = half_edges_spokes(
		work->mesh, vertex, work->spokes.at, work->spokes.room);
	return TCS_OK;
}

/* ---- the best target of a node -------------------------------------------- */

static enum tcs_status
add_candidate(struct collapses *work, uint32_t node, uint32_t target,
	struct tcs_fault *fault)
{
	double cost = placement_cost(work, node, target, INFINITY);

	if (!(cost < INFINITY))
		return TCS_OK;
	if (array_grow(&work->candidates, 1))
		return fault_memory(fault);
	work->candidates.at[work->candidates.count++] =
		(struct queue_entry){cost, target};
	return TCS_OK;
}

/* The neighbours of the first vertex that a node still has; whether the others
   have them, too, is found when one is tried. */
static enum tcs_status
find_candidates(struct collapses *work, uint32_t node, struct tcs_fault *fault)
{
	const struct sheet_node *fans = &work->sheets->nodes.at[node];
	enum tcs_status status = TCS_OK;
	uint32_t end = fans[1].first_vertex;
	size_t count = 0;

	work->candidates.count = 0;
	for (uint32_t v = fans[0].first_vertex; !status && !count && v < end;
		v++)
		status = spokes_of(work, v, &count, fault);
	for (size_t i = 0; !status && i < count; i++) {
		uint32_t target = node_of(work, work->spokes.at[i].to);

		if (target != node)
			status = add_candidate(work, node, target, fault);
	}
	return status;
}

static int
by_cost(const void *left, const void *right)
{
	return queue_entry_leads(left, right) ? -1
					      : queue_entry_leads(right, left);
}

static void
aim(struct collapses *work, uint32_t node, struct queue_entry at)
{
	work->targets.at[node] = at.node;
	node_queue_set(&work->queue, node, at.cost);
}

/* Aim at the cheapest neighbour, fine or not. */
enum tcs_status
collapses_judge(struct collapses *work, uint32_t node, struct tcs_fault *fault)
{
	uint32_t vertex = work->sheets->nodes.at[node].first_vertex;
	size_t count;
	enum tcs_status status = spokes_of(work, vertex, &count, fault);

	if (!status)
		aim(work, node, placement_cheapest(work, node, count));
	return status;
}

/* What the collapse that was just found fine costs with what it strains and
   breaks. */
static double
full_cost(const struct collapses *work, double cost)
{
	if (work->is_strained)
		cost *= STRAIN_PENALTY;
	if (work->broken > 0)
		cost += work->broken * work->settings.contact_cost;
	return cost;
}

/* Aim at the cheapest neighbour that is fine, at its full cost; what `known` is
   aimed at costs as much as it says. */
static enum tcs_status
judge_again(struct collapses *work, uint32_t node, struct queue_entry known,
	struct tcs_fault *fault)
{
	struct queue_entry best = {INFINITY, TCS_NONE};
	enum tcs_status status = find_candidates(work, node, fault);

	if (!status && work->candidates.count > 0)
		qsort(work->candidates.at, work->candidates.count,
			sizeof *work->candidates.at, by_cost);
	for (size_t i = 0; !status && i < work->candidates.count; i++) {
		struct queue_entry there = work->candidates.at[i];
		bool fine;

		if (there.cost >= best.cost)
			break;
		if (there.node == known.node) {
			there = known;
			fine = known.cost < INFINITY;
		} else {
			status = placement_check(
				work, node, there.node, &fine, fault);
			there.cost = full_cost(work, there.cost);
		}
		if (!status && fine && queue_entry_leads(&there, &best))
			best = there;
	}
	aim(work, node, best);
	return status;
}

/* ---- the loop ------------------------------------------------------------ */

/* A neighbour of a node that went into `target`: it can go there, too, now. */
static enum tcs_status
update(struct collapses *work, uint32_t node, uint32_t gone, uint32_t target,
	struct tcs_fault *fault)
{
	uint32_t aimed = work->targets.at[node];
	struct queue_entry there, now;

	if (aimed == TCS_NONE || aimed == gone)
		return collapses_judge(work, node, fault);
	now = work->queue.heap.at[work->queue.places.at[node]];
	now.node = aimed;
	there = (struct queue_entry){
		placement_cost(work, node, target, now.cost), target};
	if (queue_entry_leads(&there, &now))
		aim(work, node, there);
	return TCS_OK;
}

/* What a node costs its neighbours has changed, for it has moved. */
static enum tcs_status
judge_around(struct collapses *work, uint32_t node, struct tcs_fault *fault)
{
	uint32_t vertex = work->sheets->nodes.at[node].first_vertex;
	size_t count;
	enum tcs_status status = spokes_of(work, vertex, &count, fault);

	work->touched.count = 0;
	if (!status && array_grow(&work->touched, count))
		return fault_memory(fault);
	for (size_t i = 0; !status && i < count; i++)
		work->touched.at[work->touched.count++] =
			node_of(work, work->spokes.at[i].to);
	for (size_t i = 0; !status && i < work->touched.count; i++)
		status = collapses_judge(work, work->touched.at[i], fault);
	return status;
}

static enum tcs_status
collapse(struct collapses *work, uint32_t node, uint32_t target,
	struct tcs_fault *fault)
{
	enum tcs_status status = placement_do(work, node, target, fault);

	aim(work, node, (struct queue_entry){INFINITY, TCS_NONE});
	for (size_t i = 0; !status && i < work->touched.count; i++) {
		uint32_t other = work->touched.at[i];

		if (other == target)
			status = collapses_judge(work, other, fault);
		else if (other != node)
			status = update(work, other, node, target, fault);
	}
	if (!status && work->settings.optimal)
		status = judge_around(work, target, fault);
	return status;
}

/* Try the first of the queue: collapse it if it costs no more than it seemed
   to. */
static enum tcs_status
try_first(struct collapses *work, struct tcs_fault *fault)
{
	struct queue_entry first = *node_queue_first(&work->queue);
	uint32_t target = work->targets.at[first.node];
	struct queue_entry known = {INFINITY, target};
	bool fine;
	enum tcs_status status =
		placement_check(work, first.node, target, &fine, fault);

	if (status)
		return status;
	if (fine)
		known.cost = work->broken > 0 || work->is_strained
			? full_cost(work,
				  placement_cost(
					  work, first.node, target, INFINITY))
			: first.cost;
	/* Without worths the price is less than it is. */
	work->wants_worths = known.cost <= first.cost && work->breaks_contact &&
		work->worths.count == 0;
	if (work->wants_worths)
		return TCS_OK;
	return known.cost <= first.cost
		? collapse(work, first.node, target, fault)
		: judge_again(work, first.node, known, fault);
}

/* Unless that is done. */
static enum tcs_status
judge_all(struct collapses *work, struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	if (!work->is_stale)
		return TCS_OK;
	for (uint32_t i = 0; !status && i < work->sheets->node_count; i++)
		status = collapses_judge(work, i, fault);
	work->is_stale = status != TCS_OK;
	return status;
}

enum tcs_status
collapses_run(struct collapses *work, size_t faces, double dearest,
	struct tcs_fault *fault)
{
	const struct queue_entry *first;
	enum tcs_status status = judge_all(work, fault);

	work->wants_worths = false;
	while (!status && !work->wants_worths && work->face_count > faces &&
		(first = node_queue_first(&work->queue)) &&
		first->cost < dearest)
		status = try_first(work, fault);
	return status;
}

void
collapses_resume(
	struct collapses *work, const struct collapse_settings *settings)
{
	work->settings = *settings;
	work->is_stale = true;
}

enum tcs_status
collapses_dissolve(
	struct collapses *work, const uint32_t *homes, struct tcs_fault *fault)
{
	enum tcs_status status;

	for (size_t i = 0; i < work->features.count; i++)
		work->features.at[i] = homes[work->features.at[i]];
	status = count_surfaces(work, fault);
	return status ? status : collapses_weigh_borders(work, fault);
}

enum tcs_status
collapses_begin(struct collapses *work, const struct component_set *set,
	struct sheets *sheets, struct seams *seams,
	const struct collapse_regions *regions,
	const struct collapse_settings *settings, struct tcs_fault *fault)
{
	enum tcs_status status;

	work->set = set;
	work->sheets = sheets;
	work->seams = seams;
	work->regions = *regions;
	work->ground = set->bounds.low[2] + contact_reach(set);
	work->face_count = sheets->face_triangles.count;
	array_clear(&work->worths);
	array_clear(&work->shares);
	cover_watch_clear(&work->covers);
	half_edges_free(work->mesh);
	work->mesh = NULL;
	status = half_edges_new(&work->mesh, sheets->corners.at,
		sheets->opposites.at, work->face_count,
		sheets->vertex_nodes.count, fault);
	if (!status)
		status = make_room(work, fault);
	if (!status)
		status = copy_features(work, fault);
	if (!status)
		status = error_watch_begin(&work->watch,
			settings->max_error > 0 ? settings->max_error
						: INFINITY,
			set, sheets, fault);
	if (!status)
		status = crossing_watch_begin(&work->crossings, work, fault);
	if (!status)
		status = volume_watch_begin(&work->volume, set, fault);
	if (!status && settings->optimal)
		status = placement_begin(work, fault);
	if (status)
		return status;
	collapses_resume(work, settings);
	collapses_weigh(work);
	return collapses_weigh_borders(work, fault);
}

/* Take one face away; its nodes are appended to those touched. */
static void
take_face_away(struct collapses *work, uint32_t face)
{
	struct seams *seams = work->seams;
	uint32_t nodes[3];

	if (!collapses_face(work, face, nodes))
		return;
	for (int k = 0; k < 3; k++)
		work->touched.at[work->touched.count++] = nodes[k];
	while (seams->faces.at[face] != TCS_NONE)
		seams_open(seams, seams->faces.at[face] / 2);
	work->surfaces.at[work->features.at[face]]--;
	crossing_watch_drop(work, face);
	work->face_count--;
}

enum tcs_status
collapses_take_away(struct collapses *work, const uint32_t *faces, size_t count,
	struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	work->touched.count = 0;
	if (array_grow(&work->touched, 3 * count))
		return fault_memory(fault);
	for (size_t i = 0; i < count; i++)
		take_face_away(work, faces[i]);
	for (size_t i = 0; i < count; i++)
		half_edges_take_away(work->mesh, faces[i]);
	/* Twins of other sheets are free now; the rest finds nothing. */
	for (size_t i = 0; !status && i < work->touched.count; i++)
		status = collapses_judge(work, work->touched.at[i], fault);
	return status;
}

bool
collapses_face(const struct collapses *work, uint32_t face, uint32_t nodes[3])
{
	uint32_t corners[3];

	if (!half_edges_corners(work->mesh, face, corners))
		return false;
	for (int k = 0; k < 3; k++)
		nodes[k] = node_of(work, corners[k]);
	return true;
}

bool
collapses_is_moved(const struct collapses *work, uint32_t node)
{
	struct tcs_point now = work->positions.at[node];
	struct tcs_point first =
		work->set->points.at[work->sheets->nodes.at[node].point];

	return now.x < first.x || now.x > first.x || now.y < first.y ||
		now.y > first.y || now.z < first.z || now.z > first.z;
}

void
collapses_end(struct collapses *work)
{
	array_release(&work->quadrics);
	array_release(&work->borders);
	array_release(&work->border_places);
	array_release(&work->areas);
	array_release(&work->targets);
	node_queue_release(&work->queue);
	error_watch_release(&work->watch);
	crossing_watch_release(&work->crossings);
	volume_watch_release(&work->volume);
	cover_watch_release(&work->covers);
}

void
collapses_release_mesh(struct collapses *work)
{
	half_edges_free(work->mesh);
	work->mesh = NULL;
	array_release(&work->positions);
}

void
collapses_release(struct collapses *work)
{
	collapses_end(work);
	collapses_release_mesh(work);
	array_release(&work->fixed);
	array_release(&work->features);
	array_release(&work->sources);
	array_release(&work->surfaces);
	array_release(&work->worths);
	array_release(&work->shares);
	array_release(&work->spokes);
	array_release(&work->candidates);
	array_release(&work->touched);
	array_release(&work->moves);
	array_release(&work->ring);
	array_release(&work->sides);
	array_release(&work->apart);
	array_release(&work->leaving);
	array_release(&work->opened);
}
