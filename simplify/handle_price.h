/*
 * What closing a handle costs: see handles.h. The rims of the one that is
 * looked at stand in handles->rims.
 */
#ifndef TESSERA_HANDLE_PRICE_H
#define TESSERA_HANDLE_PRICE_H

#include "handles.h"

/* A face this parallel to what closes a hole lies in one plane with it. */
#define SAME_PLANE 0.999

/* One triangle of those that close it. */
struct triangle_shape handle_cap_shape(
	const struct handles *handles, size_t cap);

/*
 * Whether what stands in a hole is of the surface that closes it, and touches
 * nothing else: a pane in its frame. Both are one plate then.
 */
bool handle_becomes_one(
	const struct handles *handles, uint32_t part, uint32_t host);

/* What a handle costs at least, if not by being flat: nothing is looked at
   before that is dear. */
double handle_least_price(
	const struct handles *handles, const struct handle *handle);

/*
 * The price per collapse that is saved; INFINITY if none is. `adds` if closing
 * it adds to the solid: then what will be hidden is listed, too. Fails with
 * TCS_NO_MEMORY.
 */
enum tcs_status handle_price(struct handles *handles, uint32_t number,
	bool adds, double *price, struct tcs_fault *fault) TCS_CHECKED;

#endif
