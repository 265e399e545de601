/*
 * Ids and what they name: an index of one object's targets, and the library
 * of polygons that links from other top-level features reach.
 *
 * A link whose target is not in its own feature is *wanted*. One more pass
 * over the document copies what the wanted ids name into the library, and
 * nothing else; so memory follows the links that cross features.
 */
#ifndef TESSERA_CITYGML_LIBRARY_H
#define TESSERA_CITYGML_LIBRARY_H

#include <stdbool.h>
#include <stdint.h>

#include "array.h"
#include "citygml_raw.h"
#include "keyed_hash.h"

/* A hash table from ids to target numbers. All zero is empty. */
struct id_index {
	TCS_ARRAY(uint32_t) slots; /* target number + 1; 0: free */
	struct hash_key key; /* of the slots */
};

void index_release(struct id_index *index);

/* Index the targets of an object; of equal ids the first is found. */
enum tcs_status index_build(struct id_index *index,
	const struct raw_object *raw, struct tcs_fault *fault) TCS_CHECKED;

/* The target with this id; NULL for none. */
const struct raw_target *index_find(const struct id_index *index,
	const struct raw_object *raw, const char *id);

struct raw_library {
	TCS_ARRAY(char *) wanted; /* owned ids, sorted by library_sort */
	struct raw_object *store; /* what they name */
	struct id_index index; /* of the store */
};

void library_release(struct raw_library *library);

/* Add an id to the wanted ones. */
enum tcs_status library_want(struct raw_library *library, const char *id,
	struct tcs_fault *fault) TCS_CHECKED;

/* Sort the wanted ids and drop repetitions, before the collecting pass. */
void library_sort(struct raw_library *library);

/*
 * Copy what the wanted ids name in this object into the store. Links inside a
 * target are followed within the object.
 */
enum tcs_status library_collect(struct raw_library *library,
	const struct raw_object *raw, struct tcs_fault *fault) TCS_CHECKED;

/* The collecting pass is over. */
enum tcs_status library_close(
	struct raw_library *library, struct tcs_fault *fault) TCS_CHECKED;

/*
 * The polygons below a run of members, links followed within the object.
 * `take` gets each member that is a polygon, or a link that `index` does not
 * know, with what the way there adds up to. Links deeper than 32, or more than
 * `budget` members in all, end the walk with *exceeded set.
 */
struct member_walk {
	const struct raw_object *raw;
	const struct id_index *index; /* NULL: links are handed to `take` */
	void *context;
	enum tcs_status (*take)(void *context, const struct raw_member *member,
		bool reversed, uint32_t shell, bool linked,
		struct tcs_fault *fault);
	uint64_t budget;
	bool exceeded;
};

enum tcs_status members_walk(struct member_walk *walk, uint32_t first,
	uint32_t end, bool reversed, uint32_t shell, bool linked,
	struct tcs_fault *fault) TCS_CHECKED;

#endif
