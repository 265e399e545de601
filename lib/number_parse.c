#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "number.h"
#include "number_powers.h"

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

/* The powers of ten that are doubles. */
static const double ten_to_exact[] = {1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7,
	1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19,
	1e20, 1e21, 1e22};

static bool
is_digit(char c)
{
	return (unsigned char)(c - '0') <= 9;
}

/* The integer of eight digits, the first one lowest in the word. */
static uint64_t
eight_digits(uint64_t word)
{
	const uint64_t mask = 0x000000ff000000ffu;

	word = word * 10 + (word >> 8); /* pairs, in every other byte */
	return (uint32_t)(((word & mask) * (100 + ((uint64_t)1000000 << 32)) +
				  ((word >> 16) & mask) *
					  (1 + ((uint64_t)10000 << 32))) >>
		32);
}

/* The digits that the next eight bytes begin with: how many. */
static inline unsigned
digits_of_word(const char *at, uint64_t *digits)
{
	static const uint32_t tens[] = {
		1, 10, 100, 1000, 10000, 100000, 1000000, 10000000, 100000000};
	uint64_t word, other;
	unsigned count = 8;

	memcpy(&word, at, sizeof word);
	word ^= 0x3030303030303030u;
	/* The lowest bit set is in the first byte above 9. */
	other = ((word + 0x7676767676767676u) | word) & 0x8080808080808080u;
	if (other)
		count = (unsigned)__builtin_ctzll(other) / 8;
	if (!count)
		return 0;
	word <<= 64 - 8 * count;
	*digits = *digits * tens[count] + eight_digits(word);
	return count;
}

static inline const char *
digits_read(const char *at, const char *end, uint64_t *digits)
{
#if __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
	while (end - at >= 8) {
		unsigned count = digits_of_word(at, digits);

		at += count;
		if (count < 8)
			return at;
	}
#endif
	for (; at < end && is_digit(*at); at++)
		*digits = *digits * 10 + (uint64_t)(*at - '0');
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

/* mantissa · 2^exponent with 53 bits and no subnormal, as a double. */
static double
assembled(uint64_t mantissa, int exponent)
{
	uint64_t bits = mantissa + ((uint64_t)(exponent + 1074) << 52);
	double value;

	memcpy(&value, &bits, sizeof value);
	return value;
}

enum { LOST_BITS = 128 - 53 };

/*
 * digits · 10^exponent from the leading bits of the power: the true product
 * lies less than two units above that of the bits. False where this does not
 * tell to which double it is nearer, or beyond normal doubles.
 */
static bool
decimal_near(uint64_t digits, int64_t exponent, double *out)
{
	const wide half = (wide)1 << (LOST_BITS - 1);
	struct number_power power;
	wide all, lost;
	int up, binary;

	if (exponent < NUMBER_POWER_FIRST || exponent > 288)
		return false;
	power = number_powers[exponent - NUMBER_POWER_FIRST];
	up = __builtin_clzll(digits);
	digits <<= up;
	if (exponent < 0 || exponent > NUMBER_POWER_EXACT)
		power.high -= !power.low--;
	all = (wide)power.high * digits + ((wide)power.low * digits >> 64);
	binary = number_power_exponent((int)exponent) - up + LOST_BITS - 63;
	if (!(all >> 127)) {
		all <<= 1;
		binary--;
	}
	lost = all & (half * 2 - 1);
	if (binary < -1074 + 1 || (lost <= half && lost + 4 >= half))
		return false;
	*out = assembled((uint64_t)(all >> LOST_BITS) + (lost > half), binary);
	return true;
}

/*
 * The first case is Clinger's (How to read floating point numbers accurately,
 * 1990): exact operands of one rounded operation.
 */
static bool
decimal_fast(uint64_t digits, int64_t exponent, double *out)
{
	if (digits > (uint64_t)1 << 53 || exponent < -22 || exponent > 22)
		return decimal_near(digits, exponent, out);
	*out = exponent < 0 ? (double)digits / ten_to_exact[-exponent]
			    : (double)digits * ten_to_exact[exponent];
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
	return decimal_fast(digits, exponent, out) &&
		decimal_fast(digits + 1, exponent, &above) && *out == above;
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
	if (decimal_fast(decimal->digits, decimal->exponent, &value))
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
