/* Rolled and bent sections against areas computed by hand. */
#include "ifc_shape_sample.h"
#include "parsers/ifc_profile.h"

/* Between a corner and the quarter of a circle that rounds it, for radius 1. */
static const double ROUND = 1 - SAMPLE_PI / 4;

static double
area_of(const char *schema, const char *data)
{
	struct ifc_faces faces;
	double area = -1;

	if (sample_shape(schema, data, 1e-6, ifc_profile_faces, &faces))
		area = sample_area(&faces);
	ifc_faces_release(&faces);
	return area;
}

static void
sections_have_their_areas(void)
{
	static const struct {
		const char *data;
		double area, round; /* radii squared, those outside negative */
	} all[] = {
		{"#100=IFCISHAPEPROFILEDEF(.AREA.,$,$,100.,200.,6.,8.,12.,2.,"
		 "$);",
			1600 + 184 * 6, 4 * 144 - 4 * 4},
		{"#100=IFCASYMMETRICISHAPEPROFILEDEF(.AREA.,$,$,25.,50.,5.,6.,"
		 "2.,20.,10.,4.,$,$,$,$);",
			150 + 200 + 34 * 5, 2 * 4 + 2 * 16},
		{"#100=IFCLSHAPEPROFILEDEF(.AREA.,$,$,50.,25.,5.,3.,2.,$);",
			125 + 225, 9 - 2 * 4},
		{"#100=IFCLSHAPEPROFILEDEF(.AREA.,$,$,50.,$,5.,$,$,$);",
			250 + 225, 0},
		{"#100=IFCTSHAPEPROFILEDEF(.AREA.,$,$,50.,40.,6.,8.,3.,2.,1.,$,"
		 "$);",
			320 + 42 * 6, 2 * 9 - 2 * 4 - 2},
		{"#100=IFCUSHAPEPROFILEDEF(.AREA.,$,$,50.,25.,4.,5.,3.,2.,$);",
			250 + 160, 2 * 9 - 2 * 4},
		{"#100=IFCZSHAPEPROFILEDEF(.AREA.,$,$,50.,25.,4.,5.,3.,2.);",
			200 + 210, 2 * 9 - 2 * 4},
		{"#100=IFCCSHAPEPROFILEDEF(.AREA.,$,$,50.,25.,5.,10.,$);",
			50 * 25 - 15 * 40 - 5 * 30, 0},
		{"#100=IFCCSHAPEPROFILEDEF(.AREA.,$,$,50.,25.,5.,5.,2.);",
			50 * 25 - 20 * 40, 2 * 4 - 2 * 49},
		{"#100=IFCCSHAPEPROFILEDEF(.AREA.,$,$,50.,25.,5.,10.,2.);",
			50 * 25 - 15 * 40 - 5 * 30, 4 * 4 - 4 * 49},
	};

	for (size_t i = 0; i < sizeof all / sizeof *all; i++)
		CHECK(is_near(area_of("IFC4", all[i].data),
			all[i].area + all[i].round * ROUND, 4e-3));
}

static void
slopes_hold_where_thicknesses_are_measured(void)
{
	double rise = tan(0.1);
	double bend =
		(5 + rise * 25 - rise * (5 + rise * 12.5)) / (1 - rise * rise);
	double high = 5 + rise * (12.5 - bend);

	CHECK(is_near(area_of("IFC4",
			      "#100=IFCISHAPEPROFILEDEF(.AREA.,$,$,100.,200.,"
			      "6.,8.,$,$,0.1);"),
		200 * 6 + 4 * 47 * (8 - 1.5 * rise), 1e-9));
	CHECK(is_near(area_of("IFC4",
			      "#100=IFCTSHAPEPROFILEDEF(.AREA.,$,$,50.,40.,6.,"
			      "8.,$,$,$,$,0.1);"),
		50 * 6 + 2 * 17 * (8 - 1.5 * rise), 1e-9));
	CHECK(is_near(area_of("IFC4",
			      "#100=IFCTSHAPEPROFILEDEF(.AREA.,$,$,50.,40.,6.,"
			      "8.,$,$,$,0.1,$);"),
		40 * 8 + 42 * (6 - 8 * rise), 1e-9));
	CHECK(is_near(area_of("IFC4",
			      "#100=IFCUSHAPEPROFILEDEF(.AREA.,$,$,50.,25.,4.,"
			      "5.,$,$,0.1);"),
		50 * 4 + 2 * 21 * (5 - 2 * rise), 1e-9));
	CHECK(is_near(area_of("IFC4",
			      "#100=IFCLSHAPEPROFILEDEF(.AREA.,$,$,50.,25.,5.,"
			      "$,$,0.1);"),
		75 * 5 -
			(high * (5 + 25 * rise) + bend * (5 + 12.5 * rise)) / 2,
		1e-9));
}

static void
the_asymmetric_section_of_ifc2x3_is_a_symmetric_one_with_more(void)
{
	CHECK(is_near(area_of("IFC2X3",
			      "#100=IFCASYMMETRICISHAPEPROFILEDEF(.AREA.,$,$,"
			      "25.,50.,5.,6.,2.,20.,$,4.,$);"),
		150 + 120 + 38 * 5 + (2 * 4 + 2 * 16) * ROUND, 4e-3));
}

static void
what_does_not_fit_is_refused(void)
{
	static const char *const all[] = {
		"#100=IFCISHAPEPROFILEDEF(.AREA.,$,$,100.,200.,6.,100.,$,$,$);",
		"#100=IFCISHAPEPROFILEDEF(.AREA.,$,$,100.,200.,101.,8.,$,$,$);",
		"#100=IFCISHAPEPROFILEDEF(.AREA.,$,$,100.,200.,6.,8.,$,$,2.);",
		"#100=IFCISHAPEPROFILEDEF(.AREA.,$,$,100.,$,6.,8.,$,$,$);",
		"#100=IFCASYMMETRICISHAPEPROFILEDEF(.AREA.,$,$);",
		"#100=IFCLSHAPEPROFILEDEF(.AREA.,$,$,50.,25.,25.,$,$,$);",
		"#100=IFCLSHAPEPROFILEDEF(.AREA.,$,$,50.,25.,5.,$,$,0.5);",
		"#100=IFCTSHAPEPROFILEDEF(.AREA.,$,$,50.,40.,41.,8.,$,$,$,$,"
		"$);",
		"#100=IFCTSHAPEPROFILEDEF(.AREA.,$,$,50.,40.,6.,8.,$,$,$,0.5,"
		"$);",
		"#100=IFCUSHAPEPROFILEDEF(.AREA.,$,$,50.,25.,4.,25.,$,$,$);",
		"#100=IFCUSHAPEPROFILEDEF(.AREA.,$,$,50.,25.,25.,5.,$,$,$);",
		"#100=IFCZSHAPEPROFILEDEF(.AREA.,$,$,50.,25.,0.,5.,$,$);",
		"#100=IFCCSHAPEPROFILEDEF(.AREA.,$,$,50.,25.,5.,25.,$);",
		"#100=IFCCSHAPEPROFILEDEF(.AREA.,$,$,50.,25.,12.5,15.,$);",
	};

	for (size_t i = 0; i < sizeof all / sizeof *all; i++)
		CHECK(area_of("IFC4", all[i]) < 0);
}

static const struct check_test tests[] = {
	CHECK_TEST(sections_have_their_areas),
	CHECK_TEST(slopes_hold_where_thicknesses_are_measured),
	CHECK_TEST(
		the_asymmetric_section_of_ifc2x3_is_a_symmetric_one_with_more),
	CHECK_TEST(what_does_not_fit_is_refused),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
