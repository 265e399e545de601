/*
 * The report of tcs-compare as one page that needs nothing else: numbers, a row
 * for each object, and pictures of those that differ most.
 */
#ifndef TESSERA_COMPARE_HTML_H
#define TESSERA_COMPARE_HTML_H

#include "compare_print.h"

enum { GALLERY_SIZE = 24 };

/* An object with pictures; `id` is owned. */
struct gallery_entry {
	char *id;
	struct compare_metrics metrics;
	struct object_pictures pictures;
};

/* Those that differ most so far, the worst first. All zero is empty. */
struct gallery {
	struct gallery_entry entries[GALLERY_SIZE];
	size_t count;
};

/*
 * Take the object if it is among the worst, and its pictures with it: by
 * contacts broken and components crushed, floating, flipped; then by distance;
 * then the first. Fails with TCS_NO_MEMORY.
 */
enum tcs_status gallery_take(struct gallery *gallery,
	struct compare_result *result, const struct tcs_object *before,
	struct tcs_fault *fault) TCS_CHECKED;
void gallery_release(struct gallery *gallery);

/* Errors are the stream's. */
void html_print_begin(FILE *to);
void html_print_object(const struct compare_result *result,
	const struct tcs_object *before, const struct tcs_object *after,
	FILE *to);
void html_print_end(const struct compare_totals *totals,
	const struct gallery *gallery, FILE *to);

#endif
