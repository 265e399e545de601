/*
 * The document, read in passes: all of it, or the parts that a pass needs as
 * an earlier one found them.
 */
#ifndef TESSERA_CITYGML_PASSES_H
#define TESSERA_CITYGML_PASSES_H

#include "citygml_parts.h"
#include "citygml_reader.h"
#include "input.h"

enum { PASS_CHUNK = 64 * 1024 };

struct document {
	struct input *input;
	struct gml_reader reader;
	const struct document_parts *parts; /* NULL: all is read */
	size_t next_part;
	bool ended; /* the pass has read all it is to read */
	char chunk[PASS_CHUNK];
};

/*
 * Start a pass over all of the document, or over parts of it, which must
 * outlive the pass.
 */
enum tcs_status document_start(struct document *document, enum gml_pass pass,
	const struct document_parts *parts,
	struct tcs_fault *fault) TCS_CHECKED;

/* Feed the reader some more. */
enum tcs_status document_feed(
	struct document *document, struct tcs_fault *fault) TCS_CHECKED;

#endif
