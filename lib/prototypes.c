#include "prototypes.h"

#include <stdlib.h>
#include <string.h>

struct prototype {
	struct tcs_record record;
	struct tcs_object object; /* lent by the record */
};

/* Entries 2^n - 1 … 2^(n+1) - 2 are those of page n. */
static struct prototype *
prototype_at(const struct prototypes *prototypes, uint32_t number, int *page)
{
	uint32_t place = number + 1;

	*page = 0;
	while (place >> (*page + 1))
		++*page;
	if (!prototypes->pages[*page])
		return NULL;
	return prototypes->pages[*page] + (place - (UINT32_C(1) << *page));
}

enum tcs_status
prototypes_add(struct prototypes *prototypes, const struct tcs_record *record,
	struct tcs_fault *fault)
{
	struct prototype *to;
	enum tcs_status status;
	int page;

	if (prototypes->count >= UINT32_MAX / 4)
		return fault_set(fault, TCS_LIMIT, record->at,
			"more prototypes than can be counted");
	to = prototype_at(prototypes, prototypes->count, &page);
	if (!to) {
		prototypes->pages[page] = calloc((size_t)1 << page, sizeof *to);
		if (!prototypes->pages[page])
			return fault_memory(fault);
		to = prototype_at(prototypes, prototypes->count, &page);
	}
	to->record.type = record->type;
	to->record.at = record->at;
	to->record.before = record->before;
	if (array_grow(&to->record.bytes, record->bytes.count + 1))
		return fault_memory(fault);
	if (record->bytes.count)
		memcpy(to->record.bytes.at, record->bytes.at,
			record->bytes.count);
	to->record.bytes.count = record->bytes.count;
	prototypes->count++;
	status = object_decode(&to->object, &to->record, fault);
	return status;
}

const struct tcs_object *
prototypes_get(const struct prototypes *prototypes, uint32_t number)
{
	int page;

	return &prototype_at(prototypes, number, &page)->object;
}

void
prototypes_release(struct prototypes *prototypes)
{
	int page;

	for (uint32_t i = 0; i < prototypes->count; i++) {
		struct prototype *at = prototype_at(prototypes, i, &page);

		object_release(&at->object);
		record_release(&at->record);
	}
	for (page = 0; page < PROTOTYPE_PAGES; page++)
		free(prototypes->pages[page]);
	*prototypes = (struct prototypes){0};
}
