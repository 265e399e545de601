#include "handles.h"

#include <math.h>

#include "handle_price.h"
#include "inner_outlines.h"
#include "number_sort.h"

/* ---- finding ------------------------------------------------------------- */

/* Number the pieces that have a host: owners.at becomes the handle of every
   face. */
static enum tcs_status
number_handles(struct handles *handles, const struct inner_outlines *outlines,
	struct tcs_fault *fault)
{
	size_t faces = outlines->pieces.count;

	array_clear(&handles->at);
	array_clear(&handles->owners);
	if (array_grow(&handles->owners, faces))
		return fault_memory(fault);
	handles->owners.count = faces;
	for (size_t i = 0; i < faces; i++) {
		uint32_t piece = outlines->pieces.at[i];

		handles->owners.at[i] = TCS_NONE;
		if (outlines->hosts.at[piece] == TCS_NONE)
			continue;
		if (piece < i) {
			handles->owners.at[i] = handles->owners.at[piece];
			continue;
		}
		if (array_grow(&handles->at, 1))
			return fault_memory(fault);
		handles->owners.at[i] = (uint32_t)handles->at.count;
		handles->at.at[handles->at.count++] = (struct handle){
			.part = handles->removals->parts.numbers.at[i]};
	}
	return TCS_OK;
}

/* Sort the faces by their handle: count, then place. */
static enum tcs_status
sort_faces(struct handles *handles, struct tcs_fault *fault)
{
	size_t faces = handles->owners.count;
	uint32_t first = 0;

	array_clear(&handles->faces);
	for (size_t i = 0; i < faces; i++)
		if (handles->owners.at[i] != TCS_NONE)
			handles->at.at[handles->owners.at[i]].count++;
	for (size_t i = 0; i < handles->at.count; i++) {
		struct handle *handle = &handles->at.at[i];

		handle->first = first;
		first += handle->count;
		handle->count = 0;
	}
	if (array_grow(&handles->faces, first))
		return fault_memory(fault);
	handles->faces.count = first;
	for (uint32_t i = 0; i < faces; i++) {
		struct handle *handle;

		if (handles->owners.at[i] == TCS_NONE)
			continue;
		handle = &handles->at.at[handles->owners.at[i]];
		handles->faces.at[handle->first + handle->count++] = i;
	}
	return TCS_OK;
}

enum tcs_status
handles_find(struct handles *handles, struct component_set *set,
	struct collapses *work, struct removals *removals,
	struct tcs_fault *fault)
{
	struct inner_outlines outlines = {0};
	enum tcs_status status =
		inner_outlines_find(&outlines, work->set, work->sheets, fault);

	handles->set = set;
	handles->work = work;
	handles->removals = removals;
	handles->closed = handles->panels.made = 0;
	if (!status)
		status = number_handles(handles, &outlines, fault);
	inner_outlines_release(&outlines);
	if (!status)
		status = sort_faces(handles, fault);
	if (!status)
		status = node_queue_reset(
			&handles->queue, handles->at.count, fault);
	/* What is watched cannot be refilled. */
	if (status || work->settings.max_error > 0)
		return status;
	for (uint32_t i = 0; i < handles->at.count; i++)
		node_queue_set(&handles->queue, i,
			handle_least_price(handles, &handles->at.at[i]));
	return TCS_OK;
}

double
handles_next_cost(const struct handles *handles)
{
	const struct queue_entry *first = node_queue_first(&handles->queue);

	return first ? first->cost : INFINITY;
}

/* ---- the triangles that close it ----------------------------------------- */

/*
 * A face of a handle with one rim that looks the same way as what closes it,
 * and is of another surface: a window at the bottom of a recess comes forward,
 * and what closes the recess is the window. TCS_NONE: there is none.
 */
static uint32_t
find_bottom(const struct handles *handles)
{
	const struct rims *rims = &handles->rims;
	const uint32_t *features = handles->work->features.at;
	uint32_t beyond = features[rims->edges.at[0].beyond], best = TCS_NONE;
	double most = 0;

	for (size_t i = 0; rims->loops.count == 1 && i < rims->faces.count;
		i++) {
		uint32_t face = rims->faces.at[i];
		struct triangle_shape shape =
			collapses_shape(handles->work, face);
		struct tcs_point normal = triangle_normal(&shape);
		double along = vector_dot(normal, rims->loops.at[0].normal);

		if (features[face] == beyond || along <= most ||
			along < SAME_PLANE * vector_length(normal))
			continue;
		most = along;
		best = face;
	}
	return best;
}

/* Let every triangle continue the face beyond its rim, or the bottom. */
static void
choose_models(struct handles *handles)
{
	struct rims *rims = &handles->rims;
	uint32_t bottom = find_bottom(handles);

	for (size_t i = 0; bottom != TCS_NONE && i < rims->beyond.count; i++)
		rims->beyond.at[i] = bottom;
}

/* Six times the volume that is added with the caps. */
static double
volume_added(const struct handles *handles)
{
	const struct rims *rims = &handles->rims;
	struct tcs_point origin = handle_cap_shape(handles, 0).corner[0];
	double volume = 0;

	for (size_t i = 0; i < rims->beyond.count; i++) {
		struct triangle_shape shape = handle_cap_shape(handles, i);

		volume += vector_dot(vector_difference(shape.corner[0], origin),
			triangle_normal(&shape));
	}
	for (size_t i = 0; i < rims->faces.count; i++) {
		struct triangle_shape shape =
			collapses_shape(handles->work, rims->faces.at[i]);

		volume -= vector_dot(vector_difference(shape.corner[0], origin),
			triangle_normal(&shape));
	}
	return volume;
}

/* The contacts of the points that the faces hold, one for each. */
static enum tcs_status
list_contacts(struct handles *handles, struct tcs_fault *fault)
{
	const struct seams *seams = handles->work->seams;
	const struct rims *rims = &handles->rims;

	handles->held.count = 0;
	for (size_t i = 0; i < rims->faces.count; i++)
		for (uint32_t hold = seams->faces.at[rims->faces.at[i]];
			hold != TCS_NONE; hold = seams->holds.at[hold].next) {
			if (array_grow(&handles->held, 1))
				return fault_memory(fault);
			handles->held.at[handles->held.count++] =
				seams->points.at[hold / 2].contact;
		}
	number_sort(handles->held.at, handles->held.count);
	return TCS_OK;
}

/* ---- closing ------------------------------------------------------------- */

/* Contacts all points of which stand in what was added. */
static void
enclose_contacts(struct handles *handles)
{
	struct removals *removals = handles->removals;

	for (size_t i = 0; i < handles->held.count; i++) {
		uint32_t number = handles->held.at[i];
		const struct contact *contact = &removals->list->at[number];

		if ((i > 0 && number == handles->held.at[i - 1]) ||
			handles->work->seams->counts.at[number].points > 0)
			continue;
		removals->parts.enclosed.at[contact->a]++;
		removals->parts.enclosed.at[contact->b]++;
	}
}

/* Whether a part has become one with what stood in its hole, or has covered
   something before. */
static bool
is_cover(const struct handles *handles, uint32_t host)
{
	const struct cover_watch *watch = &handles->work->covers;
	bool covers = false;

	for (size_t i = 0; watch->list && i < handles->rims.beyond.count; i++)
		covers |= watch->numbers.at[handles->rims.beyond.at[i]] !=
			TCS_NONE;
	for (size_t i = 0; !covers && i < handles->hidden.count; i++)
		covers = handle_becomes_one(
			handles, handles->hidden.at[i], host);
	return covers;
}

/* Begin the cover of a part. */
static enum tcs_status
begin_cover(struct handles *handles, uint32_t host, struct tcs_fault *fault)
{
	struct collapses *work = handles->work;
	const struct parts *parts = &handles->removals->parts;
	const struct part *own = &parts->at.at[host];
	enum tcs_status status = cover_watch_open(work, handles->removals->list,
		parts->faces.at + own->first, own->count, fault);

	if (!status && parts->left.at[own->component] == 1)
		status = cover_watch_put(work, own->component, fault);
	return status;
}

/* Where a part touched others is in the plate now. */
static void
forget_points(const struct handles *handles, const struct part *own)
{
	struct seams *seams = handles->work->seams;

	for (uint32_t i = 0; i < own->count; i++) {
		const uint32_t *hold =
			&seams->faces.at[handles->removals->parts.faces
						 .at[own->first + i]];

		while (*hold != TCS_NONE)
			seams_forget(seams, *hold / 2);
	}
}

/* What has become one with it goes, and is covered. */
static enum tcs_status
become_one(struct handles *handles, uint32_t number, struct tcs_fault *fault)
{
	struct removals *removals = handles->removals;
	const struct part *own = &removals->parts.at.at[number];
	enum tcs_status status;

	forget_points(handles, own);
	status = removals_take(removals, number, fault);

	if (status || !own->gone || removals->parts.left.at[own->component] > 0)
		return status;
	return cover_watch_put(handles->work, own->component, fault);
}

/* What stood in a hole is enclosed now, and has become one with what closes it,
   comes forward, or is not seen. */
static enum tcs_status
enclose(struct handles *handles, uint32_t host, struct tcs_fault *fault)
{
	struct removals *removals = handles->removals;
	const struct part *own = &removals->parts.at.at[host];
	bool covers = is_cover(handles, host);
	enum tcs_status status =
		covers ? begin_cover(handles, host, fault) : TCS_OK;

	enclose_contacts(handles);
	for (size_t i = 0; !status && i < handles->hidden.count; i++) {
		uint32_t part = handles->hidden.at[i];

		if (handle_becomes_one(handles, part, host))
			status = become_one(handles, part, fault);
	}
	if (!status && covers)
		status = cover_watch_close(handles->work,
			removals->parts.faces.at + own->first, own->count,
			fault);
	return status ? status
		      : panels_build(&handles->panels, handles->set,
				handles->work, removals, fault);
}

static enum tcs_status
close_handle(struct handles *handles, uint32_t number,
	const struct refill *refill, struct tcs_fault *fault)
{
	uint32_t host = handles->at.at[number].part;
	enum tcs_status status = collapses_refill(handles->work, refill, fault);

	node_queue_set(&handles->queue, number, INFINITY);
	handles->closed++;
	return status || !refill->adds ? status : enclose(handles, host, fault);
}

/* What the rims say is to be done; false if it cannot be. */
static enum tcs_status
plan(struct handles *handles, const struct handle *handle,
	struct refill *refill, bool *fine, struct tcs_fault *fault)
{
	const struct rims *rims = &handles->rims;
	enum tcs_status status = rims_find(&handles->rims, handles->work,
		handles->faces.at + handle->first, handle->count,
		handles->owners.at, fine, fault);

	if (status || !*fine)
		return status;
	choose_models(handles);
	*refill = (struct refill){rims->faces.at, rims->faces.count,
		rims->faces.at, rims->corners.at, NULL, rims->beyond.at,
		rims->beyond.count, volume_added(handles) > 0};
	return list_contacts(handles, fault);
}

/* Its part has other faces by now. */
static bool
is_built_over(const struct handles *handles, uint32_t number)
{
	const struct parts *parts = &handles->removals->parts;

	return parts->at.at[parts_host(parts, handles->at.at[number].part)]
		.rebuilt;
}

enum tcs_status
handles_try(struct handles *handles, struct tcs_fault *fault)
{
	struct queue_entry first = *node_queue_first(&handles->queue);
	struct refill refill = {0};
	double price = INFINITY;
	bool fine = false;
	enum tcs_status status;

	if (is_built_over(handles, first.node)) {
		node_queue_set(&handles->queue, first.node, INFINITY);
		return TCS_OK;
	}
	status = plan(
		handles, &handles->at.at[first.node], &refill, &fine, fault);
	if (!status && fine)
		status = crossing_watch_admits(
			handles->work, &refill, &fine, fault);
	if (!status && fine)
		status = removals_look(handles->removals, fault);
	if (!status && fine)
		status = handle_price(
			handles, first.node, refill.adds, &price, fault);
	if (status)
		return status;
	if (fine && price <= first.cost)
		return close_handle(handles, first.node, &refill, fault);
	node_queue_set(&handles->queue, first.node, price);
	return TCS_OK;
}

void
handles_release(struct handles *handles)
{
	array_release(&handles->at);
	array_release(&handles->faces);
	array_release(&handles->owners);
	node_queue_release(&handles->queue);
	rims_release(&handles->rims);
	array_release(&handles->hidden);
	array_release(&handles->left);
	panels_release(&handles->panels);
	array_release(&handles->held);
}
