/*
 * Whether a component encloses a point: whether a ray from there meets it an
 * odd number of times.
 */
#ifndef TESSERA_ENCLOSURE_H
#define TESSERA_ENCLOSURE_H

#include "face_boxes.h"

/*
 * Ask rays along the axes, in turn, until one keeps clear of all edges, and a
 * slanting one after them. Takes the steps of a search in `boxes` and what the
 * ray meets. Fails with TCS_NO_MEMORY.
 */
enum tcs_status component_encloses(const struct component_set *set,
	const struct sheets *sheets, const struct face_boxes *boxes,
	uint32_t component, struct tcs_point point, struct face_list *scratch,
	bool *encloses, struct tcs_fault *fault) TCS_CHECKED;

#endif
