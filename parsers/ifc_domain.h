/*
 * A triangulated piece of a surface, and its refinement.
 *
 * Triangles are kept Delaunay in the plane of the parameters, each divided by
 * the surface's step, so that they are long where the surface is straight. A
 * triangle that is off the surface gets a point within it or within an edge it
 * shares; edges of the border are never divided.
 *
 * source: C. L. Lawson, Software for C1 surface interpolation, 1977 (edge
 * flips); L. P. Chew, Guaranteed-quality mesh generation for curved surfaces,
 * 1993.
 */
#ifndef TESSERA_IFC_DOMAIN_H
#define TESSERA_IFC_DOMAIN_H

#include "ifc_surface.h"
#include "triangulate.h"

struct ifc_domain_point {
	struct tcs_point at;
	double x, y; /* the parameters, divided by `scale` */
	double off; /* how far it is off the surface */
};

struct ifc_domain_triangle {
	uint32_t corners[3]; /* counterclockwise in x and y */
	uint32_t next[3]; /* across the edge from each corner to the one behind
	                     it; STEP_NONE: the border */
};

/* All zero is empty. */
struct ifc_domain {
	TCS_ARRAY(struct ifc_domain_point) points;
	TCS_ARRAY(struct ifc_domain_triangle) triangles;
	double scale[2];
};

/* Add a point of the border at its parameters. */
enum ifc_outcome ifc_domain_add(struct ifc_shaper *shaper,
	const struct ifc_surface *surface, struct ifc_domain *domain,
	struct tcs_point at, struct ifc_uv uv) TCS_CHECKED;

/*
 * Triangulate the points as rings, the outer one first. False in *turned says
 * that it runs counterclockwise; the triangles do in any case. Refused when
 * there is no area.
 */
enum ifc_outcome ifc_domain_triangulate(struct ifc_shaper *shaper,
	const struct ifc_surface *surface, struct ifc_domain *domain,
	const uint32_t *rings, size_t ring_count, bool *turned) TCS_CHECKED;

/*
 * Refine until no triangle is further off the surface than the shaper's
 * deflection, or than the border is, or there are very many.
 */
enum ifc_outcome ifc_domain_refine(struct ifc_shaper *shaper,
	const struct ifc_surface *surface,
	struct ifc_domain *domain) TCS_CHECKED;

void ifc_domain_release(struct ifc_domain *domain);

#endif
