/*
 * A STEP physical file: an index of its instances over the text as it is.
 *
 * One pass over the text finds every instance, `#id=NAME(parameters);`, and
 * keeps sixteen bytes of it: the id, the number of its name, and where its
 * parameters begin. Then two tables follow: from ids to instances (references
 * may lead forward), and from names to instances. Parameters are not looked at
 * before somebody asks; step_value.h decodes them, from as many threads as
 * wanted, as nothing here changes any more.
 *
 *     struct step_file file = {0};
 *
 *     if (step_index(&file, text, length, &report, &fault))
 *             …
 *     walls = step_instances(&file, step_names_find(&file.names, "IFCWALL"));
 *     for (size_t i = 0; i < walls.count; i++)
 *             cursor = step_parameters(&file, walls.at[i]);
 *
 * Instances are numbered from 0 in the order of the file, over all of its DATA
 * sections. Complex instances, `#id=(A(…)B(…));`, have the name STEP_COMPLEX,
 * and their parts are reached by step_part.
 *
 * source: ISO 10303-21:2016 (all three editions: ANCHOR and REFERENCE
 * sections are passed over, DATA may have parameters).
 */
#ifndef TESSERA_STEP_FILE_H
#define TESSERA_STEP_FILE_H

#include <stddef.h>
#include <stdint.h>

#include "array.h"
#include "report.h"
#include "step_names.h"
#include "step_value.h"

#define STEP_NONE UINT32_MAX /* no instance */

enum { STEP_COMPLEX = 0 }; /* the name of complex instances */

enum step_header {
	STEP_DESCRIPTION,
	STEP_FILE_NAME,
	STEP_SCHEMA,
	STEP_HEADERS
};

struct step_instance {
	uint64_t id;
	uint64_t place; /* see step_place, step_name_of */
};

struct step_key {
	uint64_t id;
	uint32_t instance;
};

struct step_file {
	const char *text; /* borrowed, as long as the file is used */
	size_t length;
	TCS_ARRAY(struct step_instance) instances;
	struct step_names names;
	uint64_t header[STEP_HEADERS]; /* behind "FILE_…("; 0: not there */
	uint32_t *by_id; /* instances, or STEP_NONE, by id … */
	struct step_key *keys; /* … or, where ids are too far apart, in order */
	uint64_t id_count; /* of the one or the other */
	uint32_t *by_name; /* instances, those of a name together */
	uint32_t *name_begins; /* one more than there are names */
};

/* Some instances, in the order of the file. */
struct step_list {
	const uint32_t *at;
	size_t count;
};

/*
 * Index the text. What is no statement of a DATA section, or takes an id for
 * the second time (the first one counts), is reported as skipped; a file
 * without its last line, as a note. Fails with TCS_BAD_INPUT for what is no
 * STEP file, with TCS_TRUNCATED where a statement or a DATA section does not
 * end, with TCS_LIMIT beyond 2^32 - 2 instances or STEP_MAX_NAMES names, with
 * TCS_NO_MEMORY; then the file is still to be released.
 */
enum tcs_status step_index(struct step_file *file, const char *text,
	size_t length, struct report *report,
	struct tcs_fault *fault) TCS_CHECKED;

void step_release(struct step_file *file);

/* The instance with the id; STEP_NONE when it is missing. */
uint32_t step_find(const struct step_file *file, uint64_t id);

/* The instance a value refers to; STEP_NONE for any other value, too. */
uint32_t step_target(
	const struct step_file *file, const struct step_value *value);

/* All instances with a name, given by its number. */
struct step_list step_instances(const struct step_file *file, uint16_t name);

/* The parameters of an instance; of a complex one, none but STEP_BAD. */
struct step_cursor step_parameters(
	const struct step_file *file, uint32_t instance);

/*
 * The parameters of the part called `name`, in capitals, of a complex
 * instance, or of a simple one with just that name. False when it has no such
 * part.
 */
bool step_part(const struct step_file *file, uint32_t instance,
	const char *name, struct step_cursor *out);

/* The parameters of a statement of the header; none when it is not there. */
struct step_cursor step_header_parameters(
	const struct step_file *file, enum step_header header);

static inline uint16_t
step_name_of(const struct step_file *file, uint32_t instance)
{
	return (uint16_t)file->instances.at[instance].place;
}

/* The byte of the text behind the parenthesis that opens the parameters. */
static inline uint64_t
step_place(const struct step_file *file, uint32_t instance)
{
	return file->instances.at[instance].place >> 16;
}

/* The name itself, in capitals; "" of a complex instance. */
static inline const char *
step_name_text(const struct step_file *file, uint32_t instance)
{
	return file->names.list.at[step_name_of(file, instance)].text;
}

#endif
