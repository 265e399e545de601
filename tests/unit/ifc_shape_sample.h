/* What the tests of shapes share: shapers, and what faces measure. */
#ifndef TESSERA_IFC_SHAPE_SAMPLE_H
#define TESSERA_IFC_SHAPE_SAMPLE_H

#include <math.h>

#include "check.h"
#include "ifc_sample.h"
#include "parsers/ifc_shape.h"
#include "parsers/solid.h"

#define SAMPLE_PI 3.14159265358979323846

static inline struct ifc_shaper
sample_shaper(const struct sample *sample, double deflection)
{
	return (struct ifc_shaper){.file = &sample->file,
		.angle = 1,
		.deflection = deflection,
		.precision = 1e-9};
}

static inline bool
is_near(double a, double b, double by)
{
	if (fabs(a - b) <= by)
		return true;
	fprintf(stderr, "%.12g is not %.12g by %.3g\n", a, b, by);
	return false;
}

static inline double
sample_ring_area(const struct tcs_point *points, size_t count)
{
	double area = 0;

	for (size_t i = 0; i < count; i++)
		area += points[i].x * points[(i + 1) % count].y -
			points[(i + 1) % count].x * points[i].y;
	return area / 2;
}

/* The area of faces in the plane z = 0. */
static inline double
sample_area(const struct ifc_faces *faces)
{
	const struct tcs_point *points = faces->points.at;
	double area = 0;

	for (size_t i = 0; i < faces->rings.count; i++) {
		area += sample_ring_area(points, faces->rings.at[i]);
		points += faces->rings.at[i];
	}
	CHECK(ifc_faces_loose(faces) == 0);
	return area;
}

static inline struct solid_measure
sample_measure(const struct ifc_faces *faces)
{
	struct solid solid = {.points = {.count = 0}};
	struct solid_measure out = {.volume = 0};
	struct tcs_fault fault;

	CHECK(ifc_faces_loose(faces) == 0);
	for (size_t i = 0; i < faces->faces.count; i++) {
		const struct ifc_face *face = faces->faces.at + i;

		CHECK(!solid_add_face(&solid,
			faces->points.at + face->first_point,
			faces->rings.at + face->first_ring, face->ring_count, 0,
			&fault));
	}
	CHECK(!solid_measure(&solid, &out, &fault));
	solid_release(&solid);
	return out;
}

/* An evaluator of one instance. */
typedef enum ifc_outcome sample_evaluator(
	struct ifc_shaper *shaper, uint32_t instance, struct ifc_faces *out);

/*
 * The faces that #100 of the data becomes: false when it is refused, with a
 * reason. *out is to be released.
 */
static inline bool
sample_shape(const char *schema, const char *data, double deflection,
	sample_evaluator *evaluate, struct ifc_faces *out)
{
	struct sample sample;
	struct ifc_shaper shaper;
	enum ifc_outcome outcome;

	*out = (struct ifc_faces){.points = {.count = 0}};
	CHECK(!sample_open(&sample, schema, data));
	shaper = sample_shaper(&sample, deflection);
	outcome = evaluate(&shaper, instance(&sample, 100), out);
	CHECK(outcome != IFC_NO_MEMORY);
	CHECK((outcome == IFC_REFUSED) == (shaper.reason != NULL));
	CHECK(outcome || shaper.depth == 0);
	sample_close(&sample);
	return outcome == IFC_SHAPED;
}

#endif
