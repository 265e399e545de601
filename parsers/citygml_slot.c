#include "citygml_slot.h"

#include <stdlib.h>
#include <string.h>

#include "citygml_keys.h"

static void
slot_forget(struct slot *slot)
{
	for (size_t i = 0; i < slot->missing.count; i++)
		free(slot->missing.at[i]);
	array_clear(&slot->missing);
}

bool
slot_waits(const struct slot *slot, enum convert_phase phase)
{
	return slot->raw->waits && phase == PHASE_WRITE;
}

/* Missing ids: to look for elsewhere at first, to report in the end. */
static enum tcs_status
keep_missing(struct slot *slot, enum convert_phase phase,
	const struct link_work *links, struct tcs_fault *fault)
{
	struct raw_object *raw = slot->raw;

	if (array_grow(&slot->missing, links->missing.count))
		return fault_memory(fault);
	for (size_t i = 0; i < links->missing.count; i++) {
		const char *id = object_text(&raw->tree, links->missing.at[i]);
		enum tcs_status status = TCS_OK;

		if (phase == PHASE_DEFERRED) {
			status = report_item(&raw->report, REPORT_SKIPPED,
				"link", "nothing in the document has this id",
				id, TCS_NOWHERE, fault);
		} else {
			slot->missing.at[slot->missing.count] = strdup(id);
			if (!slot->missing.at[slot->missing.count++])
				status = fault_memory(fault);
		}
		if (status)
			return status;
	}
	return TCS_OK;
}

static enum tcs_status
hash_ids(struct slot *slot, const struct build_plan *plan,
	struct tcs_fault *fault)
{
	const struct raw_object *raw = slot->raw;

	slot->hashes.count = 0;
	if (array_grow(&slot->hashes, raw->targets.count))
		return fault_memory(fault);
	for (size_t i = 0; i < raw->targets.count; i++)
		slot->hashes.at[slot->hashes.count++] = id_hash(
			plan, object_text(&raw->tree, raw->targets.at[i].id));
	return TCS_OK;
}

/* One record for each template that comes first in this object. */
static enum tcs_status
work_on_templates(struct slot *slot, const struct build_plan *plan,
	struct builder *builder, struct tcs_fault *fault)
{
	struct raw_object *raw = slot->raw;
	enum tcs_status status = TCS_OK;

	slot->prototype_count = 0;
	report_clear(&slot->templates);
	for (size_t i = 0; !status && i < raw->templates.count; i++) {
		if (i == slot->prototypes.count) {
			if (array_grow(&slot->prototypes, 1))
				return fault_memory(fault);
			slot->prototypes.at[slot->prototypes.count++] =
				(struct tcs_record){0};
		}
		status = build_prototype(builder, plan, raw,
			raw->templates.at[i].geometry, &slot->prototype,
			&slot->templates, fault);
		if (!status)
			status = object_encode(&slot->prototype, TCS_PROTOTYPE,
				&slot->prototypes.at[i], fault);
		slot->prototype_count++;
	}
	return status;
}

enum tcs_status
slot_work(struct slot *slot, enum convert_phase phase,
	const struct build_plan *plan, struct builder *builder,
	struct tcs_fault *fault)
{
	enum tcs_status status;

	slot_forget(slot);
	if (phase == PHASE_COLLECT)
		return TCS_OK;
	status = hash_ids(slot, plan, fault);
	if (!status)
		status = paints_fetch(plan, slot->raw, fault);
	if (!status)
		status = work_on_templates(slot, plan, builder, fault);
	if (status || slot_waits(slot, phase))
		return status;
	status = build_object(builder, plan, slot->raw, fault);
	if (!status && builder->links.missing.count)
		status = keep_missing(slot, phase, &builder->links, fault);
	if (status || slot->missing.count)
		return status;
	array_trim(&slot->raw->positions);
	return object_encode(
		&slot->raw->tree, TCS_OBJECT, &slot->record, fault);
}

void
slot_release(struct slot *slot)
{
	raw_free(slot->raw);
	record_release(&slot->record);
	object_release(&slot->prototype);
	report_release(&slot->templates);
	for (size_t i = 0; i < slot->prototypes.count; i++)
		record_release(&slot->prototypes.at[i]);
	array_release(&slot->prototypes);
	slot_forget(slot);
	array_release(&slot->missing);
	array_release(&slot->hashes);
}
