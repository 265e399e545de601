/*
 * The materials and images of the stream: each joins its tables when it first
 * comes, equal ones once, so that every pass gives them the same numbers.
 *
 * Whoever reads an object puts what that shows into a palette of the object's
 * own, and the numbers in there, marked, into its paints. Only who writes the
 * objects, one after the other, knows the stream's.
 */
#ifndef TESSERA_CITYGML_PALETTE_H
#define TESSERA_CITYGML_PALETTE_H

#include "citygml_digests.h"
#include "citygml_keys.h"
#include "folder.h"
#include "report.h"
#include "tcs.h"

/* Marks a number of the object's own palette. */
#define PALETTE_OWN 0x80000000u

/* All zero is empty; without a folder no image is looked up. */
struct palette_numbers {
	struct digest_table materials, images; /* of the stream so far */
	struct folder folder;
	struct key_table files; /* of the folder that were looked up … */
	struct report found; /* … once, in whatever pass */
	struct tcs_palette fresh; /* entries that have not been written yet */
	TCS_ARRAY(uint32_t) material_numbers; /* of the last palette */
	TCS_ARRAY(uint32_t) image_numbers;
	TCS_ARRAY(char) key; /* scratch */
};

void palette_numbers_release(struct palette_numbers *numbers);

/*
 * Find the number of every entry of an object's palette; new ones join the
 * fresh ones. Whether an image is there is looked up, for whoever has to
 * deliver both; what is in it is not read.
 */
enum tcs_status palette_number(struct palette_numbers *numbers,
	const struct tcs_palette *palette, struct tcs_fault *fault) TCS_CHECKED;

/* A marked number of that palette becomes the stream's; others stay. */
uint32_t palette_material(
	const struct palette_numbers *numbers, uint32_t material);
uint32_t palette_image(const struct palette_numbers *numbers, uint32_t image);

/* The same in an encoded object. */
enum tcs_status palette_renumber(const struct palette_numbers *numbers,
	struct tcs_record *record, struct tcs_fault *fault) TCS_CHECKED;

#endif
