#include <math.h>

#include "ifc_alignment.h"
#include "ifc_profile.h"
#include "ifc_sweep_curve.h"

enum { DIRECTRIX, CROSS_SECTIONS, POSITIONS, FIXED_AXIS_VERTICAL };

enum { LOCATION = 0, DISTANCE = 0 };

/* Sections and where they stand; all zero is empty. */
struct sections {
	TCS_ARRAY(struct ifc_faces) profiles;
	TCS_ARRAY(struct ifc_matrix) places;
	TCS_ARRAY(double) distances; /* along a directrix */
	struct ifc_alignment_kept alignment;
};

static void
sections_release(struct sections *sections)
{
	for (size_t i = 0; i < sections->profiles.count; i++)
		ifc_faces_release(sections->profiles.at + i);
	array_release(&sections->profiles);
	array_release(&sections->places);
	array_release(&sections->distances);
	array_release(&sections->alignment.marks);
}

/* Whether two profiles have the same rings. */
static bool
are_alike(const struct ifc_faces *a, const struct ifc_faces *b)
{
	bool alike = a->faces.count == b->faces.count &&
		a->rings.count == b->rings.count;

	for (size_t i = 0; alike && i < a->faces.count; i++)
		alike = a->faces.at[i].ring_count == b->faces.at[i].ring_count;
	for (size_t i = 0; alike && i < a->rings.count; i++)
		alike = a->rings.at[i] == b->rings.at[i];
	return alike;
}

static enum ifc_outcome
profile_add(struct ifc_shaper *shaper, uint32_t profile, struct sections *out)
{
	struct ifc_faces *faces;

	if (array_grow(&out->profiles, 1))
		return IFC_NO_MEMORY;
	faces = out->profiles.at + out->profiles.count++;
	*faces = (struct ifc_faces){.points = {.count = 0}};
	return ifc_profile_faces(shaper, profile, faces);
}

/* The first profile gets the points of all, then all get those of it. */
static enum ifc_outcome
profiles_match(struct ifc_shaper *shaper, uint32_t item, struct sections *all)
{
	struct ifc_faces *first = all->profiles.at;
	enum ifc_outcome outcome = IFC_SHAPED;

	for (int pass = 0; pass < 2; pass++)
		for (size_t i = 1; i < all->profiles.count && !outcome; i++)
			outcome =
				ifc_loft_match(shaper, item, first, first + i);
	for (size_t i = 1; i < all->profiles.count && !outcome; i++)
		if (!are_alike(first, first + i))
			return ifc_refuse(
				shaper, item, "sections of different topology");
	return outcome;
}

/* ---- at places of their own ---------------------------------------------- */

/* A place along the directrix: its axes, and how far along it is. */
static enum ifc_outcome
axes_add(struct ifc_shaper *shaper, uint32_t place,
	const struct step_value *along, const struct ifc_matrix *axes,
	struct sections *out)
{
	struct ifc_matrix *matrix;
	double distance = 0;

	if (!ifc_distance_read(along, &distance) ||
		(out->distances.count &&
			!(distance >
				out->distances.at[out->distances.count - 1])))
		return ifc_refuse(shaper, place, "sections are out of order");
	if (array_grow(&out->distances, 1) || array_grow(&out->places, 1))
		return IFC_NO_MEMORY;
	out->distances.at[out->distances.count++] = distance;
	matrix = out->places.at + out->places.count++;
	*matrix = ifc_identity;
	/* A section's x axis is to the left, its y axis up. */
	for (int i = 0; i < 3; i++) {
		matrix->at[4 * i] = axes->at[4 * i + 1];
		matrix->at[4 * i + 1] = axes->at[4 * i + 2];
		matrix->at[4 * i + 2] = axes->at[4 * i];
		matrix->at[4 * i + 3] = axes->at[4 * i + 3];
	}
	return IFC_SHAPED;
}

static enum ifc_outcome
linear_add(struct ifc_shaper *shaper, uint32_t place, struct sections *out)
{
	const struct ifc_file *file = shaper->file;
	struct step_value along =
		ifc_value(file, ifc_target(file, place, LOCATION), DISTANCE);
	struct ifc_matrix axes;
	enum ifc_outcome outcome =
		ifc_linear_axes(shaper, place, &out->alignment, &axes);

	return outcome ? outcome : axes_add(shaper, place, &along, &axes, out);
}

/* In IFC4X1 a distance is a place, and the solid says what is upright. */
static enum ifc_outcome
distance_add(struct ifc_shaper *shaper, uint32_t item, uint32_t place,
	struct sections *out)
{
	const struct ifc_file *file = shaper->file;
	struct step_value along = ifc_value(file, place, DISTANCE);
	struct step_value upright = ifc_value(file, item, FIXED_AXIS_VERTICAL);
	struct ifc_matrix axes;
	enum ifc_outcome outcome = ifc_distance_axes(shaper, place,
		ifc_target(file, item, DIRECTRIX), step_is(&upright, "T"),
		&out->alignment, &axes);

	return outcome ? outcome : axes_add(shaper, place, &along, &axes, out);
}

static enum ifc_outcome
place_add(struct ifc_shaper *shaper, uint32_t item, uint32_t place,
	struct sections *out)
{
	if (ifc_entity_of(shaper->file, place) == IFC_AXIS2PLACEMENTLINEAR)
		return linear_add(shaper, place, out);
	if (ifc_entity_of(shaper->file, place) == IFC_DISTANCEEXPRESSION)
		return distance_add(shaper, item, place, out);
	if (array_grow(&out->places, 1))
		return IFC_NO_MEMORY;
	if (!ifc_axes(shaper->file, place, out->places.at + out->places.count))
		return ifc_refuse(shaper, place, "a position is bad");
	out->places.count++;
	return IFC_SHAPED;
}

static enum ifc_outcome
sections_read(struct ifc_shaper *shaper, uint32_t item, struct sections *out)
{
	const struct ifc_file *file = shaper->file;
	struct step_value profiles = ifc_value(file, item, CROSS_SECTIONS);
	struct step_value places = ifc_value(file, item, POSITIONS);
	enum ifc_outcome outcome = IFC_SHAPED;
	struct step_value value;

	while (!outcome && profiles.kind == STEP_LIST &&
		step_next(&profiles.list, &value) > STEP_END)
		outcome = profile_add(
			shaper, step_target(file->step, &value), out);
	while (!outcome && places.kind == STEP_LIST &&
		step_next(&places.list, &value) > STEP_END)
		outcome = place_add(
			shaper, item, step_target(file->step, &value), out);
	if (!outcome &&
		(out->places.count != out->profiles.count ||
			out->places.count < 2 ||
			(out->distances.count &&
				out->distances.count != out->places.count)))
		return ifc_refuse(shaper, item,
			"sections and their positions are not as many");
	return outcome ? outcome : profiles_match(shaper, item, out);
}

/* ---- stations ------------------------------------------------------------ */

static struct ifc_matrix
matrix_between(
	const struct ifc_matrix *a, const struct ifc_matrix *b, double part)
{
	struct ifc_matrix out;

	for (int i = 0; i < 16; i++)
		out.at[i] = a->at[i] + part * (b->at[i] - a->at[i]);
	return out;
}

/* One face's points between two sections, moved by a matrix. */
static enum ifc_outcome
station_add(struct ifc_shaper *shaper, const struct sections *sections,
	size_t face, size_t from, double part, const struct ifc_matrix *matrix,
	struct ifc_points *out)
{
	const struct ifc_faces *a = sections->profiles.at + from;
	const struct ifc_faces *b = part > 0 ? a + 1 : a;
	size_t first = a->faces.at[face].first_point;
	size_t size = ifc_face_points(a, a->faces.at + face);
	enum ifc_outcome outcome = ifc_points_room(shaper, out, size);

	for (size_t i = 0; i < size && !outcome; i++) {
		struct tcs_point p = a->points.at[first + i];
		struct tcs_point q = b->points.at[first + i];

		out->at[out->count++] = ifc_transform(matrix,
			(struct tcs_point){p.x + part * (q.x - p.x),
				p.y + part * (q.y - p.y), 0});
	}
	return outcome;
}

/*
 * At a mark of the directrix between two sections: what they are off the
 * directrix, in between, on top of its own axes there.
 */
static struct ifc_matrix
mark_matrix(const struct ifc_alignment *marks, const struct sections *sections,
	size_t from, double part, const struct ifc_mark *mark)
{
	struct ifc_matrix here = ifc_mark_axes(mark), off[2], turned;

	for (int i = 0; i < 2; i++) {
		struct ifc_mark at = ifc_alignment_at(
			marks, sections->distances.at[from + (size_t)i]);
		struct ifc_matrix axes = ifc_mark_axes(&at);

		off[i] = ifc_multiply(
			&(struct ifc_matrix){{axes.at[0], axes.at[4],
				axes.at[8], 0, axes.at[1], axes.at[5],
				axes.at[9], 0, axes.at[2], axes.at[6],
				axes.at[10], 0, 0, 0, 0, 1}},
			&(struct ifc_matrix){
				{1, 0, 0, -axes.at[3], 0, 1, 0, -axes.at[7], 0,
					0, 1, -axes.at[11], 0, 0, 0, 1}});
		off[i] = ifc_multiply(off + i, sections->places.at + from + i);
	}
	turned = matrix_between(off, off + 1, part);
	return ifc_multiply(&here, &turned);
}

static enum ifc_outcome
face_along(struct ifc_shaper *shaper, const struct ifc_alignment *marks,
	const struct sections *sections, size_t face, struct ifc_points *out)
{
	enum ifc_outcome outcome = IFC_SHAPED;
	size_t mark = 0;

	for (size_t i = 0; i < sections->places.count && !outcome; i++) {
		double from, to;

		outcome = station_add(shaper, sections, face, i, 0,
			sections->places.at + i, out);
		if (i + 1 == sections->places.count || !marks->count)
			continue;
		from = sections->distances.at[i];
		to = sections->distances.at[i + 1];
		for (; mark < marks->count && marks->at[mark].along < to &&
			!outcome;
			mark++) {
			const struct ifc_mark *at = marks->at + mark;
			double part = (at->along - from) / (to - from);
			struct ifc_matrix matrix;

			if (!(at->along > from) ||
				(mark && at[-1].along == at->along))
				continue;
			matrix = mark_matrix(marks, sections, i, part, at);
			outcome = station_add(
				shaper, sections, face, i, part, &matrix, out);
		}
	}
	return outcome;
}

enum ifc_outcome
ifc_sectioned(struct ifc_shaper *shaper, uint32_t item, struct ifc_faces *out)
{
	struct sections sections = {.profiles = {.count = 0}};
	struct ifc_alignment marks = {.count = 0};
	enum ifc_outcome outcome = sections_read(shaper, item, &sections);

	if (!outcome && sections.distances.count)
		outcome = ifc_alignment_read(shaper,
			ifc_target(shaper->file, item, DIRECTRIX), &marks);
	for (size_t i = 0; !outcome && i < sections.profiles.at[0].faces.count;
		i++) {
		const struct ifc_faces *first = sections.profiles.at;
		const struct ifc_face *face = first->faces.at + i;
		struct ifc_loft loft = {
			.rings = first->rings.at + face->first_ring,
			.ring_count = face->ring_count};

		outcome =
			face_along(shaper, &marks, &sections, i, &loft.points);
		if (!outcome)
			outcome = ifc_loft_faces(shaper, &loft, out);
		array_release(&loft.points);
	}
	array_release(&marks);
	sections_release(&sections);
	return outcome;
}
