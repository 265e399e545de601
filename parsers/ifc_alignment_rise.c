#include <math.h>

#include "ifc_alignment.h"

enum { START = 3, LENGTH, HEIGHT, GRADIENT, RADIUS, IS_CONVEX };

enum { MOST_STEPS = 1 << 14 };

/* A segment over the distance; `bend` is positive where it is a valley. */
struct rise {
	double start, length, height, gradient;
	double bend; /* 1 / the radius at the bottom or top, or 0 */
	bool round; /* a circle, else a parabola */
};

static bool
rise_read(const struct ifc_file *file, uint32_t segment, struct rise *out)
{
	enum ifc_entity entity = ifc_entity_of(file, segment);
	struct step_value convex = ifc_value(file, segment, IS_CONVEX);
	double read[RADIUS + 1 - START] = {0};
	int count = entity == IFC_ALIGNMENT2DVERSEGLINE ? RADIUS - START
							: RADIUS + 1 - START;

	if (!ifc_is_kind(file, segment, IFC_ALIGNMENT2DVERTICALSEGMENT))
		return false;
	for (int i = 0; i < count; i++) {
		struct step_value value = ifc_value(file, segment, START + i);

		if (!step_number(&value, read + i) || !isfinite(read[i]))
			return false;
	}
	*out = (struct rise){read[0], read[1], read[2], read[3], 0,
		entity == IFC_ALIGNMENT2DVERSEGCIRCULARARC};
	if (entity == IFC_ALIGNMENT2DVERSEGLINE)
		return out->length > 0;
	out->bend = (step_is(&convex, "T") ? -1 : 1) / read[4];
	return out->length > 0 && read[4] > 0;
}

/* The height and slope so far into a segment; false beyond its circle. */
static bool
rise_at(const struct rise *rise, double into, struct ifc_mark *out)
{
	double slant = sqrt(1 + rise->gradient * rise->gradient);
	double sine, cosine2;

	out->along = rise->start + into;
	out->slope = rise->gradient + into * rise->bend;
	out->at.z = rise->height + into * (rise->gradient + out->slope) / 2;
	if (!rise->round)
		return true;
	/* The sine of the angle grows evenly with the distance. */
	sine = rise->gradient / slant + into * rise->bend;
	cosine2 = 1 - sine * sine;
	if (!(cosine2 > 1e-12))
		return false;
	out->slope = sine / sqrt(cosine2);
	out->at.z = rise->height + (1 / slant - sqrt(cosine2)) / rise->bend;
	return true;
}

/* So many steps that chords are near. */
static size_t
steps_of(const struct ifc_shaper *shaper, const struct rise *rise)
{
	double steps = ceil(rise->length *
		sqrt(fabs(rise->bend) / (8 * shaper->deflection)));

	return (size_t)fmin(fmax(steps, 1), MOST_STEPS);
}

static enum ifc_outcome
segment_marks(
	struct ifc_shaper *shaper, uint32_t segment, struct ifc_alignment *out)
{
	struct rise rise;
	size_t steps;

	if (!rise_read(shaper->file, segment, &rise))
		return ifc_refuse(shaper, segment, "a segment is bad");
	/* It begins where the one before it ends, but for the last digit. */
	if (out->count &&
		rise.start < out->at[out->count - 1].along + shaper->precision)
		rise.start = out->at[out->count - 1].along;
	steps = steps_of(shaper, &rise);
	if (shaper->points + steps >= IFC_MOST_POINTS)
		return ifc_refuse(shaper, segment, "too many points");
	shaper->points += steps + 1;
	if (array_grow(out, steps + 1))
		return IFC_NO_MEMORY;
	for (size_t i = 0; i <= steps; i++) {
		struct ifc_mark *mark = out->at + out->count++;

		*mark = (struct ifc_mark){.along = 0};
		if (!rise_at(&rise, rise.length * ((double)i / (double)steps),
			    mark))
			return ifc_refuse(shaper, segment,
				"a segment is longer than its circle");
	}
	return IFC_SHAPED;
}

enum ifc_outcome
ifc_rise_marks(
	struct ifc_shaper *shaper, uint32_t vertical, struct ifc_alignment *out)
{
	const struct ifc_file *file = shaper->file;
	struct step_value list = ifc_value(file, vertical, 0), item;
	enum ifc_outcome outcome = IFC_SHAPED;

	while (!outcome && list.kind == STEP_LIST &&
		step_next(&list.list, &item) > STEP_END)
		outcome = segment_marks(
			shaper, step_target(file->step, &item), out);
	return outcome;
}
