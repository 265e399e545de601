/* Alignments, places along them and sections on them, computed by hand. */
#include "ifc_shape_sample.h"
#include "parsers/ifc_alignment.h"
#include "parsers/ifc_sweep_curve.h"

/* 100 straight, 100 of a clothoid, and a circle of its last radius, 100. */
#define PLAN \
	"#1=IFCCARTESIANPOINT((0.,0.));#2=IFCCARTESIANPOINT((100.,0.));" \
	"#3=IFCDIRECTION((1.,0.));#4=IFCVECTOR(#3,1.);#5=IFCLINE(#1,#4);" \
	"#6=IFCAXIS2PLACEMENT2D(#1,$);#7=IFCAXIS2PLACEMENT2D(#2,$);" \
	"#8=IFCCLOTHOID(#6,100.);#9=IFCCIRCLE(#6,100.);" \
	"#10=IFCCURVESEGMENT(.CONTINUOUS.,#6,IFCLENGTHMEASURE(0.)," \
	"IFCLENGTHMEASURE(100.),#5);" \
	"#11=IFCCURVESEGMENT(.CONTINUOUS.,#7,IFCLENGTHMEASURE(0.)," \
	"IFCLENGTHMEASURE(100.),#8);" \
	"#12=IFCCOMPOSITECURVE((#10,#11),.F.);"

static struct ifc_mark
mark_of(const char *data, unsigned curve, double along)
{
	struct ifc_alignment marks = {.count = 0};
	struct ifc_mark out = {.along = -1};
	struct sample sample;
	struct ifc_shaper shaper;
	char text[8192];

	snprintf(text, sizeof text, "%s%s", PLAN, data);
	CHECK(!sample_open(&sample, "IFC4X3", text));
	shaper = sample_shaper(&sample, 1e-4);
	if (!ifc_alignment_read(&shaper, instance(&sample, curve), &marks))
		out = ifc_alignment_at(&marks, along);
	CHECK(shaper.depth == 0 || out.along == -1);
	array_release(&marks);
	sample_close(&sample);
	return out;
}

static void
a_clothoid_follows_its_series(void)
{
	struct ifc_mark end = mark_of("", 12, 200);

	/* Its angle is half a radian; Fresnel's series in that. */
	CHECK(is_near(end.at.x,
		200 -
			100 *
				(0.25 / 10 - 0.0625 / 216 + 0.015625 / 9360 -
					0.00390625 / 685440),
		1e-7));
	CHECK(is_near(end.at.y,
		100 *
			(0.5 / 3 - 0.125 / 42 + 0.03125 / 1320 -
				0.0078125 / 75600),
		1e-6));
	CHECK(is_near(end.x, cos(0.5), 1e-9));
	CHECK(is_near(end.y, sin(0.5), 1e-9));
	CHECK(is_near(mark_of("", 12, 50).at.x, 50, 1e-12));
	CHECK(is_near(mark_of("", 12, -5).at.x, -5, 1e-12));
}

static void
circles_turn_right_with_a_negative_length(void)
{
	struct ifc_mark end = mark_of(
		"#20=IFCCURVESEGMENT(.CONTINUOUS.,#6,IFCLENGTHMEASURE(0.),"
		"IFCLENGTHMEASURE(-157.07963267948966),#9);"
		"#21=IFCCOMPOSITECURVE((#20),.F.);",
		21, 50 * SAMPLE_PI);

	CHECK(is_near(end.at.x, 100, 1e-9) && is_near(end.at.y, -100, 1e-9));
	CHECK(is_near(end.x, 0, 1e-9) && is_near(end.y, -1, 1e-9));
}

#define GRADIENT \
	"#30=IFCDIRECTION((0.6,0.8));#31=IFCCARTESIANPOINT((60.,80.));" \
	"#32=IFCAXIS2PLACEMENT2D(#1,#30);#33=IFCAXIS2PLACEMENT2D(#31,$);" \
	"#34=IFCCURVESEGMENT(.CONTINUOUS.,#32,IFCLENGTHMEASURE(0.)," \
	"IFCLENGTHMEASURE(100.),#5);" \
	"#35=IFCCURVESEGMENT(.CONTINUOUS.,#33,IFCLENGTHMEASURE(0.)," \
	"IFCLENGTHMEASURE(140.),#5);" \
	"#36=IFCGRADIENTCURVE((#34,#35),.F.,#12,$);"

static void
heights_are_added_to_the_plan(void)
{
	struct ifc_mark low = mark_of(GRADIENT, 36, 30);
	struct ifc_mark high = mark_of(GRADIENT, 36, 150);

	CHECK(is_near(low.at.x, 30, 1e-9) && is_near(low.at.z, 40, 1e-9));
	CHECK(is_near(low.slope, 0.8 / 0.6, 1e-9));
	CHECK(is_near(high.at.z, 80, 1e-9) && is_near(high.slope, 0, 1e-9));
	CHECK(high.at.y > 1);
}

static void
cant_rolls_and_lifts(void)
{
	struct ifc_mark half = mark_of(
		"#20=IFCCARTESIANPOINT((0.,0.,0.));"
		"#21=IFCCARTESIANPOINT((100.,2.,0.));"
		"#22=IFCDIRECTION((0.,0.5,0.8660254037844386));"
		"#23=IFCAXIS2PLACEMENT3D(#20,$,$);"
		"#24=IFCAXIS2PLACEMENT3D(#21,#22,#25);"
		"#25=IFCDIRECTION((1.,0.,0.));"
		"#26=IFCCURVESEGMENT(.CONTINUOUS.,#23,IFCLENGTHMEASURE(0.),"
		"IFCLENGTHMEASURE(100.),#5);"
		"#27=IFCCURVESEGMENT(.CONTINUOUS.,#24,IFCLENGTHMEASURE(0.),"
		"IFCLENGTHMEASURE(0.),#5);"
		"#28=IFCSEGMENTEDREFERENCECURVE((#26,#27),.F.,#12,$);",
		28, 50);

	CHECK(is_near(half.at.z, 1, 1e-9));
	CHECK(is_near(half.roll, SAMPLE_PI / 12, 1e-9));
}

static void
offsets_go_evenly_from_one_to_the_next(void)
{
	struct ifc_mark mark = mark_of(
		"#20=IFCPOINTBYDISTANCEEXPRESSION(IFCLENGTHMEASURE(0.),0.,0.,"
		"$,#12);"
		"#21=IFCPOINTBYDISTANCEEXPRESSION(IFCLENGTHMEASURE(100.),-4.,"
		"8.,$,#12);"
		"#22=IFCOFFSETCURVEBYDISTANCES(#12,(#20,#21),$);",
		22, 25);

	CHECK(is_near(mark.at.x, 25, 1e-9) && is_near(mark.at.y, -1, 1e-9));
	CHECK(is_near(mark.at.z, 2, 1e-9));
}

static void
places_lie_beside_their_curve(void)
{
	struct ifc_placements placements = {.count = 0};
	const struct ifc_placement *found;
	struct sample sample;

	CHECK(!sample_open(&sample, "IFC4X3",
		PLAN GRADIENT
		"#40=IFCPOINTBYDISTANCEEXPRESSION(IFCLENGTHMEASURE(30.),2.,3.,"
		"$,#36);#41=IFCAXIS2PLACEMENTLINEAR(#40,$,$);"
		"#42=IFCCARTESIANPOINT((1000.,0.,0.));"
		"#43=IFCAXIS2PLACEMENT3D(#42,$,$);"
		"#44=IFCLOCALPLACEMENT($,#43);"
		"#45=IFCLINEARPLACEMENT(#44,#41,$);"
		"#46=IFCLINEARPLACEMENT(#44,#41,#43);"));
	CHECK(!ifc_placements_read(
		&sample.file, &placements, &sample.report, &sample.fault));
	found = ifc_placement_find(&placements, instance(&sample, 45));
	CHECK(found && found->known);
	if (found) {
		/* Up is square to the slope of 4 to 3. */
		CHECK(is_near(found->world.at[3], 1030 - 3 * 0.8, 1e-9));
		CHECK(is_near(found->world.at[7], 2, 1e-9));
		CHECK(is_near(found->world.at[11], 40 + 3 * 0.6, 1e-9));
		CHECK(is_near(found->world.at[0], 0.6, 1e-9));
		CHECK(is_near(found->world.at[8], 0.8, 1e-9));
	}
	found = ifc_placement_find(&placements, instance(&sample, 46));
	CHECK(found && found->known && found->world.at[3] == 1000);
	array_release(&placements);
	sample_close(&sample);
}

static double
volume_of(const char *data)
{
	char text[8192];
	struct ifc_faces faces;
	struct solid_measure measure = {.volume = -1};

	snprintf(text, sizeof text, "%s%s", PLAN, data);
	if (sample_shape("IFC4X3", text, 1e-3, ifc_sectioned, &faces)) {
		measure = sample_measure(&faces);
		CHECK(measure.closed);
	}
	ifc_faces_release(&faces);
	return measure.volume;
}

#define SECTIONS \
	"#50=IFCRECTANGLEPROFILEDEF(.AREA.,$,$,2.,1.);" \
	"#51=IFCRECTANGLEPROFILEDEF(.AREA.,$,$,4.,2.);" \
	"#52=IFCPOINTBYDISTANCEEXPRESSION(IFCLENGTHMEASURE(10.),$,$,$,#12);" \
	"#53=IFCPOINTBYDISTANCEEXPRESSION(IFCLENGTHMEASURE(40.),$,$,$,#12);" \
	"#54=IFCPOINTBYDISTANCEEXPRESSION(IFCLENGTHMEASURE(190.),$,$,$,#12);" \
	"#55=IFCAXIS2PLACEMENTLINEAR(#52,$,$);" \
	"#56=IFCAXIS2PLACEMENTLINEAR(#53,$,$);" \
	"#57=IFCAXIS2PLACEMENTLINEAR(#54,$,$);"

static void
sections_stand_on_their_curve(void)
{
	CHECK(is_near(volume_of(SECTIONS
			      "#100=IFCSECTIONEDSOLIDHORIZONTAL(#12,(#50,#51),"
			      "(#55,#56));"),
		30. / 3 * (2 + 4 + 8), 1e-9));
	CHECK(is_near(volume_of(SECTIONS
			      "#100=IFCSECTIONEDSOLIDHORIZONTAL(#12,(#50,#50,"
			      "#50),(#55,#56,#57));"),
		2 * 180, 2e-2));
	CHECK(is_near(volume_of("#60=IFCCARTESIANPOINT((0.,0.,0.));"
				"#61=IFCCARTESIANPOINT((0.,0.,6.));"
				"#62=IFCAXIS2PLACEMENT3D(#60,$,$);"
				"#63=IFCAXIS2PLACEMENT3D(#61,$,$);"
				"#64=IFCCIRCLEPROFILEDEF(.AREA.,$,$,1.);"
				"#65=IFCCIRCLEPROFILEDEF(.AREA.,$,$,2.);"
				"#100=IFCSECTIONEDSPINE(#12,(#64,#65),(#62,"
				"#63));"),
		SAMPLE_PI * 2 * (1 + 2 + 4), 2e-1));
}

/* The same plan as IFC4X1 tells it, with a last segment of its own. */
#define PLAN_4X1(segment) \
	"#20=IFCALIGNMENTCURVE(#21,$,$);" \
	"#21=IFCALIGNMENT2DHORIZONTAL($,(#22,#23));" \
	"#22=IFCALIGNMENT2DHORIZONTALSEGMENT(.T.,$,$,#24);" \
	"#23=IFCALIGNMENT2DHORIZONTALSEGMENT(.T.,$,$,#25);" \
	"#24=IFCLINESEGMENT2D(#1,0.,100.);#25=" segment ";"

#define TRANSITION(kind) \
	"IFCTRANSITIONCURVESEGMENT2D(#2,0.,100.,$,100.,.T.,.T.,." kind ".)"

static void
plans_of_4x1_are_read(void)
{
	static const char *const kinds[] = {
		PLAN_4X1(TRANSITION("CLOTHOIDCURVE")),
		PLAN_4X1(TRANSITION("BLOSSCURVE")),
		PLAN_4X1(TRANSITION("COSINECURVE")),
		PLAN_4X1(TRANSITION("SINECURVE"))};
	struct ifc_mark same = mark_of("", 12, 170);
	struct ifc_mark clothoid = mark_of(kinds[0], 20, 170);
	struct ifc_mark right = mark_of(
		PLAN_4X1("IFCCIRCULARARCSEGMENT2D(#2,0.,157.07963267948966,"
			 "100.,.F.)"),
		20, 100 + 50 * SAMPLE_PI);

	CHECK(is_near(clothoid.at.x, same.at.x, 1e-9) &&
		is_near(clothoid.at.y, same.at.y, 1e-9));
	CHECK(is_near(right.at.x, 200, 1e-6) &&
		is_near(right.at.y, -100, 1e-6) && is_near(right.y, -1, 1e-9));
	/* In the mean each bends half as much as at its end. */
	for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
		CHECK(is_near(mark_of(kinds[i], 20, 200).y, sin(0.5), 1e-9));
	CHECK(mark_of(PLAN_4X1(TRANSITION("CUBICPARABOLA")), 20, 0).along ==
		-1);
}

/* A rise of a tenth, then a curve of its own, on a straight plan. */
#define RISE(curve) \
	PLAN_4X1("IFCLINESEGMENT2D(#2,0.,100.)") \
	"#30=IFCALIGNMENTCURVE(#21,#31,$);" \
	"#31=IFCALIGNMENT2DVERTICAL((#32,#33));" \
	"#32=IFCALIGNMENT2DVERSEGLINE(.T.,$,$,0.,100.,5.,0.1);" \
	"#33=IFCALIGNMENT2DVERSEG" curve ";"

static void
rises_of_4x1_are_read(void)
{
	struct ifc_mark sag = mark_of(
		RISE("PARABOLICARC(.T.,$,$,100.,100.,15.,0.1,1000.,.F.)"), 30,
		200);
	struct ifc_mark crest = mark_of(
		RISE("PARABOLICARC(.T.,$,$,100.,100.,15.,0.1,1000.,.T.)"), 30,
		200);
	struct ifc_mark top = mark_of(
		RISE("CIRCULARARC(.T.,$,$,100.,60.,15.,0.,100.,.T.)"), 30, 160);
	struct ifc_mark valley = mark_of(
		RISE("CIRCULARARC(.T.,$,$,100.,60.,15.,0.,100.,.F.)"), 30, 160);

	CHECK(is_near(sag.at.z, 30, 1e-9) && is_near(sag.slope, 0.2, 1e-9));
	CHECK(is_near(crest.at.z, 20, 1e-9) && is_near(crest.slope, 0, 1e-9));
	CHECK(is_near(top.at.z, 15 - 20, 1e-9) &&
		is_near(top.slope, -0.75, 1e-9));
	CHECK(is_near(valley.at.z, 15 + 20, 1e-9));
	CHECK(is_near(
		mark_of(RISE("LINE(.T.,$,$,100.,9.,15.,0.)"), 30, 50).at.z, 10,
		1e-9));
	CHECK(mark_of(RISE("CIRCULARARC(.T.,$,$,100.,60.,15.,0.,50.,.T.)"), 30,
		      0)
			.along == -1);
	CHECK(mark_of(RISE("LINE(.T.,$,$,100.,0.,15.,0.)"), 30, 0).along == -1);
}

/* Upright sections fill their area over the plan, whatever it rises by. */
static void
sections_of_4x1_stand_at_distances(void)
{
	const char *data = RISE(
		"LINE(.T.,$,$,100.,100.,15.,0.1)") "#50=IFCRECTANGLEPROFILEDEF(.AREA.,$,$,2.,1.);"
						   "#51=IFCDISTANCEEXPRESSION(10.,3.,-1.,$,.T.);"
						   "#52=IFCDISTANCEEXPRESSION(60.,3.,-1.,$,.T.);"
						   "#100=IFCSECTIONEDSOLIDHORIZONTAL(#30,(#50,#50),(#51,#52),"
						   ".T.);";

	CHECK(is_near(volume_of(data), 2 * 50, 1e-9));
}

static void
what_leads_nowhere_is_refused(void)
{
	static const char *const all[] = {
		"#100=IFCSECTIONEDSOLIDHORIZONTAL(#12,(#50),(#55));",
		"#100=IFCSECTIONEDSOLIDHORIZONTAL(#12,(#50,#50),(#55));",
		"#100=IFCSECTIONEDSOLIDHORIZONTAL(#12,(#50,#50),(#56,#55));",
		"#100=IFCSECTIONEDSOLIDHORIZONTAL(#12,(#50,#12),(#55,#56));",
		"#100=IFCSECTIONEDSOLIDHORIZONTAL(#100,(#50,#50),(#55,#56));",
		"#100=IFCSECTIONEDSOLIDHORIZONTAL();",
	};

	for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
		char data[4096];

		snprintf(data, sizeof data, "%s%s", SECTIONS, all[i]);
		CHECK(volume_of(data) == -1);
	}
	CHECK(mark_of("#20=IFCGRADIENTCURVE((#10),.F.,#20,$);", 20, 0).along ==
		-1);
	CHECK(mark_of("#20=IFCGRADIENTCURVE((),.F.,#12,$);", 20, 0).along ==
		-1);
	CHECK(mark_of("#20=IFCOFFSETCURVEBYDISTANCES(#12,(#20),$);", 20, 0)
			.along == -1);
	CHECK(mark_of("#20=IFCCOMPOSITECURVE((#21),.F.);"
		      "#21=IFCCURVESEGMENT(.CONTINUOUS.,#6,$,$,#5);",
		      20, 0)
			.along == -1);
}

static const struct check_test tests[] = {
	CHECK_TEST(a_clothoid_follows_its_series),
	CHECK_TEST(circles_turn_right_with_a_negative_length),
	CHECK_TEST(heights_are_added_to_the_plan),
	CHECK_TEST(cant_rolls_and_lifts),
	CHECK_TEST(offsets_go_evenly_from_one_to_the_next),
	CHECK_TEST(places_lie_beside_their_curve),
	CHECK_TEST(sections_stand_on_their_curve),
	CHECK_TEST(plans_of_4x1_are_read),
	CHECK_TEST(rises_of_4x1_are_read),
	CHECK_TEST(sections_of_4x1_stand_at_distances),
	CHECK_TEST(what_leads_nowhere_is_refused),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
