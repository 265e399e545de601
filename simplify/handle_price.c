#include "handle_price.h"

#include <math.h>

/* What is no longer seen, though it stays, is worth so much of a contact, less
   where what hides it is near. */
#define VIEW_SHARE 0.25

/* Metres: what is less off is not worth a look yet. */
#define LEAST_OFF 0.01

enum { MOST_SAMPLES = 16 };

/* Of a face as it came. */
static struct triangle_shape
handle_first_shape(const struct handles *handles, uint32_t face)
{
	const struct collapses *work = handles->work;

	return component_set_shape(
		work->set, work->sheets->face_triangles.at[face]);
}

/* ---- places -------------------------------------------------------------- */

struct triangle_shape
handle_cap_shape(const struct handles *handles, size_t cap)
{
	const struct collapses *work = handles->work;
	const uint32_t *corners = handles->rims.corners.at + 3 * cap;
	struct triangle_shape shape;

	for (int k = 0; k < 3; k++)
		shape.corner[k] = work->positions.at[node_of(work, corners[k])];
	return shape;
}

/* Behind the last link of a part that is followed. */
static uint32_t
last_link(const struct part *own)
{
	return own->first_link +
		(own->link_count < MOST_LINKS ? own->link_count : MOST_LINKS);
}

/* ---- how far it is off --------------------------------------------------- */

/* How far a point is from its part as it came, and from those linked to it; what
   is not more than `enough` need not be less. */
static enum tcs_status
distance_before(const struct handles *handles, uint32_t part,
	struct tcs_point from, double enough, double *least,
	struct tcs_fault *fault)
{
	struct removals *removals = handles->removals;
	const struct parts *parts = &removals->parts;
	const struct part *own = &parts->at.at[part];
	enum tcs_status status = removals_distance(
		removals, part, from, INFINITY, enough, least, fault);

	for (uint32_t i = own->first_link;
		!status && *least > enough && i < last_link(own); i++) {
		uint32_t other = parts->links.at[i];
		double distance = INFINITY;

		if (box_distance_squared(&parts->at.at[other].box, from) <
			*least * *least)
			status = removals_distance(removals, other, from,
				*least, enough, &distance, fault);
		*least = fmin(*least, distance);
	}
	return status;
}

/* The caps' samples from the surface as it was, where that is more. */
static enum tcs_status
caps_off(const struct handles *handles, uint32_t part, double *most,
	struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	for (size_t i = 0; !status && i < handles->rims.beyond.count; i++) {
		struct triangle_shape cap = handle_cap_shape(handles, i);

		for (int k = 0; !status && k < 4; k++) {
			struct tcs_point at = k < 3
				? vector_middle(cap.corner[k],
					  cap.corner[(k + 1) % 3])
				: triangle_centre(&cap);
			double off = 0;

			status = distance_before(
				handles, part, at, *most, &off, fault);
			*most = fmax(*most, off);
		}
	}
	return status;
}

static double
distance_to_caps(const struct handles *handles, struct tcs_point from)
{
	double least = INFINITY;

	for (size_t i = 0; i < handles->rims.beyond.count; i++) {
		struct triangle_shape cap = handle_cap_shape(handles, i);

		least = fmin(least,
			vector_length(vector_difference(
				triangle_nearest(&cap, from), from)));
	}
	return least;
}

/* The faces, as they came, from the caps. */
static double
faces_off(const struct handles *handles, const struct handle *handle)
{
	uint32_t step = handle->count / MOST_SAMPLES + 1;
	double most = 0;

	for (uint32_t i = 0; i < handle->count; i += step) {
		struct triangle_shape shape = handle_first_shape(
			handles, handles->faces.at[handle->first + i]);

		most = fmax(most,
			distance_to_caps(handles, triangle_centre(&shape)));
	}
	return most;
}

/* ---- what it does to others ---------------------------------------------- */

/* Whether a part is between the caps, as it came. */
static bool
is_between(const struct handles *handles, const struct part *part)
{
	const struct rims *rims = &handles->rims;

	for (uint32_t i = 0; i < part->count; i++) {
		struct triangle_shape shape = handle_first_shape(handles,
			handles->removals->parts.faces.at[part->first + i]);

		for (size_t l = 0; l < rims->loops.count; l++) {
			const struct rim_loop *loop = &rims->loops.at[l];
			uint32_t node = node_of(handles->work,
				rims->edges.at[loop->first].from);
			struct tcs_point from =
				handles->work->positions.at[node];

			for (int k = 0; k < 3; k++)
				if (vector_dot(loop->normal,
					    vector_difference(shape.corner[k],
						    from)) > STANDS_OUT)
					return false;
		}
	}
	return true;
}

static struct box
box_of(const struct handles *handles, const struct handle *handle)
{
	struct box box = BOX_EMPTY;

	for (uint32_t i = 0; i < handle->count; i++) {
		struct triangle_shape shape = handle_first_shape(
			handles, handles->faces.at[handle->first + i]);

		for (int k = 0; k < 3; k++)
			box_add_point(&box, shape.corner[k]);
	}
	return box;
}

static bool
box_holds(const struct box *box, const struct box *other)
{
	for (int k = 0; k < 3; k++)
		if (other->low[k] < box->low[k] - STANDS_OUT ||
			other->high[k] > box->high[k] + STANDS_OUT)
			return false;
	return true;
}

/* List the parts that stand in a hole that will be closed. */
static enum tcs_status
list_hidden(struct handles *handles, const struct handle *handle,
	struct tcs_fault *fault)
{
	const struct parts *parts = &handles->removals->parts;
	const struct part *own = &parts->at.at[handle->part];
	struct box box = box_of(handles, handle);

	handles->hidden.count = 0;
	for (uint32_t i = own->first_link; i < last_link(own); i++) {
		uint32_t number = parts->links.at[i];
		const struct part *other = &parts->at.at[number];
		bool known = other->gone || !box_holds(&box, &other->box);

		for (size_t k = 0; !known && k < handles->hidden.count; k++)
			known = handles->hidden.at[k] == number;
		if (known || !is_between(handles, other))
			continue;
		if (array_grow(&handles->hidden, 1))
			return fault_memory(fault);
		handles->hidden.at[handles->hidden.count++] = number;
	}
	return TCS_OK;
}

bool
handle_becomes_one(
	const struct handles *handles, uint32_t number, uint32_t host)
{
	const struct collapses *work = handles->work;
	const struct parts *parts = &handles->removals->parts;
	const struct part *own = &parts->at.at[number];
	uint32_t feature = work->features.at[handles->rims.beyond.at[0]];

	for (uint32_t i = 0; i < own->count; i++)
		if (work->features.at[parts->faces.at[own->first + i]] !=
			feature)
			return false;
	for (uint32_t i = 0; i < own->link_count; i++) {
		const struct part *other =
			&parts->at.at[parts->links.at[own->first_link + i]];

		if (!other->gone && other->component != own->component &&
			other->component != parts->at.at[host].component)
			return false;
	}
	return true;
}

/* How many contacts break, by their worth, if none of the points listed is held
   any more. */
static double
count_broken(const struct handles *handles)
{
	const struct collapses *work = handles->work;
	double broken = 0;

	for (size_t i = 0, end; i < handles->held.count; i = end) {
		uint32_t contact = handles->held.at[i];
		const struct seam_count *count =
			&work->seams->counts.at[contact];

		for (end = i; end < handles->held.count &&
			handles->held.at[end] == contact;)
			end++;
		broken +=
			(seam_broken(count, count->open + (uint32_t)(end - i)) -
				seam_broken(count, count->open)) *
			(double)work->worths.at[contact];
	}
	return broken;
}

/* How many surfaces have no face left. */
static double
count_vanishing(const struct handles *handles)
{
	const struct collapses *work = handles->work;
	const struct rims *rims = &handles->rims;
	double vanishing = 0;
	uint32_t faces = 0;

	for (size_t i = 0; i < rims->faces.count; i++) {
		uint32_t feature = work->features.at[rims->faces.at[i]];

		if (i > 0 &&
			feature != work->features.at[rims->faces.at[i - 1]])
			faces = 0;
		if (++faces == work->surfaces.at[feature])
			vanishing += rims->beyond.count == 0 ||
				work->features.at[rims->beyond.at[0]] !=
					feature;
	}
	return vanishing;
}

/* Whether all that a vertex keeps lies in the plane of a loop. */
static enum tcs_status
lies_flat(const struct handles *handles, uint32_t vertex,
	struct tcs_point normal, bool *flat, struct tcs_fault *fault)
{
	struct collapses *work = handles->work;
	uint32_t owner = handles->owners.at[handles->rims.faces.at[0]];
	size_t count;
	enum tcs_status status = spokes_of(work, vertex, &count, fault);

	*flat = true;
	for (size_t i = 0; !status && *flat && i < count; i++) {
		uint32_t face = work->spokes.at[i].face;
		struct triangle_shape shape;
		struct tcs_point own;

		if (face == HALF_EDGE_NONE || handles->owners.at[face] == owner)
			continue;
		shape = collapses_shape(handles->work, face);
		own = triangle_normal(&shape);
		*flat = vector_dot(own, normal) >=
			SAME_PLANE * vector_length(own);
	}
	return status;
}

/* The faces that are saved, those of the collapses included that cost nothing
   once it is closed. */
static enum tcs_status
count_saved(
	const struct handles *handles, double *saved, struct tcs_fault *fault)
{
	const struct rims *rims = &handles->rims;
	enum tcs_status status = TCS_OK;

	*saved = (double)rims->faces.count - (double)rims->beyond.count;
	for (size_t l = 0; l < rims->loops.count; l++) {
		const struct rim_loop *loop = &rims->loops.at[l];

		for (uint32_t i = 0; !status && i < loop->count; i++) {
			bool flat;

			status = lies_flat(handles,
				rims->edges.at[loop->first + i].from,
				loop->normal, &flat, fault);
			*saved += flat ? 2 : 0;
		}
	}
	return status;
}

/* ---- what comes forward --------------------------------------------------- */

/* Plan for what stands in the hole, but for what will be one with its host. */
static enum tcs_status
plan_panels(struct handles *handles, uint32_t host, struct tcs_fault *fault)
{
	handles->left.count = 0;
	if (array_grow(&handles->left, handles->hidden.count))
		return fault_memory(fault);
	for (size_t i = 0; i < handles->hidden.count; i++)
		if (!handle_becomes_one(handles, handles->hidden.at[i], host))
			handles->left.at[handles->left.count++] =
				handles->hidden.at[i];
	return panels_plan(&handles->panels, handles->work, handles->removals,
		&handles->rims, handles->left.at, handles->left.count, fault);
}

/* What being off costs, and the faces that there will be more. */
static double
panels_cost(const struct handles *handles, double *faces)
{
	double cost = 0;

	*faces = 0;
	for (size_t i = 0; i < handles->panels.at.count; i++) {
		const struct panel *panel = &handles->panels.at.at[i];

		cost += panel->cost;
		*faces += panel->faces;
	}
	return cost;
}

/* How many parts will be seen no more. */
static double
count_hidden(const struct handles *handles)
{
	const struct panels *panels = &handles->panels;
	const double *visible = handles->removals->visible.at;
	double hidden = 0;

	for (size_t i = 0; i < panels->at.count; i++) {
		const struct panel *panel = &panels->at.at[i];
		const uint32_t *parts = panels->parts.at + panel->first;

		for (uint32_t k = 0; !panel->fine && k < panel->count; k++)
			hidden += visible[parts[k]] > 0;
	}
	return hidden;
}

/* ---- the price ----------------------------------------------------------- */

/* The shape, square metres times area. */
static double
shape_cost(
	const struct handles *handles, const struct handle *handle, double off)
{
	const struct removals *removals = handles->removals;
	const struct part *part = &removals->parts.at.at[handle->part];
	double seen = part->area > 0
		? removals->visible.at[handle->part] / part->area
		: 0;
	double area = 0;

	for (size_t i = 0; i < handles->rims.beyond.count; i++) {
		struct triangle_shape cap = handle_cap_shape(handles, i);

		area += triangle_area(&cap);
	}
	for (uint32_t i = 0; i < handle->count; i++) {
		struct triangle_shape shape = handle_first_shape(
			handles, handles->faces.at[handle->first + i]);

		area += triangle_area(&shape);
	}
	return fmax(seen, HIDDEN_SHARE) * area * removals_steep(removals, off);
}

/* What breaks, vanishes, is crossed or is seen no more, in contacts; what is
   hidden is listed, and what comes forward planned. */
static enum tcs_status
count_harm(struct handles *handles, const struct handle *handle, bool adds,
	double off, double *harm, struct tcs_fault *fault)
{
	double share = fmin(1, off / handles->removals->far);
	enum tcs_status status;

	*harm = count_vanishing(handles) + handles->work->broken;
	handles->panels.at.count = 0;
	if (!adds) {
		*harm += count_broken(handles);
		return TCS_OK;
	}
	status = list_hidden(handles, handle, fault);
	if (!status)
		status = plan_panels(handles, handle->part, fault);
	if (!status)
		*harm += VIEW_SHARE * share * share * count_hidden(handles);
	return status;
}

enum tcs_status
handle_price(struct handles *handles, uint32_t number, bool adds, double *price,
	struct tcs_fault *fault)
{
	const struct handle *handle = &handles->at.at[number];
	double off = faces_off(handles, handle);
	double harm = 0, saved = 0, panels, added;
	enum tcs_status status = caps_off(handles, handle->part, &off, fault);

	*price = INFINITY;
	if (status)
		return status;
	status = count_harm(handles, handle, adds, off, &harm, fault);
	if (!status)
		status = count_saved(handles, &saved, fault);
	for (size_t i = 0; !status && adds && i < handles->hidden.count; i++)
		if (handle_becomes_one(
			    handles, handles->hidden.at[i], handle->part))
			saved += removals_faces(
				handles->removals, handles->hidden.at[i]);
	panels = panels_cost(handles, &added);
	saved -= added;
	if (status || saved < 2)
		return status;
	*price = (shape_cost(handles, handle, off) + panels +
			 harm * handles->removals->contact_cost) /
		(0.5 * saved);
	return TCS_OK;
}

double
handle_least_price(const struct handles *handles, const struct handle *handle)
{
	double area = 0;

	for (uint32_t i = 0; i < handle->count; i++) {
		struct triangle_shape shape = handle_first_shape(
			handles, handles->faces.at[handle->first + i]);

		area += triangle_area(&shape);
	}
	return HIDDEN_SHARE * area * LEAST_OFF * LEAST_OFF / handle->count;
}
