#include "split_work.h"

#include "crew.h"

struct split {
	size_t count, size, next;
	split_piece *work;
	void *context;
};

static enum tcs_status
take_piece(void *context, void *slot, bool *done, struct tcs_fault *fault)
{
	struct split *split = context;
	size_t *piece = slot;

	(void)fault;
	*done = split->next * split->size >= split->count;
	*piece = split->next++;
	return TCS_OK;
}

static enum tcs_status
work_on_piece(void *context, void *slot, void *worker, struct tcs_fault *fault)
{
	const struct split *split = context;
	const size_t *piece = slot;
	size_t first = *piece * split->size;
	size_t left = split->count - first;

	(void)worker;
	(void)fault;
	split->work(split->context, *piece, first,
		first + (left < split->size ? left : split->size));
	return TCS_OK;
}

static enum tcs_status
leave_piece(void *context, void *slot, struct tcs_fault *fault)
{
	(void)context;
	(void)slot;
	(void)fault;
	return TCS_OK;
}

enum tcs_status
split_work(size_t count, size_t size, unsigned jobs, split_piece *work,
	void *context, struct tcs_fault *fault)
{
	struct split split = {count, size, 0, work, context};
	unsigned threads = count > size ? jobs : 1;
	const struct crew_plan plan = {
		.context = &split,
		.slot_size = sizeof(size_t),
		.read = take_piece,
		.work = work_on_piece,
		.write = leave_piece,
	};

	return crew_run(&plan, threads ? threads : 1, fault);
}
