/*
 * A record's payload: sections as tcs(5) lays them out, decoded and encoded
 * by the table of its kind. Internal to the stream.
 */
#ifndef TESSERA_TCS_CODEC_H
#define TESSERA_TCS_CODEC_H

#include <stddef.h>
#include <stdint.h>

#include "tcs.h"
#include "tcs_layout.h"

/* One entry of a section directory, and where its elements begin. */
struct section {
	uint32_t tag;
	uint32_t size; /* bytes of one element */
	uint64_t count;
	size_t at; /* offset in the payload */
};

/* A walk over the sections of one payload. */
struct section_walk {
	const unsigned char *bytes;
	size_t length;
	uint64_t where; /* the record's place in the stream */
	size_t entry; /* offset of the next directory entry */
	size_t entry_end;
	size_t at; /* where the next section's elements begin */
};

enum tcs_status sections_begin(struct section_walk *walk,
	const struct tcs_record *record, struct tcs_fault *fault) TCS_CHECKED;

/*
 * The next section, wholly inside the payload; *done when there is none and
 * the payload ends where it should.
 */
enum tcs_status sections_next(struct section_walk *walk, struct section *out,
	bool *done, struct tcs_fault *fault) TCS_CHECKED;

/*
 * Lend the record's sections to the arrays of `out`, a struct of the layout's
 * kind, releasing what the arrays owned. Unknown sections are passed over.
 * Text and the offsets into it are checked, nothing else.
 */
enum tcs_status record_decode(void *out, const struct tcs_layout *layout,
	const struct tcs_record *record, struct tcs_fault *fault) TCS_CHECKED;

/* The text of a struct of the layout's kind, and all offsets into it. */
enum tcs_status layout_check_text(const struct tcs_layout *layout,
	const void *kind, uint64_t where, struct tcs_fault *fault) TCS_CHECKED;

/*
 * Encode the arrays into record->bytes, in canonical form: sections in the
 * layout's order, empty ones left out, text last with each string in use once,
 * in the order of first use. The arrays may be lent by the same record.
 */
enum tcs_status record_encode(const void *kind, const struct tcs_layout *layout,
	struct tcs_record *record, struct tcs_fault *fault) TCS_CHECKED;

/* Add what the record holds to the tally, from its directory alone. */
enum tcs_status tally_add(struct tcs_tally *tally,
	const struct tcs_record *record, struct tcs_fault *fault) TCS_CHECKED;

/* The bytes that a section of `length` bytes takes with its padding. */
static inline uint64_t
section_padded(uint64_t length)
{
	return (length + 7) & ~(uint64_t)7;
}

#define DIRECTORY_HEAD 8 /* count, reserved */
#define DIRECTORY_ENTRY 16 /* tag, size, count */

#endif
