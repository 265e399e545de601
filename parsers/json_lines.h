/* An input cut into lines. */
#ifndef TESSERA_JSON_LINES_H
#define TESSERA_JSON_LINES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "array.h"
#include "input.h"

TCS_ARRAY_TYPE(line_bytes, char);

/* All zero but for `input` and `max_line` is the start. */
struct line_reader {
	struct input *input;
	uint64_t max_line; /* limit on the bytes of one line */
	uint64_t line; /* number of the last line, from 1 */
	TCS_ARRAY(char) buffer; /* read, not delivered */
	size_t at; /* of the buffer: delivered so far */
	bool ended;
};

void lines_release(struct line_reader *reader);

/*
 * The next line that is not blank, without its end, into *out, which the
 * caller reuses; *done when there is none. Memory grows as bytes arrive. Fails
 * as input_read does, and with TCS_LIMIT for a line beyond max_line.
 */
enum tcs_status lines_next(struct line_reader *reader, struct line_bytes *out,
	bool *done, struct tcs_fault *fault) TCS_CHECKED;

#endif
