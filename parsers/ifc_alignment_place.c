#include <math.h>

#include "ifc_alignment.h"

enum { LOCATION, AXIS, REF_DIRECTION };

enum { DISTANCE, LATERAL, VERTICAL, LONGITUDINAL, BASIS_CURVE };

bool
ifc_distance_read(const struct step_value *value, double *out)
{
	return step_number(value, out) && isfinite(*out);
}

/* An offset of a point; 0 where there is none. */
static double
offset(const struct ifc_file *file, uint32_t point, int position)
{
	struct step_value value = ifc_value(file, point, position);
	double out;

	return step_number(&value, &out) ? out : 0;
}

static enum ifc_outcome
alignment_keep(struct ifc_shaper *shaper, uint32_t curve,
	struct ifc_alignment_kept *kept)
{
	enum ifc_outcome outcome;

	if (kept->marks.count && kept->curve == curve)
		return IFC_SHAPED;
	kept->curve = curve;
	outcome = ifc_alignment_read(shaper, curve, &kept->marks);
	if (outcome)
		array_clear(&kept->marks);
	return outcome;
}

enum ifc_outcome
ifc_distance_axes(struct ifc_shaper *shaper, uint32_t point, uint32_t curve,
	bool upright, struct ifc_alignment_kept *kept, struct ifc_matrix *out)
{
	const struct ifc_file *file = shaper->file;
	struct step_value along = ifc_value(file, point, DISTANCE);
	enum ifc_outcome outcome;
	struct ifc_mark mark;
	struct tcs_point at;
	double distance;

	if (!ifc_distance_read(&along, &distance))
		return ifc_refuse(shaper, point, "not a place along a curve");
	outcome = alignment_keep(shaper, curve, kept);
	if (outcome)
		return outcome;
	mark = ifc_alignment_at(&kept->marks, distance);
	if (upright)
		mark.slope = mark.roll = 0;
	*out = ifc_mark_axes(&mark);
	at = ifc_transform(out,
		(struct tcs_point){offset(file, point, LONGITUDINAL),
			offset(file, point, LATERAL),
			offset(file, point, VERTICAL)});
	out->at[3] = at.x;
	out->at[7] = at.y;
	out->at[11] = at.z;
	return IFC_SHAPED;
}

static enum ifc_outcome
point_axes(struct ifc_shaper *shaper, uint32_t point,
	struct ifc_alignment_kept *kept, struct ifc_matrix *out)
{
	if (ifc_entity_of(shaper->file, point) != IFC_POINTBYDISTANCEEXPRESSION)
		return ifc_refuse(shaper, point, "not a place along a curve");
	return ifc_distance_axes(shaper, point,
		ifc_target(shaper->file, point, BASIS_CURVE), false, kept, out);
}

/* Turn the axes to a direction z and, as near as can be, a direction x. */
static bool
axes_turn(struct tcs_point z, struct tcs_point x, struct ifc_matrix *out)
{
	double length = sqrt(z.x * z.x + z.y * z.y + z.z * z.z), off;

	z = (struct tcs_point){z.x / length, z.y / length, z.z / length};
	off = x.x * z.x + x.y * z.y + x.z * z.z;
	x = (struct tcs_point){
		x.x - off * z.x, x.y - off * z.y, x.z - off * z.z};
	off = sqrt(x.x * x.x + x.y * x.y + x.z * x.z);
	if (!(length > 0) || !(off > 1e-9))
		return false;
	x = (struct tcs_point){x.x / off, x.y / off, x.z / off};
	out->at[0] = x.x;
	out->at[4] = x.y;
	out->at[8] = x.z;
	out->at[1] = z.y * x.z - z.z * x.y;
	out->at[5] = z.z * x.x - z.x * x.z;
	out->at[9] = z.x * x.y - z.y * x.x;
	out->at[2] = z.x;
	out->at[6] = z.y;
	out->at[10] = z.z;
	return true;
}

enum ifc_outcome
ifc_linear_axes(struct ifc_shaper *shaper, uint32_t placement,
	struct ifc_alignment_kept *kept, struct ifc_matrix *out)
{
	const struct ifc_file *file = shaper->file;
	enum ifc_outcome outcome;
	struct tcs_point x, z;
	bool turned;

	if (ifc_entity_of(file, placement) != IFC_AXIS2PLACEMENTLINEAR)
		return ifc_refuse(
			shaper, placement, "not a placement along a curve");
	outcome = point_axes(
		shaper, ifc_target(file, placement, LOCATION), kept, out);
	if (outcome)
		return outcome;
	x = (struct tcs_point){out->at[0], out->at[4], out->at[8]};
	z = (struct tcs_point){out->at[2], out->at[6], out->at[10]};
	turned = ifc_triple(file, ifc_target(file, placement, AXIS), &z);
	if (ifc_triple(file, ifc_target(file, placement, REF_DIRECTION), &x))
		turned = true;
	if (!turned)
		return IFC_SHAPED;
	return axes_turn(z, x, out) ? IFC_SHAPED
				    : ifc_refuse(shaper, placement,
					      "directions are along one line");
}
