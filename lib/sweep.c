#include "sweep.h"

/*
 * Each interval has a chain: the vertices that border its part right of the
 * triangles made so far, from the left end of its lower edge (the head) up to
 * the left end of its upper edge (the tail). A chain bulges to the right, for
 * any corner that does not is cut off as a triangle at once; so a new vertex
 * sees a run of the chain from either end, and from the chain's latest vertex,
 * its rightmost, both ways.
 */
struct run {
	struct sweep *sweep;
	const struct planar *polygon;
	struct triangle_list *out;
};

static struct planar_point
point_of(const struct run *run, uint32_t link)
{
	return run->polygon->points.at[run->sweep->links.at[link].vertex];
}

static uint32_t
link_new(struct run *run, uint32_t vertex)
{
	uint32_t link = (uint32_t)run->sweep->links.count++;

	run->sweep->links.at[link] = (struct sweep_link){.vertex = vertex};
	return link;
}

/* Cut the corner off if it is convex, seen from the right. */
static bool
corner_cut(struct run *run, uint32_t down, uint32_t corner, uint32_t up)
{
	struct sweep_link *links = run->sweep->links.at;
	double area = planar_orient(
		point_of(run, up), point_of(run, corner), point_of(run, down));

	if (area <= 0)
		return false;
	run->sweep->area += area;
	run->out->at[run->out->count++] = (struct tcs_triangle){
		{links[up].vertex, links[corner].vertex, links[down].vertex}};
	return true;
}

/* Join `link` below the chain that begins at `head`. */
static void
chain_below(struct run *run, uint32_t link, uint32_t head)
{
	struct sweep_link *links = run->sweep->links.at;
	uint32_t up = links[head].up;

	while (up && corner_cut(run, link, head, up)) {
		head = up;
		up = links[head].up;
	}
	links[link].up = head;
	links[head].down = link;
}

static void
chain_above(struct run *run, uint32_t link, uint32_t tail)
{
	struct sweep_link *links = run->sweep->links.at;
	uint32_t down = links[tail].down;

	while (down && corner_cut(run, down, tail, link)) {
		tail = down;
		down = links[tail].down;
	}
	links[link].down = tail;
	links[tail].up = link;
}

static void
lower_set(struct run *run, uint32_t interval, uint32_t edge)
{
	run->sweep->status.intervals.at[interval].lower = edge;
	run->sweep->edge_interval.at[edge] = interval;
}

static void
upper_set(struct run *run, uint32_t interval, uint32_t edge)
{
	run->sweep->status.intervals.at[interval].upper = edge;
	run->sweep->edge_interval.at[edge] = interval;
}

/* Whether the vertex is strictly on the inner side of the edges around it. */
static bool
is_above(const struct run *run, uint32_t interval, uint32_t vertex)
{
	const struct sweep_interval *all = run->sweep->status.intervals.at;

	return planar_side(run->polygon, all[interval].lower,
		       run->polygon->points.at[vertex]) > 0;
}

static bool
is_below(const struct run *run, uint32_t interval, uint32_t vertex)
{
	const struct sweep_interval *all = run->sweep->status.intervals.at;

	return planar_side(run->polygon, all[interval].upper,
		       run->polygon->points.at[vertex]) > 0;
}

/* Whether it is strictly outside of a neighbour; without one it is. */
static bool
is_clear_above(const struct run *run, uint32_t interval, uint32_t vertex)
{
	const struct sweep_interval *all = run->sweep->status.intervals.at;

	return !interval ||
		planar_side(run->polygon, all[interval].upper,
			run->polygon->points.at[vertex]) < 0;
}

static bool
is_clear_below(const struct run *run, uint32_t interval, uint32_t vertex)
{
	const struct sweep_interval *all = run->sweep->status.intervals.at;

	return !interval ||
		planar_side(run->polygon, all[interval].lower,
			run->polygon->points.at[vertex]) < 0;
}

/* ---- the six kinds of vertices -------------------------------------------- */

/* Both edges lead right, with the inside between them. */
static bool
vertex_start(struct run *run, uint32_t vertex)
{
	struct sweep_status *status = &run->sweep->status;
	struct sweep_place place = status_find(
		status, run->polygon, run->polygon->points.at[vertex]);
	struct sweep_interval *interval;
	uint32_t added, link;

	if (place.on_edge || place.in)
		return false;
	added = status_insert(status, place.below, place.above);
	link = link_new(run, vertex);
	interval = &status->intervals.at[added];
	interval->head = interval->tail = interval->latest = link;
	lower_set(run, added, vertex);
	upper_set(run, added, run->polygon->previous.at[vertex]);
	return true;
}

/* Both edges lead right, with the outside between them. */
static bool
vertex_split(struct run *run, uint32_t vertex)
{
	struct sweep_status *status = &run->sweep->status;
	struct sweep_place place = status_find(
		status, run->polygon, run->polygon->points.at[vertex]);
	struct sweep_link *links = run->sweep->links.at;
	struct sweep_interval *low, *high;
	uint32_t added, copy, link, middle;

	if (place.on_edge || !place.in)
		return false;
	low = &status->intervals.at[place.in];
	added = status_insert(status, place.in, low->above);
	high = &status->intervals.at[added];
	upper_set(run, added, low->upper);
	lower_set(run, added, vertex);
	upper_set(run, place.in, run->polygon->previous.at[vertex]);

	middle = low->latest;
	copy = link_new(run, links[middle].vertex);
	links[copy].up = links[middle].up;
	if (links[copy].up)
		links[links[copy].up].down = copy;
	links[middle].up = 0;
	high->tail = low->tail == middle ? copy : low->tail;

	link = link_new(run, vertex);
	chain_above(run, link, middle);
	low->tail = low->latest = link;
	link = link_new(run, vertex);
	chain_below(run, link, copy);
	high->head = high->latest = link;
	return true;
}

/* Both edges come from the left, with the inside between them. */
static bool
vertex_end(struct run *run, uint32_t vertex)
{
	struct sweep_status *status = &run->sweep->status;
	uint32_t edge = run->polygon->previous.at[vertex];
	uint32_t ended = run->sweep->edge_interval.at[edge];
	const struct sweep_interval *interval = &status->intervals.at[ended];
	struct sweep_link *links = run->sweep->links.at;
	uint32_t below = interval->below, above = interval->above;
	uint32_t low, high;

	if (ended != run->sweep->edge_interval.at[vertex] ||
		!is_clear_above(run, below, vertex) ||
		!is_clear_below(run, above, vertex))
		return false;
	low = link_new(run, vertex);
	chain_below(run, low, interval->head);
	high = link_new(run, vertex);
	chain_above(run, high, interval->tail);
	status_remove(status, ended);
	return links[high].down == links[low].up;
}

/* Both edges come from the left, with the outside between them. */
static bool
vertex_merge(struct run *run, uint32_t vertex)
{
	struct sweep_status *status = &run->sweep->status;
	uint32_t edge = run->polygon->previous.at[vertex];
	uint32_t high_at = run->sweep->edge_interval.at[edge];
	uint32_t low_at = run->sweep->edge_interval.at[vertex];
	struct sweep_interval *low = &status->intervals.at[low_at];
	struct sweep_interval *high = &status->intervals.at[high_at];
	uint32_t link;

	if (low->above != high_at || !is_above(run, low_at, vertex) ||
		!is_below(run, high_at, vertex))
		return false;
	link = link_new(run, vertex);
	chain_above(run, link, low->tail);
	chain_below(run, link, high->head);
	low->tail = high->tail;
	low->latest = link;
	upper_set(run, low_at, high->upper);
	status_remove(status, high_at);
	return true;
}

/* One edge leads on from the other, with the inside above them. */
static bool
vertex_lower(struct run *run, uint32_t vertex)
{
	struct sweep_interval *all = run->sweep->status.intervals.at;
	uint32_t edge = run->polygon->previous.at[vertex];
	uint32_t at = run->sweep->edge_interval.at[edge];
	uint32_t link;

	if (!is_below(run, at, vertex) ||
		!is_clear_above(run, all[at].below, vertex))
		return false;
	link = link_new(run, vertex);
	chain_below(run, link, all[at].head);
	all[at].head = all[at].latest = link;
	lower_set(run, at, vertex);
	return true;
}

/* The same with the inside below them. */
static bool
vertex_upper(struct run *run, uint32_t vertex)
{
	struct sweep_interval *all = run->sweep->status.intervals.at;
	uint32_t at = run->sweep->edge_interval.at[vertex];
	uint32_t link;

	if (!is_above(run, at, vertex) ||
		!is_clear_below(run, all[at].above, vertex))
		return false;
	link = link_new(run, vertex);
	chain_above(run, link, all[at].tail);
	all[at].tail = all[at].latest = link;
	upper_set(run, at, run->polygon->previous.at[vertex]);
	return true;
}

/* ---- the sweep -------------------------------------------------------------- */

static bool
is_left(struct planar_point a, struct planar_point b)
{
	return a.x < b.x || (a.x == b.x && a.y < b.y);
}

static bool
vertex_pass(struct run *run, uint32_t vertex)
{
	const struct planar_point *points = run->polygon->points.at;
	struct planar_point at = points[vertex];
	struct planar_point from = points[run->polygon->previous.at[vertex]];
	struct planar_point to = points[run->polygon->next.at[vertex]];
	bool from_left = is_left(from, at), to_left = is_left(to, at);
	double turn;

	if (from_left && !to_left)
		return vertex_lower(run, vertex);
	if (!from_left && to_left)
		return vertex_upper(run, vertex);
	turn = planar_orient(from, at, to);
	if (turn == 0)
		return false;
	if (from_left)
		return turn > 0 ? vertex_end(run, vertex)
				: vertex_merge(run, vertex);
	return turn > 0 ? vertex_start(run, vertex) : vertex_split(run, vertex);
}

/*
 * Every vertex makes at most three links and every triangle takes one away,
 * save that splits leave two copies.
 */
static enum tcs_status
sweep_begin(struct sweep *sweep, const struct planar *polygon,
	struct triangle_list *out, struct tcs_fault *fault)
{
	size_t count = polygon->kept.count;

	sweep->events.count = 0;
	sweep->sorted.count = 0;
	sweep->edge_interval.count = 0;
	sweep->links.count = 0;
	sweep->area = 0;
	if (planar_room(&sweep->events, count) ||
		planar_room(&sweep->sorted, count) ||
		planar_room(&sweep->edge_interval, polygon->points.count) ||
		planar_room(&sweep->links, 3 * count + 1) ||
		planar_room(out, 3 * count))
		return fault_memory(fault);
	for (size_t i = 0; i < count; i++) {
		uint32_t vertex = polygon->kept.at[i];
		struct planar_point at = polygon->points.at[vertex];

		sweep->events.at[i] = (struct sweep_event){at.x, at.y, vertex};
	}
	sweep_sort(sweep->events.at, count, sweep->sorted.at);
	array_trim(&sweep->sorted);
	sweep->links.count = 1;
	return status_begin(&sweep->status, count, fault);
}

enum tcs_status
sweep_run(struct sweep *sweep, const struct planar *polygon,
	struct triangle_list *out, bool *simple, struct tcs_fault *fault)
{
	struct run run = {sweep, polygon, out};
	size_t before = out->count, count = polygon->kept.count;
	enum tcs_status status = sweep_begin(sweep, polygon, out, fault);

	if (status)
		return status;
	*simple = true;
	for (size_t i = 0; i < count && *simple; i++)
		*simple = vertex_pass(&run, sweep->events.at[i].vertex);
	if (!*simple)
		out->count = before;
	return TCS_OK;
}

void
sweep_trim(struct sweep *sweep)
{
	array_trim(&sweep->status.intervals);
	array_trim(&sweep->events);
	array_trim(&sweep->edge_interval);
	array_trim(&sweep->links);
}

void
sweep_release(struct sweep *sweep)
{
	status_release(&sweep->status);
	array_release(&sweep->events);
	array_release(&sweep->sorted);
	array_release(&sweep->edge_interval);
	array_release(&sweep->links);
}
