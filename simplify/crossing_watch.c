#include "crossing_watch.h"

#include "collapses.h"
#include "crossing.h"
#include "number_sort.h"

/* Metres: so near to its plane a face is in it; well below what counts as
   crossing, for it adds up over the corners. */
#define IN_PLANE 1e-5

/* Contacts that it is worth not to go through another component: next to
   nothing for a collapse, which pays for how far it moves the surface, or where
   bevels of a few millimetres may not go outlines do; much for what closes a
   hole, which runs through all that stands in it. */
#define COLLAPSE_CROSSES 0.00005
#define REFILL_CROSSES 0.5

/* Metres: what reaches no farther through a plane is on one side of it; far
   below what counts as crossing, and above what is lost to rounding. */
#define NOTHING 1e-12

/* Metres: faces that only touch a ring are not even listed. */
#define INSET (CROSSING_DEPTH / 10)

enum tcs_status
crossing_watch_begin(struct crossing_watch *watch, const struct collapses *work,
	struct tcs_fault *fault)
{
	const struct face_boxes *boxes = &work->seams->boxes;

	array_clear(&watch->places);
	if (array_grow(&watch->places, boxes->faces.count))
		return fault_memory(fault);
	watch->places.count = boxes->faces.count;
	for (size_t i = 0; i < boxes->runs.count; i++) {
		const struct face_run *run = &boxes->runs.at[i];

		for (uint32_t k = 0; k < run->face_count; k++)
			watch->places.at[boxes->faces.at[run->first_face + k]] =
				k;
	}
	return TCS_OK;
}

static uint32_t
component_of(const struct collapses *work, uint32_t face)
{
	return work->set->numbers.at[work->sheets->face_triangles.at[face]];
}

void
crossing_watch_follow(
	struct collapses *work, uint32_t face, struct tcs_point place)
{
	struct float_box box = float_box_at(place);

	crossing_watch_grow(work, component_of(work, face), face, &box);
}

void
crossing_watch_grow(struct collapses *work, uint32_t component, uint32_t face,
	const struct float_box *by)
{
	if (work->crossings.places.count > 0)
		face_boxes_grow(&work->seams->boxes, component,
			work->crossings.places.at[face], by);
}

void
crossing_watch_drop(struct collapses *work, uint32_t face)
{
	face_boxes_drop(&work->seams->boxes, component_of(work, face),
		work->crossings.places.at[face]);
}

/* ---- what needs no look -------------------------------------------------- */

/* Whether a face is, and stays, in the plane that it came with. */
static bool
keeps_its_plane(const struct collapses *work, const struct ring_face *face,
	struct tcs_point from)
{
	struct tcs_point normal = work->sheets->normals.at[face->face];

	for (int k = 0; k < 3; k++)
		if (fabs(vector_dot(normal,
			    vector_difference(face->shape.corner[k], from))) >
			IN_PLANE)
			return false;
	return true;
}

static bool
keeps_its_surface(const struct collapses *work, uint32_t node)
{
	if (work->ring_is_open)
		return false;
	for (size_t i = 0; i < work->ring.count; i++)
		if (!keeps_its_plane(
			    work, &work->ring.at[i], work->positions.at[node]))
			return false;
	return true;
}

/* ---- what crosses what --------------------------------------------------- */

/* Some faces, and the box around all of them; their normals are of length
   1. */
struct bundle {
	struct ring_face *faces;
	size_t count;
	struct box box;
};

static inline struct box
box_around(const struct triangle_shape *shape)
{
	const struct tcs_point *p = shape->corner;

	return (struct box){{least_of(p[0].x, p[1].x, p[2].x),
				    least_of(p[0].y, p[1].y, p[2].y),
				    least_of(p[0].z, p[1].z, p[2].z)},
		{-least_of(-p[0].x, -p[1].x, -p[2].x),
			-least_of(-p[0].y, -p[1].y, -p[2].y),
			-least_of(-p[0].z, -p[1].z, -p[2].z)}};
}

static struct bundle
bundle_of(struct ring_face *faces, size_t count)
{
	struct bundle bundle = {faces, count, BOX_EMPTY};

	for (size_t i = 0; i < count; i++) {
		struct tcs_point normal = triangle_normal(&faces[i].shape);
		double length = vector_length(normal);

		faces[i].normal =
			length > 0 ? vector_scaled(normal, 1 / length) : normal;
		faces[i].box = box_around(&faces[i].shape);
		box_add(&bundle.box, &faces[i].box);
	}
	return bundle;
}

/* Where the node is taken to be. */
struct stand {
	uint32_t node, target; /* equal: the node is where it is */
};

/* A face that is left, with the node moved; false for one that goes. */
static bool
face_with(const struct collapses *work, uint32_t face, struct stand stand,
	struct ring_face *out)
{
	bool has_node = false, has_target = false;

	if (!collapses_face(work, face, out->nodes))
		return false;
	for (int k = 0; k < 3; k++) {
		has_node |= out->nodes[k] == stand.node;
		has_target |= out->nodes[k] == stand.target;
		if (out->nodes[k] == stand.node)
			out->nodes[k] = stand.target;
		out->shape.corner[k] = work->positions.at[out->nodes[k]];
	}
	out->face = face;
	return !has_node || !has_target || stand.node == stand.target;
}

static bool
have_an_edge(const struct ring_face *a, const struct ring_face *b)
{
	int common = 0;

	for (int i = 0; i < 3; i++)
		for (int k = 0; k < 3; k++)
			common += a->nodes[i] == b->nodes[k];
	return common > 1;
}

static bool
boxes_meet(const struct box *a, const struct box *b)
{
	for (int i = 0; i < 3; i++)
		if (a->low[i] > b->high[i] || a->high[i] < b->low[i])
			return false;
	return true;
}

/* Whether no corner is on the one side of the other face's plane, or none on the
   other. */
static inline bool
is_on_one_side(const struct ring_face *face, const struct ring_face *other)
{
	struct tcs_point normal = other->normal;
	double most =
		NOTHING * (fabs(normal.x) + fabs(normal.y) + fabs(normal.z));
	const struct tcs_point *p = face->shape.corner;
	struct tcs_point from = other->shape.corner[0];
	double a = vector_dot(normal, vector_difference(p[0], from));
	double b = vector_dot(normal, vector_difference(p[1], from));
	double c = vector_dot(normal, vector_difference(p[2], from));

	return (a >= -most && b >= -most && c >= -most) ||
		(a <= most && b <= most && c <= most);
}

/* Faces that have nothing to do with each other have no edge in common. */
static bool
crosses_any(const struct bundle *bundle, struct ring_face *other, bool kin)
{
	other->box = box_around(&other->shape);
	if (!boxes_meet(&bundle->box, &other->box))
		return false;
	other->normal = triangle_normal(&other->shape);
	for (size_t i = 0; i < bundle->count; i++) {
		const struct ring_face *face = &bundle->faces[i];

		if (boxes_meet(&face->box, &other->box) &&
			!is_on_one_side(face, other) &&
			(!kin ||
				(face->face != other->face &&
					!have_an_edge(face, other))) &&
			triangles_cross_along(
				&face->shape, face->normal, &other->shape))
			return true;
	}
	return false;
}

/* A little less than it, on all sides; a flat one turns inside out, and is met
   by what passes through it. */
static struct float_box
inner_box(const struct bundle *bundle)
{
	const double *low = bundle->box.low, *high = bundle->box.high;

	return float_box_around((struct tcs_point){low[0], low[1], low[2]},
		(struct tcs_point){high[0], high[1], high[2]}, -INSET);
}

/* Whether the bundle crosses a component. */
static enum tcs_status
crosses_component(struct collapses *work, const struct bundle *bundle,
	uint32_t component, struct stand stand, bool *crosses,
	struct tcs_fault *fault)
{
	struct crossing_watch *watch = &work->crossings;
	bool kin = component == component_of(work, bundle->faces[0].face);
	struct float_box box = inner_box(bundle);
	enum tcs_status status = face_boxes_near(
		&work->seams->boxes, component, &box, &watch->near, fault);

	*crosses = false;
	for (size_t i = 0; !status && !*crosses && i < watch->near.count; i++) {
		struct ring_face other;

		*crosses = face_with(work, watch->near.at[i], stand, &other) &&
			crosses_any(bundle, &other, kin);
	}
	return status;
}

/* ---- before and after ---------------------------------------------------- */

/* Put the faces around a node, as they are, behind the ring. */
static enum tcs_status
list_around(struct collapses *work, uint32_t node, struct tcs_fault *fault)
{
	const struct sheet_node *fans = &work->sheets->nodes.at[node];
	size_t count;

	for (uint32_t v = fans[0].first_vertex; v < fans[1].first_vertex; v++) {
		enum tcs_status status = spokes_of(work, v, &count, fault);

		if (status)
			return status;
		if (array_grow(&work->ring, count))
			return fault_memory(fault);
		for (size_t i = 0; i < count; i++)
			if (work->spokes.at[i].face != HALF_EDGE_NONE &&
				face_with(work, work->spokes.at[i].face,
					(struct stand){node, node},
					&work->ring.at[work->ring.count]))
				work->ring.count++;
	}
	return TCS_OK;
}

static enum tcs_status
crossed_before(struct collapses *work, uint32_t node, uint32_t component,
	bool *crossed, struct tcs_fault *fault)
{
	size_t ring = work->ring.count;
	enum tcs_status status = list_around(work, node, fault);
	struct bundle bundle =
		bundle_of(work->ring.at + ring, work->ring.count - ring);

	if (!status)
		status = crosses_component(work, &bundle, component,
			(struct stand){node, node}, crossed, fault);
	work->ring.count = ring;
	return status;
}

struct neighbours {
	struct collapses *work;
	const struct box *box;
	enum tcs_status status;
	struct tcs_fault *fault;
};

static bool
take_component(void *context, uint32_t position)
{
	struct neighbours *search = context;
	struct crossing_watch *watch = &search->work->crossings;
	const struct component_set *set = search->work->set;
	uint32_t component = set->boxes.items.at[position];

	if (box_gap_squared(&set->components.at[component].box, search->box) >
		0)
		return true;
	if (array_grow(&watch->components, 1)) {
		search->status = fault_memory(search->fault);
		return false;
	}
	watch->components.at[watch->components.count++] = component;
	return true;
}

static enum tcs_status
find_components(
	struct collapses *work, const struct box *box, struct tcs_fault *fault)
{
	struct neighbours search = {work, box, TCS_OK, fault};

	work->crossings.components.count = 0;
	box_tree_near(&work->set->boxes, work->set->box_root, box, 0,
		take_component, &search);
	return search.status;
}

enum tcs_status
crossing_watch_allows(struct collapses *work, uint32_t node, uint32_t target,
	bool *fine, struct tcs_fault *fault)
{
	const struct crossing_watch *watch = &work->crossings;
	struct bundle ring;
	enum tcs_status status;
	uint32_t own;

	*fine = true;
	if (!work->ring.count || keeps_its_surface(work, node))
		return TCS_OK;
	own = component_of(work, work->ring.at[0].face);
	ring = bundle_of(work->ring.at, work->ring.count);
	status = find_components(work, &ring.box, fault);
	for (size_t i = 0; !status && *fine && i < watch->components.count;
		i++) {
		uint32_t component = watch->components.at[i];
		bool after, before = false;

		status = crosses_component(work, &ring, component,
			(struct stand){node, target}, &after, fault);
		if (status || !after)
			continue;
		status = crossed_before(work, node, component, &before, fault);
		/* The ring may have moved in memory. */
		ring.faces = work->ring.at;
		if (before)
			continue;
		*fine = component != own &&
			work->settings.contact_cost < INFINITY;
		work->broken += COLLAPSE_CROSSES;
	}
	return status;
}

/* ---- triangles instead of faces ------------------------------------------ */

/* Put the triangles, and then the faces that go, into work->ring. */
static enum tcs_status
list_refill(struct collapses *work, const struct refill *refill,
	struct tcs_fault *fault)
{
	const struct stand nowhere = {TCS_NONE, TCS_NONE};

	work->ring.count = 0;
	if (array_grow(&work->ring, refill->count + refill->face_count))
		return fault_memory(fault);
	for (size_t i = 0; i < refill->count; i++) {
		struct ring_face *face = &work->ring.at[work->ring.count++];

		face->face = TCS_NONE;
		for (int k = 0; k < 3; k++) {
			face->nodes[k] = node_of(
				work, refill->corners[3 * i + (size_t)k]);
			face->shape.corner[k] =
				refill_place(work, refill, i, k);
		}
	}
	for (size_t i = 0; i < refill->face_count; i++)
		if (face_with(work, refill->faces[i], nowhere,
			    &work->ring.at[work->ring.count]))
			work->ring.count++;
	return TCS_OK;
}

/* Whether a bundle crosses a component, beside the faces that go. */
static enum tcs_status
refill_crosses(struct collapses *work, const struct refill *refill,
	const struct bundle *bundle, uint32_t component, bool *crosses,
	struct tcs_fault *fault)
{
	const struct stand nowhere = {TCS_NONE, TCS_NONE};
	struct crossing_watch *watch = &work->crossings;
	struct float_box box = inner_box(bundle);
	enum tcs_status status = face_boxes_near(
		&work->seams->boxes, component, &box, &watch->near, fault);

	*crosses = false;
	for (size_t i = 0; !status && !*crosses && i < watch->near.count; i++) {
		uint32_t face = watch->near.at[i];
		struct ring_face other;

		if (!number_is_among(refill->faces, refill->face_count, face))
			*crosses = face_with(work, face, nowhere, &other) &&
				crosses_any(bundle, &other, true);
	}
	return status;
}

enum tcs_status
crossing_watch_admits(struct collapses *work, const struct refill *refill,
	bool *fine, struct tcs_fault *fault)
{
	uint32_t own = component_of(work, refill->faces[0]);
	const struct crossing_watch *watch = &work->crossings;
	struct bundle after, before;
	enum tcs_status status = list_refill(work, refill, fault);

	*fine = true;
	work->broken = 0;
	if (status)
		return status;
	after = bundle_of(work->ring.at, refill->count);
	before = bundle_of(work->ring.at + refill->count,
		work->ring.count - refill->count);
	status = find_components(work, &after.box, fault);
	for (size_t i = 0; !status && *fine && i < watch->components.count;
		i++) {
		uint32_t component = watch->components.at[i];
		bool crosses, crossed = false;

		status = refill_crosses(
			work, refill, &after, component, &crosses, fault);
		if (!status && crosses)
			status = refill_crosses(work, refill, &before,
				component, &crossed, fault);
		if (!crosses || crossed)
			continue;
		*fine = component != own;
		work->broken += REFILL_CROSSES;
	}
	return status;
}

void
crossing_watch_release(struct crossing_watch *watch)
{
	array_release(&watch->places);
	array_release(&watch->components);
	array_release(&watch->near);
}
