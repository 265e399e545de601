#include "check.h"
#include "town_sample.h"

/* A stream in memory. */
struct bytes {
	char *at;
	size_t length;
};

static struct bytes
stream_of(int level)
{
	struct bytes bytes = {0};
	FILE *file = open_memstream(&bytes.at, &bytes.length);

	if (!file)
		abort();
	sample_stream(file, level);
	fclose(file);
	return bytes;
}

/* Read and decode everything; the records written again go to `copy`. */
static enum tcs_status
pass_on(const void *bytes, size_t length, FILE *copy, struct tcs_fault *fault)
{
	FILE *file = length ? fmemopen((void *)(size_t)bytes, length, "rb")
			    : fopen("/dev/null", "rb");
	struct tcs_reader reader;
	struct tcs_writer writer;
	struct tcs_record record = {0};
	struct tcs_head head = {0};
	struct tcs_palette palette = {0};
	struct tcs_object object = {0};
	enum tcs_status status = TCS_OK;

	if (!file)
		abort();
	reader_init(&reader, file);
	if (copy)
		writer_init(&writer, copy, 0);
	while (!status) {
		status = reader_next(&reader, &record, fault);
		if (status || reader.ended)
			break;
		switch (record.type) {
		case TCS_HEAD:
			status = head_decode(&head, &record, fault);
			if (!status && copy)
				status = head_encode(&head, &record, fault);
			break;
		case TCS_PALETTE:
			status = palette_decode(&palette, &record, fault);
			if (!status && copy)
				status = palette_encode(
					&palette, &record, fault);
			break;
		case TCS_OBJECT:
		case TCS_PROTOTYPE:
			status = object_decode(&object, &record, fault);
			if (!status && copy)
				status = object_encode(&object,
					(enum tcs_record_type)record.type,
					&record, fault);
			break;
		default:
			break;
		}
		if (!status && copy)
			status = writer_put(&writer, &record, fault);
	}
	if (!status && copy)
		status = writer_end(&writer, fault);
	if (copy)
		writer_release(&writer);
	reader_release(&reader);
	record_release(&record);
	head_release(&head);
	palette_release(&palette);
	object_release(&object);
	fclose(file);
	return status;
}

static void
reading_and_writing_again_changes_nothing(void)
{
	struct bytes bytes = stream_of(0), again = {0};
	FILE *copy = open_memstream(&again.at, &again.length);
	struct tcs_fault fault;

	CHECK(!pass_on(bytes.at, bytes.length, copy, &fault));
	fclose(copy);
	CHECK(bytes.length == again.length);
	CHECK(!memcmp(bytes.at, again.at, bytes.length));
	free(bytes.at);
	free(again.at);
}

static void
every_proper_prefix_is_truncated(void)
{
	for (int level = 0; level <= 9; level += 9) {
		struct bytes bytes = stream_of(level);
		size_t right = 0;

		for (size_t n = 0; n < bytes.length; n++) {
			struct tcs_fault fault;

			right += pass_on(bytes.at, n, NULL, &fault) ==
				TCS_TRUNCATED;
		}
		CHECK(right == bytes.length);
		free(bytes.at);
	}
}

static void
every_damaged_byte_is_noticed(void)
{
	for (int level = 0; level <= 9; level += 9) {
		struct bytes bytes = stream_of(level);
		struct tcs_fault fault;
		size_t noticed = 0;

		for (size_t i = 0; i < bytes.length; i++) {
			for (unsigned bit = 0; bit < 8; bit++) {
				bytes.at[i] ^= (char)(1u << bit);
				noticed += pass_on(bytes.at, bytes.length, NULL,
						   &fault) != TCS_OK;
				bytes.at[i] ^= (char)(1u << bit);
			}
		}
		CHECK(noticed == 8 * bytes.length);
		CHECK(!pass_on(bytes.at, bytes.length, NULL, &fault));
		free(bytes.at);
	}
}

static void
a_compressed_stream_is_smaller_and_means_the_same(void)
{
	struct bytes plain = stream_of(0), packed = stream_of(9), copy = {0};
	FILE *file = open_memstream(&copy.at, &copy.length);
	struct tcs_fault fault;

	CHECK(packed.length < plain.length);
	CHECK(!pass_on(packed.at, packed.length, file, &fault));
	fclose(file);
	CHECK(copy.length == plain.length);
	CHECK(!memcmp(copy.at, plain.at, plain.length));
	free(plain.at);
	free(packed.at);
	free(copy.at);
}

static void
nothing_may_follow_the_end(void)
{
	struct bytes bytes = stream_of(0);
	char *longer = malloc(bytes.length + 1);
	struct tcs_fault fault;

	if (!longer)
		abort();
	memcpy(longer, bytes.at, bytes.length);
	longer[bytes.length] = 0;
	CHECK(pass_on(longer, bytes.length + 1, NULL, &fault) == TCS_BAD_INPUT);
	CHECK(fault.at == bytes.length);
	free(longer);
	free(bytes.at);
}

/* Write the given records and read the stream back. */
static enum tcs_status
read_back(const struct tcs_record *const *records, size_t count,
	const struct tcs_tally *claimed, struct tcs_fault *fault)
{
	struct bytes bytes = {0};
	FILE *file = open_memstream(&bytes.at, &bytes.length);
	struct tcs_writer writer;
	enum tcs_status status = TCS_OK;

	writer_init(&writer, file, 0);
	for (size_t i = 0; !status && i < count; i++)
		status = writer_put(&writer, records[i], fault);
	if (claimed)
		writer.tally = *claimed;
	if (!status)
		status = writer_end(&writer, fault);
	writer_release(&writer);
	fclose(file);
	if (!status)
		status = pass_on(bytes.at, bytes.length, NULL, fault);
	free(bytes.at);
	return status;
}

static void
encode_sample(struct tcs_record *head, struct tcs_record *object)
{
	struct tcs_head source = {0};
	struct tcs_object prototype = {0};
	struct tcs_fault fault;

	sample_head(&source);
	sample_must(head_encode(&source, head, &fault), &fault);
	sample_prototype(&prototype);
	sample_must(
		object_encode(&prototype, TCS_OBJECT, object, &fault), &fault);
	head_release(&source);
	object_release(&prototype);
}

static void
the_head_comes_first_and_once(void)
{
	struct tcs_record head = {0}, object = {0};
	struct tcs_fault fault;

	encode_sample(&head, &object);
	{
		const struct tcs_record *good[] = {&head, &object};
		const struct tcs_record *twice[] = {&head, &object, &head};
		const struct tcs_record *late[] = {&object, &head};

		CHECK(!read_back(good, 2, NULL, &fault));
		CHECK(read_back(good, 1, NULL, &fault) == TCS_OK);
		CHECK(read_back(twice, 3, NULL, &fault) == TCS_BAD_INPUT);
		CHECK(read_back(late, 2, NULL, &fault) == TCS_BAD_INPUT);
		CHECK(read_back(NULL, 0, NULL, &fault) == TCS_BAD_INPUT);
	}
	record_release(&head);
	record_release(&object);
}

static void
an_end_that_counts_otherwise_is_refused(void)
{
	struct tcs_record head = {0}, object = {0};
	const struct tcs_record *records[] = {&head, &object};
	struct tcs_tally right = {
		.objects = 1, .features = 1, .polygons = 1, .triangles = 1};
	struct tcs_fault fault;

	encode_sample(&head, &object);
	CHECK(!read_back(records, 2, &right, &fault));
	right.triangles = 2;
	CHECK(read_back(records, 2, &right, &fault) == TCS_BAD_INPUT);
	CHECK(strstr(fault.text, "does not count"));
	record_release(&head);
	record_release(&object);
}

static void
the_tally_counts_every_kind(void)
{
	struct bytes bytes = stream_of(0);
	FILE *file = fmemopen(bytes.at, bytes.length, "rb");
	struct tcs_reader reader;
	struct tcs_record record = {0};
	struct tcs_fault fault;

	reader_init(&reader, file);
	while (!reader.ended && !reader_next(&reader, &record, &fault))
		;
	CHECK(reader.ended);
	CHECK(record.type == TCS_END);
	CHECK(reader.tally.objects == 2);
	CHECK(reader.tally.prototypes == 1);
	CHECK(reader.tally.images == 2);
	CHECK(reader.tally.materials == 1);
	CHECK(reader.tally.features == 7);
	CHECK(reader.tally.polygons == 7);
	CHECK(reader.tally.triangles == 9);
	CHECK(reader.tally.instances == 2);
	CHECK(reader.at == bytes.length);
	reader_release(&reader);
	record_release(&record);
	fclose(file);
	free(bytes.at);
}

/* Put the head of a record of our making behind a whole head record. */
static enum tcs_status
read_claim(uint64_t stored, uint64_t length, uint32_t flags, size_t *room,
	struct tcs_fault *fault)
{
	struct bytes bytes = stream_of(0);
	struct tcs_reader reader;
	struct tcs_record record = {0};
	uint32_t type = TCS_OBJECT;
	uint64_t head;
	FILE *file;
	enum tcs_status status;

	memcpy(&head, bytes.at + 16 + 8, sizeof head);
	head += 16 + 32;
	memcpy(bytes.at + head, &type, 4);
	memcpy(bytes.at + head + 4, &flags, 4);
	memcpy(bytes.at + head + 8, &stored, 8);
	memcpy(bytes.at + head + 16, &length, 8);
	file = fmemopen(bytes.at, bytes.length, "rb");
	reader_init(&reader, file);
	status = reader_next(&reader, &record, fault);
	CHECK(!status);
	status = reader_next(&reader, &record, fault);
	*room = record.bytes.room + reader.packed.room;
	reader_release(&reader);
	record_release(&record);
	fclose(file);
	free(bytes.at);
	return status;
}

static void
a_claimed_length_allocates_nothing(void)
{
	uint64_t four_gigabytes = (uint64_t)4 << 30;
	struct tcs_fault fault;
	size_t room;

	CHECK(read_claim(four_gigabytes, four_gigabytes, 0, &room, &fault) ==
		TCS_TRUNCATED);
	CHECK(room < 1 << 20);
	CHECK(read_claim(four_gigabytes, 64, TCS_RECORD_COMPRESSED, &room,
		      &fault) == TCS_TRUNCATED);
	CHECK(room < 1 << 20);
	CHECK(read_claim(UINT64_MAX - 7, UINT64_MAX - 7, 0, &room, &fault) ==
		TCS_LIMIT);
	CHECK(read_claim(64, 72, 0, &room, &fault) == TCS_BAD_INPUT);
	CHECK(read_claim(60, 60, 0, &room, &fault) == TCS_BAD_INPUT);
	CHECK(read_claim(64, 64, 2, &room, &fault) == TCS_BAD_INPUT);
}

static void
a_record_beyond_the_limit_is_refused(void)
{
	struct bytes bytes = stream_of(9);
	FILE *file = fmemopen(bytes.at, bytes.length, "rb");
	struct tcs_reader reader;
	struct tcs_record record = {0};
	struct tcs_fault fault;
	enum tcs_status status = TCS_OK;

	reader_init(&reader, file);
	reader.max_record = 256;
	while (!status && !reader.ended)
		status = reader_next(&reader, &record, &fault);
	CHECK(status == TCS_LIMIT);
	reader_release(&reader);
	record_release(&record);
	fclose(file);
	free(bytes.at);
}

static void
a_full_disk_is_noticed(void)
{
	FILE *file = fopen("/dev/full", "wb");
	struct tcs_record head = {0}, object = {0};
	struct tcs_writer writer;
	struct tcs_fault fault;
	enum tcs_status status;

	if (!file)
		return;
	encode_sample(&head, &object);
	writer_init(&writer, file, 0);
	status = writer_put(&writer, &head, &fault);
	if (!status)
		status = writer_end(&writer, &fault);
	CHECK(status == TCS_SYSTEM);
	CHECK(strstr(fault.text, "No space left"));
	writer_release(&writer);
	record_release(&head);
	record_release(&object);
	fclose(file);
}

static const struct check_test tests[] = {
	CHECK_TEST(reading_and_writing_again_changes_nothing),
	CHECK_TEST(every_proper_prefix_is_truncated),
	CHECK_TEST(every_damaged_byte_is_noticed),
	CHECK_TEST(a_compressed_stream_is_smaller_and_means_the_same),
	CHECK_TEST(nothing_may_follow_the_end),
	CHECK_TEST(the_head_comes_first_and_once),
	CHECK_TEST(an_end_that_counts_otherwise_is_refused),
	CHECK_TEST(the_tally_counts_every_kind),
	CHECK_TEST(a_claimed_length_allocates_nothing),
	CHECK_TEST(a_record_beyond_the_limit_is_refused),
	CHECK_TEST(a_full_disk_is_noticed),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
