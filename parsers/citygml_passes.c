#include "citygml_passes.h"

#include <stdio.h>
#include <string.h>

/* Feed the bytes from `at` to `end`. */
static enum tcs_status
feed_stretch(struct document *document, uint64_t at, uint64_t end,
	struct tcs_fault *fault)
{
	enum tcs_status status = input_seek(document->input, at, fault);

	while (!status && at < end) {
		uint64_t left = end - at;
		size_t got;

		status = input_read(document->input, document->chunk,
			left < PASS_CHUNK ? (size_t)left : PASS_CHUNK, &got,
			fault);
		if (!status && !got)
			status = fault_set(fault, TCS_TRUNCATED, TCS_NOWHERE,
				"the input has become shorter");
		if (!status)
			status = gml_feed(
				&document->reader, document->chunk, got, fault);
		at += got;
	}
	return status;
}

/* The element around a feature: its start tag, which is kept as an end tag. */
static enum tcs_status
feed_member(struct document *document, const struct raw_place *part,
	char end_tag[MEMBER_TAG_MAX + 2], struct tcs_fault *fault)
{
	size_t room = (size_t)(part->member_end - part->member);
	enum tcs_status status;
	size_t length;

	gml_move(&document->reader, part->member, part->line, part->number);
	status = feed_stretch(document, part->member, part->member_end, fault);
	if (status)
		return status;
	for (length = 1; length < room - 1; length++)
		if (strchr(" \t\r\n", document->chunk[length]))
			break;
	snprintf(end_tag, MEMBER_TAG_MAX + 2, "</%.*s>", (int)length - 1,
		document->chunk + 1);
	return TCS_OK;
}

static enum tcs_status
feed_part(struct document *document, const struct raw_place *part,
	struct tcs_fault *fault)
{
	bool wrapped = part->member < part->member_end;
	char end_tag[MEMBER_TAG_MAX + 2];
	enum tcs_status status = TCS_OK;

	if (wrapped)
		status = feed_member(document, part, end_tag, fault);
	gml_move(&document->reader, part->at, part->line, part->number);
	if (!status)
		status = feed_stretch(document, part->at, part->end, fault);
	if (status || !wrapped)
		return status;
	return gml_feed(&document->reader, end_tag, strlen(end_tag), fault);
}

static enum tcs_status
feed_whole(struct document *document, struct tcs_fault *fault)
{
	enum tcs_status status;
	size_t got;

	status = input_read(
		document->input, document->chunk, PASS_CHUNK, &got, fault);
	if (status)
		return status;
	document->ended = got == 0;
	if (!document->input->at)
		return fault_set(
			fault, TCS_BAD_INPUT, TCS_NOWHERE, "the file is empty");
	return gml_feed(&document->reader, document->chunk, got, fault);
}

enum tcs_status
document_feed(struct document *document, struct tcs_fault *fault)
{
	const struct document_parts *parts = document->parts;

	if (!parts)
		return feed_whole(document, fault);
	document->ended = document->next_part == parts->places.count;
	if (document->ended)
		return TCS_OK;
	return feed_part(
		document, &parts->places.at[document->next_part++], fault);
}

enum tcs_status
document_start(struct document *document, enum gml_pass pass,
	const struct document_parts *parts, struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	document->parts = parts;
	document->next_part = 0;
	document->ended = false;
	if (document->input->at)
		status = input_rewind(document->input, fault);
	if (!status)
		status = gml_start_pass(&document->reader, pass, fault);
	return status || !parts
		? status
		: feed_stretch(document, 0, parts->head_end, fault);
}
