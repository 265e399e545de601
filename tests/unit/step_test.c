#include "parsers/step_file.h"

#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "parsers/step_string.h"

#define HEAD \
	"ISO-10303-21;\nHEADER;\n" \
	"FILE_DESCRIPTION(('ViewDefinition [CoordinationView]'),'2;1');\n" \
	"FILE_NAME('house.ifc','2020-01-01T00:00:00',(''),(''),'p','Writer " \
	"1','');\nFILE_SCHEMA(('IFC2X3'));\nENDSEC;\n"
#define TAIL "ENDSEC;\nEND-ISO-10303-21;\n"

/* A file over a copy of the text that ends where its memory does. */
struct sample {
	char *text;
	struct step_file file;
	struct report report;
	struct tcs_fault fault;
	enum tcs_status status;
};

static void
sample_open(struct sample *sample, const char *text, size_t length)
{
	*sample = (struct sample){.text = malloc(length ? length : 1)};
	if (!sample->text)
		abort();
	memcpy(sample->text, text, length);
	sample->status = step_index(&sample->file, sample->text, length,
		&sample->report, &sample->fault);
}

static void
sample_data(struct sample *sample, const char *data)
{
	char *text = malloc(strlen(data) + sizeof HEAD TAIL + 8);

	if (!text)
		abort();
	strcpy(text, HEAD "DATA;\n");
	strcat(text, data);
	strcat(text, TAIL);
	sample_open(sample, text, strlen(text));
	free(text);
}

static void
sample_close(struct sample *sample)
{
	step_release(&sample->file);
	report_release(&sample->report);
	free(sample->text);
}

static uint64_t
skipped(const struct sample *sample)
{
	uint64_t count = 0;

	for (size_t i = 0; i < sample->report.reasons.count; i++)
		if (sample->report.reasons.at[i].severity == REPORT_SKIPPED)
			count += sample->report.reasons.at[i].count;
	return count;
}

/* ---- the index ----------------------------------------------------------- */

static void
instances_are_found_by_id_and_by_name(void)
{
	struct sample sample;
	struct step_list list;
	struct step_cursor cursor;
	struct step_value value;

	sample_data(&sample,
		"#3=IFCWALL(#1);\n#1 = IfcWall ( #7 ) ;#7=IFCSLAB($);");
	CHECK(sample.status == TCS_OK && !skipped(&sample));
	CHECK(sample.file.instances.count == 3);
	CHECK(step_find(&sample.file, 1) == 1);
	CHECK(step_find(&sample.file, 7) == 2);
	CHECK(step_find(&sample.file, 2) == STEP_NONE);
	CHECK(step_find(&sample.file, 8) == STEP_NONE);
	CHECK(step_find(&sample.file, UINT64_MAX) == STEP_NONE);
	list = step_instances(
		&sample.file, step_names_find(&sample.file.names, "IFCWALL"));
	CHECK(list.count == 2 && list.at[0] == 0 && list.at[1] == 1);
	CHECK(!step_names_find(&sample.file.names, "IFCDOOR"));
	CHECK(!step_instances(&sample.file, 0).count);
	CHECK(!strcmp(step_name_text(&sample.file, 1), "IFCWALL"));
	cursor = step_parameters(&sample.file, 1);
	CHECK(step_next(&cursor, &value) == STEP_REFERENCE);
	CHECK(step_target(&sample.file, &value) == 2);
	sample_close(&sample);
}

static void
ids_far_apart_are_found_too(void)
{
	struct sample sample;

	sample_data(&sample,
		"#9000000000000000000=A();#5=B();#1000000=C();"
		"#5=D();#900000000000000000000=E();");
	CHECK(sample.status == TCS_OK && sample.file.keys);
	CHECK(step_find(&sample.file, UINT64_C(9000000000000000000)) == 0);
	CHECK(step_find(&sample.file, 5) == 1);
	CHECK(step_find(&sample.file, 1000000) == 2);
	CHECK(step_find(&sample.file, 6) == STEP_NONE);
	CHECK(step_find(&sample.file, UINT64_MAX) == STEP_NONE);
	CHECK(skipped(&sample) == 2);
	sample_close(&sample);
}

static void
the_first_of_two_instances_with_an_id_counts(void)
{
	struct sample sample;

	sample_data(&sample, "#1=A();#2=B();#1=C();");
	CHECK(sample.status == TCS_OK && skipped(&sample) == 1);
	CHECK(step_find(&sample.file, 1) == 0);
	CHECK(!strcmp(sample.report.reasons.at[0].examples[0], "#1"));
	sample_close(&sample);
}

static void
semicolons_hide_in_strings_and_comments(void)
{
	struct sample sample;

	sample_data(&sample,
		"#1=A('x;''#2=B();','/*');/* #3=C(); ' */#4=D(/*;'*/1);"
		"#5=E('*/;');");
	CHECK(sample.status == TCS_OK && !skipped(&sample));
	CHECK(sample.file.instances.count == 3);
	CHECK(step_find(&sample.file, 4) == 1);
	CHECK(step_find(&sample.file, 5) == 2);
	sample_close(&sample);
}

static void
what_is_malformed_is_skipped_and_reported(void)
{
	struct sample sample;

	sample_data(&sample, "#=A();#1 A();#2=;#3=A;nonsense;;#4=A();");
	CHECK(sample.status == TCS_OK && skipped(&sample) == 6);
	CHECK(sample.file.instances.count == 1);
	CHECK(step_find(&sample.file, 4) == 0);
	sample_close(&sample);
}

static void
several_data_sections_are_one_file(void)
{
	static const char text[] = "\xef\xbb\xbf/* a */" HEAD
				   "ANCHOR;<a>=#1;ENDSEC;DATA('one',('X'));"
				   "#1=A();ENDSEC;data;#2=B();" TAIL "#9=C();";
	struct sample sample;

	sample_open(&sample, text, sizeof text - 1);
	CHECK(sample.status == TCS_OK && !sample.report.reasons.count);
	CHECK(sample.file.instances.count == 2);
	sample_close(&sample);
}

static void
the_header_is_read_by_name(void)
{
	struct sample sample;
	struct step_cursor cursor;
	struct step_value values[7];

	sample_data(&sample, "");
	cursor = step_header_parameters(&sample.file, STEP_SCHEMA);
	CHECK(step_next(&cursor, values) == STEP_LIST);
	CHECK(step_next(&values[0].list, values + 1) == STEP_STRING);
	CHECK(values[1].length == 6 && !memcmp(values[1].text, "IFC2X3", 6));
	cursor = step_header_parameters(&sample.file, STEP_FILE_NAME);
	CHECK(step_fetch(&cursor, values, 7) == 7);
	CHECK(values[5].length == 8 && !memcmp(values[5].text, "Writer 1", 8));
	sample_close(&sample);
}

static void
every_proper_prefix_is_truncated_or_noted(void)
{
	static const char text[] = HEAD "DATA;#1=A('a',(1,2));ENDSEC;";
	struct sample sample;

	for (size_t length = 14; length < sizeof text - 1; length++) {
		sample_open(&sample, text, length);
		CHECK(sample.status == TCS_TRUNCATED);
		sample_close(&sample);
	}
	sample_open(&sample, text, sizeof text - 1);
	CHECK(sample.status == TCS_OK && sample.report.reasons.count == 1);
	CHECK(sample.report.reasons.at[0].severity == REPORT_NOTE);
	sample_close(&sample);
}

static void
what_is_no_step_file_is_refused(void)
{
	static const char *const texts[] = {"", "PK\3\4", "<?xml version='1'?>",
		"ISO-10303-22;", "/* ISO-10303-21;"};
	struct sample sample;

	for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
		sample_open(&sample, texts[i], strlen(texts[i]));
		CHECK(sample.status == TCS_BAD_INPUT);
		sample_close(&sample);
	}
}

static void
too_many_names_exceed_a_limit(void)
{
	char *data = malloc(9000 * 24), *at = data;
	struct sample sample;

	if (!data)
		abort();
	for (int i = 0; i < 9000; i++)
		at += sprintf(at, "#%d=NAME%d();", i, i);
	sample_data(&sample, data);
	CHECK(sample.status == TCS_LIMIT);
	sample_close(&sample);
	free(data);
}

/* ---- parameters ---------------------------------------------------------- */

static struct step_cursor
first_parameters(struct sample *sample, const char *data)
{
	sample_data(sample, data);
	CHECK(sample->status == TCS_OK);
	return step_parameters(&sample->file, 0);
}

static void
every_kind_of_parameter_is_known(void)
{
	static const enum step_kind kinds[] = {STEP_UNSET, STEP_DERIVED,
		STEP_INTEGER, STEP_REAL, STEP_REAL, STEP_STRING,
		STEP_ENUMERATION, STEP_BINARY, STEP_REFERENCE, STEP_LIST,
		STEP_TYPED, STEP_INTEGER};
	struct step_value values[13];
	struct sample sample;
	struct step_cursor cursor = first_parameters(&sample,
		"#1=A($,*,-7,1.5E-3,2.,'it''s',.T.,\"0F\",#12,((),('(',1)),"
		"IFCLABEL('x'),+8);");
	double number;
	int64_t integer;

	CHECK(step_fetch(&cursor, values, 13) == 12);
	CHECK(cursor.state == STEP_OVER);
	for (size_t i = 0; i < 12; i++)
		CHECK(values[i].kind == kinds[i]);
	CHECK(values[2].integer == -7);
	CHECK(values[3].real == 1.5e-3);
	CHECK(step_integer(values + 4, &integer) && integer == 2);
	CHECK(!step_integer(values + 3, &integer));
	CHECK(values[5].length == 5 && !memcmp(values[5].text, "it''s", 5));
	CHECK(step_is(values + 6, "T") && !step_is(values + 6, "TRUE"));
	CHECK(values[7].length == 2 && values[8].reference == 12);
	CHECK(step_is(values + 10, "IFCLABEL"));
	CHECK(step_untyped(values + 10).kind == STEP_STRING);
	CHECK(step_number(values + 11, &number) && number == 8);
	CHECK(!step_number(values + 10, &number));
	CHECK(step_next(&cursor, values) == STEP_END);
	sample_close(&sample);
}

static void
lists_are_entered_or_passed_over(void)
{
	struct step_value list, value;
	struct sample sample;
	struct step_cursor cursor =
		first_parameters(&sample, "#1=A(((1.,2),(3.,/*)*/4.)),'z');");
	double numbers[3];

	CHECK(step_next(&cursor, &list) == STEP_LIST);
	CHECK(step_next(&list.list, &value) == STEP_LIST);
	CHECK(step_next(&list.list, &value) == STEP_LIST);
	CHECK(step_numbers(&value.list, numbers, 3) == 2);
	CHECK(value.list.state == STEP_OVER);
	CHECK(numbers[0] == 3 && numbers[1] == 4);
	CHECK(step_next(&list.list, &value) == STEP_END);
	CHECK(step_next(&cursor, &value) == STEP_STRING);
	CHECK(step_next(&cursor, &value) == STEP_END);
	sample_close(&sample);
}

static void
a_broken_parameter_breaks_its_list_for_ever(void)
{
	static const char *const data[] = {"#1=A(1.#INF);", "#1=A(,);",
		"#1=A(1,);", "#1=A(1;", "#1=A((1;", "#1=A(-);", "#1=A(#);",
		"#1=A(#99999999999999999999);", "#1=A(.T);", "#1=A(\"0F);",
		"#1=A('x'y);", "#1=A(1 2);", "#1=A(nan);", "#1=A(1e999);",
		"#1=A(B 1);", "#1=A(1,(2)3);", "#1=A(\"'\",1);'\");"};

	for (size_t i = 0; i < sizeof data / sizeof *data; i++) {
		struct sample sample;
		struct step_cursor cursor = first_parameters(&sample, data[i]);
		struct step_value value;

		while (step_next(&cursor, &value) > STEP_END)
			;
		CHECK(value.kind == STEP_BAD);
		CHECK(step_next(&cursor, &value) == STEP_BAD);
		sample_close(&sample);
	}
}

static void
a_list_nested_too_deep_is_bad_when_entered(void)
{
	enum { DEEP = 1000000 };
	char *data = malloc(2 * DEEP + 32);
	struct step_value value;
	struct step_cursor cursor, inner;
	struct sample sample;
	unsigned depth = 0;

	if (!data)
		abort();
	strcpy(data, "#1=A(");
	memset(data + 5, '(', DEEP);
	memset(data + 5 + DEEP, ')', DEEP);
	strcpy(data + 5 + 2 * DEEP, ",7);");
	cursor = first_parameters(&sample, data);
	CHECK(step_next(&cursor, &value) == STEP_LIST);
	for (inner = value.list; step_next(&inner, &value) > STEP_END;
		inner = value.list)
		depth++;
	CHECK(value.kind == STEP_BAD && depth == STEP_MAX_NESTING - 1);
	CHECK(step_next(&cursor, &value) == STEP_INTEGER);
	sample_close(&sample);
	free(data);
}

static void
parts_of_complex_instances_are_found(void)
{
	struct sample sample;
	struct step_cursor cursor;
	struct step_value value;

	sample_data(&sample,
		"#1=(NAMED_UNIT(*)LENGTH_UNIT()/**/Si_Unit(.MILLI.,(1)));"
		"#2=SI_UNIT(1);");
	CHECK(step_name_of(&sample.file, 0) == STEP_COMPLEX);
	CHECK(step_instances(&sample.file, STEP_COMPLEX).count == 1);
	CHECK(step_part(&sample.file, 0, "SI_UNIT", &cursor));
	CHECK(step_next(&cursor, &value) == STEP_ENUMERATION);
	CHECK(step_part(&sample.file, 0, "LENGTH_UNIT", &cursor));
	CHECK(step_next(&cursor, &value) == STEP_END);
	CHECK(!step_part(&sample.file, 0, "MASS_UNIT", &cursor));
	CHECK(step_part(&sample.file, 1, "SI_UNIT", &cursor));
	CHECK(!step_part(&sample.file, 1, "LENGTH_UNIT", &cursor));
	cursor = step_parameters(&sample.file, 0);
	CHECK(step_next(&cursor, &value) == STEP_BAD);
	sample_close(&sample);
}

/* ---- strings ------------------------------------------------------------- */

static void
strings_are_decoded(void)
{
	static const struct {
		const char *string, *text;
		unsigned trouble;
	} all[] = {
		{"", "", 0},
		{"it''s", "it's", 0},
		{"a\\\\b", "a\\b", 0},
		{"\\X\\E4x", "\xc3\xa4x", 0},
		{"\\X2\\00E4\\X0\\\\X2\\D83DDE00\\X0\\",
			"\xc3\xa4\xf0\x9f\x98\x80", 0},
		{"\\X4\\0001F600\\X0\\z", "\xf0\x9f\x98\x80z", 0},
		{"\\S\\D", "\xc3\x84", 0},
		{"\\PE\\\\S\\0\\S\\''x", "\xd0\x90\xd0\x87x", 0},
		{"\\PG\\\\S\\a", "\xce\xb1", 0},
		{"a\\N\\b\\F\\\r\nc\td", "abc\td", 0},
		{"\xc3\xa4", "\xc3\xa4", STEP_RAW_BYTES},
		{"\xe4\x80", "\xc3\xa4\xe2\x82\xac", STEP_GUESSED_BYTES},
		{"C:\\temp\\", "C:\\temp\\", STEP_STRAY_BACKSLASH},
		{"\\X\\G0", "\\X\\G0", STEP_STRAY_BACKSLASH},
		{"\\X2\\D800\\X0\\", "\xef\xbf\xbd", STEP_NO_CHARACTER},
		{"\\X\\00", "\xef\xbf\xbd", STEP_NO_CHARACTER},
		{"\\X2\\00E4", "\xc3\xa4", STEP_NO_CHARACTER},
		{"\\X2\\FEFF00E400\\X0\\x", "\xc3\xa4x", STEP_NO_CHARACTER},
		{"\\X4\\00110000\\X0\\", "\xef\xbf\xbd", STEP_NO_CHARACTER},
	};
	struct step_text text = {.count = 0};
	struct tcs_fault fault;

	for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
		unsigned trouble = 0;

		array_clear(&text);
		CHECK(!step_decode(&text, all[i].string, strlen(all[i].string),
			&trouble, &fault));
		CHECK(!strcmp(text.at, all[i].text));
		CHECK(text.count == strlen(text.at));
		CHECK((trouble & all[i].trouble) == all[i].trouble);
		CHECK(all[i].trouble || !trouble);
	}
	array_release(&text);
}

static const struct check_test tests[] = {
	CHECK_TEST(instances_are_found_by_id_and_by_name),
	CHECK_TEST(ids_far_apart_are_found_too),
	CHECK_TEST(the_first_of_two_instances_with_an_id_counts),
	CHECK_TEST(semicolons_hide_in_strings_and_comments),
	CHECK_TEST(what_is_malformed_is_skipped_and_reported),
	CHECK_TEST(several_data_sections_are_one_file),
	CHECK_TEST(the_header_is_read_by_name),
	CHECK_TEST(every_proper_prefix_is_truncated_or_noted),
	CHECK_TEST(what_is_no_step_file_is_refused),
	CHECK_TEST(too_many_names_exceed_a_limit),
	CHECK_TEST(every_kind_of_parameter_is_known),
	CHECK_TEST(lists_are_entered_or_passed_over),
	CHECK_TEST(a_broken_parameter_breaks_its_list_for_ever),
	CHECK_TEST(a_list_nested_too_deep_is_bad_when_entered),
	CHECK_TEST(parts_of_complex_instances_are_found),
	CHECK_TEST(strings_are_decoded),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
