/*
 * Which arrays a record has: one table per kind of record, from which the
 * bytes are encoded, decoded, and their text checked. Internal to the stream;
 * tcs(5) says the same in words.
 */
#ifndef TESSERA_TCS_LAYOUT_H
#define TESSERA_TCS_LAYOUT_H

#include <stddef.h>
#include <stdint.h>

#include "tcs.h"

#define TCS_MAX_TEXTS 5

/* One array: a section in the bytes, a TCS_ARRAY in the struct. */
struct tcs_column {
	uint32_t tag;
	uint32_t size; /* bytes of one element */
	size_t array; /* where in the struct the array is */
	size_t text_count;
	size_t texts[TCS_MAX_TEXTS]; /* where in an element its tcs_texts are */
};

/* The arrays of a kind of record in the order of its sections. */
struct tcs_layout {
	const struct tcs_column *columns;
	size_t count;
	const char *name; /* for messages */
};

#define TCS_TEXT_TAG TCS_TAG('T', 'E', 'X', 'T')
#define TCS_PAINT_TAG TCS_TAG('P', 'A', 'I', 'N')

extern const struct tcs_layout layout_object;
extern const struct tcs_layout layout_head;
extern const struct tcs_layout layout_palette;
extern const struct tcs_layout layout_end;

/* The end record as a struct: exactly one tally. */
struct tcs_end {
	TCS_ARRAY(struct tcs_tally) tallies;
};

/* The untyped view of a column's array in a struct of its kind. */
struct tcs_array layout_array(
	const struct tcs_column *column, const void *kind);

/* The column of a section; NULL for an unknown one. */
const struct tcs_column *layout_column(
	const struct tcs_layout *layout, uint32_t tag);

/* Read a tcs_text of an element. */
tcs_text layout_text(const void *element, size_t at);

#endif
