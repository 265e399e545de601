#include "citygml_skim.h"

#include <string.h>
#include <strings.h>

#include "newlines.h"

enum {
	SKIM_CHUNK = 64 * 1024,
	TOKEN_MAX = 1024 * 1024, /* bytes of a tag or comment */
};

/* ---- a quick look ----------------------------------------------------------- */

enum { MEMBER_NAME_LENGTH = 16 };

static const struct member_name {
	char name[MEMBER_NAME_LENGTH + 1];
	unsigned char rarest; /* letter, in CityGML */
} appearance = {"appearanceMember", 10}, city_object = {"cityObjectMember", 4};

/* The first such name, found by its rarest letter, or NULL. */
static const char *
member_name_find(
	const char *at, const char *end, const struct member_name *member)
{
	const size_t before = member->rarest;
	const size_t after = MEMBER_NAME_LENGTH - 1 - before;

	if (end - at < MEMBER_NAME_LENGTH)
		return NULL;
	for (at += before; at < end - after; at++) {
		at = memchr(
			at, member->name[before], (size_t)(end - after - at));
		if (!at)
			return NULL;
		if (!memcmp(at - before, member->name, MEMBER_NAME_LENGTH))
			return at - before;
	}
	return NULL;
}

TCS_ARRAY_TYPE(skim_bytes, char);

/* Append bytes of the input; *got is false at its end. */
static enum tcs_status
bytes_read(struct skim_bytes *bytes, struct input *input, bool *got,
	struct tcs_fault *fault)
{
	enum tcs_status status;
	size_t count;

	if (array_grow(bytes, SKIM_CHUNK))
		return fault_memory(fault);
	status = input_read(
		input, bytes->at + bytes->count, SKIM_CHUNK, &count, fault);
	bytes->count += count;
	*got = count;
	return status;
}

static void
bytes_drop(struct skim_bytes *bytes, size_t count)
{
	memmove(bytes->at, bytes->at + count, bytes->count - count);
	bytes->count -= count;
}

/* Text in UTF-16, told by its NULs, gets the benefit of the doubt. */
static enum tcs_status
look_quickly(struct skim_bytes *bytes, struct input *input, bool *found,
	struct tcs_fault *fault)
{
	const size_t overlap = MEMBER_NAME_LENGTH;
	bool got = true;

	*found = false;
	while (got && !*found) {
		enum tcs_status status;

		if (bytes->count > overlap)
			bytes_drop(bytes, bytes->count - overlap);
		status = bytes_read(bytes, input, &got, fault);
		if (status)
			return status;
		*found = member_name_find(bytes->at, bytes->at + bytes->count,
				 &appearance) ||
			memchr(bytes->at, 0, bytes->count);
	}
	return TCS_OK;
}

/* ---- markup ----------------------------------------------------------------- */

struct skim {
	struct skim_bytes bytes; /* from byte `at` of the document on */
	struct document_parts *parts;
	uint64_t at;
	uint64_t line; /* of byte `at` + `counted` */
	size_t counted;
	uint64_t depth; /* open elements, but for those below a member */
	uint64_t members; /* open cityObjectMembers, one in the other */
	const char *declaration; /* the next one in the bytes; NULL: none */
	bool declared; /* that is known */
	bool joins; /* nothing but text since the last part */
	bool within; /* a part */
	bool painted; /* there is an appearance */
	bool unsure;
};

/* Behind this text, or NULL when it does not come. */
static const char *
behind(const char *at, const char *end, const char *text)
{
	size_t length = strlen(text);

	for (; (size_t)(end - at) >= length; at++) {
		at = memchr(at, *text, (size_t)(end - at) - length + 1);
		if (!at)
			return NULL;
		if (!memcmp(at, text, length))
			return at + length;
	}
	return NULL;
}

static bool
begins(const char *at, const char *end, const char *text)
{
	size_t length = strlen(text);

	return (size_t)(end - at) >= length && !memcmp(at, text, length);
}

/* Behind the '>' of a start tag; a value may have that too. */
static const char *
behind_start_tag(const char *at, const char *end)
{
	for (;;) {
		const char *tag_end = memchr(at, '>', (size_t)(end - at));
		const char *quote;

		if (!tag_end)
			return NULL;
		for (quote = at; *quote != '"' && *quote != '\''; quote++)
			if (quote == tag_end)
				return tag_end + 1;
		at = memchr(quote + 1, *quote, (size_t)(end - quote - 1));
		if (!at)
			return NULL;
		at++;
	}
}

/* Behind a comment or a CDATA section; a document type is too much. */
static const char *
behind_declaration(struct skim *skim, const char *at, const char *end)
{
	static const char comment[] = "<!--", data[] = "<![CDATA[";

	if (begins(at, end, comment))
		return behind(at + 4, end, "-->");
	if (begins(at, end, data))
		return behind(at + 9, end, "]]>");
	skim->unsure = (size_t)(end - at) >= sizeof data;
	return NULL;
}

/* ---- parts ------------------------------------------------------------------- */

static void
lines_count(struct skim *skim, size_t upto)
{
	skim->line += newlines_count(
		skim->bytes.at + skim->counted, upto - skim->counted);
	skim->counted = upto;
}

/* The name of a tag without its prefix. */
static bool
is_named(const char *tag, const char *name)
{
	size_t length = strcspn(tag, " \t\r\n/>");
	const char *colon = memchr(tag, ':', length);
	const char *local = colon ? colon + 1 : tag;

	length -= (size_t)(local - tag);
	return length == strlen(name) && !memcmp(local, name, length);
}

/* An appearance, or the bounds with the name of the coordinate system. */
static bool
is_wanted_member(struct skim *skim, const char *tag)
{
	if (is_named(tag, "boundedBy"))
		return true;
	if (!is_named(tag, "appearanceMember"))
		return false;
	skim->painted = true;
	return true;
}

static bool
is_city_object_member(const char *tag)
{
	return is_named(tag, "cityObjectMember");
}

static enum tcs_status
part_begin(struct skim *skim, const char *at, struct tcs_fault *fault)
{
	size_t offset = (size_t)(at - skim->bytes.at);
	struct document_parts *parts = skim->parts;

	skim->within = true;
	if (skim->joins)
		return TCS_OK;
	if (array_grow(&parts->places, 1))
		return fault_memory(fault);
	lines_count(skim, offset);
	parts->places.at[parts->places.count++] =
		(struct raw_place){.at = skim->at + offset, .line = skim->line};
	return TCS_OK;
}

/* An element at the model's depth ended, or another one begins there. */
static void
part_end(struct skim *skim, const char *behind_tag)
{
	struct document_parts *parts = skim->parts;

	if (skim->within)
		parts->places.at[parts->places.count - 1].end =
			skim->at + (uint64_t)(behind_tag - skim->bytes.at);
	skim->joins = skim->within;
	skim->within = false;
}

static enum tcs_status
start_tag(struct skim *skim, const char *at, const char *behind_tag,
	struct tcs_fault *fault)
{
	bool empty = behind_tag[-2] == '/';
	enum tcs_status status = TCS_OK;

	if (skim->depth == 0) {
		skim->unsure |= skim->parts->head_end > 0;
		skim->parts->head_end =
			skim->at + (uint64_t)(behind_tag - skim->bytes.at);
	}
	if (skim->depth == 1 && is_wanted_member(skim, at + 1))
		status = part_begin(skim, at, fault);
	if (skim->depth == 1 && !empty && is_city_object_member(at + 1))
		skim->members = 1;
	if (!empty)
		skim->depth++;
	else if (skim->depth == 1)
		part_end(skim, behind_tag);
	return status;
}

static void
end_tag(struct skim *skim, const char *behind_tag)
{
	skim->unsure |= skim->depth == 0;
	skim->depth--;
	if (skim->depth == 1)
		part_end(skim, behind_tag);
}

/* One piece of markup from its '<': *next is NULL when it is not complete. */
static enum tcs_status
markup(struct skim *skim, const char *at, const char *end, const char **next,
	struct tcs_fault *fault)
{
	*next = NULL;
	if (end - at < 2)
		return TCS_OK;
	switch (at[1]) {
	case '/':
		*next = memchr(at, '>', (size_t)(end - at));
		if (*next)
			end_tag(skim, ++*next);
		return TCS_OK;
	case '!':
		*next = behind_declaration(skim, at, end);
		return TCS_OK;
	case '?':
		*next = behind(at + 2, end, "?>");
		return TCS_OK;
	default:
		*next = behind_start_tag(at, end);
		return *next ? start_tag(skim, at, *next, fault) : TCS_OK;
	}
}

/* ---- members that are not wanted ---------------------------------------------- */

/* The next "<!" or "<?". */
static const char *
declaration_find(const char *at, const char *end)
{
	const char *found = NULL;

	for (int i = 0; i < 2; i++) {
		const char *mark = at;

		while ((mark = memchr(mark, "!?"[i], (size_t)(end - mark))) &&
			(mark == at || mark[-1] != '<'))
			mark++;
		if (mark) {
			found = mark - 1;
			end = mark;
		}
	}
	return found;
}

/* The tag that a name found behind `at` belongs to; NULL: it is text. */
static const char *
tag_of_name(const char *at, const char *name)
{
	const char *tag = name;

	if (tag > at && tag[-1] == ':')
		while (tag > at && !strchr("</ \t\r\n\"'>", tag[-1]))
			tag--;
	if (tag > at && tag[-1] == '/')
		tag--;
	return tag > at && tag[-1] == '<' ? tag - 1 : NULL;
}

/* Count a tag with the name of the member it is in; behind the tag. */
static const char *
member_tag(struct skim *skim, const char *tag, const char *end)
{
	const char *behind_tag = behind_start_tag(tag, end);
	bool ends = tag[1] == '/';

	if (!behind_tag || !is_city_object_member(tag + 1 + ends))
		return behind_tag;
	if (!ends)
		skim->members += behind_tag[-2] != '/';
	else if (--skim->members == 0)
		end_tag(skim, behind_tag);
	return behind_tag;
}

/*
 * Within a member nothing counts but its end, and elements of its name before.
 * Up to `end`, where nothing is cut; NULL when there is no more, with the rest
 * to look at again.
 */
static const char *
member_skip(
	struct skim *skim, const char *at, const char *end, const char **rest)
{
	while (skim->members && at && !skim->unsure) {
		const char *mark, *name, *tag;

		if (!skim->declared ||
			(skim->declaration && skim->declaration < at)) {
			skim->declaration = declaration_find(at, end);
			skim->declared = true;
		}
		mark = skim->declaration;
		name = member_name_find(at, mark ? mark : end, &city_object);
		tag = name ? tag_of_name(at, name) : NULL;
		*rest = tag ? tag : name ? name : mark ? mark : end;
		if (tag)
			at = member_tag(skim, tag, end);
		else if (name)
			at = name + MEMBER_NAME_LENGTH;
		else if (mark && mark[1] == '?')
			at = behind(mark + 2, end, "?>");
		else
			at = mark ? behind_declaration(skim, mark, end) : NULL;
	}
	return at;
}

/* ---- the bytes ------------------------------------------------------------------ */

/* Look at all that is complete up to `end`; the rest begins at *rest. */
static enum tcs_status
bytes_skim(struct skim *skim, const char *end, const char **rest,
	struct tcs_fault *fault)
{
	const char *next = skim->bytes.at;
	enum tcs_status status = TCS_OK;

	skim->declared = false;
	while (!status && !skim->unsure && next) {
		if (skim->members) {
			next = member_skip(skim, next, end, rest);
			continue;
		}
		*rest = memchr(next, '<', (size_t)(end - next));
		if (!*rest)
			*rest = end;
		next = NULL;
		if (*rest < end)
			status = markup(skim, *rest, end, &next, fault);
	}
	return status;
}

/* Where the last markup begins if its end is missing. */
static const char *
markup_cut(const struct skim_bytes *bytes)
{
	const char *end = bytes->at + bytes->count;
	const char *last = end;

	while (last > bytes->at && *--last != '<')
		;
	return bytes->count && *last == '<' && !behind_start_tag(last, end)
		? last
		: end;
}

/* Look at the bytes, and drop what was seen. */
static enum tcs_status
bytes_take(struct skim *skim, struct tcs_fault *fault)
{
	const char *rest = skim->bytes.at;
	enum tcs_status status =
		bytes_skim(skim, markup_cut(&skim->bytes), &rest, fault);
	size_t done = (size_t)(rest - skim->bytes.at);

	lines_count(skim, done);
	skim->counted = 0;
	skim->at += done;
	bytes_drop(&skim->bytes, done);
	skim->unsure |= skim->bytes.count > TOKEN_MAX;
	return status;
}

/* ---- encodings ---------------------------------------------------------------- */

/* Whether the bytes of ASCII stand for themselves, and only for them. */
static bool
is_like_ascii(const char *name)
{
	static const char *const known[] = {
		"UTF-8", "US-ASCII", "ASCII", "ISO-8859-", "windows-125"};

	for (size_t i = 0; i < sizeof known / sizeof *known; i++)
		if (!strncasecmp(name, known[i], strlen(known[i])))
			return true;
	return false;
}

/* From the XML declaration; without one it is UTF-8, or has NULs. */
static bool
bytes_are_like_ascii(const struct skim_bytes *bytes)
{
	const char *at = bytes->at, *end = at + bytes->count;
	const char *name;
	char text[64] = "";

	if (begins(at, end, "\xef\xbb\xbf"))
		at += 3;
	if (memchr(at, 0, (size_t)(end - at)))
		return false;
	if (!begins(at, end, "<?xml"))
		return true;
	end = behind(at, end, "?>");
	if (!end)
		return false;
	name = behind(at, end, "encoding");
	if (!name)
		return true;
	name += strspn(name, " \t\r\n=\"'");
	for (size_t i = 0; i < sizeof text - 1 && name + i < end; i++)
		text[i] = name[i];
	return is_like_ascii(text);
}

/* ---- all of it ---------------------------------------------------------------- */

static enum tcs_status
look_closely(struct skim *skim, struct input *input, struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;
	bool got = true, first = true;

	while (!status && got && !skim->unsure) {
		status = bytes_read(&skim->bytes, input, &got, fault);
		if (first && !status)
			skim->unsure = !bytes_are_like_ascii(&skim->bytes);
		first = false;
		if (!status)
			status = bytes_take(skim, fault);
	}
	skim->unsure |= skim->depth > 0 || skim->bytes.count;
	return status;
}

enum tcs_status
skim_appearances(struct input *input, struct document_parts *parts,
	enum skim_result *result, struct tcs_fault *fault)
{
	struct skim skim = {.parts = parts, .line = 1};
	enum tcs_status status = look_closely(&skim, input, fault);
	bool found = skim.painted;

	if (!status && skim.unsure) {
		skim.bytes.count = 0;
		status = input_rewind(input, fault);
		if (!status)
			status =
				look_quickly(&skim.bytes, input, &found, fault);
	}
	*result = !found ? SKIM_NONE : skim.unsure ? SKIM_UNSURE : SKIM_PARTS;
	if (*result != SKIM_PARTS)
		parts_release(parts);
	array_release(&skim.bytes);
	return status;
}
