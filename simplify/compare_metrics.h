/*
 * What a comparison measures of one object, or of all of them together:
 * numbers by name. tcs-compare(1) says what each means.
 */
#ifndef TESSERA_COMPARE_METRICS_H
#define TESSERA_COMPARE_METRICS_H

#include <stdio.h>

#include "tcs.h"

/*
 * X(NAME, name in the report, decimals, how objects add up). Distances are
 * METRES with six decimals, the rest counts, square and cubic metres. BEFORE
 * and AFTER: a mean weighted by that side's area; _SQUARE: of the squares. PIXELS:
 * one weighted by the number of pixels.
 */
#define COMPARE_METRICS(X) \
	X(TRIANGLES_BEFORE, "triangles_before", 0, SUM) \
	X(TRIANGLES_AFTER, "triangles_after", 0, SUM) \
	X(COMPONENTS_BEFORE, "components_before", 0, SUM) \
	X(COMPONENTS_AFTER, "components_after", 0, SUM) \
	X(COMPONENTS_LOST, "components_lost", 0, SUM) \
	X(COMPONENTS_CRUSHED, "components_crushed", 0, SUM) \
	X(COMPONENTS_FLOATING, "components_floating", 0, SUM) \
	X(COMPONENTS_FLIPPED, "components_flipped", 0, SUM) \
	X(CONTACTS_BEFORE, "contacts_before", 0, SUM) \
	X(CONTACTS_KEPT, "contacts_kept", 0, SUM) \
	X(CONTACTS_SEPARATED, "contacts_separated", 0, SUM) \
	X(CONTACTS_HALF_OPEN, "contacts_half_open", 0, SUM) \
	X(CONTACTS_LOST, "contacts_lost", 0, SUM) \
	X(CONTACTS_CRUSHED, "contacts_crushed", 0, SUM) \
	X(GAP_MAX, "gap_max", 6, MAX) \
	X(SURFACES_BEFORE, "surfaces_before", 0, SUM) \
	X(SURFACES_LOST, "surfaces_lost", 0, SUM) \
	X(THERE_MAX, "distance_max", 6, MAX) \
	X(THERE_AT_MOST, "distance_at_most", 6, MAX) \
	X(THERE_MEAN, "distance_mean", 6, BEFORE) \
	X(THERE_RMS, "distance_rms", 6, BEFORE_SQUARE) \
	X(THERE_SPACING, "distance_spacing", 6, MAX) \
	X(BACK_MAX, "distance_back_max", 6, MAX) \
	X(BACK_AT_MOST, "distance_back_at_most", 6, MAX) \
	X(BACK_MEAN, "distance_back_mean", 6, AFTER) \
	X(BACK_RMS, "distance_back_rms", 6, AFTER_SQUARE) \
	X(BACK_SPACING, "distance_back_spacing", 6, MAX) \
	X(AREA_BEFORE, "area_before", 3, SUM) \
	X(AREA_AFTER, "area_after", 3, SUM) \
	X(VOLUME_BEFORE, "volume_before", 3, SUM) \
	X(VOLUME_AFTER, "volume_after", 3, SUM) \
	X(OPEN_BEFORE, "open_edges_before", 0, SUM) \
	X(OPEN_AFTER, "open_edges_after", 0, SUM) \
	X(NON_MANIFOLD_BEFORE, "non_manifold_edges_before", 0, SUM) \
	X(NON_MANIFOLD_AFTER, "non_manifold_edges_after", 0, SUM) \
	X(MISALIGNED_BEFORE, "misaligned_edges_before", 0, SUM) \
	X(MISALIGNED_AFTER, "misaligned_edges_after", 0, SUM) \
	X(DEGENERATE_BEFORE, "degenerate_triangles_before", 0, SUM) \
	X(DEGENERATE_AFTER, "degenerate_triangles_after", 0, SUM) \
	X(DUPLICATE_BEFORE, "duplicate_triangles_before", 0, SUM) \
	X(DUPLICATE_AFTER, "duplicate_triangles_after", 0, SUM) \
	X(CROSSING_OWN_BEFORE, "self_crossings_before", 0, SUM) \
	X(CROSSING_OWN_AFTER, "self_crossings_after", 0, SUM) \
	X(CROSSING_BEFORE, "crossing_components_before", 0, SUM) \
	X(CROSSING_AFTER, "crossing_components_after", 0, SUM) \
	X(CROSSING_NEW, "crossing_components_new", 0, SUM) \
	X(FLIPPED, "flipped_triangles", 0, SUM) \
	X(PIXELS, "pixels", 0, SUM) \
	X(HIT, "pixels_hit_share", 3, PIXELS) \
	X(SAME_SURFACE, "pixels_surface_share", 3, PIXELS) \
	X(SIMILARITY, "similarity", 3, PIXELS) \
	X(COMPONENTS_SEEN, "components_seen", 0, SUM) \
	X(COMPONENTS_HIDDEN, "components_hidden", 0, SUM) \
	X(CONTACTS_SEEN, "contacts_seen", 0, SUM) \
	X(CONTACTS_SEEN_BROKEN, "contacts_seen_broken", 0, SUM) \
	X(SURFACES_SEEN, "surfaces_seen", 0, SUM) \
	X(SURFACES_HIDDEN, "surfaces_hidden", 0, SUM) \
	X(SURFACES_UNCOVERED, "surfaces_uncovered", 0, SUM) \
	X(BOXES_BEFORE, "boxes_seen_before", 0, SUM) \
	X(BOXES_AFTER, "boxes_seen_after", 0, SUM) \
	X(BOXES_OPENED, "boxes_opened", 0, SUM) \
	X(DIAGONAL, "diagonal", 6, MAX) \
	X(EPS, "eps", 6, MAX)

enum compare_metric {
#define COMPARE_NUMBER(number, name, decimals, sum) COMPARE_##number,
	COMPARE_METRICS(COMPARE_NUMBER)
#undef COMPARE_NUMBER
		COMPARE_METRIC_COUNT,
};

/* All zero is the start of a sum. A value that is not finite is unknown: there
   was nothing to measure to. */
struct compare_metrics {
	double at[COMPARE_METRIC_COUNT];
};

/* Add an object to the sum over objects. Unknown values are left out. */
void metrics_add(
	struct compare_metrics *sum, const struct compare_metrics *object);

/* 1 - triangles after / before; 0 where there were none. */
double metrics_rate(const struct compare_metrics *metrics);

/* "name":value pairs with a comma before each; unknown ones are null. Errors
   are the stream's. */
void metrics_print_json(const struct compare_metrics *metrics, FILE *to);

/* A row of an HTML table for each. */
void metrics_print_html(const struct compare_metrics *metrics, FILE *to);

/* A few lines for people, without unknown values and zeros nobody needs. */
void metrics_print(const struct compare_metrics *metrics, FILE *to);

#endif
