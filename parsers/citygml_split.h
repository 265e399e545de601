/*
 * A document cut into members and what stands between them, by looking at
 * bytes. A cut may be wrong: in a comment, in an encoding without ASCII's bytes,
 * in what is no XML.
 */
#ifndef TESSERA_CITYGML_SPLIT_H
#define TESSERA_CITYGML_SPLIT_H

#include "citygml_members.h"
#include "input.h"

TCS_ARRAY_TYPE(document_bytes, char);
TCS_ARRAY_TYPE(document_pieces, struct document_piece);

/* All zero but for the input, of which nothing was read. */
struct splitter {
	struct input *input;
	struct document_bytes held;
	size_t first; /* of these that is in no piece yet */
	uint64_t at, lines; /* before it */
	uint64_t max_member; /* a longer one is cut anywhere */
	bool ended; /* nothing is left to read */
};

void splitter_release(struct splitter *splitter);

/*
 * The next pieces, at least one but for the end, and up to so many members:
 * `pieces` of `bytes`, with one byte behind that is nobody's. Both are the
 * caller's and reused.
 */
enum tcs_status split_next(struct splitter *splitter, size_t most_members,
	struct document_bytes *bytes, struct document_pieces *pieces,
	struct tcs_fault *fault) TCS_CHECKED;

#endif
