#include <assert.h>
#include <libdeflate.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

#include "tcs.h"
#include "tcs_codec.h"

#define CHUNK ((size_t)256 << 10) /* bytes read and summed at a time */
#define GATHERED ((size_t)64 << 10) /* bytes written at a time, at least */

/* As PNG's: a byte that is not ASCII, the name, line ends that a transfer in
 * text mode would damage, and the end of text for `type`. */
static const unsigned char magic[8] = {
	0x89, 'T', 'C', 'S', '\r', '\n', 0x1a, '\n'};

/* What a stream begins with. */
struct stream_head {
	unsigned char magic[8];
	uint32_t version;
	uint32_t reserved; /* 0 */
};

/* What a record begins with; the payload follows. */
struct record_head {
	uint32_t type;
	uint32_t flags;
	uint64_t stored; /* bytes of payload that follow */
	uint64_t length; /* bytes of payload when inflated */
	uint32_t reserved; /* 0 */
	uint32_t crc; /* of the 28 bytes before and the payload as stored */
};

_Static_assert(sizeof(struct stream_head) == 16, "stream head");
_Static_assert(sizeof(struct record_head) == 32, "record head");

#define SUMMED offsetof(struct record_head, crc)

/* What zlib's crc32 gives, several times faster. */
static uint32_t
sum(uint32_t crc, const void *bytes, size_t length)
{
	return length ? libdeflate_crc32(crc, bytes, length) : crc;
}

void
record_release(struct tcs_record *record)
{
	array_release(&record->bytes);
	array_release(&record->spare);
}

/* ---- reading --------------------------------------------------------- */

void
reader_init(struct tcs_reader *reader, FILE *file)
{
	*reader = (struct tcs_reader){
		.file = file,
		.max_record = TCS_MAX_RECORD,
	};
}

void
reader_release(struct tcs_reader *reader)
{
	array_release(&reader->packed);
}

enum tcs_status
reader_open(struct tcs_reader *reader, const char *name, uint64_t max_record,
	struct tcs_fault *fault)
{
	FILE *file = name ? fopen(name, "rb") : stdin;

	if (!file)
		return fault_system(fault, "cannot read", name);
	reader_init(reader, file);
	reader->max_record = max_record;
	return TCS_OK;
}

void
reader_close(struct tcs_reader *reader)
{
	reader_release(reader);
	if (reader->file && reader->file != stdin)
		fclose(reader->file);
	reader->file = NULL;
}

/* Read exactly `length` bytes. */
static enum tcs_status
read_exactly(struct tcs_reader *reader, void *bytes, size_t length,
	struct tcs_fault *fault)
{
	size_t got = fread(bytes, 1, length, reader->file);

	reader->at += got;
	if (got == length)
		return TCS_OK;
	if (ferror(reader->file))
		return fault_system(fault, "cannot read", "the stream");
	return fault_set(fault, TCS_TRUNCATED, reader->at,
		"the stream stops without its end record");
}

static enum tcs_status
read_stream_head(struct tcs_reader *reader, struct tcs_fault *fault)
{
	struct stream_head head;
	enum tcs_status status = read_exactly(reader, &head, 8, fault);

	if (status == TCS_TRUNCATED && !reader->at)
		return fault_set(fault, status, 0, "the stream is empty");
	if ((!status || status == TCS_TRUNCATED) &&
		memcmp(head.magic, magic, (size_t)reader->at))
		return fault_set(
			fault, TCS_BAD_INPUT, 0, "this is no component stream");
	if (status)
		return status;
	status =
		read_exactly(reader, (char *)&head + 8, sizeof head - 8, fault);
	if (status)
		return status;
	if (head.version != TCS_VERSION || head.reserved)
		return fault_set(fault, TCS_BAD_INPUT, 8,
			"the stream is of version %u; this program reads %d",
			head.version, TCS_VERSION);
	return TCS_OK;
}

/* Whether the head of a record can be one, before its sum is known. */
static enum tcs_status
check_record_head(const struct tcs_reader *reader,
	const struct record_head *head, uint64_t at, struct tcs_fault *fault)
{
	bool packed = head->flags & TCS_RECORD_COMPRESSED;

	if (head->flags & ~(uint32_t)TCS_RECORD_COMPRESSED || head->reserved ||
		head->stored % 8 || head->length % 8 ||
		(packed ? !head->stored : head->stored != head->length))
		return fault_set(fault, TCS_BAD_INPUT, at,
			"a record's head is damaged or of a newer version");
	if (head->stored > reader->max_record ||
		head->length > reader->max_record)
		return fault_set(fault, TCS_LIMIT, at,
			"a record of %llu bytes exceeds the limit of %llu",
			(unsigned long long)head->length,
			(unsigned long long)reader->max_record);
	if (!reader->began != (head->type == TCS_HEAD))
		return fault_set(fault, TCS_BAD_INPUT, at,
			reader->began
				? "the stream has a second head"
				: "the stream does not begin with a head");
	return TCS_OK;
}

/* Read a payload in chunks, summing each while the cache holds it. */
static enum tcs_status
read_payload(struct tcs_reader *reader, struct tcs_array *bytes,
	uint64_t length, uint32_t *crc, struct tcs_fault *fault)
{
	bytes->count = 0;
	while (length) {
		size_t want = length < CHUNK ? (size_t)length : CHUNK;
		unsigned char *at;
		enum tcs_status status;

		if (array_grow_bytes(bytes, 1, want))
			return fault_memory(fault);
		at = (unsigned char *)bytes->at + bytes->count;
		status = read_exactly(reader, at, want, fault);
		if (status)
			return status;
		*crc = sum(*crc, at, want);
		bytes->count += want;
		length -= want;
	}
	return TCS_OK;
}

/* Inflate `packed` into `bytes`, which must come to `length`. */
static enum tcs_status
inflate_all(z_stream *z, const struct tcs_array *packed,
	struct tcs_array *bytes, uint64_t length, struct tcs_fault *fault)
{
	size_t taken = 0;
	int result = Z_OK;

	bytes->count = 0;
	while (result == Z_OK) {
		uint64_t left = length - bytes->count;
		/* one byte more than is due tells a payload that is longer */
		size_t room = left < CHUNK ? (size_t)left + 1 : CHUNK;
		size_t give = packed->count - taken;

		if (array_grow_bytes(bytes, 1, room))
			return fault_memory(fault);
		give = give < CHUNK ? give : CHUNK;
		z->next_in = (unsigned char *)packed->at + taken;
		z->avail_in = (uInt)give;
		z->next_out = (unsigned char *)bytes->at + bytes->count;
		z->avail_out = (uInt)room;
		result = inflate(z, Z_NO_FLUSH);
		taken += give - z->avail_in;
		bytes->count += room - z->avail_out;
		if (bytes->count > length)
			return TCS_BAD_INPUT;
	}
	if (result == Z_MEM_ERROR)
		return fault_memory(fault);
	if (result != Z_STREAM_END || bytes->count != length ||
		section_padded(taken) != packed->count)
		return TCS_BAD_INPUT;
	return TCS_OK;
}

static enum tcs_status
inflate_payload(struct tcs_reader *reader, struct tcs_array *bytes,
	uint64_t length, uint64_t at, struct tcs_fault *fault)
{
	struct tcs_array packed;
	z_stream z = {0};
	enum tcs_status status;

	memcpy(&packed, &reader->packed, sizeof packed);
	if (inflateInit(&z) != Z_OK)
		return fault_memory(fault);
	status = inflate_all(&z, &packed, bytes, length, fault);
	inflateEnd(&z);
	if (status == TCS_BAD_INPUT)
		fault_set(fault, status, at,
			"a compressed record does not inflate to its length");
	return status;
}

static enum tcs_status
read_record(struct tcs_reader *reader, const struct record_head *head,
	struct tcs_record *record, struct tcs_fault *fault)
{
	bool packed = head->flags & TCS_RECORD_COMPRESSED;
	void *into = packed ? (void *)&reader->packed : (void *)&record->bytes;
	uint32_t crc = sum(0, head, SUMMED);
	struct tcs_array bytes;
	enum tcs_status status;

	memcpy(&bytes, into, sizeof bytes);
	status = read_payload(reader, &bytes, head->stored, &crc, fault);
	memcpy(into, &bytes, sizeof bytes);
	if (status)
		return status;
	if (crc != head->crc)
		return fault_set(fault, TCS_BAD_INPUT, record->at,
			"a record is damaged: its checksum is wrong");
	if (!packed)
		return TCS_OK;
	memcpy(&bytes, &record->bytes, sizeof bytes);
	status = inflate_payload(
		reader, &bytes, head->length, record->at, fault);
	memcpy(&record->bytes, &bytes, sizeof bytes);
	return status;
}

/* The end record agrees with what passed, and nothing follows it. */
static enum tcs_status
check_end(struct tcs_reader *reader, const struct tcs_record *record,
	struct tcs_fault *fault)
{
	struct tcs_end end = {0};
	enum tcs_status status =
		record_decode(&end, &layout_end, record, fault);

	if (status)
		return status;
	if (end.tallies.count != 1 ||
		memcmp(end.tallies.at, &reader->tally, sizeof reader->tally))
		return fault_set(fault, TCS_BAD_INPUT, record->at,
			"the end record does not count what passed");
	if (getc(reader->file) != EOF)
		return fault_set(fault, TCS_BAD_INPUT, reader->at,
			"something follows the end record");
	if (ferror(reader->file))
		return fault_system(fault, "cannot read", "the stream");
	reader->ended = true;
	return TCS_OK;
}

enum tcs_status
reader_next(struct tcs_reader *reader, struct tcs_record *record,
	struct tcs_fault *fault)
{
	struct record_head head;
	enum tcs_status status = TCS_OK;

	assert(!reader->ended);
	if (!reader->at)
		status = read_stream_head(reader, fault);
	if (status)
		return status;
	record->at = reader->at;
	status = read_exactly(reader, &head, sizeof head, fault);
	if (!status)
		status = check_record_head(reader, &head, record->at, fault);
	if (!status)
		status = read_record(reader, &head, record, fault);
	if (status)
		return status;
	reader->began = true;
	record->type = head.type;
	record->before = reader->tally;
	if (head.type == TCS_END)
		return check_end(reader, record, fault);
	return tally_add(&reader->tally, record, fault);
}

/* ---- writing --------------------------------------------------------- */

void
writer_init(struct tcs_writer *writer, FILE *file, int level)
{
	*writer = (struct tcs_writer){.file = file, .level = level};
}

/* What is left here is of a stream that breaks off anyway. */
void
writer_release(struct tcs_writer *writer)
{
	if (writer->gathered.count)
		fwrite(writer->gathered.at, 1, writer->gathered.count,
			writer->file);
	array_release(&writer->packed);
	array_release(&writer->gathered);
}

static enum tcs_status
write_now(struct tcs_writer *writer, const void *bytes, size_t length,
	struct tcs_fault *fault)
{
	if (length && fwrite(bytes, 1, length, writer->file) != length)
		return fault_system(fault, "cannot write", "the stream");
	return TCS_OK;
}

/* stdio's own buffer takes 4 KB at a time, whatever setvbuf says of its size. */
static enum tcs_status
write_gathered(struct tcs_writer *writer, struct tcs_fault *fault)
{
	size_t length = writer->gathered.count;

	writer->gathered.count = 0;
	return write_now(writer, writer->gathered.at, length, fault);
}

static enum tcs_status
write_exactly(struct tcs_writer *writer, const void *bytes, size_t length,
	struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	writer->at += length;
	if (writer->gathered.count + length > GATHERED)
		status = write_gathered(writer, fault);
	if (status || length >= GATHERED)
		return status ? status
			      : write_now(writer, bytes, length, fault);
	if (array_grow(&writer->gathered, length))
		return fault_memory(fault);
	if (length)
		memcpy(writer->gathered.at + writer->gathered.count, bytes,
			length);
	writer->gathered.count += length;
	return TCS_OK;
}

static enum tcs_status
write_stream_head(struct tcs_writer *writer, struct tcs_fault *fault)
{
	struct stream_head head = {.version = TCS_VERSION};

	memcpy(head.magic, magic, sizeof magic);
	return write_exactly(writer, &head, sizeof head, fault);
}

/*
 * Compress the payload into writer->packed, zero-padded; leave that empty
 * where it saves nothing.
 */
static enum tcs_status
pack_payload(struct tcs_writer *writer, const struct tcs_record *record,
	struct tcs_fault *fault)
{
	uLong length = record->bytes.count, bound = compressBound(length);
	uint64_t padded;

	array_clear(&writer->packed);
	if (!writer->level || !length)
		return TCS_OK;
	if (array_grow(&writer->packed, bound + 8))
		return fault_memory(fault);
	if (compress2(writer->packed.at, &bound, record->bytes.at, length,
		    writer->level) != Z_OK)
		return fault_memory(fault);
	padded = section_padded(bound);
	if (padded >= length)
		return TCS_OK;
	memset(writer->packed.at + bound, 0, padded - bound);
	writer->packed.count = padded;
	return TCS_OK;
}

static enum tcs_status
write_record(struct tcs_writer *writer, const struct tcs_record *record,
	struct tcs_fault *fault)
{
	struct record_head head = {
		.type = record->type,
		.stored = record->bytes.count,
		.length = record->bytes.count,
	};
	const unsigned char *payload = record->bytes.at;
	enum tcs_status status = pack_payload(writer, record, fault);

	if (status)
		return status;
	if (writer->packed.count) {
		head.flags = TCS_RECORD_COMPRESSED;
		head.stored = writer->packed.count;
		payload = writer->packed.at;
	}
	head.crc = sum(sum(0, &head, SUMMED), payload, head.stored);
	status = write_exactly(writer, &head, sizeof head, fault);
	if (!status)
		status = write_exactly(writer, payload, head.stored, fault);
	return status;
}

/* The head first and once, the end by writer_end, eights of bytes. */
static enum tcs_status
check_place(const struct tcs_writer *writer, const struct tcs_record *record,
	struct tcs_fault *fault)
{
	const char *what = NULL;

	if (!writer->at && record->type != TCS_HEAD)
		what = "the stream does not begin with a head";
	else if (writer->at && record->type == TCS_HEAD)
		what = "the stream has a second head";
	else if (record->type == TCS_END)
		what = "the end record is no record to pass on";
	else if (record->bytes.count % 8)
		what = "a record's length is no multiple of 8";
	return what ? fault_set(fault, TCS_BAD_INPUT, TCS_NOWHERE, "%s", what)
		    : TCS_OK;
}

enum tcs_status
writer_put(struct tcs_writer *writer, const struct tcs_record *record,
	struct tcs_fault *fault)
{
	enum tcs_status status = check_place(writer, record, fault);

	if (status)
		return status;
	status = tally_add(&writer->tally, record, fault);
	if (!status && !writer->at)
		status = write_stream_head(writer, fault);
	if (!status)
		status = write_record(writer, record, fault);
	return status;
}

enum tcs_status
writer_end(struct tcs_writer *writer, struct tcs_fault *fault)
{
	struct tcs_end end = {.tallies = {&writer->tally, 1, 0}};
	struct tcs_record record = {.type = TCS_END};
	enum tcs_status status =
		record_encode(&end, &layout_end, &record, fault);

	if (!status && !writer->at)
		status = fault_set(fault, TCS_BAD_INPUT, TCS_NOWHERE,
			"a stream has a head before its end");
	if (!status)
		status = write_record(writer, &record, fault);
	record_release(&record);
	if (!status)
		status = write_gathered(writer, fault);
	if (!status && fflush(writer->file))
		status = fault_system(fault, "cannot write", "the stream");
	return status;
}
