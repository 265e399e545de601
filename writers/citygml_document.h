/*
 * The document around the objects: joins their texts, keeps ids unique over
 * the file, finds the envelope, and writes it all at the end.
 *
 * The envelope stands before the objects but is known after them, and only
 * what has all of its objects should be written at all: the members go to a
 * nameless temporary file first.
 */
#ifndef TESSERA_CITYGML_DOCUMENT_H
#define TESSERA_CITYGML_DOCUMENT_H

#include <stdio.h>

#include "citygml_compose.h"

/* The geometry of a prototype until it is written with its first instance. */
struct document_prototype {
	char *text; /* owned; NULL once written */
	size_t length;
	char *appearance; /* owned; written behind that instance's object */
	size_t appearance_length;
	char *id; /* owned */
};

struct document {
	const struct compose_plan *plan;
	FILE *members; /* the temporary file */
	struct id_set ids;
	struct id_set linked; /* ids that relations name */
	struct composer again; /* for objects whose ids are taken */
	TCS_ARRAY(struct document_prototype) prototypes;
	TCS_ARRAY(char) appearances; /* of those in the object being put */
	struct report *report; /* borrowed */
	struct tcs_point lower, upper;
	bool has_bounds;
	uint64_t member_count;
	uint64_t polygons;
	uint64_t bytes; /* of the document */
};

enum tcs_status document_begin(struct document *document,
	const struct compose_plan *plan, struct report *report,
	struct tcs_fault *fault) TCS_CHECKED;
void document_release(struct document *document);

/*
 * Add what comes of a record, in the order of the stream: a prototype or an
 * object. `record` is what it was composed from, to compose it again when ids
 * of it are taken.
 */
enum tcs_status document_add(struct document *document,
	struct composed *composed, const struct tcs_record *record,
	struct tcs_fault *fault) TCS_CHECKED;

/*
 * Write the document: head, members, end. `level` 0 writes text, 1…9 gzip.
 * Links to ids that the file does not have are noted in the report.
 */
enum tcs_status document_end(struct document *document,
	const struct tcs_head *head, FILE *out, int level,
	struct tcs_fault *fault) TCS_CHECKED;

#endif
