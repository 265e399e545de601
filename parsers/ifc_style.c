#include "ifc_style.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "step_string.h"

enum { STYLED_ITEM = 0, STYLED_STYLES = 1 };

enum { STYLE_NAME = 0, STYLE_STYLES = 2 };

enum { SHADING_COLOUR = 0, SHADING_TRANSPARENCY = 1 };

enum { MAP_TARGET, MAP_OPACITY, MAP_COLOURS, MAP_INDICES };

enum { DEFINITION_REPRESENTATIONS = 2, DEFINITION_MATERIAL = 3 };

enum { REPRESENTATION_ITEMS = 3 };

static float
share(double value)
{
	return (float)fmin(fmax(value, 0), 1);
}

/* ---- surface styles ------------------------------------------------------ */

static bool
colour_read(const struct ifc_file *file, uint32_t colour, float out[3])
{
	for (int i = 0; i < 3; i++) {
		struct step_value value = ifc_value(file, colour, i + 1);
		double part;

		if (ifc_entity_of(file, colour) != IFC_COLOURRGB ||
			!step_number(&value, &part))
			return false;
		out[i] = share(part);
	}
	return true;
}

/* The shading among the styles of a surface; false when there is none. */
static bool
shading_read(
	const struct ifc_file *file, uint32_t style, struct tcs_material *out)
{
	struct step_value list = ifc_value(file, style, STYLE_STYLES), item;

	while (list.kind == STEP_LIST &&
		step_next(&list.list, &item) > STEP_END) {
		uint32_t shading = step_target(file->step, &item);
		struct step_value clear =
			ifc_value(file, shading, SHADING_TRANSPARENCY);
		double transparency = 0;

		if (!ifc_is_kind(file, shading, IFC_SURFACESTYLESHADING) ||
			!colour_read(file,
				ifc_target(file, shading, SHADING_COLOUR),
				out->diffuse))
			continue;
		if (step_number(&clear, &transparency))
			out->transparency = share(transparency);
		return true;
	}
	return false;
}

/* The style's name, or its number where it has none. */
static enum tcs_status
material_id(struct ifc_styles *styles, uint32_t style, tcs_text *out,
	struct tcs_fault *fault)
{
	struct step_value name = ifc_value(styles->file, style, STYLE_NAME);
	struct step_text text = {.count = 0};
	char id[IFC_ID_LENGTH];
	enum tcs_status status = TCS_OK;
	unsigned trouble = 0;

	ifc_id(styles->file, style, id);
	if (name.kind == STEP_STRING)
		status = step_decode(
			&text, name.text, name.length, &trouble, fault);
	if (!status)
		status = text.count ? text_append(&styles->palette, text.at,
					      text.count, out, fault)
				    : text_append(&styles->palette, id,
					      strlen(id), out, fault);
	array_release(&text);
	return status;
}

static enum tcs_status
material_add(struct ifc_styles *styles, const struct tcs_material *material,
	uint32_t *paint, struct tcs_fault *fault)
{
	if (array_grow(&styles->palette.materials, 1))
		return fault_memory(fault);
	styles->palette.materials.at[styles->palette.materials.count++] =
		*material;
	*paint = (uint32_t)styles->palette.materials.count;
	return TCS_OK;
}

/* Each surface style with a colour, painting itself. */
static enum tcs_status
surface_styles_read(struct ifc_styles *styles, struct ifc_instances *found,
	struct ifc_instances *paints, struct tcs_fault *fault)
{
	enum tcs_status status =
		ifc_collect(styles->file, IFC_SURFACESTYLE, found, fault);

	if (!status && array_grow(paints, found->count + 1))
		return fault_memory(fault);
	for (size_t i = 0; i < found->count && !status; i++) {
		struct tcs_material material = {.transparency = 0};

		paints->at[i] = 0;
		if (!shading_read(styles->file, found->at[i], &material))
			continue;
		status = material_id(styles, found->at[i], &material.id, fault);
		if (!status)
			status = material_add(
				styles, &material, &paints->at[i], fault);
	}
	return status;
}

/* ---- styled items -------------------------------------------------------- */

struct style_search {
	const struct ifc_instances *styles, *paints;
};

static uint32_t
paint_of(const struct style_search *search, uint32_t style)
{
	size_t low = 0, high = search->styles->count;

	while (low < high) {
		size_t middle = low + (high - low) / 2;

		if (search->styles->at[middle] < style)
			low = middle + 1;
		else
			high = middle;
	}
	return low < search->styles->count && search->styles->at[low] == style
		? search->paints->at[low]
		: 0;
}

/* The first surface style that a list names, by an assignment or not. */
static uint32_t
list_paint(const struct ifc_file *file, const struct style_search *search,
	struct step_value list, int depth)
{
	struct step_value item;

	while (list.kind == STEP_LIST &&
		step_next(&list.list, &item) > STEP_END) {
		uint32_t style = step_target(file->step, &item);
		uint32_t paint = paint_of(search, style);

		if (!paint && depth == 0 &&
			ifc_entity_of(file, style) ==
				IFC_PRESENTATIONSTYLEASSIGNMENT)
			paint = list_paint(
				file, search, ifc_value(file, style, 0), 1);
		if (paint)
			return paint;
	}
	return 0;
}

static enum tcs_status
painted_add(struct ifc_styles *styles, uint32_t instance, uint32_t paint,
	struct tcs_fault *fault)
{
	if (instance == STEP_NONE || !paint)
		return TCS_OK;
	if (array_grow(&styles->items, 1))
		return fault_memory(fault);
	styles->items.at[styles->items.count++] =
		(struct ifc_painted){instance, paint};
	return TCS_OK;
}

static enum tcs_status
styled_items_read(struct ifc_styles *styles, const struct style_search *search,
	struct ifc_instances *found, struct tcs_fault *fault)
{
	const struct ifc_file *file = styles->file;
	enum tcs_status status;

	array_clear(found);
	status = ifc_collect(file, IFC_STYLEDITEM, found, fault);
	for (size_t i = 0; i < found->count && !status; i++)
		status = painted_add(styles,
			ifc_target(file, found->at[i], STYLED_ITEM),
			list_paint(file, search,
				ifc_value(file, found->at[i], STYLED_STYLES),
				0),
			fault);
	return status;
}

/* The first paint of the styled items of a material's representations. */
static uint32_t
definition_paint(const struct ifc_file *file, const struct style_search *search,
	uint32_t definition)
{
	struct step_value list =
		ifc_value(file, definition, DEFINITION_REPRESENTATIONS);
	struct step_value item, styled;
	uint32_t paint = 0;

	while (!paint && list.kind == STEP_LIST &&
		step_next(&list.list, &item) > STEP_END) {
		struct step_value items = ifc_value(file,
			step_target(file->step, &item), REPRESENTATION_ITEMS);

		while (!paint && items.kind == STEP_LIST &&
			step_next(&items.list, &styled) > STEP_END)
			paint = list_paint(file, search,
				ifc_value(file,
					step_target(file->step, &styled),
					STYLED_STYLES),
				0);
	}
	return paint;
}

static enum tcs_status
material_styles_read(struct ifc_styles *styles,
	const struct style_search *search, struct ifc_instances *found,
	struct tcs_fault *fault)
{
	const struct ifc_file *file = styles->file;
	enum tcs_status status;

	array_clear(found);
	status = ifc_collect(
		file, IFC_MATERIALDEFINITIONREPRESENTATION, found, fault);
	for (size_t i = 0; i < found->count && !status; i++)
		status = painted_add(styles,
			ifc_target(file, found->at[i], DEFINITION_MATERIAL),
			definition_paint(file, search, found->at[i]), fault);
	return status;
}

/* ---- colour maps --------------------------------------------------------- */

static enum tcs_status
colours_read(struct ifc_styles *styles, uint32_t map, uint32_t *count,
	struct tcs_fault *fault)
{
	const struct ifc_file *file = styles->file;
	struct step_value list =
		ifc_value(file, ifc_target(file, map, MAP_COLOURS), 0);
	struct step_value opacity = ifc_value(file, map, MAP_OPACITY), colour;
	struct tcs_material material = {.transparency = 0};
	enum tcs_status status = TCS_OK;
	double opaque;

	*count = 0;
	if (step_number(&opacity, &opaque))
		material.transparency = share(1 - opaque);
	while (!status && list.kind == STEP_LIST &&
		step_next(&list.list, &colour) > STEP_END) {
		double parts[3] = {0};
		char id[IFC_ID_LENGTH + 16], of[IFC_ID_LENGTH];
		uint32_t paint;
		int length;

		if (colour.kind == STEP_LIST)
			step_numbers(&colour.list, parts, 3);
		for (int i = 0; i < 3; i++)
			material.diffuse[i] = share(parts[i]);
		ifc_id(file, map, of);
		length = snprintf(id, sizeof id, "%s.%u", of, *count + 1);
		status = text_append(&styles->palette, id, (size_t)length,
			&material.id, fault);
		if (!status)
			status = material_add(styles, &material, &paint, fault);
		++*count;
	}
	return status;
}

static enum tcs_status
colour_maps_read(struct ifc_styles *styles, struct ifc_instances *found,
	struct tcs_fault *fault)
{
	const struct ifc_file *file = styles->file;
	enum tcs_status status;

	array_clear(found);
	status = ifc_collect(file, IFC_INDEXEDCOLOURMAP, found, fault);
	for (size_t i = 0; i < found->count && !status; i++) {
		uint32_t item = ifc_target(file, found->at[i], MAP_TARGET);
		uint32_t first = (uint32_t)styles->palette.materials.count;
		uint32_t count;

		status = colours_read(styles, found->at[i], &count, fault);
		if (status || !count || item == STEP_NONE)
			continue;
		if (array_grow(&styles->maps, 1))
			return fault_memory(fault);
		styles->maps.at[styles->maps.count++] = (struct ifc_colour_map){
			item, found->at[i], first, count};
	}
	return status;
}

/* ---- the tables ---------------------------------------------------------- */

/* Of two of the same instance, the first of the file stands first. */
static int
painted_order(const void *left, const void *right)
{
	const struct ifc_painted *a = left, *b = right;

	if (a->instance != b->instance)
		return a->instance < b->instance ? -1 : 1;
	return a->paint < b->paint ? -1 : a->paint > b->paint;
}

static int
map_order(const void *left, const void *right)
{
	const struct ifc_colour_map *a = left, *b = right;

	if (a->item != b->item)
		return a->item < b->item ? -1 : 1;
	return a->map < b->map ? -1 : a->map > b->map;
}

enum tcs_status
ifc_styles_read(const struct ifc_file *file, struct ifc_styles *out,
	struct tcs_fault *fault)
{
	struct ifc_instances styles = {.count = 0}, paints = {.count = 0};
	struct ifc_instances found = {.count = 0};
	struct style_search search = {&styles, &paints};
	enum tcs_status status;

	out->file = file;
	status = surface_styles_read(out, &styles, &paints, fault);
	if (!status)
		status = styled_items_read(out, &search, &found, fault);
	if (!status)
		status = material_styles_read(out, &search, &found, fault);
	if (!status)
		status = colour_maps_read(out, &found, fault);
	if (!status && out->items.count)
		qsort(out->items.at, out->items.count, sizeof *out->items.at,
			painted_order);
	if (!status && out->maps.count)
		qsort(out->maps.at, out->maps.count, sizeof *out->maps.at,
			map_order);
	array_release(&styles);
	array_release(&paints);
	array_release(&found);
	return status;
}

void
ifc_styles_release(struct ifc_styles *styles)
{
	palette_release(&styles->palette);
	array_release(&styles->items);
	array_release(&styles->maps);
}

uint32_t
ifc_style_paint(const struct ifc_styles *styles, uint32_t instance)
{
	size_t low = 0, high = styles ? styles->items.count : 0;

	if (instance == STEP_NONE)
		return 0;
	while (low < high) {
		size_t middle = low + (high - low) / 2;

		if (styles->items.at[middle].instance < instance)
			low = middle + 1;
		else
			high = middle;
	}
	return styles && low < styles->items.count &&
			styles->items.at[low].instance == instance
		? styles->items.at[low].paint
		: 0;
}

void
ifc_colours_begin(const struct ifc_styles *styles, uint32_t item,
	struct ifc_colour_walk *out)
{
	size_t low = 0, high = styles ? styles->maps.count : 0;
	const struct ifc_colour_map *map;
	struct step_value list;

	out->count = 0;
	while (low < high) {
		size_t middle = low + (high - low) / 2;

		if (styles->maps.at[middle].item < item)
			low = middle + 1;
		else
			high = middle;
	}
	if (!styles || low == styles->maps.count)
		return;
	map = styles->maps.at + low;
	list = ifc_value(styles->file, map->map, MAP_INDICES);
	if (map->item == item && list.kind == STEP_LIST)
		*out = (struct ifc_colour_walk){
			list.list, map->first, map->count};
}

uint32_t
ifc_colours_next(struct ifc_colour_walk *walk)
{
	struct step_value value;
	int64_t index;

	if (!walk->count || step_next(&walk->indices, &value) <= STEP_END ||
		!step_integer(&value, &index) || index < 1 ||
		index > walk->count)
		return 0;
	return walk->first + (uint32_t)index;
}
