#include "sweep_status.h"

enum tcs_status
status_begin(struct sweep_status *status, size_t most, struct tcs_fault *fault)
{
	status->intervals.count = 0;
	status->root = 0;
	if (planar_room(&status->intervals, most + 1))
		return fault_memory(fault);
	status->intervals.at[0] = (struct sweep_interval){0};
	status->intervals.count = 1;
	return TCS_OK;
}

/* Put `child` where `node` hangs. */
static void
replace(struct sweep_status *status, uint32_t node, uint32_t child)
{
	struct sweep_interval *all = status->intervals.at;
	uint32_t parent = all[node].parent;

	if (!parent)
		status->root = child;
	else if (all[parent].left == node)
		all[parent].left = child;
	else
		all[parent].right = child;
	if (child)
		all[child].parent = parent;
}

/* Lift `node` above its parent. */
static void
rotate(struct sweep_status *status, uint32_t node)
{
	struct sweep_interval *all = status->intervals.at;
	uint32_t parent = all[node].parent;
	uint32_t moved;

	replace(status, parent, node);
	if (all[parent].left == node) {
		moved = all[node].right;
		all[parent].left = moved;
		all[node].right = parent;
	} else {
		moved = all[node].left;
		all[parent].right = moved;
		all[node].left = parent;
	}
	all[parent].parent = node;
	if (moved)
		all[moved].parent = parent;
}

static void
splay(struct sweep_status *status, uint32_t node)
{
	const struct sweep_interval *all = status->intervals.at;
	uint32_t parent, above;

	while ((parent = all[node].parent)) {
		above = all[parent].parent;
		if (above) {
			bool straight = (all[above].left == parent) ==
				(all[parent].left == node);

			rotate(status, straight ? parent : node);
		}
		rotate(status, node);
	}
}

struct sweep_place
status_find(struct sweep_status *status, const struct planar *polygon,
	struct planar_point at)
{
	const struct sweep_interval *all = status->intervals.at;
	struct sweep_place place = {0};
	uint32_t node = status->root, last = 0;

	while (node) {
		double side = planar_side(polygon, all[node].lower, at);

		last = node;
		if (side < 0) {
			place.above = node;
			node = all[node].left;
			continue;
		}
		if (side > 0)
			side = planar_side(polygon, all[node].upper, at);
		if (side == 0) {
			place.on_edge = true;
			break;
		}
		if (side > 0) {
			place.in = node;
			break;
		}
		place.below = node;
		node = all[node].right;
	}
	if (last)
		splay(status, last);
	return place;
}

uint32_t
status_insert(struct sweep_status *status, uint32_t below, uint32_t above)
{
	struct sweep_interval *all = status->intervals.at;
	uint32_t node = (uint32_t)status->intervals.count++;

	all[node] = (struct sweep_interval){.below = below, .above = above};
	if (below)
		all[below].above = node;
	if (above)
		all[above].below = node;
	/* Of two neighbours one has no child on the other's side. */
	if (below && !all[below].right) {
		all[below].right = node;
		all[node].parent = below;
	} else if (above) {
		all[above].left = node;
		all[node].parent = above;
	}
	splay(status, node);
	status->root = node;
	return node;
}

void
status_remove(struct sweep_status *status, uint32_t node)
{
	struct sweep_interval *all = status->intervals.at;
	uint32_t below = all[node].below, above = all[node].above;

	if (below)
		all[below].above = above;
	if (above)
		all[above].below = below;
	splay(status, node);
	if (!all[node].left) {
		replace(status, node, all[node].right);
		return;
	}
	/* The neighbour below becomes the root of the left part. */
	status->root = all[node].left;
	all[status->root].parent = 0;
	splay(status, below);
	all[below].right = all[node].right;
	if (all[node].right)
		all[all[node].right].parent = below;
}

void
status_release(struct sweep_status *status)
{
	array_release(&status->intervals);
}
