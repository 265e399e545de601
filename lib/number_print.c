#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "number.h"

__extension__ typedef unsigned __int128 wide;

/* The decimal digits · 10^exponent. */
struct decimal {
	uint64_t digits;
	int exponent;
};

static const uint64_t ten_to[] = {1, 10, 100, 1000, 10000, 100000, 1000000,
	10000000, 100000000, 1000000000, 10000000000, 100000000000,
	1000000000000, 10000000000000, 100000000000000, 1000000000000000,
	10000000000000000, 100000000000000000, 1000000000000000000,
	10000000000000000000u};

/* ---- the decimal ------------------------------------------------------- */

/*
 * A value of few decimals and less than 2^50 units of the last one. When i is
 * the nearest integer to value · 10^k, in doubles, and i / 10^k, also in
 * doubles, gives the value back, then the decimal i · 10^-k reads back to it,
 * for that division is how it is read. The least such k is the shortest: had
 * fewer decimals sufficed, d · 10^-j say, then value · 10^j in doubles would be
 * within d · 2^-52 ≤ 1/4 of d and d would have been found. And i is the only
 * such decimal, since its neighbours lie more than 2^-50 of the value away and
 * doubles that read alike at most 2^-52.
 */
enum { FEW_DECIMALS = 4 };

static bool
decimal_few(double value, struct decimal *out)
{
	static const double power[] = {1, 1e1, 1e2, 1e3, 1e4};

	if (value >= 1e11)
		return false;
	for (int k = 0; k <= FEW_DECIMALS; k++) {
		int64_t units = (int64_t)(value * power[k] + 0.5);

		if ((double)units / power[k] != value)
			continue;
		out->digits = (uint64_t)units;
		out->exponent = -k;
		return true;
	}
	return false;
}

/*
 * The decimals that read back to a value lie between the halfway points to its
 * neighbours. Here all three are integers over 2^shift, in units of
 * 10^exponent, and nothing is rounded.
 */
struct interval {
	wide value, lower, upper;
	int shift;
	int exponent;
	bool closed; /* the ends read back too: ties go to even */
};

enum { MOST_SCALE = 21 }; /* 4 · 2^53 · 10^21 < 2^125 */

/* For 1e-5 ≤ value < 1e17: units that leave 17 or 18 digits. */
static void
interval_set(struct interval *interval, uint64_t mantissa, int exponent)
{
	int log10 = ((exponent + 52) * 1233) >> 12;
	int scale = 16 - log10 < MOST_SCALE ? 16 - log10 : MOST_SCALE;
	wide power = ten_to[scale < 19 ? scale : 19];
	bool lopsided = mantissa == (uint64_t)1 << 52;

	for (int i = 19; i < scale; i++)
		power *= 10;
	interval->closed = !(mantissa & 1);
	interval->exponent = -scale;
	interval->shift = exponent > 0 ? 2 : 2 - exponent;
	if (exponent > 0)
		power <<= exponent;
	interval->value = mantissa * power * 4;
	interval->upper = interval->value + power * 2;
	interval->lower = interval->value - power * (lopsided ? 1 : 2);
}

static uint64_t
interval_first(const struct interval *interval)
{
	uint64_t whole = (uint64_t)(interval->lower >> interval->shift);
	bool exact = (wide)whole << interval->shift == interval->lower;

	return whole + !(exact && interval->closed);
}

static uint64_t
interval_last(const struct interval *interval)
{
	uint64_t whole = (uint64_t)(interval->upper >> interval->shift);
	bool exact = (wide)whole << interval->shift == interval->upper;

	return whole - (exact && !interval->closed);
}

/* The multiple of `unit` from first to last that is nearest to the value. */
static uint64_t
interval_nearest(const struct interval *interval, uint64_t unit, uint64_t first,
	uint64_t last)
{
	uint64_t whole = (uint64_t)(interval->value >> interval->shift);
	uint64_t below = whole / unit * unit;
	wide rest = interval->value - ((wide)below << interval->shift);
	wide half = (wide)unit << (interval->shift - 1);
	bool up = rest > half || (rest == half && below / unit % 2);

	if (below < first || (up && below + unit <= last))
		return below / unit + 1;
	return below / unit;
}

static void
decimal_shortest(uint64_t mantissa, int exponent, struct decimal *out)
{
	struct interval interval;
	uint64_t first, last, a, b, unit = 1;
	int zeros = 0;

	interval_set(&interval, mantissa, exponent);
	first = a = interval_first(&interval);
	last = b = interval_last(&interval);
	for (;;) {
		a = (a + 9) / 10;
		b /= 10;
		if (a > b)
			break;
		unit *= 10;
		zeros++;
	}
	out->digits = interval_nearest(&interval, unit, first, last);
	out->exponent = interval.exponent + zeros;
}

/* ---- decimals of any exponent, through the C library -------------------- */

static bool
decimal_reads(const struct decimal *decimal, double value)
{
	char text[NUMBER_LENGTH];
	int length = snprintf(text, sizeof text, "%llue%d",
		(unsigned long long)decimal->digits, decimal->exponent);
	double back;

	return number_parse(text, text + length, &back) && back == value;
}

/* The nearest decimal of `count` digits. */
static void
decimal_rounded(double value, int count, struct decimal *out)
{
	char text[NUMBER_LENGTH];
	const char *at = text;

	snprintf(text, sizeof text, "%.*e", count - 1, value);
	out->digits = 0;
	for (; *at != 'e'; at++) {
		if (*at >= '0' && *at <= '9')
			out->digits = out->digits * 10 + (uint64_t)(*at - '0');
	}
	out->exponent = (int)strtol(at + 1, NULL, 10) - (count - 1);
}

/*
 * The nearest decimal of so many digits may miss a power of two, whose lower
 * neighbour is nearer than its upper one, where the next decimal up does not.
 */
static void
decimal_search(double value, struct decimal *out)
{
	for (int count = 1; count < 17; count++) {
		decimal_rounded(value, count, out);
		if (decimal_reads(out, value))
			return;
		out->digits++;
		if (decimal_reads(out, value))
			return;
	}
	decimal_rounded(value, 17, out);
}

static void
decimal_find(double value, struct decimal *out)
{
	uint64_t bits;

	if (value < 1e-5 || value >= 1e17) {
		decimal_search(value, out);
		return;
	}
	if (decimal_few(value, out))
		return;
	memcpy(&bits, &value, sizeof bits);
	decimal_shortest((bits & (((uint64_t)1 << 52) - 1)) | (uint64_t)1 << 52,
		(int)(bits >> 52) - 1075, out);
}

/* ---- its text ------------------------------------------------------------ */

static int
digits_count(uint64_t digits)
{
	int count = 1;

	while (count < 19 && digits >= ten_to[count])
		count++;
	return count;
}

static void
digits_write(char *out, uint64_t digits, int count)
{
	while (count--) {
		out[count] = (char)('0' + digits % 10);
		digits /= 10;
	}
}

static char *
write_plain(char *out, const char *digits, int count, int point)
{
	if (point <= 0) {
		memcpy(out, "0.000000", 8);
		out += 2 - point;
		memcpy(out, digits, (size_t)count);
		return out + count;
	}
	if (point >= count) {
		memcpy(out, digits, (size_t)count);
		memset(out + count, '0', (size_t)(point - count));
		return out + point;
	}
	memcpy(out, digits, (size_t)point);
	out[point] = '.';
	memcpy(out + point + 1, digits + point, (size_t)(count - point));
	return out + count + 1;
}

static char *
write_exponent(char *out, const char *digits, int count, int point)
{
	*out++ = digits[0];
	if (count > 1) {
		*out++ = '.';
		memcpy(out, digits + 1, (size_t)(count - 1));
		out += count - 1;
	}
	return out + snprintf(out, 8, "e%+d", point - 1);
}

static size_t
print_special(char out[NUMBER_LENGTH], double value)
{
	const char *text = isnan(value) ? "nan" : value < 0 ? "-inf" : "inf";
	size_t length = strlen(text);

	memcpy(out, text, length);
	return length;
}

size_t
number_print(char out[NUMBER_LENGTH], double value)
{
	struct decimal decimal;
	char digits[NUMBER_LENGTH], *at = out;
	int count, point;

	if (!isfinite(value))
		return print_special(out, value);
	if (signbit(value)) {
		*at++ = '-';
		value = -value;
	}
	if (value == 0) {
		*at++ = '0';
		return (size_t)(at - out);
	}
	decimal_find(value, &decimal);
	while (decimal.digits % 10 == 0) {
		decimal.digits /= 10;
		decimal.exponent++;
	}
	count = digits_count(decimal.digits);
	digits_write(digits, decimal.digits, count);
	point = count + decimal.exponent;
	at = value >= 1e-5 && value < 1e17
		? write_plain(at, digits, count, point)
		: write_exponent(at, digits, count, point);
	return (size_t)(at - out);
}
