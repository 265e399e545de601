#include "input.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include <zlib.h>

#include "check.h"

enum { PLAIN = 700000, PADDING = 512 };

static char name[] = "/tmp/tessera-input-XXXXXX";
static unsigned char plain[PLAIN];
static unsigned char packed[PLAIN + 1000];
static size_t packed_length;

/* Text that compresses, but not to nothing. */
static void
prepare(void)
{
	z_stream stream = {0};
	unsigned noise = 1;

	for (size_t i = 0; i < PLAIN; i++) {
		noise = noise * 1103515245U + 12345U;
		plain[i] = (unsigned char)('a' + (noise >> 20) % 16);
	}
	deflateInit2(&stream, 6, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY);
	stream.next_in = plain;
	stream.avail_in = PLAIN;
	stream.next_out = packed;
	stream.avail_out = sizeof packed;
	CHECK(deflate(&stream, Z_FINISH) == Z_STREAM_END);
	packed_length = stream.total_out;
	deflateEnd(&stream);
}

/* The file at `name`, made of one or two pieces. */
static void
store(const void *a, size_t a_length, const void *b, size_t b_length)
{
	FILE *file = fopen(name, "wb");

	CHECK(file && fwrite(a, 1, a_length, file) == a_length);
	CHECK(!b || fwrite(b, 1, b_length, file) == b_length);
	fclose(file);
}

/* Read all in pieces of `room`; the bytes read in *length. */
static enum tcs_status
read_all(struct input *input, size_t room, unsigned char *into, size_t *length,
	struct tcs_fault *fault)
{
	enum tcs_status status;
	size_t got;

	*length = 0;
	do {
		status = input_read(input, into + *length, room, &got, fault);
		*length += got;
	} while (!status && got);
	return status;
}

static enum tcs_status
read_file(size_t room, unsigned char *into, size_t *length,
	struct tcs_fault *fault)
{
	struct input input;
	enum tcs_status status = input_open(&input, name, fault);

	*length = 0;
	if (!status)
		status = read_all(&input, room, into, length, fault);
	input_close(&input);
	return status;
}

static unsigned char arrived[3 * PLAIN];

static void
check_reads_plain(size_t room)
{
	struct tcs_fault fault;
	size_t length;

	CHECK(!read_file(room, arrived, &length, &fault));
	CHECK(length == PLAIN && !memcmp(arrived, plain, PLAIN));
}

static void
gzip_and_plain_read_the_same_in_any_pieces(void)
{
	static const size_t rooms[] = {1, 7, 4096, PLAIN};

	for (size_t i = 0; i < sizeof rooms / sizeof *rooms; i++) {
		store(plain, PLAIN, NULL, 0);
		check_reads_plain(rooms[i]);
		store(packed, packed_length, NULL, 0);
		check_reads_plain(rooms[i]);
	}
}

static void
members_follow_each_other(void)
{
	struct tcs_fault fault;
	size_t length;

	store(packed, packed_length, packed, packed_length);
	CHECK(!read_file(65536, arrived, &length, &fault));
	CHECK(length == 2 * (size_t)PLAIN);
	CHECK(!memcmp(arrived + PLAIN, plain, PLAIN));
}

static void
zeros_behind_gzip_are_padding_and_all_else_is_a_fault(void)
{
	static const unsigned char padding[PADDING];
	struct tcs_fault fault;
	size_t length;

	store(packed, packed_length, padding, PADDING);
	check_reads_plain(65536);
	store(packed, packed_length, "<x>", 3);
	CHECK(read_file(65536, arrived, &length, &fault) == TCS_BAD_INPUT);
	CHECK(fault.at == packed_length);
	store(packed, packed_length, "\x1f", 1);
	CHECK(read_file(65536, arrived, &length, &fault) == TCS_BAD_INPUT);
}

static void
every_cut_of_gzip_is_truncated(void)
{
	for (size_t cut = 2; cut < packed_length;
		cut += cut < 64 || cut + 64 > packed_length ? 1 : 40009) {
		struct tcs_fault fault;
		size_t length;

		store(packed, cut, NULL, 0);
		CHECK(read_file(65536, arrived, &length, &fault) ==
			TCS_TRUNCATED);
		CHECK(fault.at == cut);
	}
}

static void
a_changed_byte_is_noticed(void)
{
	struct tcs_fault fault;
	size_t length;

	for (size_t back = 1; back <= 8; back++) {
		packed[packed_length - back] ^= 0x10;
		store(packed, packed_length, NULL, 0);
		packed[packed_length - back] ^= 0x10;
		CHECK(read_file(65536, arrived, &length, &fault) ==
			TCS_BAD_INPUT);
	}
	packed[packed_length / 2] ^= 0x10;
	store(packed, packed_length, NULL, 0);
	packed[packed_length / 2] ^= 0x10;
	CHECK(read_file(65536, arrived, &length, &fault) == TCS_BAD_INPUT);
}

static void
an_empty_file_and_a_single_byte_are_plain(void)
{
	struct tcs_fault fault;
	size_t length;

	store("", 0, NULL, 0);
	CHECK(!read_file(64, arrived, &length, &fault) && length == 0);
	store("\x1f", 1, NULL, 0);
	CHECK(!read_file(64, arrived, &length, &fault) && length == 1);
}

static void
a_file_reads_twice_and_knows_its_size(void)
{
	struct input input;
	struct tcs_fault fault;
	size_t length;

	store(packed, packed_length, NULL, 0);
	CHECK(!input_open(&input, name, &fault));
	CHECK(input.can_rewind && input.size == packed_length);
	CHECK(!input_read(&input, arrived, 100000, &length, &fault));
	CHECK(!input_rewind(&input, &fault) && input.at == 0);
	CHECK(!read_all(&input, 4096, arrived, &length, &fault));
	CHECK(length == PLAIN && !memcmp(arrived, plain, PLAIN));
	CHECK(input_consumed(&input) == packed_length && input.at == PLAIN);
	input_close(&input);
}

static void
reading_goes_on_anywhere(void)
{
	static const size_t places[] = {0, PLAIN - 7, 300000, 299990, 12};
	struct input input;
	struct tcs_fault fault;
	size_t length;

	for (int i = 0; i < 2; i++) {
		store(i ? packed : plain, i ? packed_length : PLAIN, NULL, 0);
		CHECK(!input_open(&input, name, &fault));
		for (size_t k = 0; k < sizeof places / sizeof *places; k++) {
			size_t at = places[k];

			CHECK(!input_seek(&input, at, &fault));
			CHECK(input.at == at);
			CHECK(!input_read(&input, arrived, 5, &length, &fault));
			CHECK(length && !memcmp(arrived, plain + at, length));
		}
		CHECK(!input_rewind(&input, &fault));
		CHECK(!read_all(&input, 4096, arrived, &length, &fault));
		CHECK(length == PLAIN && !memcmp(arrived, plain, PLAIN));
		input_close(&input);
	}
}

static void
a_limit_counts_what_is_delivered(void)
{
	struct input input;
	struct tcs_fault fault;
	size_t length;

	store(packed, packed_length, NULL, 0);
	CHECK(!input_open(&input, name, &fault));
	input.max_bytes = PLAIN;
	CHECK(!read_all(&input, 4096, arrived, &length, &fault));
	CHECK(!input_rewind(&input, &fault));
	input.max_bytes = PLAIN - 1;
	CHECK(read_all(&input, 4096, arrived, &length, &fault) == TCS_LIMIT);
	input_close(&input);
}

static void
standard_input_may_be_a_pipe(void)
{
	struct input input;
	struct tcs_fault fault;
	int ends[2], before = dup(STDIN_FILENO);
	size_t length;

	CHECK(!pipe(ends));
	dup2(ends[0], STDIN_FILENO);
	CHECK(write(ends[1], "wall", 4) == 4);
	close(ends[0]);
	close(ends[1]);
	CHECK(!input_open(&input, NULL, &fault));
	CHECK(!input.can_rewind && input.size == 0);
	CHECK(!read_all(&input, 3, arrived, &length, &fault));
	CHECK(length == 4 && !memcmp(arrived, "wall", 4));
	CHECK(input_rewind(&input, &fault) == TCS_SYSTEM);
	input_close(&input);
	dup2(before, STDIN_FILENO);
	close(before);
}

static void
what_cannot_be_read_says_why(void)
{
	struct input input;
	struct tcs_fault fault;

	CHECK(input_open(&input, "/nowhere/at/all", &fault) == TCS_SYSTEM);
	CHECK(strstr(fault.text, "cannot read /nowhere/at/all: ") != NULL);
	CHECK(input_open(&input, "/tmp", &fault) == TCS_SYSTEM);
	CHECK(strstr(fault.text, "directory") != NULL);
	input_close(&input);
}

static const struct check_test tests[] = {
	CHECK_TEST(gzip_and_plain_read_the_same_in_any_pieces),
	CHECK_TEST(members_follow_each_other),
	CHECK_TEST(zeros_behind_gzip_are_padding_and_all_else_is_a_fault),
	CHECK_TEST(every_cut_of_gzip_is_truncated),
	CHECK_TEST(a_changed_byte_is_noticed),
	CHECK_TEST(an_empty_file_and_a_single_byte_are_plain),
	CHECK_TEST(a_file_reads_twice_and_knows_its_size),
	CHECK_TEST(reading_goes_on_anywhere),
	CHECK_TEST(a_limit_counts_what_is_delivered),
	CHECK_TEST(standard_input_may_be_a_pipe),
	CHECK_TEST(what_cannot_be_read_says_why),
	{0},
};

int
main(void)
{
	int result;

	close(mkstemp(name));
	prepare();
	result = check_run(tests);
	unlink(name);
	return result;
}
