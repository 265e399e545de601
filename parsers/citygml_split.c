#include "citygml_split.h"

#include <string.h>

#include "citygml_numbers.h"
#include "newlines.h"

enum {
	READ_MIN = 64 * 1024, /* bytes at a time */
	NAME_MAX_LENGTH = 100, /* of a tag that is looked at */
};

void
splitter_release(struct splitter *splitter)
{
	array_release(&splitter->rest);
}

/* ---- tags -------------------------------------------------------------------- */

/* The length of the name of a start tag; 0 for any other markup. */
static size_t
tag_name_length(const char *tag, const char *end)
{
	const char *at = tag + 1;

	if (end - at > NAME_MAX_LENGTH)
		end = at + NAME_MAX_LENGTH;
	while (at < end && !is_blank(*at) && *at != '>' && *at != '/' &&
		*at != '<')
		at++;
	return at < end && *at != '<' ? (size_t)(at - tag - 1) : 0;
}

static bool
is_member_name(const char *name, size_t length)
{
	static const char *const names[] = {
		"cityObjectMember", "featureMember"};
	const char *colon = memchr(name, ':', length);

	if (colon) {
		length -= (size_t)(colon + 1 - name);
		name = colon + 1;
	}
	for (size_t i = 0; i < sizeof names / sizeof *names; i++)
		if (length == strlen(names[i]) &&
			!memcmp(name, names[i], length))
			return true;
	return false;
}

/* Behind the end tag of this name, looked for by its rarest letter; or NULL. */
static const char *
end_tag_find(const char *name, size_t length, const char *at, const char *end)
{
	const char *letter = memchr(name, 'M', length);
	const size_t before = (size_t)(letter - name) + 2;
	const size_t after = length + 2 - before;

	if ((size_t)(end - at) <= before)
		return NULL;
	for (at += before; (size_t)(end - at) > after; at++) {
		const char *tag, *close;

		at = memchr(at, 'M', (size_t)(end - at) - after);
		if (!at)
			return NULL;
		tag = at - before;
		if (tag[0] != '<' || tag[1] != '/' ||
			memcmp(tag + 2, name, length) != 0)
			continue;
		for (close = tag + 2 + length; close < end && is_blank(*close);
			close++)
			;
		if (close < end && *close == '>')
			return close + 1;
	}
	return NULL;
}

/* The next start tag of a member; else the last '<', else the end. */
static const char *
member_find(const char *at, const char *end, bool *found)
{
	const char *last = end;

	*found = false;
	while ((at = memchr(at, '<', (size_t)(end - at)))) {
		size_t length = tag_name_length(at, end);

		*found = length && is_member_name(at + 1, length);
		last = at;
		if (*found)
			break;
		at++;
	}
	return last;
}

/* ---- pieces ------------------------------------------------------------------ */

/* A walk over the bytes at hand. */
struct split {
	struct splitter *splitter;
	const struct document_bytes *bytes;
	struct document_pieces *pieces;
	size_t done; /* in pieces */
	size_t members;
};

static enum tcs_status
piece_add(struct split *split, const char *end, bool is_member,
	struct tcs_fault *fault)
{
	const char *at = split->bytes->at + split->done;
	size_t length = (size_t)(end - at);

	if (!length)
		return TCS_OK;
	if (array_grow(split->pieces, 1))
		return fault_memory(fault);
	split->pieces->at[split->pieces->count++] = (struct document_piece){
		.first = split->done,
		.length = length,
		.at = split->splitter->at,
		.line = split->splitter->lines + 1,
		.is_member = is_member,
	};
	split->splitter->at += length;
	split->splitter->lines += newlines_count(at, length);
	split->done += length;
	split->members += is_member;
	return TCS_OK;
}

/* Bytes that are no member's: all of them if nothing is to come. */
static enum tcs_status
other_add(struct split *split, bool *more, struct tcs_fault *fault)
{
	const char *at = split->bytes->at + split->done;
	const char *end = split->bytes->at + split->bytes->count;
	const char *cut = end;
	bool found = false;

	if (at < end)
		cut = member_find(at + 1, end, &found);
	if (!found && (split->splitter->ended || end - cut > READ_MIN))
		cut = end;
	*more = found;
	return piece_add(split, cut, false, fault);
}

/* The next piece; *more is false where it depends on bytes to come. */
static enum tcs_status
piece_next(struct split *split, bool *more, struct tcs_fault *fault)
{
	const char *at = split->bytes->at + split->done;
	const char *end = split->bytes->at + split->bytes->count;
	const char *tag = at;
	const char *member_end;
	size_t length;

	while (tag < end && is_blank(*tag))
		tag++;
	if (tag < end && tag > at)
		return piece_add(split, tag, false, fault);
	length = tag < end && *tag == '<' ? tag_name_length(tag, end) : 0;
	if (!length || !is_member_name(tag + 1, length)) {
		*more = split->splitter->ended || end - tag > NAME_MAX_LENGTH;
		return *more ? other_add(split, more, fault) : TCS_OK;
	}
	member_end = end_tag_find(tag + 1, length, tag + 1, end);
	if (member_end &&
		(uint64_t)(member_end - tag) <= split->splitter->max_member)
		return piece_add(split, member_end, true, fault);
	*more = member_end || split->splitter->ended ||
		(uint64_t)(end - tag) > split->splitter->max_member;
	return *more ? other_add(split, more, fault) : TCS_OK;
}

/* ---- bytes ------------------------------------------------------------------- */

static enum tcs_status
bytes_read(struct split *split, struct document_bytes *bytes,
	struct tcs_fault *fault)
{
	size_t room = bytes->count < READ_MIN ? READ_MIN : bytes->count;
	enum tcs_status status;
	size_t got;

	if (array_grow(bytes, room + 1))
		return fault_memory(fault);
	status = input_read(split->splitter->input, bytes->at + bytes->count,
		room, &got, fault);
	bytes->count += got;
	split->splitter->ended = !status && !got;
	return status;
}

/* What is in no piece waits for more. */
static enum tcs_status
rest_keep(struct split *split, struct tcs_fault *fault)
{
	struct document_bytes *rest = &split->splitter->rest;
	size_t length = split->bytes->count - split->done;

	rest->count = 0;
	if (array_grow(rest, length))
		return fault_memory(fault);
	if (length)
		memcpy(rest->at, split->bytes->at + split->done, length);
	rest->count = length;
	return TCS_OK;
}

enum tcs_status
split_next(struct splitter *splitter, size_t most_members,
	struct document_bytes *bytes, struct document_pieces *pieces,
	struct tcs_fault *fault)
{
	struct split split = {splitter, bytes, pieces, 0, 0};
	enum tcs_status status = TCS_OK;

	pieces->count = bytes->count = 0;
	if (array_grow(bytes, splitter->rest.count + 1))
		return fault_memory(fault);
	if (splitter->rest.count)
		memcpy(bytes->at, splitter->rest.at, splitter->rest.count);
	bytes->count = splitter->rest.count;
	while (!status && !pieces->count &&
		(bytes->count || !splitter->ended)) {
		bool more = bytes->count;

		while (!status && more && split.done < bytes->count &&
			split.members < most_members)
			status = piece_next(&split, &more, fault);
		if (!status && !pieces->count)
			status = bytes_read(&split, bytes, fault);
	}
	return status ? status : rest_keep(&split, fault);
}
