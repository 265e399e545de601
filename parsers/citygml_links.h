/*
 * Which polygon goes where: links followed, levels of detail picked, and
 * every polygon given to one geometry and one surface.
 *
 * A solid that links to the polygons of boundary surfaces, a surface that
 * links into the solid, and a host's multi-surface that repeats both are one
 * geometry: per level of detail, solids take their polygons first and learn
 * from the boundary surfaces which surface each belongs to, then boundary
 * surfaces take what is left, then the rest.
 */
#ifndef TESSERA_CITYGML_LINKS_H
#define TESSERA_CITYGML_LINKS_H

#include <stdbool.h>
#include <stdint.h>

#include "array.h"
#include "citygml_library.h"
#include "citygml_raw.h"

/* Which levels of detail are wanted. */
struct lod_choice {
	bool highest; /* of each feature */
	bool lods[5]; /* else these */
};

enum use_state {
	USE_OPEN,
	USE_KEPT, /* goes into its geometry */
	USE_ABSORBED, /* the same polygon goes elsewhere */
	USE_UNWANTED, /* another level of detail is wanted */
};

/* One use of a polygon by a geometry, directly or through links. */
struct raw_use {
	const struct raw_object *home; /* where the polygon is */
	uint32_t polygon; /* of home */
	uint32_t key; /* the same for uses of the same polygon */
	uint32_t geometry; /* of the object */
	uint32_t shell; /* of the object or of home; TCS_NONE */
	uint32_t surface; /* feature it belongs to, once kept */
	uint32_t next; /* use of the same polygon; TCS_NONE */
	uint8_t state; /* enum use_state */
	bool reversed;
	bool linked; /* came through a link */
	bool shared; /* an earlier use, or another object, has it too */
};

/* Scratch of one worker, reused; all zero is empty. */
struct link_work {
	TCS_ARRAY(struct raw_use) uses; /* in the order of the geometries */
	TCS_ARRAY(uint32_t) first_use; /* per geometry, and the end */
	TCS_ARRAY(uint8_t) lods; /* per geometry: its level of detail */
	TCS_ARRAY(uint32_t) groups; /* per feature: whose LODs it shares */
	TCS_ARRAY(uint32_t) foreign; /* uses of the library's polygons */
	uint32_t keys; /* how many polygons are used: keys are below it */
	TCS_ARRAY(uint32_t) heads; /* per key: its first use at a LOD */
	TCS_ARRAY(bool) emitted; /* per key: kept at some LOD */
	struct id_index targets; /* of the object, by id */
	TCS_ARRAY(tcs_text) missing; /* ids that no target has */
	TCS_ARRAY(bool) unwanted; /* per instance: of another level */
	uint64_t left_out; /* areas at levels of detail not wanted */
};

void link_work_release(struct link_work *work);

/*
 * Follow the links of the object and decide every use. `library` may be NULL.
 * What cannot be followed is in work->missing, and each geometry keeps the
 * rest. Links that go in circles or multiply beyond reason are reported.
 * Fails with TCS_NO_MEMORY.
 */
enum tcs_status links_resolve(struct link_work *work,
	const struct raw_object *raw, const struct raw_library *library,
	const struct lod_choice *choice, struct report *report,
	struct tcs_fault *fault) TCS_CHECKED;

/*
 * The same for one template: all it holds is kept, and nothing else is.
 */
enum tcs_status links_resolve_template(struct link_work *work,
	const struct raw_object *raw, const struct raw_library *library,
	uint32_t geometry, struct report *report,
	struct tcs_fault *fault) TCS_CHECKED;

/* Whether a link names something outside the document. */
bool link_is_foreign(const char *href);

#endif
