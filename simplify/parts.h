/*
 * The parts of an object that can vanish as a whole, and what carries them.
 *
 * A part is a manifold sheet of a component: the faces that are connected
 * through joined edges. Two parts are linked where they meet at a point of
 * their component, where they hold the two sides of a seam, or where the
 * component of one encloses that of the other. What is linked to the ground,
 * directly or through others, stands; a part may go only if all that stands
 * without it stood on something else as well.
 *
 * source: W, small connecting components (Wang et al. 2021, ISPRS IJGI 10,
 * 422).
 */
#ifndef TESSERA_PARTS_H
#define TESSERA_PARTS_H

#include "seams.h"

struct part {
	uint32_t first, count; /* of `faces` */
	uint32_t first_link, link_count; /* of `links` */
	uint32_t component;
	uint32_t parent; /* what carries it; itself if the ground does */
	uint32_t children; /* parts that it carries */
	struct box box;
	double area; /* square metres */
	double depth; /* metres, of a closed one: three volumes per area */
	uint32_t host; /* the part that it has become one with; or itself */
	bool gone; /* taken away, or in its host */
	bool rebuilt; /* its faces are others than those it came with */
	bool drawn_out; /* to where it was not: see panels.h */
};

/* Who carries a part from now on. */
struct part_carrier {
	uint32_t part, carrier;
};

/* All zero is empty; reused from object to object. */
struct parts {
	TCS_ARRAY(struct part) at;
	size_t count;
	TCS_ARRAY(uint32_t) faces; /* by part */
	TCS_ARRAY(uint32_t) numbers; /* per face: its part; hosts have all */
	TCS_ARRAY(uint32_t) links; /* parts, by part */
	TCS_ARRAY(uint32_t) left; /* per component: parts that are there */
	TCS_ARRAY(uint32_t) enclosed; /* per component: contacts of the kind */
	TCS_ARRAY(uint32_t) pairs; /* scratch: two parts per link */
	TCS_ARRAY(uint32_t) queue; /* scratch: parts */
	TCS_ARRAY(uint32_t) marks; /* scratch: per part */
	TCS_ARRAY(struct part_carrier) carriers; /* scratch */
	uint32_t mark;
	TCS_ARRAY(uint32_t) hanging; /* see parts_find_hanging */
};

/*
 * Find the parts of an object split into sheets, with the contacts and seams
 * of it as they are before anything is collapsed. What is not more than
 * `reach` above the lowest point of the object stands on the ground; of what
 * is linked to nothing that does, the largest part stands for the rest. Takes
 * n log n steps. Fails with TCS_NO_MEMORY.
 */
enum tcs_status parts_find(struct parts *parts, const struct component_set *set,
	const struct sheets *sheets, const struct seams *seams,
	const struct contact_list *contacts, double reach,
	struct tcs_fault *fault) TCS_CHECKED;

/*
 * Take a part away if all others stand without it, and tell whether it is
 * gone. Looks at no more than some thousand of those that it carries: one that
 * carries more stays. Fails with TCS_NO_MEMORY.
 */
enum tcs_status parts_take_away(struct parts *parts, uint32_t part, bool *gone,
	struct tcs_fault *fault) TCS_CHECKED;

/*
 * List in `hanging` what would not stand without a part: itself, and what it
 * carries and nothing else does, carriers first. None, where it carries more
 * than parts_take_away looks at. Fails with TCS_NO_MEMORY.
 */
enum tcs_status parts_find_hanging(struct parts *parts, uint32_t part,
	struct tcs_fault *fault) TCS_CHECKED;

/* Whether a part is among those that were listed last. */
static inline bool
parts_hangs(const struct parts *parts, uint32_t part)
{
	return parts->marks.at[part] == parts->mark;
}

/*
 * Make some of them one, which is number `host` from then on: it has the faces
 * and the links of all, carries what they carried, and stands on what the
 * lowest of them stood on. None of them is gone, and together they are linked.
 * Fails with TCS_NO_MEMORY.
 */
enum tcs_status parts_join(struct parts *parts, const uint32_t *numbers,
	size_t count, uint32_t host, struct tcs_fault *fault) TCS_CHECKED;

/* The part that a part is in by now. */
uint32_t parts_host(const struct parts *parts, uint32_t part);

void parts_release(struct parts *parts);

#endif
