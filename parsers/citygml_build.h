/*
 * From a raw object to an object of the stream: links resolved, positions read
 * and triangulated, materials put on polygons. The work of one worker thread.
 */
#ifndef TESSERA_CITYGML_BUILD_H
#define TESSERA_CITYGML_BUILD_H

#include "citygml_links.h"
#include "citygml_raw.h"
#include "citygml_store.h"
#include "keyed_hash.h"
#include "number.h"
#include "report.h"
#include "triangulate.h"

/* What all workers are told; read only while they work. */
struct build_plan {
	struct lod_choice lods;
	const struct raw_library *library; /* NULL in the first pass */
	const struct paint_store *store; /* closed; NULL: no global paints */
	struct hash_key id_key; /* of hashes that stand for ids */
};

/* A paint waiting for its polygon. */
struct build_paint {
	uint32_t polygon; /* of the raw object */
	uint32_t paint; /* of the raw object */
};

/* One worker's scratch, reused. All zero but for the triangulator. */
struct builder {
	struct triangulator *triangulator;
	struct link_work links;
	struct number_list numbers;
	TCS_ARRAY(struct tcs_point) points; /* of one polygon, as written */
	TCS_ARRAY(struct tcs_point) scaled; /* the same in metres */
	TCS_ARRAY(uint32_t) ring_sizes;
	TCS_ARRAY(tcs_text) ring_ids;
	TCS_ARRAY(uint32_t) ring_places; /* in the raw polygon */
	TCS_ARRAY(struct build_paint) paints; /* sorted by polygon */
	struct number_list texcoords; /* of one ring */
	TCS_ARRAY(uint32_t) order; /* of the attributes */
	TCS_ARRAY(struct tcs_attribute) attributes;
};

/* A string of `from` in the text of `out`, which may be the same object. */
enum tcs_status text_carry(struct tcs_object *out,
	const struct tcs_object *from, tcs_text text, tcs_text *to,
	struct tcs_fault *fault) TCS_CHECKED;

enum tcs_status builder_init(
	struct builder *builder, struct tcs_fault *fault) TCS_CHECKED;
void builder_release(struct builder *builder);

/*
 * Complete raw->tree: geometries, shells, polygons and what they own. Counts
 * and what was left out go to raw->report. Ids that links name and nothing has
 * are in builder->links.missing for the caller to judge.
 */
enum tcs_status build_object(struct builder *builder,
	const struct build_plan *plan, struct raw_object *raw,
	struct tcs_fault *fault) TCS_CHECKED;

/*
 * Build the prototype of a template: an object of one feature. What has no
 * place in it, links that dangle, is in builder->links.missing too.
 */
enum tcs_status build_prototype(struct builder *builder,
	const struct build_plan *plan, struct raw_object *raw,
	uint32_t geometry, struct tcs_object *out, struct report *report,
	struct tcs_fault *fault) TCS_CHECKED;

/* ---- citygml_rings.c ---------------------------------------------------- */

/*
 * Read the positions of a polygon, line or point into builder->points, and the
 * sizes and ids of its rings, the outer ring first. *problem becomes a static
 * text when the polygon cannot be used, NULL otherwise; harmless repairs are
 * noted in the report.
 */
enum tcs_status rings_read(struct builder *builder,
	const struct raw_object *home, const struct raw_polygon *polygon,
	const char **problem, struct report *report,
	struct tcs_fault *fault) TCS_CHECKED;

/* ---- citygml_triangles.c ------------------------------------------------ */

/*
 * Triangles of the polygon whose points and rings the builder holds; vertices
 * that a repair adds join the points. Nothing for lines and points. The result
 * is valid until the next one.
 */
enum tcs_status polygon_triangulate(struct builder *builder,
	const struct raw_polygon *polygon, struct triangulation *out,
	struct tcs_fault *fault) TCS_CHECKED;

/* ---- citygml_attribute_order.c ------------------------------------------ */

/*
 * Sort the attributes by their features, stably: sets stay before their
 * members. What belongs to no feature is dropped.
 */
enum tcs_status attributes_sort(struct builder *builder,
	struct tcs_object *tree, struct tcs_fault *fault) TCS_CHECKED;

/* ---- citygml_paint_links.c ---------------------------------------------- */

/*
 * Add what global appearances put on the targets of the object, and follow the
 * links of its paints; once.
 */
enum tcs_status paints_fetch(const struct build_plan *plan,
	struct raw_object *raw, struct tcs_fault *fault) TCS_CHECKED;

/* ---- citygml_paint.c ---------------------------------------------------- */

/*
 * After links_resolve: all paints of the object, sorted by polygon. Targets
 * that are not there go to the report; NULL: were reported before.
 */
enum tcs_status paints_collect(struct builder *builder,
	const struct raw_object *raw, struct report *report,
	struct tcs_fault *fault) TCS_CHECKED;

/*
 * Append the paints of one raw polygon to `out`, for its last polygon, whose
 * points are still in the builder.
 */
enum tcs_status paints_write(struct builder *builder,
	const struct raw_object *raw, uint32_t raw_polygon,
	struct tcs_object *out, struct report *report,
	struct tcs_fault *fault) TCS_CHECKED;

#endif
