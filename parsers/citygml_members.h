/*
 * Members read out of order, by several threads: each by a reader of its own, a
 * helper, that knows the head of the document and nothing that came since.
 *
 * A member that needs more than that, that is no well-formed element, or that
 * does not hold exactly one feature, is left to the leader, the reader of the
 * document, which reads in order. So who cuts the document into members may be
 * wrong, and what is wrong in it is found by the leader, as if it had read all.
 */
#ifndef TESSERA_CITYGML_MEMBERS_H
#define TESSERA_CITYGML_MEMBERS_H

#include "citygml_reader.h"

/* A run of the document's bytes. */
struct document_piece {
	size_t first, length; /* in the bytes at hand */
	uint64_t at, line; /* of its first byte, in the document */
	bool is_member; /* by the looks of it */
};

/* What helpers begin with: what the leader knows by then. All zero is empty. */
struct helper_start {
	const struct gml_options *options; /* borrowed */
	TCS_ARRAY(char) head; /* the document's first bytes */
	struct srs_list systems;
	uint32_t model_srs, first_srs;
};

/* All zero is a helper that has not begun. */
struct helper {
	struct gml_reader reader;
	bool begun;
	bool ready; /* stands behind the head */
	bool in_vain; /* it has read what is not for it: from then on, what can
	                 be seen to be of that kind is not read */
};

/*
 * Whether what helpers read is what the leader would read: it is below the
 * model, between two elements, and knows how coordinates are written.
 */
bool leader_can_be_helped(const struct gml_reader *leader);

/* The first bytes are there, at least all of the head; the rest is taken. */
enum tcs_status helper_start_take(struct helper_start *start,
	const struct gml_reader *leader, struct tcs_fault *fault) TCS_CHECKED;
void helper_start_release(struct helper_start *start);

void helper_release(struct helper *helper);

/*
 * Read one member, behind which a byte may be written, into the object, or a
 * new one for NULL. It becomes NULL when the leader has to read the member; the
 * number of its place is still to be given.
 */
enum tcs_status helper_read(struct helper *helper,
	const struct helper_start *start, char *bytes,
	const struct document_piece *piece, struct raw_object **out,
	struct tcs_fault *fault) TCS_CHECKED;

/* The leader passes over a member that a helper has read: its place. */
void leader_pass(struct gml_reader *leader, struct raw_object *raw);

/* The leader reads a piece, which follows what it has read or passed over. */
enum tcs_status leader_read(struct gml_reader *leader, const char *bytes,
	const struct document_piece *piece,
	struct tcs_fault *fault) TCS_CHECKED;

#endif
