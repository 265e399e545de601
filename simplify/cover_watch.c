#include "cover_watch.h"

#include <math.h>

#include "collapses.h"
#include "number_sort.h"

/* So much farther away, squared, is farther however it is rounded. */
#define SAFE (1 + 1e-6)

/* Of a triangle's height: a line that is so near to an edge may meet either. */
#define LEAST_MARGIN 1e-9

/* ---- who has which contacts ---------------------------------------------- */

/* Count, then place. */
static enum tcs_status
sort_contacts(struct cover_watch *watch, const struct component_set *set,
	const struct contact_list *list, struct tcs_fault *fault)
{
	size_t components = set->components.count;

	if (array_grow(&watch->first, components + 1) ||
		array_grow(&watch->contacts, 2 * list->count) ||
		array_grow(&watch->lost, list->count))
		return fault_memory(fault);
	watch->list = list;
	watch->reach = fmin(contact_reach(set), STANDS_OUT);
	watch->first.count = components + 1;
	watch->contacts.count = 2 * list->count;
	watch->lost.count = list->count;
	for (size_t i = 0; i <= components; i++)
		watch->first.at[i] = 0;
	for (size_t i = 0; i < list->count; i++) {
		watch->lost.at[i] = false;
		watch->first.at[list->at[i].a]++;
		watch->first.at[list->at[i].b]++;
	}
	for (size_t i = 1; i <= components; i++)
		watch->first.at[i] += watch->first.at[i - 1];
	/* From each one's end, which moves to where it begins. */
	for (uint32_t i = (uint32_t)list->count; i-- > 0;) {
		const uint32_t sides[2] = {list->at[i].a, list->at[i].b};

		for (int k = 0; k < 2; k++)
			watch->contacts.at[--watch->first.at[sides[k]]] = i;
	}
	return TCS_OK;
}

static enum tcs_status
begin(struct collapses *work, const struct contact_list *list,
	struct tcs_fault *fault)
{
	struct cover_watch *watch = &work->covers;
	size_t faces = work->features.count;

	if (watch->list)
		return TCS_OK;
	if (array_grow(&watch->numbers, faces))
		return fault_memory(fault);
	watch->numbers.count = faces;
	for (size_t i = 0; i < faces; i++)
		watch->numbers.at[i] = TCS_NONE;
	return sort_contacts(watch, work->set, list, fault);
}

/* ---- covering ------------------------------------------------------------ */

static enum tcs_status
list_number(struct cover_watch *watch, uint32_t number, struct tcs_fault *fault)
{
	if (array_grow(&watch->losing, 1))
		return fault_memory(fault);
	watch->losing.at[watch->losing.count++] = number;
	return TCS_OK;
}

static void
keep_each_once(struct cover_watch *watch)
{
	watch->losing.count =
		number_sort_once(watch->losing.at, watch->losing.count);
}

/* Whether the cover that was begun has it. */
static bool
has_component(const struct cover_watch *watch, uint32_t component)
{
	const struct cover *cover = &watch->at.at[watch->at.count - 1];

	for (uint32_t i = 0; i < cover->count; i++)
		if (watch->covered.at[cover->first + i].component == component)
			return true;
	return false;
}

static enum tcs_status
put_covered(struct cover_watch *watch, const struct covered *own,
	struct tcs_fault *fault)
{
	if (array_grow(&watch->covered, 1))
		return fault_memory(fault);
	watch->covered.at[watch->covered.count++] = *own;
	watch->at.at[watch->at.count - 1].count++;
	return TCS_OK;
}

enum tcs_status
cover_watch_put(
	struct collapses *work, uint32_t component, struct tcs_fault *fault)
{
	struct cover_watch *watch = &work->covers;
	const struct component_set *set = work->set;
	const struct component *own = &set->components.at[component];
	size_t first = watch->points.count, count = 3 * (size_t)own->count;

	if (has_component(watch, component))
		return TCS_OK;
	if (array_grow(&watch->points, count))
		return fault_memory(fault);
	for (size_t i = 0; i < count; i++) {
		uint32_t triangle = set->order.at[own->first + i / 3];

		watch->points.at[first + i] =
			set->triangles.at[triangle].corner[i % 3];
	}
	count = number_sort_once(watch->points.at + first, count);
	watch->points.count += count;
	return put_covered(watch,
		&(struct covered){
			component, (uint32_t)first, (uint32_t)count, false},
		fault);
}

/* What was in the covers that are listed. */
static enum tcs_status
take_over(struct cover_watch *watch, struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	for (size_t i = 0; i < watch->losing.count; i++) {
		struct cover from = watch->at.at[watch->losing.at[i]];

		for (uint32_t k = 0; !status && k < from.count; k++) {
			struct covered own = watch->covered.at[from.first + k];

			if (!own.bare && !has_component(watch, own.component))
				status = put_covered(watch, &own, fault);
		}
	}
	return status;
}

/* Those of the faces that are left. */
static enum tcs_status
list_covers(struct collapses *work, const uint32_t *faces, size_t count,
	struct tcs_fault *fault)
{
	struct cover_watch *watch = &work->covers;
	enum tcs_status status = TCS_OK;
	uint32_t corners[3];

	watch->losing.count = 0;
	for (size_t i = 0; !status && i < count; i++)
		if (watch->numbers.at[faces[i]] != TCS_NONE &&
			half_edges_corners(work->mesh, faces[i], corners))
			status = list_number(
				watch, watch->numbers.at[faces[i]], fault);
	keep_each_once(watch);
	return status;
}

enum tcs_status
cover_watch_open(struct collapses *work, const struct contact_list *contacts,
	const uint32_t *faces, size_t count, struct tcs_fault *fault)
{
	struct cover_watch *watch = &work->covers;
	enum tcs_status status = begin(work, contacts, fault);

	if (!status)
		status = list_covers(work, faces, count, fault);
	if (!status && array_grow(&watch->at, 1))
		status = fault_memory(fault);
	if (status)
		return status;
	watch->at.at[watch->at.count++] =
		(struct cover){.first = (uint32_t)watch->covered.count};
	return take_over(watch, fault);
}

static bool
is_open(const struct collapses *work, uint32_t face)
{
	uint32_t beyond[3];

	half_edges_across(work->mesh, face, beyond);
	return beyond[0] == HALF_EDGE_NONE || beyond[1] == HALF_EDGE_NONE ||
		beyond[2] == HALF_EDGE_NONE;
}

enum tcs_status
cover_watch_close(struct collapses *work, const uint32_t *faces, size_t count,
	struct tcs_fault *fault)
{
	struct cover_watch *watch = &work->covers;
	uint32_t number = (uint32_t)watch->at.count - 1, corners[3];
	struct cover *cover = &watch->at.at[number];

	if (array_grow(&watch->faces, count))
		return fault_memory(fault);
	cover->first_face = (uint32_t)watch->faces.count;
	for (size_t i = 0; i < count; i++) {
		if (!half_edges_corners(work->mesh, faces[i], corners))
			continue;
		if (is_open(work, faces[i]))
			cover->count = 0;
		watch->faces.at[watch->faces.count++] = faces[i];
		watch->numbers.at[faces[i]] = number;
	}
	cover->face_count = (uint32_t)watch->faces.count - cover->first_face;
	return TCS_OK;
}

/* ---- coming out ---------------------------------------------------------- */

/* A face of the ring as it will be; NULL if it is not in it. */
static const struct ring_face *
in_ring(const struct collapses *work, uint32_t face)
{
	for (size_t i = 0; i < work->ring.count; i++)
		if (work->ring.at[i].face == face)
			return &work->ring.at[i];
	return NULL;
}

/* Where anything of a cover changes: the ring as it is and as it will be. */
static struct box
changed_of(const struct collapses *work, uint32_t number, uint32_t node)
{
	struct box changed = BOX_EMPTY;

	box_add_point(&changed, work->positions.at[node]);
	for (size_t i = 0; i < work->ring.count; i++) {
		const struct ring_face *next = &work->ring.at[i];

		for (int k = 0;
			k < 3 && work->covers.numbers.at[next->face] == number;
			k++)
			box_add_point(&changed, next->shape.corner[k]);
	}
	return changed;
}

/* The faces of a cover as they will be. */
static enum tcs_status
list_shapes(struct collapses *work, const struct cover *cover, uint32_t node,
	struct tcs_fault *fault)
{
	struct cover_watch *watch = &work->covers;

	watch->shapes.count = 0;
	if (array_grow(&watch->shapes, cover->face_count))
		return fault_memory(fault);
	for (uint32_t i = 0; i < cover->face_count; i++) {
		uint32_t face = watch->faces.at[cover->first_face + i];
		const struct ring_face *next = in_ring(work, face);
		struct triangle_shape shape;
		uint32_t nodes[3];

		if (!collapses_face(work, face, nodes) ||
			(!next &&
				(nodes[0] == node || nodes[1] == node ||
					nodes[2] == node)))
			continue;
		for (int k = 0; k < 3; k++)
			shape.corner[k] = next ? next->shape.corner[k]
					       : work->positions.at[nodes[k]];
		watch->shapes.at[watch->shapes.count++] =
			(struct cover_face){shape, triangle_normal(&shape)};
	}
	return TCS_OK;
}

/*
 * The solid angle of a triangle.
 *
 * source: A. van Oosterom, J. Strackee, The solid angle of a plane triangle,
 * 1983.
 */
static double
angle_of(const struct triangle_shape *shape, struct tcs_point from)
{
	struct tcs_point a = vector_difference(shape->corner[0], from);
	struct tcs_point b = vector_difference(shape->corner[1], from);
	struct tcs_point c = vector_difference(shape->corner[2], from);
	double la = vector_length(a), lb = vector_length(b),
	       lc = vector_length(c);

	return 2 *
		atan2(vector_dot(a, vector_cross(b, c)),
			la * lb * lc + vector_dot(a, b) * lc +
				vector_dot(a, c) * lb + vector_dot(b, c) * la);
}

/* Whether a point is hardly off a face; its plane may be farther already. */
static bool
is_near(const struct cover_face *face, struct tcs_point point, double reach)
{
	double height = vector_dot(
		face->normal, vector_difference(point, face->shape.corner[0]));
	struct tcs_point there;

	if (height * height >
		SAFE * reach * reach * vector_dot(face->normal, face->normal))
		return false;
	there = triangle_nearest_along(&face->shape, face->normal, point);
	return vector_length(vector_difference(there, point)) <= reach;
}

/* How often the shapes go round a point, by what a line from it passes through;
   false where that comes too near to an edge to tell. */
static bool
count_turns(const struct cover_watch *watch, struct tcs_point point, int *turns)
{
	static const struct tcs_point way = {0.267, 0.153, 0.951};

	*turns = 0;
	for (size_t i = 0; i < watch->shapes.count; i++) {
		const struct cover_face *face = &watch->shapes.at[i];
		double along = vector_dot(face->normal, way);
		double ahead = vector_dot(face->normal,
			vector_difference(face->shape.corner[0], point));
		double t, margin = 0;

		if (!(along * ahead > 0))
			continue;
		if (triangle_hit(&face->shape, point, way, &t, &margin))
			*turns += along > 0 ? 1 : -1;
		if (fabs(margin) < LEAST_MARGIN)
			return false;
	}
	return true;
}

/* Whether a point is in the shapes, or hardly out of them. */
static bool
is_in(const struct cover_watch *watch, struct tcs_point point)
{
	double angle = 0;
	int turns;

	for (size_t i = 0; i < watch->shapes.count; i++)
		if (is_near(&watch->shapes.at[i], point, watch->reach))
			return true;
	if (count_turns(watch, point, &turns))
		return turns != 0;
	for (size_t i = 0; i < watch->shapes.count; i++)
		angle += angle_of(&watch->shapes.at[i].shape, point);
	return fabs(angle) > 2 * acos(-1);
}

static bool
comes_out(const struct collapses *work, const struct covered *own,
	const struct box *changed)
{
	const struct cover_watch *watch = &work->covers;

	for (uint32_t i = 0; i < own->point_count; i++) {
		struct tcs_point point =
			work->set->points
				.at[watch->points.at[own->first_point + i]];

		if (box_distance_squared(changed, point) <=
				watch->reach * watch->reach &&
			!is_in(watch, point))
			return true;
	}
	return false;
}

/* Of the contacts listed; what is broken already is worth no more. */
static double
worth_of_losing(const struct collapses *work)
{
	const struct cover_watch *watch = &work->covers;
	double worth = 0;

	for (size_t i = 0; i < watch->losing.count; i++) {
		uint32_t contact = watch->losing.at[i];
		const struct seam_count *count =
			&work->seams->counts.at[contact];
		double broken =
			count->points > 0 ? seam_broken(count, count->open) : 0;

		if (!watch->lost.at[contact])
			worth += (1 - broken) *
				(work->worths.count > 0 ? (double)work->worths
								  .at[contact]
							: 1);
	}
	return worth;
}

/* The contacts of what comes out. */
static enum tcs_status
list_losing(struct cover_watch *watch, struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	watch->losing.count = 0;
	for (size_t i = 0; i < watch->coming.count; i++) {
		uint32_t component =
			watch->covered.at[watch->coming.at[i]].component;
		uint32_t end = watch->first.at[component + 1];

		for (uint32_t k = watch->first.at[component];
			!status && k < end; k++)
			status = list_number(
				watch, watch->contacts.at[k], fault);
	}
	keep_each_once(watch);
	return status;
}

/* Whether what changes is where a component was. */
static bool
is_beside(const struct collapses *work, const struct covered *own,
	const struct box *changed)
{
	const struct cover_watch *watch = &work->covers;

	return box_gap_squared(changed,
		       &work->set->components.at[own->component].box) <=
		SAFE * watch->reach * watch->reach;
}

/* List what comes out of one cover. */
static enum tcs_status
look_at(struct collapses *work, uint32_t number, uint32_t node,
	struct tcs_fault *fault)
{
	struct cover_watch *watch = &work->covers;
	const struct cover *cover = &watch->at.at[number];
	struct box changed = changed_of(work, number, node);
	enum tcs_status status = TCS_OK;
	bool listed = false;

	for (uint32_t i = cover->first;
		!status && i < cover->first + cover->count; i++) {
		const struct covered *own = &watch->covered.at[i];

		if (own->bare || !is_beside(work, own, &changed))
			continue;
		if (!listed)
			status = list_shapes(work, cover, node, fault);
		listed = true;
		if (status || !comes_out(work, own, &changed))
			continue;
		if (array_grow(&watch->coming, 1))
			return fault_memory(fault);
		watch->coming.at[watch->coming.count++] = i;
	}
	return status;
}

/* A node has faces of one cover, or of few. */
static bool
is_first(const struct collapses *work, size_t place)
{
	const uint32_t *numbers = work->covers.numbers.at;

	for (size_t i = 0; i < place; i++)
		if (numbers[work->ring.at[i].face] ==
			numbers[work->ring.at[place].face])
			return false;
	return numbers[work->ring.at[place].face] != TCS_NONE;
}

enum tcs_status
cover_watch_look(struct collapses *work, uint32_t node, double *worth,
	struct tcs_fault *fault)
{
	struct cover_watch *watch = &work->covers;
	enum tcs_status status = TCS_OK;

	*worth = 0;
	watch->coming.count = 0;
	for (size_t i = 0; !status && watch->list && i < work->ring.count; i++)
		if (is_first(work, i))
			status = look_at(work,
				watch->numbers.at[work->ring.at[i].face], node,
				fault);
	if (status || watch->coming.count == 0)
		return status;
	status = list_losing(watch, fault);
	if (!status)
		*worth = worth_of_losing(work);
	return status;
}

/* All that is in the covers that are listed. */
static enum tcs_status
list_all(struct cover_watch *watch, struct tcs_fault *fault)
{
	watch->coming.count = 0;
	for (size_t i = 0; i < watch->losing.count; i++) {
		const struct cover *cover = &watch->at.at[watch->losing.at[i]];

		if (array_grow(&watch->coming, cover->count))
			return fault_memory(fault);
		for (uint32_t k = 0; k < cover->count; k++)
			if (!watch->covered.at[cover->first + k].bare)
				watch->coming.at[watch->coming.count++] =
					cover->first + k;
	}
	return list_losing(watch, fault);
}

/* A point that is left is held by what covers it, and watched there. */
static void
drop_held(struct cover_watch *watch, const struct seams *seams)
{
	size_t kept = 0;

	for (size_t i = 0; i < watch->losing.count; i++)
		if (seams->counts.at[watch->losing.at[i]].points == 0)
			watch->losing.at[kept++] = watch->losing.at[i];
	watch->losing.count = kept;
}

enum tcs_status
cover_watch_worth(struct collapses *work, const uint32_t *faces, size_t count,
	double *worth, struct tcs_fault *fault)
{
	struct cover_watch *watch = &work->covers;
	enum tcs_status status;

	*worth = 0;
	if (!watch->list)
		return TCS_OK;
	status = list_covers(work, faces, count, fault);
	if (status || watch->losing.count == 0)
		return status;
	status = list_all(watch, fault);
	if (status)
		return status;
	drop_held(watch, work->seams);
	*worth = worth_of_losing(work);
	watch->coming.count = 0;
	return TCS_OK;
}

bool
cover_watch_loses(const struct cover_watch *watch, uint32_t contact)
{
	return watch->list &&
		(watch->lost.at[contact] ||
			(watch->coming.count > 0 &&
				number_is_among(watch->losing.at,
					watch->losing.count, contact)));
}

void
cover_watch_follow(struct collapses *work)
{
	struct cover_watch *watch = &work->covers;

	if (watch->coming.count == 0)
		return;
	for (size_t i = 0; i < watch->losing.count; i++)
		watch->lost.at[watch->losing.at[i]] = true;
	for (size_t i = 0; i < watch->coming.count; i++)
		watch->covered.at[watch->coming.at[i]].bare = true;
	watch->coming.count = 0;
}

/* ---- all of it ----------------------------------------------------------- */

void
cover_watch_clear(struct cover_watch *watch)
{
	watch->list = NULL;
	array_clear(&watch->at);
	array_clear(&watch->faces);
	array_clear(&watch->covered);
	array_clear(&watch->points);
	array_clear(&watch->numbers);
	array_clear(&watch->first);
	array_clear(&watch->contacts);
	array_clear(&watch->lost);
	watch->coming.count = 0;
}

void
cover_watch_release(struct cover_watch *watch)
{
	watch->list = NULL;
	array_release(&watch->at);
	array_release(&watch->faces);
	array_release(&watch->covered);
	array_release(&watch->points);
	array_release(&watch->numbers);
	array_release(&watch->first);
	array_release(&watch->contacts);
	array_release(&watch->lost);
	array_release(&watch->shapes);
	array_release(&watch->coming);
	array_release(&watch->losing);
}
