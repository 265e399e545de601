/* A few triangles as the simplifier has them: with components, sheets,
   contacts, seams and collapses. */
#ifndef TESSERA_COLLAPSE_SAMPLE_H
#define TESSERA_COLLAPSE_SAMPLE_H

#include "check.h"
#include "simplify/collapses.h"

enum { SAMPLE_FEATURES = 8 };

/* All zero is empty. */
struct collapse_sample {
	struct component_set set;
	struct sheets sheets;
	struct contact_list contacts;
	struct seams seams;
	struct collapses work;
	bool leads[SAMPLE_FEATURES];
	const uint32_t *charts; /* per triangle; NULL: one */
};

static inline void
sample_add(struct collapse_sample *sample, uint32_t feature, struct tcs_point a,
	struct tcs_point b, struct tcs_point c)
{
	const struct tcs_point corners[3] = {a, b, c};
	struct tcs_fault fault;

	CHECK(!component_set_add(
		&sample->set, corners, feature, TCS_NONE, &fault));
}

/* a b c d counterclockwise */
static inline void
sample_add_quad(struct collapse_sample *sample, uint32_t feature,
	struct tcs_point a, struct tcs_point b, struct tcs_point c,
	struct tcs_point d)
{
	sample_add(sample, feature, a, b, c);
	sample_add(sample, feature, a, c, d);
}

/* A level sheet of columns × rows squares of a side of `step`, seen from
   above. */
static inline void
sample_add_sheet(struct collapse_sample *sample, uint32_t feature,
	struct tcs_point low, double step, int columns, int rows)
{
	for (int y = 0; y < rows; y++)
		for (int x = 0; x < columns; x++) {
			struct tcs_point a = {
				low.x + x * step, low.y + y * step, low.z};
			struct tcs_point b = {a.x + step, a.y, a.z};
			struct tcs_point c = {a.x + step, a.y + step, a.z};
			struct tcs_point d = {a.x, a.y + step, a.z};

			sample_add_quad(sample, feature, a, b, c, d);
		}
}

static inline void
sample_add_box(struct collapse_sample *sample, uint32_t feature,
	struct tcs_point low, struct tcs_point size)
{
	static const unsigned char sides[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6},
		{0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
	struct tcs_point at[8];

	for (unsigned i = 0; i < 8; i++)
		at[i] = (struct tcs_point){low.x + (i & 1 ? size.x : 0),
			low.y + (i & 2 ? size.y : 0),
			low.z + (i & 4 ? size.z : 0)};
	for (int i = 0; i < 6; i++)
		sample_add_quad(sample, feature, at[sides[i][0]],
			at[sides[i][1]], at[sides[i][2]], at[sides[i][3]]);
}

static inline void
sample_begin(struct collapse_sample *sample,
	const struct collapse_settings *settings)
{
	const struct collapse_regions regions = {sample->leads, sample->charts};
	struct tcs_fault fault;
	double reach;

	CHECK(!component_set_build(&sample->set, &fault));
	CHECK(!sheets_build(&sample->sheets, &sample->set, &fault));
	reach = contact_reach(&sample->set);
	CHECK(!seams_find(&sample->seams, &sample->set, &sample->sheets, reach,
		&sample->contacts, &fault));
	CHECK(!collapses_begin(&sample->work, &sample->set, &sample->sheets,
		&sample->seams, &regions, settings, &fault));
}

static inline void
sample_run(struct collapse_sample *sample, size_t faces)
{
	struct tcs_fault fault;

	CHECK(!collapses_run(&sample->work, faces, INFINITY, &fault));
}

/* The node at a place, the first one there; TCS_NONE. */
static inline uint32_t
sample_node(const struct collapse_sample *sample, double x, double y, double z)
{
	const struct collapses *work = &sample->work;

	for (uint32_t i = 0; i < work->positions.count; i++) {
		struct tcs_point away = vector_difference(
			work->positions.at[i], (struct tcs_point){x, y, z});

		if (vector_length(away) < 1e-9)
			return i;
	}
	return TCS_NONE;
}

/* Whether a face that is left has a corner there. */
static inline bool
sample_has(const struct collapse_sample *sample, double x, double y, double z)
{
	uint32_t node = sample_node(sample, x, y, z), nodes[3];
	size_t faces = sample->sheets.face_triangles.count;

	for (uint32_t i = 0; node != TCS_NONE && i < faces; i++)
		if (collapses_face(&sample->work, i, nodes))
			for (int k = 0; k < 3; k++)
				if (nodes[k] == node)
					return true;
	return false;
}

/* Under the faces of a feature that are left. */
static inline double
sample_volume(const struct collapse_sample *sample, uint32_t feature)
{
	const struct collapses *work = &sample->work;
	const struct tcs_point *at = work->positions.at;
	double sum = 0;
	uint32_t nodes[3];

	for (uint32_t i = 0; i < work->features.count; i++)
		if (work->features.at[i] == feature &&
			collapses_face(work, i, nodes))
			sum += vector_dot(at[nodes[0]],
				vector_cross(at[nodes[1]], at[nodes[2]]));
	return sum / 6;
}

static inline void
sample_release(struct collapse_sample *sample)
{
	collapses_release(&sample->work);
	seams_release(&sample->seams);
	array_release(&sample->contacts);
	sheets_release(&sample->sheets);
	component_set_release(&sample->set);
	*sample = (struct collapse_sample){0};
}

#endif
