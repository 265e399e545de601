#include "number_powers.h"

#include <stdbool.h>
#include <string.h>

#include "check.h"

enum { WORDS = 40 };

/* Digits to the base 2^32, the least first. */
struct big {
	uint32_t words[WORDS];
};

static struct big
big_of(uint64_t high, uint64_t low)
{
	return (struct big){{(uint32_t)low, (uint32_t)(low >> 32),
		(uint32_t)high, (uint32_t)(high >> 32)}};
}

static struct big
times(struct big big, uint32_t factor)
{
	uint64_t carry = 0;

	for (int i = 0; i < WORDS; i++) {
		carry += (uint64_t)big.words[i] * factor;
		big.words[i] = (uint32_t)carry;
		carry >>= 32;
	}
	return big;
}

static struct big
times_ten_to(struct big big, int exponent)
{
	while (exponent-- > 0)
		big = times(big, 10);
	return big;
}

static struct big
times_two_to(struct big big, int exponent)
{
	while (exponent-- > 0)
		big = times(big, 2);
	return big;
}

static int
compare(struct big a, struct big b)
{
	for (int i = WORDS - 1; i >= 0; i--) {
		if (a.words[i] != b.words[i])
			return a.words[i] < b.words[i] ? -1 : 1;
	}
	return 0;
}

static struct big
less_one(struct number_power power)
{
	return big_of(power.high - !power.low, power.low - 1);
}

/* As fractions without denominators: power · 2^up against ten · 2^down. */
static bool
is_rounded_up(int e)
{
	struct number_power power = number_powers[e - NUMBER_POWER_FIRST];
	int shift = number_power_exponent(e) - 127;
	int up = shift > 0 ? shift : 0, down = shift < 0 ? -shift : 0;
	int over = e < 0 ? -e : 0;
	struct big ten =
		times_two_to(times_ten_to(big_of(0, 1), e > 0 ? e : 0), down);
	struct big here = times_two_to(
		times_ten_to(big_of(power.high, power.low), over), up);
	struct big below =
		times_two_to(times_ten_to(less_one(power), over), up);

	return power.high >> 63 && compare(here, ten) >= 0 &&
		compare(below, ten) < 0 &&
		(compare(here, ten) == 0) ==
		(e >= 0 && e <= NUMBER_POWER_EXACT);
}

static void
every_power_is_rounded_up_in_its_last_bit(void)
{
	for (int e = NUMBER_POWER_FIRST; e <= NUMBER_POWER_LAST; e++)
		CHECK(is_rounded_up(e));
}

static const struct check_test tests[] = {
	CHECK_TEST(every_power_is_rounded_up_in_its_last_bit),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
