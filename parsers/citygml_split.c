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
	array_release(&splitter->held);
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

/* Where the rarest letter of a member's name stands in it. */
static const char *
rarest_letter(const char *name, size_t length)
{
	const char *letter = memchr(name, 'O', length);

	return letter ? letter : memchr(name, 'M', length);
}

/* Behind the end tag of this name, or NULL. */
static const char *
end_tag_find(const char *name, size_t length, const char *at, const char *end)
{
	const char *letter = rarest_letter(name, length);
	const size_t before = (size_t)(letter - name) + 2;
	const size_t after = length + 2 - before;

	if ((size_t)(end - at) <= before)
		return NULL;
	for (at += before; (size_t)(end - at) > after; at++) {
		const char *tag, *close;

		at = memchr(at, *letter, (size_t)(end - at) - after);
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
	struct document_pieces *pieces;
	size_t done; /* in pieces */
	size_t members;
};

static const char *
split_at(const struct split *split)
{
	return split->splitter->held.at + split->splitter->first + split->done;
}

static const char *
split_end(const struct split *split)
{
	return split->splitter->held.at + split->splitter->held.count;
}

static enum tcs_status
piece_add(struct split *split, const char *end, bool is_member,
	struct tcs_fault *fault)
{
	const char *at = split_at(split);
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
	const char *at = split_at(split), *end = split_end(split);
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
	const char *at = split_at(split), *end = split_end(split);
	const char *tag = at;
	const char *member_end;
	size_t length;

	while (tag < end && is_blank(*tag))
		tag++;
	if (tag > at && (tag < end || tag - at > READ_MIN))
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
bytes_read(struct splitter *splitter, struct tcs_fault *fault)
{
	struct document_bytes *held = &splitter->held;
	size_t room, got;
	enum tcs_status status;

	held->count -= splitter->first;
	if (splitter->first && held->count)
		memmove(held->at, held->at + splitter->first, held->count);
	splitter->first = 0;
	room = held->count < READ_MIN ? READ_MIN : held->count;
	if (array_grow(held, room))
		return fault_memory(fault);
	status = input_read(
		splitter->input, held->at + held->count, room, &got, fault);
	held->count += got;
	splitter->ended = !status && !got;
	return status;
}

/* What is in pieces goes to the caller. */
static enum tcs_status
pieces_take(const struct split *split, struct document_bytes *bytes,
	struct tcs_fault *fault)
{
	struct splitter *splitter = split->splitter;

	bytes->count = 0;
	if (array_grow(bytes, split->done + 1))
		return fault_memory(fault);
	if (split->done)
		memcpy(bytes->at, splitter->held.at + splitter->first,
			split->done);
	bytes->count = split->done;
	splitter->first += split->done;
	return TCS_OK;
}

static bool
is_over(const struct splitter *splitter)
{
	return splitter->ended && splitter->first == splitter->held.count;
}

enum tcs_status
split_next(struct splitter *splitter, size_t most_members,
	struct document_bytes *bytes, struct document_pieces *pieces,
	struct tcs_fault *fault)
{
	struct split split = {splitter, pieces, 0, 0};
	enum tcs_status status = TCS_OK;

	pieces->count = 0;
	while (!status && !pieces->count && !is_over(splitter)) {
		bool more = true;

		while (!status && more &&
			split_at(&split) < split_end(&split) &&
			split.members < most_members)
			status = piece_next(&split, &more, fault);
		if (!status && !pieces->count)
			status = bytes_read(splitter, fault);
	}
	return status ? status : pieces_take(&split, bytes, fault);
}
