#include "compare_views.h"

#include <math.h>
#include <stdlib.h>

#include "split_work.h"
#include "vector.h"

#define EYE_HEIGHT 1.7 /* metres */

struct view
compare_view(const struct component_set *before, int number)
{
	const struct box *box = &before->bounds;
	double diagonal = fmax(box_diagonal(box), 0.001);
	bool street = number < STREET_VIEWS;
	double turn = acos(-1) *
		(street ? number / 4.0 : (number - STREET_VIEWS) / 2.0 + 0.125);
	double distance = 1.5 * diagonal * (street ? 1 : sqrt(0.5));
	struct tcs_point middle = {(box->low[0] + box->high[0]) / 2,
		(box->low[1] + box->high[1]) / 2,
		(box->low[2] + box->high[2]) / 2};
	struct tcs_point eye = {middle.x + distance * cos(turn),
		middle.y + distance * sin(turn),
		street ? box->low[2] + EYE_HEIGHT : middle.z + distance};

	return view_of(eye, middle, diagonal / 2);
}

double
view_grey(const struct component_set *set, uint32_t triangle,
	const struct view *view)
{
	struct triangle_shape shape = component_set_shape(set, triangle);
	struct tcs_point normal = triangle_normal(&shape);
	double length = vector_length(normal);

	if (!(length > 0))
		return 0.3;
	return 0.3 + 0.7 * fabs(vector_dot(normal, view->forward)) / length;
}

/* ---- drawing ------------------------------------------------------------- */

struct drawing {
	const struct component_set *sets[2];
	struct compare_pictures *pictures;
	unsigned size;
	bool failed[2 * ALL_VIEWS]; /* for want of memory */
};

static void
draw_one(void *context, size_t piece, size_t first, size_t end)
{
	struct drawing *drawing = context;
	size_t side = piece / ALL_VIEWS, number = piece % ALL_VIEWS;
	const struct component_set *set = drawing->sets[side];
	struct view view = compare_view(drawing->sets[0], (int)number);
	struct tcs_fault fault;

	(void)first;
	(void)end;
	drawing->failed[piece] =
		raster_draw(&drawing->pictures->rasters[side][number],
			drawing->size, &view, set->points.at, set->points.count,
			set->triangles.at, set->triangles.count, NULL, &fault);
}

static enum tcs_status
draw_all(const struct compare_side *before, const struct compare_side *after,
	unsigned size, struct compare_pictures *pictures,
	struct tcs_fault *fault)
{
	struct drawing drawing = {.sets = {&before->set, &after->set},
		.pictures = pictures,
		.size = size};
	enum tcs_status status = split_work(
		2 * ALL_VIEWS, 1, before->set.jobs, draw_one, &drawing, fault);

	for (int i = 0; i < 2 * ALL_VIEWS; i++)
		if (!status && drawing.failed[i])
			status = fault_memory(fault);
	return status;
}

/* ---- looking ------------------------------------------------------------- */

/* What one side shows: per part, a component before and a piece after, and per
   feature. */
struct seen {
	const uint32_t *numbers; /* the part of each triangle */
	bool *parts, *features;
};

struct look {
	const struct compare_side *before, *after;
	struct seen seen[2];
	double either, both, same, alike; /* pixels */
	double boxes[2], opened;
	uint32_t last[2]; /* the triangles of the pixel before, */
	double last_alike; /* and how alike they are */
};

static void
note_seen(struct seen *seen, const struct component_set *set, uint32_t triangle)
{
	if (triangle == RASTER_NOTHING)
		return;
	seen->parts[seen->numbers[triangle]] = true;
	seen->features[set->features.at[triangle]] = true;
}

static void
look_at_pixel(
	struct look *look, const struct view *view, uint32_t a, uint32_t b)
{
	const struct component_set *before = &look->before->set;
	const struct component_set *after = &look->after->set;

	note_seen(&look->seen[0], before, a);
	note_seen(&look->seen[1], after, b);
	look->either += a != RASTER_NOTHING || b != RASTER_NOTHING;
	if (a == RASTER_NOTHING || b == RASTER_NOTHING)
		return;
	look->both++;
	look->same += look->before->twins.at[before->features.at[a]] ==
		after->features.at[b];
	if (a != look->last[0] || b != look->last[1]) {
		look->last[0] = a;
		look->last[1] = b;
		look->last_alike = 1 -
			fabs(view_grey(before, a, view) -
				view_grey(after, b, view));
	}
	look->alike += look->last_alike;
}

/* Whether each box behind is seen in a picture of size² pixels. */
static void
find_boxes(const struct raster *raster, bool boxes[VIEW_BOXES * VIEW_BOXES])
{
	for (unsigned i = 0; i < VIEW_BOXES * VIEW_BOXES; i++)
		boxes[i] = false;
	for (unsigned y = 0; y < raster->size; y++)
		for (unsigned x = 0; x < raster->size; x++)
			if (raster->triangles[y * raster->size + x] ==
				RASTER_NOTHING)
				boxes[y * VIEW_BOXES / raster->size *
						VIEW_BOXES +
					x * VIEW_BOXES / raster->size] = true;
}

static void
look_behind(struct look *look, const struct raster *before,
	const struct raster *after)
{
	bool a[VIEW_BOXES * VIEW_BOXES], b[VIEW_BOXES * VIEW_BOXES];

	find_boxes(before, a);
	find_boxes(after, b);
	for (unsigned i = 0; i < VIEW_BOXES * VIEW_BOXES; i++) {
		look->boxes[0] += a[i];
		look->boxes[1] += b[i];
		look->opened += b[i] && !a[i];
	}
}

static void
look_at_all(struct look *look, const struct compare_pictures *pictures)
{
	for (int i = 0; i < ALL_VIEWS; i++) {
		const struct raster *a = &pictures->rasters[0][i];
		const struct raster *b = &pictures->rasters[1][i];
		struct view view = compare_view(&look->before->set, i);

		look->last[0] = look->last[1] = RASTER_NOTHING;
		for (size_t k = 0; k < (size_t)a->size * a->size; k++)
			look_at_pixel(
				look, &view, a->triangles[k], b->triangles[k]);
		look_behind(look, a, b);
	}
}

/* ---- counting ------------------------------------------------------------ */

static bool
shows_an_image(const struct look *look, const struct compare_match *match,
	uint32_t component)
{
	struct images images = match_images(match, component);
	bool seen = false;

	for (size_t i = 0; i < images.count; i++)
		seen |= look->seen[1].parts[images.at[i]];
	return seen;
}

static void
count_sets(
	const struct look *look, const struct compare_match *match, double *at)
{
	const struct compare_side *before = look->before, *after = look->after;

	for (uint32_t i = 0; i < before->set.components.count; i++) {
		if (!look->seen[0].parts[i])
			continue;
		at[COMPARE_COMPONENTS_SEEN]++;
		at[COMPARE_COMPONENTS_HIDDEN] +=
			!shows_an_image(look, match, i);
	}
	for (size_t i = 0; i < before->twins.count; i++) {
		uint32_t twin = before->twins.at[i];

		if (!look->seen[0].features[i])
			continue;
		at[COMPARE_SURFACES_SEEN]++;
		at[COMPARE_SURFACES_HIDDEN] +=
			twin == TCS_NONE || !look->seen[1].features[twin];
	}
	for (size_t i = 0; i < after->twins.count; i++) {
		uint32_t twin = after->twins.at[i];

		at[COMPARE_SURFACES_UNCOVERED] += look->seen[1].features[i] &&
			(twin == TCS_NONE || !look->seen[0].features[twin]);
	}
}

/* Contacts of which both sides are seen, and those of them that are broken. */
static void
count_contacts(
	const struct look *look, const struct broken_list *broken, double *at)
{
	const struct contact_list *contacts = &look->before->contacts;
	const bool *seen = look->seen[0].parts;

	for (size_t i = 0; i < contacts->count; i++)
		at[COMPARE_CONTACTS_SEEN] +=
			seen[contacts->at[i].a] && seen[contacts->at[i].b];
	for (size_t i = 0; i < broken->count; i++)
		at[COMPARE_CONTACTS_SEEN_BROKEN] += seen[broken->at[i].a] &&
			seen[broken->at[i].b] &&
			broken->at[i].state != CONTACT_HALF_OPEN;
}

static void
fill_metrics(
	const struct look *look, const struct compare_match *match, double *at)
{
	double share = look->either > 0 ? 100 / look->either : 0;

	at[COMPARE_PIXELS] = look->either;
	at[COMPARE_HIT] = share * look->both;
	at[COMPARE_SAME_SURFACE] = share * look->same;
	at[COMPARE_SIMILARITY] = share * look->alike;
	at[COMPARE_BOXES_BEFORE] = look->boxes[0];
	at[COMPARE_BOXES_AFTER] = look->boxes[1];
	at[COMPARE_BOXES_OPENED] = look->opened;
	count_sets(look, match, at);
}

static bool
seen_allocate(struct seen *seen, const struct compare_side *side,
	const uint32_t *numbers, size_t parts)
{
	seen->numbers = numbers;
	seen->parts = calloc(parts + 1, sizeof *seen->parts);
	seen->features = calloc(side->twins.count + 1, sizeof *seen->features);
	return seen->parts && seen->features;
}

enum tcs_status
compare_views(const struct compare_side *before,
	const struct compare_side *after, const struct compare_match *match,
	const struct broken_list *broken, unsigned size,
	struct compare_pictures *pictures, struct compare_metrics *metrics,
	struct tcs_fault *fault)
{
	struct look look = {.before = before, .after = after};
	enum tcs_status status = TCS_OK;
	bool has_room = seen_allocate(&look.seen[0], before,
		before->set.numbers.at, before->set.components.count);

	has_room = seen_allocate(&look.seen[1], after, match->numbers.at,
			   match->pieces.count) &&
		has_room;
	if (!has_room)
		status = fault_memory(fault);
	else if (before->set.triangles.count > 0)
		status = draw_all(before, after, size, pictures, fault);
	if (!status && before->set.triangles.count > 0) {
		look_at_all(&look, pictures);
		fill_metrics(&look, match, metrics->at);
		count_contacts(&look, broken, metrics->at);
	}
	for (int i = 0; i < 2; i++) {
		free(look.seen[i].parts);
		free(look.seen[i].features);
	}
	return status;
}

void
pictures_release(struct compare_pictures *pictures)
{
	for (int i = 0; i < 2; i++)
		for (int k = 0; k < ALL_VIEWS; k++)
			raster_release(&pictures->rasters[i][k]);
}
