/*
 * What a stage did and what it left out: counts, and skipped items by reason.
 *
 * Each worker fills a report of its own per item; the writing thread merges
 * them in order, so totals and examples are the same for any number of jobs.
 * At the end the report becomes lines on standard error and the JSON object
 * of --stats. All zero is the empty report.
 */
#ifndef TESSERA_REPORT_H
#define TESSERA_REPORT_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

#include "array.h"
#include "fault.h"

struct report_count {
	const char *name; /* static text: "polygons" */
	uint64_t count;
};

#define REPORT_EXAMPLES 3 /* ids kept per reason */

enum report_severity {
	REPORT_NOTE, /* worth knowing: an assumption */
	REPORT_REPAIRED, /* came through changed */
	REPORT_SKIPPED, /* did not come through: an error under --strict */
};

struct report_reason {
	enum report_severity severity;
	const char *item; /* static text: "polygon" */
	const char *reason; /* static text: "fewer than three points" */
	uint64_t count;
	char *examples[REPORT_EXAMPLES]; /* ids; owned; NULL when fewer */
};

#define REPORT_ENTRIES 10000 /* listed in one report, whatever the reason */

/* An item of a reason whose items are listed, all of them. */
struct report_entry {
	const char *item, *reason; /* as its reason has them */
	char *id; /* owned */
	const char *class; /* static text */
};

struct report {
	TCS_ARRAY(struct report_count) counts;
	size_t last; /* count added to: the same or the next one follows */
	TCS_ARRAY(struct report_reason) reasons;
	TCS_ARRAY(struct report_entry) entries;
};

void report_release(struct report *report);
void report_clear(struct report *report);

enum tcs_status report_add(struct report *report, const char *name,
	uint64_t count, struct tcs_fault *fault) TCS_CHECKED;

/*
 * Note one item under a reason. `id` may be NULL; `at` is its line or byte in
 * the input, or TCS_NOWHERE, and names an item that has no id.
 */
enum tcs_status report_item(struct report *report,
	enum report_severity severity, const char *item, const char *reason,
	const char *id, uint64_t at, struct tcs_fault *fault) TCS_CHECKED;

/* A note as by report_item that --stats lists with every other of its reason,
   each with its class, up to REPORT_ENTRIES. */
enum tcs_status report_listed(struct report *report, const char *item,
	const char *reason, const char *id, const char *class,
	struct tcs_fault *fault) TCS_CHECKED;

enum tcs_status report_merge(struct report *into, const struct report *from,
	struct tcs_fault *fault) TCS_CHECKED;

/*
 * With --strict: TCS_BAD_INPUT naming the first skipped item, if there is one.
 */
enum tcs_status report_strict(
	const struct report *report, struct tcs_fault *fault) TCS_CHECKED;

/* One line per reason: "prog: 3 polygons skipped: zero area (a, b, c)". */
void report_print(const struct report *report, const char *program, FILE *to);

/*
 * The JSON object of --stats, whole or not at all:
 * {"program":…,"version":…,"counts":{…},
 *  "skipped":[{"item":…,"reason":…,"count":…,"examples":[…]}],
 *  "repaired":[…],"notes":[…]}
 * A reason whose items are listed has "list":[{"id":…,"class":…}], too.
 */
enum tcs_status report_write(const struct report *report, const char *program,
	const char *file_name, struct tcs_fault *fault) TCS_CHECKED;

#endif
