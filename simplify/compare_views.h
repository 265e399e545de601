/*
 * What of an object is seen before and after, from places in the street and in
 * the air.
 *
 * source: W, the visibility analysis of the evaluation, and L, the similarity
 * of pictures.
 */
#ifndef TESSERA_COMPARE_VIEWS_H
#define TESSERA_COMPARE_VIEWS_H

#include "compare_contacts.h"
#include "compare_metrics.h"
#include "raster.h"

enum {
	STREET_VIEWS = 8,
	AERIAL_VIEWS = 4,
	ALL_VIEWS = STREET_VIEWS + AERIAL_VIEWS,
	VIEW_BOXES = 24, /* rows and columns of boxes behind the object */
};

/*
 * The places from which both are looked at, which is to the middle of the box
 * of `before` from one and a half of its diagonals: in the street, 1.7 m above
 * the lowest point, from east, north-east and so on; in the air, 45 degrees
 * up, from between them. `before` has triangles.
 */
struct view compare_view(const struct component_set *before, int number);

/* How bright a pixel that shows the triangle is, 0.3 to 1. */
double view_grey(const struct component_set *set, uint32_t triangle,
	const struct view *view);

/* All zero is empty; reused. */
struct compare_pictures {
	struct raster rasters[2][ALL_VIEWS];
};

/*
 * Draw both from everywhere, `size` pixels wide and high, and fill in the
 * metrics. `broken` are the contacts of `before` that broke. Uses before->set.jobs threads. Without triangles before nothing is
 * seen. Fails with TCS_NO_MEMORY, TCS_SYSTEM.
 */
enum tcs_status compare_views(const struct compare_side *before,
	const struct compare_side *after, const struct compare_match *match,
	const struct broken_list *broken, unsigned size,
	struct compare_pictures *pictures, struct compare_metrics *metrics,
	struct tcs_fault *fault) TCS_CHECKED;

void pictures_release(struct compare_pictures *pictures);

#endif
