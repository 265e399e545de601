/*
 * Welding: equal positions are one point. Equal is bit for bit, but -0 is 0.
 *
 * source: W, segmentation (Wang et al. 2021, ISPRS IJGI 10, 422).
 */
#ifndef TESSERA_WELD_H
#define TESSERA_WELD_H

#include <stddef.h>
#include <stdint.h>

#include "fault.h"
#include "tcs.h"

/*
 * Number the points: numbers[i] is that of points[i], equal for equal points,
 * counting from 0 in the order of first occurrence; *distinct is how many
 * there are. All finite, fewer than 2³¹ of them. Takes n steps on the average.
 * Fails with TCS_NO_MEMORY.
 */
enum tcs_status weld_points(const struct tcs_point *points, size_t count,
	uint32_t *numbers, size_t *distinct,
	struct tcs_fault *fault) TCS_CHECKED;

#endif
