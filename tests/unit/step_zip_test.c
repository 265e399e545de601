#include "parsers/step_zip.h"

#include <stdlib.h>
#include <string.h>
#include <zlib.h>

#include "check.h"

static const char model[] = "ISO-10303-21;HEADER;ENDSEC;DATA;ENDSEC;"
			    "END-ISO-10303-21;\n";

/* An archive of one member, made by hand. */
struct archive {
	unsigned char bytes[1024];
	size_t count, directory;
};

static void
put(struct archive *archive, uint32_t value, int bytes)
{
	for (int i = 0; i < bytes; i++)
		archive->bytes[archive->count++] =
			(unsigned char)(value >> 8 * i);
}

static void
put_bytes(struct archive *archive, const void *bytes, size_t count)
{
	memcpy(archive->bytes + archive->count, bytes, count);
	archive->count += count;
}

static size_t
pack(unsigned char *out, size_t room, bool deflated)
{
	z_stream stream = {.avail_out = (uInt)room};

	if (!deflated) {
		memcpy(out, model, sizeof model - 1);
		return sizeof model - 1;
	}
	if (deflateInit2(&stream, 9, Z_DEFLATED, -MAX_WBITS, 8, 0) != Z_OK)
		abort();
	stream.next_in = (z_const Bytef *)(uintptr_t)model;
	stream.avail_in = sizeof model - 1;
	stream.next_out = out;
	if (deflate(&stream, Z_FINISH) != Z_STREAM_END)
		abort();
	deflateEnd(&stream);
	return room - stream.avail_out;
}

/* What the local header and the directory both say. */
static void
put_facts(
	struct archive *archive, const char *name, size_t packed, bool deflated)
{
	uint32_t crc =
		(uint32_t)crc32_z(0, (const Bytef *)model, sizeof model - 1);

	put(archive, 20, 2);
	put(archive, 0, 2);
	put(archive, deflated ? 8 : 0, 2);
	put(archive, 0, 4);
	put(archive, crc, 4);
	put(archive, (uint32_t)packed, 4);
	put(archive, sizeof model - 1, 4);
	put(archive, (uint32_t)strlen(name), 2);
	put(archive, 0, 2);
}

static void
archive_make(struct archive *archive, const char *name, bool deflated)
{
	unsigned char packed[512];
	size_t size = pack(packed, sizeof packed, deflated);

	*archive = (struct archive){.count = 0};
	put_bytes(archive, "PK\3\4", 4);
	put_facts(archive, name, size, deflated);
	put_bytes(archive, name, strlen(name));
	put_bytes(archive, packed, size);
	archive->directory = archive->count;
	put_bytes(archive, "PK\1\2", 4);
	put(archive, 20, 2);
	put_facts(archive, name, size, deflated);
	put_bytes(archive, (char[14]){0}, 14);
	put_bytes(archive, name, strlen(name));
	size = archive->count - archive->directory;
	put_bytes(archive, "PK\5\6", 4);
	put(archive, 0, 4);
	put(archive, 1, 2);
	put(archive, 1, 2);
	put(archive, (uint32_t)size, 4);
	put(archive, (uint32_t)archive->directory, 4);
	put(archive, 0, 2);
}

/* Over a copy that ends where its memory does. */
static enum tcs_status
unpack(const struct archive *archive, size_t length, uint64_t max_bytes,
	struct step_bytes *out)
{
	char *bytes = malloc(length ? length : 1);
	struct tcs_fault fault;
	enum tcs_status status;

	if (!bytes)
		abort();
	memcpy(bytes, archive->bytes, length);
	array_release(out);
	status = zip_member(bytes, length, max_bytes, out, &fault);
	free(bytes);
	return status;
}

static void
members_stored_and_deflated_are_unpacked(void)
{
	struct step_bytes out = {.count = 0};
	struct archive archive;

	for (int deflated = 0; deflated < 2; deflated++) {
		archive_make(&archive, "Folder/House.IFC", deflated);
		CHECK(zip_is((char *)archive.bytes, archive.count));
		CHECK(unpack(&archive, archive.count, 0, &out) == TCS_OK);
		CHECK(out.count == sizeof model - 1);
		CHECK(!memcmp(out.at, model, out.count));
	}
	array_release(&out);
}

static void
another_member_is_not_taken(void)
{
	struct step_bytes out = {.count = 0};
	struct archive archive;

	archive_make(&archive, "house.xml", true);
	CHECK(unpack(&archive, archive.count, 0, &out) == TCS_BAD_INPUT);
	array_release(&out);
}

static void
every_prefix_is_damaged(void)
{
	struct step_bytes out = {.count = 0};
	struct archive archive;

	archive_make(&archive, "a.ifc", true);
	for (size_t length = 0; length < archive.count; length++)
		CHECK(unpack(&archive, length, 0, &out) == TCS_BAD_INPUT);
	array_release(&out);
}

static void
every_changed_byte_of_the_member_is_noticed(void)
{
	enum { FIRST = 30 + 5 };
	struct step_bytes out = {.count = 0};
	struct archive archive;

	for (int deflated = 0; deflated < 2; deflated++) {
		archive_make(&archive, "a.ifc", deflated);
		for (size_t i = FIRST; i < archive.directory; i++) {
			archive.bytes[i] ^= 0x20;
			CHECK(unpack(&archive, archive.count, 0, &out) ==
				TCS_BAD_INPUT);
			archive.bytes[i] ^= 0x20;
		}
	}
	array_release(&out);
}

static void
what_unpacks_to_more_than_the_limit_is_refused(void)
{
	struct step_bytes out = {.count = 0};
	struct archive archive;

	for (int deflated = 0; deflated < 2; deflated++) {
		archive_make(&archive, "a.ifc", deflated);
		CHECK(unpack(&archive, archive.count, sizeof model - 1, &out) ==
			TCS_OK);
		CHECK(unpack(&archive, archive.count, sizeof model - 2, &out) ==
			TCS_LIMIT);
	}
	array_release(&out);
}

static const struct check_test tests[] = {
	CHECK_TEST(members_stored_and_deflated_are_unpacked),
	CHECK_TEST(another_member_is_not_taken),
	CHECK_TEST(every_prefix_is_damaged),
	CHECK_TEST(every_changed_byte_of_the_member_is_noticed),
	CHECK_TEST(what_unpacks_to_more_than_the_limit_is_refused),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
