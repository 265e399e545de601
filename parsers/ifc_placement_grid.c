#include "ifc_placement_grid.h"

#include <math.h>

#include "ifc_curve.h"
#include "ifc_offset.h"

enum { INTERSECTING_AXES, OFFSETS };

enum { AXIS_CURVE = 1, AXIS_SENSE = 2 };

enum { PRODUCT_PLACEMENT = 5 };

static const struct tcs_point up = {0, 0, 1};

/* Where two axes meet, and how the first one runs there. */
struct crossing {
	struct tcs_point at, along;
	double beyond; /* how far beyond the ends of the axes that is */
};

/* ---- axes ---------------------------------------------------------------- */

static int
position_of(const struct ifc_file *file, const char *attribute)
{
	return ifc_attribute(file->version, IFC_GRIDPLACEMENT, attribute);
}

/* The points of an axis in its sense, moved to the left. */
static enum ifc_outcome
axis_points(struct ifc_shaper *shaper, uint32_t axis, double offset,
	struct ifc_points *out)
{
	struct step_value sense = ifc_value(shaper->file, axis, AXIS_SENSE);
	struct ifc_points points = {.count = 0};
	enum ifc_outcome outcome;

	outcome = ifc_curve_points(
		shaper, ifc_target(shaper->file, axis, AXIS_CURVE), &points);
	if (!outcome && step_is(&sense, "F"))
		for (size_t low = 0, high = points.count; low + 1 < high;
			low++) {
			struct tcs_point swap = points.at[low];

			points.at[low] = points.at[--high];
			points.at[high] = swap;
		}
	if (!outcome)
		outcome = ifc_offset_points(shaper, points.at, points.count,
			false, offset, up, out);
	array_release(&points);
	return outcome;
}

/* How far a part of an edge is beyond it; nothing where the axis goes on. */
static double
beyond(double part, double length)
{
	return part < 0 ? -part * length : part > 1 ? (part - 1) * length : 0;
}

/* The edges from a[0] and b[0], as long as they must be. */
static void
edges_cross(const struct tcs_point *a, const struct tcs_point *b,
	struct crossing *best)
{
	double ax = a[1].x - a[0].x, ay = a[1].y - a[0].y;
	double bx = b[1].x - b[0].x, by = b[1].y - b[0].y;
	double cross = ax * by - ay * bx;
	double x = b[0].x - a[0].x, y = b[0].y - a[0].y;
	double part = (x * by - y * bx) / cross;
	double far = beyond(part, hypot(ax, ay)) +
		beyond((x * ay - y * ax) / cross, hypot(bx, by));

	if (!(fabs(cross) > 1e-9 * hypot(ax, ay) * hypot(bx, by)) ||
		!(far < best->beyond))
		return;
	*best = (struct crossing){
		{a[0].x + part * ax, a[0].y + part * ay, a[0].z}, {ax, ay, 0},
		far};
}

/* Up to three numbers; those that are not there are 0. */
static void
offsets_read(const struct ifc_file *file, uint32_t place, double out[3])
{
	struct step_value list = ifc_value(file, place, OFFSETS);

	out[0] = out[1] = out[2] = 0;
	if (list.kind == STEP_LIST)
		(void)step_numbers(&list.list, out, 3);
}

static enum ifc_outcome
crossing_read(struct ifc_shaper *shaper, uint32_t place, struct crossing *out)
{
	const struct ifc_file *file = shaper->file;
	struct step_value list = ifc_value(file, place, INTERSECTING_AXES);
	struct ifc_points axes[2] = {{.count = 0}, {.count = 0}};
	enum ifc_outcome outcome = IFC_SHAPED;
	struct step_value axis;
	double offsets[3];

	*out = (struct crossing){.beyond = HUGE_VAL};
	offsets_read(file, place, offsets);
	for (int i = 0; i < 2 && !outcome; i++) {
		if (list.kind != STEP_LIST ||
			step_next(&list.list, &axis) <= STEP_END)
			outcome =
				ifc_refuse(shaper, place, "an axis is missing");
		else
			outcome = axis_points(shaper,
				step_target(file->step, &axis), offsets[i],
				axes + i);
	}
	for (size_t i = 0; i + 1 < axes[0].count && !outcome; i++)
		for (size_t k = 0; k + 1 < axes[1].count; k++)
			edges_cross(axes[0].at + i, axes[1].at + k, out);
	out->at.z += offsets[2];
	array_release(axes);
	array_release(axes + 1);
	if (!outcome && out->beyond == HUGE_VAL)
		return ifc_refuse(shaper, place, "axes do not meet");
	return outcome;
}

/* ---- placements ---------------------------------------------------------- */

const char *
ifc_grid_matrix(
	struct ifc_shaper *shaper, uint32_t placement, struct ifc_matrix *out)
{
	const struct ifc_file *file = shaper->file;
	uint32_t place = ifc_target(
		file, placement, position_of(file, "PlacementLocation"));
	uint32_t towards = ifc_target(
		file, placement, position_of(file, "PlacementRefDirection"));
	struct crossing here, there;
	struct tcs_point x;
	double length;

	shaper->depth = 0;
	if (ifc_entity_of(file, place) != IFC_VIRTUALGRIDINTERSECTION)
		return "on a grid, without an intersection of axes";
	if (crossing_read(shaper, place, &here))
		return "on a grid whose axes do not meet";
	x = here.along;
	if (ifc_entity_of(file, towards) == IFC_VIRTUALGRIDINTERSECTION) {
		if (crossing_read(shaper, towards, &there))
			return "on a grid whose axes do not meet";
		x = (struct tcs_point){
			there.at.x - here.at.x, there.at.y - here.at.y, 0};
	} else {
		(void)ifc_triple(file, towards, &x);
	}
	length = hypot(x.x, x.y);
	if (!(length > 0))
		return "on a grid, without a direction";
	x.x /= length;
	x.y /= length;
	*out = (struct ifc_matrix){{x.x, -x.y, 0, here.at.x, x.y, x.x, 0,
		here.at.y, 0, 0, 1, here.at.z, 0, 0, 0, 1}};
	return NULL;
}

static bool
list_has(const struct ifc_file *file, struct step_value list, uint32_t wanted)
{
	struct step_value value;

	while (list.kind == STEP_LIST &&
		step_next(&list.list, &value) > STEP_END)
		if (step_target(file->step, &value) == wanted)
			return true;
	return false;
}

uint32_t
ifc_grid_placement_of(const struct ifc_file *file, uint32_t placement)
{
	uint32_t place = ifc_target(
		file, placement, position_of(file, "PlacementLocation"));
	struct step_value list = ifc_value(file, place, INTERSECTING_AXES);
	struct step_list grids = step_instances(
		file->step, step_names_find(&file->step->names, "IFCGRID"));
	int axes_at = ifc_attribute(file->version, IFC_GRID, "UAxes");
	struct step_value value;
	uint32_t axis;

	if (list.kind != STEP_LIST || step_next(&list.list, &value) <= STEP_END)
		return STEP_NONE;
	axis = step_target(file->step, &value);
	for (size_t i = 0; i < grids.count; i++)
		for (int k = 0; k < 3; k++)
			if (list_has(file,
				    ifc_value(file, grids.at[i], axes_at + k),
				    axis))
				return ifc_target(
					file, grids.at[i], PRODUCT_PLACEMENT);
	return STEP_NONE;
}
