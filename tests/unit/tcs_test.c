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

static const struct check_test tests[] = {
	CHECK_TEST(reading_and_writing_again_changes_nothing),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
