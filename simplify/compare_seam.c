#include "compare_seam.h"

#include <math.h>

#include "vector.h"

enum { MOST_TRIANGLES = 100 };

struct seam {
	const struct compare_side *before, *after;
	const struct compare_match *match;
	struct images a, b; /* what the two sides became */
	bool in_one; /* both are in some component */
	double eps;
	unsigned long points, gaping;
};

/* One side of the seam, while its triangles are visited. */
struct seam_side {
	struct seam *seam;
	uint32_t other; /* the root of the other side */
	size_t count; /* triangles in the box of the other side */
	size_t step; /* one in so many is taken; 0: only counting */
};

/* All that a piece is in, unless the other side is in it as well. */
static uint32_t
root_of(const struct seam *seam, const struct match_piece *piece)
{
	return seam->in_one
		? piece->root
		: seam->after->set.components.at[piece->component].root;
}

static struct tree_hit
nearest_image(const struct seam *seam, struct images images,
	struct tcs_point from, double reach)
{
	struct tree_hit best = {.distance = INFINITY};

	for (size_t i = 0; i < images.count; i++) {
		struct tree_hit hit = triangle_tree_nearest(
			&seam->after->set.tree,
			root_of(seam, &seam->match->pieces.at[images.at[i]]),
			from, reach);

		if (hit.distance < best.distance) {
			best = hit;
			reach = hit.distance;
		}
	}
	return best;
}

static bool
image_encloses(
	const struct seam *seam, struct images images, struct tcs_point point)
{
	const struct component_set *set = &seam->after->set;

	for (size_t i = 0; i < images.count; i++) {
		const struct match_piece *piece =
			&seam->match->pieces.at[images.at[i]];

		if ((!piece->region || !seam->in_one) &&
			set->components.at[piece->component].closed &&
			triangle_tree_encloses(
				&set->tree, root_of(seam, piece), point))
			return true;
	}
	return false;
}

/* Whether some component has both sides. */
static bool
share_component(const struct seam *seam)
{
	const struct match_piece *pieces = seam->match->pieces.at;

	for (size_t i = 0; i < seam->a.count; i++)
		for (size_t k = 0; k < seam->b.count; k++)
			if (pieces[seam->a.at[i]].component ==
				pieces[seam->b.at[k]].component)
				return true;
	return false;
}

/* Whether a component that has both sides is still there. */
static bool
is_in_one(const struct seam *seam, struct tcs_point point)
{
	const struct component_set *set = &seam->after->set;
	const struct match_piece *pieces = seam->match->pieces.at;
	double reach = 2 * seam->eps;

	for (size_t i = 0; seam->in_one && i < seam->a.count; i++)
		for (size_t k = 0; k < seam->b.count; k++) {
			uint32_t number = pieces[seam->a.at[i]].component;
			const struct component *own =
				&set->components.at[number];

			if (number != pieces[seam->b.at[k]].component)
				continue;
			if (isfinite(triangle_tree_nearest(
				    &set->tree, own->root, point, reach)
					     .distance) ||
				(own->closed &&
					triangle_tree_encloses(
						&set->tree, own->root, point)))
				return true;
		}
	return false;
}

/* From where one side is nearest now, a closed one being full, how far the
   other is. */
static bool
is_apart(const struct seam *seam, struct images from, struct images to,
	struct tcs_point point)
{
	struct tcs_point at = image_encloses(seam, from, point)
		? point
		: nearest_image(seam, from, point, INFINITY).point;

	return !isfinite(nearest_image(seam, to, at, 2 * seam->eps).distance) &&
		!image_encloses(seam, to, at);
}

static void
add_point(struct seam *seam, struct tcs_point point)
{
	seam->points++;
	seam->gaping += is_apart(seam, seam->a, seam->b, point) &&
		is_apart(seam, seam->b, seam->a, point) &&
		!is_in_one(seam, point);
}

static void
add_triangle(const struct seam_side *side, const struct triangle_shape *shape)
{
	const struct triangle_tree *tree = &side->seam->before->set.tree;
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
	double eps = side->seam->eps;
	struct tree_gap gap =
		triangle_tree_gap_from(tree, side->other, shape, eps);

	if (!isfinite(gap.distance))
		return;
	add_point(side->seam, gap.points[0]);
	for (size_t i = 0; i < sizeof points / sizeof *points; i++)
		if (isfinite(triangle_tree_nearest(
			    tree, side->other, points[i], eps)
				     .distance))
			add_point(side->seam, points[i]);
}

static bool
visit_triangle(void *context, uint32_t position)
{
	struct seam_side *side = context;
	const struct triangle_tree *tree = &side->seam->before->set.tree;

	if (side->step > 0 && side->count % side->step == 0)
		add_triangle(side, &tree->shapes.at[position]);
	side->count++;
	return true;
}

static void
add_side(struct seam *seam, uint32_t own, uint32_t other)
{
	const struct component_set *set = &seam->before->set;
	const struct component *component = &set->components.at[other];
	uint32_t root = set->components.at[own].root;
	struct seam_side side = {seam, component->root, 0, 0};

	box_tree_near(&set->tree.boxes, root, &component->box, seam->eps,
		visit_triangle, &side);
	side.step = side.count / MOST_TRIANGLES + 1;
	side.count = 0;
	box_tree_near(&set->tree.boxes, root, &component->box, seam->eps,
		visit_triangle, &side);
}

bool
seam_is_half_open(const struct compare_side *before,
	const struct compare_side *after, const struct compare_match *match,
	const struct contact *contact, double eps)
{
	struct seam seam = {before, after, match,
		match_images(match, contact->a),
		match_images(match, contact->b), false, eps, 0, 0};

	if (contact->inside)
		return false;
	seam.in_one = share_component(&seam);
	add_side(&seam, contact->a, contact->b);
	add_side(&seam, contact->b, contact->a);
	return seam.points > 0 && 4 * seam.gaping >= seam.points;
}

bool
component_is_still(const struct compare_side *before, uint32_t component,
	const struct compare_side *after, const struct compare_match *match,
	double far)
{
	const struct component *own = &before->set.components.at[component];
	struct seam seam = {.before = before,
		.after = after,
		.match = match,
		.in_one = true};
	struct images images = match_images(match, component);

	for (uint32_t i = 0; i < own->count; i++) {
		struct triangle_shape shape = component_set_shape(
			&before->set, before->set.order.at[own->first + i]);
		struct tcs_point centre = vector_scaled(
			vector_sum(shape.corner[0],
				vector_sum(shape.corner[1], shape.corner[2])),
			1.0 / 3);
		struct tree_hit hit = nearest_image(&seam, images, centre, far);
		struct triangle_shape image;

		if (!isfinite(hit.distance))
			return false;
		image = component_set_shape(&after->set, hit.item);
		for (int k = 0; k < 3; k++) {
			struct tcs_point at =
				triangle_nearest(&image, shape.corner[k]);

			if (vector_length(vector_difference(
				    at, shape.corner[k])) > far)
				return false;
		}
	}
	return true;
}
