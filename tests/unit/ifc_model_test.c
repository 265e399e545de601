#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "ifc_sample.h"
#include "parsers/ifc_placement.h"
#include "parsers/ifc_tree.h"
#include "parsers/ifc_units.h"

static uint64_t
reported(const struct sample *sample, enum report_severity severity)
{
	uint64_t count = 0;

	for (size_t i = 0; i < sample->report.reasons.count; i++)
		if (sample->report.reasons.at[i].severity == severity)
			count += sample->report.reasons.at[i].count;
	return count;
}

static bool
near(double a, double b)
{
	return fabs(a - b) <= 1e-12 * fmax(1, fabs(b));
}

static bool
near_point(struct tcs_point point, double x, double y, double z)
{
	return near(point.x, x) && near(point.y, y) && near(point.z, z);
}

/* ---- the file ------------------------------------------------------------ */

static void
other_schemas_are_refused(void)
{
	struct sample sample;

	CHECK(sample_open(&sample, "AUTOMOTIVE_DESIGN", "") == TCS_BAD_INPUT);
	sample_close(&sample);
	CHECK(sample_open(&sample, "ifc4x3_add2", "") == TCS_OK);
	CHECK(sample.file.version == IFC_4X3);
	sample_close(&sample);
}

static void
kinds_are_collected_in_the_order_of_the_file(void)
{
	struct ifc_instances found = {.count = 0};
	struct sample sample;

	CHECK(!sample_open(&sample, "IFC4",
		"#1=IFCWALL();#2=IFCSLAB();#3=(A()B());#4=IFCWALL();"
		"#5=IFCWALLTYPE();#6=NOTHING();"));
	CHECK(!ifc_collect(&sample.file, IFC_ELEMENT, &found, &sample.fault));
	CHECK(found.count == 3 && found.at[0] == 0 && found.at[1] == 1 &&
		found.at[2] == 3);
	CHECK(ifc_entity_of(&sample.file, 2) == IFC_NONE);
	CHECK(ifc_entity_of(&sample.file, 5) == IFC_NONE);
	CHECK(ifc_entity_of(&sample.file, STEP_NONE) == IFC_NONE);
	CHECK(ifc_value(&sample.file, 0, 0).kind == STEP_END);
	CHECK(ifc_target(&sample.file, STEP_NONE, 0) == STEP_NONE);
	array_release(&found);
	sample_close(&sample);
}

/* ---- units --------------------------------------------------------------- */

#define PROJECT "#1=IFCPROJECT('',$,$,$,$,$,$,(),#2);"

static void
units_have_prefixes_and_conversions(void)
{
	struct ifc_units units;
	struct sample sample;

	CHECK(!sample_open(&sample, "IFC2X3",
		PROJECT
		"#2=IFCUNITASSIGNMENT((#3,#4,#5,#6));"
		"#3=IFCCONVERSIONBASEDUNIT(#9,.LENGTHUNIT.,'FOOT',#7);"
		"#4=IFCSIUNIT(*,.AREAUNIT.,.CENTI.,.SQUARE_METRE.);"
		"#5=IFCSIUNIT(*,.VOLUMEUNIT.,.MILLI.,.CUBIC_METRE.);"
		"#6=IFCCONVERSIONBASEDUNIT(#9,.PLANEANGLEUNIT.,'DEGREE',#8);"
		"#7=IFCMEASUREWITHUNIT(IFCRATIOMEASURE(304.8),#10);"
		"#8=IFCMEASUREWITHUNIT(IFCPLANEANGLEMEASURE(0.0174532925),#11);"
		"#10=IFCSIUNIT(*,.LENGTHUNIT.,.MILLI.,.METRE.);"
		"#11=IFCSIUNIT(*,.PLANEANGLEUNIT.,$,.RADIAN.);"));
	CHECK(!ifc_units_read(
		&sample.file, &units, &sample.report, &sample.fault));
	CHECK(near(units.length, 0.3048));
	CHECK(near(units.area, 1e-4));
	CHECK(near(units.volume, 1e-9));
	CHECK(near(units.angle, 0.0174532925));
	CHECK(!sample.report.reasons.count);
	sample_close(&sample);
}

static void
units_that_lead_nowhere_are_assumed(void)
{
	struct ifc_units units;
	struct sample sample;

	CHECK(!sample_open(&sample, "IFC4",
		PROJECT "#2=IFCUNITASSIGNMENT((#3,#4,#99));"
			"#3=IFCCONVERSIONBASEDUNIT(#9,.LENGTHUNIT.,'LOOP',#5);"
			"#4=IFCSIUNIT(*,.PLANEANGLEUNIT.,.HALF.,.RADIAN.);"
			"#5=IFCMEASUREWITHUNIT(IFCRATIOMEASURE(2.),#3);"));
	CHECK(!ifc_units_read(
		&sample.file, &units, &sample.report, &sample.fault));
	CHECK(units.length == 1 && units.area == 1 && units.volume == 1);
	CHECK(units.angle == 1);
	CHECK(reported(&sample, REPORT_NOTE) == 2);
	sample_close(&sample);
}

/* ---- placements ---------------------------------------------------------- */

static void
chains_of_placements_are_multiplied_out(void)
{
	struct ifc_placements placements = {.count = 0};
	const struct ifc_placement *inner;
	struct tcs_point point = {1, 0, 5};
	struct sample sample;

	CHECK(!sample_open(&sample, "IFC4",
		"#1=IFCLOCALPLACEMENT(#2,#11);#2=IFCLOCALPLACEMENT($,#12);"
		"#11=IFCAXIS2PLACEMENT3D(#21,$,#32);"
		"#12=IFCAXIS2PLACEMENT3D(#22,#33,#31);"
		"#21=IFCCARTESIANPOINT((10.,0.,0.));"
		"#22=IFCCARTESIANPOINT((100.,200.,300.));"
		"#31=IFCDIRECTION((2.,0.,7.));#32=IFCDIRECTION((0.,3.));"
		"#33=IFCDIRECTION((0.,0.,-1.));"));
	CHECK(!ifc_placements_read(
		&sample.file, &placements, &sample.report, &sample.fault));
	CHECK(placements.count == 2 && !sample.report.reasons.count);
	inner = ifc_placement_find(&placements, instance(&sample, 1));
	CHECK(inner && inner->known && inner->parent == 1);
	/* (1,0,5) turned to (0,1,5), moved to (10,1,5), turned over. */
	CHECK(near_point(ifc_transform(&inner->world, point), 110, 199, 295));
	CHECK(!ifc_placement_find(&placements, instance(&sample, 11)));
	array_release(&placements);
	sample_close(&sample);
}

static void
cycles_and_what_hangs_on_them_are_not_known(void)
{
	static const bool known[] = {false, false, false, true, false, false};
	struct ifc_placements placements = {.count = 0};
	struct sample sample;

	CHECK(!sample_open(&sample, "IFC2X3",
		"#1=IFCLOCALPLACEMENT(#2,#11);#2=IFCLOCALPLACEMENT(#3,#11);"
		"#3=IFCLOCALPLACEMENT(#2,#11);#4=IFCLOCALPLACEMENT($,#11);"
		"#5=IFCLOCALPLACEMENT(#5,#11);#6=IFCLOCALPLACEMENT(#99,#11);"
		"#11=IFCAXIS2PLACEMENT3D(#21,$,$);"
		"#21=IFCCARTESIANPOINT((0.,0.,0.));"));
	CHECK(!ifc_placements_read(
		&sample.file, &placements, &sample.report, &sample.fault));
	CHECK(placements.count == 6);
	for (size_t i = 0; i < placements.count; i++)
		CHECK(placements.at[i].known == known[i]);
	CHECK(reported(&sample, REPORT_SKIPPED) == 5);
	array_release(&placements);
	sample_close(&sample);
}

static void
a_chain_of_a_hundred_thousand_is_no_harm(void)
{
	enum { LINKS = 100000 };
	char *data = malloc(LINKS * 48 + 256), *at = data;
	struct ifc_placements placements = {.count = 0};
	struct sample sample;

	if (!data)
		abort();
	for (int i = 1; i < LINKS; i++)
		at += sprintf(
			at, "#%d=IFCLOCALPLACEMENT(#%d,#999998);", i, i + 1);
	sprintf(at,
		"#%d=IFCLOCALPLACEMENT($,#999998);"
		"#999998=IFCAXIS2PLACEMENT3D(#999999,$,$);"
		"#999999=IFCCARTESIANPOINT((1.,0.,0.));",
		LINKS);
	CHECK(!sample_open(&sample, "IFC4", data));
	CHECK(!ifc_placements_read(
		&sample.file, &placements, &sample.report, &sample.fault));
	CHECK(placements.at[0].known && placements.at[0].world.at[3] == LINKS);
	array_release(&placements);
	sample_close(&sample);
	free(data);
}

static void
directions_that_are_none_fall_back(void)
{
	struct ifc_matrix matrix;
	struct sample sample;

	CHECK(!sample_open(&sample, "IFC4",
		"#1=IFCAXIS2PLACEMENT3D(#9,#2,#3);"
		"#2=IFCDIRECTION((1.,0.,0.));#3=IFCDIRECTION((5.,0.,0.));"
		"#4=IFCAXIS2PLACEMENT3D(#9,#5,$);"
		"#5=IFCDIRECTION((0.,0.,0.));#6=IFCAXIS2PLACEMENT3D($,$,$);"
		"#9=IFCCARTESIANPOINT((0.,0.,0.));"));
	CHECK(ifc_axes(&sample.file, instance(&sample, 1), &matrix));
	CHECK(near_point(
		ifc_transform(&matrix, (struct tcs_point){0, 0, 1}), 1, 0, 0));
	CHECK(near_point(
		ifc_transform(&matrix, (struct tcs_point){1, 0, 0}), 0, 1, 0));
	CHECK(ifc_axes(&sample.file, instance(&sample, 4), &matrix));
	CHECK(!memcmp(&matrix, &ifc_identity, sizeof matrix));
	CHECK(!ifc_axes(&sample.file, instance(&sample, 6), &matrix));
	CHECK(!ifc_axes(&sample.file, instance(&sample, 9), &matrix));
	CHECK(!ifc_axes(&sample.file, STEP_NONE, &matrix));
	sample_close(&sample);
}

static void
operators_scale_and_mirror(void)
{
	struct tcs_point point = {1, 2, 3};
	struct ifc_matrix matrix;
	struct sample sample;

	CHECK(!sample_open(&sample, "IFC4",
		"#1=IFCCARTESIANTRANSFORMATIONOPERATOR3DNONUNIFORM("
		"$,#7,#9,2.,$,3.,4.);"
		"#2=IFCCARTESIANTRANSFORMATIONOPERATOR3D($,$,#9,$,$);"
		"#3=IFCCARTESIANTRANSFORMATIONOPERATOR2D(#8,$,#10,0.5);"
		"#4=IFCCARTESIANTRANSFORMATIONOPERATOR3D($,$,#9,0.,$);"
		"#7=IFCDIRECTION((0.,-1.,0.));#8=IFCDIRECTION((0.,1.));"
		"#9=IFCCARTESIANPOINT((10.,20.,30.));"
		"#10=IFCCARTESIANPOINT((1.,1.));"));
	CHECK(ifc_operator(&sample.file, instance(&sample, 1), &matrix));
	CHECK(near_point(ifc_transform(&matrix, point), 12, 14, 42));
	CHECK(ifc_operator(&sample.file, instance(&sample, 2), &matrix));
	CHECK(near_point(ifc_transform(&matrix, point), 11, 22, 33));
	CHECK(ifc_operator(&sample.file, instance(&sample, 3), &matrix));
	CHECK(near_point(ifc_transform(&matrix, point), 0, 1.5, 1.5));
	CHECK(!ifc_operator(&sample.file, instance(&sample, 4), &matrix));
	sample_close(&sample);
}

/* ---- the tree ------------------------------------------------------------ */

#define BUILDING \
	"#1=IFCPROJECT('',$,$,$,$,$,$,(),$);#2=IFCBUILDING();" \
	"#3=IFCBUILDINGSTOREY();#4=IFCWALL();#5=IFCOPENINGELEMENT();" \
	"#6=IFCWINDOW();#7=IFCWALLTYPE();" \
	"#11=IFCRELAGGREGATES('',$,$,$,#1,(#2));" \
	"#12=IFCRELAGGREGATES('',$,$,$,#2,(#3));"

static void
what_belongs_to_what_is_known(void)
{
	struct ifc_tree tree = {.count = 0};
	struct sample sample;
	uint32_t wall, opening, window;

	CHECK(!sample_open(&sample, "IFC2X3",
		BUILDING
		"#13=IFCRELCONTAINEDINSPATIALSTRUCTURE('',$,$,$,(#4,#6),#3);"
		"#14=IFCRELVOIDSELEMENT('',$,$,$,#4,#5);"
		"#15=IFCRELFILLSELEMENT('',$,$,$,#5,#6);"));
	CHECK(!ifc_tree_read(
		&sample.file, &tree, &sample.report, &sample.fault));
	CHECK(tree.count == 6 && !sample.report.reasons.count);
	wall = ifc_tree_find(&tree, instance(&sample, 4));
	opening = ifc_tree_find(&tree, instance(&sample, 5));
	window = ifc_tree_find(&tree, instance(&sample, 6));
	CHECK(ifc_tree_find(&tree, instance(&sample, 7)) == STEP_NONE);
	CHECK(tree.at[wall].link == IFC_LINK_CONTENT);
	CHECK(tree.at[opening].link == IFC_LINK_VOID);
	CHECK(tree.at[opening].parent == wall);
	CHECK(tree.at[window].fills == opening);
	CHECK(ifc_tree_above(&sample.file, &tree, window, IFC_BUILDING) ==
		ifc_tree_find(&tree, instance(&sample, 2)));
	CHECK(ifc_tree_above(&sample.file, &tree, window, IFC_SITE) ==
		STEP_NONE);
	array_release(&tree);
	sample_close(&sample);
}

static void
rings_are_cut_and_second_parents_noted(void)
{
	struct ifc_tree tree = {.count = 0};
	struct sample sample;

	CHECK(!sample_open(&sample, "IFC4",
		BUILDING
		"#13=IFCRELAGGREGATES('',$,$,$,#3,(#1,#4,#99));"
		"#14=IFCRELCONTAINEDINSPATIALSTRUCTURE('',$,$,$,(#4),#2);"
		"#15=IFCRELCONTAINEDINSPATIALSTRUCTURE('',$,$,$,(#6),#98);"));
	CHECK(!ifc_tree_read(
		&sample.file, &tree, &sample.report, &sample.fault));
	CHECK(reported(&sample, REPORT_SKIPPED) == 2);
	CHECK(reported(&sample, REPORT_NOTE) == 2);
	for (uint32_t i = 0; i < tree.count; i++)
		CHECK(ifc_tree_above(&sample.file, &tree, i, IFC_SITE) ==
			STEP_NONE);
	array_release(&tree);
	sample_close(&sample);
}

static const struct check_test tests[] = {
	CHECK_TEST(other_schemas_are_refused),
	CHECK_TEST(kinds_are_collected_in_the_order_of_the_file),
	CHECK_TEST(units_have_prefixes_and_conversions),
	CHECK_TEST(units_that_lead_nowhere_are_assumed),
	CHECK_TEST(chains_of_placements_are_multiplied_out),
	CHECK_TEST(cycles_and_what_hangs_on_them_are_not_known),
	CHECK_TEST(a_chain_of_a_hundred_thousand_is_no_harm),
	CHECK_TEST(directions_that_are_none_fall_back),
	CHECK_TEST(operators_scale_and_mirror),
	CHECK_TEST(what_belongs_to_what_is_known),
	CHECK_TEST(rings_are_cut_and_second_parents_noted),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
