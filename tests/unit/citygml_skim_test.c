#include "parsers/citygml_skim.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "check.h"

static char name[] = "/tmp/tessera-skim-XXXXXX";
static struct document_parts parts;
static const char *text; /* of the last document */

static enum skim_result
skimmed(const char *document, size_t length)
{
	FILE *file = fopen(name, "wb");
	enum skim_result result = SKIM_NONE;
	struct tcs_fault fault;
	struct input input;

	text = document;
	CHECK(file && fwrite(document, 1, length, file) == length);
	fclose(file);
	parts_release(&parts);
	CHECK(!input_open(&input, name, &fault));
	CHECK(!skim_appearances(&input, &parts, &result, &fault));
	input_close(&input);
	return result;
}

static enum skim_result
skim(const char *document)
{
	return skimmed(document, strlen(document));
}

static bool
part_is(size_t index, const char *expected, uint64_t line)
{
	const struct raw_place *place = &parts.places.at[index];
	size_t length = strlen(expected);

	return index < parts.places.count && place->end - place->at == length &&
		place->line == line &&
		!memcmp(text + place->at, expected, length);
}

static void
members_of_the_model_are_found(void)
{
	CHECK(skim("<?xml version='1.0'?>\n<m:CityModel a='>'\n>"
		   "<m:cityObjectMember><b c=\"/>\"/></m:cityObjectMember>\n"
		   "<app:appearanceMember ><a/></app:appearanceMember>"
		   "<x/><appearanceMember/></m:CityModel>\n") == SKIM_PARTS);
	CHECK(parts.places.count == 2);
	CHECK(part_is(
		0, "<app:appearanceMember ><a/></app:appearanceMember>", 4));
	CHECK(part_is(1, "<appearanceMember/>", 4));
	CHECK(!strncmp(text + parts.head_end, "<m:cityObject", 13));
}

/* They name the coordinate system. */
static void
bounds_of_the_model_are_found(void)
{
	CHECK(skim("<M><g:boundedBy><E/></g:boundedBy><a><boundedBy/></a>"
		   "<a:appearanceMember/></M>") == SKIM_PARTS);
	CHECK(parts.places.count == 2);
	CHECK(part_is(0, "<g:boundedBy><E/></g:boundedBy>", 1));
}

static void
neighbours_are_one_part(void)
{
	CHECK(skim("<M><a:appearanceMember/>\n <a:appearanceMember>x"
		   "</a:appearanceMember> </M>") == SKIM_PARTS);
	CHECK(parts.places.count == 1);
	CHECK(part_is(0,
		"<a:appearanceMember/>\n <a:appearanceMember>x"
		"</a:appearanceMember>",
		1));
}

static void
what_only_looks_like_one_is_none(void)
{
	CHECK(skim("<M><a>appearanceMember</a></M>") == SKIM_NONE);
	CHECK(parts.places.count == 0);
	CHECK(skim("<M><!-- <appearanceMember/> -->"
		   "<a><![CDATA[</a><appearanceMember>]]></a>"
		   "<?p <appearanceMember/>?><a><appearanceMember/></a>"
		   "<appearanceMembers/></M>") == SKIM_NONE);
	CHECK(parts.places.count == 0);
	CHECK(skim("<M><a/></M>") == SKIM_NONE);
}

static void
members_are_left_at_their_own_end(void)
{
	CHECK(skim("<M><c:cityObjectMember>"
		   "<!-- </c:cityObjectMember><appearanceMember/> -->"
		   "<x>cityObjectMember/cityObjectMember</x>"
		   "<c:cityObjectMember a='>'><appearanceMember/>"
		   "</c:cityObjectMember><cityObjectMember b='/>'/>"
		   "<cityObjectMembers a='cityObjectMember'/>"
		   "<![CDATA[</c:cityObjectMember>]]><?</cityObjectMember>?>"
		   "<appearanceMember/></c:cityObjectMember >"
		   "<a:appearanceMember/></M>") == SKIM_PARTS);
	CHECK(parts.places.count == 1);
	CHECK(part_is(0, "<a:appearanceMember/>", 1));
	CHECK(skim("<M><cityObjectMember><appearanceMember/></M>") ==
		SKIM_UNSURE);
	CHECK(skim("<M><cityObjectMember><!DOCTYPE appearanceMember>"
		   "</cityObjectMember></M>") == SKIM_UNSURE);
}

static void
what_is_not_certain_is_not_claimed(void)
{
	CHECK(skim("<!DOCTYPE M><M><appearanceMember/></M>") == SKIM_UNSURE);
	CHECK(skim("<M><appearanceMember></M>") == SKIM_UNSURE);
	CHECK(skim("<M><appearanceMember/></M></M>") == SKIM_UNSURE);
	CHECK(skim("<M><appearanceMember/></M><M></M>") == SKIM_UNSURE);
	CHECK(skim("<M><appearanceMember/><") == SKIM_UNSURE);
	CHECK(skim("<?xml version='1.0' encoding='ISO-2022-JP'?>"
		   "<M><appearanceMember/></M>") == SKIM_UNSURE);
	CHECK(skim("<?xml version='1.0' encoding='iso-8859-15'?>"
		   "<M><appearanceMember/></M>") == SKIM_PARTS);
	CHECK(skimmed("<\0M\0", 4) == SKIM_UNSURE);
}

/* Longer than what is read at once, cut anywhere. */
static void
pieces_do_not_matter(void)
{
	static const char member[] =
		"<a:appearanceMember><!--\n > --></a:appearanceMember>";
	static char document[300000];
	uint64_t count = 0;
	size_t length = (size_t)sprintf(document, "<M>");

	for (; length < sizeof document - 200; count++)
		length += (size_t)sprintf(document + length, "<b c='%*s>'/>%s",
			(int)(count % 61), "", member);
	sprintf(document + length, "</M>");
	CHECK(skim(document) == SKIM_PARTS);
	CHECK(parts.places.count == count);
	for (size_t i = 0; i < count; i++)
		CHECK(part_is(i, member, i + 1));
}

static const struct check_test tests[] = {
	CHECK_TEST(members_of_the_model_are_found),
	CHECK_TEST(bounds_of_the_model_are_found),
	CHECK_TEST(neighbours_are_one_part),
	CHECK_TEST(what_only_looks_like_one_is_none),
	CHECK_TEST(members_are_left_at_their_own_end),
	CHECK_TEST(what_is_not_certain_is_not_claimed),
	CHECK_TEST(pieces_do_not_matter),
	{0},
};

int
main(void)
{
	int result;

	close(mkstemp(name));
	result = check_run(tests);
	unlink(name);
	parts_release(&parts);
	return result;
}
