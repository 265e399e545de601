/*
 * The direct attributes of products that are kept under their own names, and
 * where in its parameters each product of a file has them.
 */
#ifndef TESSERA_IFC_DIRECT_H
#define TESSERA_IFC_DIRECT_H

#include "ifc_file.h"

struct ifc_direct_row {
	const char *name;
	bool is_length;
};

/* The table ends with a row without a name. */
extern const struct ifc_direct_row ifc_direct_rows[];

enum {
	IFC_DIRECT_ROWS = 17,
	IFC_DIRECT_REACH = 32, /* no position is as far */
};

/* By row: the position; negative: the entity has no such attribute. */
struct ifc_direct_places {
	signed char at[IFC_DIRECT_ROWS];
};

/*
 * The places by the number of an instance's name, for the names that are
 * products'. Fails with TCS_NO_MEMORY; free *out.
 */
enum tcs_status ifc_direct_read(const struct ifc_file *file,
	struct ifc_direct_places **out, struct tcs_fault *fault) TCS_CHECKED;

#endif
