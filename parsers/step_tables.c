#include "step_tables.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A table addressed by ids may be so many times larger than it must. */
enum { SPARSE = 4 };

static enum tcs_status
id_taken(const struct step_file *file, uint32_t instance, struct report *report,
	struct tcs_fault *fault)
{
	char name[24];

	snprintf(name, sizeof name, "#%" PRIu64,
		file->instances.at[instance].id);
	return report_item(report, REPORT_SKIPPED, "instance",
		"its id is taken", name, step_place(file, instance), fault);
}

static enum tcs_status
ids_address(
	struct step_file *file, struct report *report, struct tcs_fault *fault)
{
	size_t size = (size_t)file->id_count * sizeof *file->by_id;
	enum tcs_status status = TCS_OK;

	file->by_id = malloc(size);
	if (!file->by_id)
		return fault_memory(fault);
	memset(file->by_id, 0xff, size);
	for (uint32_t i = 0; i < file->instances.count && !status; i++) {
		uint32_t *slot = file->by_id + file->instances.at[i].id;

		if (*slot == STEP_NONE)
			*slot = i;
		else
			status = id_taken(file, i, report, fault);
	}
	return status;
}

static int
key_order(const void *left, const void *right)
{
	const struct step_key *a = left, *b = right;

	if (a->id != b->id)
		return a->id < b->id ? -1 : 1;
	return a->instance < b->instance ? -1 : a->instance > b->instance;
}

/* Ids may be chosen to collide in any table: these are sorted. */
static enum tcs_status
ids_sort(struct step_file *file, struct report *report, struct tcs_fault *fault)
{
	size_t count = file->instances.count, kept = 0;
	struct step_key *keys = calloc(count, sizeof *keys);
	enum tcs_status status = TCS_OK;

	file->keys = keys;
	if (!keys)
		return fault_memory(fault);
	for (uint32_t i = 0; i < count; i++)
		keys[i] = (struct step_key){file->instances.at[i].id, i};
	qsort(keys, count, sizeof *keys, key_order);
	for (size_t i = 0; i < count && !status; i++) {
		if (kept && keys[kept - 1].id == keys[i].id)
			status =
				id_taken(file, keys[i].instance, report, fault);
		else
			keys[kept++] = keys[i];
	}
	file->id_count = kept;
	return status;
}

enum tcs_status
step_tabulate_ids(
	struct step_file *file, struct report *report, struct tcs_fault *fault)
{
	uint64_t count = file->instances.count, highest = 0;

	for (size_t i = 0; i < count; i++)
		if (file->instances.at[i].id > highest)
			highest = file->instances.at[i].id;
	if (highest / SPARSE > count)
		return ids_sort(file, report, fault);
	file->id_count = highest + 1;
	return ids_address(file, report, fault);
}

/* A counting sort, stable. */
enum tcs_status
step_tabulate_names(struct step_file *file, struct tcs_fault *fault)
{
	size_t count = file->instances.count, names = file->names.list.count;
	uint32_t *begins = calloc(names + 2, sizeof *begins);
	uint32_t *all = malloc((count + 1) * sizeof *all);

	file->name_begins = begins;
	file->by_name = all;
	if (!begins || !all)
		return fault_memory(fault);
	for (uint32_t i = 0; i < count; i++)
		begins[step_name_of(file, i) + 2]++;
	for (size_t i = 2; i < names + 2; i++)
		begins[i] += begins[i - 1];
	for (uint32_t i = 0; i < count; i++)
		all[begins[step_name_of(file, i) + 1]++] = i;
	return TCS_OK;
}

static uint32_t
key_find(const struct step_file *file, uint64_t id)
{
	uint64_t low = 0, high = file->id_count;

	while (low < high) {
		uint64_t middle = low + (high - low) / 2;

		if (file->keys[middle].id < id)
			low = middle + 1;
		else
			high = middle;
	}
	if (low == file->id_count || file->keys[low].id != id)
		return STEP_NONE;
	return file->keys[low].instance;
}

uint32_t
step_find(const struct step_file *file, uint64_t id)
{
	if (file->keys)
		return key_find(file, id);
	return id < file->id_count ? file->by_id[id] : STEP_NONE;
}

uint32_t
step_target(const struct step_file *file, const struct step_value *value)
{
	if (value->kind != STEP_REFERENCE)
		return STEP_NONE;
	return step_find(file, value->reference);
}

struct step_list
step_instances(const struct step_file *file, uint16_t name)
{
	if (!file->name_begins || name >= file->names.list.count)
		return (struct step_list){.count = 0};
	return (struct step_list){.at = file->by_name + file->name_begins[name],
		.count = file->name_begins[name + 1] - file->name_begins[name]};
}
