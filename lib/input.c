#include "input.h"

#include <errno.h>
#include <fcntl.h>
#include <inttypes.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

enum {
	STORED_ROOM = 256 * 1024,
	MAGIC_LENGTH = 2,
	WINDOW_BITS_GZIP = 15 + 16, /* as inflateInit2 wants it */
};

static const unsigned char gzip_magic[MAGIC_LENGTH] = {0x1f, 0x8b};

/* What is stored comes through `stored`; inflate eats it there. */
struct input_gz {
	z_stream inflate;
	off_t start; /* of the file, where reading began */
	uint64_t fetched; /* stored bytes read so far */
	int fd;
	bool packed; /* gzip, by its first bytes */
	bool in_member; /* inside a gzip member */
	bool ended; /* the file has no more bytes */
	unsigned char stored[STORED_ROOM];
};

static enum tcs_status
read_some(struct input *input, void *bytes, size_t room, size_t *got,
	struct tcs_fault *fault)
{
	struct input_gz *gz = input->gz;
	ssize_t count;

	do
		count = read(gz->fd, bytes, room);
	while (count < 0 && errno == EINTR);
	if (count < 0)
		return fault_system(fault, "cannot read", input->name);
	gz->ended = count == 0;
	gz->fetched += (uint64_t)count;
	*got = (size_t)count;
	return TCS_OK;
}

/* Have at least `want` stored bytes, fewer at the end of the file only. */
static enum tcs_status
fetch(struct input *input, size_t want, struct tcs_fault *fault)
{
	struct input_gz *gz = input->gz;

	if (gz->inflate.avail_in >= want)
		return TCS_OK;
	if (gz->inflate.avail_in)
		memmove(gz->stored, gz->inflate.next_in, gz->inflate.avail_in);
	gz->inflate.next_in = gz->stored;
	while (gz->inflate.avail_in < want && !gz->ended) {
		size_t have = gz->inflate.avail_in, got = 0;
		enum tcs_status status = read_some(input, gz->stored + have,
			STORED_ROOM - have, &got, fault);

		if (status)
			return status;
		gz->inflate.avail_in += (uInt)got;
	}
	return TCS_OK;
}

static bool
at_magic(const struct input_gz *gz)
{
	return gz->inflate.avail_in >= MAGIC_LENGTH &&
		!memcmp(gz->inflate.next_in, gzip_magic, MAGIC_LENGTH);
}

/* Look at the first bytes. */
static enum tcs_status
begin(struct input *input, struct tcs_fault *fault)
{
	struct input_gz *gz = input->gz;
	enum tcs_status status;

	gz->inflate.next_in = gz->stored;
	gz->inflate.avail_in = 0;
	gz->fetched = 0;
	gz->ended = gz->in_member = false;
	input->at = 0;
	status = fetch(input, MAGIC_LENGTH, fault);
	gz->packed = at_magic(gz);
	return status;
}

enum tcs_status
input_open(struct input *input, const char *name, struct tcs_fault *fault)
{
	bool is_file = name && strcmp(name, "-") != 0;
	struct input_gz *gz = calloc(1, sizeof *gz);
	struct stat there;
	enum tcs_status status = TCS_OK;

	*input = (struct input){.name = is_file ? name : "standard input"};
	if (!gz)
		return fault_memory(fault);
	input->gz = gz;
	gz->fd = is_file ? open(name, O_RDONLY | O_CLOEXEC) : STDIN_FILENO;
	if (gz->fd < 0 || fstat(gz->fd, &there)) {
		status = fault_system(fault, "cannot read", input->name);
	} else if (S_ISREG(there.st_mode)) {
		gz->start = lseek(gz->fd, 0, SEEK_CUR);
		input->can_rewind = gz->start >= 0;
		if (input->can_rewind && there.st_size > gz->start)
			input->size = (uint64_t)(there.st_size - gz->start);
	}
	if (!status && inflateInit2(&gz->inflate, WINDOW_BITS_GZIP) != Z_OK)
		status = fault_memory(fault);
	if (!status)
		status = begin(input, fault);
	if (status)
		input_close(input);
	return status;
}

static enum tcs_status
read_plain(struct input *input, void *bytes, size_t room, size_t *got,
	struct tcs_fault *fault)
{
	struct input_gz *gz = input->gz;
	size_t have = gz->inflate.avail_in;

	if (!have)
		return gz->ended ? TCS_OK
				 : read_some(input, bytes, room, got, fault);
	if (have > room)
		have = room;
	memcpy(bytes, gz->inflate.next_in, have);
	gz->inflate.next_in += have;
	gz->inflate.avail_in -= (uInt)have;
	*got = have;
	return TCS_OK;
}

/*
 * Between members: begin the next one, or set *end. Zeros behind the last
 * member are padding; anything else would be lost, so it fails.
 */
static enum tcs_status
next_member(struct input *input, bool *end, struct tcs_fault *fault)
{
	struct input_gz *gz = input->gz;
	enum tcs_status status = fetch(input, MAGIC_LENGTH, fault);

	if (status)
		return status;
	if (at_magic(gz)) {
		gz->in_member = true;
		return inflateReset(&gz->inflate) == Z_OK ? TCS_OK
							  : fault_memory(fault);
	}
	while (gz->inflate.avail_in) {
		if (*gz->inflate.next_in)
			return fault_set(fault, TCS_BAD_INPUT,
				input_consumed(input),
				"bytes that are no gzip data follow the gzip "
				"data");
		gz->inflate.next_in++;
		gz->inflate.avail_in--;
		status = fetch(input, 1, fault);
		if (status)
			return status;
	}
	*end = true;
	return TCS_OK;
}

static enum tcs_status
inflate_fault(struct input *input, int result, struct tcs_fault *fault)
{
	struct input_gz *gz = input->gz;

	if (result == Z_MEM_ERROR)
		return fault_memory(fault);
	return fault_set(fault, TCS_BAD_INPUT, input_consumed(input),
		"damaged gzip data: %s",
		result == Z_NEED_DICT	  ? "a dictionary is needed"
			: gz->inflate.msg ? gz->inflate.msg
					  : "no progress");
}

static enum tcs_status
read_packed(struct input *input, void *bytes, size_t room, size_t *got,
	struct tcs_fault *fault)
{
	struct input_gz *gz = input->gz;
	uInt size = room < UINT_MAX ? (uInt)room : UINT_MAX;
	enum tcs_status status;
	bool end = false;

	gz->inflate.next_out = bytes;
	gz->inflate.avail_out = size;
	while (gz->inflate.avail_out == size) {
		int result;

		if (!gz->in_member) {
			status = next_member(input, &end, fault);
			if (status || end)
				return status;
		}
		status = fetch(input, 1, fault);
		if (status)
			return status;
		/* It may hold output back even when all input is eaten. */
		result = inflate(&gz->inflate, Z_NO_FLUSH);
		if (result == Z_BUF_ERROR && !gz->inflate.avail_in)
			return fault_set(fault, TCS_TRUNCATED,
				input_consumed(input),
				"the gzip data ends too early");
		if (result == Z_STREAM_END)
			gz->in_member = false;
		else if (result != Z_OK)
			return inflate_fault(input, result, fault);
	}
	*got = size - gz->inflate.avail_out;
	return TCS_OK;
}

enum tcs_status
input_read(struct input *input, void *bytes, size_t room, size_t *got,
	struct tcs_fault *fault)
{
	const struct input_gz *gz = input->gz;
	enum tcs_status status;

	*got = 0;
	if (!room)
		return TCS_OK;
	status = gz->packed ? read_packed(input, bytes, room, got, fault)
			    : read_plain(input, bytes, room, got, fault);
	if (status)
		return status;
	input->at += *got;
	if (input->max_bytes && input->at > input->max_bytes)
		return fault_set(fault, TCS_LIMIT, TCS_NOWHERE,
			"more than %" PRIu64 " bytes of input",
			input->max_bytes);
	return TCS_OK;
}

bool
input_is_plain_file(const struct input *input)
{
	const struct input_gz *gz = input->gz;

	return input->can_rewind && !gz->packed;
}

enum tcs_status
input_read_at(const struct input *input, uint64_t at, void *bytes, size_t room,
	size_t *got, struct tcs_fault *fault)
{
	const struct input_gz *gz = input->gz;
	ssize_t count;

	do
		count = pread(gz->fd, bytes, room, gz->start + (off_t)at);
	while (count < 0 && errno == EINTR);
	*got = count < 0 ? 0 : (size_t)count;
	return count < 0 ? fault_system(fault, "cannot read", input->name)
			 : TCS_OK;
}

enum tcs_status
input_rewind(struct input *input, struct tcs_fault *fault)
{
	struct input_gz *gz = input->gz;

	if (!input->can_rewind)
		errno = ESPIPE;
	else if (lseek(gz->fd, gz->start, SEEK_SET) == gz->start)
		return begin(input, fault);
	return fault_system(fault, "cannot read again", input->name);
}

/* Bytes that are held are stepped over; else the next come from there. */
static enum tcs_status
seek_plain(struct input *input, uint64_t at, struct tcs_fault *fault)
{
	struct input_gz *gz = input->gz;
	uint64_t held = gz->inflate.avail_in;
	off_t place = gz->start + (off_t)at;

	if (at >= input->at && at - input->at <= held) {
		gz->inflate.next_in += at - input->at;
		gz->inflate.avail_in -= (uInt)(at - input->at);
	} else if (lseek(gz->fd, place, SEEK_SET) == place) {
		gz->inflate.avail_in = 0;
		gz->fetched = at;
		gz->ended = false;
	} else {
		return fault_system(fault, "cannot read again", input->name);
	}
	input->at = at;
	return TCS_OK;
}

static enum tcs_status
seek_packed(struct input *input, uint64_t at, struct tcs_fault *fault)
{
	unsigned char passed[16 * 1024];
	enum tcs_status status = TCS_OK;

	if (at < input->at)
		status = input_rewind(input, fault);
	while (!status && input->at < at) {
		uint64_t left = at - input->at;
		size_t got;

		status = input_read(input, passed,
			left < sizeof passed ? (size_t)left : sizeof passed,
			&got, fault);
		if (!status && !got)
			return fault_set(fault, TCS_TRUNCATED,
				input_consumed(input),
				"the input has become shorter");
	}
	return status;
}

enum tcs_status
input_seek(struct input *input, uint64_t at, struct tcs_fault *fault)
{
	const struct input_gz *gz = input->gz;

	if (!input->can_rewind) {
		errno = ESPIPE;
		return fault_system(fault, "cannot read again", input->name);
	}
	return gz->packed ? seek_packed(input, at, fault)
			  : seek_plain(input, at, fault);
}

static enum tcs_status
write_all(int fd, const unsigned char *bytes, size_t length,
	struct tcs_fault *fault)
{
	while (length) {
		ssize_t count = write(fd, bytes, length);

		if (count < 0 && errno == EINTR)
			continue;
		if (count < 0)
			return fault_system(
				fault, "cannot write", "a temporary file");
		bytes += count;
		length -= (size_t)count;
	}
	return TCS_OK;
}

/* Copy what is held and what is still to come. */
static enum tcs_status
spool_to(struct input *input, int fd, struct tcs_fault *fault)
{
	struct input_gz *gz = input->gz;

	while (gz->inflate.avail_in || !gz->ended) {
		enum tcs_status status = write_all(
			fd, gz->inflate.next_in, gz->inflate.avail_in, fault);

		input->size += gz->inflate.avail_in;
		gz->inflate.avail_in = 0;
		if (!status)
			status = fetch(input, 1, fault);
		if (status)
			return status;
	}
	return TCS_OK;
}

int
input_nameless(void)
{
	const char *folder = getenv("TMPDIR");
	char name[PATH_MAX];
	int fd;

	if (snprintf(name, sizeof name, "%s/tessera-XXXXXX",
		    folder && *folder ? folder : "/tmp") >= (int)sizeof name) {
		errno = ENAMETOOLONG;
		return -1;
	}
	fd = mkstemp(name);
	if (fd >= 0)
		unlink(name);
	return fd;
}

enum tcs_status
input_spool(struct input *input, struct tcs_fault *fault)
{
	struct input_gz *gz = input->gz;
	enum tcs_status status;
	int fd;

	if (input->can_rewind)
		return TCS_OK;
	fd = input_nameless();
	if (fd < 0)
		return fault_system(fault, "cannot create", "a temporary file");
	status = spool_to(input, fd, fault);
	if (gz->fd > STDIN_FILENO)
		close(gz->fd);
	gz->fd = fd;
	gz->start = 0;
	input->can_rewind = true;
	return status ? status : input_rewind(input, fault);
}

uint64_t
input_consumed(const struct input *input)
{
	const struct input_gz *gz = input->gz;

	return gz->fetched - gz->inflate.avail_in;
}

void
input_close(struct input *input)
{
	struct input_gz *gz = input->gz;

	if (!gz)
		return;
	inflateEnd(&gz->inflate);
	if (gz->fd > STDIN_FILENO)
		close(gz->fd);
	free(gz);
	input->gz = NULL;
}
