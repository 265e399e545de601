/*
 * Which shell of a solid a polygon belongs to.
 */
#ifndef TESSERA_SHELLS_H
#define TESSERA_SHELLS_H

#include "tcs.h"

/*
 * The shell of a polygon of a geometry, from that of an earlier one on, or from
 * TCS_NONE; TCS_NONE if the geometry is no solid. All of them together take n
 * steps.
 */
static inline uint32_t
shell_after(const struct tcs_object *object,
	const struct tcs_geometry *geometry, uint32_t shell, uint32_t polygon)
{
	uint32_t end = geometry->first_shell + geometry->shell_count;

	if (shell == TCS_NONE)
		shell = geometry->first_shell;
	while (shell < end &&
		polygon >= object->shells.at[shell].first_polygon +
				object->shells.at[shell].polygon_count)
		shell++;
	return shell < end ? shell : TCS_NONE;
}

#endif
