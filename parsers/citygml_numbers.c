#include "citygml_numbers.h"

#include <math.h>

/* Behind a number that ends at white space or the end; else NULL. */
static const char *
number_alone(const char *at, const char *end, double *out)
{
	at = number_parse(at, end, out);
	return at && (at == end || is_blank(*at)) && isfinite(*out) ? at : NULL;
}

enum tcs_status
numbers_read(struct number_list *numbers, const char *at, size_t length,
	bool *bad, struct tcs_fault *fault)
{
	const char *end = at + length;

	numbers->count = 0;
	*bad = false;
	for (;;) {
		while (at < end && is_blank(*at))
			at++;
		if (at == end)
			return TCS_OK;
		if (array_grow(numbers, 1))
			return fault_memory(fault);
		at = number_alone(at, end, &numbers->at[numbers->count]);
		*bad = !at;
		if (*bad)
			return TCS_OK;
		numbers->count++;
	}
}

int
numbers_first(const char *at, size_t length, double *out, int want)
{
	const char *end = at + length;
	int count = 0;

	while (count < want) {
		while (at < end && (is_blank(*at) || *at == ','))
			at++;
		at = number_parse(at, end, &out[count]);
		if (!at)
			break;
		count++;
	}
	return count;
}
