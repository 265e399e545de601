#include "enclosure.h"

#include <math.h>

#include "vector.h"

/* A hit this near to an edge, as a share of the triangle, may be none. */
#define CLEAR_OF_EDGES 1e-9

static bool
is_odd(const struct component_set *set, const struct sheets *sheets,
	const struct face_list *faces, struct tcs_point from,
	struct tcs_point along, bool *clear)
{
	bool odd = false;

	*clear = true;
	for (size_t i = 0; i < faces->count; i++) {
		struct triangle_shape shape = component_set_shape(
			set, sheets->face_triangles.at[faces->at[i]]);
		double t = 0, margin = 1;
		bool hit = triangle_hit(&shape, from, along, &t, &margin);

		*clear &= fabs(margin) > CLEAR_OF_EDGES;
		odd ^= hit && t > 0;
	}
	return odd;
}

enum tcs_status
component_encloses(const struct component_set *set, const struct sheets *sheets,
	const struct face_boxes *boxes, uint32_t component,
	struct tcs_point point, struct face_list *scratch, bool *encloses,
	struct tcs_fault *fault)
{
	static const struct tcs_point ways[] = {{0, 0, 1}, {0, 0, -1},
		{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0},
		{0.267, 0.153, 0.951}};
	const struct box *bounds = &set->components.at[component].box;
	double size = 2 * box_diagonal(bounds);
	bool clear = false;

	for (size_t i = 0; !clear && i < sizeof ways / sizeof *ways; i++) {
		struct float_box ray = float_box_around(
			point, vector_along(point, ways[i], size), 0);
		enum tcs_status status =
			face_boxes_near(boxes, component, &ray, scratch, fault);

		if (status)
			return status;
		*encloses =
			is_odd(set, sheets, scratch, point, ways[i], &clear);
	}
	return TCS_OK;
}
