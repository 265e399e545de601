/*
 * Surfaces as functions of two parameters.
 *
 * u and v are: lengths on a plane; the angle and the height on a cylinder; the
 * longitude and the latitude on a sphere; the angles about the axis and about
 * the tube on a torus; the length of the swept curve and the height on an
 * extrusion; the angle and the length of the swept curve on a revolution; the
 * knots' parameters on a spline. Angles are radians. Swept curves are held as
 * polylines within the shaper's deflection.
 *
 * source: ISO 10303-42 4.4 (surfaces), ISO 16739-1 8.9.3.
 */
#ifndef TESSERA_IFC_SURFACE_H
#define TESSERA_IFC_SURFACE_H

#include "ifc_spline.h"

enum ifc_surface_kind {
	IFC_SURFACE_PLANE,
	IFC_SURFACE_CYLINDER,
	IFC_SURFACE_SPHERE,
	IFC_SURFACE_TORUS,
	IFC_SURFACE_EXTRUSION,
	IFC_SURFACE_REVOLUTION,
	IFC_SURFACE_SPLINE,
};

struct ifc_uv {
	double at[2]; /* u, v */
};

/* All zero is empty. */
struct ifc_surface {
	enum ifc_surface_kind kind;
	struct ifc_matrix at; /* of a revolution: z is its axis */
	double radius, minor;
	struct ifc_points curve; /* swept, in the surface's coordinates */
	struct ifc_knots lengths; /* of the curve up to each of its points */
	struct tcs_point along; /* of an extrusion, unit */
	unsigned degree[2];
	size_t count[2]; /* poles in u and v */
	struct ifc_poles poles; /* those of one u together */
	struct ifc_knots knots[2];
	double low[2], high[2]; /* the range; infinite where it has no ends */
	double period[2]; /* 0 where it does not repeat */
	double tolerance; /* a point this near is on it */
	double step[2]; /* about what a chord may span; 0: any */
	bool pinched[2][2]; /* in which direction, at its low and high end: all
	                       of the other parameter's values are one point */
};

/*
 * Read a surface. A swept one that is not `placed` stays where its curve is,
 * whatever its Position says: some programs give both in the same coordinates.
 * In any case *out is to be released.
 */
enum ifc_outcome ifc_surface_read(struct ifc_shaper *shaper, uint32_t surface,
	bool placed, struct ifc_surface *out) TCS_CHECKED;

void ifc_surface_release(struct ifc_surface *surface);

/* Parameters beyond the range of a surface with ends are its ends. */
struct tcs_point ifc_surface_at(
	const struct ifc_surface *surface, struct ifc_uv uv);

/* The unit normal, along the derivative by u times that by v; 0 in a pinch. */
struct tcs_point ifc_surface_normal(
	const struct ifc_surface *surface, struct ifc_uv uv);

/* ---- ifc_surface_locate.c ------------------------------------------------ */

/*
 * The parameters of a point on the surface, or of one near it. Of those that a
 * period allows, they are the nearest to `near`, which may be NULL. False where
 * the point is in a pinch, which leaves the one parameter open: it is that of
 * `near`.
 */
bool ifc_surface_locate(const struct ifc_surface *surface,
	struct tcs_point point, const struct ifc_uv *near, struct ifc_uv *out);

#endif
