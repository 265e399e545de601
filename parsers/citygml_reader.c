#include "citygml_reader.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "citygml_numbers.h"

/* ---- the stack --------------------------------------------------------- */

struct frame *
gml_top(struct gml_reader *reader)
{
	return &reader->frames.at[reader->frames.count - 1];
}

enum tcs_status
gml_push(struct gml_reader *reader, struct name *name, enum frame_role role,
	struct frame **out, struct tcs_fault *fault)
{
	const struct frame *parent;
	struct frame *frame;

	if (array_grow(&reader->frames, 1))
		return fault_memory(fault);
	parent = gml_top(reader);
	frame = &reader->frames.at[reader->frames.count++];
	*frame = (struct frame){
		.name = name,
		.role = role,
		.reversed = parent->reversed,
		.interior = parent->interior,
		.dimension = parent->dimension,
		.attribute = TCS_NONE,
		.feature = parent->feature,
		.polygon = parent->polygon,
		.shell = parent->shell,
	};
	reader->text.count = 0;
	if (out)
		*out = frame;
	return TCS_OK;
}

bool
gml_out_of_turn(struct gml_reader *reader)
{
	reader->out_of_turn = reader->is_helper;
	return reader->is_helper;
}

enum tcs_status
gml_skip(struct gml_reader *reader)
{
	reader->skip = true;
	return TCS_OK;
}

/* ---- what the other files share ----------------------------------------- */

void
gml_trimmed(const struct gml_reader *reader, const char **at, size_t *length)
{
	const char *first = reader->text.at;
	const char *end = first + reader->text.count;

	while (first < end && is_blank(*first))
		first++;
	while (first < end && is_blank(end[-1]))
		end--;
	*at = first;
	*length = (size_t)(end - first);
}

enum tcs_status
gml_text(struct gml_reader *reader, const char *bytes, size_t length,
	tcs_text *out, struct tcs_fault *fault)
{
	return text_append(&reader->raw->tree, bytes, length, out, fault);
}

enum tcs_status
gml_name_text(struct gml_reader *reader, struct name *name, tcs_text *out,
	struct tcs_fault *fault)
{
	/* Serial 0 is a name never placed; the first object counts as 1. */
	if (name->text_serial != reader->serial) {
		enum tcs_status status = gml_text(
			reader, name->local, name->length, &name->text, fault);

		if (status)
			return status;
		name->text_serial = reader->serial;
	}
	*out = name->text;
	return TCS_OK;
}

enum tcs_status
gml_skipped(struct gml_reader *reader, const char *item, const char *reason,
	const char *id, struct tcs_fault *fault)
{
	struct report *report =
		reader->raw ? &reader->raw->report : &reader->report;

	return raw_report(report, REPORT_SKIPPED, item, reason, id,
		xml_line(reader->xml), fault);
}

/* ---- coordinate systems -------------------------------------------------- */

#define MAX_SYSTEMS 1000 /* spellings kept; later ones are the first's */

enum tcs_status
gml_srs(struct gml_reader *reader, const char *name, size_t length,
	uint32_t *out, struct tcs_fault *fault)
{
	struct gml_srs *added;

	for (size_t i = 0; i < reader->systems.count; i++) {
		const char *known = reader->systems.at[i].name;

		*out = (uint32_t)i;
		if (!strncmp(known, name, length) && !known[length])
			return TCS_OK;
	}
	*out = TCS_NONE;
	if (gml_out_of_turn(reader))
		return TCS_OK;
	*out = 0;
	if (reader->systems.count >= MAX_SYSTEMS)
		return TCS_OK;
	if (array_grow(&reader->systems, 1))
		return fault_memory(fault);
	added = &reader->systems.at[reader->systems.count];
	*added = (struct gml_srs){.name = strndup(name, length)};
	if (!added->name)
		return fault_memory(fault);
	srs_read(added->name, &added->srs);
	*out = (uint32_t)reader->systems.count++;
	return TCS_OK;
}

uint32_t
gml_system(const struct gml_reader *reader, uint32_t given)
{
	if (given != TCS_NONE)
		return given;
	return reader->object_srs != TCS_NONE ? reader->object_srs
					      : reader->model_srs;
}

bool
gml_north_first(struct gml_reader *reader, uint32_t system,
	const char *position, size_t length)
{
	struct gml_srs *srs = &reader->systems.at[system];
	double sample[3] = {0};

	if (srs->decided)
		return srs->north_first;
	if (gml_out_of_turn(reader))
		return false;
	if (numbers_first(position, length, sample, 3) < 2)
		return false;
	srs->north_first = srs_north_first(&srs->srs,
		(struct tcs_point){sample[0], sample[1], sample[2]},
		&srs->assumed);
	srs->decided = true;
	return srs->north_first;
}

/* ---- bounds -------------------------------------------------------------- */

/* The object of the appearances' pass is none of the model's. */
static bool
is_in_object(const struct gml_reader *reader)
{
	return reader->raw && reader->pass == PASS_OBJECTS;
}

/* gml:boundedBy with a CityGML 0.4 file's habits: surfaces may stand in it. */
static enum tcs_status
bounds_child(struct gml_reader *reader, struct name *name,
	const struct xml_attribute *attributes, size_t count,
	struct tcs_fault *fault)
{
	const struct xml_attribute *srs_name;
	struct frame *frame;
	enum tcs_status status;
	uint32_t system;

	if (name->kind == NAME_FEATURE && is_in_object(reader))
		return feature_begin(reader, name, attributes, count, fault);
	status = gml_push(reader, name, ROLE_BOUNDS, &frame, fault);
	if (status)
		return status;
	frame->wants_text =
		name->kind == NAME_ENVELOPE_CORNER || name->kind == NAME_POS;
	srs_name = attribute_find(attributes, count, "srsName");
	if (!srs_name || !srs_name->length)
		return TCS_OK;
	status = gml_srs(
		reader, srs_name->value, srs_name->length, &system, fault);
	if (status)
		return status;
	if (!is_in_object(reader))
		reader->model_srs = system;
	else if (frame->feature == 0)
		reader->object_srs = system;
	return TCS_OK;
}

static void
bounds_end(struct gml_reader *reader, const struct frame *frame)
{
	bool upper;

	if (is_in_object(reader) || !frame->wants_text)
		return;
	upper = frame->name->kind == NAME_ENVELOPE_CORNER
		? frame->name->local[0] == 'u'
		: reader->has_corner[0];
	if (numbers_first(reader->text.at, reader->text.count,
		    reader->corner[upper], 3) == 3)
		reader->has_corner[upper] = true;
}

/* ---- extensions ----------------------------------------------------------- */

/* Elements of extensions that are not wanted. */
static bool
is_dropped(const struct gml_reader *reader, const struct frame *parent,
	const struct name *name)
{
	return reader->options.drop_extensions && name->space == SPACE_OTHER &&
		parent->role >= ROLE_MEMBER;
}

static enum tcs_status
extension_drop(struct gml_reader *reader, struct tcs_fault *fault)
{
	struct report *report =
		reader->raw ? &reader->raw->report : &reader->report;
	enum tcs_status status =
		report_add(report, "elements of extensions dropped", 1, fault);

	return status ? status : gml_skip(reader);
}

/* ---- events ---------------------------------------------------------------- */

static enum tcs_status
element_start(struct gml_reader *reader, struct name *name,
	const struct xml_attribute *attributes, size_t count,
	struct tcs_fault *fault)
{
	struct frame *top = gml_top(reader);

	top->has_children = true;
	if (reader->out_of_turn)
		return gml_skip(reader);
	if (is_dropped(reader, top, name))
		return extension_drop(reader, fault);
	switch (top->role) {
	case ROLE_DOCUMENT:
		return document_child(reader, name, attributes, count, fault);
	case ROLE_MODEL:
		return model_child(reader, name, attributes, count, fault);
	case ROLE_MEMBER:
		return member_child(reader, name, attributes, count, fault);
	case ROLE_FEATURE:
	case ROLE_PROPERTY:
	case ROLE_ATTRIBUTE:
	case ROLE_GENERIC:
		return feature_child(reader, name, attributes, count, fault);
	case ROLE_BOUNDS:
		return bounds_child(reader, name, attributes, count, fault);
	case ROLE_GEOMETRY:
		return geometry_child(reader, name, attributes, count, fault);
	case ROLE_IMPLICIT:
		return implicit_child(reader, name, attributes, count, fault);
	case ROLE_APPEARANCE:
		return appearance_child(reader, name, attributes, count, fault);
	case ROLE_MODEL_TEXT:
	case ROLE_GENERIC_PART:
		break;
	}
	return gml_skip(reader);
}

static enum tcs_status
gml_start(void *context, struct name *name,
	const struct xml_attribute *attributes, size_t count, bool *skip,
	struct tcs_fault *fault)
{
	struct gml_reader *reader = context;
	enum tcs_status status;

	reader->skip = false;
	status = element_start(reader, name, attributes, count, fault);
	*skip = reader->skip;
	return status;
}

static bool
gml_listens(const void *context)
{
	const struct gml_reader *reader = context;
	const struct frame *top = &reader->frames.at[reader->frames.count - 1];

	return top->wants_text &&
		!(top->has_children && attribute_may_come_of(top));
}

static enum tcs_status
gml_characters(void *context, const char *bytes, size_t length,
	struct tcs_fault *fault)
{
	struct gml_reader *reader = context;

	if (!gml_listens(reader))
		return TCS_OK;
	if (gml_top(reader)->role == ROLE_GEOMETRY)
		return geometry_text(reader, bytes, length, fault);
	if (array_grow(&reader->text, length))
		return fault_memory(fault);
	memcpy(reader->text.at + reader->text.count, bytes, length);
	reader->text.count += length;
	return TCS_OK;
}

/* The frame that ends is popped, but stays where it is meanwhile. */
static enum tcs_status
gml_end_element(void *context, struct tcs_fault *fault)
{
	struct gml_reader *reader = context;
	struct frame *frame = gml_top(reader);

	reader->frames.count--;
	switch (frame->role) {
	case ROLE_FEATURE:
	case ROLE_PROPERTY:
	case ROLE_ATTRIBUTE:
	case ROLE_GENERIC:
	case ROLE_GENERIC_PART:
		return feature_end(reader, frame, fault);
	case ROLE_GEOMETRY:
		return geometry_end(reader, frame, fault);
	case ROLE_IMPLICIT:
		return implicit_end(reader, frame, fault);
	case ROLE_APPEARANCE:
		return appearance_end(reader, frame, fault);
	case ROLE_BOUNDS:
		bounds_end(reader, frame);
		return TCS_OK;
	case ROLE_MODEL_TEXT:
		return model_text_end(reader, frame, fault);
	case ROLE_DOCUMENT:
	case ROLE_MODEL:
	case ROLE_MEMBER:
		break;
	}
	return TCS_OK;
}

/* ---- life ------------------------------------------------------------------- */

enum tcs_status
gml_begin(struct gml_reader *reader, const struct gml_options *options,
	struct tcs_fault *fault)
{
	*reader = (struct gml_reader){
		.options = *options,
		.names.version = 2,
		.ready_end = &reader->ready,
		.model_srs = TCS_NONE,
		.first_srs = TCS_NONE,
		.folder.name = options->folder,
		.numbers.folder.name = options->folder,
	};
	if (array_grow(&reader->frames, 1) || array_grow(&reader->text, 64))
		return fault_memory(fault);
	return TCS_OK;
}

static void
raw_list_free(struct raw_object *list)
{
	while (list) {
		struct raw_object *next = list->next;

		raw_free(list);
		list = next;
	}
}

void
gml_release(struct gml_reader *reader)
{
	xml_free(reader->xml);
	array_release(&reader->frames);
	array_release(&reader->model_id);
	array_release(&reader->model_name);
	array_release(&reader->model_description);
	array_release(&reader->text);
	raw_free(reader->raw);
	raw_list_free(reader->ready);
	raw_list_free(reader->spare);
	for (size_t i = 0; i < reader->systems.count; i++)
		free(reader->systems.at[i].name);
	array_release(&reader->systems);
	report_release(&reader->report);
	keys_release(&reader->templates);
	appearance_release(reader);
}

enum tcs_status
gml_start_pass(
	struct gml_reader *reader, enum gml_pass pass, struct tcs_fault *fault)
{
	reader->pass = pass;
	reader->handler = (struct xml_handler){reader, gml_start,
		gml_end_element, gml_characters, gml_listens};
	xml_free(reader->xml);
	reader->xml =
		xml_new(&reader->handler, &reader->options.xml, &reader->names);
	if (!reader->xml)
		return fault_memory(fault);
	if (reader->raw &&
		report_merge(&reader->report, &reader->raw->report, fault))
		return fault->status;
	raw_free(reader->raw);
	reader->raw = NULL;
	reader->head_end = 0;
	reader->member = (struct xml_stretch){0};
	reader->objects = 0;
	reader->object_bytes = 0;
	reader->object_srs = reader->geometry_srs = TCS_NONE;
	reader->frames.at[0] = (struct frame){
		.role = ROLE_DOCUMENT,
		.attribute = TCS_NONE,
		.feature = TCS_NONE,
		.polygon = TCS_NONE,
		.shell = TCS_NONE,
	};
	reader->frames.count = 1;
	return TCS_OK;
}

enum tcs_status
gml_feed(struct gml_reader *reader, const char *bytes, size_t length,
	struct tcs_fault *fault)
{
	uint64_t object = reader->objects;
	enum tcs_status status = xml_feed(reader->xml, bytes, length, fault);
	bool within = reader->raw && reader->objects == object &&
		reader->pass == PASS_OBJECTS;

	reader->object_bytes = within ? reader->object_bytes + length : 0;
	if (status || !reader->options.max_feature ||
		reader->object_bytes <= reader->options.max_feature)
		return status;
	return fault_set(fault, TCS_LIMIT, TCS_NOWHERE,
		"line %u: a feature is longer than %llu bytes (--max-feature)",
		xml_line(reader->xml),
		(unsigned long long)reader->options.max_feature);
}

struct raw_object *
gml_take(struct gml_reader *reader)
{
	struct raw_object *raw = reader->ready;

	if (!raw)
		return NULL;
	reader->ready = raw->next;
	if (!reader->ready)
		reader->ready_end = &reader->ready;
	raw->next = NULL;
	return raw;
}

void
gml_recycle(struct gml_reader *reader, struct raw_object *raw)
{
	if (!raw)
		return;
	raw_clear(raw);
	raw->next = reader->spare;
	reader->spare = raw;
}

enum tcs_status
gml_open_object(struct gml_reader *reader, struct tcs_fault *fault)
{
	struct xml_stretch tag;

	reader->raw = reader->spare ? reader->spare : raw_new();
	if (!reader->raw)
		return fault_memory(fault);
	if (reader->raw == reader->spare)
		reader->spare = reader->raw->next;
	reader->raw->next = NULL;
	if (array_grow(&reader->raw->positions, 64))
		return fault_memory(fault);
	xml_place_tag(reader->xml, &tag);
	reader->raw->place = (struct raw_place){
		.member = reader->member.at,
		.member_end = reader->member.end,
		.at = tag.at,
		.line = tag.line,
		.number = reader->objects++,
	};
	reader->serial++;
	reader->object_srs = TCS_NONE;
	return TCS_OK;
}

void
gml_move(struct gml_reader *reader, uint64_t at, uint64_t line, uint64_t number)
{
	xml_move(reader->xml, at, (uint32_t)line);
	reader->objects = number;
}

void
gml_close_object(struct gml_reader *reader)
{
	if (reader->head_end && reader->member.end)
		xml_place_end(reader->xml, &reader->raw->place.end);
	*reader->ready_end = reader->raw;
	reader->ready_end = &reader->raw->next;
	reader->raw = NULL;
}
