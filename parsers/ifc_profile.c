#include "ifc_profile.h"

#include "ifc_curve.h"

enum { PROFILE_POSITION = 2 };

enum { OUTER_CURVE = 2, INNER_CURVES = 3 };

enum { PARENT = 2, OPERATOR = 3 };

static double
ring_area2(const struct tcs_point *points, size_t count)
{
	double area = 0;

	for (size_t i = 2; i < count; i++)
		area += (points[i - 1].x - points[0].x) *
				(points[i].y - points[0].y) -
			(points[i].x - points[0].x) *
				(points[i - 1].y - points[0].y);
	return area;
}

/* Wind the rings of the faces as they should. */
static void
rings_wind(struct ifc_faces *faces, size_t first_face)
{
	for (size_t i = first_face; i < faces->faces.count; i++) {
		const struct ifc_face *face = faces->faces.at + i;
		struct tcs_point *points = faces->points.at + face->first_point;

		for (uint32_t k = 0; k < face->ring_count; k++) {
			size_t count = faces->rings.at[face->first_ring + k];

			if ((ring_area2(points, count) > 0) != (k == 0))
				ifc_ring_reverse(points, count);
			points += count;
		}
	}
}

static enum ifc_outcome
ring_read(struct ifc_shaper *shaper, uint32_t curve, struct ifc_faces *out,
	bool *kept)
{
	size_t first = out->points.count;
	enum ifc_outcome outcome = ifc_curve_ring(shaper, curve, &out->points);

	if (outcome)
		return outcome;
	for (size_t i = first; i < out->points.count; i++)
		out->points.at[i].z = 0;
	return ifc_ring_end(shaper, out, kept);
}

static enum ifc_outcome
arbitrary(struct ifc_shaper *shaper, uint32_t profile, struct ifc_faces *out)
{
	const struct ifc_file *file = shaper->file;
	struct step_value list, item;
	enum ifc_outcome outcome;
	bool kept;

	outcome = ring_read(
		shaper, ifc_target(file, profile, OUTER_CURVE), out, &kept);
	if (!outcome && !kept)
		return ifc_refuse(shaper, profile, "a profile has no area");
	if (outcome ||
		ifc_entity_of(file, profile) !=
			IFC_ARBITRARYPROFILEDEFWITHVOIDS)
		return outcome;
	list = ifc_value(file, profile, INNER_CURVES);
	while (!outcome && list.kind == STEP_LIST &&
		step_next(&list.list, &item) > STEP_END)
		outcome = ring_read(
			shaper, step_target(file->step, &item), out, NULL);
	return outcome;
}

static enum ifc_outcome
composite(struct ifc_shaper *shaper, uint32_t profile, struct ifc_faces *out)
{
	struct step_value list = ifc_value(shaper->file, profile, 2), item;
	enum ifc_outcome outcome = IFC_SHAPED;

	if (list.kind != STEP_LIST)
		return ifc_refuse(shaper, profile, "a profile has no parts");
	while (!outcome && step_next(&list.list, &item) > STEP_END)
		outcome = ifc_profile_faces(
			shaper, step_target(shaper->file->step, &item), out);
	return outcome;
}

static enum ifc_outcome
derived(struct ifc_shaper *shaper, uint32_t profile, struct ifc_faces *out)
{
	const struct ifc_file *file = shaper->file;
	uint32_t map = ifc_target(file, profile, OPERATOR);
	struct ifc_matrix matrix = ifc_identity;
	size_t first = out->faces.count;
	enum ifc_outcome outcome;

	if (ifc_entity_of(file, profile) == IFC_MIRROREDPROFILEDEF)
		matrix.at[0] = -1;
	else if (!ifc_operator(file, map, &matrix))
		return ifc_refuse(shaper, profile, "an operator is bad");
	outcome = ifc_profile_faces(
		shaper, ifc_target(file, profile, PARENT), out);
	if (!outcome)
		ifc_faces_transform(out, first, &matrix);
	return outcome;
}

static enum ifc_outcome
parametrised(struct ifc_shaper *shaper, uint32_t profile, struct ifc_faces *out)
{
	const struct ifc_file *file = shaper->file;
	struct step_value position = ifc_value(file, profile, PROFILE_POSITION);
	struct ifc_matrix matrix = ifc_identity;
	size_t first = out->faces.count;
	enum ifc_outcome outcome;

	if (position.kind == STEP_REFERENCE &&
		!ifc_axes(file, step_target(file->step, &position), &matrix))
		return ifc_refuse(shaper, profile, "a position is bad");
	outcome = ifc_profile_plain(shaper, profile, out);
	if (!outcome)
		outcome = ifc_face_end(shaper, out);
	if (!outcome)
		ifc_faces_transform(out, first, &matrix);
	return outcome;
}

/* A profile whose instance was entered. */
static enum ifc_outcome
faces_inside(struct ifc_shaper *shaper, uint32_t profile, struct ifc_faces *out)
{
	enum ifc_entity entity = ifc_entity_of(shaper->file, profile);
	enum ifc_outcome outcome;

	if (ifc_is_kind(shaper->file, profile, IFC_PARAMETERIZEDPROFILEDEF))
		return parametrised(shaper, profile, out);
	switch (entity) {
	case IFC_ARBITRARYCLOSEDPROFILEDEF:
	case IFC_ARBITRARYPROFILEDEFWITHVOIDS:
		outcome = arbitrary(shaper, profile, out);
		if (!outcome)
			outcome = ifc_face_end(shaper, out);
		return outcome ? outcome
			       : ifc_profile_untangle(shaper, profile, out);
	case IFC_CENTERLINEPROFILEDEF:
		return ifc_profile_strip(shaper, profile, out);
	case IFC_COMPOSITEPROFILEDEF:
		return composite(shaper, profile, out);
	case IFC_DERIVEDPROFILEDEF:
	case IFC_MIRROREDPROFILEDEF:
		return derived(shaper, profile, out);
	default:
		return ifc_refuse(
			shaper, profile, "a profile of this kind is not known");
	}
}

enum ifc_outcome
ifc_profile_faces(
	struct ifc_shaper *shaper, uint32_t profile, struct ifc_faces *out)
{
	size_t first = out->faces.count;
	enum ifc_outcome outcome = ifc_enter(shaper, profile);

	if (outcome)
		return outcome;
	outcome = faces_inside(shaper, profile, out);
	ifc_leave(shaper);
	if (!outcome)
		rings_wind(out, first);
	return outcome;
}
