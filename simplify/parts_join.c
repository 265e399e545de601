/* Parts that become one: see parts.h. */
#include "parts.h"

uint32_t
parts_host(const struct parts *parts, uint32_t part)
{
	while (parts->at.at[part].host != part)
		part = parts->at.at[part].host;
	return part;
}

/* Whether something below a part, which carries it, is marked. */
static bool
stands_on_marked(const struct parts *parts, uint32_t part)
{
	const struct part *at = parts->at.at;

	while (at[part].parent != part) {
		part = at[part].parent;
		if (parts->marks.at[part] == parts->mark)
			return true;
	}
	return false;
}

/* The one that stands on none of the others: what carries it can carry all. */
static uint32_t
lowest(const struct parts *parts, const uint32_t *numbers, size_t count)
{
	for (size_t i = 0; i < count; i++)
		if (!stands_on_marked(parts, numbers[i]))
			return numbers[i];
	return numbers[0];
}

/* The faces of all, in a run of its own. */
static enum tcs_status
join_faces(struct parts *parts, const uint32_t *numbers, size_t count,
	uint32_t host, struct tcs_fault *fault)
{
	uint32_t first = (uint32_t)parts->faces.count;

	for (size_t i = 0; i < count; i++) {
		const struct part *own = &parts->at.at[numbers[i]];

		if (array_grow(&parts->faces, own->count))
			return fault_memory(fault);
		for (uint32_t k = 0; k < own->count; k++) {
			uint32_t face = parts->faces.at[own->first + k];

			parts->numbers.at[face] = host;
			parts->faces.at[parts->faces.count++] = face;
		}
	}
	parts->at.at[host].first = first;
	parts->at.at[host].count = (uint32_t)parts->faces.count - first;
	return TCS_OK;
}

/* Those linked to one of them are linked to the host now. */
static void
turn_links(struct parts *parts, uint32_t part, uint32_t host)
{
	const struct part *own = &parts->at.at[part];

	for (uint32_t i = 0; i < own->link_count; i++)
		if (parts->links.at[own->first_link + i] != host &&
			parts->marks.at[parts->links.at[own->first_link + i]] ==
				parts->mark)
			parts->links.at[own->first_link + i] = host;
}

/* The links of all to others, each once, in a run of its own. */
static enum tcs_status
join_links(struct parts *parts, const uint32_t *numbers, size_t count,
	uint32_t host, struct tcs_fault *fault)
{
	uint32_t first = (uint32_t)parts->links.count;

	parts->queue.count = 0;
	for (size_t i = 0; i < count; i++) {
		const struct part *own = &parts->at.at[numbers[i]];

		if (array_grow(&parts->links, own->link_count))
			return fault_memory(fault);
		for (uint32_t k = 0; k < own->link_count; k++) {
			uint32_t other = parts->links.at[own->first_link + k];

			if (parts->marks.at[other] >= parts->mark)
				continue;
			parts->marks.at[other] = parts->mark + 1;
			parts->links.at[parts->links.count++] = other;
		}
	}
	parts->at.at[host].first_link = first;
	parts->at.at[host].link_count = (uint32_t)parts->links.count - first;
	for (uint32_t i = first; i < parts->links.count; i++)
		turn_links(parts, parts->links.at[i], host);
	return TCS_OK;
}

/* What stood on them stands on the host. */
static void
join_carried(struct parts *parts, uint32_t host, uint32_t low)
{
	struct part *own = &parts->at.at[host];
	uint32_t parent = parts->at.at[low].parent;
	bool grounded = parent == low;

	for (uint32_t i = 0; i < own->link_count; i++) {
		struct part *other =
			&parts->at.at[parts->links.at[own->first_link + i]];

		if (other->gone ||
			parts->marks.at[other->parent] != parts->mark)
			continue;
		parts->at.at[other->parent].children--;
		other->parent = host;
		own->children++;
	}
	own->parent = grounded ? host : parent;
}

enum tcs_status
parts_join(struct parts *parts, const uint32_t *numbers, size_t count,
	uint32_t host, struct tcs_fault *fault)
{
	enum tcs_status status;
	uint32_t low;

	parts->mark++;
	for (size_t i = 0; i < count; i++)
		parts->marks.at[numbers[i]] = parts->mark;
	low = lowest(parts, numbers, count);
	for (size_t i = 0; i < count; i++) {
		struct part *own = &parts->at.at[numbers[i]];

		/* Up to now it was a child of its parent. */
		if (own->parent != numbers[i])
			parts->at.at[own->parent].children--;
	}
	status = join_faces(parts, numbers, count, host, fault);
	if (!status)
		status = join_links(parts, numbers, count, host, fault);
	if (status)
		return status;
	join_carried(parts, host, low);
	if (parts->at.at[host].parent != host)
		parts->at.at[parts->at.at[host].parent].children++;
	for (size_t i = 0; i < count; i++) {
		struct part *own = &parts->at.at[numbers[i]];

		if (numbers[i] == host)
			continue;
		box_add(&parts->at.at[host].box, &own->box);
		parts->at.at[host].area += own->area;
		parts->left.at[own->component]--;
		own->host = host;
		own->gone = true;
		own->parent = numbers[i];
		own->children = 0;
	}
	parts->mark++;
	return TCS_OK;
}
