#include "frame.h"

#include <math.h>
#include <stdbool.h>

#include "check.h"

static bool
near(struct tcs_point a, double x, double y, double z, double tolerance)
{
	bool fine = fabs(a.x - x) <= tolerance && fabs(a.y - y) <= tolerance &&
		fabs(a.z - z) <= tolerance;

	if (!fine)
		fprintf(stderr, "%.12g %.12g %.12g\n", a.x, a.y, a.z);
	return fine;
}

static struct frame
frame_of(enum tcs_crs_kind kind, double x, double y, double z)
{
	struct tcs_crs crs = {.metres_per_unit = 1,
		.metres_per_unit_up = 1,
		.origin = {x, y, z},
		.kind = kind};
	struct frame frame;

	frame_init(&frame, &crs, NULL);
	return frame;
}

static void
a_projected_system_is_shifted_and_scaled(void)
{
	struct tcs_crs crs = {.metres_per_unit = 0.3048,
		.metres_per_unit_up = 0.5,
		.origin = {1, 2, 3},
		.kind = TCS_CRS_PROJECTED};
	struct tcs_point other = {1000, 2000, 30}, point = {1010, 2020, 34};
	struct frame frame;

	frame_init(&frame, &crs, &other);
	CHECK(near(frame_to_local(&frame, point), 3.048, 6.096, 2, 1e-12));
	CHECK(near(frame_from_local(&frame, frame_to_local(&frame, point)),
		1010, 2020, 34, 1e-9));
	frame_init(&frame, &crs, NULL);
	CHECK(near(frame_to_local(&frame, crs.origin), 0, 0, 0, 0));
}

static void
a_millimetre_at_five_million_metres_stays(void)
{
	struct frame frame =
		frame_of(TCS_CRS_UNKNOWN, 691051.25, 5333770.5, 512);
	struct tcs_point point = {691051.251, 5333770.5, 512};

	CHECK(near(frame_to_local(&frame, point), 0.001, 0, 0, 1e-9));
}

/*
 * The figures are PROJ's (9.1): proj +proj=tmerc +lat_0=48.1374 +lon_0=11.5755
 * +k=1 +ellps=GRS80, which computes without Snyder's series.
 */
static void
a_geographic_system_goes_through_transverse_mercator(void)
{
	struct frame frame =
		frame_of(TCS_CRS_GEOGRAPHIC, 11.5755, 48.1374, 520);
	struct frame south = frame_of(TCS_CRS_GEOGRAPHIC, -70.66, -33.45, 0);
	struct tcs_point near_by = {11.60, 48.15, 540};
	struct tcs_point far = {11.0, 47.5, 520};
	struct tcs_point santiago = {-70.31, -33.52, 0};

	CHECK(near(frame_to_local(&frame, near_by), 1823.014854652,
		1401.323610762, 20, 1e-6));
	CHECK(near(frame_to_local(&frame, far), -43360.160460744,
		-70709.908246636, 0, 1e-4));
	CHECK(near(frame_to_local(&south, santiago), 32515.488767400,
		-7818.762104138, 0, 1e-4));
	CHECK(near(frame_to_local(&frame, frame.origin), 0, 0, 0, 0));
}

/* PROJ's again: cct +proj=cart, then cct +proj=topocentric, at the same place. */
static void
a_geocentric_system_is_turned_to_east_north_up(void)
{
	struct frame frame = frame_of(TCS_CRS_GEOCENTRIC, 4177959.901305879,
		855750.369888666, 4727472.774721454);
	struct tcs_point point = {
		4176584.378362156, 857329.648370830, 4728422.608909524};

	CHECK(near(frame_to_local(&frame, point), 1823.168862326,
		1401.442318996, 19.585804427, 1e-6));
}

static void
there_and_back_is_the_same_point(void)
{
	static const struct {
		enum tcs_crs_kind kind;
		struct tcs_point origin, off;
		double tolerance;
	} cases[] = {
		{TCS_CRS_GEOGRAPHIC, {11.5, 48.1, 520}, {0.1, 0.1, 9}, 1e-12},
		{TCS_CRS_GEOGRAPHIC, {11.5, 48.1, 520}, {2, 1, 9}, 1e-11},
		{TCS_CRS_GEOGRAPHIC, {-70, -33, 0}, {-0.3, 0.2, -4}, 1e-12},
		{TCS_CRS_GEOGRAPHIC, {103, 0, 0}, {0.1, -0.2, 1}, 1e-12},
		{TCS_CRS_GEOGRAPHIC, {20, 78, 0}, {0.5, 0.1, 1}, 1e-11},
		{TCS_CRS_GEOCENTRIC, {4177959, 855750, 4727472},
			{1000, -2000, 50}, 1e-8},
		{TCS_CRS_PROJECTED, {691051, 5333770, 500},
			{1234.567, -9876.543, 12.3}, 1e-9},
	};

	for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
		struct tcs_point o = cases[i].origin, d = cases[i].off;
		struct frame frame = frame_of(cases[i].kind, o.x, o.y, o.z);
		struct tcs_point at = {o.x + d.x, o.y + d.y, o.z + d.z};
		struct tcs_point back =
			frame_from_local(&frame, frame_to_local(&frame, at));

		CHECK(near(back, at.x, at.y, at.z, cases[i].tolerance));
	}
}

static void
the_poles_and_the_centre_give_numbers(void)
{
	struct frame pole = frame_of(TCS_CRS_GEOGRAPHIC, 0, 90, 0);
	struct frame centre = frame_of(TCS_CRS_GEOCENTRIC, 0, 0, 0);
	struct tcs_point point = {10, 89.99, 3};
	struct tcs_point at = frame_to_local(&pole, point);

	CHECK(isfinite(at.x) && isfinite(at.y) && at.z == 3);
	at = frame_from_local(&pole, at);
	CHECK(isfinite(at.x) && isfinite(at.y));
	at = frame_to_local(&centre, point);
	CHECK(isfinite(at.x) && isfinite(at.y) && isfinite(at.z));
}

static const struct check_test tests[] = {
	CHECK_TEST(a_projected_system_is_shifted_and_scaled),
	CHECK_TEST(a_millimetre_at_five_million_metres_stays),
	CHECK_TEST(a_geographic_system_goes_through_transverse_mercator),
	CHECK_TEST(a_geocentric_system_is_turned_to_east_north_up),
	CHECK_TEST(there_and_back_is_the_same_point),
	CHECK_TEST(the_poles_and_the_centre_give_numbers),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
