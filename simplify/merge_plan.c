#include "merge_plan.h"

#include "face_directions.h"
#include "number_sort.h"

/* Faces, as they came, of all parts: more are not looked at. */
enum { MOST_FACES = 1 << 14 };

/* Axes that are tried. */
enum { MOST_AXES = 3 };

/* Points: among so many it is looked whether one is listed already. */
enum { LATELY = 16 };

/* Another axis has to save as much of the volume. */
#define BETTER_VOLUME 0.99

/* ---- the parts ----------------------------------------------------------- */

static void
sort_parts(struct merge_plan *plan)
{
	plan->parts.count = number_sort_once(plan->parts.at, plan->parts.count);
}

/* Those that the parts of the group are in by now; one that was drawn out is not
   where it was. */
static enum tcs_status
list_parts(struct merge_plan *plan, const struct parts *parts,
	const uint32_t *group, size_t count, bool *fine,
	struct tcs_fault *fault)
{
	*fine = true;
	plan->parts.count = 0;
	if (array_grow(&plan->parts, count))
		return fault_memory(fault);
	for (size_t i = 0; i < count; i++) {
		uint32_t part = parts_host(parts, group[i]);

		*fine = *fine && !parts->at.at[part].drawn_out;
		if (!parts->at.at[part].gone)
			plan->parts.at[plan->parts.count++] = part;
	}
	sort_parts(plan);
	return TCS_OK;
}

static bool
is_closed(const struct collapses *work, uint32_t face)
{
	uint32_t beyond[3];

	half_edges_across(work->mesh, face, beyond);
	return beyond[0] != HALF_EDGE_NONE && beyond[1] != HALF_EDGE_NONE &&
		beyond[2] != HALF_EDGE_NONE;
}

/* What is left of their faces, and all that they came with. */
static enum tcs_status
list_faces(struct merge_plan *plan, const struct collapses *work,
	const struct parts *parts, bool *fine, struct tcs_fault *fault)
{
	uint32_t corners[3];

	plan->faces.count = plan->slots.count = 0;
	for (size_t i = 0; i < plan->parts.count; i++) {
		const struct part *own = &parts->at.at[plan->parts.at[i]];

		if (array_grow(&plan->faces, own->count) ||
			array_grow(&plan->slots, own->count))
			return fault_memory(fault);
		for (uint32_t k = 0; k < own->count; k++) {
			uint32_t face = parts->faces.at[own->first + k];

			plan->slots.at[plan->slots.count++] = face;
			if (!half_edges_corners(work->mesh, face, corners))
				continue;
			plan->faces.at[plan->faces.count++] = face;
			*fine = *fine && is_closed(work, face);
		}
	}
	*fine = *fine && plan->slots.count <= MOST_FACES;
	number_sort(plan->faces.at, plan->faces.count);
	number_sort(plan->slots.at, plan->slots.count);
	return TCS_OK;
}

/* ---- whose faces it becomes ---------------------------------------------- */

static uint32_t
component_of(const struct collapses *work, uint32_t face)
{
	return work->set->numbers.at[work->sheets->face_triangles.at[face]];
}

/* Keep the slots of the component that has most of them: faces are numbered
   component by component. */
static void
choose_component(struct merge_plan *plan, const struct collapses *work)
{
	size_t best = 0, most = 0;

	for (size_t i = 0, end; i < plan->slots.count; i = end) {
		uint32_t component = component_of(work, plan->slots.at[i]);

		for (end = i; end < plan->slots.count &&
			component_of(work, plan->slots.at[end]) == component;)
			end++;
		if (end - i > most) {
			most = end - i;
			best = i;
		}
	}
	for (size_t i = 0; i < most; i++)
		plan->slots.at[i] = plan->slots.at[best + i];
	plan->slots.count = most;
}

/* Whether nothing but the parts has a face at a node. */
static enum tcs_status
is_free(const struct merge_plan *plan, struct collapses *work,
	const struct parts *parts, uint32_t node, bool *free,
	struct tcs_fault *fault)
{
	const struct sheet_node *fans = &work->sheets->nodes.at[node];
	enum tcs_status status = TCS_OK;
	size_t count;

	*free = true;
	for (uint32_t v = fans[0].first_vertex;
		!status && v < fans[1].first_vertex; v++) {
		status = spokes_of(work, v, &count, fault);
		for (size_t i = 0; !status && i < count; i++) {
			uint32_t face = work->spokes.at[i].face;

			if (face != HALF_EDGE_NONE &&
				!number_is_among(plan->parts.at,
					plan->parts.count,
					parts->numbers.at[face]))
				*free = false;
		}
	}
	return status;
}

/* A vertex of each node that the slots came with, as far as they are needed. */
static enum tcs_status
list_vertices(struct merge_plan *plan, struct collapses *work,
	const struct parts *parts, struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;
	size_t corners = 3 * plan->slots.count, kept = 0;
	uint32_t last = TCS_NONE;

	plan->vertices.count = 0;
	if (array_grow(&plan->vertices, corners))
		return fault_memory(fault);
	for (size_t i = 0; i < corners; i++)
		plan->vertices.at[i] =
			work->sheets->corners
				.at[3 * (size_t)plan->slots.at[i / 3] + i % 3];
	number_sort(plan->vertices.at, corners);
	/* Those of a node stand together. */
	for (size_t i = 0; !status && i < corners && kept < PRISM_CORNERS;
		i++) {
		uint32_t vertex = plan->vertices.at[i];
		uint32_t node = node_of(work, vertex);
		bool free = false;

		if (node != last)
			status = is_free(plan, work, parts, node, &free, fault);
		if (free)
			plan->vertices.at[kept++] = vertex;
		last = node;
	}
	plan->vertices.count = kept;
	return status;
}

/* ---- the prism ----------------------------------------------------------- */

/* Neighbouring faces share corners: what has just been listed need not be again. */
static void
list_point(struct merge_plan *plan, struct tcs_point point)
{
	size_t count = plan->points.count;
	size_t begin = count > LATELY ? count - LATELY : 0;

	for (size_t i = count; i-- > begin;) {
		struct tcs_point there = plan->points.at[i];

		if (!(there.x < point.x || there.x > point.x ||
			    there.y < point.y || there.y > point.y ||
			    there.z < point.z || there.z > point.z))
			return;
	}
	plan->points.at[plan->points.count++] = point;
}

/* Where everything was, and which way its faces looked. */
static enum tcs_status
list_points(struct merge_plan *plan, const struct collapses *work,
	const struct parts *parts, struct face_directions *directions,
	struct tcs_fault *fault)
{
	plan->points.count = 0;
	for (size_t i = 0; i < plan->parts.count; i++) {
		const struct part *own = &parts->at.at[plan->parts.at[i]];

		if (array_grow(&plan->points, 3 * (size_t)own->count))
			return fault_memory(fault);
		for (uint32_t k = 0; k < own->count; k++) {
			uint32_t face = parts->faces.at[own->first + k];
			uint32_t triangle =
				work->sheets->face_triangles.at[face];
			struct triangle_shape shape =
				component_set_shape(work->set, triangle);
			struct tcs_point normal = triangle_normal(&shape);
			double size = vector_length(normal);

			for (int c = 0; c < 3; c++)
				list_point(plan, shape.corner[c]);
			if (size > 0)
				face_directions_add(directions,
					vector_scaled(normal, 1 / size),
					size / 2);
		}
	}
	face_directions_sort(directions);
	return TCS_OK;
}

static enum tcs_status
find_prism(struct merge_plan *plan, const struct face_directions *directions,
	unsigned sides, struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;
	double least = INFINITY;

	plan->prism = (struct prism){.sides = 0};
	for (unsigned i = 0; !status && i < directions->count && i < MOST_AXES;
		i++) {
		struct prism prism;
		bool found;

		status = prism_around(&prism, &plan->outline, plan->points.at,
			plan->points.count, directions->at[i].way, sides,
			&found, fault);
		if (status || !found || prism.volume >= BETTER_VOLUME * least)
			continue;
		least = prism.volume;
		plan->prism = prism;
	}
	return status;
}

/* Of so many sides at most; from the parts as they are listed. */
static enum tcs_status
make_prism(struct merge_plan *plan, const struct collapses *work,
	const struct removals *removals, unsigned sides,
	struct tcs_fault *fault)
{
	struct face_directions directions = {0};
	enum tcs_status status =
		list_points(plan, work, &removals->parts, &directions, fault);

	return status ? status : find_prism(plan, &directions, sides, fault);
}

/* The prism of a group, known or not. */
static enum tcs_status
know_prism(struct merge_plan *plan, const struct collapses *work,
	const struct removals *removals, struct merge_known *known,
	struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	if (known->parts == plan->parts.count) {
		plan->prism = known->prism;
		return TCS_OK;
	}
	status = make_prism(plan, work, removals, PRISM_SIDES, fault);
	*known = (struct merge_known){
		(uint32_t)plan->parts.count, plan->prism, -1, 0};
	return status;
}

/* ---- putting it together ------------------------------------------------- */

/* The face that looks most as the triangle does: of those that do nearly, the
   largest. */
static uint32_t
find_model(const struct merge_plan *plan, const struct collapses *work,
	const struct parts *parts, struct tcs_point normal)
{
	uint32_t best = plan->faces.at[0];
	double most = -INFINITY;

	for (size_t i = 0; i < plan->parts.count; i++) {
		const struct part *own = &parts->at.at[plan->parts.at[i]];

		for (uint32_t k = 0; k < own->count; k++) {
			uint32_t face = parts->faces.at[own->first + k];
			struct triangle_shape shape =
				component_set_shape(work->set,
					work->sheets->face_triangles.at[face]);
			double along =
				vector_dot(normal, triangle_normal(&shape));

			if (along > most) {
				most = along;
				best = face;
			}
		}
	}
	return best;
}

static void
fill_in(struct merge_plan *plan)
{
	for (unsigned i = 0; i < PRISM_TRIANGLES_OF(plan->prism.sides); i++) {
		struct triangle_shape shape = prism_shape(&plan->prism, i);
		unsigned corners[3];

		prism_triangle(&plan->prism, i, corners);
		for (unsigned k = 0; k < 3; k++) {
			plan->corners[3 * i + k] =
				plan->vertices.at[corners[k]];
			plan->places[3 * i + k] = shape.corner[k];
		}
		plan->numbers[i] = plan->slots.at[i];
	}
}

/* Triangles in one plane with the one before look like it. */
void
merge_plan_choose_models(struct merge_plan *plan, const struct collapses *work,
	const struct parts *parts)
{
	struct tcs_point last = {0};

	for (unsigned i = 0; i < PRISM_TRIANGLES_OF(plan->prism.sides); i++) {
		struct triangle_shape shape = prism_shape(&plan->prism, i);
		struct tcs_point normal = triangle_normal(&shape);

		normal = vector_scaled(normal, 1 / vector_length(normal));
		plan->models[i] = i > 0 && vector_dot(normal, last) > 1 - 1e-9
			? plan->models[i - 1]
			: find_model(plan, work, parts, normal);
		last = normal;
	}
}

/* How many sides there are faces and vertices for; 0 if there are too few. */
static unsigned
most_sides(const struct merge_plan *plan)
{
	size_t sides = PRISM_SIDES;

	while (sides >= 4 &&
		(plan->vertices.count < PRISM_CORNERS_OF(sides) ||
			plan->slots.count < PRISM_TRIANGLES_OF(sides)))
		sides--;
	return sides >= 4 ? (unsigned)sides : 0;
}

/* ---- what lies in it anyway ---------------------------------------------- */

static bool
lies_within(const struct merge_plan *plan, const struct collapses *work,
	const struct removals *removals, const struct part *part)
{
	for (uint32_t i = 0; i < part->count; i++) {
		uint32_t face = removals->parts.faces.at[part->first + i];
		struct triangle_shape shape = component_set_shape(
			work->set, work->sheets->face_triangles.at[face]);

		for (int k = 0; k < 3; k++)
			if (prism_height(&plan->prism, shape.corner[k]) >
				removals->reach)
				return false;
	}
	return true;
}

/* Parts of the family that are linked to one of those listed. */
static enum tcs_status
add_swallowed(struct merge_plan *plan, const struct collapses *work,
	const struct removals *removals, const struct merge_groups *groups,
	struct tcs_fault *fault)
{
	const struct parts *parts = &removals->parts;
	size_t count = plan->parts.count;
	uint32_t family = groups->families.at[plan->parts.at[0]];

	for (size_t i = 0; i < count; i++) {
		const struct part *own = &parts->at.at[plan->parts.at[i]];

		for (uint32_t k = 0; k < own->link_count; k++) {
			uint32_t other = parts->links.at[own->first_link + k];
			const struct part *there = &parts->at.at[other];

			if (there->gone || there->drawn_out ||
				groups->families.at[other] != family ||
				number_is_among(plan->parts.at, count, other) ||
				!lies_within(plan, work, removals, there))
				continue;
			if (array_grow(&plan->parts, 1))
				return fault_memory(fault);
			plan->parts.at[plan->parts.count++] = other;
		}
	}
	sort_parts(plan);
	return TCS_OK;
}

/* ---- all of it ----------------------------------------------------------- */

static void
add_up(struct merge_plan *plan, const struct removals *removals)
{
	plan->area = 0;
	for (size_t i = 0; i < plan->parts.count; i++)
		plan->area += removals->parts.at.at[plan->parts.at[i]].area;
}

/* Whose faces it becomes, and with as many sides as there are faces for. */
static enum tcs_status
find_host(struct merge_plan *plan, struct collapses *work,
	const struct removals *removals, struct merge_known *known, bool *fine,
	struct tcs_fault *fault)
{
	const struct parts *parts = &removals->parts;
	enum tcs_status status = list_faces(plan, work, parts, fine, fault);
	unsigned sides;

	*fine = *fine &&
		plan->faces.count > PRISM_TRIANGLES_OF(plan->prism.sides);
	if (status || !*fine)
		return status;
	choose_component(plan, work);
	status = list_vertices(plan, work, parts, fault);
	sides = most_sides(plan);
	if (!status && sides > 0 && sides < plan->prism.sides) {
		status = make_prism(plan, work, removals, sides, fault);
		known->prism = plan->prism;
		known->off = -1;
	}
	*fine = sides > 0 && plan->prism.sides > 0;
	return status;
}

enum tcs_status
merge_plan_make(struct merge_plan *plan, struct collapses *work,
	const struct removals *removals, const struct merge_groups *groups,
	uint32_t number, struct merge_known *known, bool *fine,
	struct tcs_fault *fault)
{
	const struct merge_group *group = &groups->at.at[number];
	const struct parts *parts = &removals->parts;
	enum tcs_status status = list_parts(plan, parts,
		groups->parts.at + group->first, group->count, fine, fault);

	*fine = *fine && plan->parts.count > 1;
	if (!status && *fine)
		status = know_prism(plan, work, removals, known, fault);
	*fine = *fine && plan->prism.sides > 0;
	if (!status && *fine)
		status = add_swallowed(plan, work, removals, groups, fault);
	if (!status && *fine)
		status = find_host(plan, work, removals, known, fine, fault);
	if (status || !*fine)
		return status;
	add_up(plan, removals);
	plan->host = parts->numbers.at[plan->slots.at[0]];
	fill_in(plan);
	return TCS_OK;
}

/* ---- a panel ------------------------------------------------------------- */

/* Where one of the points is, and is not, along the axis. */
static enum tcs_status
reach_out(struct merge_plan *plan, struct tcs_point axis, double low,
	double high, struct tcs_fault *fault)
{
	struct tcs_point from = plan->points.at[0];
	double height = vector_dot(from, axis);

	if (array_grow(&plan->points, 2))
		return fault_memory(fault);
	plan->points.at[plan->points.count++] =
		vector_along(from, axis, low - height);
	plan->points.at[plan->points.count++] =
		vector_along(from, axis, high - height);
	return TCS_OK;
}

enum tcs_status
merge_plan_panel(struct merge_plan *plan, struct collapses *work,
	const struct removals *removals, const uint32_t *numbers, size_t count,
	struct tcs_point axis, double low, double high, bool *fine,
	struct tcs_fault *fault)
{
	const struct parts *parts = &removals->parts;
	struct face_directions directions = {0};
	enum tcs_status status =
		list_parts(plan, parts, numbers, count, fine, fault);
	bool found = false;
	unsigned sides;

	*fine = *fine && plan->parts.count > 0;
	if (!status && *fine)
		status = list_faces(plan, work, parts, fine, fault);
	*fine = *fine && plan->faces.count > 0;
	if (status || !*fine)
		return status;
	status = list_points(plan, work, parts, &directions, fault);
	if (!status)
		status = reach_out(plan, axis, low, high, fault);
	if (status)
		return status;
	choose_component(plan, work);
	status = list_vertices(plan, work, parts, fault);
	sides = most_sides(plan);
	if (!status && sides > 0)
		status = prism_around(&plan->prism, &plan->outline,
			plan->points.at, plan->points.count, axis, sides,
			&found, fault);
	*fine = found;
	if (status || !found)
		return status;
	add_up(plan, removals);
	plan->host = parts->numbers.at[plan->slots.at[0]];
	fill_in(plan);
	return TCS_OK;
}

struct refill
merge_plan_refill(const struct merge_plan *plan)
{
	return (struct refill){plan->faces.at, plan->faces.count, plan->numbers,
		plan->corners, plan->places, plan->models,
		PRISM_TRIANGLES_OF(plan->prism.sides), true};
}

void
merge_plan_release(struct merge_plan *plan)
{
	array_release(&plan->parts);
	array_release(&plan->faces);
	array_release(&plan->points);
	array_release(&plan->slots);
	array_release(&plan->vertices);
	prism_outline_release(&plan->outline);
}
