#include "node_queue.h"

#include <math.h>
#include <stdbool.h>

enum { ARMS = 4 }; /* children of an entry */

static void
put(struct node_queue *queue, size_t place, struct queue_entry entry)
{
	queue->heap.at[place] = entry;
	queue->places.at[entry.node] = (uint32_t)place;
}

static void
rise(struct node_queue *queue, size_t place, struct queue_entry entry)
{
	while (place > 0) {
		size_t parent = (place - 1) / ARMS;

		if (!queue_entry_leads(&entry, &queue->heap.at[parent]))
			break;
		put(queue, place, queue->heap.at[parent]);
		place = parent;
	}
	put(queue, place, entry);
}

static void
sink(struct node_queue *queue, size_t place, struct queue_entry entry)
{
	size_t count = queue->heap.count;

	for (;;) {
		size_t first = ARMS * place + 1, least = first;

		if (first >= count)
			break;
		for (size_t i = first + 1; i < first + ARMS && i < count; i++)
			if (queue_entry_leads(
				    &queue->heap.at[i], &queue->heap.at[least]))
				least = i;
		if (!queue_entry_leads(&queue->heap.at[least], &entry))
			break;
		put(queue, place, queue->heap.at[least]);
		place = least;
	}
	put(queue, place, entry);
}

static void
take_out(struct node_queue *queue, size_t place)
{
	struct queue_entry last = queue->heap.at[--queue->heap.count];
	struct queue_entry out = queue->heap.at[place];

	queue->places.at[out.node] = UINT32_MAX;
	if (place == queue->heap.count)
		return;
	if (queue_entry_leads(&last, &out))
		rise(queue, place, last);
	else
		sink(queue, place, last);
}

enum tcs_status
node_queue_reset(
	struct node_queue *queue, size_t count, struct tcs_fault *fault)
{
	array_clear(&queue->heap);
	array_clear(&queue->places);
	if (array_grow(&queue->heap, count) ||
		array_grow(&queue->places, count))
		return fault_memory(fault);
	queue->places.count = count;
	for (size_t i = 0; i < count; i++)
		queue->places.at[i] = UINT32_MAX;
	return TCS_OK;
}

void
node_queue_set(struct node_queue *queue, uint32_t node, double cost)
{
	struct queue_entry entry = {cost, node};
	uint32_t place = queue->places.at[node];

	if (!(cost < INFINITY)) {
		if (place != UINT32_MAX)
			take_out(queue, place);
	} else if (place == UINT32_MAX) {
		rise(queue, queue->heap.count++, entry);
	} else if (queue_entry_leads(&entry, &queue->heap.at[place])) {
		rise(queue, place, entry);
	} else {
		sink(queue, place, entry);
	}
}

const struct queue_entry *
node_queue_first(const struct node_queue *queue)
{
	return queue->heap.count > 0 ? queue->heap.at : NULL;
}

void
node_queue_release(struct node_queue *queue)
{
	array_release(&queue->heap);
	array_release(&queue->places);
}
