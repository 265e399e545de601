#include "visible.h"

#include <math.h>
#include <stdlib.h>

#include "raster.h"
#include "split_work.h"
#include "triangle_tree.h"
#include "vector.h"

enum { RAYS_PER_PIECE = 4096 };

/* What some of the directions show. */
struct tally {
	uint32_t *pixels; /* of each triangle */
	uint64_t *open; /* of each: the directions in which it may be seen */
	bool *shown; /* of each group: some pixel shows it */
	struct raster raster;
	bool failed; /* for want of memory */
};

struct looking {
	const struct tcs_point *points;
	size_t point_count;
	const struct tcs_triangle *triangles;
	size_t count;
	const struct visible_views *views;
	struct tcs_point ways[VISIBLE_MOST_DIRECTIONS];
	struct tcs_point middle;
	double radius;
	struct tally *tallies; /* of each piece of the directions */
	struct triangle_tree tree;
	uint32_t root;
	double *areas;
};

static struct triangle_shape
shape_at(const struct looking *looking, size_t i)
{
	const uint32_t *corner = looking->triangles[i].corner;

	return (struct triangle_shape){{looking->points[corner[0]],
		looking->points[corner[1]], looking->points[corner[2]]}};
}

static struct tcs_point
centre_of(const struct triangle_shape *shape)
{
	struct tcs_point sum = vector_sum(shape->corner[0],
		vector_sum(shape->corner[1], shape->corner[2]));

	return vector_scaled(sum, 1.0 / 3);
}

struct tcs_point
visible_direction(const struct visible_views *views, unsigned number)
{
	static const double golden_angle = 2.399963229728653;
	double share = (number + 0.5) / views->directions;
	double height = 1 - share * (1 - views->lowest);
	double flat = sqrt(fmax(1 - height * height, 0));
	double turn = golden_angle * number;

	return (struct tcs_point){
		-flat * cos(turn), -flat * sin(turn), -height};
}

/* ---- pictures ------------------------------------------------------------ */

static void
count_pixels(struct tally *tally)
{
	const struct raster *raster = &tally->raster;
	size_t count = (size_t)raster->size * raster->size;

	for (size_t i = 0; i < count; i++)
		if (raster->triangles[i] != RASTER_NOTHING)
			tally->pixels[raster->triangles[i]]++;
}

/* Whether some pixel around the spot shows nothing that is before it by more
   than rounding. */
static bool
is_open(const struct raster *raster, const struct view *view,
	const struct spot *spot)
{
	double reached = spot->nearness + 1e-6 * view->farthest;
	int size = (int)raster->size;
	int column = (int)floor(spot->x), row = (int)floor(spot->y);

	if (column < 1 || row < 1 || column + 1 >= size || row + 1 >= size)
		return true;
	for (int y = row - 1; y <= row + 1; y++) {
		const float *there = raster->nearness +
			(size_t)y * raster->size + (size_t)column;

		if ((double)there[-1] <= reached ||
			(double)there[0] <= reached ||
			(double)there[1] <= reached)
			return true;
	}
	return false;
}

/* Which groups need no ray. */
static void
note_shown(const struct looking *looking, struct tally *tally)
{
	const uint32_t *groups = looking->views->groups;

	for (size_t i = 0; groups && i < looking->count; i++)
		if (tally->pixels[i])
			tally->shown[groups[i]] = true;
}

static void
note_open(const struct looking *looking, const struct view *view,
	unsigned number, struct tally *tally)
{
	const uint32_t *groups = looking->views->groups;

	for (size_t i = 0; i < looking->count; i++) {
		struct triangle_shape shape;
		struct spot spot;

		if (groups ? tally->shown[groups[i]] : tally->pixels[i] > 0)
			continue;
		shape = shape_at(looking, i);
		spot = view_spot(view, tally->raster.size, centre_of(&shape));
		if (is_open(&tally->raster, view, &spot))
			tally->open[i] |= UINT64_C(1) << number;
	}
}

static void
draw_some(void *context, size_t piece, size_t first, size_t end)
{
	struct looking *looking = context;
	struct tally *tally = &looking->tallies[piece];
	struct tcs_fault fault;

	tally->pixels = calloc(looking->count, sizeof *tally->pixels);
	tally->open = calloc(looking->count, sizeof *tally->open);
	tally->shown =
		calloc(looking->views->group_count + 1, sizeof *tally->shown);
	tally->failed = !tally->pixels || !tally->open || !tally->shown;
	for (size_t i = first; i < end && !tally->failed; i++) {
		unsigned number = (unsigned)i;
		struct view view = view_parallel(looking->ways[number],
			looking->middle, looking->radius);

		tally->failed = raster_draw(&tally->raster,
			looking->views->size, &view, looking->points,
			looking->point_count, looking->triangles,
			looking->count, looking->views->fronts, &fault);
		if (tally->failed)
			break;
		count_pixels(tally);
		note_shown(looking, tally);
		note_open(looking, &view, number, tally);
	}
	raster_release(&tally->raster);
}

/* Put all tallies into the first. */
static void
add_up(struct looking *looking, size_t pieces)
{
	struct tally *all = looking->tallies;

	for (size_t k = 1; k < pieces; k++) {
		const struct tally *more = &looking->tallies[k];

		for (size_t i = 0; i < looking->count; i++) {
			all->pixels[i] += more->pixels[i];
			all->open[i] |= more->open[i];
		}
		for (size_t i = 0; i < looking->views->group_count; i++)
			all->shown[i] |= more->shown[i];
	}
}

static enum tcs_status
draw_all(struct looking *looking, size_t pieces, struct tcs_fault *fault)
{
	size_t count = looking->views->directions;
	enum tcs_status status =
		split_work(count, (count + pieces - 1) / pieces,
			looking->views->jobs, draw_some, looking, fault);

	for (size_t i = 0; i < pieces && !status; i++)
		if (looking->tallies[i].failed)
			status = fault_memory(fault);
	if (!status)
		add_up(looking, pieces);
	return status;
}

/* ---- rays ---------------------------------------------------------------- */

/*
 * Whether something stands before a point. What stood in the way of the last
 * ray mostly does in that of the next, so that is tried first.
 */
static bool
is_blocked(const struct looking *looking, struct tcs_point from,
	struct tcs_point out, uint32_t *blocker)
{
	double reach = 2 * looking->radius, t, margin;
	struct tree_hit hit;

	if (*blocker != TCS_NONE) {
		struct triangle_shape shape = shape_at(looking, *blocker);

		if (triangle_hit(&shape, from, out, &t, &margin) && t > 0 &&
			t < reach)
			return true;
	}
	hit = triangle_tree_any(
		&looking->tree, looking->root, from, out, reach);
	if (!(hit.distance < INFINITY))
		return false;
	*blocker = hit.item;
	return true;
}

/* What a ray from the middle of a triangle sees is all or nothing. */
static double
area_by_rays(const struct looking *looking, size_t i, uint64_t open)
{
	struct triangle_shape shape = shape_at(looking, i);
	struct tcs_point centre = centre_of(&shape);
	struct tcs_point normal = triangle_normal(&shape);
	unsigned count = looking->views->directions;
	const signed char *fronts = looking->views->fronts;
	int front = fronts ? fronts[i] : 0;
	uint32_t blocker = TCS_NONE;

	for (unsigned k = 0; k < count; k++) {
		struct tcs_point out;
		double along, slant;

		if (!(open >> k & 1))
			continue;
		out = vector_scaled(looking->ways[k], -1);
		along = vector_dot(normal, out);
		slant = fabs(along) / 2;
		if (slant > 0 && front * along >= 0 &&
			!is_blocked(looking,
				vector_along(
					centre, out, 1e-7 * looking->radius),
				out, &blocker))
			return slant / count;
	}
	return 0;
}

static void
cast_some(void *context, size_t piece, size_t first, size_t end)
{
	struct looking *looking = context;
	const struct tally *all = looking->tallies;
	double width = 2 * looking->radius / looking->views->size;

	(void)piece;
	for (size_t i = first; i < end; i++)
		if (all->pixels[i])
			looking->areas[i] = all->pixels[i] * width * width /
				looking->views->directions;
		else if (all->open[i])
			looking->areas[i] =
				area_by_rays(looking, i, all->open[i]);
		else
			looking->areas[i] = 0;
}

/* What needs no ray is not open any more. */
static void
close_groups(struct looking *looking)
{
	const uint32_t *groups = looking->views->groups;
	struct tally *all = looking->tallies;

	for (size_t i = 0; groups && i < looking->count; i++)
		if (all->shown[groups[i]])
			all->open[i] = 0;
}

static bool
any_ray(const struct looking *looking)
{
	const struct tally *all = looking->tallies;

	for (size_t i = 0; i < looking->count; i++)
		if (!all->pixels[i] && all->open[i])
			return true;
	return false;
}

static enum tcs_status
grow_tree(struct looking *looking, struct tcs_fault *fault)
{
	uint32_t *items = calloc(looking->count, sizeof *items);
	enum tcs_status status;

	if (!items)
		return fault_memory(fault);
	for (size_t i = 0; i < looking->count; i++)
		items[i] = (uint32_t)i;
	status = triangle_tree_add(&looking->tree, looking->points,
		looking->triangles, items, looking->count, &looking->root,
		fault);
	free(items);
	return status;
}

static enum tcs_status
cast_all(struct looking *looking, struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	close_groups(looking);
	if (any_ray(looking))
		status = grow_tree(looking, fault);
	return status
		? status
		: split_work(looking->count, RAYS_PER_PIECE,
			  looking->views->jobs, cast_some, looking, fault);
}

/* ---- all of it ----------------------------------------------------------- */

static void
enclose(struct looking *looking)
{
	struct box box = BOX_EMPTY;

	for (size_t i = 0; i < looking->count; i++) {
		struct triangle_shape shape = shape_at(looking, i);

		for (int k = 0; k < 3; k++)
			box_add_point(&box, shape.corner[k]);
	}
	looking->middle = (struct tcs_point){(box.low[0] + box.high[0]) / 2,
		(box.low[1] + box.high[1]) / 2, (box.low[2] + box.high[2]) / 2};
	looking->radius = fmax(0.5001 * box_diagonal(&box), 1e-6);
}

enum tcs_status
visible_find(const struct tcs_point *points, size_t point_count,
	const struct tcs_triangle *triangles, size_t triangle_count,
	const struct visible_views *views, double *areas,
	struct tcs_fault *fault)
{
	struct looking looking = {.points = points,
		.point_count = point_count,
		.triangles = triangles,
		.count = triangle_count,
		.views = views,
		.areas = areas};
	size_t pieces = views->jobs ? views->jobs : 1;
	enum tcs_status status;

	if (!triangle_count)
		return TCS_OK;
	if (pieces > views->directions)
		pieces = views->directions;
	pieces = split_pieces(
		views->directions, split_pieces(views->directions, pieces));
	looking.tallies = calloc(pieces, sizeof *looking.tallies);
	if (!looking.tallies)
		return fault_memory(fault);
	enclose(&looking);
	for (unsigned k = 0; k < views->directions; k++)
		looking.ways[k] = visible_direction(views, k);
	status = draw_all(&looking, pieces, fault);
	if (!status)
		status = cast_all(&looking, fault);
	for (size_t i = 0; i < pieces; i++) {
		free(looking.tallies[i].pixels);
		free(looking.tallies[i].open);
		free(looking.tallies[i].shown);
	}
	free(looking.tallies);
	triangle_tree_release(&looking.tree);
	return status;
}
