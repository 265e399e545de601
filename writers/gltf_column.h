/*
 * One column of a property table: the values of one attribute, by row.
 *
 * A column holds what came, sparsely and in the source's spelling; when all
 * rows are known it takes the narrowest type that holds every value, and
 * becomes the bytes that EXT_structural_metadata asks for.
 *
 * source: EXT_structural_metadata, "Binary Table Format"; 3D Metadata
 * Specification 1.0, "Binary Table Format".
 */
#ifndef TESSERA_GLTF_COLUMN_H
#define TESSERA_GLTF_COLUMN_H

#include <stdbool.h>
#include <stdint.h>

#include "array.h"
#include "fault.h"
#include "gltf_spool.h"

enum column_type {
	COLUMN_STRING, /* anything else; "" is no value */
	COLUMN_FLOAT64, /* numbers; COLUMN_NO_NUMBER is no value */
	COLUMN_INT32, /* whole numbers; COLUMN_NO_INTEGER is no value */
	COLUMN_UINT8, /* truth values with gaps: 0, 1; 255 is no value */
	COLUMN_BOOLEAN, /* truth values in every row */
};

#define COLUMN_NO_NUMBER (-1.7976931348623157e308)
#define COLUMN_NO_INTEGER INT32_MIN
#define COLUMN_NO_TRUTH 255

/* What a value is besides its spelling. */
enum column_value {
	VALUE_TEXT,
	VALUE_NUMBER,
	VALUE_INTEGER,
	VALUE_TRUTH,
};

/* All zero is an empty column. */
struct column {
	TCS_ARRAY(uint32_t) rows; /* ascending */
	TCS_ARRAY(double) numbers; /* as many, unless `text_only` */
	TCS_ARRAY(uint64_t) ends; /* of the spellings in the heap */
	TCS_ARRAY(char) heap;
	bool text_only;
	unsigned seen; /* bit 1 << enum column_value */
};

/* Where the bytes of a column stand in the spool. */
struct column_place {
	enum column_type type;
	bool has_gaps; /* some row has no value: noData applies */
	uint64_t values_at, values_size;
	uint64_t offsets_at, offsets_size; /* strings: rows + 1 offsets */
	bool wide_offsets; /* UINT64 instead of UINT32 */
};

/*
 * Append the value of a row after the last one's. `text` is its spelling. An
 * empty text is no value. Fails with TCS_NO_MEMORY.
 */
enum tcs_status column_add(struct column *column, uint32_t row,
	enum column_value kind, double number, const char *text, size_t length,
	struct tcs_fault *fault) TCS_CHECKED;

enum column_type column_type(const struct column *column, uint32_t row_count);

/*
 * Write all rows, each buffer aligned to 8 bytes in the spool. Fails with
 * TCS_SYSTEM.
 */
enum tcs_status column_write(const struct column *column, uint32_t row_count,
	struct spool *spool, struct column_place *place,
	struct tcs_fault *fault) TCS_CHECKED;

void column_release(struct column *column);

#endif
