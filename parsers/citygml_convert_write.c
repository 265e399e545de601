#include "citygml_convert_state.h"

enum tcs_status
write_head(struct convert *convert, struct tcs_fault *fault)
{
	convert->head_written = true;
	return writer_put(&convert->writer, &convert->head_record, fault);
}

/* The object waits for what it links to. */
static enum tcs_status
defer(struct convert *convert, const struct slot *slot, struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	if (array_grow(&convert->deferred, 1))
		return fault_memory(fault);
	convert->deferred.at[convert->deferred.count++] =
		slot->raw->place.number;
	for (size_t i = 0; !status && i < slot->missing.count; i++)
		status = library_want(
			&convert->library, slot->missing.at[i], fault);
	return status;
}

static enum tcs_status
write_palette(struct convert *convert, struct tcs_fault *fault)
{
	struct tcs_palette *fresh = &convert->document.reader.numbers.fresh;
	enum tcs_status status;

	if (!fresh->images.count && !fresh->materials.count)
		return TCS_OK;
	status = palette_encode(fresh, &convert->palette, fault);
	palette_clear(fresh);
	return status ? status
		      : writer_put(&convert->writer, &convert->palette, fault);
}

/* Now it is the object's turn to have its materials and images numbered. */
static enum tcs_status
slot_number(struct convert *convert, struct slot *slot, bool complete,
	struct tcs_fault *fault)
{
	struct palette_numbers *numbers = &convert->document.reader.numbers;
	const struct tcs_palette *palette = &slot->raw->palette;
	enum tcs_status status;

	if (!palette->images.count && !palette->materials.count)
		return TCS_OK;
	status = palette_number(numbers, palette, fault);
	for (size_t i = 0; !status && i < slot->prototype_count; i++)
		status = palette_renumber(
			numbers, &slot->prototypes.at[i], fault);
	return status || !complete
		? status
		: palette_renumber(numbers, &slot->record, fault);
}

static enum tcs_status
slot_write(struct convert *convert, struct slot *slot, struct tcs_fault *fault)
{
	bool complete =
		!slot->missing.count && !slot_waits(slot, convert->phase);
	enum tcs_status status = TCS_OK;

	if (convert->phase == PHASE_COLLECT)
		return library_collect(&convert->library, slot->raw, fault);
	if (!convert->head_written)
		status = write_head(convert, fault);
	if (!status && convert->phase == PHASE_WRITE)
		status = places_add(&convert->places, &slot->raw->place,
			slot->hashes.at, slot->hashes.count, fault);
	if (!status)
		status = slot_number(convert, slot, complete, fault);
	if (!status)
		status = write_palette(convert, fault);
	for (size_t i = 0; !status && i < slot->prototype_count; i++)
		status = writer_put(
			&convert->writer, &slot->prototypes.at[i], fault);
	if (!status)
		status = report_merge(convert->report, &slot->templates, fault);
	if (status)
		return status;
	if (!complete)
		return defer(convert, slot, fault);
	convert->written++;
	status = report_merge(convert->report, &slot->raw->report, fault);
	if (!status && convert->command->strict)
		status = report_strict(convert->report, fault);
	return status ? status
		      : writer_put(&convert->writer, &slot->record, fault);
}

/* What helpers leave to the leader is worked on when its turn has come. */
static enum tcs_status
leader_turn(struct convert *convert, const char *bytes,
	const struct document_piece *piece, struct tcs_fault *fault)
{
	struct gml_reader *leader = &convert->document.reader;
	struct slot *slot = &convert->turn;
	enum tcs_status status = leader_read(leader, bytes, piece, fault);

	while (!status && (slot->raw = gml_take(leader))) {
		status = slot_work(slot, convert->phase, &convert->plan,
			&convert->builder, fault);
		if (!status)
			status = slot_write(convert, slot, fault);
		gml_recycle(leader, slot->raw);
		slot->raw = NULL;
	}
	return status;
}

static enum tcs_status
pieces_write(
	struct convert *convert, struct batch *batch, struct tcs_fault *fault)
{
	struct gml_reader *leader = &convert->document.reader;
	struct slot *slot = batch->slots;
	enum tcs_status status = TCS_OK;

	for (size_t i = 0; !status && i < batch->pieces.count; i++) {
		const struct document_piece *piece = &batch->pieces.at[i];

		if (!piece->is_member || !slot->raw ||
			!leader_can_be_helped(leader) ||
			leader->model_srs != convert->start.model_srs) {
			status = leader_turn(
				convert, batch->bytes.at, piece, fault);
		} else {
			leader_pass(leader, slot->raw);
			status = slot->status;
			*fault = slot->fault;
			if (!status)
				status = slot_write(convert, slot, fault);
		}
		slot += piece->is_member;
	}
	return status;
}

enum tcs_status
convert_write(void *context, void *item, struct tcs_fault *fault)
{
	struct batch *batch = item;
	enum tcs_status status = TCS_OK;

	if (batch->pieces.count)
		return pieces_write(context, batch, fault);
	for (size_t i = 0; !status && i < batch->count; i++) {
		status = batch->slots[i].status;
		if (status)
			*fault = batch->slots[i].fault;
		else
			status = slot_write(context, &batch->slots[i], fault);
	}
	return status;
}
