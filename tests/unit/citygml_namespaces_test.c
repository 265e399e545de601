#include "parsers/citygml_namespaces.h"

#include <stdio.h>
#include <string.h>

#include "check.h"

/* An element or attribute as the parser would name it. */
struct document {
	struct namespaces namespaces;
	struct names names;
	xmlDictPtr dict;
};

static struct document
document_new(void)
{
	return (struct document){.names.version = 2, .dict = xmlDictCreate()};
}

static void
document_release(struct document *document)
{
	names_release(&document->names);
	namespaces_release(&document->namespaces);
	xmlDictFree(document->dict);
}

static struct spelling *
spell(struct document *document, const char *name)
{
	return spelling_find(&document->namespaces,
		(const char *)xmlDictLookup(
			document->dict, (const xmlChar *)name, -1));
}

static enum tcs_status
declare(struct document *document, const char *attribute, const char *uri,
	unsigned depth)
{
	struct tcs_fault fault;
	const struct spelling *spelling = spell(document, attribute);

	CHECK(spelling->declares);
	return namespace_declare(
		&document->namespaces, spelling, uri, depth, &fault);
}

static const struct name *
mean(struct document *document, const char *name)
{
	return spelling_mean(
		&document->namespaces, &document->names, spell(document, name));
}

static bool
parts_are(struct document *document, const char *name, const char *prefix,
	const char *local)
{
	const struct spelling *spelling = spell(document, name);

	return !strcmp(spelling->prefix ? spelling->prefix : "", prefix) &&
		!strcmp(spelling->local, local);
}

static void
names_fall_into_prefix_and_local_name(void)
{
	struct document document = document_new();

	CHECK(parts_are(&document, "gml:posList", "gml", "posList"));
	CHECK(parts_are(&document, "posList", "", "posList"));
	CHECK(parts_are(&document, "a:b:c", "a", "b:c"));
	CHECK(parts_are(&document, ":a", "", ":a"));
	CHECK(parts_are(&document, "a:", "", "a:"));
	CHECK(parts_are(&document, "a:1", "", "a:1"));
	CHECK(!spell(&document, "x")->declares);
	CHECK(!spell(&document, "xmlnsx")->declares);
	CHECK(!spell(&document, "a:xmlns")->declares);
	document_release(&document);
}

static void
a_declaration_holds_until_its_element_ends(void)
{
	struct document document = document_new();
	const char gml[] = "http://www.opengis.net/gml";
	const struct name *outside, *within;

	CHECK(!declare(&document, "xmlns:g", gml, 1));
	outside = mean(&document, "g:Solid");
	CHECK(outside->kind == NAME_SOLID && !strcmp(outside->uri, gml));
	CHECK(!declare(&document, "xmlns:g", "urn:x", 2));
	within = mean(&document, "g:Solid");
	CHECK(within->kind == NAME_OTHER && !strcmp(within->uri, "urn:x"));
	namespaces_leave(&document.namespaces, 3);
	CHECK(mean(&document, "g:Solid") == within);
	namespaces_leave(&document.namespaces, 2);
	CHECK(mean(&document, "g:Solid") == outside);
	namespaces_leave(&document.namespaces, 1);
	CHECK(mean(&document, "g:Solid")->uri == NULL);
	document_release(&document);
}

static void
the_default_can_be_taken_back(void)
{
	struct document document = document_new();

	CHECK(!declare(&document, "xmlns", "urn:x", 1));
	CHECK(!strcmp(mean(&document, "a")->uri, "urn:x"));
	CHECK(!declare(&document, "xmlns", "", 2));
	CHECK(mean(&document, "a")->uri == NULL);
	namespaces_leave(&document.namespaces, 2);
	CHECK(!strcmp(mean(&document, "a")->uri, "urn:x"));
	document_release(&document);
}

static void
what_must_not_be_declared_is_not(void)
{
	struct document document = document_new();

	CHECK(!declare(&document, "xmlns:xml", "urn:x", 1));
	CHECK(!declare(&document, "xmlns:xmlns", "urn:x", 1));
	CHECK(!declare(&document, "xmlns:a", "", 1));
	CHECK(document.namespaces.bindings.count == 0);
	document_release(&document);
}

static void
a_declaration_said_again_changes_nothing(void)
{
	struct document document = document_new();

	CHECK(!declare(&document, "xmlns:a", "urn:x", 1));
	CHECK(!declare(&document, "xmlns:a", "urn:x", 2));
	CHECK(document.namespaces.bindings.count == 1);
	namespaces_leave(&document.namespaces, 2);
	CHECK(!strcmp(mean(&document, "a:b")->uri, "urn:x"));
	document_release(&document);
}

static void
declarations_in_force_are_bounded(void)
{
	struct document document = document_new();
	char prefix[32];

	for (int i = 0; i < MAX_BINDINGS; i++) {
		snprintf(prefix, sizeof prefix, "xmlns:a%d", i);
		CHECK(!declare(&document, prefix, "urn:x", 1));
	}
	CHECK(declare(&document, "xmlns:b", "urn:x", 2) == TCS_LIMIT);
	namespaces_leave(&document.namespaces, 1);
	CHECK(!declare(&document, "xmlns:b", "urn:x", 2));
	document_release(&document);
}

static const struct check_test tests[] = {
	CHECK_TEST(names_fall_into_prefix_and_local_name),
	CHECK_TEST(a_declaration_holds_until_its_element_ends),
	CHECK_TEST(the_default_can_be_taken_back),
	CHECK_TEST(what_must_not_be_declared_is_not),
	CHECK_TEST(a_declaration_said_again_changes_nothing),
	CHECK_TEST(declarations_in_force_are_bounded),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
