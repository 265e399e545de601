#include "parsers/citygml_xml.h"

#include <stdlib.h>
#include <string.h>

#include "check.h"

/* The events of one element below a root, a word each. */
struct heard {
	struct xml_parser *parser;
	char text[512];
	uint32_t line; /* of the last start */
	struct xml_stretch tag; /* the last one */
	uint64_t end; /* of the last element */
	bool deaf;
};

static enum tcs_status
hear_start(void *context, struct name *name,
	const struct xml_attribute *attributes, size_t count, bool *skip,
	struct tcs_fault *fault)
{
	struct heard *heard = context;
	size_t used = strlen(heard->text);

	(void)fault;
	used += (size_t)snprintf(heard->text + used, sizeof heard->text - used,
		"<%s", name->local);
	for (size_t i = 0; i < count; i++)
		used += (size_t)snprintf(heard->text + used,
			sizeof heard->text - used, " %s=%.*s",
			attributes[i].local, (int)attributes[i].length,
			attributes[i].value);
	heard->line = xml_line(heard->parser);
	xml_place_tag(heard->parser, &heard->tag);
	*skip = !strcmp(name->local, "skip");
	heard->deaf = !strcmp(name->local, "deaf");
	return TCS_OK;
}

static enum tcs_status
hear_end(void *context, struct tcs_fault *fault)
{
	struct heard *heard = context;

	(void)fault;
	heard->deaf = false;
	strcat(heard->text, ">");
	xml_place_end(heard->parser, &heard->end);
	return TCS_OK;
}

static enum tcs_status
hear_text(void *context, const char *bytes, size_t length,
	struct tcs_fault *fault)
{
	struct heard *heard = context;

	(void)fault;
	strncat(heard->text, bytes, length);
	return TCS_OK;
}

static bool
hear_listens(const void *context)
{
	const struct heard *heard = context;

	return !heard->deaf;
}

/* Whether it was read as a whole; the bytes are as they were. */
static bool
element_read(struct heard *heard, const char *element)
{
	static const char root[] = "<r xmlns:g='g'>";
	const struct xml_handler handler = {
		heard, hear_start, hear_end, hear_text, hear_listens};
	const struct xml_limits limits = {.depth = 5, .tag = 4096};
	struct names names = {.version = 2};
	size_t length = strlen(element);
	char *bytes = malloc(length + 1);
	struct tcs_fault fault;
	bool whole = false;

	*heard = (struct heard){.parser = xml_new(&handler, &limits, &names)};
	if (!bytes || !heard->parser)
		abort();
	memcpy(bytes, element, length);
	bytes[length] = '?';
	CHECK(!xml_feed(heard->parser, root, sizeof root - 1, &fault));
	CHECK(xml_is_between(heard->parser));
	heard->text[0] = '\0';
	xml_move(heard->parser, 1000, 10);
	if (xml_feed_element(heard->parser, bytes, length, &whole, &fault))
		whole = false;
	CHECK(!memcmp(bytes, element, length) && bytes[length] == '?');
	CHECK(!whole || xml_is_between(heard->parser));
	xml_free(heard->parser);
	free(bytes);
	return whole;
}

static bool
is_heard_as(const char *element, const char *events)
{
	struct heard heard;

	return element_read(&heard, element) && !strcmp(heard.text, events);
}

static bool
is_refused(const char *element)
{
	struct heard heard;

	return !element_read(&heard, element);
}

static void
tags_values_and_text_are_heard(void)
{
	CHECK(is_heard_as("<a/>", "<a>"));
	CHECK(is_heard_as("<g:a\n b = 'c\"d>' g:e=\"\" ><f />\t1 2</g:a >",
		"<a b=c\"d> e=<f>\t1 2>"));
	CHECK(is_heard_as("<a xmlns:k='u' k:b='1'><k:c/></a>", "<a b=1<c>>"));
	CHECK(is_heard_as(
		"<a><skip b='1'>x<c>y</c></skip>z</a>", "<a<skip b=1z>"));
	CHECK(is_heard_as(
		"<a>\xc3\xa9\xef\xbf\xbd</a>", "<a\xc3\xa9\xef\xbf\xbd>"));
}

static void
names_and_values_of_any_length_end_where_they_end(void)
{
	static const char letters[] = "abcdefghijklmnopqrstuvwxyz";
	static const char ends[] = "<&\n\t\x01";

	for (int length = 1; length < 20; length++) {
		char element[80], events[80];

		snprintf(element, sizeof element, "<%.*s %.*s='%.*s'/>", length,
			letters, length, letters + 1, length, letters + 2);
		snprintf(events, sizeof events, "<%.*s %.*s=%.*s>", length,
			letters, length, letters + 1, length, letters + 2);
		CHECK(is_heard_as(element, events));
		for (const char *end = ends; *end; end++) {
			snprintf(element, sizeof element, "<%.*s b='%.*s%c'/>",
				length, letters, length, letters, *end);
			CHECK(is_refused(element) || *end == '\n' ||
				*end == '\t');
		}
		snprintf(element, sizeof element, "<%.*s></%.*s%c>", length,
			letters, length - 1, letters, '_');
		CHECK(is_refused(element));
	}
}

static void
text_that_nobody_listens_to_is_not_reported(void)
{
	CHECK(is_heard_as(
		"<a>1<deaf>2\r\n&lt;<b/>3</deaf>4</a>", "<a1<deaf<b>3>4>"));
}

static void
lines_end_in_one_character(void)
{
	CHECK(is_heard_as("<a>\r\n1\r\n</a>", "<a\n1\n>"));
	CHECK(is_refused("<a>\r1</a>")); /* too rare to be plain */
}

static void
references_are_what_they_mean(void)
{
	CHECK(is_heard_as(
		"<a>&amp;&lt;b&gt;\r\n&quot;&apos;</a>", "<a&<b>\n\"'>"));
	CHECK(is_heard_as("<a><b/>&amp;amp;</a>", "<a<b>&amp;>"));
	CHECK(is_heard_as("<a>1&#233;&amp;</a>", "<a1\xc3\xa9&>"));
	CHECK(is_refused("<a>&amp</a>"));
	CHECK(is_refused("<a>& amp;</a>"));
	CHECK(is_refused("<a &amp;='1'/>"));
}

static void
what_is_not_plain_is_heard_too(void)
{
	CHECK(is_heard_as("<a b='&lt;'>&amp;<!-- c --><![CDATA[<d>]]></a>",
		"<a b=<&<d>>"));
	CHECK(is_heard_as("<a>]] ></a>", "<a]] >>"));
}

static void
what_is_not_well_formed_is_refused(void)
{
	CHECK(is_refused("<a b='1'c='2'/>"));
	CHECK(is_refused("<a b='1' b='2'/>"));
	CHECK(is_refused("<a b=1/>"));
	CHECK(is_refused("<a b/>"));
	CHECK(is_refused("<a b='<'/>"));
	CHECK(is_refused("<a b='1/>"));
	CHECK(is_refused("<a></b>"));
	CHECK(is_refused("<a></ab>"));
	CHECK(is_refused("<a></a"));
	CHECK(is_refused("<a><b></a></b>"));
	CHECK(is_refused("<1/>"));
	CHECK(is_refused("< a/>"));
	CHECK(is_refused("<a>]]></a>"));
	CHECK(is_refused("<a>\x01</a>"));
	CHECK(is_refused("<a>\xff</a>"));
	CHECK(is_refused("<a>\xef\xbf\xbf</a>"));
	CHECK(is_refused("<a>&b;</a>"));
}

static void
what_is_not_one_element_is_refused(void)
{
	CHECK(is_refused(""));
	CHECK(is_refused("<a>"));
	CHECK(is_refused("</r>"));
	CHECK(is_refused("<a/> "));
	CHECK(is_refused("<a/><b/>"));
	CHECK(is_refused("text<a/>"));
}

static void
depth_has_a_limit(void)
{
	CHECK(is_heard_as("<a><b><c><d/></c></b></a>", "<a<b<c<d>>>>"));
	CHECK(is_refused("<a><b><c><d><e/></d></c></b></a>"));
}

static void
places_are_those_of_the_document(void)
{
	struct heard heard;

	CHECK(element_read(&heard, "<a>\n \n<b\n c='1'\n>1</b></a>"));
	CHECK(heard.line == 14);
	CHECK(heard.tag.at == 1006 && heard.tag.end == 1017);
	CHECK(heard.tag.line == 12);
	CHECK(heard.end == 1026);
	CHECK(element_read(&heard, "<a>\n&lt;\n<b\n c='1'\n>1</b></a>"));
	CHECK(heard.line == 14);
	CHECK(heard.tag.at == 1009 && heard.tag.end == 1020);
	CHECK(heard.tag.line == 12);
	CHECK(heard.end == 1029);
}

static const struct check_test tests[] = {
	CHECK_TEST(tags_values_and_text_are_heard),
	CHECK_TEST(names_and_values_of_any_length_end_where_they_end),
	CHECK_TEST(text_that_nobody_listens_to_is_not_reported),
	CHECK_TEST(lines_end_in_one_character),
	CHECK_TEST(references_are_what_they_mean),
	CHECK_TEST(what_is_not_plain_is_heard_too),
	CHECK_TEST(what_is_not_well_formed_is_refused),
	CHECK_TEST(what_is_not_one_element_is_refused),
	CHECK_TEST(depth_has_a_limit),
	CHECK_TEST(places_are_those_of_the_document),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
