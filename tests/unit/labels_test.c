#include "labels.h"

#include <string.h>

#include "check.h"

static void
every_label_is_found_again(void)
{
	for (unsigned i = 0; i < TCS_CLASS_COUNT; i++) {
		const char *name = label_of(i)->name;

		CHECK(name && label_find(name, strlen(name)) == i);
	}
}

/* The first row wins where 3.0 has one name for two classes of 2.0. */
static void
every_citygml_name_is_found_in_its_version(void)
{
	for (unsigned i = 0; i < TCS_CLASS_COUNT; i++) {
		const struct label *label = label_of(i);
		unsigned found;

		if (label->name_2)
			CHECK(label_find_citygml(2, label->name_2,
				      strlen(label->name_2)) == i);
		if (!label->name_3)
			continue;
		found = label_find_citygml(
			3, label->name_3, strlen(label->name_3));
		CHECK(found <= i);
		CHECK(!strcmp(label_of(found)->name_3, label->name_3));
	}
}

static void
a_name_and_its_module_stand_together(void)
{
	for (unsigned i = 0; i < TCS_CLASS_COUNT; i++) {
		const struct label *label = label_of(i);

		CHECK(!label->name_2 == !label->module_2);
		CHECK(!label->name_3 == !label->module_3);
	}
}

static void
versions_differ_where_citygml_does(void)
{
	CHECK(label_find_citygml(1, "Room", 4) == TCS_CLASS_BuildingRoom);
	CHECK(label_find_citygml(2, "Room", 4) == TCS_CLASS_BuildingRoom);
	CHECK(label_find_citygml(3, "Room", 4) == TCS_CLASS_Unknown);
	CHECK(label_find_citygml(3, "BuildingRoom", 12) ==
		TCS_CLASS_BuildingRoom);
	CHECK(label_find_citygml(2, "Storey", 6) == TCS_CLASS_Unknown);
	CHECK(label_find_citygml(3, "Storey", 6) == TCS_CLASS_Storey);
	CHECK(label_find_citygml(2, "IntBridgeInstallation", 21) ==
		TCS_CLASS_IntBridgeInstallation);
}

static void
only_the_whole_name_counts(void)
{
	CHECK(label_find("WallSurface", 11) == TCS_CLASS_WallSurface);
	CHECK(label_find("WallSurface", 4) == TCS_CLASS_Unknown);
	CHECK(label_find("wallsurface", 11) == TCS_CLASS_Unknown);
	CHECK(label_find("", 0) == TCS_CLASS_Unknown);
	CHECK(label_find_citygml(2, "-", 1) == TCS_CLASS_Unknown);
	CHECK(label_find_citygml(3, "Nothing", 7) == TCS_CLASS_Unknown);
}

static void
a_number_of_the_future_is_unknown(void)
{
	CHECK(!strcmp(label_of(TCS_CLASS_COUNT)->name, "Unknown"));
	CHECK(!strcmp(label_of(65535)->name, "Unknown"));
	CHECK(label_of(0)->name_2 == NULL && label_of(0)->name_3 == NULL);
}

static const struct check_test tests[] = {
	CHECK_TEST(every_label_is_found_again),
	CHECK_TEST(every_citygml_name_is_found_in_its_version),
	CHECK_TEST(a_name_and_its_module_stand_together),
	CHECK_TEST(versions_differ_where_citygml_does),
	CHECK_TEST(only_the_whole_name_counts),
	CHECK_TEST(a_number_of_the_future_is_unknown),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
