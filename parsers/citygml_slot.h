/*
 * One top-level feature on its way from a raw object to records.
 */
#ifndef TESSERA_CITYGML_SLOT_H
#define TESSERA_CITYGML_SLOT_H

#include <string.h>

#include "citygml_build.h"
#include "citygml_raw.h"
#include "report.h"
#include "tcs.h"

enum convert_phase {
	PHASE_WRITE, /* write every object that needs no other */
	PHASE_COLLECT, /* copy what the others link to */
	PHASE_DEFERRED, /* write the others */
};

/* Owned by the caller and reused; all zero is empty. */
struct slot {
	struct raw_object *raw; /* owned */
	struct tcs_record record;
	struct tcs_object prototype; /* being built */
	TCS_ARRAY(struct tcs_record) prototypes; /* the room's are kept */
	size_t prototype_count;
	struct report templates; /* what became of them */
	TCS_ARRAY(char *) missing; /* owned: ids that were not found */
	TCS_ARRAY(uint64_t) hashes; /* of the ids that links may name */
	enum tcs_status status; /* of the work on it */
	struct tcs_fault fault;
};

void slot_release(struct slot *slot);

/*
 * Make the records of slot->raw, but for one that misses ids: these it lists,
 * to look for elsewhere at first, and reports in the end; and but for one that
 * waits.
 */
enum tcs_status slot_work(struct slot *slot, enum convert_phase phase,
	const struct build_plan *plan, struct builder *builder,
	struct tcs_fault *fault) TCS_CHECKED;

/* As in slot->hashes. */
static inline uint64_t
id_hash(const struct build_plan *plan, const char *id)
{
	return keyed_hash(&plan->id_key, id, strlen(id));
}

/* Whether it links to a template that may be still to come. */
bool slot_waits(const struct slot *slot, enum convert_phase phase);

#endif
