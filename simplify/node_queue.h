/*
 * A priority queue of nodes, each at most once: the cheapest comes first, of
 * equally cheap ones that with the lowest number.
 */
#ifndef TESSERA_NODE_QUEUE_H
#define TESSERA_NODE_QUEUE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "array.h"
#include "fault.h"

struct queue_entry {
	double cost;
	uint32_t node;
};

/* Whether it comes first. */
static inline bool
queue_entry_leads(const struct queue_entry *a, const struct queue_entry *b)
{
	return a->cost < b->cost || (!(b->cost < a->cost) && a->node < b->node);
}

/* All zero is empty; reused from object to object. */
struct node_queue {
	TCS_ARRAY(struct queue_entry) heap;
	TCS_ARRAY(uint32_t) places; /* per node: in the heap; or UINT32_MAX */
};

/* Empty, for nodes below `count`. Fails with TCS_NO_MEMORY. */
enum tcs_status node_queue_reset(struct node_queue *queue, size_t count,
	struct tcs_fault *fault) TCS_CHECKED;

/* Put a node in, or change its cost. INFINITY takes it out. */
void node_queue_set(struct node_queue *queue, uint32_t node, double cost);

/* Whether anything is left; the first, which stays in. */
const struct queue_entry *node_queue_first(const struct node_queue *queue);

void node_queue_release(struct node_queue *queue);

#endif
