#include <math.h>
#include <string.h>

#include "number.h"
#include "number_powers.h"

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
 * A value of at most four decimals, below 1e11. With u the nearest integer to
 * value · 10^4, in doubles, u / 10^4 is how the decimal u · 10^-4 is read, for
 * both are doubles and the division is rounded once. If it gives the value,
 * that decimal, without the zeros at its end, is the shortest: a shorter one
 * has at most four decimals too, and the multiples of 10^-4 are more than
 * 2^-50 of the value apart, doubles that read alike at most 2^-52. And if any
 * such decimal reads as the value, value · 10^4 is within u · 2^-52 ≤ 1/4 of
 * it, so it is found.
 */
static bool
decimal_few(double value, struct decimal *out)
{
	uint64_t units;

	if (value >= 1e11)
		return false;
	units = (uint64_t)(int64_t)(value * 1e4 + 0.5);
	*out = (struct decimal){units, -4};
	return (double)(int64_t)units / 1e4 == value;
}

/*
 * The integer part of power · value / 2^128, with the lowest bit set where a
 * fraction is left. The power being rounded up, what is no more than one unit
 * of the last place is none.
 */
static uint64_t
scaled(struct number_power power, uint64_t value)
{
	wide low = (wide)power.low * value;
	wide all = (wide)power.high * value + (low >> 64);

	return (uint64_t)(all >> 64) | ((uint64_t)all > 1);
}

/*
 * The shortest decimal of mantissa · 2^exponent, and the nearest of them.
 *
 * 10^k is the largest power of ten that fits between the halfway points to the
 * neighbours, so that one or more of its multiples lie there, and at most one
 * multiple of 10^(k + 1), which is shorter. Quarters of 10^k tell value and
 * halfway points apart.
 *
 * source: R. Giulietti, The Schubfach way to render doubles, 2020.
 */
static void
decimal_shortest(uint64_t mantissa, int exponent, struct decimal *out)
{
	bool lopsided = mantissa == (uint64_t)1 << 52 && exponent > -1074;
	uint64_t odd =
		mantissa & 1; /* then the halfway points read elsewhere */
	int k = (exponent * 1262611 - (lopsided ? 524031 : 0)) >> 22;
	int shift = exponent + number_power_exponent(-k) + 1;
	struct number_power power = number_powers[-k - NUMBER_POWER_FIRST];
	uint64_t first = (mantissa * 4 - 2 + lopsided) << shift;
	uint64_t value = scaled(power, mantissa * 4 << shift);
	uint64_t last = scaled(power, (mantissa * 4 + 2) << shift) - odd;
	uint64_t below = value / 4, tens = value / 40;
	bool fits, next_fits;

	first = scaled(power, first) + odd;
	fits = first <= tens * 40;
	next_fits = tens * 40 + 40 <= last;
	if (value >= 40 && fits != next_fits) {
		*out = (struct decimal){tens + next_fits, k + 1};
		return;
	}
	fits = first <= below * 4;
	next_fits = below * 4 + 4 <= last;
	if (fits == next_fits)
		next_fits = value % 4 > 2 || (value % 4 == 2 && below % 2);
	*out = (struct decimal){below + next_fits, k};
}

enum { MANTISSA_BITS = 52, EXPONENT_BIAS = 1075 };

static void
decimal_find(double value, struct decimal *out)
{
	uint64_t bits, mantissa;
	int exponent;

	memcpy(&bits, &value, sizeof bits);
	mantissa = bits & (((uint64_t)1 << MANTISSA_BITS) - 1);
	exponent = (int)(bits >> MANTISSA_BITS);
	if (exponent)
		mantissa |= (uint64_t)1 << MANTISSA_BITS;
	else
		exponent = 1;
	if (value < 1e-4 || !decimal_few(value, out))
		decimal_shortest(mantissa, exponent - EXPONENT_BIAS, out);
	while (out->digits % 10 == 0) {
		out->digits /= 10;
		out->exponent++;
	}
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
	static const char pairs[] = "00010203040506070809"
				    "10111213141516171819"
				    "20212223242526272829"
				    "30313233343536373839"
				    "40414243444546474849"
				    "50515253545556575859"
				    "60616263646566676869"
				    "70717273747576777879"
				    "80818283848586878889"
				    "90919293949596979899";

	for (; count >= 2; digits /= 100) {
		count -= 2;
		memcpy(out + count, pairs + 2 * (digits % 100), 2);
	}
	if (count)
		*out = (char)('0' + digits);
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
	*out++ = 'e';
	*out++ = point > 0 ? '+' : '-';
	point = point > 0 ? point - 1 : 1 - point;
	count = digits_count((uint64_t)point);
	digits_write(out, (uint64_t)point, count);
	return out + count;
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
	count = digits_count(decimal.digits);
	digits_write(digits, decimal.digits, count);
	point = count + decimal.exponent;
	at = value >= 1e-5 && value < 1e17
		? write_plain(at, digits, count, point)
		: write_exponent(at, digits, count, point);
	return (size_t)(at - out);
}
