#include "compare_contacts.h"

#include <math.h>
#include <stdlib.h>

#include "vector.h"

struct judge {
	const struct compare_side *before, *after;
	const struct compare_match *match;
	double eps;
};

/* The images of one side of a contact. */
struct images {
	const uint32_t *at;
	size_t count;
};

static struct images
images_of(const struct judge *judge, uint32_t component)
{
	struct images images;

	images.at = match_images(judge->match, component, &images.count);
	return images;
}

static const struct component *
after_component(const struct judge *judge, uint32_t number)
{
	return &judge->after->set.components.at[number];
}

/* ---- gaps ---------------------------------------------------------------- */

static bool
is_enclosed(const struct judge *judge, uint32_t inner, uint32_t outer)
{
	const struct component_set *set = &judge->after->set;
	const struct component *shell = &set->components.at[outer];
	uint32_t first = set->order.at[set->components.at[inner].first];

	return shell->closed &&
		triangle_tree_encloses(&set->tree, shell->root,
			component_set_shape(set, first).corner[0]);
}

/* 0 for what is one component, or one inside the other. */
static double
gap_between(const struct judge *judge, uint32_t a, uint32_t b, double reach)
{
	double gap;

	if (a == b)
		return 0;
	gap = triangle_tree_gap(&judge->after->set.tree,
		after_component(judge, a)->root,
		after_component(judge, b)->root, reach, 2 * judge->eps)
		      .distance;
	if (gap > 2 * judge->eps &&
		(is_enclosed(judge, a, b) || is_enclosed(judge, b, a)))
		return 0;
	return gap;
}

static double
least_gap(const struct judge *judge, struct images a, struct images b)
{
	double least = INFINITY;

	for (size_t i = 0; i < a.count; i++)
		for (size_t k = 0; k < b.count; k++) {
			least = fmin(least,
				gap_between(judge, a.at[i], b.at[k], least));
			if (least <= 2 * judge->eps)
				return least;
		}
	return least;
}

/* ---- seams --------------------------------------------------------------- */

/* Points of the contact before, and how many of them gape after. */
struct seam {
	const struct judge *judge;
	struct images a, b;
	unsigned long points, gaping;
};

static struct tree_hit
nearest_image(
	const struct judge *judge, struct images images, struct tcs_point from)
{
	struct tree_hit best = {.distance = INFINITY};

	for (size_t i = 0; i < images.count; i++) {
		struct tree_hit hit =
			triangle_tree_nearest(&judge->after->set.tree,
				after_component(judge, images.at[i])->root,
				from, best.distance);

		if (hit.distance < best.distance)
			best = hit;
	}
	return best;
}

static bool
image_encloses(
	const struct judge *judge, struct images images, struct tcs_point point)
{
	for (size_t i = 0; i < images.count; i++) {
		const struct component *component =
			after_component(judge, images.at[i]);

		if (component->closed &&
			triangle_tree_encloses(&judge->after->set.tree,
				component->root, point))
			return true;
	}
	return false;
}

/* From where one side went, how far the other is now. */
static bool
is_apart(const struct judge *judge, struct images from, struct images to,
	struct tcs_point point)
{
	struct tcs_point at = nearest_image(judge, from, point).point;

	return nearest_image(judge, to, at).distance > 2 * judge->eps &&
		!image_encloses(judge, to, at);
}

static void
add_seam_point(struct seam *seam, struct tcs_point point)
{
	seam->points++;
	seam->gaping += is_apart(seam->judge, seam->a, seam->b, point) &&
		is_apart(seam->judge, seam->b, seam->a, point);
}

/* The corners, the middles of the edges and the centre of one triangle, as far
   as the other is in reach. */
static void
add_seam_points(struct seam *seam, const struct triangle_shape *shape,
	const struct triangle_shape *other)
{
	const struct tcs_point *c = shape->corner;
	const struct tcs_point points[] = {
		c[0],
		c[1],
		c[2],
		vector_scaled(vector_sum(c[0], c[1]), 0.5),
		vector_scaled(vector_sum(c[1], c[2]), 0.5),
		vector_scaled(vector_sum(c[2], c[0]), 0.5),
		vector_scaled(
			vector_sum(c[0], vector_sum(c[1], c[2])), 1.0 / 3),
	};

	for (size_t i = 0; i < sizeof points / sizeof *points; i++) {
		struct tcs_point at = triangle_nearest(other, points[i]);

		if (vector_length(vector_difference(at, points[i])) <=
			seam->judge->eps)
			add_seam_point(seam, points[i]);
	}
}

static bool
visit_seam(void *context, uint32_t a, uint32_t b)
{
	struct seam *seam = context;
	const struct triangle_tree *tree = &seam->judge->before->set.tree;
	const struct triangle_shape *p = &tree->shapes.at[a];
	const struct triangle_shape *q = &tree->shapes.at[b];
	struct tcs_point points[2];

	if (triangle_gap(p, q, points) > seam->judge->eps)
		return true;
	add_seam_point(seam, points[0]);
	add_seam_points(seam, p, q);
	add_seam_points(seam, q, p);
	return true;
}

static bool
is_half_open(const struct judge *judge, const struct contact *contact,
	struct images a, struct images b)
{
	const struct component_set *set = &judge->before->set;
	struct seam seam = {judge, a, b, 0, 0};

	if (contact->inside)
		return false;
	box_tree_pairs(&set->tree.boxes, set->components.at[contact->a].root,
		set->components.at[contact->b].root, judge->eps, visit_seam,
		&seam);
	return seam.points > 0 && 4 * seam.gaping >= seam.points;
}

static struct broken_contact
judge_contact(const struct judge *judge, const struct contact *contact)
{
	struct images a = images_of(judge, contact->a);
	struct images b = images_of(judge, contact->b);
	struct broken_contact out = {
		CONTACT_LOST, contact->a, contact->b, INFINITY};

	if (!a.count || !b.count)
		return out;
	out.gap = least_gap(judge, a, b);
	if (out.gap > 2 * judge->eps)
		out.state = CONTACT_SEPARATED;
	else if (is_half_open(judge, contact, a, b))
		out.state = CONTACT_HALF_OPEN;
	else
		out.state = CONTACT_KEPT;
	return out;
}

static enum tcs_status
judge_contacts(const struct judge *judge, struct compare_metrics *metrics,
	struct broken_list *broken, struct tcs_fault *fault)
{
	const struct contact_list *contacts = &judge->before->contacts;
	static const enum compare_metric counts[] = {COMPARE_CONTACTS_KEPT,
		COMPARE_CONTACTS_SEPARATED, COMPARE_CONTACTS_HALF_OPEN,
		COMPARE_CONTACTS_LOST};

	metrics->at[COMPARE_CONTACTS_BEFORE] = (double)contacts->count;
	for (size_t i = 0; i < contacts->count; i++) {
		struct broken_contact found =
			judge_contact(judge, &contacts->at[i]);

		metrics->at[counts[found.state]]++;
		if (found.state == CONTACT_KEPT)
			continue;
		if (found.state == CONTACT_SEPARATED)
			metrics->at[COMPARE_GAP_MAX] =
				fmax(metrics->at[COMPARE_GAP_MAX], found.gap);
		if (array_grow(broken, 1))
			return fault_memory(fault);
		broken->at[broken->count++] = found;
	}
	return TCS_OK;
}

/* ---- what stands on the ground ------------------------------------------- */

static uint32_t
find_root(uint32_t *parents, uint32_t i)
{
	while (parents[i] != i) {
		parents[i] = parents[parents[i]];
		i = parents[i];
	}
	return i;
}

/* Per component whether a chain of contacts leads to one at the ground. The
   ground is an element behind the components. NULL without memory. */
static uint32_t *
find_grounded(const struct compare_side *side, double ground)
{
	uint32_t count = (uint32_t)side->set.components.count;
	uint32_t *parents = calloc((size_t)count + 1, sizeof *parents);

	if (!parents)
		return NULL;
	for (uint32_t i = 0; i <= count; i++)
		parents[i] = i;
	for (uint32_t i = 0; i < count; i++)
		if (side->set.components.at[i].box.low[2] <= ground)
			parents[i] = count;
	for (size_t i = 0; i < side->contacts.count; i++) {
		uint32_t a = find_root(parents, side->contacts.at[i].a);
		uint32_t b = find_root(parents, side->contacts.at[i].b);

		if (a < b)
			parents[a] = b;
		else
			parents[b] = a;
	}
	for (uint32_t i = 0; i < count; i++)
		parents[i] = find_root(parents, i);
	return parents;
}

static double
count_floating(const struct judge *judge, const uint32_t *before,
	const uint32_t *after)
{
	uint32_t count = (uint32_t)judge->before->set.components.count;
	uint32_t ground = (uint32_t)judge->after->set.components.count;
	double floating = 0;

	for (uint32_t i = 0; i < count; i++) {
		struct images images = images_of(judge, i);
		bool stands = false;

		for (size_t k = 0; k < images.count; k++)
			stands |= after[images.at[k]] == ground;
		floating += before[i] == count && images.count > 0 && !stands;
	}
	return floating;
}

static enum tcs_status
judge_floating(const struct judge *judge, struct compare_metrics *metrics,
	struct tcs_fault *fault)
{
	double ground = judge->before->set.bounds.low[2];
	uint32_t *before = find_grounded(judge->before, ground + judge->eps);
	uint32_t *after = find_grounded(judge->after, ground + 2 * judge->eps);
	enum tcs_status status = TCS_OK;

	if (!before || !after)
		status = fault_memory(fault);
	else
		metrics->at[COMPARE_COMPONENTS_FLOATING] =
			count_floating(judge, before, after);
	free(before);
	free(after);
	return status;
}

/* ---- components ---------------------------------------------------------- */

/* What is left of a component, over all its images. */
struct remains {
	double area, volume;
	bool closed;
};

static struct remains
remains_of(const struct judge *judge, struct images images)
{
	struct remains remains = {.closed = true};

	for (size_t i = 0; i < images.count; i++) {
		const struct component *image =
			after_component(judge, images.at[i]);

		remains.area += image->area;
		remains.volume += image->volume;
		remains.closed &= image->closed;
	}
	return remains;
}

static void
judge_components(const struct judge *judge, struct compare_metrics *metrics)
{
	const struct component_set *set = &judge->before->set;

	for (uint32_t i = 0; i < set->components.count; i++) {
		const struct component *own = &set->components.at[i];
		struct images images = images_of(judge, i);
		struct remains left = remains_of(judge, images);
		bool solid = own->closed && left.closed;

		if (!images.count)
			metrics->at[COMPARE_COMPONENTS_LOST]++;
		if (!images.count || judge->match->merged.at[i])
			continue;
		metrics->at[COMPARE_COMPONENTS_CRUSHED] +=
			10 * left.area < own->area ||
			(solid && 10 * fabs(left.volume) < fabs(own->volume));
		metrics->at[COMPARE_COMPONENTS_FLIPPED] +=
			solid && left.volume * own->volume < 0;
	}
}

enum tcs_status
compare_contacts(const struct compare_side *before, struct compare_side *after,
	const struct compare_match *match, double eps,
	struct compare_metrics *metrics, struct broken_list *broken,
	struct tcs_fault *fault)
{
	struct judge judge = {before, after, match, eps};
	enum tcs_status status =
		contacts_find(&after->set, 2 * eps, &after->contacts, fault);

	broken->count = 0;
	if (!status)
		status = judge_contacts(&judge, metrics, broken, fault);
	if (!status)
		status = judge_floating(&judge, metrics, fault);
	if (!status)
		judge_components(&judge, metrics);
	return status;
}
