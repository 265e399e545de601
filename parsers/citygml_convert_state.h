/*
 * The state of one conversion, and what its crew does with each piece of the
 * document: citygml_convert.c runs the passes, citygml_convert_read.c reads and
 * works on objects, citygml_convert_write.c writes them.
 *
 * The leader, the reader of the document, reads alone until it knows what the
 * head of the stream has to say. From then on, in the phase that writes most
 * objects, helpers read members at the same time; the leader reads, while
 * writing, what is left to it: see citygml_members.h.
 */
#ifndef TESSERA_CITYGML_CONVERT_STATE_H
#define TESSERA_CITYGML_CONVERT_STATE_H

#include "citygml_convert.h"
#include "citygml_library.h"
#include "citygml_members.h"
#include "citygml_parts.h"
#include "citygml_passes.h"
#include "citygml_slot.h"
#include "citygml_split.h"
#include "progress.h"

/*
 * What goes through the crew at once: pieces of the document, a slot for each
 * member among them; or what the leader has read, in slots.
 */
enum { BATCH = 16 };

struct batch {
	struct slot slots[BATCH];
	size_t count; /* of slots in use */
	struct document_bytes bytes;
	struct document_pieces pieces;
};

struct convert {
	struct document document; /* its reader is the leader */
	struct splitter splitter;
	struct helper_start start; /* what helpers begin with */
	struct document_bytes bytes; /* that the leader reads alone */
	struct document_pieces pieces; /* of these */
	bool helped; /* in this phase */
	struct slot turn; /* an object that the leader read meanwhile … */
	struct builder builder; /* … which this works on */
	const struct convert_options *options;
	const struct command *command;
	struct report *report;
	struct progress progress;
	struct tcs_writer writer;
	struct build_plan plan;
	struct raw_library library;
	TCS_ARRAY(uint64_t) deferred; /* numbers of the objects that wait */
	size_t next_deferred;
	enum convert_phase phase;
	struct place_log places; /* of the objects of the first phase */
	struct tcs_record head_record; /* made with the first object read */
	struct tcs_record palette;
	bool head_ready, head_written;
	uint64_t written; /* objects */
};

/* Of one thread. */
struct convert_worker {
	struct builder builder;
	struct helper helper;
};

/* What the crew's plan names. */
enum tcs_status convert_read(void *context, void *item, bool *done,
	struct tcs_fault *fault) TCS_CHECKED;
enum tcs_status convert_work(void *context, void *item, void *worker,
	struct tcs_fault *fault) TCS_CHECKED;
enum tcs_status convert_write(
	void *context, void *item, struct tcs_fault *fault) TCS_CHECKED;
enum tcs_status convert_begin_worker(
	void *context, void *worker, struct tcs_fault *fault) TCS_CHECKED;
void convert_release_worker(void *worker);
void convert_release_batch(void *item);

/* The first object has told what the head needs; NULL: there is none. */
enum tcs_status prepare_head(struct convert *convert,
	const struct raw_object *first, struct tcs_fault *fault) TCS_CHECKED;
enum tcs_status write_head(
	struct convert *convert, struct tcs_fault *fault) TCS_CHECKED;

#endif
