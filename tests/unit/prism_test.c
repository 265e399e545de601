#include "simplify/prism.h"

#include "check.h"
#include "simplify/vector.h"

#define PI 3.14159265358979323846

static const struct tcs_point up = {0, 0, 1};

enum { MOST_POINTS = 64 };

/* All zero is empty. */
struct cloud {
	struct tcs_point at[MOST_POINTS];
	size_t count;
};

static void
add(struct cloud *cloud, double x, double y, double z)
{
	cloud->at[cloud->count++] = (struct tcs_point){x, y, z};
}

static void
add_box(struct cloud *cloud, struct tcs_point low, struct tcs_point high)
{
	for (int i = 0; i < 8; i++)
		add(cloud, i & 1 ? high.x : low.x, i & 2 ? high.y : low.y,
			i & 4 ? high.z : low.z);
}

static bool
around(struct prism *prism, const struct cloud *cloud, struct tcs_point axis,
	unsigned sides)
{
	struct prism_outline outline = {0};
	struct tcs_fault fault;
	bool fine = false;

	CHECK(!prism_around(prism, &outline, cloud->at, cloud->count, axis,
		sides, &fine, &fault));
	prism_outline_release(&outline);
	return fine;
}

/* What its triangles enclose. */
static double
volume(const struct prism *prism)
{
	double sum = 0;

	for (unsigned i = 0; i < PRISM_TRIANGLES_OF(prism->sides); i++) {
		struct triangle_shape shape = prism_shape(prism, i);

		sum += vector_dot(shape.corner[0],
			vector_cross(shape.corner[1], shape.corner[2]));
	}
	return sum / 6;
}

/* Every edge of its triangles once each way. */
static bool
is_closed(const struct prism *prism)
{
	int uses[PRISM_CORNERS][PRISM_CORNERS] = {{0}};
	bool closed = true;

	for (unsigned i = 0; i < PRISM_TRIANGLES_OF(prism->sides); i++) {
		unsigned corners[3];

		prism_triangle(prism, i, corners);
		for (int k = 0; k < 3; k++)
			uses[corners[k]][corners[(k + 1) % 3]]++;
	}
	for (int i = 0; i < PRISM_CORNERS; i++)
		for (int k = 0; k < PRISM_CORNERS; k++)
			closed &= uses[i][k] <= 1 && uses[i][k] == uses[k][i];
	return closed;
}

static bool
holds_all(const struct prism *prism, const struct cloud *cloud)
{
	bool all = true;

	for (size_t i = 0; i < cloud->count; i++)
		all &= prism_height(prism, cloud->at[i]) < 1e-9;
	return all;
}

static void
around_two_boxes_it_is_their_box(void)
{
	struct cloud cloud = {0};
	struct prism prism;

	add_box(&cloud, (struct tcs_point){0, 0, 0},
		(struct tcs_point){1, 2, 3});
	add_box(&cloud, (struct tcs_point){1, 0, 0},
		(struct tcs_point){4, 2, 3});
	CHECK(around(&prism, &cloud, up, PRISM_SIDES));
	CHECK(prism.sides == 4 && is_closed(&prism));
	CHECK(fabs(prism.volume - 24) < 1e-9);
	CHECK(fabs(volume(&prism) - 24) < 1e-9);
	CHECK(holds_all(&prism, &cloud));
	CHECK(fabs(prism_height(&prism, (struct tcs_point){2, 1, 1}) + 1) <
		1e-9);
	CHECK(fabs(prism_height(&prism, (struct tcs_point){2, 1, 3.5}) - 0.5) <
		1e-9);
}

static void
along_a_slanting_axis_it_is_as_large(void)
{
	struct cloud cloud = {0};
	struct prism prism;

	for (int i = 0; i < 8; i++) {
		double x = i & 1 ? 4 : 0, y = i & 2 ? 3 : 0;

		/* Turned by a right triangle of 3, 4, 5. */
		add(&cloud, 0.8 * x - 0.6 * y, 0.6 * x + 0.8 * y,
			i & 4 ? 2 : 0);
	}
	CHECK(around(
		&prism, &cloud, (struct tcs_point){0.8, 0.6, 0}, PRISM_SIDES));
	CHECK(fabs(prism.volume - 24) < 1e-9 && is_closed(&prism));
	CHECK(fabs(volume(&prism) - 24) < 1e-9);
}

/* A tenth of a circle less would be a side more. */
static void
a_cylinder_has_few_sides(void)
{
	struct cloud cloud = {0};
	struct prism prism;

	for (int i = 0; i < MOST_POINTS; i++)
		add(&cloud, cos(2 * PI * (i / 2) / (MOST_POINTS / 2)),
			sin(2 * PI * (i / 2) / (MOST_POINTS / 2)), i % 2);
	CHECK(around(&prism, &cloud, up, PRISM_SIDES));
	CHECK(prism.sides <= PRISM_SIDES && is_closed(&prism));
	CHECK(holds_all(&prism, &cloud));
	CHECK(prism.volume < 4.01);
	CHECK(around(&prism, &cloud, up, 4));
	CHECK(prism.sides == 4 && holds_all(&prism, &cloud));
	CHECK(prism.volume < 4.01);
}

static void
around_steps_it_is_a_ramp(void)
{
	struct cloud cloud = {0};
	struct prism prism;

	for (int i = 0; i < 8; i++)
		add_box(&cloud, (struct tcs_point){0.3 * i, 0, 0},
			(struct tcs_point){0.3 * (i + 1), 1, 0.2 * (i + 1)});
	CHECK(around(&prism, &cloud, (struct tcs_point){0, 1, 0}, PRISM_SIDES));
	CHECK(prism.sides <= 5 && is_closed(&prism));
	CHECK(holds_all(&prism, &cloud));
	/* The steps have 2.16, a box would have 3.84. */
	CHECK(prism.volume < 2.5);
}

static void
what_is_flat_has_none(void)
{
	struct cloud cloud = {0};
	struct prism prism;

	for (int i = 0; i < 9; i++)
		add(&cloud, i % 3, i / 3, 0);
	CHECK(!around(&prism, &cloud, up, PRISM_SIDES));
	CHECK(!around(
		&prism, &cloud, (struct tcs_point){1, 0, 0}, PRISM_SIDES));
	cloud.count = 0;
	for (int i = 0; i < 9; i++)
		add(&cloud, i, i, i);
	CHECK(!around(&prism, &cloud, up, PRISM_SIDES));
}

static const struct check_test tests[] = {
	CHECK_TEST(around_two_boxes_it_is_their_box),
	CHECK_TEST(along_a_slanting_axis_it_is_as_large),
	CHECK_TEST(a_cylinder_has_few_sides),
	CHECK_TEST(around_steps_it_is_a_ramp),
	CHECK_TEST(what_is_flat_has_none),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
