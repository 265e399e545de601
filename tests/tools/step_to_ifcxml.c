/*
 * step_to_ifcxml 2|4 <FILE.ifc: a STEP file of IFC in one of the spellings of
 * ifcXML: "2", each attribute an element and each instance by itself; "4",
 * simple values as XML attributes, and each instance where it is used first.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "parsers/ifc_file.h"
#include "parsers/step_load.h"
#include "parsers/step_string.h"

enum { MOST_ATTRIBUTES = 64, LONGEST = 64 };

static const char *const own_attributes[IFC_ENTITIES] = {
#define X(name, super, versions, attributes) [IFC_##name] = attributes,
	IFC_ROWS(X)
#undef X
};

static struct step_file step;
static struct ifc_file file;
static bool *written; /* instances */
static bool nests;

static void
die(const char *what)
{
	fprintf(stderr, "step_to_ifcxml: %s\n", what);
	exit(1);
}

/* The names of the attributes, by position. */
static int
attribute_names(enum ifc_entity entity, char names[MOST_ATTRIBUTES][LONGEST])
{
	for (enum ifc_entity at = entity; at != IFC_NONE;
		at = ifc_super(file.version, at)) {
		const char *text = own_attributes[at];

		while (*text) {
			char name[LONGEST];
			size_t length = strcspn(text, " :");
			int position;

			snprintf(name, sizeof name, "%.*s", (int)length, text);
			position = ifc_attribute(file.version, entity, name);
			if (position >= 0)
				snprintf(names[position], LONGEST, "%s", name);
			text += strcspn(text, " ");
			text += strspn(text, " ");
		}
	}
	return (int)ifc_attribute_count(file.version, entity);
}

static void
put_text(const struct step_value *value)
{
	struct step_text text = {0};
	struct tcs_fault fault;
	unsigned trouble = 0;

	if (step_decode(&text, value->text, value->length, &trouble, &fault))
		die("out of memory");
	for (const char *at = text.at; *at; at++)
		if (*at == '<' || *at == '&' || *at == '"')
			printf("&#%d;", *at);
		else
			putchar(*at);
	array_release(&text);
}

/* A value that is no list and no link; without quotes. */
static void
put_simple(const struct step_value *value)
{
	if (value->kind == STEP_STRING)
		put_text(value);
	else if (step_is(value, "T") || step_is(value, "F"))
		printf("%s", step_is(value, "T") ? "true" : "false");
	else if (step_is(value, "U"))
		printf("unknown");
	else if (value->kind == STEP_ENUMERATION)
		for (size_t i = 0; i < value->length; i++)
			putchar(value->text[i] >= 'A' && value->text[i] <= 'Z'
					? value->text[i] - 'A' + 'a'
					: value->text[i]);
	else
		printf("%.*s", (int)value->length, value->text);
}

static bool
is_simple(const struct step_value *value)
{
	return value->kind > STEP_DERIVED && value->kind < STEP_REFERENCE;
}

/* Numbers, or lists of such. */
static bool
is_numbers(const struct step_value *value)
{
	struct step_value copy = *value, item;

	if (value->kind != STEP_LIST)
		return false;
	while (step_next(&copy.list, &item) > STEP_END)
		if (item.kind != STEP_INTEGER && item.kind != STEP_REAL &&
			!is_numbers(&item))
			return false;
	return true;
}

static bool
is_ragged(const char *attribute)
{
	return !strcmp(attribute, "InnerCoordIndices");
}

static bool
is_in_tag(const struct step_value *value, const char *attribute)
{
	return is_simple(value) || (is_numbers(value) && !is_ragged(attribute));
}

static void
put_numbers(const struct step_value *list)
{
	struct step_value copy = *list, item;

	while (step_next(&copy.list, &item) > STEP_END)
		if (item.kind == STEP_LIST)
			put_numbers(&item);
		else
			printf("%.*s ", (int)item.length, item.text);
}

/* Lists of numbers in a list that may differ in length. */
static void
put_sequences(const struct step_value *list)
{
	struct step_value copy = *list, item;

	while (step_next(&copy.list, &item) > STEP_END) {
		printf("<Seq-IfcPositiveInteger-wrapper>");
		put_numbers(&item);
		printf("</Seq-IfcPositiveInteger-wrapper>");
	}
}

/* The name of an entity without its "IFC"; "" for one that has none. */
static const char *
short_name(enum ifc_entity entity)
{
	const char *name = ifc_name(entity);

	return *name ? name + 3 : name;
}

static void put_instance(uint32_t instance, const char *element);

static void
put_link(uint32_t target, const char *element, bool typed)
{
	char spelled[LONGEST];

	snprintf(spelled, sizeof spelled, "Ifc%s",
		short_name(ifc_entity_of(&file, target)));
	if (typed)
		element = NULL;
	if (nests && !written[target])
		put_instance(target, element);
	else if (element)
		printf("<%s xsi:type=\"%s\" xsi:nil=\"true\" href=\"i%u\"/>\n",
			element, spelled, target);
	else
		printf("<%s xsi:nil=\"true\" %s=\"i%u\"/>\n", spelled,
			nests ? "href" : "ref", target);
}

/* What stands in a list or a select. */
static void
put_item(const struct step_value *value)
{
	struct step_value inner = step_untyped(value), item;

	if (value->kind == STEP_REFERENCE) {
		put_link(step_target(&step, value), NULL, true);
	} else if (value->kind == STEP_TYPED) {
		printf("<Ifc%.*s%s>", (int)value->length - 3, value->text + 3,
			nests ? "-wrapper" : "");
		if (inner.kind == STEP_LIST)
			put_numbers(&inner);
		else
			put_simple(&inner);
		printf("</Ifc%.*s%s>\n", (int)value->length - 3,
			value->text + 3, nests ? "-wrapper" : "");
	} else if (value->kind == STEP_LIST) {
		while (step_next(&inner.list, &item) > STEP_END)
			put_item(&item);
	} else {
		printf("<ex:string-wrapper>");
		put_simple(value);
		printf("</ex:string-wrapper>\n");
	}
}

/* The rows and columns of a list of lists of links. */
static void
put_size(const struct step_value *value)
{
	struct step_value copy = *value, row, item;
	int rows = 0, columns = 0;

	while (copy.kind == STEP_LIST &&
		step_next(&copy.list, &row) == STEP_LIST)
		for (rows++, columns = 0;
			step_next(&row.list, &item) > STEP_END;)
			columns++;
	if (rows && !is_numbers(value))
		printf(" ex:arraySize=\"%d %d\"", rows, columns);
}

static void
put_element(const struct step_value *value, const char *name)
{
	if (nests && value->kind == STEP_REFERENCE) {
		put_link(step_target(&step, value), name, false);
		return;
	}
	printf("<%s%s", name,
		value->kind == STEP_LIST && !nests ? " ex:cType=\"list\"" : "");
	put_size(value);
	printf(">");
	if (is_ragged(name))
		put_sequences(value);
	else if (is_numbers(value))
		put_numbers(value);
	else if (is_simple(value))
		put_simple(value);
	else
		put_item(value);
	printf("</%s>\n", name);
}

static void
put_instance(uint32_t instance, const char *element)
{
	enum ifc_entity entity = ifc_entity_of(&file, instance);
	char names[MOST_ATTRIBUTES][LONGEST] = {""}, name[LONGEST];
	int count = attribute_names(entity, names);
	struct step_cursor cursor = step_parameters(&step, instance);
	struct step_value values[MOST_ATTRIBUTES];

	snprintf(name, sizeof name, "Ifc%s", short_name(entity));
	written[instance] = true;
	count = (int)step_fetch(&cursor, values, (size_t)count);
	printf("<%s", element ? element : name);
	if (element)
		printf(" xsi:type=\"%s\"", name);
	printf(" id=\"i%u\"", instance);
	for (int i = 0; i < count && nests; i++)
		if (is_in_tag(values + i, names[i])) {
			printf(" %s=\"", names[i]);
			if (is_simple(values + i))
				put_simple(values + i);
			else
				put_numbers(values + i);
			printf("\"");
		}
	printf(">\n");
	for (int i = 0; i < count; i++)
		if (values[i].kind > STEP_DERIVED &&
			!(nests && is_in_tag(values + i, names[i])))
			put_element(values + i, names[i]);
	printf("</%s>\n", element ? element : name);
}

int
main(int argc, char **argv)
{
	struct step_bytes bytes = {0};
	struct report report = {0};
	struct input input = {0};
	struct tcs_fault fault;

	nests = argc > 1 && *argv[1] == '4';
	if (input_open(&input, NULL, &fault) ||
		step_load(&bytes, &input, 0, 1, &fault) ||
		step_index(&step, bytes.at, bytes.count, &report, &fault) ||
		ifc_open(&file, &step, &fault))
		die(fault.text);
	written = calloc(step.instances.count, sizeof *written);
	if (!written)
		die("out of memory");
	printf("<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<%s "
	       "xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" "
	       "xmlns:ex=\"urn:iso:std:iso:10303:-28\" xmlns=\"urn:%s\">\n",
		nests ? "ifcXML" : "uos",
		file.version == IFC_2X3 ? "IFC2X3" : "IFC4");
	for (uint32_t i = 0; i < step.instances.count; i++)
		if (!written[i] && ifc_entity_of(&file, i) != IFC_NONE)
			put_instance(i, NULL);
	printf("</%s>\n", nests ? "ifcXML" : "uos");
	free(written);
	ifc_close(&file);
	step_release(&step);
	array_release(&bytes);
	report_release(&report);
	input_close(&input);
	return 0;
}
