/* B-splines and offset curves against areas and points computed by hand. */
#include "ifc_shape_sample.h"
#include "parsers/ifc_curve.h"
#include "parsers/ifc_profile.h"
#include "parsers/ifc_spline.h"

#define PLACES \
	"#1=IFCCARTESIANPOINT((0.,0.));#2=IFCCARTESIANPOINT((1.,0.));" \
	"#3=IFCCARTESIANPOINT((1.,1.));#4=IFCCARTESIANPOINT((0.,1.));" \
	"#5=IFCCARTESIANPOINT((-1.,1.));#6=IFCCARTESIANPOINT((-1.,0.));" \
	"#7=IFCCARTESIANPOINT((-1.,-1.));#8=IFCCARTESIANPOINT((0.,-1.));" \
	"#9=IFCCARTESIANPOINT((1.,-1.));#10=IFCAXIS2PLACEMENT2D(#1,$);" \
	"#11=IFCCIRCLE(#10,1.);" \
	"#12=IFCPOLYLINE((#2,#4,#6,#8,#2));"

/* A whole circle in nine points. */
#define CIRCLE \
	"#20=IFCRATIONALBSPLINECURVEWITHKNOTS(2,(#2,#3,#4,#5,#6,#7,#8,#9,#2)," \
	".UNSPECIFIED.,.T.,.F.,(3,2,2,2,3),(0.,0.25,0.5,0.75,1.),.UNSPECIFIED.," \
	"(1.,0.7071067811865476,1.,0.7071067811865476,1.,0.7071067811865476," \
	"1.,0.7071067811865476,1.));"

static double
area_of(const char *data, double deflection)
{
	struct ifc_faces faces;
	double area = -1;

	if (sample_shape("IFC4", data, deflection, ifc_profile_faces, &faces))
		area = sample_area(&faces);
	ifc_faces_release(&faces);
	return area;
}

static void
a_rational_circle_is_one_at_every_deflection(void)
{
	for (double deflection = 1e-2; deflection > 1e-7; deflection /= 10) {
		double area = area_of(PLACES CIRCLE
			"#100=IFCARBITRARYCLOSEDPROFILEDEF(.AREA.,$,#20);",
			deflection);

		CHECK(area < SAMPLE_PI);
		CHECK(is_near(area, SAMPLE_PI, 2 * SAMPLE_PI * deflection));
	}
}

static void
a_bezier_curve_needs_no_knots(void)
{
	CHECK(is_near(
		area_of(PLACES
			"#20=IFCBEZIERCURVE(2,(#1,#2,#3),.UNSPECIFIED.,.F.,.F.);"
			"#21=IFCPOLYLINE((#3,#2,#1));"
			"#22=IFCCOMPOSITECURVESEGMENT(.CONTINUOUS.,.T.,#20);"
			"#23=IFCCOMPOSITECURVESEGMENT(.CONTINUOUS.,.T.,#21);"
			"#24=IFCCOMPOSITECURVE((#22,#23),.F.);"
			"#100=IFCARBITRARYCLOSEDPROFILEDEF(.AREA.,$,#24);",
			1e-7),
		1. / 6, 1e-6));
}

static void
splines_are_trimmed_by_parameters_and_points(void)
{
	static const char *const all[] = {
		("(IFCPARAMETERVALUE(0.)),(IFCPARAMETERVALUE(0.5)),.T.,"
		 ".PARAMETER."),
		"(#2),(#6),.T.,.CARTESIAN.",
		"(#6),(#2),.F.,.CARTESIAN.",
	};

	for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
		char data[4096];

		snprintf(data, sizeof data,
			"%s#21=IFCTRIMMEDCURVE(#20,%s);"
			"#100=IFCARBITRARYCLOSEDPROFILEDEF(.AREA.,$,#21);",
			PLACES CIRCLE, all[i]);
		CHECK(is_near(area_of(data, 1e-7), SAMPLE_PI / 2, 1e-6));
	}
}

static void
offsets_lie_beside_their_curves(void)
{
	static const struct {
		const char *curve;
		double area;
	} all[] = {
		{"#20=IFCOFFSETCURVE2D(#11,-0.5,.F.);",
			2.25 * 3.14159265358979},
		{"#20=IFCOFFSETCURVE2D(#11,0.5,.F.);", 0.25 * 3.14159265358979},
		{"#20=IFCOFFSETCURVE2D(#12,-0.7071067811865476,.F.);", 8},
		{"#20=IFCOFFSETCURVE3D(#12,0.7071067811865476,.F.,#21);"
		 "#21=IFCDIRECTION((0.,0.,-3.));",
			8},
	};

	for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
		char data[4096];

		snprintf(data, sizeof data,
			"%s%s#100=IFCARBITRARYCLOSEDPROFILEDEF(.AREA.,$,#20);",
			PLACES, all[i].curve);
		CHECK(is_near(area_of(data, 1e-5), all[i].area, 1e-4));
	}
}

static void
strips_are_as_large_as_long_and_thick(void)
{
	CHECK(is_near(
		area_of(PLACES
			"#20=IFCPOLYLINE((#6,#1,#4,#3));"
			"#100=IFCCENTERLINEPROFILEDEF(.AREA.,$,#20,0.25);",
			1e-3),
		0.75, 1e-12));
	CHECK(is_near(area_of(PLACES
			      "#100=IFCCENTERLINEPROFILEDEF(.AREA.,$,#11,0.5);",
			      1e-6),
		SAMPLE_PI, 1e-4));
	CHECK(is_near(
		area_of(PLACES
			"#20=IFCPOLYLINE((#2,#8,#6,#4,#2));"
			"#100=IFCCENTERLINEPROFILEDEF(.AREA.,$,#20,0.25);",
			1e-6),
		sqrt(2), 1e-12));
}

static void
splines_that_are_none_are_refused(void)
{
	static const char *const all[] = {
		"2,(#2,#3),.UNSPECIFIED.,.F.,.F.,(3,2),(0.,1.),.UNSPECIFIED.",
		"0,(#2,#3),.UNSPECIFIED.,.F.,.F.,(1,2),(0.,1.),.UNSPECIFIED.",
		"99,(#2,#3),.UNSPECIFIED.,.F.,.F.,(2,2),(0.,1.),.UNSPECIFIED.",
		"1,(#2,#3),.UNSPECIFIED.,.F.,.F.,(2,2),(0.,0.),.UNSPECIFIED.",
		"1,(#2,#3),.UNSPECIFIED.,.F.,.F.,(2,2),(1.,0.),.UNSPECIFIED.",
		"1,(#2,#3),.UNSPECIFIED.,.F.,.F.,(2),(0.,1.),.UNSPECIFIED.",
		"1,(#2,#3),.UNSPECIFIED.,.F.,.F.,(2,2),(0.),.UNSPECIFIED.",
		"1,(#2,#3),.UNSPECIFIED.,.F.,.F.,(2,900000000),(0.,1.),"
		".UNSPECIFIED.",
		"1,(#2,#3),.UNSPECIFIED.,.F.,.F.,(4,0),(0.,1.),.UNSPECIFIED.",
		"1,(#2,#3,#4,#5),.UNSPECIFIED.,.F.,.F.,(2,2,2),(0.,1.,2.),"
		".UNSPECIFIED.",
		"1,(#2,#99),.UNSPECIFIED.,.F.,.F.,(2,2),(0.,1.),.UNSPECIFIED.",
		"1,$,.UNSPECIFIED.,.F.,.F.,(2,2),(0.,1.),.UNSPECIFIED.",
	};

	for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
		char data[4096];

		snprintf(data, sizeof data,
			"%s#20=IFCBSPLINECURVEWITHKNOTS(%s);"
			"#100=IFCARBITRARYCLOSEDPROFILEDEF(.AREA.,$,#20);",
			PLACES, all[i]);
		CHECK(area_of(data, 1e-3) < 0);
	}
	CHECK(area_of(PLACES "#20=IFCRATIONALBEZIERCURVE(2,(#2,#3,#4),"
			     ".UNSPECIFIED.,.F.,.F.,(1.,0.,1.));"
			     "#100=IFCARBITRARYCLOSEDPROFILEDEF(.AREA.,$,#20);",
		      1e-3) < 0);
	CHECK(area_of(PLACES "#20=IFCOFFSETCURVE2D(#20,1.,.F.);"
			     "#100=IFCARBITRARYCLOSEDPROFILEDEF(.AREA.,$,#20);",
		      1e-3) < 0);
}

static const struct check_test tests[] = {
	CHECK_TEST(a_rational_circle_is_one_at_every_deflection),
	CHECK_TEST(a_bezier_curve_needs_no_knots),
	CHECK_TEST(splines_are_trimmed_by_parameters_and_points),
	CHECK_TEST(offsets_lie_beside_their_curves),
	CHECK_TEST(strips_are_as_large_as_long_and_thick),
	CHECK_TEST(splines_that_are_none_are_refused),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
