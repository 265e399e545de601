/*
 * Numbers on their way into the buffer of a city: each call appends to a part
 * and says in *out where it went. All fail with TCS_SYSTEM or TCS_NO_MEMORY.
 */
#ifndef TESSERA_GLTF_NUMBERS_H
#define TESSERA_GLTF_NUMBERS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "fault.h"
#include "gltf_assembly.h"
#include "gltf_city.h"

/* `count` floats, `width` of them an element. None: out->count is 0. */
enum tcs_status city_add_floats(struct city *city, enum city_part part,
	const float *values, size_t count, unsigned width,
	struct assembly_accessor *out, struct tcs_fault *fault) TCS_CHECKED;

/*
 * Feature ids base + features[i], four bytes apart: UNSIGNED_SHORT while the
 * largest fits, FLOAT beyond. `features` NULL: all are `base`.
 */
enum tcs_status city_add_ids(struct city *city, const uint32_t *features,
	size_t count, uint32_t base, uint32_t largest,
	struct assembly_accessor *out, struct tcs_fault *fault) TCS_CHECKED;

/* Vertex indices, 16 bits wide if `narrow`. */
enum tcs_status city_add_indices(struct city *city, const uint32_t *indices,
	size_t count, bool narrow, struct assembly_accessor *out,
	struct tcs_fault *fault) TCS_CHECKED;

#endif
