/*
 * Where the top-level features stand in the document, and which ids are in
 * each: so that a later pass reads only those that it needs.
 *
 * The log goes to a file without a name once it is long; a hash stands for an
 * id, so more may be selected than is needed, never less.
 */
#ifndef TESSERA_CITYGML_PARTS_H
#define TESSERA_CITYGML_PARTS_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

#include "array.h"
#include "citygml_raw.h"

/* Parts of a document in their order, to be read below its root element. */
struct document_parts {
	TCS_ARRAY(struct raw_place) places;
	uint64_t head_end; /* behind the start tag of the root element */
};

void parts_release(struct document_parts *parts);

/* All zero is the empty log. */
struct place_log {
	FILE *file; /* NULL while it is short */
	TCS_ARRAY(uint64_t) words; /* that are not in the file yet */
	size_t next; /* word to read, without a file */
	bool unknown; /* a place is not known: nothing can be selected */
};

void places_release(struct place_log *log);

/* Note a feature and the hashes of the ids in it. */
enum tcs_status places_add(struct place_log *log, const struct raw_place *place,
	const uint64_t *hashes, size_t count,
	struct tcs_fault *fault) TCS_CHECKED;

/* What is asked for: features that have an id, and features by number. */
struct place_query {
	const uint64_t *hashes; /* ascending */
	size_t hash_count;
	const uint64_t *numbers; /* ascending */
	size_t number_count;
};

/* Append to the two the places of these and of those. */
enum tcs_status places_select(struct place_log *log,
	const struct place_query *query, struct document_parts *with_id,
	struct document_parts *with_number,
	struct tcs_fault *fault) TCS_CHECKED;

#endif
