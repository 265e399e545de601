#include "citygml_document.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "citygml_sink.h"
#include "input.h"

/* ---- namespaces ----------------------------------------------------------------- */

/* Modules and the last part of their names, before the version. */
static const struct {
	const char *prefix, *name;
	unsigned char versions; /* bit n: enum gml_version n */
} modules[] = {
	{"core", "", 7},
	{"app", "appearance/", 7},
	{"bldg", "building/", 7},
	{"brid", "bridge/", 6},
	{"con", "construction/", 4},
	{"dem", "relief/", 7},
	{"dyn", "dynamizer/", 4},
	{"frn", "cityfurniture/", 7},
	{"gen", "generics/", 7},
	{"grp", "cityobjectgroup/", 7},
	{"luse", "landuse/", 7},
	{"pcl", "pointcloud/", 4},
	{"tran", "transportation/", 7},
	{"tun", "tunnel/", 6},
	{"veg", "vegetation/", 7},
	{"wtr", "waterbody/", 7},
};

static void
write_namespace(struct markup *markup, const char *prefix, const char *first,
	const char *second, const char *third)
{
	const char *const parts[] = {
		"\n\txmlns:", prefix, "=\"", first, second, third, "\""};

	for (size_t i = 0; i < sizeof parts / sizeof *parts; i++)
		markup_raw(markup, parts[i], strlen(parts[i]));
}

static void
write_namespaces(struct markup *markup, enum gml_version version)
{
	static const char *const versions[] = {"1.0", "2.0", "3.0"};

	for (size_t i = 0; i < sizeof modules / sizeof *modules; i++)
		if (modules[i].versions >> version & 1)
			write_namespace(markup, modules[i].prefix,
				"http://www.opengis.net/citygml/",
				modules[i].name, versions[version]);
	write_namespace(markup, "gml", "http://www.opengis.net/gml",
		version == GML_3_0 ? "/3.2" : "", "");
	write_namespace(markup, "xAL", "urn:oasis:names:tc:ciq:",
		version == GML_3_0 ? "xal:3" : "xsdschema:xAL:2.0", "");
	if (version == GML_3_0)
		write_namespace(
			markup, "ct", "urn:oasis:names:tc:ciq:ct:3", "", "");
	write_namespace(
		markup, "xlink", "http://www.w3.org/1999/xlink", "", "");
}

/* ---- the head ------------------------------------------------------------------- */

static void
write_corner(struct document *document, struct markup *markup, const char *name,
	struct tcs_point corner)
{
	bool north_first = document->plan->north_first;

	markup_start(markup, "gml", name);
	markup_number(markup, north_first ? corner.y : corner.x);
	markup_number(markup, north_first ? corner.x : corner.y);
	markup_number(markup, corner.z);
	markup_end(markup, "gml", name);
}

static void
write_envelope(struct document *document, struct markup *markup,
	const struct tcs_head *head)
{
	const struct tcs_crs *crs = &head->crs.at[0];
	const char *name = head_text(head, crs->name);

	if (!document->has_bounds && !(crs->flags & TCS_HAS_BOUNDS))
		return;
	if (!document->has_bounds) {
		document->lower = crs->lower;
		document->upper = crs->upper;
	}
	markup_start(markup, "gml", "boundedBy");
	markup_start(markup, "gml", "Envelope");
	if (*name)
		markup_attribute(markup, "srsName", name);
	markup_attribute(markup, "srsDimension", "3");
	write_corner(document, markup, "lowerCorner", document->lower);
	write_corner(document, markup, "upperCorner", document->upper);
	markup_end(markup, "gml", "Envelope");
	markup_end(markup, "gml", "boundedBy");
}

/* An id for the model that no feature has: its own if it may be. */
static void
write_model_id(
	struct document *document, struct markup *markup, const char *own)
{
	char id[32] = "CityModel";

	if (*own && id_is_legal(own) &&
		!id_set_has(
			&document->ids, id_hash(&document->plan->key, own))) {
		markup_attribute(markup, "gml:id", own);
		return;
	}
	if (document->plan->schema.version != GML_3_0)
		return;
	for (unsigned i = 2;
		id_set_has(&document->ids, id_hash(&document->plan->key, id));
		i++)
		snprintf(id, sizeof id, "CityModel_%u", i);
	markup_attribute(markup, "gml:id", id);
}

static void
write_model_text(struct markup *markup, const struct tcs_head *head,
	const char *name, tcs_text text)
{
	if (text)
		markup_leaf(markup, "gml", name, head_text(head, text));
}

static void
write_head(struct document *document, struct markup *markup,
	const struct tcs_head *head)
{
	static const char declaration[] =
		"<?xml version=\"1.0\" encoding=\"UTF-8\"?>";
	struct tcs_model model = {0};

	if (head->models.count == 1)
		model = head->models.at[0];
	markup_raw(markup, declaration, sizeof declaration - 1);
	markup_start(markup, "core", "CityModel");
	write_namespaces(markup, document->plan->schema.version);
	write_model_id(document, markup, head_text(head, model.id));
	markup_begin_text(markup);
	write_model_text(markup, head, "description", model.description);
	write_model_text(markup, head, "name", model.name);
	write_envelope(document, markup, head);
}

/* ---- members -------------------------------------------------------------------- */

enum tcs_status
document_begin(struct document *document, const struct compose_plan *plan,
	struct report *report, struct tcs_fault *fault)
{
	int fd = input_nameless();

	*document = (struct document){.plan = plan, .report = report};
	document->again.plan = plan;
	if (fd >= 0)
		document->members = fdopen(fd, "w+b");
	if (document->members)
		return TCS_OK;
	if (fd >= 0)
		close(fd);
	return fault_system(fault, "cannot create", "a temporary file");
}

void
document_release(struct document *document)
{
	for (size_t i = 0; i < document->prototypes.count; i++) {
		free(document->prototypes.at[i].text);
		free(document->prototypes.at[i].appearance);
		free(document->prototypes.at[i].id);
	}
	if (document->members)
		fclose(document->members);
	array_release(&document->prototypes);
	array_release(&document->appearances);
	id_set_release(&document->ids);
	id_set_release(&document->linked);
	composer_release(&document->again);
}

/* Whether the file so far agrees with what the text defines and needs. */
static bool
agrees(const struct document *document, const struct composed *composed)
{
	for (size_t i = 0; i < composed->defined.count; i++)
		if (id_set_has(&document->ids, composed->defined.at[i]))
			return false;
	for (size_t i = 0; i < composed->needed.count; i++)
		if (!id_set_has(&document->ids, composed->needed.at[i]))
			return false;
	return true;
}

static enum tcs_status
add_ids(struct id_set *set, const uint64_t *hashes, size_t count,
	struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;
	bool added;

	for (size_t i = 0; i < count && !status; i++)
		status = id_set_add(set, hashes[i], &added, fault);
	return status;
}

static enum tcs_status
put(struct document *document, const char *bytes, size_t length,
	struct tcs_fault *fault)
{
	if (length && fwrite(bytes, 1, length, document->members) != length)
		return fault_system(fault, "cannot write", "a temporary file");
	return TCS_OK;
}

/* What paints a prototype stands behind the object that it stands in. */
static enum tcs_status
take_appearance(struct document *document,
	const struct document_prototype *prototype, struct tcs_fault *fault)
{
	size_t length = prototype->appearance_length;

	if (array_grow(&document->appearances, length))
		return fault_memory(fault);
	if (length)
		memcpy(document->appearances.at + document->appearances.count,
			prototype->appearance, length);
	document->appearances.count += length;
	return TCS_OK;
}

/* The geometry of an instance: in full the first time, then by link. */
static enum tcs_status
put_instance(struct document *document, const struct hole *hole,
	struct tcs_fault *fault)
{
	const char *name = document->plan->schema.version == GML_3_0
		? "relativeGeometry"
		: "relativeGMLGeometry";
	struct document_prototype *prototype =
		&document->prototypes.at[hole->prototype];
	struct markup markup = {.depth = hole->depth};
	enum tcs_status status;

	markup_start(&markup, "core", name);
	if (prototype->text) {
		markup_begin_text(&markup);
		markup_raw(&markup, prototype->text, prototype->length);
		markup.after_text = false;
	} else {
		markup_link(&markup, "xlink:href", prototype->id);
	}
	markup_end(&markup, "core", name);
	status = markup_check(&markup, fault);
	if (!status)
		status = put(
			document, markup.bytes.at, markup.bytes.count, fault);
	markup_release(&markup);
	if (!status && prototype->text)
		status = take_appearance(document, prototype, fault);
	free(prototype->text);
	free(prototype->appearance);
	prototype->text = prototype->appearance = NULL;
	return status;
}

static enum tcs_status
put_members(struct document *document, const struct composed *composed,
	struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;
	size_t at = 0;

	array_clear(&document->appearances);
	for (size_t i = 0; i < composed->holes.count && !status; i++) {
		const struct hole *hole = &composed->holes.at[i];

		status = put(document, composed->markup.bytes.at + at,
			hole->at - at, fault);
		at = hole->at;
		if (!status)
			status = put_instance(document, hole, fault);
	}
	if (!status)
		status = put(document, composed->markup.bytes.at + at,
			composed->markup.bytes.count - at, fault);
	return status ? status
		      : put(document, document->appearances.at,
				document->appearances.count, fault);
}

static void
include(struct document *document, const struct composed *composed)
{
	struct tcs_point *lower = &document->lower, *upper = &document->upper;
	struct tcs_point least = composed->lower, most = composed->upper;

	if (!composed->has_bounds)
		return;
	if (!document->has_bounds) {
		*lower = least;
		*upper = most;
	}
	lower->x = least.x < lower->x ? least.x : lower->x;
	lower->y = least.y < lower->y ? least.y : lower->y;
	lower->z = least.z < lower->z ? least.z : lower->z;
	upper->x = most.x > upper->x ? most.x : upper->x;
	upper->y = most.y > upper->y ? most.y : upper->y;
	upper->z = most.z > upper->z ? most.z : upper->z;
	document->has_bounds = true;
}

/* NULL without memory. */
static char *
copy_text(const struct markup *markup)
{
	char *copy = malloc(markup->bytes.count + 1);

	if (copy && markup->bytes.count)
		memcpy(copy, markup->bytes.at, markup->bytes.count);
	return copy;
}

static enum tcs_status
keep_prototype(struct document *document, const struct composed *composed,
	struct tcs_fault *fault)
{
	struct document_prototype *prototype;

	if (array_grow(&document->prototypes, 1))
		return fault_memory(fault);
	prototype = &document->prototypes.at[document->prototypes.count++];
	*prototype = (struct document_prototype){
		.text = copy_text(&composed->markup),
		.length = composed->markup.bytes.count,
		.appearance = copy_text(&composed->appearance),
		.appearance_length = composed->appearance.bytes.count,
		.id = strdup(composed->outer_id.at),
	};
	return prototype->text && prototype->appearance && prototype->id
		? TCS_OK
		: fault_memory(fault);
}

static enum tcs_status
compose(struct composer *composer, const struct tcs_record *record,
	const struct id_set *taken, struct composed *out,
	struct tcs_fault *fault)
{
	return record->type == TCS_PROTOTYPE
		? compose_prototype(composer, record, taken, out, fault)
		: compose_object(composer, record, taken, out, fault);
}

enum tcs_status
document_add(struct document *document, struct composed *composed,
	const struct tcs_record *record, struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	if (!agrees(document, composed))
		status = compose(&document->again, record, &document->ids,
			composed, fault);
	if (!status)
		status = report_merge(
			document->report, &composed->report, fault);
	if (!status)
		status = add_ids(&document->ids, composed->defined.at,
			composed->defined.count, fault);
	if (!status)
		status = add_ids(&document->linked, composed->linked.at,
			composed->linked.count, fault);
	if (status)
		return status;
	document->polygons += composed->polygons;
	if (record->type == TCS_PROTOTYPE)
		return keep_prototype(document, composed, fault);
	document->member_count += composed->members;
	include(document, composed);
	return put_members(document, composed, fault);
}

/* ---- the end ---------------------------------------------------------------------- */

static enum tcs_status
note_dangling(struct document *document, struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	for (size_t i = 0; i < document->linked.room && !status; i++)
		if (document->linked.slots[i] &&
			!id_set_has(&document->ids, document->linked.slots[i]))
			status = report_item(document->report, REPORT_NOTE,
				"link", "its target is not in the stream", NULL,
				TCS_NOWHERE, fault);
	return status;
}

static enum tcs_status
copy_members(
	struct document *document, struct sink *sink, struct tcs_fault *fault)
{
	static const size_t room = (size_t)1 << 18;
	enum tcs_status status = TCS_OK;
	char *bytes = malloc(room);
	size_t got;

	if (!bytes)
		return fault_memory(fault);
	if (fflush(document->members) || fseeko(document->members, 0, SEEK_SET))
		status =
			fault_system(fault, "cannot write", "a temporary file");
	while (!status && (got = fread(bytes, 1, room, document->members)) > 0)
		status = sink_put(sink, bytes, got, fault);
	if (!status && ferror(document->members))
		status = fault_system(fault, "cannot read", "a temporary file");
	free(bytes);
	return status;
}

enum tcs_status
document_end(struct document *document, const struct tcs_head *head, FILE *out,
	int level, struct tcs_fault *fault)
{
	static const char end[] = "\n</core:CityModel>\n";
	struct markup markup = {0};
	struct sink sink = {0};
	enum tcs_status status = note_dangling(document, fault);

	if (status)
		return status;
	write_head(document, &markup, head);
	status = markup_check(&markup, fault);
	if (!status)
		status = sink_open(&sink, out, level, fault);
	if (!status)
		status = sink_put(
			&sink, markup.bytes.at, markup.bytes.count, fault);
	if (!status)
		status = copy_members(document, &sink, fault);
	if (!status)
		status = sink_put(&sink, end, sizeof end - 1, fault);
	if (!status)
		status = sink_finish(&sink, fault);
	document->bytes = sink.bytes;
	sink_release(&sink);
	markup_release(&markup);
	return status;
}
