#define _GNU_SOURCE /* memfd_create */

#include <inttypes.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

#include "input.h"

enum { LIMIT = 1 << 20, MAX_ROOM = 4096 };

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size);

/* How a reading ends: status, length and sum of what came. */
struct outcome {
	enum tcs_status status;
	uint64_t length, sum;
};

static struct outcome
read_in_pieces(struct input *input, size_t room)
{
	struct outcome outcome = {0};
	struct tcs_fault fault;
	unsigned char piece[MAX_ROOM];
	size_t got;

	do {
		outcome.status = input_read(input, piece, room, &got, &fault);
		for (size_t i = 0; !outcome.status && i < got; i++)
			outcome.sum = outcome.sum * 31 + piece[i];
		outcome.length += outcome.status ? 0 : got;
	} while (!outcome.status && got);
	return outcome;
}

/* However it is cut, an input delivers the same bytes, or fails both times. */
int
LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
	int fd = memfd_create("input", 0);
	struct input input;
	struct tcs_fault fault;
	struct outcome a, b;
	char name[64];

	if (fd < 0 || write(fd, bytes, size) != (ssize_t)size)
		abort();
	snprintf(name, sizeof name, "/proc/self/fd/%d", fd);
	if (input_open(&input, name, &fault))
		abort();
	input.max_bytes = LIMIT;
	a = read_in_pieces(&input, MAX_ROOM);
	if (input_rewind(&input, &fault))
		abort();
	b = read_in_pieces(&input, 7);
	input_close(&input);
	close(fd);
	if (a.status != b.status ||
		(!a.status && (a.length != b.length || a.sum != b.sum)))
		abort();
	return 0;
}
