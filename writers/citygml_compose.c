#include "citygml_compose.h"

#include <math.h>
#include <string.h>

/* ---- lifetimes ------------------------------------------------------------------ */

void
composed_release(struct composed *composed)
{
	markup_release(&composed->markup);
	markup_release(&composed->appearance);
	report_release(&composed->report);
	array_release(&composed->defined);
	array_release(&composed->needed);
	array_release(&composed->linked);
	array_release(&composed->holes);
	array_release(&composed->outer_id);
}

void
composer_release(struct composer *composer)
{
	object_release(&composer->object);
	arena_release(&composer->arena);
	id_set_release(&composer->ids);
	id_numbers_release(&composer->numbers);
	array_release(&composer->nodes);
	array_release(&composer->items);
	array_release(&composer->pieces);
	array_release(&composer->owners);
	array_release(&composer->surfaces);
	array_release(&composer->roots);
	array_release(&composer->stack);
	array_release(&composer->first_member);
	array_release(&composer->next_member);
	array_release(&composer->last_member);
	array_release(&composer->addresses);
	array_release(&composer->paints);
	array_release(&composer->faces);
	coplanar_release(&composer->merged);
	array_release(&composer->triangles);
	array_release(&composer->triangle_polygons);
	array_release(&composer->coats);
	array_release(&composer->textures);
	array_release(&composer->ring_ids);
	array_release(&composer->slots);
}

static void
clear(struct composer *composer, const struct id_set *taken,
	struct composed *out, unsigned depth)
{
	composer->taken = taken;
	composer->out = out;
	composer->made = 0;
	composer->outer_id = NULL;
	composer->wants_outer_id = false;
	composer->is_prototype = false;
	arena_reset(&composer->arena);
	id_set_clear(&composer->ids);
	if (!taken)
		id_numbers_clear(&composer->numbers);
	array_clear(&composer->items);
	array_clear(&composer->roots);
	array_clear(&composer->addresses);
	array_clear(&composer->nodes);
	markup_clear(&out->markup, depth);
	markup_clear(&out->appearance, depth);
	report_clear(&out->report);
	array_clear(&out->defined);
	array_clear(&out->needed);
	array_clear(&out->linked);
	array_clear(&out->holes);
	out->has_bounds = false;
	out->members = 0;
	out->polygons = 0;
}

/* ---- shared by the files of the composer ---------------------------------------- */

const char *
compose_module(const struct composer *composer, uint32_t feature,
	const struct property *property)
{
	const struct node *node = &composer->nodes.at[feature];

	return strcmp(property->module, node->class->module) ? property->module
							     : node->module;
}

/* A degree of latitude is 111.3 km anywhere, near enough for a tolerance. */
struct tcs_point
compose_metres(const struct composer *composer)
{
	const struct compose_plan *plan = composer->plan;
	struct tcs_point metres = {plan->metres, plan->metres, plan->metres_up};

	if (plan->geographic && !composer->is_prototype &&
		composer->object.vertices.count) {
		double latitude = composer->object.vertices.at[0].y;

		metres.y = 111300;
		metres.x = 111300 * fabs(cos(latitude * 0.017453292519943295));
	}
	return metres;
}

enum tcs_status
compose_note(struct composer *composer, enum report_severity severity,
	const char *item, const char *reason, const char *id,
	struct tcs_fault *fault)
{
	return report_item(&composer->out->report, severity, item, reason,
		id && *id ? id : NULL, composer->number, fault);
}

void
compose_lose(struct composer *composer, const char *item, const char *reason,
	const char *id)
{
	struct tcs_fault fault;

	if (compose_note(composer, REPORT_SKIPPED, item, reason, id, &fault))
		composer->out->markup.failed = true;
}

/* ---- items ------------------------------------------------------------------------ */

static bool
is_foreign(const char *target)
{
	return strchr(target, '#') || strstr(target, "://") ||
		strchr(target, '/');
}

/* The href of a relation; ids of the file are remembered. */
static void
write_href(struct composer *composer, const char *target)
{
	struct composed *out = composer->out;
	const char *legal;

	if (is_foreign(target)) {
		markup_attribute(&out->markup, "xlink:href", target);
		return;
	}
	legal = id_legal(target, &composer->arena);
	if (!legal || array_grow(&out->linked, 1)) {
		out->markup.failed = true;
		return;
	}
	out->linked.at[out->linked.count++] =
		id_hash(&composer->plan->key, legal);
	markup_link(&out->markup, "xlink:href", legal);
}

/* The id that the source gives a role; "" for none. */
static const char *
role_id(const struct composer *composer, const struct item *item)
{
	uint32_t at = TCS_NONE;

	if (item->kind == ITEM_ATTRIBUTE)
		at = value_member(composer, item->index, "Role");
	if (at != TCS_NONE)
		at = value_member(composer, at, "@id");
	return at == TCS_NONE
		? ""
		: compose_text(
			  composer, composer->object.attributes.at[at].value);
}

static void
write_role(struct composer *composer, const struct item *item,
	const char *target, const char *note)
{
	struct markup *markup = &composer->out->markup;

	markup_start(markup, "grp", "groupMember");
	markup_start(markup, "grp", "Role");
	markup_attribute(markup, "gml:id",
		compose_id(composer, role_id(composer, item)));
	if (*note)
		markup_leaf(markup, "grp", "role", note);
	markup_start(markup, "grp", "groupMember");
	write_href(composer, target);
	markup_end(markup, "grp", "groupMember");
	markup_end(markup, "grp", "Role");
	markup_end(markup, "grp", "groupMember");
}

void
link_write(struct composer *composer, const struct item *item,
	const char *target, const char *note)
{
	const struct property *property = compose_property(composer, item);
	const char *module = compose_module(composer, item->feature, property);
	struct markup *markup = &composer->out->markup;

	if (property->content == CONTENT_ROLE) {
		write_role(composer, item, target, note);
		return;
	}
	markup_start(markup, module, property->name);
	write_href(composer, target);
	if (*note && property->content == CONTENT_MEMBER)
		markup_attribute(markup, "role", note);
	else if (*note)
		compose_lose(composer, "role of a link",
			"only members of a group have one", note);
	markup_end(markup, module, property->name);
}

static void
write_relation(struct composer *composer, const struct item *item)
{
	const struct tcs_relation *relation =
		&composer->object.relations.at[item->index];
	const char *target = compose_text(composer, relation->target);

	if (compose_property(composer, item)->content == CONTENT_GENERIC)
		generic_write_string(composer,
			compose_text(composer, relation->role), target);
	else
		link_write(composer, item, target,
			compose_text(composer, relation->note));
}

static void
write_group_member(struct composer *composer, const struct item *item)
{
	const struct node *node = &composer->nodes.at[item->index];

	link_write(composer, item, node->id, node->note ? node->note : "");
}

/* A level of detail of the object, or "lane". */
static const char *
required_value(const struct composer *composer, unsigned content)
{
	static const char *const levels[] = {"0", "1", "2", "3", "4"};
	unsigned lod = composer->object.geometries.count
		? composer->object.geometries.at[0].lod
		: 0;

	if (content == CONTENT_GRANULARITY)
		return "lane";
	return levels[lod > 4				     ? 0
			: lod == 4 && compose_is_3(composer) ? 3
							     : lod];
}

static void
write_item(struct composer *composer, const struct item *item)
{
	const struct property *property = compose_property(composer, item);
	const char *module = compose_module(composer, item->feature, property);
	struct markup *markup = &composer->out->markup;

	switch (item->kind) {
	case ITEM_NAME:
		markup_leaf(markup, module, property->name,
			compose_text(composer,
				composer->object.features.at[item->index]
					.name));
		return;
	case ITEM_ATTRIBUTE:
	case ITEM_HEIGHT:
	case ITEM_MEASURED:
		value_write(composer, item);
		return;
	case ITEM_GENERIC:
		generic_write(composer, item->index);
		return;
	case ITEM_APPEARANCE:
		appearances_write(composer);
		return;
	case ITEM_INSTANCE:
		instance_write(composer, item);
		return;
	case ITEM_RELATION:
		write_relation(composer, item);
		return;
	case ITEM_MEMBER:
		write_group_member(composer, item);
		return;
	case ITEM_INSIDE:
		markup_leaf(markup, module, property->name, "inside");
		return;
	case ITEM_PART_OF:
		generic_write_string(
			composer, "partOf", composer->nodes.at[item->index].id);
		return;
	case ITEM_ORIGINAL_ID:
		generic_write_string(composer, "originalId",
			compose_text(composer,
				composer->object.features.at[item->index].id));
		return;
	case ITEM_REQUIRED:
		markup_leaf(markup, module, property->name,
			required_value(composer, property->content));
		return;
	default:
		return;
	}
}

/* ---- features -------------------------------------------------------------------- */

static bool
is_shape(const struct item *item)
{
	return item->kind == ITEM_GEOMETRY || item->kind == ITEM_POLYGON;
}

/* Geometry items of one property are written together. */
static uint32_t
shape_run(const struct composer *composer, uint32_t first, uint32_t end)
{
	const struct item *items = composer->items.at;
	uint32_t at = first + 1;

	if (compose_property(composer, &items[first])->many)
		return 1;
	while (at < end && is_shape(&items[at]) &&
		items[at].property == items[first].property)
		at++;
	return at - first;
}

static enum tcs_status
open_feature(
	struct composer *composer, uint32_t feature, struct tcs_fault *fault)
{
	const struct node *node = &composer->nodes.at[feature];
	struct markup *markup = &composer->out->markup;

	if (array_grow(&composer->stack, 1))
		return fault_memory(fault);
	composer->stack.at[composer->stack.count++] = feature;
	markup_start(markup, node->module, node->class->name);
	if (node->id)
		markup_attribute(markup, "gml:id", node->id);
	return TCS_OK;
}

static void
child_property(const struct composer *composer, uint32_t feature,
	const char **module, const char **name)
{
	const struct node *node = &composer->nodes.at[feature];
	const struct property *property;

	*module = "core";
	*name = "cityObjectMember";
	if (node->property == SCHEMA_NONE)
		return;
	property = &composer->nodes.at[node->parent]
			    .class->properties[node->property];
	*module = compose_module(composer, node->parent, property);
	*name = property->name;
}

static void
close_feature(struct composer *composer)
{
	uint32_t feature = composer->stack.at[--composer->stack.count];
	const struct node *node = &composer->nodes.at[feature];
	const char *module, *name;

	markup_end(&composer->out->markup, node->module, node->class->name);
	child_property(composer, feature, &module, &name);
	markup_end(&composer->out->markup, module, name);
}

/* The next item of the innermost feature; its children open. */
static enum tcs_status
step(struct composer *composer, struct tcs_fault *fault)
{
	uint32_t feature = composer->stack.at[composer->stack.count - 1];
	struct node *node = &composer->nodes.at[feature];
	const struct item *item = &composer->items.at[node->first_item];
	const char *module, *name;
	uint32_t run;

	if (is_shape(item)) {
		run = shape_run(composer, node->first_item, node->item_end);
		node->first_item += run;
		shapes_write(composer, item, run);
		return TCS_OK;
	}
	node->first_item++;
	if (item->kind != ITEM_CHILD) {
		write_item(composer, item);
		return TCS_OK;
	}
	child_property(composer, item->index, &module, &name);
	markup_start(&composer->out->markup, module, name);
	if (composer->nodes.at[item->index].note)
		markup_attribute(&composer->out->markup, "role",
			composer->nodes.at[item->index].note);
	return open_feature(composer, item->index, fault);
}

static enum tcs_status
write_member(struct composer *composer, uint32_t root, struct tcs_fault *fault)
{
	enum tcs_status status;

	composer->out->members++;
	array_clear(&composer->stack);
	markup_start(&composer->out->markup, "core", "cityObjectMember");
	status = open_feature(composer, root, fault);
	while (!status && composer->stack.count) {
		const struct node *node =
			&composer->nodes
				 .at[composer->stack.at[composer->stack.count -
					 1]];

		if (node->first_item == node->item_end)
			close_feature(composer);
		else
			status = step(composer, fault);
	}
	return status;
}

/* ---- objects ---------------------------------------------------------------------- */

static void
find_bounds(const struct composer *composer, struct composed *out)
{
	const struct tcs_object *object = &composer->object;

	for (size_t i = 0; i < object->vertices.count + object->instances.count;
		i++) {
		struct tcs_point at = i < object->vertices.count
			? object->vertices.at[i]
			: object->instances.at[i - object->vertices.count]
				  .anchor;

		if (!out->has_bounds)
			out->lower = out->upper = at;
		out->has_bounds = true;
		out->lower.x = at.x < out->lower.x ? at.x : out->lower.x;
		out->lower.y = at.y < out->lower.y ? at.y : out->lower.y;
		out->lower.z = at.z < out->lower.z ? at.z : out->lower.z;
		out->upper.x = at.x > out->upper.x ? at.x : out->upper.x;
		out->upper.y = at.y > out->upper.y ? at.y : out->upper.y;
		out->upper.z = at.z > out->upper.z ? at.z : out->upper.z;
	}
}

enum tcs_status
compose_object(struct composer *composer, const struct tcs_record *record,
	const struct id_set *taken, struct composed *out,
	struct tcs_fault *fault)
{
	enum tcs_status status =
		object_decode(&composer->object, record, fault);

	clear(composer, taken, out, 1);
	composer->number = composer->before = record->before.objects;
	if (!status)
		status = plan_features(composer, fault);
	if (!status)
		status = place_items(composer, fault);
	for (size_t i = 0; i < composer->roots.count && !status; i++)
		status = write_member(composer, composer->roots.at[i], fault);
	if (!status && out->markup.replaced)
		status = compose_note(composer, REPORT_REPAIRED, "text",
			"a character that XML has not is U+FFFD now",
			composer->nodes.at[0].id, fault);
	if (status)
		return status;
	find_bounds(composer, out);
	return markup_check(&out->markup, fault);
}

static enum tcs_status
keep_outer_id(struct composer *composer, struct composed *out,
	struct tcs_fault *fault)
{
	const char *id = composer->outer_id ? composer->outer_id : "";
	size_t length = strlen(id) + 1;

	array_clear(&out->outer_id);
	if (array_grow(&out->outer_id, length))
		return fault_memory(fault);
	memcpy(out->outer_id.at, id, length);
	out->outer_id.count = length;
	return TCS_OK;
}

enum tcs_status
compose_prototype(struct composer *composer, const struct tcs_record *record,
	const struct id_set *taken, struct composed *out,
	struct tcs_fault *fault)
{
	enum tcs_status status =
		object_decode(&composer->object, record, fault);

	clear(composer, taken, out, 1);
	composer->number = record->before.prototypes;
	composer->before = record->before.objects;
	composer->is_prototype = true;
	if (!status)
		status = place_prototype(composer, fault);
	if (status)
		return status;
	prototype_write(composer);
	prototype_appearances_write(composer);
	status = keep_outer_id(composer, out, fault);
	if (!status)
		status = markup_check(&out->appearance, fault);
	return status ? status : markup_check(&out->markup, fault);
}
