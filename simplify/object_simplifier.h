/*
 * One object to its levels of detail: choose the triangles, find components,
 * contacts and seams, collapse under one budget for all components, and write
 * the levels, each further down the same sequence of collapses.
 */
#ifndef TESSERA_OBJECT_SIMPLIFIER_H
#define TESSERA_OBJECT_SIMPLIFIER_H

#include "collapses.h"
#include "face_budget.h"
#include "handles.h"
#include "lod_source.h"
#include "lod_write.h"
#include "merges.h"
#include "openings.h"
#include "overlaps.h"
#include "paint_charts.h"
#include "report.h"

enum { SIMPLIFY_LEVELS = 8 };

struct simplify_level {
	struct face_budget budget;
	int lod; /* 0…4, or LOD_IN_PLACE */
};

enum placement { PLACE_HALF_EDGE, PLACE_OPTIMAL }; /* see placement.h */

struct simplify_settings {
	struct simplify_level levels[SIMPLIFY_LEVELS]; /* each leaves
	                                                  less than the last */
	size_t level_count;
	int source; /* level that is simplified, see lod_select.h */
	double base_ratio; /* of the cost of a boundary vertex */
	enum placement placement;
	double max_error; /* metres, see error_watch.h; 0: any */
	unsigned jobs; /* threads that a large object may use; 0 is 1 */
	bool keep_interior; /* parts count as if they were seen */
	struct tcs_crs crs;
};

/* All zero is ready; one thread at a time. */
struct object_simplifier {
	struct lod_source source;
	struct sheets sheets;
	struct paint_charts charts;
	struct contact_list contacts;
	struct seams seams;
	struct collapses collapses;
	struct lod_writer writer;
	struct openings openings;
	struct overlaps overlaps;
	struct removals removals;
	struct handles handles;
	struct merges merges;
	TCS_ARRAY(uint32_t) homes; /* see lod_home.h */
	TCS_ARRAY(bool) hosts; /* per feature: see selection */
};

/*
 * Simplify an object; *out is valid until the next call, and lends from `in`.
 * What was reached and what was not goes to the report. Fails with
 * TCS_NO_MEMORY, TCS_LIMIT.
 */
enum tcs_status simplify_object(struct object_simplifier *simplifier,
	const struct simplify_settings *settings, const struct tcs_object *in,
	const struct tcs_object **out, struct report *report,
	struct tcs_fault *fault) TCS_CHECKED;

void object_simplifier_release(struct object_simplifier *simplifier);

#endif
