#include "citygml_schema.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

#define MAX_PROPERTIES 64 /* of one class */

/* In the order of enum content; the words of the tables. */
static const char *const content_words[] = {"string", "code", "uri", "date",
	"time", "year", "boolean", "integer", "count", "double", "measure",
	"measures", "level", "terrain", "water", "spacetype", "condition",
	"relation", "granularity", "direction", "external", "address", "set",
	"grid", "solid", "multisolid", "multisurface", "surface", "multicurve",
	"multipoint", "point", "geometry", "complex", "tin", "polygon",
	"implicit", "feature", "member", "role", "link", "generic",
	"appearance"};

#define SURFACES \
	"RoofSurface|WallSurface|GroundSurface|ClosureSurface|FloorSurface|" \
	"OuterFloorSurface|InteriorWallSurface|CeilingSurface|" \
	"OuterCeilingSurface"

/* Names for long lists of classes. */
static const struct {
	const char *name, *classes;
} families[] = {
	{"SURFACE", SURFACES},
	{"BOUNDARY",
		SURFACES "|WindowSurface|DoorSurface|GenericThematicSurface|"
			 "TrafficArea|AuxiliaryTrafficArea|Marking|HoleSurface|"
			 "WaterSurface|WaterGroundSurface|LandUse|"
			 "ReliefFeature|TINRelief|MassPointRelief|"
			 "BreaklineRelief|RasterRelief"},
};

static size_t
word_length(const char *at, const char *ends)
{
	return strcspn(at, ends);
}

static void
read_classes(struct property *property, const char *at, size_t length)
{
	for (size_t i = 0; i < sizeof families / sizeof *families; i++) {
		if (strlen(families[i].name) != length ||
			memcmp(families[i].name, at, length))
			continue;
		at = families[i].classes;
		length = strlen(at);
		break;
	}
	for (const char *end = at + length; at < end;) {
		size_t part = word_length(at, "|*!@ ");
		unsigned class = label_find(at, part);

		assert(class != TCS_CLASS_Unknown);
		property->classes[class / 64] |= (uint64_t)1 << class % 64;
		at += part + 1;
	}
}

static void
read_content(struct property *property, const char *at, size_t length)
{
	if (*at == '>') {
		property->content = CONTENT_FEATURE;
		read_classes(property, at + 1, length - 1);
		return;
	}
	if (length > 4 && !memcmp(at, "set=", 4)) {
		property->content = CONTENT_SET;
		memcpy(property->inner, at + 4, length - 4);
		return;
	}
	while (strlen(content_words[property->content]) != length ||
		memcmp(content_words[property->content], at, length)) {
		property->content++;
		assert(property->content <
			sizeof content_words / sizeof *content_words);
	}
}

/* Returns whether the version has it. */
static bool
read_marks(struct property *property, const char *at, enum gml_version version)
{
	bool has = true;

	for (; *at && *at != ' '; at++)
		switch (*at) {
		case '*':
			property->many = true;
			break;
		case '!':
			property->required = true;
			break;
		case '1':
			has = has && version == GML_1_0;
			break;
		case '2':
			has = has && version != GML_1_0;
			break;
		case 'g':
			memcpy(property->module, "gml", 4);
			break;
		}
	return has;
}

/* One "name:content…" at *at; moves *at behind it. */
static bool
read_property(struct property *property, const char *module, const char **at,
	enum gml_version version)
{
	size_t length = word_length(*at, ":");
	bool has;

	*property = (struct property){.lod = SCHEMA_LOD_NONE};
	strcpy(property->module, module);
	assert(length < sizeof property->name);
	memcpy(property->name, *at, length);
	property->length = (uint8_t)length;
	if (!strncmp(*at, "lod", 3) && (*at)[3] >= '0' && (*at)[3] <= '4')
		property->lod = (uint8_t)((*at)[3] - '0');
	*at += length + 1;
	length = word_length(*at, "*!@ ");
	read_content(property, *at, length);
	*at += length;
	has = read_marks(property, *at, version);
	*at += word_length(*at, " ");
	*at += strspn(*at, " ");
	return has;
}

static const struct schema_row *
find_row(const struct schema_table *table, const char *module, const char *name)
{
	for (size_t i = 0; i < table->count; i++)
		if (!strcmp(table->rows[i].name, name) &&
			(!module || !strcmp(table->rows[i].module, module)))
			return &table->rows[i];
	return NULL;
}

/* The properties of a row behind those of the rows it extends. */
static uint16_t
flatten(struct property *out, const struct schema_table *table,
	const struct schema_row *row, enum gml_version version)
{
	const struct schema_row *chain[16];
	uint16_t count = 0;
	size_t depth = 0;

	for (; row; row = row->base ? find_row(table, NULL, row->base) : NULL) {
		assert(depth < sizeof chain / sizeof *chain);
		chain[depth++] = row;
	}
	while (depth-- > 0) {
		const char *at = chain[depth]->properties;

		while (*at) {
			assert(count < MAX_PROPERTIES);
			if (read_property(&out[count], chain[depth]->module,
				    &at, version))
				count++;
		}
	}
	return count;
}

/* CityGML 1.0 knows neither bridges nor tunnels, nor these two surfaces. */
static bool
version_has(enum gml_version version, unsigned class)
{
	const struct label *label = label_of(class);
	const char *module =
		version == GML_3_0 ? label->module_3 : label->module_2;

	if (!module)
		return false;
	if (version != GML_1_0)
		return true;
	return strcmp(module, "brid") && strcmp(module, "tun") &&
		class != TCS_CLASS_OuterFloorSurface &&
		class != TCS_CLASS_OuterCeilingSurface;
}

enum tcs_status
schema_init(struct schema *schema, enum gml_version version,
	struct tcs_fault *fault)
{
	const struct schema_table *table =
		version == GML_3_0 ? &schema_table_3 : &schema_table_2;
	size_t used = 0;

	*schema = (struct schema){.version = version};
	schema->all = calloc(
		(size_t)TCS_CLASS_COUNT * MAX_PROPERTIES, sizeof *schema->all);
	if (!schema->all)
		return fault_memory(fault);
	for (unsigned i = 0; i < TCS_CLASS_COUNT; i++) {
		const struct label *label = label_of(i);
		struct schema_class *class = &schema->classes[i];
		const struct schema_row *row;

		if (!version_has(version, i))
			continue;
		class->module =
			version == GML_3_0 ? label->module_3 : label->module_2;
		class->name =
			version == GML_3_0 ? label->name_3 : label->name_2;
		row = find_row(table, class->module, class->name);
		assert(row);
		class->properties = &schema->all[used];
		class->count = flatten(&schema->all[used], table, row, version);
		used += class->count;
	}
	return TCS_OK;
}

void
schema_release(struct schema *schema)
{
	free(schema->all);
	*schema = (struct schema){0};
}

uint16_t
schema_find(const struct schema_class *of, const char *name)
{
	size_t length = strlen(name);

	for (uint16_t i = 0; i < of->count; i++)
		if (of->properties[i].length == length &&
			!memcmp(of->properties[i].name, name, length))
			return i;
	return SCHEMA_NONE;
}

uint16_t
schema_find_content(const struct schema_class *of, enum content content)
{
	for (uint16_t i = 0; i < of->count; i++)
		if (of->properties[i].content == content)
			return i;
	return SCHEMA_NONE;
}

bool
schema_may_hold(const struct property *property, unsigned class)
{
	if (property->content == CONTENT_MEMBER)
		return true;
	return property->content == CONTENT_FEATURE &&
		class < TCS_CLASS_COUNT &&
		(property->classes[class / 64] >> class % 64 & 1);
}

uint16_t
schema_find_child(
	const struct schema_class *of, unsigned class, const char *role)
{
	uint16_t named = *role ? schema_find(of, role) : SCHEMA_NONE;

	if (named != SCHEMA_NONE &&
		schema_may_hold(&of->properties[named], class))
		return named;
	for (uint16_t i = 0; i < of->count; i++)
		if (schema_may_hold(&of->properties[i], class))
			return i;
	return SCHEMA_NONE;
}
