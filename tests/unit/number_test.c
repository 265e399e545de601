#include "number.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"

/* ---- oracles: the C library, in the C locale ------------------------------ */

static uint64_t
random_bits(uint64_t *state)
{
	uint64_t z = *state += 0x9e3779b97f4a7c15u; /* splitmix64 */

	z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
	z = (z ^ z >> 27) * 0x94d049bb133111ebu;
	return z ^ z >> 31;
}

static uint64_t
bits_of(double value)
{
	uint64_t bits;

	memcpy(&bits, &value, sizeof bits);
	return bits;
}

static double
double_of(uint64_t bits)
{
	double value;

	memcpy(&value, &bits, sizeof value);
	return value;
}

static bool
reads_as_strtod(const char *text)
{
	double value = NAN;
	const char *end = text + strlen(text);
	bool same = number_parse(text, end, &value) == end &&
		bits_of(value) == bits_of(strtod(text, NULL));

	if (!same)
		fprintf(stderr, "%.60s reads as %a\n", text, value);
	return same;
}

static size_t
significant(const char *text)
{
	size_t count = 0, zeros = 0;

	for (; *text && *text != 'e'; text++) {
		if (*text == '0')
			zeros++;
		else if (*text != '.' && *text != '-') {
			count += zeros * (count > 0) + 1;
			zeros = 0;
		}
	}
	return count;
}

/* Fewer digits never read back, and no decimal as long is nearer. */
static bool
prints_shortest(double value)
{
	char text[NUMBER_LENGTH + 1], rounded[64];
	size_t length = number_print(text, value), count;
	bool fine;

	text[length] = '\0';
	count = significant(text);
	snprintf(rounded, sizeof rounded, "%.*e", (int)count - 1, value);
	fine = bits_of(strtod(text, NULL)) == bits_of(value) &&
		(strtod(rounded, NULL) != value ||
			strtold(text, NULL) == strtold(rounded, NULL));
	if (count > 1) {
		snprintf(
			rounded, sizeof rounded, "%.*e", (int)count - 2, value);
		fine = fine && strtod(rounded, NULL) != value;
	}
	if (!fine)
		fprintf(stderr, "%a prints as %s\n", value, text);
	return fine;
}

/* ---- reading -------------------------------------------------------------- */

static void
ordinary_numbers_read_as_by_strtod(void)
{
	static const char *const texts[] = {"0", "-0", "1", "+1", "-1", "007",
		"0.1", ".5", "5.", "-.5e1", "1e22", "1e23", "1E-5", "1e+5",
		"5333770.123", "691051.4379999999", "13.376211999999999",
		"9007199254740993", "9007199254740992.5", "0.30000000000000004",
		"123456789012345678e3", "12345678901234567.89e-2",
		"6.12303176911189E-17", "179769313486231570000000",
		"18446744073709551615", "18446744073709551616",
		"9999999999999999999", "99999999999999999999",
		"0.00000000000000000000000000000001", "00000000000000000000001",
		"0.000000000000000000000000e5", "1e0000000000000000000000005",
		NULL};

	for (size_t i = 0; texts[i]; i++)
		CHECK(reads_as_strtod(texts[i]));
}

static void
the_ends_of_the_range_read_right(void)
{
	static const char *const texts[] = {"1e400", "-1e400", "1e-400",
		"-1e-400", "4.9e-324", "2.4703282292062327208e-324",
		"2.4703282292062327209e-324", "2.2250738585072011e-308",
		"2.2250738585072014e-308", "1.7976931348623157e308",
		"1.7976931348623158e308", "1.7976931348623159e308",
		"1e99999999999999999999999", "1e-99999999999999999999999",
		"0e99999999999999999999999", "123456789e-330", NULL};
	double value;
	const char text[] = "1e400";

	for (size_t i = 0; texts[i]; i++)
		CHECK(reads_as_strtod(texts[i]));
	CHECK(number_parse(text, text + 5, &value) == text + 5);
	CHECK(isinf(value) && value > 0);
}

static void
a_halfway_case_of_any_length_goes_to_even(void)
{
	char text[1200];
	uint64_t state = 7;

	for (int i = 0; i < 2000; i++) {
		uint64_t bits = random_bits(&state) % 0x7fe0000000000000u;
		double low = double_of(bits);
		double high = nextafter(low, HUGE_VAL);
		long double half = low + ((long double)high - low) / 2;
		int length = snprintf(text, 900, "%.800Le", half);
		char *e = strchr(text, 'e');
		char tail[16];

		CHECK(length < 900);
		CHECK(reads_as_strtod(text));
		snprintf(tail, sizeof tail, "%s", e);
		snprintf(e, 400, "%0300d%s", 0, tail);
		CHECK(reads_as_strtod(text));
		snprintf(e, 400, "%0300d%s", 1, tail);
		CHECK(reads_as_strtod(text));
	}
}

static void
eight_hundred_digits_with_the_point_anywhere_read_right(void)
{
	char text[900];
	uint64_t state = 11;

	for (size_t point = 0; point <= 800; point += 7) {
		for (size_t i = 0; i < 800; i++)
			text[i] = (char)('0' + random_bits(&state) % 10);
		memmove(text + point + 1, text + point, 800 - point);
		text[point] = '.';
		snprintf(text + 801, 90, "e%d", 200 - (int)point);
		CHECK(reads_as_strtod(text));
	}
}

static void
random_decimals_read_as_by_strtod(void)
{
	uint64_t state = 1;
	char text[64];

	for (int i = 0; i < 200000; i++) {
		uint64_t digits = random_bits(&state);

		digits >>= random_bits(&state) % 64;
		snprintf(text, sizeof text, "%llue%d",
			(unsigned long long)digits,
			(int)(random_bits(&state) % 60) - 40);
		CHECK(reads_as_strtod(text));
		snprintf(text, sizeof text, "%u.%012llu",
			(unsigned)(random_bits(&state) % 6000000),
			(unsigned long long)(digits % 1000000000000));
		CHECK(reads_as_strtod(text));
	}
}

static size_t
parsed(const char *text)
{
	double value;
	const char *behind = number_parse(text, text + strlen(text), &value);

	return behind ? (size_t)(behind - text) : 99;
}

static void
the_longest_prefix_is_the_number(void)
{
	CHECK(parsed("12 13") == 2);
	CHECK(parsed("1e") == 1);
	CHECK(parsed("1e+") == 1);
	CHECK(parsed("1e+5x") == 4);
	CHECK(parsed("1.2.3") == 3);
	CHECK(parsed("1-2") == 1);
	CHECK(parsed("0x10") == 1);
	CHECK(parsed("1,5") == 1);
}

static void
what_is_no_number_is_refused(void)
{
	static const char *const texts[] = {"", " 1", "-", "+", ".", "-.", "e5",
		".e5", "inf", "nan", "-inf", "--1", "+-1", "x", NULL};

	for (size_t i = 0; texts[i]; i++)
		CHECK(parsed(texts[i]) == 99);
}

static void
nothing_is_read_behind_the_end(void)
{
	const char text[] = "-12.5e3";
	double value;

	CHECK(number_parse(text, text, &value) == NULL);
	CHECK(number_parse(text, text + 1, &value) == NULL);
	CHECK(number_parse(text, text + 3, &value) == text + 3);
	CHECK(value == -12);
	CHECK(number_parse(text, text + 6, &value) == text + 5);
	CHECK(value == -12.5);
}

static bool
integer(const char *text, int64_t expected)
{
	int64_t value;
	const char *end = text + strlen(text);

	return number_parse_integer(text, end, &value) == end &&
		value == expected;
}

static void
integers_end_at_their_range(void)
{
	int64_t value = 5;
	const char over[] = "9223372036854775808", none[] = "-";

	CHECK(integer("0", 0));
	CHECK(integer("-0", 0));
	CHECK(integer("+17", 17));
	CHECK(integer("-42", -42));
	CHECK(integer("9223372036854775807", INT64_MAX));
	CHECK(integer("-9223372036854775808", INT64_MIN));
	CHECK(!number_parse_integer(over, over + 19, &value));
	CHECK(!number_parse_integer(none, none + 1, &value));
	CHECK(value == 5);
	CHECK(number_parse_integer("12.5", &"12.5"[4], &value) != NULL);
}

/* ---- printing ------------------------------------------------------------- */

static bool
prints(double value, const char *expected)
{
	char text[NUMBER_LENGTH];
	size_t length = number_print(text, value);

	if (length == strlen(expected) && !memcmp(text, expected, length))
		return true;
	fprintf(stderr, "%a prints as %.*s\n", value, (int)length, text);
	return false;
}

static void
the_notation_is_plain_between_its_limits(void)
{
	CHECK(prints(0, "0"));
	CHECK(prints(-0.0, "-0"));
	CHECK(prints(1, "1"));
	CHECK(prints(5333770, "5333770"));
	CHECK(prints(-5333770.125, "-5333770.125"));
	CHECK(prints(0.00012, "0.00012"));
	CHECK(prints(1e-5, "0.00001"));
	CHECK(prints(-1.2345678901234568e-5, "-0.000012345678901234568"));
	CHECK(prints(9.999999999999999e-6, "9.999999999999999e-6"));
	CHECK(prints(1e-7, "1e-7"));
	CHECK(prints(1e16, "10000000000000000"));
	CHECK(prints(72057594037927936, "72057594037927940"));
	CHECK(prints(99999999999999984, "99999999999999980"));
	CHECK(prints(1e17, "1e+17"));
	CHECK(prints(-2.5e300, "-2.5e+300"));
	CHECK(prints(5e-324, "5e-324"));
	CHECK(prints(1.7976931348623157e308, "1.7976931348623157e+308"));
	CHECK(prints(NAN, "nan"));
	CHECK(prints(HUGE_VAL, "inf"));
	CHECK(prints(-HUGE_VAL, "-inf"));
}

static void
coordinates_print_as_they_were_written(void)
{
	CHECK(prints(0.1, "0.1"));
	CHECK(prints(0.3, "0.3"));
	CHECK(prints(0.1 + 0.2, "0.30000000000000004"));
	CHECK(prints(691051.438, "691051.438"));
	CHECK(prints(13.376211999999999, "13.376211999999999"));
	CHECK(prints(52.520008, "52.520008"));
	CHECK(prints(9007199254740992, "9007199254740992"));
}

/* Two to the -44 lies nearer to its lower neighbour. */
static void
powers_of_two_print_shortest(void)
{
	CHECK(prints(0x1p-44, "5.684341886080802e-14"));
	for (int e = -1074; e < 1024; e++)
		CHECK(prints_shortest(ldexp(1, e)));
}

static void
random_bits_print_shortest(void)
{
	uint64_t state = 3;

	for (int i = 0; i < 30000; i++) {
		double value = double_of(random_bits(&state));

		if (isfinite(value))
			CHECK(prints_shortest(value));
	}
}

static void
random_coordinates_print_shortest(void)
{
	uint64_t state = 5;

	for (int i = 0; i < 200000; i++) {
		uint64_t bits = random_bits(&state);
		double value = (double)(bits >> 11);

		CHECK(prints_shortest(ldexp(value, -(int)(bits % 66))));
	}
}

static void
random_decimals_print_as_written(void)
{
	uint64_t state = 9;
	char text[64];

	for (int i = 0; i < 200000; i++) {
		uint64_t bits = random_bits(&state);
		uint64_t digits = bits % 1000000000000000 | 1;

		int point = (int)(bits >> 60) % 10;
		unsigned long long unit = 1;

		digits += digits % 5 == 0 ? 2 : 0;
		for (int k = 0; k < point; k++)
			unit *= 10;
		snprintf(text, sizeof text, point ? "%llu.%0*llu" : "%llu",
			digits / unit, point, digits % unit);
		CHECK(prints(strtod(text, NULL), text));
	}
}

static const struct check_test tests[] = {
	CHECK_TEST(ordinary_numbers_read_as_by_strtod),
	CHECK_TEST(the_ends_of_the_range_read_right),
	CHECK_TEST(a_halfway_case_of_any_length_goes_to_even),
	CHECK_TEST(eight_hundred_digits_with_the_point_anywhere_read_right),
	CHECK_TEST(random_decimals_read_as_by_strtod),
	CHECK_TEST(the_longest_prefix_is_the_number),
	CHECK_TEST(what_is_no_number_is_refused),
	CHECK_TEST(nothing_is_read_behind_the_end),
	CHECK_TEST(integers_end_at_their_range),
	CHECK_TEST(the_notation_is_plain_between_its_limits),
	CHECK_TEST(coordinates_print_as_they_were_written),
	CHECK_TEST(powers_of_two_print_shortest),
	CHECK_TEST(random_bits_print_shortest),
	CHECK_TEST(random_coordinates_print_shortest),
	CHECK_TEST(random_decimals_print_as_written),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
