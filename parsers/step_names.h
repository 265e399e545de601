/*
 * The entity names of one STEP file, each numbered once. Internal to the STEP
 * reader; step_file.h says how the numbers are used.
 */
#ifndef TESSERA_STEP_NAMES_H
#define TESSERA_STEP_NAMES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "arena.h"
#include "array.h"
#include "keyed_hash.h"

enum {
	STEP_MAX_NAME = 255, /* bytes */
	STEP_MAX_NAMES = 8191,
};

/* A name in capitals, terminated. */
struct step_name {
	const char *text;
	uint32_t length;
	uint32_t hash;
};

struct step_names {
	TCS_ARRAY(struct step_name) list; /* [0] is the empty name */
	uint16_t *slots; /* numbers; 0: free */
	size_t slot_count; /* a power of two, or 0 */
	struct hash_key key;
	struct arena text;
};

/* Make room for names; all zero before. */
enum tcs_status step_names_begin(
	struct step_names *names, struct tcs_fault *fault) TCS_CHECKED;

/*
 * The number of the name of `length` bytes, 1 to STEP_MAX_NAME, which reads
 * the same in small letters; a new one if it is new. Fails with TCS_NO_MEMORY,
 * or with TCS_LIMIT when there are STEP_MAX_NAMES others.
 */
enum tcs_status step_names_intern(struct step_names *names, const char *name,
	size_t length, uint16_t *out, struct tcs_fault *fault) TCS_CHECKED;

/* The number of a name in capitals; 0 for none. */
uint16_t step_names_find(const struct step_names *names, const char *name);

void step_names_release(struct step_names *names);

#endif
