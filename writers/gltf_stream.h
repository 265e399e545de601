/*
 * From a component stream to a city: read in order, convert objects on N
 * threads, add them in order. The result is the same for any N.
 */
#ifndef TESSERA_GLTF_STREAM_H
#define TESSERA_GLTF_STREAM_H

#include <stdbool.h>
#include <stdint.h>

#include "fault.h"
#include "gltf_city.h"
#include "gltf_convert.h"
#include "progress.h"
#include "report.h"
#include "tcs.h"

struct stream_settings {
	struct convert_settings convert; /* the frame is filled here */
	uint64_t max_record; /* limit on one record's bytes */
	unsigned jobs;
	bool strict;
};

/* What the stream's head said. All zero is empty. */
struct stream_head {
	struct tcs_record record;
	struct tcs_head head; /* lent by the record */
	struct tcs_point origin; /* of the glTF, in the stream's units */
};

/*
 * Read all of a file; NULL is standard input. Without an origin in the head, it is the first vertex,
 * rounded down. `head` must be released on failure too.
 */
enum tcs_status stream_to_city(const char *name,
	const struct stream_settings *settings, struct city *city,
	struct stream_head *head, struct report *report,
	struct progress *progress, struct tcs_fault *fault) TCS_CHECKED;

void stream_head_release(struct stream_head *head);

#endif
