#include "simplify/raster.h"

#include <math.h>

#include "check.h"
#include "simplify/component_set.h"
#include "simplify/vector.h"

static void
set_add(struct component_set *set, struct tcs_point a, struct tcs_point b,
	struct tcs_point c, uint32_t feature)
{
	const struct tcs_point corners[3] = {a, b, c};
	struct tcs_fault fault;

	CHECK(!component_set_add(set, corners, feature, TCS_NONE, &fault));
}

/* A square across the x axis, of half the side `half`, of two triangles. */
static void
set_square(struct component_set *set, double x, double half, uint32_t feature)
{
	const struct tcs_point at[4] = {{x, -half, -half}, {x, half, -half},
		{x, half, half}, {x, -half, half}};

	set_add(set, at[0], at[1], at[2], feature);
	set_add(set, at[0], at[2], at[3], feature);
}

/* Seen from x = 10, a sphere of radius 1 around 0 fits. */
static struct view
view_along_x(void)
{
	return view_of(
		(struct tcs_point){10, 0, 0}, (struct tcs_point){0, 0, 0}, 1);
}

static size_t
count_pixels(const struct raster *raster, const struct component_set *set,
	uint32_t feature)
{
	size_t count = 0;

	for (size_t i = 0; i < (size_t)raster->size * raster->size; i++)
		count += raster->triangles[i] != RASTER_NOTHING &&
			set->features.at[raster->triangles[i]] == feature;
	return count;
}

static void
draw(struct raster *raster, struct component_set *set)
{
	struct view view = view_along_x();
	struct tcs_fault fault;

	CHECK(!component_set_build(set, &fault));
	CHECK(!raster_draw(raster, 100, &view, set->points.at,
		set->points.count, set->triangles.at, set->triangles.count,
		NULL, &fault));
}

static void
a_square_has_the_pixels_of_its_perspective(void)
{
	struct component_set set = {0};
	struct raster raster = {0};

	/* Half the picture is sqrt(99) / 10 of a radius at distance 10. */
	set_square(&set, 0, 0.5, 7);
	draw(&raster, &set);
	CHECK(count_pixels(&raster, &set, 7) == 50 * 50);
	CHECK(raster.triangles[0] == RASTER_NOTHING);
	CHECK(fabs(raster.nearness[50 * 100 + 50] - 0.1) < 1e-6);
	raster_release(&raster);
	component_set_release(&set);
}

static void
what_is_nearer_hides_what_is_behind(void)
{
	struct component_set set = {0};
	struct raster raster = {0};

	set_square(&set, 1, 0.45, 1);
	set_square(&set, 0, 0.5, 2);
	draw(&raster, &set);
	CHECK(count_pixels(&raster, &set, 1) == 50 * 50);
	CHECK(count_pixels(&raster, &set, 2) == 0);
	raster_release(&raster);
	component_set_release(&set);
}

/* Both triangles of the square are counterclockwise as they are seen. */
static void
what_has_a_front_is_seen_only_from_there(void)
{
	for (int front = -1; front <= 1; front++) {
		const signed char fronts[2] = {(signed char)front, 0};
		struct component_set set = {0};
		struct raster raster = {0};
		struct view view = view_along_x();
		struct tcs_fault fault;

		set_square(&set, 0, 0.5, 1);
		CHECK(!component_set_build(&set, &fault));
		CHECK(!raster_draw(&raster, 100, &view, set.points.at,
			set.points.count, set.triangles.at, set.triangles.count,
			fronts, &fault));
		CHECK((raster.triangles[60 * 100 + 55] == 0) == (front >= 0));
		CHECK(raster.triangles[40 * 100 + 45] == 1);
		raster_release(&raster);
		component_set_release(&set);
	}
}

static void
what_is_behind_the_eye_or_partly_so_is_not_drawn(void)
{
	struct component_set set = {0};
	struct raster raster = {0};

	set_square(&set, 12, 5, 1);
	set_add(&set, (struct tcs_point){11, 0, 0}, (struct tcs_point){0, 1, 0},
		(struct tcs_point){0, 0, 1}, 2);
	draw(&raster, &set);
	CHECK(count_pixels(&raster, &set, 1) == 0);
	CHECK(count_pixels(&raster, &set, 2) == 0);
	raster_release(&raster);
	component_set_release(&set);
}

static void
a_triangle_wider_than_the_picture_fills_it(void)
{
	struct component_set set = {0};
	struct raster raster = {0};

	set_add(&set, (struct tcs_point){0, -1e7, -1e7},
		(struct tcs_point){0, 1e7, -1e7}, (struct tcs_point){0, 0, 1e7},
		3);
	draw(&raster, &set);
	CHECK(count_pixels(&raster, &set, 3) == 100 * 100);
	raster_release(&raster);
	component_set_release(&set);
}

static void
the_ray_of_a_pixel_meets_what_it_shows(void)
{
	struct component_set set = {0};
	struct raster raster = {0};
	struct view view = view_along_x();
	size_t seen = 0;

	set_square(&set, 0.3, 0.4, 1);
	set_square(&set, -0.3, 0.7, 2);
	draw(&raster, &set);
	for (unsigned i = 0; i < 100 * 100; i++) {
		struct tcs_point way = view_ray(&view, 100, i % 100, i / 100);
		double t, margin;

		if (raster.triangles[i] == RASTER_NOTHING)
			continue;
		struct triangle_shape shape =
			component_set_shape(&set, raster.triangles[i]);
		CHECK(triangle_hit(&shape, view.eye, way, &t, &margin) ||
			margin > -1e-9);
		CHECK(fabs(t * raster.nearness[i] - 1) < 1e-6);
		seen++;
	}
	CHECK(seen > 1000);
	raster_release(&raster);
	component_set_release(&set);
}

static void
parallel_rays_see_the_same_size_at_any_distance(void)
{
	static const struct tcs_point ways[] = {
		{-1, 0, 0}, {0, 0, -1}, {0, 0, 1}};

	for (size_t i = 0; i < sizeof ways / sizeof *ways; i++) {
		struct component_set set = {0};
		struct raster raster = {0};
		struct tcs_fault fault;
		struct view view =
			view_parallel(ways[i], (struct tcs_point){0, 0, 0}, 1);

		/* Squares across x: seen along z they are but lines. */
		set_square(&set, -0.7, 0.5, 1);
		set_square(&set, 0.7, 0.26, 2);
		CHECK(!component_set_build(&set, &fault));
		CHECK(!raster_draw(&raster, 100, &view, set.points.at,
			set.points.count, set.triangles.at, set.triangles.count,
			NULL, &fault));
		CHECK(count_pixels(&raster, &set, 2) == (i ? 0 : 26 * 26));
		CHECK(count_pixels(&raster, &set, 1) ==
			(i ? 0 : 50 * 50 - 26 * 26));
		raster_release(&raster);
		component_set_release(&set);
	}
}

static const struct check_test tests[] = {
	CHECK_TEST(a_square_has_the_pixels_of_its_perspective),
	CHECK_TEST(what_is_nearer_hides_what_is_behind),
	CHECK_TEST(what_has_a_front_is_seen_only_from_there),
	CHECK_TEST(what_is_behind_the_eye_or_partly_so_is_not_drawn),
	CHECK_TEST(a_triangle_wider_than_the_picture_fills_it),
	CHECK_TEST(the_ray_of_a_pixel_meets_what_it_shows),
	CHECK_TEST(parallel_rays_see_the_same_size_at_any_distance),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
