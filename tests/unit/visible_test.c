#include "simplify/visible.h"

#include <math.h>
#include <string.h>

#include "check.h"

enum { MOST = 4096 };

struct mesh {
	struct tcs_point points[3 * MOST];
	struct tcs_triangle triangles[MOST];
	size_t count;
	double areas[MOST];
};

static struct mesh mesh;

static void
mesh_triangle(struct tcs_point a, struct tcs_point b, struct tcs_point c)
{
	uint32_t first = 3 * (uint32_t)mesh.count;

	mesh.points[first] = a;
	mesh.points[first + 1] = b;
	mesh.points[first + 2] = c;
	mesh.triangles[mesh.count++] =
		(struct tcs_triangle){{first, first + 1, first + 2}};
}

/* A parallelogram at `at`. */
static void
mesh_face(struct tcs_point at, struct tcs_point u, struct tcs_point v)
{
	struct tcs_point b = {at.x + u.x, at.y + u.y, at.z + u.z};
	struct tcs_point c = {b.x + v.x, b.y + v.y, b.z + v.z};
	struct tcs_point d = {at.x + v.x, at.y + v.y, at.z + v.z};

	mesh_triangle(at, b, c);
	mesh_triangle(at, c, d);
}

/* A box of 12 triangles, two for each face: low z, high z, y, y, x, x. */
static void
mesh_box(struct tcs_point low, struct tcs_point high)
{
	struct tcs_point x = {high.x - low.x, 0, 0};
	struct tcs_point y = {0, high.y - low.y, 0};
	struct tcs_point z = {0, 0, high.z - low.z};

	mesh_face(low, y, x);
	mesh_face((struct tcs_point){low.x, low.y, high.z}, x, y);
	mesh_face(low, x, z);
	mesh_face((struct tcs_point){low.x, high.y, low.z}, z, x);
	mesh_face(low, z, y);
	mesh_face((struct tcs_point){high.x, low.y, low.z}, y, z);
}

static void
look(const struct visible_views *views)
{
	struct tcs_fault fault;

	CHECK(!visible_find(mesh.points, 3 * (size_t)MOST, mesh.triangles,
		mesh.count, views, mesh.areas, &fault));
}

static void
look_all_round(void)
{
	struct visible_views views = VISIBLE_ALL_ROUND;

	views.size = 256;
	look(&views);
}

static size_t
count_seen(size_t first, size_t count)
{
	size_t seen = 0;

	for (size_t i = first; i < first + count; i++)
		seen += mesh.areas[i] > 0;
	return seen;
}

static struct tcs_point
point(double x, double y, double z)
{
	return (struct tcs_point){x, y, z};
}

static void
of_each_face_of_a_cube_a_quarter_of_its_area_is_seen(void)
{
	mesh.count = 0;
	mesh_box(point(0, 0, 0), point(2, 2, 2));
	look_all_round();
	for (size_t i = 0; i < 12; i += 2)
		CHECK(fabs(mesh.areas[i] + mesh.areas[i + 1] - 1) < 0.03);
}

static void
what_is_shut_in_is_not_seen(void)
{
	mesh.count = 0;
	mesh_box(point(0, 0, 0), point(10, 10, 10));
	mesh_box(point(4, 4, 4), point(5, 5, 5));
	look_all_round();
	CHECK(count_seen(0, 12) == 12);
	CHECK(count_seen(12, 12) == 0);
}

static void
what_stands_behind_an_opening_is_seen(void)
{
	mesh.count = 0;
	mesh_box(point(0, 0, 0), point(10, 10, 10));
	mesh_box(point(4, 4, 4), point(5, 5, 5));
	/* Take the face at the highest x away. */
	memmove(mesh.triangles + 10, mesh.triangles + 12,
		12 * sizeof *mesh.triangles);
	mesh.count -= 2;
	look_all_round();
	/* The face turned to the opening, and those beside it. */
	CHECK(count_seen(10, 12) >= 8);
	/* The back of the box, from inside: larger for the open side. */
	CHECK(count_seen(0, 10) == 10);
}

static void
faces_that_touch_hide_each_other(void)
{
	mesh.count = 0;
	mesh_box(point(0, 0, 0), point(1, 1, 1));
	mesh_box(point(1, 0, 0), point(2, 1, 1));
	look_all_round();
	CHECK(count_seen(10, 2) == 0); /* highest x of the first */
	CHECK(count_seen(20, 2) == 0); /* lowest x of the second */
	CHECK(count_seen(0, 24) == 20);
}

static void
what_is_thinner_than_a_pixel_is_seen_where_it_lies_open(void)
{
	mesh.count = 0;
	mesh_box(point(0, 0, 0), point(100, 100, 100));
	/* A wire a tenth of a millimetre thick on the roof, and one inside. */
	mesh_box(point(10, 50, 100), point(90, 50.0001, 100.0001));
	mesh_box(point(10, 50, 50), point(90, 50.0001, 50.0001));
	look_all_round();
	CHECK(count_seen(14, 10) == 10);
	CHECK(count_seen(24, 12) == 0);
}

static void
what_is_closed_is_seen_from_where_it_looks(void)
{
	struct visible_views views = VISIBLE_ALL_ROUND;
	signed char fronts[MOST];

	views.size = 256;
	views.fronts = fronts;
	mesh.count = 0;
	mesh_box(point(0, 0, 0), point(100, 100, 100));
	mesh_box(point(40, 40, 40), point(50, 50, 50));
	/* A wire that no pixel shows. */
	mesh_box(point(10, 50, 100), point(90, 50.0001, 100.0001));
	memset(fronts, 1, mesh.count);
	look(&views);
	CHECK(count_seen(0, 12) == 12);
	CHECK(count_seen(12, 12) == 0);
	CHECK(count_seen(26, 10) == 10);
	/* Turned inside out, the large one can be looked into. */
	memset(fronts, -1, 12);
	look(&views);
	CHECK(count_seen(12, 12) == 12);
}

static void
what_stands_out_is_seen_from_below_but_not_from_the_air(void)
{
	struct visible_views views = VISIBLE_FROM_STREETS;

	views.size = 256;
	mesh.count = 0;
	mesh_box(point(0, 0, 0), point(100, 100, 10));
	mesh_box(point(-5, -5, 10), point(105, 105, 11));
	look(&views);
	CHECK(count_seen(12, 2) == 2);
	views.lowest = 0;
	look(&views);
	CHECK(count_seen(12, 2) == 0);
	CHECK(count_seen(14, 2) == 2);
}

static void
the_number_of_threads_changes_nothing(void)
{
	struct visible_views views = VISIBLE_ALL_ROUND;
	double areas[MOST];

	mesh.count = 0;
	for (int i = 0; i < 100; i++)
		mesh_box(point(i % 10, i / 10, 0),
			point(i % 10 + 0.7, i / 10 + 0.9999, i % 7 + 0.01));
	views.size = 128;
	look(&views);
	memcpy(areas, mesh.areas, sizeof areas);
	for (views.jobs = 2; views.jobs < 70; views.jobs += 21) {
		look(&views);
		CHECK(!memcmp(areas, mesh.areas, mesh.count * sizeof *areas));
	}
}

static void
no_triangles_and_flat_ones_are_no_trouble(void)
{
	mesh.count = 0;
	look_all_round();
	mesh_triangle(point(1, 1, 1), point(1, 1, 1), point(1, 1, 1));
	look_all_round();
	CHECK(count_seen(0, 1) == 0);
	mesh_triangle(point(0, 0, 0), point(2, 0, 0), point(1, 0, 0));
	look_all_round();
	CHECK(count_seen(0, 2) == 0);
}

static const struct check_test tests[] = {
	CHECK_TEST(of_each_face_of_a_cube_a_quarter_of_its_area_is_seen),
	CHECK_TEST(what_is_shut_in_is_not_seen),
	CHECK_TEST(what_stands_behind_an_opening_is_seen),
	CHECK_TEST(faces_that_touch_hide_each_other),
	CHECK_TEST(what_is_thinner_than_a_pixel_is_seen_where_it_lies_open),
	CHECK_TEST(what_is_closed_is_seen_from_where_it_looks),
	CHECK_TEST(what_stands_out_is_seen_from_below_but_not_from_the_air),
	CHECK_TEST(the_number_of_threads_changes_nothing),
	CHECK_TEST(no_triangles_and_flat_ones_are_no_trouble),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
