/*
 * What it costs to take a whole part of an object away, beside what collapses
 * cost, and doing it: the cheapest first, and together with all that would not
 * stand without it. How prices are found is in removal_price.c.
 *
 * A part costs the area that is seen of it, and a little of what is not, times
 * the square of how far its surface is from what stays; and for every contact
 * that breaks and every surface that vanishes as much as a shape that is off
 * by a set share of the object's size. That is shared by half of its faces,
 * for a collapse takes two.
 *
 * source: W, small connecting components (Wang et al. 2021, ISPRS IJGI 10,
 * 422); the cost is ours.
 */
#ifndef TESSERA_REMOVALS_H
#define TESSERA_REMOVALS_H

#include "collapses.h"
#include "parts.h"

/* What is hidden counts as this share of what is seen. */
#define HIDDEN_SHARE 0.2

/* Of what a part is linked to, so many are asked. */
enum { MOST_LINKS = 1000 };

/* What a contact that breaks costs, in an object of that size. */
double contact_cost(const struct component_set *set);

/* Faces of one surface. */
struct surface_run {
	uint32_t feature, faces;
};

/* All zero is empty; reused from object to object. */
struct removals {
	struct parts parts;
	struct collapses *work; /* borrowed */
	const struct contact_list *list; /* borrowed */
	struct node_queue queue; /* of parts, by their price */
	/* Per part: square metres that are seen, 3/8 of the area where all of it
	   lies open; empty while unknown. */
	TCS_ARRAY(double) visible;
	/* Per part: metres that its surface is from what stays, at least; and
	   whether that was measured since what it is linked to last changed. */
	TCS_ARRAY(double) distances;
	TCS_ARRAY(bool) measured;
	/* Per part: its price is that of all that hangs in the air without it */
	TCS_ARRAY(bool) with_stack;
	struct triangle_tree tree; /* of parts that were asked for */
	TCS_ARRAY(uint32_t) roots; /* per part: in the tree; TCS_NONE */
	TCS_ARRAY(uint32_t) items; /* scratch: triangles of a part */
	TCS_ARRAY(uint32_t) contacts; /* scratch: of what goes */
	TCS_ARRAY(uint32_t) held; /* scratch: per contact, points of it; or 0 */
	TCS_ARRAY(struct surface_run) runs; /* scratch: of what goes */
	TCS_ARRAY(uint32_t) around; /* scratch: parts that stay */
	double reach; /* metres: what counts as touching */
	double far; /* metres from what stays: beyond it the price is steep */
	double contact_cost; /* of one that breaks */
	bool all_seen; /* without looking */
};

/*
 * Begin with a mesh nothing of which is collapsed; its contacts, and what
 * counts as touching; `all_seen` lets hidden parts count as if they were seen. Fails with TCS_NO_MEMORY.
 */
enum tcs_status removals_begin(struct removals *removals,
	struct collapses *work, const struct contact_list *contacts,
	double reach, bool all_seen, struct tcs_fault *fault) TCS_CHECKED;

/* What the next removal costs per collapse, at least; INFINITY when none is
   left. */
double removals_next_cost(const struct removals *removals);

/*
 * Look closer at the next removal: take the part away if it costs what it
 * seemed to, with what would hang in the air without it; else it is dearer from
 * then on. Fails with TCS_NO_MEMORY, TCS_LIMIT, TCS_SYSTEM.
 */
enum tcs_status removals_try(
	struct removals *removals, struct tcs_fault *fault) TCS_CHECKED;

/* Find out how much is seen of every part, and let contacts and shapes count by
   it from then on, unless that is done. Fails with TCS_NO_MEMORY, TCS_SYSTEM. */
enum tcs_status removals_look(
	struct removals *removals, struct tcs_fault *fault) TCS_CHECKED;

/* Take a part away, at any price, if nothing stands on it alone. Fails with
   TCS_NO_MEMORY. */
enum tcs_status removals_take(struct removals *removals, uint32_t part,
	struct tcs_fault *fault) TCS_CHECKED;

/* What it costs per square metre to be off by so much: its square, and far more
   beyond `far`. */
static inline double
removals_steep(const struct removals *removals, double off)
{
	double far = off / removals->far;

	return off * off * (1 + far * far * far);
}

/* The faces that a part still has. */
uint32_t removals_faces(const struct removals *removals, uint32_t part);

/*
 * Parts became one, the host, see parts.h: it is as visible as all of them were.
 * Fails with TCS_NO_MEMORY.
 */
enum tcs_status removals_join(struct removals *removals, const uint32_t *parts,
	size_t count, uint32_t host, struct tcs_fault *fault) TCS_CHECKED;

/* A part is not seen any more. Fails with TCS_NO_MEMORY. */
enum tcs_status removals_hide(struct removals *removals, uint32_t part,
	struct tcs_fault *fault) TCS_CHECKED;

/* How far a point is from the surface that a part came with, if not farther
   than `reach`; else INFINITY. What is not more than `enough` may be less. Fails
   with TCS_NO_MEMORY, TCS_LIMIT. */
enum tcs_status removals_distance(struct removals *removals, uint32_t part,
	struct tcs_point from, double reach, double enough, double *distance,
	struct tcs_fault *fault) TCS_CHECKED;

void removals_release(struct removals *removals);

#endif
