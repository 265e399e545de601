#include "compare_pairs.h"

#include <stdlib.h>
#include <string.h>

void
pair_object_free(struct pair_object *object)
{
	if (!object)
		return;
	array_release(&object->placed);
	object_release(&object->object);
	record_release(&object->record);
	free(object);
}

/* ---- one stream ---------------------------------------------------------- */

static enum tcs_status
open_stream(struct pair_stream *stream, const char *name, uint64_t max_record,
	struct tcs_fault *fault)
{
	enum tcs_status status =
		reader_open(&stream->reader, name, max_record, fault);

	if (!status)
		status = reader_next(&stream->reader, &stream->record, fault);
	if (!status)
		status = head_decode(&stream->head, &stream->record, fault);
	return status;
}

static void
close_stream(struct pair_stream *stream)
{
	for (size_t i = 0; i < stream->prototypes.count; i++)
		pair_object_free(stream->prototypes.at[i]);
	array_release(&stream->prototypes);
	reader_close(&stream->reader);
	head_release(&stream->head);
	record_release(&stream->record);
}

/* The next object or prototype, other records passed over; NULL at the end. */
static enum tcs_status
next_mesh(struct pair_stream *stream, struct pair_object **out,
	struct tcs_fault *fault)
{
	struct pair_object *object;
	enum tcs_status status = TCS_OK;

	*out = NULL;
	if (stream->reader.ended)
		return TCS_OK;
	object = calloc(1, sizeof *object);
	if (!object)
		return fault_memory(fault);
	do
		status = reader_next(&stream->reader, &object->record, fault);
	while (!status && !stream->reader.ended &&
		object->record.type != TCS_OBJECT &&
		object->record.type != TCS_PROTOTYPE);
	if (!status && !stream->reader.ended)
		status = object_decode(&object->object, &object->record, fault);
	if (status || stream->reader.ended) {
		pair_object_free(object);
		return status;
	}
	*out = object;
	return TCS_OK;
}

static enum tcs_status
keep_prototype(struct pair_stream *stream, struct pair_object *prototype,
	struct tcs_fault *fault)
{
	if (array_grow(&stream->prototypes, 1)) {
		pair_object_free(prototype);
		return fault_memory(fault);
	}
	stream->prototypes.at[stream->prototypes.count++] = prototype;
	return TCS_OK;
}

/* Decoding has checked that the prototypes stand before the object. */
static enum tcs_status
find_placed(const struct pair_stream *stream, struct pair_object *object,
	struct tcs_fault *fault)
{
	size_t count = object->object.instances.count;

	if (array_grow(&object->placed, count))
		return fault_memory(fault);
	for (size_t i = 0; i < count; i++)
		object->placed.at[i] =
			&stream->prototypes
				 .at[object->object.instances.at[i].prototype]
				 ->object;
	object->placed.count = count;
	return TCS_OK;
}

/* The next object; NULL at the end. */
static enum tcs_status
next_object(struct pair_stream *stream, struct pair_object **out,
	struct tcs_fault *fault)
{
	enum tcs_status status = next_mesh(stream, out, fault);

	while (!status && *out && (*out)->record.type == TCS_PROTOTYPE) {
		status = keep_prototype(stream, *out, fault);
		*out = NULL;
		if (!status)
			status = next_mesh(stream, out, fault);
	}
	if (!status && *out)
		status = find_placed(stream, *out, fault);
	if (status) {
		pair_object_free(*out);
		*out = NULL;
	}
	return status;
}

/* ---- both ---------------------------------------------------------------- */

enum tcs_status
pairs_open(struct pair_reader *pairs, const char *const names[2],
	uint64_t max_record, struct tcs_fault *fault)
{
	for (int i = 0; i < 2; i++) {
		enum tcs_status status = open_stream(
			&pairs->streams[i], names[i], max_record, fault);

		if (status)
			return status;
	}
	return TCS_OK;
}

static const char *
id_of(const struct pair_object *object)
{
	const struct tcs_object *o = &object->object;

	return o->features.count ? object_text(o, o->features.at[0].id) : "";
}

static enum tcs_status
let_wait(struct pair_reader *pairs, struct pair_object *object,
	struct tcs_fault *fault)
{
	const char *id = id_of(object);
	struct pair_queue *queue;
	enum tcs_status status;
	uint32_t number;
	bool added;

	if (array_grow(&pairs->waiting, 1))
		return fault_memory(fault);
	status = byte_index_add(
		&pairs->ids, id, strlen(id), &number, &added, fault);
	if (status)
		return status;
	if (added)
		pairs->waiting.at[pairs->waiting.count++] =
			(struct pair_queue){NULL, NULL};
	queue = &pairs->waiting.at[number];
	if (queue->last)
		queue->last->next = object;
	else
		queue->first = object;
	queue->last = object;
	return TCS_OK;
}

static struct pair_object *
take_first(struct pair_queue *queue)
{
	struct pair_object *object = queue->first;

	if (!object)
		return NULL;
	queue->first = object->next;
	if (!queue->first)
		queue->last = NULL;
	object->next = NULL;
	return object;
}

/* From those that wait, or by reading on until it comes. */
static enum tcs_status
find_partner(struct pair_reader *pairs, const char *id,
	struct pair_object **out, struct tcs_fault *fault)
{
	uint32_t number = byte_index_find(&pairs->ids, id, strlen(id));
	enum tcs_status status = TCS_OK;

	*out = NULL;
	if (number != INDEX_NONE)
		*out = take_first(&pairs->waiting.at[number]);
	while (!status && !*out) {
		struct pair_object *object;

		status = next_object(&pairs->streams[1], &object, fault);
		if (status || !object)
			return status;
		if (!strcmp(id_of(object), id)) {
			*out = object;
			break;
		}
		status = let_wait(pairs, object, fault);
		if (status)
			pair_object_free(object);
	}
	return status;
}

/* What nobody asked for: those that wait, then the rest of the stream. */
static enum tcs_status
next_left(struct pair_reader *pairs, struct pair_object **out,
	struct tcs_fault *fault)
{
	for (; pairs->next_left < pairs->waiting.count; pairs->next_left++) {
		*out = take_first(&pairs->waiting.at[pairs->next_left]);
		if (*out)
			return TCS_OK;
	}
	return next_object(&pairs->streams[1], out, fault);
}

enum tcs_status
pairs_next(struct pair_reader *pairs, struct pair_object *pair[2],
	struct tcs_fault *fault)
{
	enum tcs_status status =
		next_object(&pairs->streams[0], &pair[0], fault);

	pair[1] = NULL;
	if (status)
		return status;
	if (!pair[0])
		return next_left(pairs, &pair[1], fault);
	return find_partner(pairs, id_of(pair[0]), &pair[1], fault);
}

void
pairs_close(struct pair_reader *pairs)
{
	for (size_t i = 0; i < pairs->waiting.count; i++) {
		struct pair_object *object;

		while ((object = take_first(&pairs->waiting.at[i])))
			pair_object_free(object);
	}
	array_release(&pairs->waiting);
	byte_index_release(&pairs->ids);
	for (int i = 0; i < 2; i++)
		close_stream(&pairs->streams[i]);
}
