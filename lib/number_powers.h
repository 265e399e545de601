/*
 * Powers of ten in 128 bits, for reading and printing numbers.
 */
#ifndef TESSERA_NUMBER_POWERS_H
#define TESSERA_NUMBER_POWERS_H

#include <stdint.h>

#define NUMBER_POWER_FIRST (-292)
#define NUMBER_POWER_LAST 324
/* From 10^0 to 10^55 the 128 bits hold all of it. */
#define NUMBER_POWER_EXACT 55

/* Its 128 leading bits, the first of them set. */
struct number_power {
	uint64_t high, low;
};

/*
 * 10^e, for e from NUMBER_POWER_FIRST, over 2^(number_power_exponent(e) - 127),
 * rounded up.
 */
extern const struct number_power number_powers[];

/* The largest x such that 2^x is at most 10^e; for any e of the table. */
static inline int
number_power_exponent(int e)
{
	return (e * 1741647) >> 19;
}

#endif
