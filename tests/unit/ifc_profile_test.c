/* Profiles against areas computed by hand, and the curves they are made of. */
#include <math.h>

#include "check.h"
#include "ifc_sample.h"
#include "parsers/ifc_curve.h"
#include "parsers/ifc_item.h"
#include "parsers/ifc_profile.h"

static const double PI = 3.14159265358979323846;

#define PLACES \
	"#1=IFCCARTESIANPOINT((0.,0.));#2=IFCCARTESIANPOINT((1.,0.));" \
	"#3=IFCCARTESIANPOINT((1.,1.));#4=IFCCARTESIANPOINT((0.,1.));" \
	"#5=IFCAXIS2PLACEMENT2D(#1,$);#6=IFCCIRCLE(#5,1.);" \
	"#7=IFCPOLYLINE((#1,#2,#3,#4,#1));" \
	"#8=IFCCARTESIANPOINTLIST2D(((0.,0.),(1.,0.),(1.,1.),(0.,1.)));"

static struct ifc_shaper
shaper_of(const struct sample *sample, double deflection)
{
	return (struct ifc_shaper){.file = &sample->file,
		.angle = 1,
		.deflection = deflection,
		.precision = 1e-9};
}

static double
ring_area(const struct tcs_point *points, size_t count)
{
	double area = 0;

	for (size_t i = 0; i < count; i++)
		area += points[i].x * points[(i + 1) % count].y -
			points[(i + 1) % count].x * points[i].y;
	return area / 2;
}

static double
faces_area(const struct ifc_faces *faces)
{
	const struct tcs_point *points = faces->points.at;
	double area = 0;

	for (size_t i = 0; i < faces->rings.count; i++) {
		area += ring_area(points, faces->rings.at[i]);
		points += faces->rings.at[i];
	}
	CHECK(ifc_faces_loose(faces) == 0);
	return area;
}

/* The area of profile #100, or less than 0 when it is refused. */
static double
area_of(const char *data, double deflection)
{
	struct ifc_faces faces = {.points = {.count = 0}};
	struct sample sample;
	struct ifc_shaper shaper;
	double area = -1;

	CHECK(!sample_open(&sample, "IFC4", data));
	shaper = shaper_of(&sample, deflection);
	CHECK(!ifc_scratch_new(&shaper.scratch, &sample.fault));
	switch (ifc_profile_faces(&shaper, instance(&sample, 100), &faces)) {
	case IFC_SHAPED:
		area = faces_area(&faces);
		break;
	case IFC_REFUSED:
		CHECK(shaper.reason != NULL);
		break;
	default:
		CHECK(false);
	}
	CHECK(shaper.depth == 0 || area < 0);
	ifc_scratch_free(shaper.scratch);
	ifc_faces_release(&faces);
	sample_close(&sample);
	return area;
}

static bool
near(double a, double b, double by)
{
	return fabs(a - b) <= by;
}

static void
plain_profiles_have_their_areas(void)
{
	static const struct {
		const char *data;
		double area, by;
	} all[] = {
		{"#100=IFCRECTANGLEPROFILEDEF(.AREA.,$,$,3.,2.);", 6, 1e-12},
		{"#100=IFCRECTANGLEPROFILEDEF(.AREA.,$,#5,3.,2.);", 6, 1e-12},
		{"#100=IFCRECTANGLEHOLLOWPROFILEDEF(.AREA.,$,#5,3.,2.,0.25,$,"
		 "$);",
			6 - 2.5 * 1.5, 1e-12},
		{"#100=IFCTRAPEZIUMPROFILEDEF(.AREA.,$,#5,3.,1.,2.,0.5);", 4,
			1e-12},
		{"#100=IFCCIRCLEPROFILEDEF(.AREA.,$,#5,2.);",
			3.14159265358979 * 4, 1e-3},
		{"#100=IFCCIRCLEHOLLOWPROFILEDEF(.AREA.,$,#5,2.,0.5);",
			3.14159265358979 * 1.75, 1e-3},
		{"#100=IFCELLIPSEPROFILEDEF(.AREA.,$,#5,2.,1.);",
			3.14159265358979 * 2, 1e-3},
		{"#100=IFCROUNDEDRECTANGLEPROFILEDEF(.AREA.,$,#5,3.,2.,0.5);",
			6 - (4 - 3.14159265358979) * 0.25, 1e-3},
		{"#100=IFCRECTANGLEHOLLOWPROFILEDEF(.AREA.,$,#5,3.,2.,0.25,"
		 "0.25,0.5);",
			6 - 3.75 - (4 - 3.14159265358979) * (0.25 - 0.0625),
			1e-3},
	};

	for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
		char data[2048];

		snprintf(data, sizeof data, "%s%s", PLACES, all[i].data);
		CHECK(near(area_of(data, 1e-5), all[i].area, all[i].by));
	}
}

static void
a_circle_of_n_chords_is_an_n_gon(void)
{
	double area =
		area_of(PLACES "#100=IFCCIRCLEPROFILEDEF(.AREA.,$,#5,2.);", 10);

	CHECK(near(area, 24 / 2 * 4 * sin(2 * PI / 24), 1e-12));
}

static void
curves_of_many_kinds_bound_areas(void)
{
	static const struct {
		const char *curve;
		double area;
	} all[] = {
		{"#50=IFCPOLYLINE((#1,#2,#3,#4,#1));", 1},
		{"#50=IFCPOLYLINE((#1,#4,#3,#2));", 1},
		{"#50=IFCINDEXEDPOLYCURVE(#8,$,.F.);", 1},
		{"#50=IFCINDEXEDPOLYCURVE(#8,(IFCLINEINDEX((1,2,3)),"
		 "IFCLINEINDEX((3,4,1))),.F.);",
			1},
		{"#50=IFCINDEXEDPOLYCURVE(#8,(IFCARCINDEX((1,2,3)),"
		 "IFCARCINDEX((3,4,1))),.F.);",
			3.14159265358979 / 2},
		{"#50=IFCCOMPOSITECURVE((#51,#52),.F.);"
		 "#51=IFCCOMPOSITECURVESEGMENT(.CONTINUOUS.,.T.,#53);"
		 "#52=IFCCOMPOSITECURVESEGMENT(.CONTINUOUS.,.F.,#54);"
		 "#53=IFCTRIMMEDCURVE(#6,(IFCPARAMETERVALUE(0.)),"
		 "(IFCPARAMETERVALUE(3.141592653589793)),.T.,.PARAMETER.);"
		 "#54=IFCPOLYLINE((#2,#55));#55=IFCCARTESIANPOINT((-1.,0.));",
			3.14159265358979 / 2},
		{"#50=IFCCOMPOSITECURVE((#51,#52),.F.);"
		 "#51=IFCCOMPOSITECURVESEGMENT(.CONTINUOUS.,.T.,#53);"
		 "#52=IFCCOMPOSITECURVESEGMENT(.CONTINUOUS.,.T.,#54);"
		 "#53=IFCTRIMMEDCURVE(#6,(#2),(#4),.F.,.CARTESIAN.);"
		 "#54=IFCPOLYLINE((#4,#1,#2));",
			3.14159265358979 * 3 / 4},
	};

	for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
		char data[2048];

		snprintf(data, sizeof data,
			"%s%s#100=IFCARBITRARYCLOSEDPROFILEDEF(.AREA.,$,#50);",
			PLACES, all[i].curve);
		CHECK(near(area_of(data, 1e-5), all[i].area, 1e-3));
	}
}

static void
holes_and_operators_count(void)
{
	CHECK(near(
		area_of(PLACES
			"#100=IFCARBITRARYPROFILEDEFWITHVOIDS(.AREA.,$,#6,(#90));"
			"#90=IFCPOLYLINE((#91,#92,#93,#91));"
			"#91=IFCCARTESIANPOINT((0.,0.));"
			"#92=IFCCARTESIANPOINT((0.5,0.));"
			"#93=IFCCARTESIANPOINT((0.,0.5));",
			1e-6),
		PI - 0.125, 1e-3));
	CHECK(near(
		area_of(PLACES
			"#100=IFCDERIVEDPROFILEDEF(.AREA.,$,#99,#98,$);"
			"#99=IFCRECTANGLEPROFILEDEF(.AREA.,$,$,3.,2.);"
			"#98=IFCCARTESIANTRANSFORMATIONOPERATOR2D($,$,#1,2.);",
			1e-6),
		24, 1e-12));
	CHECK(near(
		area_of(PLACES "#100=IFCMIRROREDPROFILEDEF(.AREA.,$,#99,*,$);"
			       "#99=IFCRECTANGLEPROFILEDEF(.AREA.,$,$,3.,2.);",
			1e-6),
		6, 1e-12));
	CHECK(near(area_of(PLACES
			   "#100=IFCCOMPOSITEPROFILEDEF(.AREA.,$,(#99,#99),$);"
			   "#99=IFCRECTANGLEPROFILEDEF(.AREA.,$,$,3.,2.);",
			   1e-6),
		12, 1e-12));
}

/* By the odd-even rule: the areas of the lobes, whatever way they run. */
static void
what_crosses_itself_is_filled_where_it_is_inside_once(void)
{
	static const struct {
		const char *points, *voids;
		double area;
	} all[] = {
		/* An 8 of equal lobes, whose signed areas cancel out. */
		{"(0.,0.),(2.,2.),(2.,0.),(0.,2.)", NULL, 2},
		{"(0.,0.),(3.,3.),(3.,0.),(0.,3.),(0.,1.)", NULL, 2.25 + 2.25},
		/* A curl inside is left out, one outside is filled. */
		{"(0.,0.),(4.,0.),(4.,4.),(1.,4.),(1.,1.),(3.,1.),(3.,3.),"
		 "(0.,3.)",
			NULL, 16 - 1 - 4},
		{"(0.,0.),(2.,0.),(2.,3.),(3.,3.),(3.,2.),(0.,2.)", NULL,
			4 + 1},
		/* A hole that looks out. */
		{"(0.,0.),(2.,0.),(2.,2.),(0.,2.)",
			"(1.,1.),(3.,1.),(3.,1.5),(1.,1.5)", 4 - 0.5 + 0.5},
		/* Lobes that touch in a corner that is told twice. */
		{"(0.,0.),(1.,1.),(2.,0.),(2.,2.),(1.,1.),(0.,2.)", NULL, 2},
	};

	for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
		char data[2048];

		snprintf(data, sizeof data,
			"#100=IFCARBITRARY%s(.AREA.,$,#101%s);"
			"#101=IFCINDEXEDPOLYCURVE(#102,$,$);"
			"#102=IFCCARTESIANPOINTLIST2D((%s));"
			"#103=IFCINDEXEDPOLYCURVE(#104,$,$);"
			"#104=IFCCARTESIANPOINTLIST2D((%s));",
			all[i].voids ? "PROFILEDEFWITHVOIDS"
				     : "CLOSEDPROFILEDEF",
			all[i].voids ? ",(#103)" : "", all[i].points,
			all[i].voids ? all[i].voids : "");
		CHECK(near(area_of(data, 1e-3), all[i].area, 1e-9));
	}
}

static void
what_is_no_area_is_refused(void)
{
	static const char *const all[] = {
		"#100=IFCRECTANGLEPROFILEDEF(.AREA.,$,$,0.,2.);",
		"#100=IFCRECTANGLEPROFILEDEF(.AREA.,$,$,$,2.);",
		"#100=IFCRECTANGLEPROFILEDEF(.AREA.,$,#99,3.,2.);",
		"#100=IFCCIRCLEPROFILEDEF(.AREA.,$,$,-1.);",
		"#100=IFCRECTANGLEHOLLOWPROFILEDEF(.AREA.,$,$,3.,2.,1.,$,$);",
		"#100=IFCARBITRARYCLOSEDPROFILEDEF(.AREA.,$,#99);",
		"#100=IFCARBITRARYCLOSEDPROFILEDEF(.AREA.,$,#1);",
		("#100=IFCARBITRARYCLOSEDPROFILEDEF(.AREA.,$,#99);"
		 "#99=IFCPOLYLINE((#1,#2,#1));"),
		"#100=IFCCOMPOSITEPROFILEDEF(.AREA.,$,(#100),$);",
		"#100=IFCWALL();",
	};

	for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
		char data[2048];

		snprintf(data, sizeof data, "%s%s", PLACES, all[i]);
		CHECK(area_of(data, 1e-3) < 0);
	}
}

/* Each level holds the one below twice: 2^40 rectangles. */
static void
what_is_used_ever_again_ends(void)
{
	char data[8192];
	size_t at = (size_t)snprintf(data, sizeof data,
		"#140=IFCRECTANGLEPROFILEDEF(.AREA.,$,$,3.,2.);");

	for (int i = 100; i < 140; i++)
		at += (size_t)snprintf(data + at, sizeof data - at,
			"#%d=IFCCOMPOSITEPROFILEDEF(.AREA.,$,(#%d,#%d),$);", i,
			i + 1, i + 1);
	CHECK(area_of(data, 1e-3) < 0);
}

static void
parts_of_curves_lie_between_parameters(void)
{
	struct ifc_points points = {.count = 0};
	struct sample sample;
	struct ifc_shaper shaper;
	double from, to;

	CHECK(!sample_open(&sample, "IFC4",
		PLACES "#50=IFCCOMPOSITECURVE((#51,#52),.F.);"
		       "#51=IFCCOMPOSITECURVESEGMENT(.CONTINUOUS.,.T.,#53);"
		       "#52=IFCCOMPOSITECURVESEGMENT(.CONTINUOUS.,.T.,#54);"
		       "#53=IFCPOLYLINE((#1,#2,#3));"
		       "#54=IFCPOLYLINE((#3,#4));"));
	shaper = shaper_of(&sample, 1e-3);
	CHECK(!ifc_curve_range(&shaper, instance(&sample, 50), &from, &to));
	CHECK(from == 0 && to == 3);
	CHECK(!ifc_curve_between(
		&shaper, instance(&sample, 50), 0.5, 2.25, &points));
	CHECK(points.count == 4);
	CHECK(points.at[0].x == 0.5 && points.at[0].y == 0);
	CHECK(points.at[3].x == 0.75 && points.at[3].y == 1);
	array_clear(&points);
	CHECK(!ifc_curve_between(
		&shaper, instance(&sample, 50), 1.5, 0.5, &points));
	CHECK(points.count == 3 && points.at[0].y == 0.5 &&
		points.at[2].x == 0.5);
	CHECK(shaper.depth == 0);
	array_release(&points);
	sample_close(&sample);
}

static const struct check_test tests[] = {
	CHECK_TEST(plain_profiles_have_their_areas),
	CHECK_TEST(a_circle_of_n_chords_is_an_n_gon),
	CHECK_TEST(curves_of_many_kinds_bound_areas),
	CHECK_TEST(holes_and_operators_count),
	CHECK_TEST(what_crosses_itself_is_filled_where_it_is_inside_once),
	CHECK_TEST(what_is_no_area_is_refused),
	CHECK_TEST(what_is_used_ever_again_ends),
	CHECK_TEST(parts_of_curves_lie_between_parameters),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
