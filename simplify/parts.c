#include "parts.h"

#include <math.h>
#include <stdlib.h>

#include "forest.h"
#include "node_queue.h"
#include "vector.h"

struct search {
	struct parts *parts;
	const struct component_set *set;
	const struct sheets *sheets;
	struct tcs_fault *fault;
};

/* ---- the parts ----------------------------------------------------------- */

/* The part of every face, numbered by its first face. */
static enum tcs_status
number_parts(struct search *search)
{
	const struct sheets *sheets = search->sheets;
	struct parts *parts = search->parts;
	uint32_t faces = (uint32_t)sheets->face_triangles.count;
	uint32_t *parents = calloc((size_t)faces + 1, sizeof *parents);

	if (!parents || array_grow(&parts->numbers, faces)) {
		free(parents);
		return fault_memory(search->fault);
	}
	for (uint32_t i = 0; i < faces; i++)
		parents[i] = i;
	for (uint32_t i = 0; i < 3 * faces; i++) {
		uint32_t back = sheets->opposites.at[i];

		if (back != HALF_EDGE_NONE && back > i)
			forest_join(parents, i / 3, back / 3);
	}
	for (uint32_t i = 0; i < faces; i++) {
		uint32_t root = forest_root(parents, i);

		parts->numbers.at[i] = root == i ? (uint32_t)parts->count++
						 : parts->numbers.at[root];
	}
	parts->numbers.count = faces;
	free(parents);
	return TCS_OK;
}

/* Sort the faces by their part: count, then place. */
static enum tcs_status
sort_faces(struct search *search)
{
	struct parts *parts = search->parts;
	size_t faces = parts->numbers.count;
	uint32_t first = 0;

	if (array_grow(&parts->at, parts->count + 1) ||
		array_grow(&parts->faces, faces))
		return fault_memory(search->fault);
	for (size_t i = 0; i <= parts->count; i++)
		parts->at.at[i] =
			(struct part){.parent = TCS_NONE, .host = (uint32_t)i};
	for (size_t i = 0; i < faces; i++)
		parts->at.at[parts->numbers.at[i]].count++;
	for (size_t i = 0; i <= parts->count; i++) {
		struct part *part = &parts->at.at[i];

		part->first = first;
		first += part->count;
		part->count = 0;
	}
	for (uint32_t i = 0; i < faces; i++) {
		struct part *part = &parts->at.at[parts->numbers.at[i]];

		parts->faces.at[part->first + part->count++] = i;
	}
	parts->at.count = parts->count + 1;
	parts->faces.count = faces;
	return TCS_OK;
}

/* Box, area and depth. A part of a closed component is closed itself, as a
   rule; for an open one the volume says nothing, and is not more than that of
   a box. */
static void
measure_part(const struct search *search, struct part *part)
{
	const uint32_t *faces = search->parts->faces.at + part->first;
	struct tcs_point origin = {0};
	double volume = 0;

	part->box = BOX_EMPTY;
	for (uint32_t i = 0; i < part->count; i++) {
		uint32_t triangle = search->sheets->face_triangles.at[faces[i]];
		struct triangle_shape shape =
			component_set_shape(search->set, triangle);
		struct tcs_point normal;

		part->component = search->set->numbers.at[triangle];
		if (i == 0)
			origin = shape.corner[0];
		for (int k = 0; k < 3; k++)
			box_add_point(&part->box, shape.corner[k]);
		normal = triangle_normal(&shape);
		part->area += vector_length(normal) / 2;
		volume += vector_dot(vector_difference(shape.corner[0], origin),
				  normal) /
			6;
	}
	if (part->area > 0)
		part->depth = 3 * fabs(volume) / part->area;
}

static enum tcs_status
count_components(struct search *search, const struct contact_list *contacts)
{
	struct parts *parts = search->parts;
	size_t count = search->set->components.count;

	if (array_grow(&parts->left, count) ||
		array_grow(&parts->enclosed, count))
		return fault_memory(search->fault);
	parts->left.count = parts->enclosed.count = count;
	for (size_t i = 0; i < count; i++)
		parts->left.at[i] = parts->enclosed.at[i] = 0;
	for (size_t i = 0; i < parts->count; i++)
		parts->left.at[parts->at.at[i].component]++;
	for (size_t i = 0; i < contacts->count; i++) {
		parts->enclosed.at[contacts->at[i].a] += contacts->at[i].inside;
		parts->enclosed.at[contacts->at[i].b] += contacts->at[i].inside;
	}
	return TCS_OK;
}

/* ---- links --------------------------------------------------------------- */

/* Points of one seam stand in a row. */
static bool
is_last_pair(const struct parts *parts, uint32_t a, uint32_t b)
{
	size_t count = parts->pairs.count;

	return count > 0 && parts->pairs.at[count - 2] == a &&
		parts->pairs.at[count - 1] == b;
}

static enum tcs_status
add_link(struct search *search, uint32_t a, uint32_t b)
{
	struct parts *parts = search->parts;

	if (a == b || a == TCS_NONE || b == TCS_NONE ||
		is_last_pair(parts, a, b))
		return TCS_OK;
	if (array_grow(&parts->pairs, 2))
		return fault_memory(search->fault);
	parts->pairs.at[parts->pairs.count++] = a;
	parts->pairs.at[parts->pairs.count++] = b;
	return TCS_OK;
}

/* Parts that meet at a node: each with the one before. */
static enum tcs_status
link_twins(struct search *search)
{
	const struct sheets *sheets = search->sheets;
	size_t nodes = sheets->node_count;
	uint32_t *last = malloc((nodes + 1) * sizeof *last);
	enum tcs_status status = TCS_OK;

	if (!last)
		return fault_memory(search->fault);
	for (size_t i = 0; i < nodes; i++)
		last[i] = TCS_NONE;
	for (size_t i = 0; !status && i < sheets->corners.count; i++) {
		uint32_t node = sheets->vertex_nodes.at[sheets->corners.at[i]];
		uint32_t part = search->parts->numbers.at[i / 3];

		if (last[node] != part)
			status = add_link(search, last[node], part);
		last[node] = part;
	}
	free(last);
	return status;
}

static enum tcs_status
link_seams(struct search *search, const struct seams *seams)
{
	const uint32_t *numbers = search->parts->numbers.at;
	enum tcs_status status = TCS_OK;

	for (size_t i = 0; !status && i < seams->holds.count; i += 2) {
		uint32_t a = seams->holds.at[i].face;
		uint32_t b = seams->holds.at[i + 1].face;

		if (a != TCS_NONE && b != TCS_NONE)
			status = add_link(search, numbers[a], numbers[b]);
	}
	return status;
}

/* A part of either component, where one encloses the other. */
static enum tcs_status
link_enclosed(struct search *search, const struct contact_list *contacts)
{
	const struct component_set *set = search->set;
	enum tcs_status status = TCS_OK;

	for (size_t i = 0; !status && i < contacts->count; i++) {
		const struct contact *contact = &contacts->at[i];
		const uint32_t sides[2] = {contact->a, contact->b};
		uint32_t parts[2] = {TCS_NONE, TCS_NONE};

		for (int k = 0; contact->inside && k < 2; k++) {
			const struct component *component =
				&set->components.at[sides[k]];
			uint32_t triangle = set->order.at[component->first];
			uint32_t face =
				search->sheets->triangle_faces.at[triangle];

			if (face != TCS_NONE)
				parts[k] = search->parts->numbers.at[face];
		}
		status = add_link(search, parts[0], parts[1]);
	}
	return status;
}

/* The links by part, from the pairs: count, then place. */
static enum tcs_status
sort_links(struct search *search)
{
	struct parts *parts = search->parts;
	uint32_t first = 0;

	if (array_grow(&parts->links, parts->pairs.count))
		return fault_memory(search->fault);
	parts->links.count = parts->pairs.count;
	for (size_t i = 0; i < parts->pairs.count; i++)
		parts->at.at[parts->pairs.at[i] + 1].first_link++;
	for (size_t i = 0; i <= parts->count; i++)
		first = parts->at.at[i].first_link += first;
	/* Each place moves to its part's end, which is the next one's first. */
	for (size_t i = parts->pairs.count; i-- > 0;) {
		uint32_t own = parts->pairs.at[i];
		uint32_t place = --parts->at.at[own + 1].first_link;

		parts->links.at[place] = parts->pairs.at[i ^ 1];
	}
	for (size_t i = 0; i < parts->count; i++)
		parts->at.at[i].first_link = parts->at.at[i + 1].first_link;
	parts->at.at[parts->count].first_link = (uint32_t)parts->pairs.count;
	array_trim(&parts->pairs);
	return TCS_OK;
}

/* Each of the links of a part once. */
static enum tcs_status
drop_repeated_links(struct search *search)
{
	struct parts *parts = search->parts;
	uint32_t *seen = malloc((parts->count + 1) * sizeof *seen);
	uint32_t kept = 0;

	if (!seen)
		return fault_memory(search->fault);
	for (size_t i = 0; i < parts->count; i++)
		seen[i] = TCS_NONE;
	for (uint32_t i = 0; i < parts->count; i++) {
		uint32_t link = parts->at.at[i].first_link;
		uint32_t end = parts->at.at[i + 1].first_link;

		parts->at.at[i].first_link = kept;
		for (; link < end; link++) {
			uint32_t other = parts->links.at[link];

			if (seen[other] != i)
				parts->links.at[kept++] = other;
			seen[other] = i;
		}
		parts->at.at[i].link_count = kept - parts->at.at[i].first_link;
	}
	parts->links.count = kept;
	free(seen);
	return TCS_OK;
}

/* ---- standing ------------------------------------------------------------ */

static void
put_on(struct parts *parts, uint32_t part, uint32_t parent)
{
	struct part *own = &parts->at.at[part];

	own->parent = parent;
	if (part != parent)
		parts->at.at[parent].children++;
}

/* Whoever is linked to those in the queue from `next` on, and has no parent,
   stands on them. There is room for all. */
static void
carry(struct parts *parts, size_t next)
{
	for (; next < parts->queue.count; next++) {
		uint32_t part = parts->queue.at[next];
		const struct part *own = &parts->at.at[part];

		for (uint32_t i = 0; i < own->link_count; i++) {
			uint32_t other = parts->links.at[own->first_link + i];

			if (parts->at.at[other].parent != TCS_NONE)
				continue;
			put_on(parts, other, part);
			parts->queue.at[parts->queue.count++] = other;
		}
	}
}

static void
put_on_ground(struct parts *parts, uint32_t part)
{
	put_on(parts, part, part);
	parts->queue.at[parts->queue.count++] = part;
}

static int
by_area(const void *left, const void *right)
{
	const struct queue_entry *a = left, *b = right;

	if (a->cost < b->cost || b->cost < a->cost)
		return a->cost > b->cost ? -1 : 1;
	return (a->node > b->node) - (a->node < b->node);
}

/* What is linked to nothing on the ground: the largest is put there. */
static enum tcs_status
ground_rest(struct search *search)
{
	struct parts *parts = search->parts;
	size_t rest = 0;
	struct queue_entry *by_size = calloc(parts->count + 1, sizeof *by_size);

	if (!by_size)
		return fault_memory(search->fault);
	for (uint32_t i = 0; i < parts->count; i++)
		if (parts->at.at[i].parent == TCS_NONE)
			by_size[rest++] =
				(struct queue_entry){parts->at.at[i].area, i};
	if (rest > 0)
		qsort(by_size, rest, sizeof *by_size, by_area);
	for (size_t i = 0; i < rest; i++) {
		size_t next = parts->queue.count;

		if (parts->at.at[by_size[i].node].parent != TCS_NONE)
			continue;
		put_on_ground(parts, by_size[i].node);
		carry(parts, next);
	}
	free(by_size);
	return TCS_OK;
}

static enum tcs_status
find_standing(struct search *search, double reach)
{
	struct parts *parts = search->parts;
	double ground = search->set->bounds.low[2] + reach;

	array_clear(&parts->queue);
	array_clear(&parts->marks);
	if (array_grow(&parts->queue, parts->count) ||
		array_grow(&parts->marks, parts->count))
		return fault_memory(search->fault);
	parts->marks.count = parts->count;
	for (uint32_t i = 0; i < parts->count; i++) {
		parts->marks.at[i] = 0;
		if (parts->at.at[i].box.low[2] <= ground)
			put_on_ground(parts, i);
	}
	parts->mark = 0;
	carry(parts, 0);
	return ground_rest(search);
}

/* ---- from the object ----------------------------------------------------- */

static void
clear(struct parts *parts)
{
	parts->count = 0;
	array_clear(&parts->at);
	array_clear(&parts->faces);
	array_clear(&parts->numbers);
	array_clear(&parts->links);
	array_clear(&parts->left);
	array_clear(&parts->enclosed);
	array_clear(&parts->pairs);
}

enum tcs_status
parts_find(struct parts *parts, const struct component_set *set,
	const struct sheets *sheets, const struct seams *seams,
	const struct contact_list *contacts, double reach,
	struct tcs_fault *fault)
{
	struct search search = {parts, set, sheets, fault};
	enum tcs_status status;

	clear(parts);
	status = number_parts(&search);
	if (!status)
		status = sort_faces(&search);
	for (size_t i = 0; !status && i < parts->count; i++)
		measure_part(&search, &parts->at.at[i]);
	if (!status)
		status = count_components(&search, contacts);
	if (!status)
		status = link_twins(&search);
	if (!status)
		status = link_seams(&search, seams);
	if (!status)
		status = link_enclosed(&search, contacts);
	if (!status)
		status = sort_links(&search);
	if (!status)
		status = drop_repeated_links(&search);
	return status ? status : find_standing(&search, reach);
}

void
parts_release(struct parts *parts)
{
	array_release(&parts->at);
	array_release(&parts->faces);
	array_release(&parts->numbers);
	array_release(&parts->links);
	array_release(&parts->left);
	array_release(&parts->enclosed);
	array_release(&parts->pairs);
	array_release(&parts->queue);
	array_release(&parts->marks);
	array_release(&parts->hanging);
	array_release(&parts->carriers);
}
