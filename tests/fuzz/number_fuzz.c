/*
 * The bytes twice: as text to read as the C library does, as doubles to print
 * and read back.
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
	free(text);
	return 0;
}
