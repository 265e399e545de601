#include "check.h"
#include "writers/gltf_placement.h"

#include <math.h>
#include <string.h>

static const struct tcs_crs metric = {
	.metres_per_unit = 1, .metres_per_unit_up = 1};
static const struct tcs_point origin = {500000, 5300000, 100};

static bool
place(double matrix[16], const struct tcs_crs *crs, const double rows[16])
{
	struct tcs_instance instance = {.anchor = {500010, 5300020, 130}};
	struct frame frame;

	frame_init(&frame, crs, &origin);
	memcpy(instance.matrix, rows, sizeof instance.matrix);
	return placement_matrix(matrix, &frame, &instance);
}

/* Column k of rotation times scale, from the quaternion. */
static void
column(const struct placement *at, int k, double out[3])
{
	double x = (double)at->rotation[0], y = (double)at->rotation[1];
	double z = (double)at->rotation[2], w = (double)at->rotation[3];
	const double r[3][3] = {{1 - 2 * (y * y + z * z), 2 * (x * y + z * w),
					2 * (x * z - y * w)},
		{2 * (x * y - z * w), 1 - 2 * (x * x + z * z),
			2 * (y * z + x * w)},
		{2 * (x * z + y * w), 2 * (y * z - x * w),
			1 - 2 * (x * x + y * y)}};

	for (int i = 0; i < 3; i++)
		out[i] = r[k][i] * (double)at->scale[k];
}

/* Turned about z by a, then about x by b; y is scaled by 3, x by `side`. */
static void
check_turn(double a, double b, double side)
{
	const double rows[16] = {side * cos(a), -3 * sin(a), 0, 1,
		side * sin(a) * cos(b), 3 * cos(a) * cos(b), -sin(b), 2,
		side * sin(a) * sin(b), 3 * cos(a) * sin(b), cos(b), 3, 0, 0, 0,
		1};
	struct placement at;
	double matrix[16], got[3];

	CHECK(place(matrix, &metric, rows));
	CHECK(matrix[12] == 11 && matrix[13] == 22 && matrix[14] == 33);
	at = placement_split(matrix);
	CHECK(at.translation[2] == 33);
	for (int k = 0; k < 3; k++) {
		column(&at, k, got);
		for (int i = 0; i < 3; i++) {
			CHECK(matrix[4 * k + i] == rows[4 * i + k]);
			CHECK(fabs(got[i] - matrix[4 * k + i]) < 1e-5);
		}
	}
}

static void
the_three_parts_make_the_matrix_again(void)
{
	for (int a = 0; a < 24; a++)
		for (int b = 0; b < 24; b++) {
			check_turn(a * 0.2618, b * 0.2618, 2);
			check_turn(a * 0.2618, b * 0.2618, -0.5);
		}
}

static void
units_of_the_system_become_metres(void)
{
	static const struct tcs_crs feet = {
		.metres_per_unit = 0.3048, .metres_per_unit_up = 1};
	static const double rows[16] = {
		1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
	double matrix[16];

	CHECK(place(matrix, &feet, rows));
	CHECK(matrix[0] == 0.3048 && matrix[5] == 0.3048 && matrix[10] == 1);
	CHECK(fabs(matrix[13] - 20 * 0.3048) < 1e-12 && matrix[14] == 30);
}

static void
what_a_node_cannot_say_is_refused(void)
{
	static const double sheared[16] = {
		1, 0.5, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
	static const double flat[16] = {
		1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1};
	static const double far[16] = {
		1, 0, 0, 1e39, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
	double matrix[16];

	CHECK(!place(matrix, &metric, sheared));
	CHECK(!place(matrix, &metric, flat));
	CHECK(!place(matrix, &metric, far));
}

int
main(void)
{
	static const struct check_test tests[] = {
		CHECK_TEST(the_three_parts_make_the_matrix_again),
		CHECK_TEST(units_of_the_system_become_metres),
		CHECK_TEST(what_a_node_cannot_say_is_refused),
		{0},
	};

	return check_run(tests);
}
