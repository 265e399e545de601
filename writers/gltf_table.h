/*
 * A property table: what is known of every feature of one feature-id set.
 *
 * Every row has `id` and `class`; `name`, `parent` and `type` follow where
 * some row has one, then a column per attribute. Members of attribute sets are
 * named by their path, "address.street". An attribute that a feature has more
 * than once takes further columns ("function", "function_2"), and so does one
 * that comes in different units.
 */
#ifndef TESSERA_GLTF_TABLE_H
#define TESSERA_GLTF_TABLE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "array.h"
#include "byte_index.h"
#include "fault.h"
#include "gltf_column.h"
#include "report.h"
#include "tcs.h"

enum {
	TABLE_ID,
	TABLE_CLASS,
	TABLE_NAME,
	TABLE_PARENT,
	TABLE_TYPE,
	TABLE_FIXED, /* columns that every table begins with */
};

/* Rows that 32-bit floats tell apart: feature ids may be FLOAT. */
#define TABLE_MAX_ROWS (UINT32_C(1) << 24)

struct table_column {
	struct column column;
	char *property; /* its id: [a-zA-Z_][a-zA-Z0-9_]*, unique; owned */
	char *name; /* as the source spells it; owned */
	char *unit; /* NULL without; owned */
	char *code_space; /* the one of all values; NULL; owned */
	bool code_spaces_differ;
};

struct table {
	uint32_t row_count;
	uint32_t column_limit; /* columns of attributes; more are reported */
	TCS_ARRAY(struct table_column) columns;
	struct byte_index keys; /* of attribute columns, from TABLE_FIXED on */
	struct byte_index properties; /* ids in use */
	TCS_ARRAY(char) path; /* scratch */
	TCS_ARRAY(char) paths; /* scratch: the sets' names so far */
	TCS_ARRAY(size_t) path_at; /* scratch: per attribute */
};

enum tcs_status table_init(struct table *table, uint32_t column_limit,
	struct tcs_fault *fault) TCS_CHECKED;

/*
 * Append one row: the feature and, `with_attributes`, its attributes
 * [first, end) of the object. `id` and `parent` are given, because a feature
 * without an id gets one. Fails with TCS_NO_MEMORY, or with TCS_LIMIT past
 * TABLE_MAX_ROWS.
 */
enum tcs_status table_add(struct table *table, const struct tcs_object *object,
	uint32_t feature, const char *id, const char *parent, size_t first,
	size_t end, struct report *report, struct tcs_fault *fault) TCS_CHECKED;

/*
 * Turn a name into a property id: letters, digits and '_' stay, other
 * characters become one '_' each, a leading digit gets a '_' before it.
 * `out` has room for twice the length plus 2.
 */
void property_id(const char *name, char *out);

void table_release(struct table *table);

#endif
