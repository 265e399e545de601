/*
 * Paths of sweeps: a curve as stations, each a frame for a section.
 *
 * At a corner, and at every point of a curve that has become a polyline, the
 * section stands in the plane that halves the angle, widened across the bend,
 * so that between corners the swept body has the section's shape: a mitre.
 *
 * source: IfcSweptDiskSolid, IfcFixedReferenceSweptAreaSolid (ISO 16739-1
 * 8.8.3).
 */
#ifndef TESSERA_IFC_PATH_H
#define TESSERA_IFC_PATH_H

#include "ifc_shape.h"

struct ifc_station {
	struct tcs_point at;
	struct tcs_point along; /* unit; normal to the section's plane */
	struct tcs_point x; /* unit; the section's x axis */
	struct tcs_point bend; /* unit, where a section is widened; or 0 */
	double widen; /* by this factor */
	double place; /* how long the path is up to here */
};

TCS_ARRAY_TYPE(ifc_stations, struct ifc_station);

/* All zero is empty. */
struct ifc_path {
	struct ifc_stations stations;
	bool closed; /* the last station is followed by the first one */
};

/*
 * The path along points; points that are the same as the one before are passed
 * over, and it is closed when the last is the first. Without x axes yet. Fewer
 * than two stations are refused.
 */
enum ifc_outcome ifc_path_along(struct ifc_shaper *shaper,
	const struct ifc_points *points, struct ifc_path *out) TCS_CHECKED;

/*
 * The path of a swept solid, with chords fine enough for what lies `reach`
 * beside it: the part of its curve between two values, each a parameter, a
 * length, or not there. All of a curve are also what programs write for that:
 * parameters 0 and 1 on a polyline, however many edges it has, and on a trimmed
 * curve the parameters of its basis where it is cut.
 */
enum ifc_outcome ifc_path_read(struct ifc_shaper *shaper, uint32_t curve,
	const struct step_value *start, const struct step_value *end,
	double reach, struct ifc_path *out) TCS_CHECKED;

/*
 * Turn a section's x axis at one station to a direction, or as near to it as
 * its plane allows. False when the direction is along the path.
 */
bool ifc_station_turn(struct ifc_station *station, struct tcs_point direction);

/* Carry an x axis along all of the path, turning with it as little as can be. */
void ifc_path_carry(struct ifc_path *path);

/* Where a point of the section's plane comes to lie. */
struct tcs_point ifc_station_place(
	const struct ifc_station *station, double x, double y);

void ifc_path_release(struct ifc_path *path);

#endif
