/*
 * The bytes as an srsName: whatever it says, what comes out can be used. The
 * order of coordinates is asked for with the numbers that the name's bytes
 * make.
 */
#include "../../parsers/srs.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const unsigned char *bytes, size_t length);

static void
require(bool condition)
{
	if (!condition)
		abort();
}

static void
check_area(const struct srs *srs)
{
	if (!srs->has_area)
		return;
	for (int i = 0; i < 2; i++) {
		require(isfinite(srs->lower[i]) && isfinite(srs->upper[i]));
		require(srs->lower[i] < srs->upper[i]);
	}
}

static void
check_system(const struct srs *srs)
{
	require(srs->metres_per_unit > 0 && isfinite(srs->metres_per_unit));
	require(srs->metres_per_unit_up > 0 &&
		isfinite(srs->metres_per_unit_up));
	require(srs->epsg >= 0 && srs->epsg_up >= 0);
	require(memchr(srs->assumed, '\0', sizeof srs->assumed) != NULL);
	require(srs->kind != TCS_CRS_UNKNOWN || srs->assumed[0]);
	check_area(srs);
}

int
LLVMFuzzerTestOneInput(const unsigned char *bytes, size_t length)
{
	char *name = malloc(length + 1);
	struct tcs_point sample = {0, 0, 0};
	const char *assumed;
	struct srs srs;

	require(name != NULL);
	if (length > 0)
		memcpy(name, bytes, length);
	name[length] = '\0';
	srs_read(name, &srs);
	check_system(&srs);
	for (size_t i = 0; i < length; i++) {
		sample.x = 7 * sample.x + bytes[i];
		sample.y = 11 * sample.y - bytes[i];
	}
	if (srs_north_first(&srs, sample, &assumed))
		require(srs.north_first || assumed != NULL);
	free(name);
	return 0;
}
