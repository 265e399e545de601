/*
 * How much of its volume each component still has.
 *
 * A closed component may keep its contacts and its place while it is pressed
 * flat, a post into a blade, and quadrics of small faces hardly object. Falling
 * below a tenth of its volume has a price: that of some contacts. A panel that
 * stands in a wall (panels.h) is hidden bit by bit, and pays for every bit.
 */
#ifndef TESSERA_VOLUME_WATCH_H
#define TESSERA_VOLUME_WATCH_H

#include "error_watch.h"

/* All zero is empty; reused from object to object. */
struct volume_watch {
	TCS_ARRAY(double) volumes; /* per component: cubic metres, as it is */
	TCS_ARRAY(double) panels; /* per component: as one was made; or 0 */
	double change; /* by the collapse that is looked at */
};

/* Fails with TCS_NO_MEMORY. */
enum tcs_status volume_watch_begin(struct volume_watch *watch,
	const struct component_set *set, struct tcs_fault *fault) TCS_CHECKED;

/* What changes when the vertex of the ring moves to `place` is added to that;
   faces that have the node `without`, too, are of another ring. */
void volume_watch_look(struct collapses *work, const struct watch_ring *ring,
	struct tcs_point place);

/* A component has become a panel of so many cubic metres. */
void volume_watch_panel(
	struct volume_watch *watch, uint32_t component, double volume);

/* Contacts that it is worth not to do what was looked at. */
double volume_watch_worth(const struct collapses *work, uint32_t node);

/* It is done. */
void volume_watch_follow(struct collapses *work, uint32_t node);

/* Triangles take the place of faces, before they do. */
struct refill;
void volume_watch_refill(struct collapses *work, const struct refill *refill);

void volume_watch_release(struct volume_watch *watch);

#endif
