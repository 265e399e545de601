#include "check.h"
#include "writers/gltf_column.h"

#include <math.h>
#include <string.h>

static struct tcs_fault fault;

static void
add(struct column *column, uint32_t row, enum column_value kind, double number,
	const char *text)
{
	CHECK(!column_add(
		column, row, kind, number, text, strlen(text), &fault));
}

/* Write the column; its place and the spool's bytes. */
static size_t
written(const struct column *column, uint32_t rows, struct column_place *place,
	unsigned char *bytes, size_t room)
{
	struct spool spool = {.file = NULL};
	FILE *to = tmpfile();
	size_t size;

	spool_open(&spool, NULL);
	CHECK(!spool_write(&spool, "xyz", 3, &fault));
	CHECK(!column_write(column, rows, &spool, place, &fault));
	CHECK(!spool_pour(&spool, to, "test", &fault));
	rewind(to);
	size = fread(bytes, 1, room, to);
	CHECK(size == spool.size);
	fclose(to);
	spool_close(&spool);
	return size;
}

static void
strings_have_one_offset_more_than_rows(void)
{
	struct column column = {.text_only = true};
	struct column_place place;
	unsigned char bytes[256];
	uint32_t offsets[5];

	add(&column, 0, VALUE_TEXT, 0, "ab");
	add(&column, 2, VALUE_TEXT, 0, "c\xc3\xa4");
	written(&column, 4, &place, bytes, sizeof bytes);
	CHECK(place.type == COLUMN_STRING);
	CHECK(place.has_gaps);
	CHECK(place.values_at == 8 && place.values_size == 5);
	CHECK(!memcmp(bytes + 8, "abc\xc3\xa4", 5));
	CHECK(place.offsets_at == 16 && place.offsets_size == sizeof offsets);
	CHECK(!place.wide_offsets);
	memcpy(offsets, bytes + 16, sizeof offsets);
	CHECK(offsets[0] == 0 && offsets[1] == 2 && offsets[2] == 2);
	CHECK(offsets[3] == 5 && offsets[4] == 5);
	column_release(&column);
}

static void
an_empty_text_is_no_value(void)
{
	struct column column = {.text_only = true};

	add(&column, 0, VALUE_TEXT, 0, "");
	CHECK(column.rows.count == 0);
	column_release(&column);
}

static void
whole_numbers_make_int32_with_gaps_marked(void)
{
	struct column column = {.seen = 0};
	struct column_place place;
	unsigned char bytes[256];
	int32_t values[3];

	add(&column, 1, VALUE_INTEGER, -7, "-7");
	add(&column, 2, VALUE_INTEGER, 2147483647, "2147483647");
	written(&column, 3, &place, bytes, sizeof bytes);
	CHECK(place.type == COLUMN_INT32 && place.has_gaps);
	CHECK(place.values_size == sizeof values);
	memcpy(values, bytes + place.values_at, sizeof values);
	CHECK(values[0] == COLUMN_NO_INTEGER);
	CHECK(values[1] == -7 && values[2] == 2147483647);
	column_release(&column);
}

static void
an_integer_that_is_the_gap_mark_widens_the_column(void)
{
	struct column column = {.seen = 0};

	add(&column, 0, VALUE_INTEGER, -2147483648.0, "-2147483648");
	CHECK(column_type(&column, 1) == COLUMN_FLOAT64);
	add(&column, 1, VALUE_INTEGER, 9007199254740994.0, "9007199254740993");
	CHECK(column_type(&column, 2) == COLUMN_STRING);
	column_release(&column);
}

static void
mixed_numbers_make_float64(void)
{
	struct column column = {.seen = 0};
	struct column_place place;
	unsigned char bytes[256];
	double values[3];

	add(&column, 0, VALUE_INTEGER, 3, "3");
	add(&column, 2, VALUE_NUMBER, 2.5, "2.50");
	written(&column, 3, &place, bytes, sizeof bytes);
	CHECK(place.type == COLUMN_FLOAT64);
	memcpy(values, bytes + place.values_at, sizeof values);
	CHECK(values[0] == 3 && values[2] == 2.5);
	CHECK(values[1] == COLUMN_NO_NUMBER);
	column_release(&column);
}

static void
a_number_without_meaning_makes_the_column_text(void)
{
	struct column column = {.seen = 0};
	struct column_place place;
	unsigned char bytes[256];

	add(&column, 0, VALUE_NUMBER, 2.5, "2.50");
	add(&column, 1, VALUE_NUMBER, (double)NAN, "unknown");
	written(&column, 2, &place, bytes, sizeof bytes);
	CHECK(place.type == COLUMN_STRING && !place.has_gaps);
	CHECK(!memcmp(bytes + place.values_at, "2.50unknown", 11));
	column_release(&column);
}

static void
truth_in_every_row_is_packed_into_bits(void)
{
	struct column column = {.seen = 0};
	struct column_place place;
	unsigned char bytes[64];

	for (uint32_t i = 0; i < 10; i++)
		add(&column, i, VALUE_TRUTH, i % 3 == 0, "x");
	written(&column, 10, &place, bytes, sizeof bytes);
	CHECK(place.type == COLUMN_BOOLEAN && place.values_size == 2);
	CHECK(bytes[place.values_at] == 0x49);
	CHECK(bytes[place.values_at + 1] == 0x02);
	column_release(&column);
}

static void
truth_with_gaps_is_a_byte_each(void)
{
	struct column column = {.seen = 0};
	struct column_place place;
	unsigned char bytes[64];

	add(&column, 0, VALUE_TRUTH, 1, "true");
	add(&column, 2, VALUE_TRUTH, 0, "0");
	written(&column, 3, &place, bytes, sizeof bytes);
	CHECK(place.type == COLUMN_UINT8 && place.values_size == 3);
	CHECK(bytes[place.values_at] == 1);
	CHECK(bytes[place.values_at + 1] == COLUMN_NO_TRUTH);
	CHECK(bytes[place.values_at + 2] == 0);
	column_release(&column);
}

int
main(void)
{
	static const struct check_test tests[] = {
		CHECK_TEST(strings_have_one_offset_more_than_rows),
		CHECK_TEST(an_empty_text_is_no_value),
		CHECK_TEST(whole_numbers_make_int32_with_gaps_marked),
		CHECK_TEST(an_integer_that_is_the_gap_mark_widens_the_column),
		CHECK_TEST(mixed_numbers_make_float64),
		CHECK_TEST(a_number_without_meaning_makes_the_column_text),
		CHECK_TEST(truth_in_every_row_is_packed_into_bits),
		CHECK_TEST(truth_with_gaps_is_a_byte_each),
		{0},
	};

	return check_run(tests);
}
