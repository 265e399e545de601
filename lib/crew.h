/*
 * An ordered crew of threads: read | work on N threads | write in order.
 *
 * Items live in slots that the crew reuses: `read` fills one, `work` changes
 * it, `write` empties it. Reads happen one at a time and in order; so do
 * writes, in the order of the reads; works happen at the same time on
 * different slots. With one job everything runs on the calling thread: same
 * calls, same order of writes, same result.
 *
 * A slot is whatever struct the plan gives the size of, and so is a worker,
 * the scratch memory of one thread. Both are all zero at first, keep what they
 * hold from item to item, and are released when the run is over.
 */
#ifndef TESSERA_CREW_H
#define TESSERA_CREW_H

#include <stdbool.h>
#include <stddef.h>

#include "fault.h"

struct crew_plan {
	void *context; /* handed to all that take one */
	size_t slot_size; /* bytes, at least 1 */
	size_t slot_count; /* 0: as many as suit the jobs */
	size_t worker_size; /* bytes; 0: `worker` is NULL */

	/* Fill the slot, or set *done when there is nothing left. */
	enum tcs_status (*read)(
		void *context, void *slot, bool *done, struct tcs_fault *fault);
	/* May be NULL. */
	enum tcs_status (*work)(void *context, void *slot, void *worker,
		struct tcs_fault *fault);
	enum tcs_status (*write)(
		void *context, void *slot, struct tcs_fault *fault);

	/* All three may be NULL. Each worker begins before the first read; one
	   that failed to, or never did and is all zero, is released too. */
	enum tcs_status (*worker_begin)(
		void *context, void *worker, struct tcs_fault *fault);
	void (*worker_release)(void *worker);
	void (*slot_release)(void *slot);
};

/* The number of processors this process may run on, at least 1. */
unsigned crew_processors(void);

/*
 * Run until `read` is done and all is written, or until something fails. After
 * a failure no new item begins, items before the failed one are still written,
 * and the fault is that of the earliest item in reading order, whatever the
 * number of jobs. Fails also with TCS_SYSTEM when no thread can be started,
 * and with TCS_NO_MEMORY.
 */
enum tcs_status crew_run(const struct crew_plan *plan, unsigned jobs,
	struct tcs_fault *fault) TCS_CHECKED;

#endif
