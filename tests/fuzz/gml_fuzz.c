/*
 * Any stream as CityGML. The first byte chooses the version; behind it stand
 * the bytes of a stream, its checksums mended, or of its text twin where they
 * begin with a brace. Whatever comes out, libxml2 reads it: well formed, every
 * prefix declared, no id twice, and no polygon linked to that is not there.
 */
#include <libxml/hash.h>
#include <libxml/parser.h>
#include <libxml/tree.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "parsers/json_build.h"
#include "tests/fuzz/mend_sums.h"
#include "writers/citygml_document.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

struct run {
	struct gml_palette palette;
	struct compose_plan plan;
	struct composer composer;
	struct composed composed;
	struct document document;
	struct report report;
	struct tcs_record head_record; /* lends the head */
	struct tcs_head head;
	struct tcs_palette more;
	struct tcs_tally tally;
	bool began;
};

/* ---- what came out ----------------------------------------------------------- */

static xmlNode *
next_node(xmlNode *node)
{
	if (node->children)
		return node->children;
	while (node && !node->next)
		node = node->parent;
	return node ? node->next : NULL;
}

static void
add_id(xmlHashTable *ids, xmlNode *node)
{
	xmlChar *id = xmlGetProp(node, BAD_CAST "id");

	if (id && node->properties && node->properties->ns &&
		xmlHashAddEntry(ids, id, node))
		abort();
	xmlFree(id);
}

static void
follow_link(xmlHashTable *ids, xmlNode *node)
{
	xmlChar *link = xmlGetNsProp(
		node, BAD_CAST "href", BAD_CAST "http://www.w3.org/1999/xlink");

	if (link &&
		(xmlStrEqual(node->name, BAD_CAST "surfaceMember") ||
			xmlStrEqual(node->name, BAD_CAST "baseSurface")) &&
		!xmlHashLookup(ids, link + 1))
		abort();
	xmlFree(link);
}

static void
check_document(const char *text, size_t length)
{
	xmlParserCtxt *context = xmlNewParserCtxt();
	xmlHashTable *ids = xmlHashCreate(64);
	xmlDoc *document;

	if (!context || !ids)
		abort();
	document = xmlCtxtReadMemory(context, text, (int)length, "out", NULL,
		XML_PARSE_HUGE | XML_PARSE_NONET | XML_PARSE_NOERROR);
	if (!document || !context->nsWellFormed)
		abort();
	for (xmlNode *node = document->children; node; node = next_node(node))
		if (node->type == XML_ELEMENT_NODE)
			add_id(ids, node);
	for (xmlNode *node = document->children; node; node = next_node(node))
		if (node->type == XML_ELEMENT_NODE)
			follow_link(ids, node);
	xmlHashFree(ids, NULL);
	xmlFreeDoc(document);
	xmlFreeParserCtxt(context);
}

static void
finish(struct run *run)
{
	struct tcs_fault fault;
	char *text = NULL;
	size_t length = 0;
	FILE *file = open_memstream(&text, &length);

	if (!file)
		abort();
	if (document_end(&run->document, &run->head, file, 0, &fault))
		abort();
	fclose(file);
	check_document(text, length);
	free(text);
}

/* ---- what goes in ------------------------------------------------------------ */

static bool
begin(struct run *run, struct tcs_record *record)
{
	struct tcs_fault fault;
	const struct tcs_crs *crs;

	run->head_record = *record;
	*record = (struct tcs_record){0};
	if (run->head_record.type != TCS_HEAD ||
		head_decode(&run->head, &run->head_record, &fault))
		return false;
	crs = &run->head.crs.at[0];
	run->plan.palette = &run->palette;
	run->plan.north_first = (crs->flags & TCS_CRS_NORTH_FIRST) != 0;
	run->plan.geographic = crs->kind == TCS_CRS_GEOGRAPHIC;
	run->plan.metres = crs->metres_per_unit;
	run->plan.metres_up = crs->metres_per_unit_up;
	run->began = !document_begin(
		&run->document, &run->plan, &run->report, &fault);
	return run->began;
}

static void
count(struct run *run, const struct tcs_record *record)
{
	run->tally.objects += record->type == TCS_OBJECT;
	run->tally.prototypes += record->type == TCS_PROTOTYPE;
	run->tally.images += run->more.images.count;
	run->tally.materials += run->more.materials.count;
	palette_clear(&run->more);
}

/* False where the record is not sound. */
static bool
take(struct run *run, struct tcs_record *record)
{
	struct tcs_fault fault;
	enum tcs_status status = TCS_OK;

	if (!run->began)
		return begin(run, record);
	record->before = run->tally;
	if (record->type == TCS_PALETTE) {
		status = palette_decode(&run->more, record, &fault);
		if (!status)
			status = gml_palette_add(&run->palette, &run->more,
				run->tally.objects, &fault);
	} else if (record->type == TCS_OBJECT ||
		record->type == TCS_PROTOTYPE) {
		status = record->type == TCS_OBJECT
			? compose_object(&run->composer, record, NULL,
				  &run->composed, &fault)
			: compose_prototype(&run->composer, record, NULL,
				  &run->composed, &fault);
		if (!status &&
			document_add(
				&run->document, &run->composed, record, &fault))
			abort();
	}
	if (!status)
		count(run, record);
	return !status;
}

static void
take_lines(struct run *run, const char *at, size_t size)
{
	struct json_builder builder = {0};
	struct tcs_record record = {0};
	const char *end = at + size;
	uint64_t number = 0;
	bool sound = true;

	while (at < end && sound) {
		const char *stop = memchr(at, '\n', (size_t)(end - at));
		struct tcs_tally claimed;
		struct tcs_fault fault;

		stop = stop ? stop : end;
		record.before = run->tally;
		sound = !json_build_line(&builder, at, (size_t)(stop - at),
				++number, &record, &claimed, &fault) &&
			take(run, &record);
		at = stop + (stop < end);
	}
	json_builder_release(&builder);
	record_release(&record);
}

static void
take_stream(struct run *run, const uint8_t *data, size_t size)
{
	unsigned char *bytes = malloc(size);
	struct tcs_record record = {0};
	struct tcs_reader reader;
	struct tcs_fault fault;
	FILE *file;

	if (!bytes)
		return;
	memcpy(bytes, data, size);
	mend_sums(bytes, size);
	file = fmemopen(bytes, size, "rb");
	if (file) {
		reader_init(&reader, file);
		reader.max_record = 1 << 20;
		while (!reader.ended &&
			!reader_next(&reader, &record, &fault) &&
			take(run, &record))
			;
		reader_release(&reader);
		fclose(file);
	}
	record_release(&record);
	free(bytes);
}

/* Made once: it costs more than a small input. */
static const struct schema *
schema_of(unsigned version)
{
	static struct schema schemas[3];
	struct tcs_fault fault;

	if (!schemas[version].all &&
		schema_init(
			&schemas[version], (enum gml_version)version, &fault))
		abort();
	return &schemas[version];
}

int
LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
	struct run run = {.began = false};

	if (size < 2 || pthread_rwlock_init(&run.palette.lock, NULL))
		return 0;
	run.plan.schema = *schema_of(data[0] % 3);
	run.composer.plan = &run.plan;
	if (data[1] == '{')
		take_lines(&run, (const char *)data + 1, size - 1);
	else
		take_stream(&run, data + 1, size - 1);
	if (run.began)
		finish(&run);
	composer_release(&run.composer);
	composed_release(&run.composed);
	if (run.began)
		document_release(&run.document);
	report_release(&run.report);
	head_release(&run.head);
	record_release(&run.head_record);
	palette_release(&run.more);
	gml_palette_release(&run.palette);
	pthread_rwlock_destroy(&run.palette.lock);
	return 0;
}
