/*
 * An input of bytes: a file, standard input, gzip or plain, told apart by
 * content. A file can be read twice; what comes through a pipe only after
 * input_spool.
 */
#ifndef TESSERA_INPUT_H
#define TESSERA_INPUT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "fault.h"

struct input {
	const char *name; /* for messages; borrowed; "standard input" */
	void *gz; /* zlib's reader */
	uint64_t size; /* bytes of the file as stored; 0 unknown */
	uint64_t at; /* bytes delivered, uncompressed */
	uint64_t max_bytes; /* limit on them; 0: none */
	bool can_rewind;
};

/* NULL and "-" are standard input. */
enum tcs_status input_open(struct input *input, const char *name,
	struct tcs_fault *fault) TCS_CHECKED;

/*
 * Up to `room` bytes; *got is 0 at the end only. Fails with TCS_SYSTEM,
 * TCS_TRUNCATED or TCS_BAD_INPUT (a damaged gzip), TCS_LIMIT.
 */
enum tcs_status input_read(struct input *input, void *bytes, size_t room,
	size_t *got, struct tcs_fault *fault) TCS_CHECKED;

enum tcs_status input_rewind(
	struct input *input, struct tcs_fault *fault) TCS_CHECKED;

/*
 * Go on reading at this byte, uncompressed, of an input that can be rewound.
 * What is compressed is read up to there, if need be from its beginning.
 * TCS_TRUNCATED when the input ends before.
 */
enum tcs_status input_seek(
	struct input *input, uint64_t at, struct tcs_fault *fault) TCS_CHECKED;

/* Whether the input is a regular file whose bytes are delivered as stored. */
bool input_is_plain_file(const struct input *input);

/*
 * Up to `room` bytes of such a file from any place, by several threads at once;
 * *got is 0 at its end only. What input_read delivers next stays as it is.
 * Fails with TCS_SYSTEM.
 */
enum tcs_status input_read_at(const struct input *input, uint64_t at,
	void *bytes, size_t room, size_t *got,
	struct tcs_fault *fault) TCS_CHECKED;

/*
 * Before the first read: make an input that cannot be read twice one that can,
 * by copying all of it, as stored, to a file that has no name and vanishes with
 * the process. Nothing happens to an input that already can. Fails with
 * TCS_SYSTEM.
 */
enum tcs_status input_spool(
	struct input *input, struct tcs_fault *fault) TCS_CHECKED;

/*
 * An open file without a name, in $TMPDIR or else /tmp, to write to and read
 * back; it vanishes with the process. -1 with errno set on failure.
 */
int input_nameless(void);

/* Bytes consumed of what is stored, for progress against `size`. */
uint64_t input_consumed(const struct input *input);

void input_close(struct input *input);

#endif
