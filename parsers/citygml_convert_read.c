#include <string.h>

#include "citygml_convert_state.h"
#include "citygml_head.h"

/* ---- the leader -------------------------------------------------------------- */

/* Objects that this phase has nothing to do with are not worked on. */
static bool
is_wanted(struct convert *convert, const struct raw_object *raw)
{
	if (convert->phase != PHASE_DEFERRED)
		return true;
	if (convert->next_deferred == convert->deferred.count ||
		convert->deferred.at[convert->next_deferred] !=
			raw->place.number)
		return false;
	convert->next_deferred++;
	return true;
}

enum tcs_status
prepare_head(struct convert *convert, const struct raw_object *first,
	struct tcs_fault *fault)
{
	struct tcs_head head = {0};
	enum tcs_status status;

	if (convert->head_ready)
		return TCS_OK;
	status = head_build(&head, &convert->document.reader, first,
		convert->command, fault);
	if (!status)
		status = head_encode(&head, &convert->head_record, fault);
	convert->head_ready = true;
	head_release(&head);
	return status;
}

/* Put the wanted ones among the complete objects into the batch. */
static void
batch_fill(struct convert *convert, struct batch *batch)
{
	struct gml_reader *reader = &convert->document.reader;
	struct raw_object *raw;

	while (batch->count < BATCH && (raw = gml_take(reader))) {
		if (is_wanted(convert, raw))
			batch->slots[batch->count++].raw = raw;
		else
			gml_recycle(reader, raw);
	}
}

/* The first bytes of the document, for the helpers. */
static enum tcs_status
head_keep(struct convert *convert, struct tcs_fault *fault)
{
	const struct document_bytes *bytes = &convert->bytes;

	if (array_grow(&convert->start.head, bytes->count))
		return fault_memory(fault);
	memcpy(convert->start.head.at, bytes->at, bytes->count);
	convert->start.head.count = bytes->count;
	return TCS_OK;
}

static bool
helpers_wanted(const struct convert *convert)
{
	const struct gml_reader *leader = &convert->document.reader;

	return convert->phase == PHASE_WRITE && convert->head_ready &&
		leader->head_end <= convert->start.head.count &&
		leader_can_be_helped(leader);
}

/* The leader reads some more of the document, or another part. */
static enum tcs_status
feed_leader(struct convert *convert, struct tcs_fault *fault)
{
	struct document *document = &convert->document;
	struct document_pieces *pieces = &convert->pieces;
	enum tcs_status status;

	if (convert->phase != PHASE_WRITE)
		return document_feed(document, fault);
	status = split_next(
		&convert->splitter, SIZE_MAX, &convert->bytes, pieces, fault);
	if (!status && !document->input->at)
		return fault_set(
			fault, TCS_BAD_INPUT, TCS_NOWHERE, "the file is empty");
	if (!status && !convert->start.head.count)
		status = head_keep(convert, fault);
	for (size_t i = 0; !status && i < pieces->count; i++)
		status = leader_read(&document->reader, convert->bytes.at,
			&pieces->at[i], fault);
	document->ended = !pieces->count;
	return status || pieces->count
		? status
		: gml_feed(&document->reader, NULL, 0, fault);
}

/* Some more of the document may name a coordinate system for the head. */
static bool
head_waits(const struct convert *convert)
{
	enum { LOOKED_THROUGH = 1024 * 1024 };
	const struct document *document = &convert->document;

	return !convert->head_ready && !document->ended &&
		document->reader.model_srs == TCS_NONE &&
		document->reader.first_srs == TCS_NONE &&
		document->input->at < LOOKED_THROUGH;
}

static enum tcs_status
read_alone(struct convert *convert, struct batch *batch, bool *done,
	struct tcs_fault *fault)
{
	struct document *document = &convert->document;

	for (size_t i = 0; i < batch->count; i++) {
		gml_recycle(&document->reader, batch->slots[i].raw);
		batch->slots[i].raw = NULL;
	}
	batch->count = 0;
	for (;;) {
		enum tcs_status status;

		if (!head_waits(convert))
			batch_fill(convert, batch);
		if (batch->count)
			return prepare_head(
				convert, batch->slots[0].raw, fault);
		*done = document->ended;
		if (*done || helpers_wanted(convert))
			return TCS_OK;
		status = feed_leader(convert, fault);
		if (status)
			return status;
	}
}

enum tcs_status
convert_read(void *context, void *item, bool *done, struct tcs_fault *fault)
{
	struct convert *convert = context;
	struct input *input = convert->document.input;
	struct batch *batch = item;
	enum tcs_status status = TCS_OK;

	progress_show(&convert->progress, convert->written,
		input_consumed(input), input->size);
	if (!convert->helped) {
		status = read_alone(convert, batch, done, fault);
		if (status || *done || batch->count)
			return status;
		status = helper_start_take(
			&convert->start, &convert->document.reader, fault);
		convert->helped = true;
	}
	if (!status)
		status = split_next(&convert->splitter, BATCH, &batch->bytes,
			&batch->pieces, fault);
	*done = !status && !batch->pieces.count;
	return status;
}

/* ---- working -------------------------------------------------------------------- */

static enum tcs_status
members_read(const struct convert *convert, struct batch *batch,
	struct helper *helper, struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	batch->count = 0;
	for (size_t i = 0; !status && i < batch->pieces.count; i++) {
		struct slot *slot = &batch->slots[batch->count];

		if (!batch->pieces.at[i].is_member)
			continue;
		batch->count++;
		status = helper_read(helper, &convert->start, batch->bytes.at,
			&batch->pieces.at[i], &slot->raw, fault);
	}
	return status;
}

/* A failure waits until the objects before have been written. */
enum tcs_status
convert_work(void *context, void *item, void *worker, struct tcs_fault *fault)
{
	struct convert *convert = context;
	struct convert_worker *own = worker;
	struct batch *batch = item;

	if (batch->pieces.count &&
		members_read(convert, batch, &own->helper, fault))
		return fault->status;
	for (size_t i = 0; i < batch->count; i++) {
		struct slot *slot = &batch->slots[i];

		slot->status = TCS_OK;
		if (slot->raw)
			slot->status = slot_work(slot, convert->phase,
				&convert->plan, &own->builder, &slot->fault);
	}
	return TCS_OK;
}

enum tcs_status
convert_begin_worker(void *context, void *worker, struct tcs_fault *fault)
{
	struct convert_worker *own = worker;

	(void)context;
	return builder_init(&own->builder, fault);
}

void
convert_release_worker(void *worker)
{
	struct convert_worker *own = worker;

	builder_release(&own->builder);
	helper_release(&own->helper);
}

void
convert_release_batch(void *item)
{
	struct batch *batch = item;

	for (size_t i = 0; i < BATCH; i++)
		slot_release(&batch->slots[i]);
	array_release(&batch->bytes);
	array_release(&batch->pieces);
}
