#include "gltf_table.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "labels.h"

enum { PATH_LIMIT = 1024 }; /* bytes of an attribute's full name */

void
property_id(const char *name, char *out)
{
	if (*name >= '0' && *name <= '9')
		*out++ = '_';
	for (; *name; name++) {
		unsigned char c = (unsigned char)*name;

		if ((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
			(c >= '0' && c <= '9') || c == '_')
			*out++ = (char)c;
		else if ((c & 0xc0) != 0x80) /* once per UTF-8 character */
			*out++ = '_';
	}
	*out = '\0';
}

/* The id of a new property: `name` made legal, numbered until it is free. */
static enum tcs_status
claim_property(struct table *table, const char *name, char **out,
	struct tcs_fault *fault)
{
	size_t room = strlen(name) + 24, base;
	char *id = malloc(room);
	uint32_t number;
	bool added = false;
	enum tcs_status status = TCS_OK;

	if (!id)
		return fault_memory(fault);
	property_id(name, id);
	if (!*id)
		memcpy(id, "_", 2);
	base = strlen(id);
	for (unsigned n = 2; !added && !status; n++) {
		status = byte_index_add(&table->properties, id, strlen(id),
			&number, &added, fault);
		if (!added)
			snprintf(id + base, room - base, "_%u", n);
	}
	if (status) {
		free(id);
		return status;
	}
	*out = id;
	return TCS_OK;
}

static enum tcs_status
append_column(struct table *table, const char *name, const char *unit,
	struct tcs_fault *fault)
{
	struct table_column made = {.unit = NULL};
	enum tcs_status status;

	if (array_grow(&table->columns, 1))
		return fault_memory(fault);
	status = claim_property(table, name, &made.property, fault);
	if (status)
		return status;
	made.name = strdup(name);
	made.unit = *unit ? strdup(unit) : NULL;
	table->columns.at[table->columns.count++] = made;
	return made.name && (made.unit || !*unit) ? TCS_OK
						  : fault_memory(fault);
}

enum tcs_status
table_init(struct table *table, uint32_t column_limit, struct tcs_fault *fault)
{
	static const char *const fixed[TABLE_FIXED] = {
		"id", "class", "name", "parent", "type"};
	enum tcs_status status = TCS_OK;

	*table = (struct table){.column_limit = column_limit};
	for (int i = 0; i < TABLE_FIXED && !status; i++) {
		status = append_column(table, fixed[i], "", fault);
		if (!status)
			table->columns.at[i].column.text_only = true;
	}
	return status;
}

/* ---- attributes ------------------------------------------------------- */

static int
push_bytes(void *array, const char *bytes, size_t length)
{
	struct tcs_array *to = array;

	if (array_grow_bytes(array, 1, length + 1))
		return -1;
	memcpy((char *)to->at + to->count, bytes, length + 1);
	to->count += length;
	return 0;
}

/*
 * Leave the full name of an attribute in table->path and keep it for its
 * members. A set stands before its members, so the way up is known.
 */
static int
make_path(struct table *table, const struct tcs_object *object, size_t first,
	size_t number)
{
	const struct tcs_attribute *attribute = object->attributes.at + number;
	const char *name = object_text(object, attribute->name);
	const char *space = object_text(object, attribute->space);

	array_clear(&table->path);
	if (attribute->parent != TCS_NONE) {
		const char *set = table->paths.at +
			table->path_at.at[attribute->parent - first];

		if (push_bytes(&table->path, set, strlen(set)) ||
			push_bytes(&table->path, ".", 1))
			return -1;
	}
	if (*space &&
		(push_bytes(&table->path, space, strlen(space)) ||
			push_bytes(&table->path, ":", 1)))
		return -1;
	if (push_bytes(&table->path, name, strlen(name)))
		return -1;
	if (table->path.count > PATH_LIMIT) {
		table->path.count = 0;
		table->path.at[0] = '\0';
	}
	table->path_at.at[number - first] = table->paths.count;
	if (push_bytes(&table->paths, table->path.at, table->path.count))
		return -1;
	table->paths.count++;
	return 0;
}

/*
 * Find or make the column of the attribute whose path was just made: the
 * `turn`-th of its name in its feature. NULL in *out past the limit.
 */
static enum tcs_status
find_column(struct table *table, const struct tcs_attribute *attribute,
	const char *unit, unsigned turn, struct table_column **out,
	struct tcs_fault *fault)
{
	size_t length = table->path.count;
	uint32_t number;
	bool added;
	enum tcs_status status;
	char mark[40];
	int marked = snprintf(mark, sizeof mark, "\x1f%u\x1f%d\x1f", turn,
		attribute->flags & TCS_ATTRIBUTE_GENERIC);

	*out = NULL;
	if (push_bytes(&table->path, mark, (size_t)marked) ||
		push_bytes(&table->path, unit, strlen(unit)))
		return fault_memory(fault);
	number = byte_index_find(
		&table->keys, table->path.at, table->path.count);
	added = number == INDEX_NONE;
	if (added && table->keys.ends.count >= table->column_limit)
		goto done;
	if (added) {
		status = byte_index_add(&table->keys, table->path.at,
			table->path.count, &number, &added, fault);
		if (status)
			return status;
		table->path.at[length] = '\0';
		status = append_column(table, table->path.at, unit, fault);
		if (status)
			return status;
	}
	*out = table->columns.at + TABLE_FIXED + number;
done:
	table->path.count = length;
	table->path.at[length] = '\0';
	return TCS_OK;
}

static enum column_value
value_kind(const struct tcs_attribute *attribute)
{
	switch (attribute->type) {
	case TCS_INTEGER:
		return VALUE_INTEGER;
	case TCS_DOUBLE:
	case TCS_MEASURE:
		return VALUE_NUMBER;
	case TCS_BOOLEAN:
		return VALUE_TRUTH;
	default:
		return VALUE_TEXT;
	}
}

/* A code space is worth telling while all values of the column share it. */
static enum tcs_status
keep_code_space(struct table_column *column, const char *code_space,
	struct tcs_fault *fault)
{
	bool first = !column->column.rows.count;

	if (column->code_spaces_differ)
		return TCS_OK;
	if (first && *code_space) {
		column->code_space = strdup(code_space);
		return column->code_space ? TCS_OK : fault_memory(fault);
	}
	if (strcmp(column->code_space ? column->code_space : "", code_space)) {
		column->code_spaces_differ = true;
		free(column->code_space);
		column->code_space = NULL;
	}
	return TCS_OK;
}

static bool
row_is_taken(const struct table_column *column, uint32_t row)
{
	size_t count = column->column.rows.count;

	return count && column->column.rows.at[count - 1] == row;
}

static enum tcs_status
add_attribute(struct table *table, const struct tcs_object *object,
	const struct tcs_attribute *attribute, struct report *report,
	struct tcs_fault *fault)
{
	const char *value = object_text(object, attribute->value);
	const char *unit = object_text(object, attribute->unit);
	struct table_column *column = NULL;
	enum tcs_status status = TCS_OK;

	if (attribute->type == TCS_SET || !*value)
		return TCS_OK;
	for (unsigned turn = 1; table->path.count && !status; turn++) {
		status = find_column(
			table, attribute, unit, turn, &column, fault);
		if (!column || !row_is_taken(column, table->row_count))
			break;
	}
	if (status)
		return status;
	if (!column)
		return report_item(report, REPORT_SKIPPED, "attribute",
			table->path.count ? "more columns than --max-columns"
					  : "name is too long",
			object_text(object, attribute->name), TCS_NOWHERE,
			fault);
	status = keep_code_space(
		column, object_text(object, attribute->code_space), fault);
	return status ? status
		      : column_add(&column->column, table->row_count,
				value_kind(attribute), attribute->number, value,
				strlen(value), fault);
}

static enum tcs_status
add_attributes(struct table *table, const struct tcs_object *object,
	size_t first, size_t end, struct report *report,
	struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	array_clear(&table->paths);
	array_clear(&table->path_at);
	if (array_grow(&table->path_at, end - first))
		return fault_memory(fault);
	for (size_t i = first; i < end && !status; i++) {
		if (make_path(table, object, first, i))
			return fault_memory(fault);
		status = add_attribute(table, object, object->attributes.at + i,
			report, fault);
	}
	return status;
}

/* ---- rows ------------------------------------------------------------ */

static enum tcs_status
add_fixed(struct table *table, int which, const char *text,
	struct tcs_fault *fault)
{
	return column_add(&table->columns.at[which].column, table->row_count,
		VALUE_TEXT, 0, text, strlen(text), fault);
}

enum tcs_status
table_add(struct table *table, const struct tcs_object *object,
	uint32_t feature, const char *id, const char *parent, size_t first,
	size_t end, struct report *report, struct tcs_fault *fault)
{
	const struct tcs_feature *of = object->features.at + feature;
	enum tcs_status status;

	if (table->row_count >= TABLE_MAX_ROWS)
		return fault_set(fault, TCS_LIMIT, TCS_NOWHERE,
			"more than %u features: their numbers would not be "
			"exact in 32-bit floats; convert the city in parts",
			TABLE_MAX_ROWS);
	status = add_fixed(table, TABLE_ID, id, fault);
	if (!status)
		status = add_fixed(
			table, TABLE_CLASS, label_of(of->class)->name, fault);
	if (!status)
		status = add_fixed(table, TABLE_NAME,
			object_text(object, of->name), fault);
	if (!status)
		status = add_fixed(table, TABLE_PARENT, parent, fault);
	if (!status)
		status = add_fixed(table, TABLE_TYPE,
			object_text(object, of->type), fault);
	if (!status && first < end)
		status = add_attributes(
			table, object, first, end, report, fault);
	if (!status)
		table->row_count++;
	return status;
}

void
table_release(struct table *table)
{
	for (size_t i = 0; i < table->columns.count; i++) {
		struct table_column *column = table->columns.at + i;

		column_release(&column->column);
		free(column->property);
		free(column->name);
		free(column->unit);
		free(column->code_space);
	}
	array_release(&table->columns);
	byte_index_release(&table->keys);
	byte_index_release(&table->properties);
	array_release(&table->path);
	array_release(&table->paths);
	array_release(&table->path_at);
}
