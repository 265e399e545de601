/*
 * A stream through a filter of objects: every object goes in, what it becomes
 * comes out, in order and by several threads; the head and all other records
 * pass.
 */
#ifndef TESSERA_OBJECT_STREAM_H
#define TESSERA_OBJECT_STREAM_H

#include "stage.h"
#include "tcs.h"

/* What one filter does; all but the sizes as in crew.h. */
struct object_work {
	void *context;
	uint64_t max_record; /* bytes */
	bool expand; /* placed prototypes become geometry of the objects, and
	                are left out of the stream themselves */
	size_t worker_size; /* scratch of a thread, zero at first */
	void (*worker_release)(void *worker);

	/* The coordinate systems, before any object comes. */
	void (*begin)(void *context, const struct tcs_crs *crs);

	/*
	 * Filter one object: *out, `object` itself or another, is valid until
	 * the worker's next one. Called by several threads, for one worker by
	 * one at a time.
	 */
	enum tcs_status (*filter)(void *context, void *worker,
		struct tcs_object *object, const struct tcs_object **out,
		struct report *report, struct tcs_fault *fault);
};

/*
 * Read the command's input, filter it, and write the stage's output. Fails as
 * the streams and the filter do, and with --strict for what was reported as
 * skipped.
 */
enum tcs_status object_stream_run(const struct object_work *filter,
	struct stage *stage, struct tcs_fault *fault) TCS_CHECKED;

#endif
