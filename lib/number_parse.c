#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "number.h"

#if FLT_EVAL_METHOD != 0
#error "double arithmetic must round to double"
#endif

__extension__ typedef unsigned __int128 wide;

/*
 * A number as written: digits · 10^exponent. `digits` holds every digit and is
 * exact while `significant` is at most 19.
 */
struct decimal {
	uint64_t digits;
	int64_t exponent;
	size_t significant; /* digits behind leading zeros */
	bool negative;
	const char *first; /* the text from the first digit or point on */
	const char *last; /* behind the last digit or point */
};

enum { EXACT_DIGITS = 19 }; /* that fit in 64 bits */

static const uint64_t ten_to[] = {1, 10, 100, 1000, 10000, 100000, 1000000,
	10000000, 100000000, 1000000000, 10000000000, 100000000000,
	1000000000000, 10000000000000, 100000000000000, 1000000000000000,
	10000000000000000, 100000000000000000, 1000000000000000000,
	10000000000000000000u};

/* The powers of ten that are doubles. */
static const double ten_to_exact[] = {1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7,
	1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19,
	1e20, 1e21, 1e22};

static bool
is_digit(char c)
{
	return (unsigned char)(c - '0') <= 9;
}

static const char *
digits_read(const char *at, const char *end, uint64_t *digits)
{
	uint64_t value = *digits;

	for (; at < end && is_digit(*at); at++)
		value = value * 10 + (uint64_t)(*at - '0');
	*digits = value;
	return at;
}

/* An exponent that no count of digits in memory can outweigh. */
#define EXPONENT_MAX ((int64_t)1 << 60)

/* Behind an exponent at `at`, or `at` where none is. */
static const char *
exponent_read(const char *at, const char *end, int64_t *exponent)
{
	const char *digit = at + 1;
	int64_t value = 0;
	bool negative = false;

	if (at == end || (*at | 0x20) != 'e')
		return at;
	if (digit < end && (*digit == '-' || *digit == '+'))
		negative = *digit++ == '-';
	if (digit == end || !is_digit(*digit))
		return at;
	for (; digit < end && is_digit(*digit); digit++) {
		if (value < EXPONENT_MAX / 16)
			value = value * 10 + (*digit - '0');
	}
	*exponent += negative ? -value : value;
	return digit;
}

static size_t
leading_zeros(const char *at, const char *end)
{
	size_t zeros = 0;

	for (; at < end && (*at == '0' || *at == '.'); at++)
		zeros += *at == '0';
	return zeros;
}

static const char *
decimal_read(const char *at, const char *end, struct decimal *decimal)
{
	const char *point;
	size_t count;

	decimal->digits = 0;
	decimal->exponent = 0;
	decimal->negative = at < end && *at == '-';
	if (at < end && (*at == '-' || *at == '+'))
		at++;
	decimal->first = at;
	at = digits_read(at, end, &decimal->digits);
	count = (size_t)(at - decimal->first);
	if (at < end && *at == '.') {
		point = ++at;
		at = digits_read(at, end, &decimal->digits);
		count += (size_t)(at - point);
		decimal->exponent = -(int64_t)(at - point);
	}
	if (!count)
		return NULL;
	decimal->last = at;
	if (count > EXACT_DIGITS)
		count -= leading_zeros(decimal->first, decimal->last);
	decimal->significant = count;
	return exponent_read(at, end, &decimal->exponent);
}

/* value · 2^shift, where no result is subnormal or infinite. */
static double
scaled(uint64_t value, int shift)
{
	uint64_t bits = (uint64_t)(shift + 1023) << 52;
	double power;

	memcpy(&power, &bits, sizeof power);
	return (double)value * power;
}

/*
 * The 64 leading bits of a product or quotient keep ten below the double's
 * own; a bit for the lost ones in the lowest place then rounds as they would.
 */
static double
product(uint64_t digits, uint64_t power)
{
	wide value = (wide)digits * power;
	int shift;

	if (!(value >> 64))
		return (double)(uint64_t)value;
	shift = 64 - __builtin_clzll((uint64_t)(value >> 64));
	digits = (uint64_t)(value >> shift);
	if ((wide)digits << shift != value)
		digits |= 1;
	return scaled(digits, shift);
}

static double
quotient(uint64_t digits, uint64_t power)
{
	int up = __builtin_clzll(digits);
	int power_up = __builtin_clzll(power);
	wide value = (wide)(digits << up) << 63;
	uint64_t result;

	power <<= power_up;
	result = (uint64_t)(value / power);
	if ((wide)result * power != value)
		result |= 1;
	return scaled(result, power_up - up - 63);
}

/*
 * digits · 10^exponent, rounded once. False where this needs more than 64-bit
 * powers. The first case is Clinger's (How to read floating point numbers
 * accurately, 1990): exact operands of one rounded operation.
 */
static bool
decimal_exact(uint64_t digits, int64_t exponent, double *out)
{
	if (digits <= (uint64_t)1 << 53 && exponent >= -22 && exponent <= 22) {
		*out = exponent < 0 ? (double)digits / ten_to_exact[-exponent]
				    : (double)digits * ten_to_exact[exponent];
		return true;
	}
	if (exponent < -EXACT_DIGITS || exponent > EXACT_DIGITS)
		return false;
	*out = exponent < 0 ? quotient(digits, ten_to[-exponent])
			    : product(digits, ten_to[exponent]);
	return true;
}

/*
 * Doubles and the points halfway between two of them have at most 767
 * significant digits: beyond that only whether any digit is not zero matters.
 */
enum { DIGITS_THAT_MATTER = 800 };

/* No point and no separator: strtod reads it alike in every locale. */
static double
decimal_any(const struct decimal *decimal)
{
	char text[DIGITS_THAT_MATTER + 32];
	const char *at = decimal->first;
	int64_t exponent = decimal->exponent;
	size_t count = 0;
	bool more = false;

	while (at < decimal->last && (*at == '0' || *at == '.'))
		at++;
	for (; at < decimal->last; at++) {
		if (*at == '.')
			continue;
		if (count < DIGITS_THAT_MATTER) {
			text[count++] = *at;
			continue;
		}
		more |= *at != '0';
		exponent++;
	}
	if (!count)
		return 0;
	if (more) {
		text[count++] = '1';
		exponent--;
	}
	if (exponent + (int64_t)count > 400)
		return HUGE_VAL;
	if (exponent + (int64_t)count < -400)
		return 0;
	snprintf(text + count, 32, "e%d", (int)exponent);
	return strtod(text, NULL);
}

/* The first 19 digits decide unless the next double is within reach. */
static bool
decimal_cut(const struct decimal *decimal, double *out)
{
	const char *at = decimal->first;
	uint64_t digits = 0;
	size_t count = 0;
	int64_t exponent;
	double above;

	for (; count < EXACT_DIGITS; at++) {
		if (*at == '.' || (*at == '0' && !count))
			continue;
		digits = digits * 10 + (uint64_t)(*at - '0');
		count++;
	}
	exponent = decimal->exponent +
		(int64_t)(decimal->significant - EXACT_DIGITS);
	return decimal_exact(digits, exponent, out) &&
		decimal_exact(digits + 1, exponent, &above) && *out == above;
}

static double
decimal_value(const struct decimal *decimal)
{
	double value;

	if (decimal->significant > EXACT_DIGITS)
		return decimal_cut(decimal, &value) ? value
						    : decimal_any(decimal);
	if (!decimal->digits)
		return 0;
	if (decimal_exact(decimal->digits, decimal->exponent, &value))
		return value;
	return decimal_any(decimal);
}

const char *
number_parse(const char *at, const char *end, double *out)
{
	struct decimal decimal;
	const char *behind = decimal_read(at, end, &decimal);
	double value;

	if (!behind)
		return NULL;
	value = decimal_value(&decimal);
	*out = decimal.negative ? -value : value;
	return behind;
}

const char *
number_parse_integer(const char *at, const char *end, int64_t *out)
{
	bool negative = at < end && *at == '-';
	uint64_t limit = (uint64_t)INT64_MAX + negative;
	uint64_t value = 0, digit;
	const char *first;

	if (at < end && (*at == '-' || *at == '+'))
		at++;
	for (first = at; at < end && is_digit(*at); at++) {
		digit = (uint64_t)(*at - '0');
		if (value > (limit - digit) / 10)
			return NULL;
		value = value * 10 + digit;
	}
	if (at == first)
		return NULL;
	*out = negative && value ? -(int64_t)(value - 1) - 1 : (int64_t)value;
	return at;
}
