#include "report.h"

#include <stdlib.h>
#include <string.h>

#include "check.h"

/* What a report prints, to be freed. */
static char *
printed(const struct report *report)
{
	char *text = NULL;
	size_t size;
	FILE *file = open_memstream(&text, &size);

	report_print(report, "prog", file);
	fclose(file);
	return text;
}

static char *
written(const struct report *report)
{
	char name[] = "/tmp/tessera-report-XXXXXX";
	struct tcs_fault fault;
	char *text = calloc(1, 4096);
	int fd = mkstemp(name);
	FILE *file = fdopen(fd, "r");

	CHECK(!report_write(report, "prog", name, &fault));
	file = freopen(name, "r", file);
	CHECK(file && fread(text, 1, 4095, file) > 0);
	fclose(file);
	remove(name);
	return text;
}

static void
note(struct report *report, enum report_severity severity, const char *item,
	const char *reason, const char *id)
{
	struct tcs_fault fault;

	CHECK(!report_item(
		report, severity, item, reason, id, TCS_NOWHERE, &fault));
}

static void
counts_add_up(void)
{
	struct report report = {0};
	struct tcs_fault fault;

	CHECK(!report_add(&report, "polygons", 3, &fault));
	CHECK(!report_add(&report, "rings", 1, &fault));
	CHECK(!report_add(&report, "polygons", 4, &fault));
	CHECK(report.counts.count == 2);
	CHECK(report.counts.at[0].count == 7);
	report_release(&report);
}

static void
items_are_counted_by_reason_with_three_examples(void)
{
	static const char *const ids[] = {"a", "b", "c", "d"};
	struct report report = {0};
	char *text;

	for (int i = 0; i < 4; i++)
		note(&report, REPORT_SKIPPED, "polygon", "zero area", ids[i]);
	note(&report, REPORT_REPAIRED, "geometry", "open ring", "e");
	note(&report, REPORT_NOTE, "feature", "no id", NULL);
	text = printed(&report);
	CHECK(!strcmp(text,
		"prog: 4 polygons skipped: zero area (a, b, c, ...)\n"
		"prog: 1 geometry repaired: open ring (e)\n"
		"prog: 1 feature: no id\n"));
	free(text);
	report_release(&report);
}

static void
an_item_without_an_id_is_named_by_its_place(void)
{
	struct report report = {0};
	struct tcs_fault fault;

	CHECK(!report_item(
		&report, REPORT_SKIPPED, "ring", "open", NULL, 17, &fault));
	CHECK(!report_item(
		&report, REPORT_SKIPPED, "ring", "open", "", 18, &fault));
	CHECK(!strcmp(report.reasons.at[0].examples[0], "at 17"));
	CHECK(!strcmp(report.reasons.at[0].examples[1], "at 18"));
	report_release(&report);
}

static void
control_characters_do_not_reach_the_terminal(void)
{
	struct report report = {0};
	char *text;

	note(&report, REPORT_SKIPPED, "ring", "open",
		"a\033[2Jb\n\xc2\x9bz\xff");
	text = printed(&report);
	CHECK(!strcmp(text, "prog: 1 ring skipped: open (a?[2Jb??z?)\n"));
	free(text);
	report_release(&report);
}

/* Merging reports of items in order is noting all in one. */
static void
merged_parts_are_the_whole(void)
{
	struct report whole = {0}, sum = {0}, part = {0};
	struct tcs_fault fault;
	char *a, *b;

	for (int i = 0; i < 6; i++) {
		const char id[] = {(char)('p' + i), '\0'};
		const char *reason = i % 2 ? "odd" : "even";

		report_clear(&part);
		note(&whole, REPORT_SKIPPED, "ring", reason, id);
		note(&part, REPORT_SKIPPED, "ring", reason, id);
		CHECK(!report_add(&whole, "rings", 1, &fault));
		CHECK(!report_add(&part, "rings", 1, &fault));
		CHECK(!report_merge(&sum, &part, &fault));
	}
	a = written(&whole);
	b = written(&sum);
	CHECK(!strcmp(a, b));
	free(a);
	free(b);
	report_release(&whole);
	report_release(&sum);
	report_release(&part);
}

static void
strict_fails_on_what_was_skipped_only(void)
{
	struct report report = {0};
	struct tcs_fault fault;

	note(&report, REPORT_NOTE, "file", "no srsName", NULL);
	note(&report, REPORT_REPAIRED, "polygon", "bow tie", "x");
	CHECK(report_strict(&report, &fault) == TCS_OK);
	note(&report, REPORT_SKIPPED, "polygon", "zero area", "y");
	CHECK(report_strict(&report, &fault) == TCS_BAD_INPUT);
	CHECK(!strcmp(fault.text, "polygon y: zero area"));
	report_release(&report);
}

static void
the_json_is_escaped(void)
{
	struct report report = {0};
	struct tcs_fault fault;
	char *text;

	CHECK(!report_add(&report, "rings", UINT64_MAX, &fault));
	note(&report, REPORT_SKIPPED, "ring", "open", "a\"\\\n\xfe");
	note(&report, REPORT_NOTE, "file", "no srsName", NULL);
	text = written(&report);
	CHECK(strstr(text, "\"rings\": 18446744073709551615}") != NULL);
	CHECK(strstr(text, "\"examples\": [\"a\\\"\\\\\\u000a\\ufffd\"]") !=
		NULL);
	CHECK(strstr(text, "\"repaired\": []") != NULL);
	CHECK(strstr(text, "\"examples\": []}]}\n") != NULL);
	free(text);
	report_release(&report);
}

static void
listed_items_are_all_there_and_merged_in_order(void)
{
	struct report report = {0}, more = {0};
	struct tcs_fault fault;
	char id[8], *text;

	for (int i = 0; i < 5; i++) {
		snprintf(id, sizeof id, "w%d", i);
		CHECK(!report_listed(i < 3 ? &report : &more, "surface", "gone",
			id, "WallSurface", &fault));
	}
	note(&more, REPORT_NOTE, "object", "gone", "b");
	CHECK(!report_merge(&report, &more, &fault));
	text = written(&report);
	CHECK(strstr(text,
		"\"examples\": [\"w0\", \"w1\", \"w2\"],\n   \"list\": [\n"
		"    {\"id\": \"w0\", \"class\": \"WallSurface\"},\n"));
	CHECK(strstr(text,
		"    {\"id\": \"w3\", \"class\": \"WallSurface\"},\n"
		"    {\"id\": \"w4\", \"class\": \"WallSurface\"}]}"));
	CHECK(strstr(text, "\"examples\": [\"b\"]}"));
	free(text);
	report_release(&report);
	report_release(&more);
}

static void
a_list_has_an_end(void)
{
	struct report report = {0};
	struct tcs_fault fault;

	for (int i = 0; i < REPORT_ENTRIES + 5; i++)
		CHECK(!report_listed(
			&report, "surface", "gone", "w", "Window", &fault));
	CHECK(report.entries.count == REPORT_ENTRIES);
	CHECK(report.reasons.at[0].count == REPORT_ENTRIES + 5);
	report_release(&report);
}

static const struct check_test tests[] = {
	CHECK_TEST(counts_add_up),
	CHECK_TEST(items_are_counted_by_reason_with_three_examples),
	CHECK_TEST(an_item_without_an_id_is_named_by_its_place),
	CHECK_TEST(control_characters_do_not_reach_the_terminal),
	CHECK_TEST(merged_parts_are_the_whole),
	CHECK_TEST(strict_fails_on_what_was_skipped_only),
	CHECK_TEST(the_json_is_escaped),
	CHECK_TEST(listed_items_are_all_there_and_merged_in_order),
	CHECK_TEST(a_list_has_an_end),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
