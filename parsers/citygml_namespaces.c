#include "citygml_namespaces.h"

#include <string.h>

void
namespaces_release(struct namespaces *namespaces)
{
	xmlDictFree(namespaces->parts);
	array_release(&namespaces->slots);
	array_release(&namespaces->bindings);
	*namespaces = (struct namespaces){.used = 0};
}

/* ---- spellings --------------------------------------------------------------- */

static const char *
intern(struct namespaces *namespaces, const char *at, size_t length)
{
	return (const char *)xmlDictLookup(
		namespaces->parts, (const xmlChar *)at, (int)length);
}

static struct spelling *
slot_of(const struct namespaces *namespaces, const char *spelled)
{
	size_t mask = namespaces->slots.count - 1;
	size_t i = spelling_slot(namespaces, spelled);
	struct spelling *slots = namespaces->slots.at;

	while (slots[i].spelled && slots[i].spelled != spelled)
		i = (i + 1) & mask;
	return &slots[i];
}

static int
slots_grow(struct namespaces *namespaces)
{
	struct namespaces old = *namespaces;
	size_t room = old.slots.count ? old.slots.count * 2 : 512;

	memset(&namespaces->slots, 0, sizeof namespaces->slots);
	if (array_grow(&namespaces->slots, room)) {
		namespaces->slots = old.slots;
		return -1;
	}
	memset(namespaces->slots.at, 0, room * sizeof *namespaces->slots.at);
	namespaces->slots.count = room;
	for (size_t i = 0; i < old.slots.count; i++)
		if (old.slots.at[i].spelled)
			*slot_of(namespaces, old.slots.at[i].spelled) =
				old.slots.at[i];
	array_release(&old.slots);
	return 0;
}

/* What could not begin a name does not follow a prefix. */
static bool
begins_name(char byte)
{
	return byte && byte != ':' && byte != '-' && byte != '.' &&
		(byte < '0' || byte > '9');
}

static bool
is_xmlns(const char *text)
{
	return text && !strcmp(text, "xmlns");
}

static int
spelling_part(struct namespaces *namespaces, struct spelling *spelling)
{
	const char *local = spelling->spelled;
	const char *colon = strchr(local, ':');

	if (colon && colon > local && begins_name(colon[1])) {
		spelling->prefix =
			intern(namespaces, local, (size_t)(colon - local));
		if (!spelling->prefix)
			return -1;
		local = colon + 1;
	}
	spelling->local = intern(namespaces, local, strlen(local));
	spelling->declares =
		is_xmlns(spelling->prefix ? spelling->prefix : spelling->local);
	return spelling->local ? 0 : -1;
}

struct spelling *
spelling_look(struct namespaces *namespaces, const char *spelled)
{
	struct spelling made = {.spelled = spelled}, *slot;

	if (!namespaces->parts)
		namespaces->parts = xmlDictCreate();
	if (!namespaces->parts)
		return NULL;
	/* Few share a slot, so that nearly all are found at first sight. */
	if (namespaces->used * 4 >= namespaces->slots.count &&
		slots_grow(namespaces))
		return NULL;
	slot = slot_of(namespaces, spelled);
	if (slot->spelled)
		return slot;
	if (spelling_part(namespaces, &made))
		return NULL;
	*slot = made;
	namespaces->used++;
	return slot;
}

/* ---- declarations -------------------------------------------------------------- */

static const struct namespace_binding *
binding_find(const struct namespaces *namespaces, const char *prefix)
{
	const struct namespace_binding *first = namespaces->bindings.at;

	for (size_t i = namespaces->bindings.count; i-- > 0;)
		if (first[i].prefix == prefix)
			return &first[i];
	return NULL;
}

const char *
namespace_find(const struct namespaces *namespaces, const char *prefix)
{
	const struct namespace_binding *binding =
		binding_find(namespaces, prefix);

	return binding ? binding->uri : NULL;
}

enum tcs_status
namespace_declare(struct namespaces *namespaces,
	const struct spelling *spelling, const char *value, unsigned depth,
	struct tcs_fault *fault)
{
	const char *prefix = spelling->prefix ? spelling->local : NULL;
	const char *uri = NULL;

	if (prefix && (!*value || !strcmp(prefix, "xml") || is_xmlns(prefix)))
		return TCS_OK;
	if (*value)
		uri = intern(namespaces, value, strlen(value));
	if (*value && !uri)
		return fault_memory(fault);
	if (namespace_find(namespaces, prefix) == uri)
		return TCS_OK;
	if (namespaces->bindings.count == MAX_BINDINGS)
		return fault_set(fault, TCS_LIMIT, TCS_NOWHERE,
			"more than %d namespaces are in force", MAX_BINDINGS);
	if (array_grow(&namespaces->bindings, 1))
		return fault_memory(fault);
	namespaces->bindings.at[namespaces->bindings.count++] =
		(struct namespace_binding){
			prefix, uri, namespaces->scope, depth};
	namespaces->scope = ++namespaces->last_scope;
	return TCS_OK;
}

struct name *
spelling_mean(const struct namespaces *namespaces, struct names *names,
	struct spelling *spelling)
{
	if (!spelling->name || spelling->scope != namespaces->scope) {
		spelling->name =
			names_find(names, spelling->local, spelling->prefix,
				namespace_find(namespaces, spelling->prefix));
		spelling->scope = namespaces->scope;
	}
	return spelling->name;
}
