#include "step_zip.h"

#include <string.h>
#include <zlib.h>

enum {
	LOCAL_HEAD = 30,
	ENTRY_HEAD = 46,
	TAIL = 22,
	LONGEST_COMMENT = 65535,
	PIECE = 1 << 16,
};

struct archive {
	const unsigned char *bytes;
	size_t length;
	size_t directory, directory_end;
};

struct member {
	unsigned flags, method;
	uint32_t crc;
	size_t packed, unpacked, local;
	const unsigned char *name;
	size_t name_length;
};

static unsigned
get16(const unsigned char *at)
{
	return at[0] | (unsigned)at[1] << 8;
}

static uint32_t
get32(const unsigned char *at)
{
	return get16(at) | (uint32_t)get16(at + 2) << 16;
}

static enum tcs_status
damaged(uint64_t at, const char *what, struct tcs_fault *fault)
{
	return fault_set(
		fault, TCS_BAD_INPUT, at, "a damaged zip archive: %s", what);
}

bool
zip_is(const char *bytes, size_t length)
{
	return length >= 4 && !memcmp(bytes, "PK\3\4", 4);
}

/* The directory, from the record at the end of the archive. */
static enum tcs_status
directory_find(struct archive *archive, struct tcs_fault *fault)
{
	size_t length = archive->length, at, lowest, size;
	const unsigned char *bytes = archive->bytes;

	if (length < TAIL)
		return damaged(length, "it has no directory", fault);
	lowest = length > TAIL + LONGEST_COMMENT
		? length - TAIL - LONGEST_COMMENT
		: 0;
	for (at = length - TAIL; memcmp(bytes + at, "PK\5\6", 4); at--)
		if (at == lowest)
			return damaged(length, "it has no directory", fault);
	size = get32(bytes + at + 12);
	archive->directory = get32(bytes + at + 16);
	if (archive->directory > at || size > at - archive->directory)
		return damaged(at, "its directory is not within it", fault);
	archive->directory_end = archive->directory + size;
	return TCS_OK;
}

/* The entry at `*at`, which moves to the next one. */
static enum tcs_status
entry_read(const struct archive *archive, size_t *at, struct member *out,
	struct tcs_fault *fault)
{
	const unsigned char *head = archive->bytes + *at;
	size_t left = archive->directory_end - *at, size;

	if (left < ENTRY_HEAD || memcmp(head, "PK\1\2", 4))
		return damaged(*at, "its directory breaks off", fault);
	out->flags = get16(head + 8);
	out->method = get16(head + 10);
	out->crc = get32(head + 16);
	out->packed = get32(head + 20);
	out->unpacked = get32(head + 24);
	out->local = get32(head + 42);
	out->name = head + ENTRY_HEAD;
	out->name_length = get16(head + 28);
	size = out->name_length + get16(head + 30) + get16(head + 32);
	if (size > left - ENTRY_HEAD)
		return damaged(*at, "its directory breaks off", fault);
	*at += ENTRY_HEAD + size;
	return TCS_OK;
}

static bool
name_ends_in(const struct member *member, const char *suffix)
{
	size_t length = strlen(suffix);
	const unsigned char *tail;

	if (member->name_length < length)
		return false;
	tail = member->name + member->name_length - length;
	for (size_t i = 0; i < length; i++) {
		char byte = (char)tail[i];

		if (byte >= 'A' && byte <= 'Z')
			byte = (char)(byte - 'A' + 'a');
		if (byte != suffix[i])
			return false;
	}
	return true;
}

static bool
is_building(const struct member *member)
{
	return name_ends_in(member, ".ifc") || name_ends_in(member, ".ifcxml");
}

/* The packed bytes of a member, from its local header. */
static enum tcs_status
member_bytes(const struct archive *archive, const struct member *member,
	const unsigned char **out, struct tcs_fault *fault)
{
	size_t at = member->local, left, skip;
	const unsigned char *head = archive->bytes + at;

	if (at > archive->length || archive->length - at < LOCAL_HEAD ||
		memcmp(head, "PK\3\4", 4))
		return damaged(at, "a member is not within it", fault);
	left = archive->length - at - LOCAL_HEAD;
	skip = (size_t)get16(head + 26) + get16(head + 28);
	if (skip > left || member->packed > left - skip)
		return damaged(at, "a member is not within it", fault);
	*out = head + LOCAL_HEAD + skip;
	return TCS_OK;
}

static enum tcs_status
limit_check(const struct step_bytes *out, uint64_t max_bytes,
	struct tcs_fault *fault)
{
	if (max_bytes && out->count > max_bytes)
		return fault_set(fault, TCS_LIMIT, TCS_NOWHERE,
			"the archive unpacks to more than the limit");
	return TCS_OK;
}

static enum tcs_status
inflate_all(z_stream *stream, const struct member *member, uint64_t max_bytes,
	struct step_bytes *out, struct tcs_fault *fault)
{
	size_t left = member->packed;
	int result = Z_OK;

	while (result != Z_STREAM_END) {
		enum tcs_status status = limit_check(out, max_bytes, fault);
		uInt room, piece;

		if (status)
			return status;
		if (array_grow(out, PIECE))
			return fault_memory(fault);
		room = out->room - out->count > PIECE * 16
			? PIECE * 16
			: (uInt)(out->room - out->count);
		piece = left > UINT32_MAX / 2 ? UINT32_MAX / 2 : (uInt)left;
		stream->avail_in = piece;
		stream->next_out = (unsigned char *)out->at + out->count;
		stream->avail_out = room;
		result = inflate(stream, Z_NO_FLUSH);
		left -= piece - stream->avail_in;
		out->count += room - stream->avail_out;
		if (result == Z_MEM_ERROR)
			return fault_memory(fault);
		if (result != Z_OK && result != Z_STREAM_END)
			return damaged(member->local,
				"a member does not unpack", fault);
	}
	return limit_check(out, max_bytes, fault);
}

static enum tcs_status
member_inflate(const unsigned char *packed, const struct member *member,
	uint64_t max_bytes, struct step_bytes *out, struct tcs_fault *fault)
{
	z_stream stream = {.next_in = (z_const Bytef *)(uintptr_t)packed};
	enum tcs_status status;

	if (inflateInit2(&stream, -MAX_WBITS) != Z_OK)
		return fault_memory(fault);
	status = inflate_all(&stream, member, max_bytes, out, fault);
	inflateEnd(&stream);
	return status;
}

static enum tcs_status
member_copy(const unsigned char *packed, const struct member *member,
	uint64_t max_bytes, struct step_bytes *out, struct tcs_fault *fault)
{
	/* Room behind it, so that there is some for an empty member, too. */
	if (array_grow(out, (size_t)member->packed + 1))
		return fault_memory(fault);
	if (member->packed)
		memcpy(out->at + out->count, packed, member->packed);
	out->count += member->packed;
	return limit_check(out, max_bytes, fault);
}

static enum tcs_status
member_unpack(const struct archive *archive, const struct member *member,
	uint64_t max_bytes, struct step_bytes *out, struct tcs_fault *fault)
{
	const unsigned char *packed = NULL;
	size_t before = out->count;
	enum tcs_status status;

	status = member_bytes(archive, member, &packed, fault);
	if (status)
		return status;
	if (member->flags & 1 || (member->method && member->method != 8))
		return fault_set(fault, TCS_BAD_INPUT, member->local,
			"a zip archive that is encrypted or not deflated");
	if (member->method)
		status = member_inflate(packed, member, max_bytes, out, fault);
	else
		status = member_copy(packed, member, max_bytes, out, fault);
	if (status)
		return status;
	if (out->count - before != member->unpacked ||
		crc32_z(0, (unsigned char *)out->at + before,
			out->count - before) != member->crc)
		return damaged(member->local, "a checksum differs", fault);
	return TCS_OK;
}

enum tcs_status
zip_member(const char *bytes, size_t length, uint64_t max_bytes,
	struct step_bytes *out, struct tcs_fault *fault)
{
	struct archive archive = {(const unsigned char *)bytes, length, 0, 0};
	enum tcs_status status = directory_find(&archive, fault);
	size_t at = archive.directory;
	struct member member = {.flags = 0};

	while (!status && at < archive.directory_end) {
		status = entry_read(&archive, &at, &member, fault);
		if (!status && is_building(&member))
			return member_unpack(
				&archive, &member, max_bytes, out, fault);
	}
	if (status)
		return status;
	return fault_set(fault, TCS_BAD_INPUT, 0,
		"a zip archive without a member that ends in .ifc or .ifcxml");
}
