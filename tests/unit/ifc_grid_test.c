/* Placements on grids against points computed by hand. */
#include "ifc_shape_sample.h"
#include "parsers/ifc_placement.h"

/* Axes x = 3 (up), y = 2, y = x, and a circle; on a grid that stands at 100. */
#define GRID \
	"#1=IFCCARTESIANPOINT((3.,0.));#2=IFCCARTESIANPOINT((3.,9.));" \
	"#3=IFCCARTESIANPOINT((0.,2.));#4=IFCCARTESIANPOINT((1.,2.));" \
	"#5=IFCCARTESIANPOINT((0.,0.));#6=IFCCARTESIANPOINT((5.,5.));" \
	"#11=IFCPOLYLINE((#1,#2));#12=IFCPOLYLINE((#3,#4));" \
	"#13=IFCPOLYLINE((#5,#6));#14=IFCAXIS2PLACEMENT2D(#5,$);" \
	"#15=IFCCIRCLE(#14,5.);#16=IFCTRIMMEDCURVE(#15,(IFCPARAMETERVALUE(0.))," \
	"(IFCPARAMETERVALUE(1.)),.T.,.PARAMETER.);" \
	"#21=IFCGRIDAXIS('A',#11,.T.);#22=IFCGRIDAXIS('1',#12,.T.);" \
	"#23=IFCGRIDAXIS('2',#13,.T.);#24=IFCGRIDAXIS('3',#16,.F.);" \
	"#25=IFCGRIDAXIS('4',#11,.F.);" \
	"#31=IFCCARTESIANPOINT((100.,0.,10.));" \
	"#32=IFCAXIS2PLACEMENT3D(#31,$,$);#33=IFCLOCALPLACEMENT($,#32);" \
	"#34=IFCGRID('grid',$,$,$,$,#33,$,(#21,#25),(#22,#23,#24),$,$);"

/* Where the origin and the x axis of #100 come to lie; false: not known. */
static bool
placed(const char *schema, const char *data, struct tcs_point *origin,
	struct tcs_point *x)
{
	struct ifc_placements placements = {.count = 0};
	const struct ifc_placement *found;
	struct sample sample;
	char text[4096];
	bool known;

	snprintf(text, sizeof text, "%s%s", GRID, data);
	CHECK(!sample_open(&sample, schema, text));
	CHECK(!ifc_placements_read(
		&sample.file, &placements, &sample.report, &sample.fault));
	found = ifc_placement_find(&placements, instance(&sample, 100));
	known = found && found->known;
	if (known) {
		const double *m = found->world.at;

		*origin = (struct tcs_point){m[3], m[7], m[11]};
		*x = (struct tcs_point){m[0], m[4], m[8]};
	}
	CHECK(known == !sample.report.reasons.count);
	array_release(&placements);
	sample_close(&sample);
	return known;
}

static void
axes_meet_where_they_are_offset_to(void)
{
	static const struct {
		const char *data;
		struct tcs_point origin, x;
	} all[] = {
		{"#50=IFCVIRTUALGRIDINTERSECTION((#22,#21),(0.,0.));"
		 "#100=IFCGRIDPLACEMENT(#50,$);",
			{103, 2, 10}, {1, 0, 0}},
		{"#50=IFCVIRTUALGRIDINTERSECTION((#21,#22),(0.5,0.25,7.));"
		 "#100=IFCGRIDPLACEMENT(#50,$);",
			{102.5, 2.25, 17}, {0, 1, 0}},
		{"#50=IFCVIRTUALGRIDINTERSECTION((#25,#22),(0.5,0.));"
		 "#100=IFCGRIDPLACEMENT(#50,$);",
			{103.5, 2, 10}, {0, -1, 0}},
		{"#50=IFCVIRTUALGRIDINTERSECTION((#22,#21),(0.,0.));"
		 "#51=IFCVIRTUALGRIDINTERSECTION((#23,#21),(0.,0.));"
		 "#100=IFCGRIDPLACEMENT(#50,#51);",
			{103, 2, 10}, {0, 1, 0}},
		{"#50=IFCVIRTUALGRIDINTERSECTION((#22,#21),(0.,0.));"
		 "#51=IFCDIRECTION((-2.,0.,1.));"
		 "#100=IFCGRIDPLACEMENT(#50,#51);",
			{103, 2, 10}, {-1, 0, 0}},
	};

	for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
		struct tcs_point origin, x;

		if (!placed("IFC4", all[i].data, &origin, &x)) {
			CHECK(false);
			continue;
		}
		CHECK(is_near(origin.x, all[i].origin.x, 1e-12));
		CHECK(is_near(origin.y, all[i].origin.y, 1e-12));
		CHECK(is_near(origin.z, all[i].origin.z, 1e-12));
		CHECK(is_near(x.x, all[i].x.x, 1e-12));
		CHECK(is_near(x.y, all[i].x.y, 1e-12));
	}
}

static void
axes_may_be_curved(void)
{
	struct tcs_point origin, x;

	CHECK(placed("IFC4",
		"#50=IFCVIRTUALGRIDINTERSECTION((#24,#23),(0.,0.));"
		"#100=IFCGRIDPLACEMENT(#50,$);",
		&origin, &x));
	CHECK(is_near(origin.x, 100 + 5 * sqrt(0.5), 1e-3));
	CHECK(is_near(origin.y, 5 * sqrt(0.5), 1e-3));
	CHECK(is_near(x.x, sqrt(0.5), 1e-2) && is_near(x.y, -sqrt(0.5), 1e-2));
}

static void
a_parent_may_be_named_since_ifc4x3(void)
{
	struct tcs_point origin, x;

	CHECK(placed("IFC4X3",
		"#50=IFCVIRTUALGRIDINTERSECTION((#22,#21),(0.,0.));"
		"#52=IFCLOCALPLACEMENT(#33,#32);"
		"#100=IFCGRIDPLACEMENT(#52,#50,$);",
		&origin, &x));
	CHECK(origin.x == 203 && origin.y == 2 && origin.z == 20);
}

static void
axes_that_do_not_meet_place_nothing(void)
{
	static const char *const all[] = {
		"#50=IFCVIRTUALGRIDINTERSECTION((#21,#25),(0.,0.));"
		"#100=IFCGRIDPLACEMENT(#50,$);",
		"#50=IFCVIRTUALGRIDINTERSECTION((#21),(0.,0.));"
		"#100=IFCGRIDPLACEMENT(#50,$);",
		"#50=IFCVIRTUALGRIDINTERSECTION((#21,#99),(0.,0.));"
		"#100=IFCGRIDPLACEMENT(#50,$);",
		"#50=IFCVIRTUALGRIDINTERSECTION((#21,#22),(0.,0.));"
		"#100=IFCGRIDPLACEMENT(#50,#50);",
		"#100=IFCGRIDPLACEMENT(#1,$);",
		"#100=IFCGRIDPLACEMENT();",
	};
	struct tcs_point origin, x;

	for (size_t i = 0; i < sizeof all / sizeof *all; i++)
		CHECK(!placed("IFC4", all[i], &origin, &x));
}

static const struct check_test tests[] = {
	CHECK_TEST(axes_meet_where_they_are_offset_to),
	CHECK_TEST(axes_may_be_curved),
	CHECK_TEST(a_parent_may_be_named_since_ifc4x3),
	CHECK_TEST(axes_that_do_not_meet_place_nothing),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
