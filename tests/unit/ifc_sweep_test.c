/* Swept, tapered and primitive solids against volumes computed by hand. */
#include "ifc_shape_sample.h"
#include "parsers/ifc_sweep_curve.h"

#define PLACES \
	"#1=IFCCARTESIANPOINT((0.,0.,0.));#2=IFCCARTESIANPOINT((4.,0.,0.));" \
	"#3=IFCCARTESIANPOINT((4.,4.,0.));#4=IFCCARTESIANPOINT((4.,4.,4.));" \
	"#5=IFCAXIS2PLACEMENT3D(#1,$,$);#6=IFCCIRCLE(#5,4.);" \
	"#7=IFCPOLYLINE((#1,#2,#3,#4));#8=IFCDIRECTION((0.,0.,1.));" \
	"#9=IFCRECTANGLEPROFILEDEF(.AREA.,$,$,1.,2.);" \
	"#10=IFCPOLYLINE((#1,#2,#3));#11=IFCPLANE(#5);" \
	"#12=IFCCARTESIANPOINT((0.,4.,0.));#13=IFCPOLYLINE((#1,#2,#3,#12,#1));" \
	"#14=IFCDIRECTION((1.,1.,0.));#15=IFCAXIS2PLACEMENT3D(#3,#14,$);" \
	"#16=IFCTRIMMEDCURVE(#6,(IFCPARAMETERVALUE(0.)),(IFCPARAMETERVALUE(" \
	"1.5707963267948966)),.T.,.PARAMETER.);"

/* The volume of a closed solid; -1 when it is refused. */
static double
volume_of(sample_evaluator *evaluate, const char *data, double deflection)
{
	char text[8192];
	struct ifc_faces faces;
	struct solid_measure measure = {.volume = -1};

	snprintf(text, sizeof text, "%s%s", PLACES, data);
	if (sample_shape("IFC4", text, deflection, evaluate, &faces)) {
		measure = sample_measure(&faces);
		CHECK(measure.closed);
	}
	ifc_faces_release(&faces);
	return measure.volume;
}

/* The area of a disk's section: with 256 chords in a quarter. */
static double
disk(double radius)
{
	double turn = SAMPLE_PI / 512;

	return 512 * radius * radius * sin(turn);
}

static void
primitives_have_their_volumes(void)
{
	CHECK(is_near(
		volume_of(ifc_primitive, "#100=IFCBLOCK(#15,1.,2.,3.);", 1), 6,
		1e-12));
	CHECK(is_near(volume_of(ifc_primitive,
			      "#100=IFCRECTANGULARPYRAMID(#15,1.,2.,3.);", 1),
		2, 1e-12));
	CHECK(is_near(
		volume_of(ifc_primitive,
			"#100=IFCRIGHTCIRCULARCYLINDER(#15,3.,2.);", 1e-9),
		disk(2) * 3, 1e-9));
	CHECK(is_near(volume_of(ifc_primitive,
			      "#100=IFCRIGHTCIRCULARCONE(#15,3.,2.);", 1e-9),
		disk(2), 1e-9));
}

static void
a_sphere_comes_near_at_every_deflection(void)
{
	for (double deflection = 0.1; deflection > 1e-4; deflection /= 10) {
		double volume = volume_of(
			ifc_primitive, "#100=IFCSPHERE(#15,2.);", deflection);
		double ball = 4 * SAMPLE_PI * 8 / 3;

		CHECK(volume < ball);
		CHECK(is_near(
			volume, ball, 4 * SAMPLE_PI * 4 * 2 * deflection));
	}
}

/* A mitre takes from one side of a bend what it adds at the other. */
static void
swept_disks_are_as_long_as_their_paths(void)
{
	CHECK(is_near(volume_of(ifc_swept_disk,
			      "#100=IFCSWEPTDISKSOLID(#7,0.5,$,$,$);", 1e-9),
		disk(0.5) * 12, 1e-9));
	CHECK(is_near(
		volume_of(ifc_swept_disk,
			"#100=IFCSWEPTDISKSOLID(#7,0.5,0.25,0.5,2.5);", 1e-9),
		(disk(0.5) - disk(0.25)) * 8, 1e-9));
	CHECK(is_near(volume_of(ifc_swept_disk,
			      "#100=IFCSWEPTDISKSOLID(#7,0.5,$,"
			      "IFCLENGTHMEASURE(1.),IFCLENGTHMEASURE(9.));",
			      1e-9),
		disk(0.5) * 8, 1e-9));
	CHECK(is_near(volume_of(ifc_swept_disk,
			      "#100=IFCSWEPTDISKSOLID(#13,0.5,$,$,$);", 1e-9),
		disk(0.5) * 16, 1e-9));
	CHECK(is_near(
		volume_of(ifc_swept_disk,
			"#100=IFCSWEPTDISKSOLIDPOLYGONAL(#10,0.5,$,$,$,1.);",
			1e-6),
		SAMPLE_PI / 4 * (6 + SAMPLE_PI / 2), 1e-3));
}

static void
a_torus_comes_near_at_every_deflection(void)
{
	double whole = 2 * SAMPLE_PI * 4 * SAMPLE_PI / 4;

	for (double deflection = 1e-2; deflection > 1e-5; deflection /= 10) {
		double volume = volume_of(ifc_swept_disk,
			"#100=IFCSWEPTDISKSOLID(#6,0.5,$,$,$);", deflection);

		CHECK(is_near(volume, whole, 200 * deflection));
	}
}

static void
areas_are_swept_along_curves(void)
{
	static const char *const straight[] = {
		"#100=IFCFIXEDREFERENCESWEPTAREASOLID(#9,#15,#10,$,$,#8);",
		"#100=IFCSURFACECURVESWEPTAREASOLID(#9,#15,#10,$,$,#11);",
		"#100=IFCSURFACECURVESWEPTAREASOLID(#9,$,#10,0.,2.,#11);",
		"#100=IFCFIXEDREFERENCESWEPTAREASOLID(#9,#5,#13,0.,2.,#8);",
	};

	for (size_t i = 0; i < sizeof straight / sizeof *straight; i++)
		CHECK(is_near(
			volume_of(ifc_swept_area, straight[i], 1), 16, 1e-9));
	CHECK(is_near(volume_of(ifc_swept_area,
			      "#100=IFCSURFACECURVESWEPTAREASOLID(#9,$,#16,$,$,"
			      "#11);",
			      1e-6),
		2 * 4 * SAMPLE_PI / 2, 1e-3));
}

static void
tapered_solids_have_their_volumes(void)
{
	CHECK(is_near(volume_of(ifc_tapered,
			      "#20=IFCRECTANGLEPROFILEDEF(.AREA.,$,$,2.,4.);"
			      "#100=IFCEXTRUDEDAREASOLIDTAPERED(#9,#5,#8,3.,"
			      "#20);",
			      1),
		3. / 3 * (2 + 8 + 4), 1e-12));
	CHECK(is_near(volume_of(ifc_tapered,
			      "#20=IFCCIRCLEPROFILEDEF(.AREA.,$,$,1.);"
			      "#21=IFCCIRCLEPROFILEDEF(.AREA.,$,$,2.);"
			      "#100=IFCEXTRUDEDAREASOLIDTAPERED(#20,$,#8,3.,"
			      "#21);",
			      1e-4),
		SAMPLE_PI * (1 + 2 + 4), 1e-2));
	CHECK(is_near(volume_of(ifc_tapered,
			      "#20=IFCRECTANGLEPROFILEDEF(.AREA.,$,$,1.,2.);"
			      "#21=IFCCARTESIANPOINT((5.,0.,0.));"
			      "#22=IFCDIRECTION((0.,1.,0.));"
			      "#23=IFCAXIS1PLACEMENT(#21,#22);"
			      "#100=IFCREVOLVEDAREASOLIDTAPERED(#9,$,#23,"
			      "1.5707963267948966,#20);",
			      1e-6),
		2 * 5 * SAMPLE_PI / 2, 1e-3));
}

static void
what_is_no_solid_is_refused(void)
{
	static const struct {
		sample_evaluator *evaluate;
		const char *data;
	} all[] = {
		{ifc_primitive, "#100=IFCBLOCK(#5,1.,0.,3.);"},
		{ifc_primitive, "#100=IFCSPHERE(#1,1.);"},
		{ifc_primitive, "#100=IFCSPHERE(#5,-1.);"},
		{ifc_primitive, "#100=IFCWALL();"},
		{ifc_swept_disk, "#100=IFCSWEPTDISKSOLID(#7,0.,$,$,$);"},
		{ifc_swept_disk, "#100=IFCSWEPTDISKSOLID(#7,1.,1.,$,$);"},
		{ifc_swept_disk, "#100=IFCSWEPTDISKSOLID(#7,1.,$,1.,1.);"},
		{ifc_swept_disk, "#100=IFCSWEPTDISKSOLID(#9,1.,$,$,$);"},
		{ifc_swept_disk,
			"#100=IFCSWEPTDISKSOLID(#20,1.,$,$,$);"
			"#20=IFCPOLYLINE((#1,#1));"},
		{ifc_swept_area,
			"#100=IFCFIXEDREFERENCESWEPTAREASOLID(#9,$,#7,$,$,#8);"},
		{ifc_swept_area,
			"#100=IFCSURFACECURVESWEPTAREASOLID(#9,$,#10,$,$,#9);"},
		{ifc_swept_area,
			"#100=IFCSURFACECURVESWEPTAREASOLID(#9,#1,#10,$,$,"
			"#11);"},
		{ifc_tapered,
			"#100=IFCEXTRUDEDAREASOLIDTAPERED(#9,$,#8,0.,#9);"},
		{ifc_tapered,
			"#100=IFCEXTRUDEDAREASOLIDTAPERED(#9,$,#8,1.,#8);"},
		{ifc_tapered,
			"#20=IFCCIRCLEHOLLOWPROFILEDEF(.AREA.,$,$,1.,0.5);"
			"#100=IFCEXTRUDEDAREASOLIDTAPERED(#9,$,#8,1.,#20);"},
	};

	for (size_t i = 0; i < sizeof all / sizeof *all; i++)
		CHECK(volume_of(all[i].evaluate, all[i].data, 1e-3) == -1);
}

static const struct check_test tests[] = {
	CHECK_TEST(primitives_have_their_volumes),
	CHECK_TEST(a_sphere_comes_near_at_every_deflection),
	CHECK_TEST(swept_disks_are_as_long_as_their_paths),
	CHECK_TEST(a_torus_comes_near_at_every_deflection),
	CHECK_TEST(areas_are_swept_along_curves),
	CHECK_TEST(tapered_solids_have_their_volumes),
	CHECK_TEST(what_is_no_solid_is_refused),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
