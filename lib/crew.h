/*
 * An ordered crew of threads: read | work on N threads | write in order.
 *
 * Items live in slots that the caller allocates and the crew reuses: `read`
 * fills one, `work` changes it, `write` empties it. Reads happen one at a
 * time and in order; so do writes, in the order of the reads; works happen at
 * the same time on different slots. With one job everything runs on the
 * calling thread: same calls, same order of writes, same result.
 */
#ifndef TESSERA_CREW_H
#define TESSERA_CREW_H

#include <stdbool.h>
#include <stddef.h>

#include "fault.h"

struct crew_plan {
	void *context; /* handed to all three */
	void *slots; /* slot_count items of slot_size bytes, ready for use */
	size_t slot_size;
	size_t slot_count; /* at least 1; crew_slots(jobs) is a good number */

	/* Fill the slot, or set *done when there is nothing left. */
	enum tcs_status (*read)(
		void *context, void *slot, bool *done, struct tcs_fault *fault);
	/* May be NULL. `worker` counts from 0 below the number of jobs, for
	   scratch memory of its own. */
	enum tcs_status (*work)(void *context, void *slot, size_t worker,
		struct tcs_fault *fault);
	enum tcs_status (*write)(
		void *context, void *slot, struct tcs_fault *fault);
};

size_t crew_slots(unsigned jobs);

/* The number of processors this process may run on, at least 1. */
unsigned crew_processors(void);

/*
 * Run until `read` is done and all is written, or until something fails. After
 * a failure no new item begins, items before the failed one are still written,
 * and the fault is that of the earliest item in reading order, whatever the
 * number of jobs. Fails also with TCS_SYSTEM when no thread can be started.
 */
enum tcs_status crew_run(const struct crew_plan *plan, unsigned jobs,
	struct tcs_fault *fault) TCS_CHECKED;

#endif
