#include "parsers/ifc_schema.h"

#include <string.h>

#include "check.h"

static void
schemas_are_told_apart_by_name(void)
{
	enum ifc_version version;

	CHECK(ifc_version_of("IFC2X3", &version) && version == IFC_2X3);
	CHECK(ifc_version_of("IFC2X2_FINAL", &version) && version == IFC_2X3);
	CHECK(ifc_version_of("IFC4", &version) && version == IFC_4);
	CHECK(ifc_version_of("IFC4X1", &version) && version == IFC_4);
	CHECK(ifc_version_of("IFC4X3_ADD2", &version) && version == IFC_4X3);
	CHECK(!ifc_version_of("CONFIG_CONTROL_DESIGN", &version));
}

static void
every_entity_is_found_by_its_name(void)
{
	for (int i = IFC_NONE + 1; i < IFC_ENTITIES; i++)
		CHECK((int)ifc_find(ifc_name((enum ifc_entity)i)) == i);
	CHECK(ifc_find("IFCWAL") == IFC_NONE);
	CHECK(ifc_find("") == IFC_NONE);
}

static void
every_chain_of_supertypes_ends_within_its_version(void)
{
	for (int v = 0; v < IFC_VERSIONS; v++) {
		enum ifc_version version = (enum ifc_version)v;

		for (int i = IFC_NONE + 1; i < IFC_ENTITIES; i++) {
			enum ifc_entity at = (enum ifc_entity)i;
			int steps = 0;

			if (!ifc_exists(version, at))
				continue;
			for (; at != IFC_NONE && steps < 12; steps++) {
				CHECK(ifc_exists(version, at));
				at = ifc_super(version, at);
			}
			CHECK(at == IFC_NONE);
		}
	}
}

static void
kinds_follow_the_version(void)
{
	CHECK(ifc_is(IFC_2X3, IFC_WALLSTANDARDCASE, IFC_WALL));
	CHECK(ifc_is(IFC_2X3, IFC_WALLSTANDARDCASE, IFC_PRODUCT));
	CHECK(!ifc_is(IFC_2X3, IFC_WALL, IFC_SLAB));
	CHECK(ifc_is(IFC_4, IFC_WALL, IFC_BUILDINGELEMENT));
	CHECK(!ifc_is(IFC_4X3, IFC_WALL, IFC_BUILDINGELEMENT));
	CHECK(ifc_is(IFC_4X3, IFC_WALL, IFC_BUILTELEMENT));
	CHECK(ifc_is(IFC_2X3, IFC_BUILDING, IFC_SPATIALSTRUCTUREELEMENT));
	CHECK(ifc_is(IFC_4X3, IFC_BUILDING, IFC_FACILITY));
	CHECK(!ifc_is(IFC_4, IFC_NONE, IFC_PRODUCT));
}

static void
an_entity_of_another_version_is_taken_from_there(void)
{
	CHECK(!ifc_exists(IFC_2X3, IFC_POLYGONALFACESET));
	CHECK(ifc_is(IFC_2X3, IFC_ROAD, IFC_PRODUCT));
	CHECK(ifc_is(IFC_4X3, IFC_ELECTRICALELEMENT, IFC_ELEMENT));
	CHECK(ifc_attribute(IFC_2X3, IFC_POLYGONALFACESET, "Faces") == 2);
}

/* The counts are those of instances in files of many writers. */
static void
positions_follow_the_version(void)
{
	static const struct {
		enum ifc_entity entity;
		const char *attribute;
		int positions[IFC_VERSIONS];
	} all[] = {
		{IFC_WALL, "GlobalId", {0, 0, 0}},
		{IFC_WALL, "ObjectPlacement", {5, 5, 5}},
		{IFC_WALL, "Representation", {6, 6, 6}},
		{IFC_WALL, "PredefinedType", {-1, 8, 8}},
		{IFC_SLAB, "PredefinedType", {8, 8, 8}},
		{IFC_DOOR, "OverallWidth", {9, 9, 9}},
		{IFC_DOOR, "OperationType", {-1, 11, 11}},
		{IFC_PROJECT, "UnitsInContext", {8, 8, 8}},
		{IFC_BUILDINGSTOREY, "Elevation", {9, 9, 9}},
		{IFC_RELAGGREGATES, "RelatedObjects", {5, 5, 5}},
		{IFC_RELVOIDSELEMENT, "RelatedOpeningElement", {5, 5, 5}},
		{IFC_RELDEFINESBYTYPE, "RelatingType", {5, 5, 5}},
		{IFC_LOCALPLACEMENT, "RelativePlacement", {1, 1, 1}},
		{IFC_COMPOSITECURVESEGMENT, "ParentCurve", {2, 2, 2}},
		{IFC_ASYMMETRICISHAPEPROFILEDEF, "TopFlangeWidth", {8, 8, 8}},
		{IFC_MATERIALLAYER, "LayerThickness", {1, 1, 1}},
		{IFC_EXTRUDEDAREASOLID, "Depth", {3, 3, 3}},
		{IFC_EXTRUDEDAREASOLID, "depth", {-1, -1, -1}},
	};

	for (size_t i = 0; i < sizeof all / sizeof *all; i++)
		for (int v = 0; v < IFC_VERSIONS; v++)
			CHECK(ifc_attribute((enum ifc_version)v, all[i].entity,
				      all[i].attribute) == all[i].positions[v]);
	CHECK(ifc_attribute_count(IFC_2X3, IFC_WALL) == 8);
	CHECK(ifc_attribute_count(IFC_4, IFC_STAIRFLIGHT) == 13);
	CHECK(ifc_attribute_count(IFC_2X3, IFC_REINFORCINGBAR) == 14);
	CHECK(ifc_attribute_count(IFC_4X3, IFC_GRIDPLACEMENT) == 3);
	CHECK(ifc_attribute_count(IFC_4, IFC_ASYMMETRICISHAPEPROFILEDEF) == 15);
}

static const struct check_test tests[] = {
	CHECK_TEST(schemas_are_told_apart_by_name),
	CHECK_TEST(every_entity_is_found_by_its_name),
	CHECK_TEST(every_chain_of_supertypes_ends_within_its_version),
	CHECK_TEST(kinds_follow_the_version),
	CHECK_TEST(an_entity_of_another_version_is_taken_from_there),
	CHECK_TEST(positions_follow_the_version),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
