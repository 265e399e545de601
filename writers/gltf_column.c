#include "gltf_column.h"

#include <math.h>
#include <string.h>

enum tcs_status
column_add(struct column *column, uint32_t row, enum column_value kind,
	double number, const char *text, size_t length, struct tcs_fault *fault)
{
	if (!length)
		return TCS_OK;
	if (kind != VALUE_TEXT &&
		(!isfinite(number) || number <= COLUMN_NO_NUMBER))
		kind = VALUE_TEXT;
	if (kind == VALUE_INTEGER &&
		(number <= COLUMN_NO_INTEGER || number > INT32_MAX))
		kind = fabs(number) <= 9007199254740992.0 ? VALUE_NUMBER
							  : VALUE_TEXT;
	if (array_grow(&column->rows, 1) || array_grow(&column->ends, 1) ||
		array_grow(&column->heap, length) ||
		(!column->text_only && array_grow(&column->numbers, 1)))
		return fault_memory(fault);
	column->seen |= 1u << kind;
	column->rows.at[column->rows.count++] = row;
	if (!column->text_only)
		column->numbers.at[column->numbers.count++] = number;
	memcpy(column->heap.at + column->heap.count, text, length);
	column->heap.count += length;
	column->ends.at[column->ends.count++] = column->heap.count;
	return TCS_OK;
}

enum column_type
column_type(const struct column *column, uint32_t row_count)
{
	unsigned seen = column->seen;

	if (column->text_only || seen & 1u << VALUE_TEXT)
		return COLUMN_STRING;
	if (seen == 1u << VALUE_TRUTH)
		return column->rows.count == row_count ? COLUMN_BOOLEAN
						       : COLUMN_UINT8;
	if (seen & 1u << VALUE_TRUTH)
		return COLUMN_STRING;
	return seen == 1u << VALUE_INTEGER ? COLUMN_INT32 : COLUMN_FLOAT64;
}

/* One pass over all rows, those with a value and those without. */
struct row_walk {
	const struct column *column;
	size_t next; /* the next value */
};

/* Whether the row has a value; its place among the values in *value. */
static bool
walk_row(struct row_walk *walk, uint32_t row, size_t *value)
{
	if (walk->next >= walk->column->rows.count ||
		walk->column->rows.at[walk->next] != row)
		return false;
	*value = walk->next++;
	return true;
}

static enum tcs_status
write_offsets(const struct column *column, uint32_t row_count,
	struct spool *spool, bool wide, struct tcs_fault *fault)
{
	struct row_walk walk = {column, 0};
	enum tcs_status status = TCS_OK;
	uint64_t end = 0;
	size_t value;

	for (uint64_t row = 0; row <= row_count && !status; row++) {
		uint32_t narrow = (uint32_t)end;

		status = wide
			? spool_write(spool, &end, sizeof end, fault)
			: spool_write(spool, &narrow, sizeof narrow, fault);
		if (row < row_count && walk_row(&walk, (uint32_t)row, &value))
			end = column->ends.at[value];
	}
	return status;
}

static enum tcs_status
write_strings(const struct column *column, uint32_t row_count,
	struct spool *spool, struct column_place *place,
	struct tcs_fault *fault)
{
	enum tcs_status status =
		spool_write(spool, column->heap.at, column->heap.count, fault);

	if (!status)
		status = spool_align(spool, 8, fault);
	place->wide_offsets = column->heap.count > UINT32_MAX;
	place->offsets_at = spool->size;
	if (!status)
		status = write_offsets(
			column, row_count, spool, place->wide_offsets, fault);
	place->offsets_size = spool->size - place->offsets_at;
	return status;
}

static enum tcs_status
write_numbers(const struct column *column, uint32_t row_count,
	struct spool *spool, enum column_type type, struct tcs_fault *fault)
{
	struct row_walk walk = {column, 0};
	enum tcs_status status = TCS_OK;
	size_t value;

	for (uint32_t row = 0; row < row_count && !status; row++) {
		bool there = walk_row(&walk, row, &value);
		double number = there ? column->numbers.at[value] : 0;
		double real = there ? number : COLUMN_NO_NUMBER;
		int32_t whole = there ? (int32_t)number : COLUMN_NO_INTEGER;
		uint8_t truth = there ? number != 0 : COLUMN_NO_TRUTH;

		if (type == COLUMN_FLOAT64)
			status = spool_write(spool, &real, sizeof real, fault);
		else if (type == COLUMN_INT32)
			status =
				spool_write(spool, &whole, sizeof whole, fault);
		else
			status =
				spool_write(spool, &truth, sizeof truth, fault);
	}
	return status;
}

/* Bit i of the buffer, from the lowest of each byte, is row i. */
static enum tcs_status
write_bits(const struct column *column, struct spool *spool,
	struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;
	uint8_t bits = 0;
	size_t count = column->numbers.count;

	for (size_t row = 0; row < count && !status; row++) {
		if (column->numbers.at[row] != 0)
			bits = (uint8_t)(bits | 1u << row % 8);
		if (row % 8 != 7 && row + 1 != count)
			continue;
		status = spool_write(spool, &bits, 1, fault);
		bits = 0;
	}
	return status;
}

enum tcs_status
column_write(const struct column *column, uint32_t row_count,
	struct spool *spool, struct column_place *place,
	struct tcs_fault *fault)
{
	enum tcs_status status = spool_align(spool, 8, fault);

	*place = (struct column_place){
		.type = column_type(column, row_count),
		.has_gaps = column->rows.count < row_count,
		.values_at = spool->size,
	};
	if (status)
		return status;
	switch (place->type) {
	case COLUMN_STRING:
		status = write_strings(column, row_count, spool, place, fault);
		place->values_size = column->heap.count;
		break;
	case COLUMN_BOOLEAN:
		status = write_bits(column, spool, fault);
		place->values_size = spool->size - place->values_at;
		break;
	default:
		status = write_numbers(
			column, row_count, spool, place->type, fault);
		place->values_size = spool->size - place->values_at;
		break;
	}
	return status ? status : spool_align(spool, 8, fault);
}

void
column_release(struct column *column)
{
	array_release(&column->rows);
	array_release(&column->numbers);
	array_release(&column->ends);
	array_release(&column->heap);
}
