#include "labels.h"

#include <string.h>

/* "-" in the table is NULL in the row. No class has a name that short. */
#define NAME(text) (sizeof(text) == sizeof "-" ? NULL : (text))

#define LABEL_ROW(number, label, kind, m2, n2, m3, n3, colour) \
	[number] = {#label, NAME(m2), NAME(n2), NAME(m3), NAME(n3), (colour), \
		LABEL_##kind},
static const struct label labels[TCS_CLASS_COUNT] = {TCS_CLASSES(LABEL_ROW)};

/* Lengths stand apart: a search reads them alone until one fits. */
#define LENGTH_OF_LABEL(number, label, kind, m2, n2, m3, n3, colour) \
	[number] = sizeof #label - 1,
#define LENGTH_OF_2(number, label, kind, m2, n2, m3, n3, colour) \
	[number] = sizeof(n2) - 1,
#define LENGTH_OF_3(number, label, kind, m2, n2, m3, n3, colour) \
	[number] = sizeof(n3) - 1,
static const uint8_t label_lengths[] = {TCS_CLASSES(LENGTH_OF_LABEL)};
static const uint8_t lengths_2[] = {TCS_CLASSES(LENGTH_OF_2)};
static const uint8_t lengths_3[] = {TCS_CLASSES(LENGTH_OF_3)};

const struct label *
label_of(unsigned class)
{
	return &labels[class < TCS_CLASS_COUNT ? class : TCS_CLASS_Unknown];
}

enum tcs_class
label_find(const char *name, size_t length)
{
	for (unsigned i = 0; i < TCS_CLASS_COUNT; i++)
		if (label_lengths[i] == length &&
			memcmp(labels[i].name, name, length) == 0)
			return (enum tcs_class)i;
	return TCS_CLASS_Unknown;
}

enum tcs_class
label_find_citygml(int version, const char *name, size_t length)
{
	const uint8_t *lengths = version < 3 ? lengths_2 : lengths_3;

	for (unsigned i = 0; i < TCS_CLASS_COUNT; i++) {
		const char *known;

		if (lengths[i] != length)
			continue;
		known = version < 3 ? labels[i].name_2 : labels[i].name_3;
		if (known && memcmp(known, name, length) == 0)
			return (enum tcs_class)i;
	}
	return TCS_CLASS_Unknown;
}
