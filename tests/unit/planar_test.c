#include "planar.h"

#include "check.h"
#include "planar_slabs.h"

__extension__ typedef __int128 wide;

static int
sign(double value)
{
	return (value > 0) - (value < 0);
}

/* Coordinates in units of `unit`, a power of two. */
struct grid_point {
	int64_t x, y;
};

static int
exact_turn(struct grid_point a, struct grid_point b, struct grid_point c)
{
	wide area = (wide)(a.x - c.x) * (b.y - c.y) -
		(wide)(a.y - c.y) * (b.x - c.x);

	return (area > 0) - (area < 0);
}

static struct planar_point
placed(struct grid_point at, double unit)
{
	return (struct planar_point){(double)at.x * unit, (double)at.y * unit};
}

static bool
turns_right(struct grid_point a, struct grid_point b, struct grid_point c,
	double unit)
{
	return sign(planar_orient(placed(a, unit), placed(b, unit),
		       placed(c, unit))) == exact_turn(a, b, c);
}

/*
 * Points around the middle of a diagonal, one unit of the last place apart;
 * source: L. Kettner et al., Classroom examples of robustness problems in
 * geometric computations, 2008.
 */
static void
points_next_to_a_line_lie_on_their_side(void)
{
	const int64_t half = (int64_t)1 << 52;
	const struct grid_point b = {24 * half, 24 * half};
	const struct grid_point c = {48 * half, 48 * half};

	for (int x = 0; x < 64; x++) {
		for (int y = 0; y < 64; y++) {
			struct grid_point a = {half + x, half + y};

			CHECK(turns_right(a, b, c, 0x1p-53));
			CHECK(turns_right(b, a, c, 0x1p-53));
			CHECK(turns_right(c, b, a, 0x1p-53));
		}
	}
}

/* The products have 64 bits, and the last of them decide. */
static void
whole_numbers_next_to_a_line_lie_on_their_side(void)
{
	for (int64_t i = 0; i < 2000; i++) {
		struct grid_point origin = {0, 0};
		struct grid_point a = {
			((int64_t)1 << 31) + 7 * i, ((int64_t)1 << 31) - i};
		struct grid_point b = {a.x + i % 3, a.y + i % 3 - i % 2};
		struct grid_point c = {a.x - 1, a.y - 1};

		CHECK(turns_right(a, b, origin, 1));
		CHECK(turns_right(a, c, origin, 1));
		CHECK(turns_right(b, c, origin, 1));
	}
}

static void
the_largest_and_smallest_coordinates_keep_their_sign(void)
{
	struct planar_point big[] = {
		{1e75, 1e75}, {-1e75, -1e75}, {1, 1.0000001}};
	struct planar_point small[] = {
		{1e-75, 1e-75}, {-1e-75, -1e-75}, {1e-76, 2e-76}};

	CHECK(planar_orient(big[0], big[1], big[2]) < 0);
	CHECK(planar_orient(big[1], big[0], big[2]) > 0);
	CHECK(planar_orient(small[0], small[1], small[2]) < 0);
}

struct slabs_answer {
	double area, wrong;
};

static struct slabs_answer
slabs_asked(const struct tcs_point *vertices, const uint32_t *rings,
	size_t ring_count, size_t count, const struct triangle_list *triangles)
{
	struct planar polygon = {.area = 0};
	struct slabs_answer answer = {-1, -1};
	struct tcs_fault fault;
	enum tcs_status status;
	double flatness;

	CHECK(!planar_find(
		&polygon.plane, vertices, rings[0], count, &flatness));
	CHECK(!planar_lay(
		&polygon, vertices, rings, ring_count, count, &status));
	CHECK(!status);
	CHECK(!slabs_check(
		&polygon, triangles, &answer.area, &answer.wrong, &fault));
	planar_release(&polygon);
	return answer;
}

/* A square of 4 with a hole of 1 x 1, and another that lies half outside. */
static void
slabs_count_what_is_inside_an_odd_number_of_times(void)
{
	static const struct tcs_point vertices[] = {{0, 0, 0}, {4, 0, 0},
		{4, 4, 0}, {0, 4, 0}, {1, 1, 0}, {2, 1, 0}, {2, 2, 0},
		{1, 2, 0}, {3, 3, 0}, {5, 3, 0}, {5, 3.5, 0}, {3, 3.5, 0}};
	static const uint32_t rings[] = {4, 4, 4};
	static const double areas[] = {16, 15, 15};
	static const size_t counts[] = {4, 8, 12};
	struct triangle_list none = {0};

	for (size_t i = 0; i < 3; i++) {
		struct slabs_answer answer =
			slabs_asked(vertices, rings, i + 1, counts[i], &none);

		CHECK(fabs(answer.area - areas[i]) < 1e-12);
		CHECK(fabs(answer.wrong - areas[i]) < 1e-12);
	}
}

/* Half a square, and where triangles of the whole one would lie. */
static void
slabs_see_triangles_in_the_wrong_place(void)
{
	static const struct tcs_point vertices[] = {
		{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 2, 0}, {0, 4, 0}};
	static const uint32_t rings[] = {4, 1};
	struct tcs_triangle bottom = {{0, 1, 3}}, right = {{1, 2, 3}};
	struct tcs_triangle left = {{0, 3, 4}};
	struct {
		struct tcs_triangle triangles[3];
		size_t count;
		double wrong;
	} covers[] = {{{bottom, right}, 2, 0}, {{right}, 1, 4},
		{{left, right}, 2, 8}, {{bottom, right, right}, 3, 4}};

	for (size_t i = 0; i < sizeof covers / sizeof *covers; i++) {
		struct triangle_list triangles = {
			.at = covers[i].triangles, .count = covers[i].count};
		struct slabs_answer answer =
			slabs_asked(vertices, rings, 2, 5, &triangles);

		CHECK(fabs(answer.area - 8) < 1e-12);
		CHECK(fabs(answer.wrong - covers[i].wrong) < 1e-12);
	}
}

static const struct check_test tests[] = {
	CHECK_TEST(points_next_to_a_line_lie_on_their_side),
	CHECK_TEST(whole_numbers_next_to_a_line_lie_on_their_side),
	CHECK_TEST(the_largest_and_smallest_coordinates_keep_their_sign),
	CHECK_TEST(slabs_count_what_is_inside_an_odd_number_of_times),
	CHECK_TEST(slabs_see_triangles_in_the_wrong_place),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
