#include "citygml_members.h"

#include <stdlib.h>
#include <string.h>

#include "citygml_numbers.h"

/* ---- helpers ----------------------------------------------------------------- */

bool
leader_can_be_helped(const struct gml_reader *leader)
{
	return leader->head_end && leader->objects &&
		leader->frames.count == 2 && xml_is_between(leader->xml) &&
		(leader->model_srs == TCS_NONE ||
			leader->systems.at[leader->model_srs].decided);
}

static void
systems_release(struct srs_list *systems)
{
	for (size_t i = 0; i < systems->count; i++)
		free(systems->at[i].name);
	array_release(systems);
}

static enum tcs_status
systems_copy(struct srs_list *to, const struct srs_list *from,
	struct tcs_fault *fault)
{
	if (array_grow(to, from->count))
		return fault_memory(fault);
	for (size_t i = 0; i < from->count; i++) {
		to->at[i] = from->at[i];
		to->at[i].name = strdup(from->at[i].name);
		if (!to->at[i].name)
			return fault_memory(fault);
		to->count++;
	}
	return TCS_OK;
}

enum tcs_status
helper_start_take(struct helper_start *start, const struct gml_reader *leader,
	struct tcs_fault *fault)
{
	start->options = &leader->options;
	start->head.count = (size_t)leader->head_end;
	start->model_srs = leader->model_srs;
	start->first_srs = leader->first_srs;
	return systems_copy(&start->systems, &leader->systems, fault);
}

void
helper_start_release(struct helper_start *start)
{
	array_release(&start->head);
	systems_release(&start->systems);
}

static enum tcs_status
helper_begin(struct helper *helper, const struct helper_start *start,
	struct tcs_fault *fault)
{
	struct gml_reader *reader = &helper->reader;
	enum tcs_status status = gml_begin(reader, start->options, fault);

	helper->begun = true;
	reader->is_helper = true;
	reader->model_srs = start->model_srs;
	reader->first_srs = start->first_srs;
	return status ? status
		      : systems_copy(&reader->systems, &start->systems, fault);
}

/* From the head again, after what has left the reader anywhere. */
static enum tcs_status
helper_restart(struct helper *helper, const struct helper_start *start,
	struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	if (!helper->begun)
		status = helper_begin(helper, start, fault);
	if (!status)
		status = gml_start_pass(&helper->reader, PASS_OBJECTS, fault);
	helper->ready = !status;
	return status ? status
		      : gml_feed(&helper->reader, start->head.at,
				start->head.count, fault);
}

void
helper_release(struct helper *helper)
{
	gml_release(&helper->reader);
}

/* The one feature that was read; NULL if it was not one, or not all of it. */
static struct raw_object *
helper_take(struct gml_reader *reader)
{
	struct raw_object *raw = gml_take(reader), *more;
	bool one = raw && !reader->ready && !reader->out_of_turn &&
		!reader->report.counts.count && !reader->report.reasons.count;

	while ((more = gml_take(reader)))
		gml_recycle(reader, more);
	report_clear(&reader->report);
	if (one)
		return raw;
	gml_recycle(reader, raw);
	return NULL;
}

/* Only the leader reads templates. */
static bool
names_template(const char *at, size_t length)
{
	static const char name[] = "ImplicitGeometry";
	const char *end = at + length;

	for (; (size_t)(end - at) >= sizeof name; at++) {
		at = memchr(at, name[0], (size_t)(end - at) - sizeof name + 1);
		if (!at)
			return false;
		if (!memcmp(at, name, sizeof name - 1))
			return true;
	}
	return false;
}

enum tcs_status
helper_read(struct helper *helper, const struct helper_start *start,
	char *bytes, const struct document_piece *piece,
	struct raw_object **out, struct tcs_fault *fault)
{
	struct gml_reader *reader = &helper->reader;
	struct tcs_fault ignored = {0};
	enum tcs_status status = TCS_OK;
	bool whole;

	if (!helper->ready)
		status = helper_restart(helper, start, fault);
	if (status)
		return status;
	gml_recycle(reader, *out);
	*out = NULL;
	if (helper->in_vain &&
		names_template(bytes + piece->first, piece->length))
		return TCS_OK;
	reader->out_of_turn = false;
	gml_move(reader, piece->at, piece->line, reader->objects);
	status = xml_feed_element(reader->xml, bytes + piece->first,
		piece->length, &whole, &ignored);
	helper->ready = !status && whole;
	helper->in_vain |= reader->out_of_turn;
	*out = helper_take(reader);
	if (!helper->ready) {
		gml_recycle(reader, *out);
		*out = NULL;
	}
	if (status != TCS_NO_MEMORY)
		return TCS_OK;
	*fault = ignored;
	return status;
}

/* ---- the leader -------------------------------------------------------------- */

void
leader_pass(struct gml_reader *leader, struct raw_object *raw)
{
	raw->place.number = leader->objects++;
}

static enum tcs_status
feed(struct gml_reader *leader, const char *at, size_t length,
	struct tcs_fault *fault)
{
	enum { FED_AT_ONCE = 64 * 1024 };
	enum tcs_status status = TCS_OK;

	while (!status && length) {
		size_t some = length < FED_AT_ONCE ? length : FED_AT_ONCE;

		status = gml_feed(leader, at, some, fault);
		at += some;
		length -= some;
	}
	return status;
}

/* White space between members is passed over. */
enum tcs_status
leader_read(struct gml_reader *leader, const char *bytes,
	const struct document_piece *piece, struct tcs_fault *fault)
{
	const char *at = bytes + piece->first;
	size_t length = piece->length;
	enum tcs_status status = TCS_OK;

	if (xml_is_between(leader->xml))
		gml_move(leader, piece->at, piece->line, leader->objects);
	while (length && is_blank(at[length - 1]))
		length--;
	status = feed(leader, at, length, fault);
	if (!status && length)
		status = xml_settle(leader->xml, fault);
	if (status || xml_is_between(leader->xml))
		return status;
	return feed(leader, at + length, piece->length - length, fault);
}
