/*
 * Two streams read side by side: the objects of the one with those of the
 * other, by id.
 *
 * An object that comes later in the second stream than in the first waits in
 * memory, as do those before it: streams in the same order are never held, but
 * for their prototypes, which objects refer to until pairs_close.
 * Objects with the same id, or with none, are paired in the order they come.
 */
#ifndef TESSERA_COMPARE_PAIRS_H
#define TESSERA_COMPARE_PAIRS_H

#include <stdbool.h>

#include "byte_index.h"
#include "tcs.h"

/* An object and the record that lends it. */
struct pair_object {
	struct tcs_record record;
	struct tcs_object object;
	TCS_ARRAY(const struct tcs_object *)
	placed; /* per instance: its prototype; the stream's */
	struct pair_object *next; /* while it waits, by id */
};

/* One stream. */
struct pair_stream {
	struct tcs_reader reader;
	struct tcs_head head;
	struct tcs_record record; /* of the head */
	TCS_ARRAY(struct pair_object *) prototypes; /* so far */
};

struct pair_queue {
	struct pair_object *first, *last;
};

/* All zero is empty. */
struct pair_reader {
	struct pair_stream streams[2];
	struct byte_index ids; /* of waiting objects of the second stream */
	TCS_ARRAY(struct pair_queue) waiting; /* per id */
	size_t next_left; /* the first string of ids not yet emptied */
};

/*
 * Open both, NULL is standard input, and read their heads. Fails with
 * TCS_SYSTEM, and as reader_next and head_decode do; the fault names the file.
 */
enum tcs_status pairs_open(struct pair_reader *pairs,
	const char *const names[2], uint64_t max_record,
	struct tcs_fault *fault) TCS_CHECKED;

/*
 * The next pair, allocated, in the order of the first stream; then what is
 * left of the second. One of both may be NULL; both are at the end.
 */
enum tcs_status pairs_next(struct pair_reader *pairs,
	struct pair_object *pair[2], struct tcs_fault *fault) TCS_CHECKED;

void pair_object_free(struct pair_object *object); /* NULL is fine */
void pairs_close(struct pair_reader *pairs);

#endif
