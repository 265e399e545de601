/*
 * Names as they are spelled, "gml:posList", and what they mean where they
 * stand: the namespaces in force.
 *
 * libxml2's parser interns what is spelled, once for each name; so a name that
 * has been met in this scope costs a look into a table of pointers.
 *
 * source: Namespaces in XML 1.0, third edition. Undeclared prefixes pass.
 */
#ifndef TESSERA_CITYGML_NAMESPACES_H
#define TESSERA_CITYGML_NAMESPACES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <libxml/parser.h>

#include "array.h"
#include "citygml_names.h"

struct spelling {
	const char *spelled; /* by libxml2; NULL: a free slot */
	const char *prefix; /* NULL for none */
	const char *local;
	bool declares; /* as an attribute: it is "xmlns" or "xmlns:…" */
	struct name *name; /* in this scope; NULL: not looked up */
	uint64_t scope;
};

struct namespace_binding {
	const char *prefix; /* NULL for the default */
	const char *uri; /* NULL: none */
	uint64_t outer; /* the scope around it */
	unsigned depth; /* of the element that declares it */
};

/*
 * All zero is empty. What is not as the parser interned it is interned in
 * `parts`: the parser's own table is fastest while there is little in it.
 */
struct namespaces {
	xmlDictPtr parts; /* made with the first name */
	TCS_ARRAY(struct spelling) slots; /* the count is a power of 2 */
	size_t used;
	TCS_ARRAY(struct namespace_binding) bindings;
	uint64_t scope; /* changes with the bindings */
	uint64_t last_scope;
};

void namespaces_release(struct namespaces *namespaces);

/* Interned pointers differ in their middle bits; mix them down. */
static inline size_t
spelling_slot(const struct namespaces *namespaces, const char *spelled)
{
	uint64_t mixed = (uint64_t)(uintptr_t)spelled * 0x9e3779b97f4a7c15u;

	return (size_t)(mixed >> 32) & (namespaces->slots.count - 1);
}

/* The one of this name, made if need be. */
struct spelling *spelling_look(
	struct namespaces *namespaces, const char *spelled);

/* Valid until the next call. NULL without memory. */
static inline struct spelling *
spelling_find(struct namespaces *namespaces, const char *spelled)
{
	struct spelling *first;

	if (!namespaces->used)
		return spelling_look(namespaces, spelled);
	first = &namespaces->slots.at[spelling_slot(namespaces, spelled)];
	return first->spelled == spelled ? first
					 : spelling_look(namespaces, spelled);
}

/*
 * The element at this depth has an attribute that declares, of this value. What must not
 * be declared is not. Fails with TCS_NO_MEMORY, and with TCS_LIMIT beyond
 * MAX_BINDINGS that are in force.
 */
enum { MAX_BINDINGS = 2000 };
enum tcs_status namespace_declare(struct namespaces *namespaces,
	const struct spelling *spelling, const char *value, unsigned depth,
	struct tcs_fault *fault) TCS_CHECKED;

/* The element at this depth ends. */
static inline void
namespaces_leave(struct namespaces *namespaces, unsigned depth)
{
	while (namespaces->bindings.count &&
		namespaces->bindings.at[namespaces->bindings.count - 1].depth ==
			depth)
		namespaces->scope =
			namespaces->bindings.at[--namespaces->bindings.count]
				.outer;
}

/* What the prefix stands for; NULL: nothing. */
const char *namespace_find(
	const struct namespaces *namespaces, const char *prefix);

/* The name that an element is spelled like; NULL without memory. */
struct name *spelling_mean(const struct namespaces *namespaces,
	struct names *names, struct spelling *spelling);

#endif
