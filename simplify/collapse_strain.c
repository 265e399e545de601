/*
 * Collapses that are done only if nothing cheaper is left.
 *
 * The source compares the normal of each face around a collapse, and the area
 * of all of them, before and after: past a threshold it adds a penalty of 200
 * and forbids the collapse. Both cannot be meant. Here the cost is multiplied
 * by 200 past the thresholds below, which it does not tell, and what
 * collapse_check.c says is forbidden.
 *
 * source: L, validation (Liu, Li, Zhao, Liu, Texture feature preserving
 * simplification).
 */
#include "collapses.h"

#define MOST_GROWTH 4.0 /* of the area of all, either way */

bool
collapse_is_strained(const struct strain *strain)
{
	return strain->turns || strain->after > MOST_GROWTH * strain->before ||
		strain->before > MOST_GROWTH * strain->after;
}
