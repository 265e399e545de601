/* Representation items against volumes computed by hand. */
#include <math.h>

#include "check.h"
#include "ifc_sample.h"
#include "parsers/ifc_item.h"

#define PLACES \
	"#1=IFCCARTESIANPOINT((0.,0.,0.));#2=IFCDIRECTION((0.,0.,1.));" \
	"#3=IFCAXIS2PLACEMENT3D(#1,$,$);#4=IFCDIRECTION((1.,0.,0.));" \
	"#5=IFCDIRECTION((0.,1.,0.));#6=IFCCARTESIANPOINT((10.,0.,0.));" \
	"#7=IFCDIRECTION((0.,0.6,0.8));#8=IFCDIRECTION((0.,0.,-2.));" \
	"#9=IFCAXIS1PLACEMENT(#6,#5);" \
	"#10=IFCRECTANGLEPROFILEDEF(.AREA.,$,$,4.,2.);" \
	"#11=IFCCIRCLEPROFILEDEF(.AREA.,$,$,2.);" \
	"#12=IFCRECTANGLEHOLLOWPROFILEDEF(.AREA.,$,$,4.,2.,0.5,$,$);" \
	"#20=IFCEXTRUDEDAREASOLID(#10,$,#2,3.);"

struct result {
	double volume;
	size_t faces, parts;
	enum ifc_part_kind kind; /* of the first part */
	enum ifc_outcome outcome;
};

/* What item #100 becomes. */
static struct result
result_of(const char *data, double deflection)
{
	struct ifc_body body = {.faces = {.points = {.count = 0}}};
	struct result result = {.volume = 0};
	struct tcs_fault fault;
	struct sample sample;
	struct ifc_shaper shaper;
	char text[8192];

	snprintf(text, sizeof text, "%s%s", PLACES, data);
	CHECK(!sample_open(&sample, "IFC4", text));
	shaper = (struct ifc_shaper){.file = &sample.file,
		.unit = 1,
		.angle = 1,
		.deflection = deflection,
		.precision = 1e-9};
	CHECK(!ifc_scratch_new(&shaper.scratch, &fault));
	result.outcome = ifc_item_body(&shaper, instance(&sample, 100), &body);
	if (!result.outcome) {
		CHECK(shaper.depth == 0);
		result.volume = ifc_faces_volume6(&body.faces, 0) / 6;
		result.faces = body.faces.faces.count;
		result.parts = body.parts.count;
		if (body.parts.count)
			result.kind = body.parts.at[0].kind;
	}
	ifc_body_release(&body);
	ifc_scratch_free(shaper.scratch);
	sample_close(&sample);
	return result;
}

static bool
near(double a, double b, double by)
{
	return fabs(a - b) <= by;
}

static void
extrusions_have_base_times_height(void)
{
	static const struct {
		const char *data;
		double volume;
		size_t faces;
	} all[] = {
		{"#100=IFCEXTRUDEDAREASOLID(#10,$,#2,3.);", 24, 6},
		{"#100=IFCEXTRUDEDAREASOLID(#10,#3,#2,3.);", 24, 6},
		/* Slanted: the height is along z only. */
		{"#100=IFCEXTRUDEDAREASOLID(#10,#3,#7,5.);", 32, 6},
		/* Downwards, and backwards. */
		{"#100=IFCEXTRUDEDAREASOLID(#10,#3,#8,3.);", 24, 6},
		{"#100=IFCEXTRUDEDAREASOLID(#10,#3,#2,-3.);", 24, 6},
		{"#100=IFCEXTRUDEDAREASOLID(#12,#3,#2,3.);", 15, 10},
	};

	for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
		struct result result = result_of(all[i].data, 1e-3);

		CHECK(near(result.volume, all[i].volume, 1e-12));
		CHECK(result.faces == all[i].faces);
		CHECK(result.kind == IFC_PART_SOLID);
	}
}

static void
extrusions_of_nothing_are_refused(void)
{
	static const char *const all[] = {
		"#100=IFCEXTRUDEDAREASOLID(#10,#3,#2,0.);",
		"#100=IFCEXTRUDEDAREASOLID(#10,#3,#4,1.);",
		"#100=IFCEXTRUDEDAREASOLID(#10,#3,$,1.);",
		"#100=IFCEXTRUDEDAREASOLID(#10,#1,#2,1.);",
		"#100=IFCEXTRUDEDAREASOLID(#100,#3,#2,1.);",
		"#100=IFCREVOLVEDAREASOLID(#10,#3,#9,0.);",
		"#100=IFCREVOLVEDAREASOLID(#10,#3,$,1.);",
		"#100=IFCWALL();",
	};

	for (size_t i = 0; i < sizeof all / sizeof *all; i++)
		CHECK(result_of(all[i], 1e-3).outcome == IFC_REFUSED);
}

/* Pappus: the area times the way of its centre, 10 from the axis. */
static void
revolutions_come_nearer_with_the_deflection(void)
{
	static const struct {
		const char *data;
		double volume;
	} all[] = {
		{"#100=IFCREVOLVEDAREASOLID(#10,#3,#9,6.283185307179586);",
			8 * 10 * 2 * 3.14159265358979},
		{"#100=IFCREVOLVEDAREASOLID(#10,#3,#9,1.);", 8 * 10},
		{"#100=IFCREVOLVEDAREASOLID(#10,#3,#9,-1.);", 8 * 10},
		{"#100=IFCREVOLVEDAREASOLID(#11,#3,#9,1.);",
			4 * 3.14159265358979 * 10},
	};

	for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
		double coarse = result_of(all[i].data, 0.1).volume;
		double fine = result_of(all[i].data, 1e-3).volume;

		CHECK(coarse < fine && fine < all[i].volume);
		CHECK(near(fine, all[i].volume, 1e-3 * all[i].volume));
	}
}

#define TETRAHEDRON(outer) \
	"#30=IFCCLOSEDSHELL((#31,#32,#33,#34));" \
	"#31=IFCFACE((#41));#41=" outer "(#51,.T.);" \
	"#51=IFCPOLYLOOP((#61,#63,#62));" \
	"#32=IFCFACE((#42));#42=" outer "(#52,.T.);" \
	"#52=IFCPOLYLOOP((#61,#62,#64));" \
	"#33=IFCFACE((#43));#43=" outer "(#53,.F.);" \
	"#53=IFCPOLYLOOP((#61,#63,#64));" \
	"#34=IFCFACE((#44));#44=" outer "(#54,.T.);" \
	"#54=IFCPOLYLOOP((#62,#63,#64));" \
	"#61=IFCCARTESIANPOINT((0.,0.,0.));" \
	"#62=IFCCARTESIANPOINT((6.,0.,0.));" \
	"#63=IFCCARTESIANPOINT((0.,6.,0.));" \
	"#64=IFCCARTESIANPOINT((0.,0.,6.));"

static void
shells_look_outwards_however_they_are_given(void)
{
	CHECK(near(
		result_of(
			TETRAHEDRON(
				"IFCFACEOUTERBOUND") "#100=IFCFACETEDBREP(#30);",
			1)
			.volume,
		36, 1e-12));
	CHECK(near(
		result_of(
			TETRAHEDRON("IFCFACEBOUND") "#100=IFCFACETEDBREP(#30);",
			1)
			.volume,
		36, 1e-12));
	CHECK(near(result_of("#100=IFCTRIANGULATEDFACESET(#30,$,.T.,((1,2,3),"
			     "(1,4,2),(1,3,4),(2,4,3)),$);"
			     "#30=IFCCARTESIANPOINTLIST3D(((0.,0.,0.),"
			     "(6.,0.,0.),(0.,6.,0.),(0.,0.,6.)));",
			   1)
			   .volume,
		36, 1e-12));
	CHECK(result_of(
		      TETRAHEDRON(
			      "IFCFACEBOUND") "#100=IFCFACEBASEDSURFACEMODEL((#30));",
		      1)
			.kind == IFC_PART_SURFACE);
}

static void
voids_are_taken_away(void)
{
	struct result result = result_of(
		TETRAHEDRON(
			"IFCFACEBOUND") "#100=IFCFACETEDBREPWITHVOIDS(#30,(#30));",
		1);

	CHECK(near(result.volume, 0, 1e-12));
	CHECK(result.parts == 2);
}

static void
maps_scale_and_mirror(void)
{
	static const char map[] =
		"#100=IFCMAPPEDITEM(#101,#102);"
		"#101=IFCREPRESENTATIONMAP(#3,#103);"
		"#103=IFCSHAPEREPRESENTATION($,'Body','',(#20));"
		"#102=IFCCARTESIANTRANSFORMATIONOPERATOR3D"
		"NONUNIFORM(#4,#106,#1,2.,#2,1.,1.5);"
		"#106=IFCDIRECTION((0.,-1.,0.));";

	CHECK(near(result_of(map, 1).volume, 24 * 3, 1e-12));
	CHECK(result_of("#100=IFCMAPPEDITEM(#101,#102);"
			"#101=IFCREPRESENTATIONMAP(#3,#103);"
			"#103=IFCSHAPEREPRESENTATION($,'Body','',(#100));"
			"#102=IFCCARTESIANTRANSFORMATIONOPERATOR3D("
			"$,$,#1,$,$);",
		      1)
			.outcome == IFC_REFUSED);
}

/* The box is 4 by 2 by 3 about the origin, upwards. */
static void
booleans_have_their_volumes(void)
{
	static const struct {
		const char *data;
		double volume;
	} all[] = {
		{"#100=IFCBOOLEANCLIPPINGRESULT(.DIFFERENCE.,#20,#101);"
		 "#101=IFCHALFSPACESOLID(#102,.F.);#102=IFCPLANE(#103);"
		 "#103=IFCAXIS2PLACEMENT3D(#104,$,$);"
		 "#104=IFCCARTESIANPOINT((0.,0.,1.));",
			8},
		{"#100=IFCBOOLEANCLIPPINGRESULT(.DIFFERENCE.,#20,#101);"
		 "#101=IFCHALFSPACESOLID(#102,.T.);#102=IFCPLANE(#103);"
		 "#103=IFCAXIS2PLACEMENT3D(#104,$,$);"
		 "#104=IFCCARTESIANPOINT((0.,0.,1.));",
			16},
		{"#100=IFCBOOLEANRESULT(.INTERSECTION.,#20,#101);"
		 "#101=IFCHALFSPACESOLID(#102,.F.);#102=IFCPLANE(#103);"
		 "#103=IFCAXIS2PLACEMENT3D(#104,$,$);"
		 "#104=IFCCARTESIANPOINT((0.,0.,1.));",
			16},
		/* Above z = 1, but only where x and y are positive. */
		{"#100=IFCBOOLEANCLIPPINGRESULT(.DIFFERENCE.,#20,#101);"
		 "#101=IFCPOLYGONALBOUNDEDHALFSPACE(#102,.F.,#3,#105);"
		 "#102=IFCPLANE(#103);#103=IFCAXIS2PLACEMENT3D(#104,$,$);"
		 "#104=IFCCARTESIANPOINT((0.,0.,1.));"
		 "#105=IFCPOLYLINE((#106,#107,#108,#109,#106));"
		 "#106=IFCCARTESIANPOINT((0.,0.));"
		 "#107=IFCCARTESIANPOINT((5.,0.));"
		 "#108=IFCCARTESIANPOINT((5.,5.));"
		 "#109=IFCCARTESIANPOINT((0.,5.));",
			24 - 2 * 1 * 2},
		/* A chain: less a box, less another that overlaps it. */
		{"#100=IFCBOOLEANRESULT(.DIFFERENCE.,#101,#103);"
		 "#101=IFCBOOLEANRESULT(.DIFFERENCE.,#20,#102);"
		 "#102=IFCEXTRUDEDAREASOLID(#110,$,#2,1.);"
		 "#103=IFCEXTRUDEDAREASOLID(#110,$,#2,2.);"
		 "#110=IFCRECTANGLEPROFILEDEF(.AREA.,$,$,1.,1.);",
			22},
		{"#100=IFCBOOLEANRESULT(.UNION.,#20,#102);"
		 "#102=IFCEXTRUDEDAREASOLID(#110,$,#2,5.);"
		 "#110=IFCRECTANGLEPROFILEDEF(.AREA.,$,$,1.,1.);",
			26},
		{"#100=IFCCSGSOLID(#101);"
		 "#101=IFCBOOLEANRESULT(.INTERSECTION.,#20,#102);"
		 "#102=IFCEXTRUDEDAREASOLID(#110,$,#2,5.);"
		 "#110=IFCRECTANGLEPROFILEDEF(.AREA.,$,$,1.,9.);",
			6},
		/* Nothing is left. */
		{"#100=IFCBOOLEANRESULT(.DIFFERENCE.,#20,#20);", 0},
	};

	for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
		struct result result = result_of(all[i].data, 1e-3);

		CHECK(result.outcome == IFC_SHAPED);
		CHECK(near(result.volume, all[i].volume, 1e-9));
		CHECK(result.parts == (all[i].volume > 0));
	}
}

static void
booleans_without_end_are_refused(void)
{
	static const char *const all[] = {
		"#100=IFCBOOLEANRESULT(.DIFFERENCE.,#100,#20);",
		"#100=IFCBOOLEANRESULT(.DIFFERENCE.,#20,#100);",
		"#100=IFCBOOLEANRESULT(.NEITHER.,#20,#20);",
		"#100=IFCBOOLEANRESULT(.UNION.,#20,#101);"
		"#101=IFCHALFSPACESOLID(#102,.F.);#102=IFCPLANE(#3);",
		"#100=IFCBOOLEANRESULT(.DIFFERENCE.,#20,#101);"
		"#101=IFCHALFSPACESOLID(#11,.F.);",
		"#100=IFCBOOLEANRESULT(.DIFFERENCE.,$,#20);",
	};

	for (size_t i = 0; i < sizeof all / sizeof *all; i++)
		CHECK(result_of(all[i], 1e-3).outcome == IFC_REFUSED);
}

static const struct check_test tests[] = {
	CHECK_TEST(extrusions_have_base_times_height),
	CHECK_TEST(extrusions_of_nothing_are_refused),
	CHECK_TEST(revolutions_come_nearer_with_the_deflection),
	CHECK_TEST(shells_look_outwards_however_they_are_given),
	CHECK_TEST(voids_are_taken_away),
	CHECK_TEST(maps_scale_and_mirror),
	CHECK_TEST(booleans_have_their_volumes),
	CHECK_TEST(booleans_without_end_are_refused),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
