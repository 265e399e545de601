#include "removal_price.h"

#include <math.h>
#include <stdlib.h>

enum { MOST_SAMPLES = 16 };

/* Parts that go together: no more. */
enum { MOST_STACKED = 64 };

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
	struct tcs_point from, double reach, double enough, double *distance,
	struct tcs_fault *fault)
{
	uint32_t root = TCS_NONE;
	enum tcs_status status = root_of(removals, part, &root, fault);

	if (!status)
		*distance = triangle_tree_near(
			&removals->tree, root, from, reach, enough)
				    .distance;
	return status;
}

/* How far something is from what stays around it. */
struct reaching {
	struct removals *removals;
	const uint32_t *around; /* parts, gone or not */
	uint32_t count;
	double far; /* metres: as far as need be looked */
	uint32_t nearest; /* place: what was nearest to the last point */
	double most; /* of the points so far; INFINITY: none of them stays */
};

/* A point that is not farther than another was does not matter. */
static enum tcs_status
reach_from(struct reaching *reaching, struct tcs_point from,
	struct tcs_fault *fault)
{
	struct removals *removals = reaching->removals;
	uint32_t count = reaching->count, begin = reaching->nearest;
	double least = reaching->far;
	bool any = false;

	for (uint32_t i = 0; i < count; i++) {
		uint32_t place =
			begin + i < count ? begin + i : begin + i - count;
		uint32_t other = reaching->around[place];
		enum tcs_status status;
		double distance;

		if (removals->parts.at.at[other].gone)
			continue;
		any = true;
		status = removals_distance(removals, other, from, least,
			reaching->most, &distance, fault);
		if (status)
			return status;
		if (distance < least) {
			least = distance;
			reaching->nearest = place;
		}
		if (least <= reaching->most)
			return TCS_OK;
	}
	reaching->most = any ? least : INFINITY;
	return TCS_OK;
}

static enum tcs_status
reach_from_part(struct reaching *reaching, const struct part *own,
	struct tcs_fault *fault)
{
	const struct parts *parts = &reaching->removals->parts;
	const struct collapses *work = reaching->removals->work;
	uint32_t step = own->count / MOST_SAMPLES + 1;
	enum tcs_status status = TCS_OK;

	for (uint32_t i = 0; !status && i < own->count; i += step) {
		uint32_t face = parts->faces.at[own->first + i];
		struct triangle_shape shape = component_set_shape(
			work->set, work->sheets->face_triangles.at[face]);

		status = reach_from(reaching, triangle_centre(&shape), fault);
		for (int k = 0; !status && k < 3; k++)
			status = reach_from(reaching, shape.corner[k], fault);
	}
	return status;
}

/* Nothing that stays comes nearer: what was found out holds until something goes
   that a part is linked to. */
enum tcs_status
removal_measure(
	struct removals *removals, uint32_t number, struct tcs_fault *fault)
{
	const struct part *own = &removals->parts.at.at[number];
	struct reaching reaching = {.removals = removals,
		.around = own->link_count > 0
			? removals->parts.links.at + own->first_link
			: NULL,
		.count = own->link_count,
		.far = box_diagonal(&own->box)};
	enum tcs_status status;

	if (removals->measured.at[number])
		return TCS_OK;
	status = reach_from_part(&reaching, own, fault);
	if (status)
		return status;
	removals->measured.at[number] = true;
	removals->distances.at[number] =
		fmax(removals->distances.at[number], reaching.most);
	return TCS_OK;
}

/* ---- what breaks --------------------------------------------------------- */

/* What is lost with the parts that were added so far; their contacts and
   surfaces stand in lists. */
struct loss {
	double shape; /* square metres times area */
	double contacts; /* that have no points, by their worth */
	double faces;
	bool seen; /* something of them */
};

/* The contacts of the points that a part holds, and how many of each. */
static enum tcs_status
list_contacts(struct removals *removals, const struct part *part,
	struct tcs_fault *fault)
{
	const struct seams *seams = removals->work->seams;

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

/* How many of the contacts listed break, by their worth, and parts of contacts
   as parts. The list is used up. */
static double
count_broken(struct removals *removals)
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
	return broken;
}

/* The surfaces of the faces that are left, one after another. */
static enum tcs_status
list_surfaces(struct removals *removals, const struct part *part,
	struct tcs_fault *fault)
{
	const struct collapses *work = removals->work;
	uint32_t corners[3];

	for (uint32_t i = 0; i < part->count; i++) {
		uint32_t face = removals->parts.faces.at[part->first + i];
		uint32_t feature = work->features.at[face];
		size_t count = removals->runs.count;

		if (!half_edges_corners(work->mesh, face, corners))
			continue;
		if (count > 0 &&
			removals->runs.at[count - 1].feature == feature) {
			removals->runs.at[count - 1].faces++;
			continue;
		}
		if (array_grow(&removals->runs, 1))
			return fault_memory(fault);
		removals->runs.at[removals->runs.count++] =
			(struct surface_run){feature, 1};
	}
	return TCS_OK;
}

static int
by_feature(const void *left, const void *right)
{
	const struct surface_run *a = left, *b = right;

	return (a->feature > b->feature) - (a->feature < b->feature);
}

/* How many surfaces keep no face. The list is used up. */
static double
count_vanishing(struct removals *removals)
{
	const uint32_t *left = removals->work->surfaces.at;
	struct surface_run *runs = removals->runs.at;
	double vanishing = 0;

	if (removals->runs.count > 1)
		qsort(runs, removals->runs.count, sizeof *runs, by_feature);
	for (size_t i = 0, end; i < removals->runs.count; i = end) {
		uint32_t faces = 0;

		for (end = i; end < removals->runs.count &&
			runs[end].feature == runs[i].feature;)
			faces += runs[end++].faces;
		vanishing += faces == left[runs[i].feature];
	}
	removals->runs.count = 0;
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

/* Add a part that goes, so far from what stays; `last` if nothing is left of its
   component then. */
static enum tcs_status
add_part(struct removals *removals, uint32_t number, double distance, bool last,
	struct loss *loss, struct tcs_fault *fault)
{
	const struct part *part = &removals->parts.at.at[number];
	double visible =
		removals->visible.count ? removals->visible.at[number] : 0;
	double covered = 0;
	enum tcs_status status = cover_watch_worth(removals->work,
		removals->parts.faces.at + part->first, part->count, &covered,
		fault);

	if (!status)
		status = list_contacts(removals, part, fault);
	if (!status)
		status = list_surfaces(removals, part, fault);
	loss->shape += fmax(visible, HIDDEN_SHARE * part->area) *
		removals_steep(removals, distance);
	loss->contacts += covered;
	if (last)
		loss->contacts += removals->parts.enclosed.at[part->component];
	loss->faces += removals_faces(removals, number);
	loss->seen |= visible > 0;
	return status;
}

static double
price_of(struct removals *removals, const struct loss *loss)
{
	double broken = loss->contacts + count_broken(removals) +
		count_vanishing(removals) * (loss->seen ? SEEN_FACTOR : 1);

	return (loss->shape + broken * removals->contact_cost) /
		(0.5 * loss->faces);
}

static bool
is_too_far(const struct removals *removals, double distance)
{
	double allowed = removals->work->settings.max_error;

	return distance == INFINITY || (allowed > 0 && distance > allowed);
}

enum tcs_status
removal_price(struct removals *removals, uint32_t number, double *price,
	struct tcs_fault *fault)
{
	const struct parts *parts = &removals->parts;
	double distance = removals->distances.at[number];
	struct loss loss = {0};
	enum tcs_status status;

	*price = INFINITY;
	if (is_too_far(removals, distance) || !removals_faces(removals, number))
		return TCS_OK;
	removals->contacts.count = removals->runs.count = 0;
	status = add_part(removals, number, distance,
		parts->left.at[parts->at.at[number].component] == 1, &loss,
		fault);
	if (!status)
		*price = price_of(removals, &loss);
	return status;
}

/* ---- of a stack ----------------------------------------------------------- */

/* What stays and is linked to what hangs. */
static enum tcs_status
list_around(struct removals *removals, struct tcs_fault *fault)
{
	const struct parts *parts = &removals->parts;

	removals->around.count = 0;
	for (size_t i = 0; i < parts->hanging.count; i++) {
		const struct part *own = &parts->at.at[parts->hanging.at[i]];

		if (array_grow(&removals->around, own->link_count))
			return fault_memory(fault);
		for (uint32_t k = 0; k < own->link_count; k++) {
			uint32_t other = parts->links.at[own->first_link + k];

			if (!parts->at.at[other].gone &&
				!parts_hangs(parts, other))
				removals->around.at[removals->around.count++] =
					other;
		}
	}
	return TCS_OK;
}

static double
width_of_stack(const struct parts *parts)
{
	struct box box = BOX_EMPTY;

	for (size_t i = 0; i < parts->hanging.count; i++)
		box_add(&box, &parts->at.at[parts->hanging.at[i]].box);
	return box_diagonal(&box);
}

/* Whether all that is left of the component of part i of a stack is among those
   before it, and itself. */
static bool
is_last(const struct parts *parts, size_t i)
{
	uint32_t component = parts->at.at[parts->hanging.at[i]].component;
	uint32_t count = 0;

	for (size_t k = 0; k <= i; k++)
		count += parts->at.at[parts->hanging.at[k]].component ==
			component;
	return count == parts->left.at[component];
}

/* All that hangs; *near is false if some of it is too far from what stays. */
static enum tcs_status
add_stack(struct removals *removals, struct loss *loss, bool *near,
	struct tcs_fault *fault)
{
	const struct parts *parts = &removals->parts;
	double far = width_of_stack(parts);
	enum tcs_status status = TCS_OK;

	for (size_t i = 0; !status && *near && i < parts->hanging.count; i++) {
		uint32_t number = parts->hanging.at[i];
		const struct part *own = &parts->at.at[number];
		struct reaching reaching = {.removals = removals,
			.around = removals->around.at,
			.count = (uint32_t)removals->around.count,
			.far = far,
			.most = own->depth};

		status = reach_from_part(&reaching, own, fault);
		*near = !is_too_far(removals, reaching.most);
		if (!status)
			status = add_part(removals, number, reaching.most,
				is_last(parts, i), loss, fault);
	}
	return status;
}

enum tcs_status
removal_stack_price(struct removals *removals, uint32_t number, double *price,
	struct tcs_fault *fault)
{
	struct parts *parts = &removals->parts;
	struct loss loss = {0};
	bool near = true;
	enum tcs_status status = parts_find_hanging(parts, number, fault);
	double cost;

	*price = INFINITY;
	if (status || parts->hanging.count == 0 ||
		parts->hanging.count > MOST_STACKED)
		return status;
	removals->contacts.count = removals->runs.count = 0;
	status = list_around(removals, fault);
	if (!status)
		status = add_stack(removals, &loss, &near, fault);
	cost = price_of(removals, &loss); /* it uses the lists up */
	if (!status && near && loss.faces > 0)
		*price = cost;
	return status;
}
