#include "ifc_sweep_curve.h"

#include <math.h>

#include "ifc_profile.h"
#include "ifc_surface.h"

enum { SWEPT_AREA, POSITION, DIRECTRIX, START, END, REFERENCE };

enum ifc_outcome
ifc_faces_place(struct ifc_shaper *shaper, uint32_t item, int position,
	struct ifc_faces *faces, size_t first_face)
{
	struct step_value value = ifc_value(shaper->file, item, position);
	struct ifc_matrix matrix;

	if (value.kind != STEP_REFERENCE)
		return IFC_SHAPED;
	if (!ifc_axes(shaper->file, step_target(shaper->file->step, &value),
		    &matrix))
		return ifc_refuse(shaper, item, "a position is bad");
	ifc_faces_transform(faces, first_face, &matrix);
	return IFC_SHAPED;
}

/* ---- along a path -------------------------------------------------------- */

static enum ifc_outcome
face_along(struct ifc_shaper *shaper, const struct ifc_faces *section,
	const struct ifc_face *face, const struct ifc_path *path,
	struct ifc_faces *out)
{
	size_t size = ifc_face_points(section, face);
	const struct tcs_point *points = section->points.at + face->first_point;
	struct ifc_loft loft = {.rings = section->rings.at + face->first_ring,
		.ring_count = face->ring_count,
		.closed = path->closed};
	enum ifc_outcome outcome = IFC_SHAPED;

	for (size_t i = 0; i < path->stations.count && !outcome; i++) {
		outcome = ifc_points_room(shaper, &loft.points, size);
		for (size_t k = 0; k < size && !outcome; k++)
			loft.points.at[loft.points.count++] =
				ifc_station_place(path->stations.at + i,
					points[k].x, points[k].y);
	}
	if (!outcome)
		outcome = ifc_loft_faces(shaper, &loft, out);
	array_release(&loft.points);
	return outcome;
}

enum ifc_outcome
ifc_sweep_along(struct ifc_shaper *shaper, const struct ifc_faces *section,
	const struct ifc_path *path, struct ifc_faces *out)
{
	enum ifc_outcome outcome = IFC_SHAPED;

	for (size_t i = 0; i < section->faces.count && !outcome; i++)
		outcome = face_along(
			shaper, section, section->faces.at + i, path, out);
	return outcome;
}

/* ---- with a reference ---------------------------------------------------- */

static double
reach_of(const struct ifc_points *points)
{
	double reach = 0;

	for (size_t i = 0; i < points->count; i++)
		reach = fmax(reach, hypot(points->at[i].x, points->at[i].y));
	return reach;
}

static enum ifc_outcome
turn_to_direction(struct ifc_shaper *shaper, uint32_t item,
	struct tcs_point direction, struct ifc_path *path)
{
	for (size_t i = 0; i < path->stations.count; i++)
		if (!ifc_station_turn(path->stations.at + i, direction))
			return ifc_refuse(shaper, item,
				"a path runs along its reference direction");
	return IFC_SHAPED;
}

/* To the normal of the surface where each station is nearest to it. */
static enum ifc_outcome
turn_to_normals(struct ifc_shaper *shaper, uint32_t item,
	const struct ifc_surface *surface, struct ifc_path *path)
{
	struct ifc_uv near, uv;

	for (size_t i = 0; i < path->stations.count; i++) {
		struct ifc_station *station = path->stations.at + i;

		(void)ifc_surface_locate(
			surface, station->at, i ? &near : NULL, &uv);
		if (!ifc_station_turn(station, ifc_surface_normal(surface, uv)))
			return ifc_refuse(shaper, item,
				"a path leaves its surface upright");
		near = uv;
	}
	return IFC_SHAPED;
}

static enum ifc_outcome
turn_to_surface(struct ifc_shaper *shaper, uint32_t item, uint32_t surface,
	struct ifc_path *path)
{
	struct ifc_surface read;
	enum ifc_outcome outcome =
		ifc_surface_read(shaper, surface, true, &read);

	if (!outcome)
		outcome = turn_to_normals(shaper, item, &read, path);
	ifc_surface_release(&read);
	return outcome;
}

static enum ifc_outcome
path_turn(struct ifc_shaper *shaper, uint32_t item, struct ifc_path *path)
{
	const struct ifc_file *file = shaper->file;
	uint32_t reference = ifc_target(file, item, REFERENCE);
	struct tcs_point direction;

	if (ifc_is_kind(file, item, IFC_SURFACECURVESWEPTAREASOLID))
		return turn_to_surface(shaper, item, reference, path);
	if (ifc_triple(file, reference, &direction))
		return turn_to_direction(shaper, item, direction, path);
	if (ifc_value(file, item, REFERENCE).kind == STEP_REFERENCE)
		return ifc_refuse(shaper, item, "a reference is bad");
	ifc_path_carry(path);
	return IFC_SHAPED;
}

enum ifc_outcome
ifc_swept_area(struct ifc_shaper *shaper, uint32_t item, struct ifc_faces *out)
{
	const struct ifc_file *file = shaper->file;
	struct step_value start = ifc_value(file, item, START);
	struct step_value end = ifc_value(file, item, END);
	struct ifc_faces section = {.points = {.count = 0}};
	struct ifc_path path = {.closed = false};
	size_t first = out->faces.count;
	enum ifc_outcome outcome;

	outcome = ifc_profile_faces(
		shaper, ifc_target(file, item, SWEPT_AREA), &section);
	if (!outcome)
		outcome =
			ifc_path_read(shaper, ifc_target(file, item, DIRECTRIX),
				&start, &end, reach_of(&section.points), &path);
	if (!outcome)
		outcome = path_turn(shaper, item, &path);
	if (!outcome)
		outcome = ifc_sweep_along(shaper, &section, &path, out);
	if (!outcome)
		outcome = ifc_faces_place(shaper, item, POSITION, out, first);
	ifc_faces_release(&section);
	ifc_path_release(&path);
	return outcome;
}
