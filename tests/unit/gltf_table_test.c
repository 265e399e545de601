#include "check.h"
#include "town_sample.h"
#include "writers/gltf_table.h"

static struct tcs_fault fault;
static struct tcs_object object;
static struct report report;
static struct table table;

static void
start(uint32_t column_limit)
{
	report_release(&report);
	report = (struct report){.counts = {NULL, 0, 0}};
	table_release(&table);
	CHECK(!table_init(&table, column_limit, &fault));
	object_clear(&object);
	SAMPLE_PUSH(object.text, '\0');
	SAMPLE_PUSH(object.features,
		(struct tcs_feature){
			.parent = TCS_NONE, .class = TCS_CLASS_Building});
}

static void
attribute(const char *name, const char *value, const char *unit,
	uint32_t parent, uint16_t type)
{
	SAMPLE_PUSH(object.attributes,
		(struct tcs_attribute){.name = SAMPLE_TEXT(&object, name),
			.value = SAMPLE_TEXT(&object, value),
			.unit = SAMPLE_TEXT(&object, unit),
			.number = atof(value),
			.parent = parent,
			.type = type});
}

static void
add_row(void)
{
	CHECK(!table_add(&table, &object, 0, "b", "", 0,
		object.attributes.count, &report, &fault));
}

static const struct table_column *
column_named(const char *property)
{
	for (size_t i = 0; i < table.columns.count; i++)
		if (!strcmp(table.columns.at[i].property, property))
			return table.columns.at + i;
	return NULL;
}

static void
property_ids_are_identifiers(void)
{
	static const char *const pairs[][2] = {
		{"height", "height"},
		{"uro:type of roof", "uro_type_of_roof"},
		{"Geb\xc3\xa4"
		 "ude",
			"Geb_ude"},
		{"3rd", "_3rd"},
		{"\xf0\x9f\x8f\xa0", "_"},
	};
	char out[64];

	for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++) {
		property_id(pairs[i][0], out);
		CHECK(!strcmp(out, pairs[i][1]));
	}
}

static void
a_taken_id_gets_a_number(void)
{
	start(10);
	attribute("class", "1000", "", TCS_NONE, TCS_CODE);
	attribute("a-b", "x", "", TCS_NONE, TCS_STRING);
	attribute("a b", "y", "", TCS_NONE, TCS_STRING);
	add_row();
	CHECK(column_named("class_2") &&
		!strcmp(column_named("class_2")->name, "class"));
	CHECK(column_named("a_b") && !strcmp(column_named("a_b")->name, "a-b"));
	CHECK(column_named("a_b_2") &&
		!strcmp(column_named("a_b_2")->name, "a b"));
}

static void
members_of_sets_are_named_by_their_path(void)
{
	start(10);
	attribute("address", "", "", TCS_NONE, TCS_SET);
	attribute("street", "Rue A", "", 0, TCS_STRING);
	attribute("inner", "", "", 0, TCS_SET);
	attribute("number", "7", "", 2, TCS_INTEGER);
	add_row();
	CHECK(table.columns.count == TABLE_FIXED + 2);
	CHECK(column_named("address_street") &&
		!strcmp(column_named("address_street")->name,
			"address.street"));
	CHECK(column_named("address_inner_number") &&
		!strcmp(column_named("address_inner_number")->name,
			"address.inner.number"));
}

static void
a_repeated_attribute_takes_further_columns(void)
{
	start(10);
	attribute("function", "1", "", TCS_NONE, TCS_CODE);
	attribute("function", "2", "", TCS_NONE, TCS_CODE);
	add_row();
	add_row();
	CHECK(table.row_count == 2);
	CHECK(table.columns.count == TABLE_FIXED + 2);
	CHECK(column_named("function")->column.rows.count == 2);
	CHECK(column_named("function_2")->column.rows.count == 2);
}

static void
units_do_not_share_a_column(void)
{
	start(10);
	attribute("height", "3", "m", TCS_NONE, TCS_MEASURE);
	add_row();
	object.attributes.count = 0;
	attribute("height", "10", "ft", TCS_NONE, TCS_MEASURE);
	add_row();
	CHECK(!strcmp(column_named("height")->unit, "m"));
	CHECK(!strcmp(column_named("height_2")->unit, "ft"));
	CHECK(column_named("height_2")->column.rows.at[0] == 1);
}

static void
columns_past_the_limit_are_reported(void)
{
	start(1);
	attribute("a", "1", "", TCS_NONE, TCS_STRING);
	attribute("b", "2", "", TCS_NONE, TCS_STRING);
	add_row();
	CHECK(table.columns.count == TABLE_FIXED + 1);
	CHECK(report.reasons.count == 1);
	CHECK(report.reasons.at[0].severity == REPORT_SKIPPED);
	CHECK(!strcmp(report.reasons.at[0].examples[0], "b"));
}

static void
a_code_space_that_differs_is_not_told(void)
{
	start(10);
	attribute("function", "1", "", TCS_NONE, TCS_CODE);
	object.attributes.at[0].code_space = SAMPLE_TEXT(&object, "codes.xml");
	add_row();
	CHECK(!strcmp(column_named("function")->code_space, "codes.xml"));
	object.attributes.at[0].code_space = SAMPLE_TEXT(&object, "other.xml");
	add_row();
	CHECK(!column_named("function")->code_space);
	table_release(&table);
	table = (struct table){.row_count = 0};
	object_release(&object);
	report_release(&report);
}

int
main(void)
{
	static const struct check_test tests[] = {
		CHECK_TEST(property_ids_are_identifiers),
		CHECK_TEST(a_taken_id_gets_a_number),
		CHECK_TEST(members_of_sets_are_named_by_their_path),
		CHECK_TEST(a_repeated_attribute_takes_further_columns),
		CHECK_TEST(units_do_not_share_a_column),
		CHECK_TEST(columns_past_the_limit_are_reported),
		CHECK_TEST(a_code_space_that_differs_is_not_told),
		{0},
	};

	return check_run(tests);
}
