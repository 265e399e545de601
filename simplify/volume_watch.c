#include "volume_watch.h"

#include <math.h>

#include "collapses.h"

/* Of its volume: with less a component is crushed, as tcs-compare(1) counts. */
#define LEAST_SHARE 0.1

/* Contacts that a component is worth not to be crushed. */
#define CRUSH_WORTH 4

/* Contacts that all of a panel is worth. */
#define PANEL_WORTH 3

/* Between the triangle and the origin. */
static double
volume_under(struct tcs_point a, struct tcs_point b, struct tcs_point c)
{
	return vector_dot(a, vector_cross(b, c)) / 6;
}

enum tcs_status
volume_watch_begin(struct volume_watch *watch, const struct component_set *set,
	struct tcs_fault *fault)
{
	size_t count = set->components.count;

	array_clear(&watch->volumes);
	array_clear(&watch->panels);
	if (array_grow(&watch->volumes, count) ||
		array_grow(&watch->panels, count))
		return fault_memory(fault);
	for (size_t i = 0; i < count; i++) {
		watch->volumes.at[i] = set->components.at[i].volume;
		watch->panels.at[i] = 0;
	}
	watch->volumes.count = watch->panels.count = count;
	watch->change = 0;
	return TCS_OK;
}

/* Seen from `place` all faces that are left have no volume under them. */
void
volume_watch_look(struct collapses *work, const struct watch_ring *ring,
	struct tcs_point place)
{
	const struct tcs_point *at = work->positions.at;
	struct tcs_point from =
		vector_difference(at[node_of(work, ring->vertex)], place);

	for (size_t i = 0; i < ring->count; i++) {
		size_t next = i + 1 < ring->count ? i + 1 : 0;
		uint32_t b = node_of(work, ring->spokes[i].to);
		uint32_t c = node_of(work, ring->spokes[next].to);

		if (ring->spokes[i].face == HALF_EDGE_NONE ||
			b == ring->without || c == ring->without)
			continue;
		work->volume.change -=
			volume_under(from, vector_difference(at[b], place),
				vector_difference(at[c], place));
	}
}

void
volume_watch_panel(
	struct volume_watch *watch, uint32_t component, double volume)
{
	watch->panels.at[component] = volume;
}

double
volume_watch_worth(const struct collapses *work, uint32_t node)
{
	uint32_t number = work->sheets->nodes.at[node].component;
	const struct component *own = &work->set->components.at[number];
	double least = LEAST_SHARE * fabs(own->volume);
	double now = work->volume.volumes.at[number];
	double panel = work->volume.panels.at[number];

	if (panel > 0)
		return PANEL_WORTH * fmax(-work->volume.change / panel, 0);
	if (!own->closed || fabs(now) < least)
		return 0;
	return fabs(now + work->volume.change) < least ? CRUSH_WORTH : 0;
}

void
volume_watch_follow(struct collapses *work, uint32_t node)
{
	uint32_t number = work->sheets->nodes.at[node].component;

	work->volume.volumes.at[number] += work->volume.change;
}

static double
volume_under_nodes(const struct collapses *work, const uint32_t nodes[3])
{
	const struct tcs_point *at = work->positions.at;

	return volume_under(at[nodes[0]], at[nodes[1]], at[nodes[2]]);
}

void
volume_watch_refill(struct collapses *work, const struct refill *refill)
{
	double change = 0;
	uint32_t nodes[3] = {0, 0, 0};

	for (size_t i = 0; i < refill->face_count; i++)
		if (collapses_face(work, refill->faces[i], nodes))
			change -= volume_under_nodes(work, nodes);
	for (size_t i = 0; i < refill->count; i++) {
		for (int k = 0; k < 3; k++)
			nodes[k] = node_of(
				work, refill->corners[3 * i + (size_t)k]);
		change += volume_under_nodes(work, nodes);
	}
	work->volume.volumes.at[work->sheets->nodes.at[nodes[0]].component] +=
		change;
}

void
volume_watch_release(struct volume_watch *watch)
{
	array_release(&watch->volumes);
	array_release(&watch->panels);
}
