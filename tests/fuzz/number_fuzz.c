/*
 * The bytes three times: as text to read as the C library does, as doubles to
 * print and read back, as a run of numbers that may be cut anywhere.
 */
#include "number.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static uint64_t
bits_of(double value)
{
	uint64_t bits;

	memcpy(&bits, &value, sizeof bits);
	return bits;
}

/* Where strtod would go beyond decimals: hexadecimal, inf, nan, blanks. */
static bool
is_decimal_to_strtod(const char *text)
{
	if (*text == '-' || *text == '+')
		text++;
	return (*text == '.' || (*text >= '0' && *text <= '9')) &&
		!(text[0] == '0' && (text[1] | 0x20) == 'x');
}

static void
check_reading(const char *text, size_t length)
{
	double value = 0, expected;
	const char *behind = number_parse(text, text + length, &value);
	char *end;

	if (!is_decimal_to_strtod(text))
		return;
	expected = strtod(text, &end);
	if (end == text ? behind != NULL
			: behind != end || bits_of(value) != bits_of(expected))
		abort();
}

static void
check_printing(const uint8_t *bytes, size_t length)
{
	for (; length >= sizeof(double); length--, bytes++) {
		char text[NUMBER_LENGTH];
		double value, back;
		size_t count;

		memcpy(&value, bytes, sizeof value);
		count = number_print(text, value);
		if (!count || count > NUMBER_LENGTH)
			abort();
		if (!isfinite(value))
			continue;
		if (number_parse(text, text + count, &back) != text + count ||
			bits_of(back) != bits_of(value))
			abort();
	}
}

struct run {
	struct number_scan scan;
	struct number_list list;
};

static void
run_feed(struct run *run, const char *text, size_t length)
{
	struct tcs_fault fault;

	if (number_scan_feed(&run->scan, text, length, &run->list, &fault))
		abort();
}

static void
run_finish(struct run *run)
{
	struct tcs_fault fault;

	if (number_scan_finish(&run->scan, &run->list, &fault))
		abort();
}

/* Piece by piece, each as long as a byte of the text says. */
static void
check_pieces(const char *text, size_t length)
{
	struct run whole = {.list = {0}}, cut = {.list = {0}};
	size_t bytes;

	run_feed(&whole, text, length);
	run_finish(&whole);
	for (size_t at = 0; at < length;) {
		size_t piece = (unsigned char)text[at] % 7;

		piece = piece < length - at ? piece : length - at;
		run_feed(&cut, text + at, piece);
		at += piece;
		if (!piece && at < length)
			run_feed(&cut, text + at++, 1);
	}
	run_finish(&cut);
	bytes = whole.list.count * sizeof *whole.list.at;
	if (whole.list.count != cut.list.count ||
		whole.scan.bad != cut.scan.bad ||
		whole.scan.bad_at != cut.scan.bad_at ||
		(bytes && memcmp(whole.list.at, cut.list.at, bytes)))
		abort();
	number_scan_release(&whole.scan);
	number_scan_release(&cut.scan);
	array_release(&whole.list);
	array_release(&cut.list);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t length);

int
LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t length)
{
	char *text = calloc(length + 4, 1);

	if (!text)
		abort();
	if (length)
		memcpy(text, bytes, length);
	if (strlen(text) == length)
		check_reading(text, length);
	check_printing(bytes, length);
	check_pieces(text, length);
	free(text);
	return 0;
}
