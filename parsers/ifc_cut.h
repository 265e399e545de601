/*
 * Cutting bodies: from faces to the solids of solid.h and back, and what a cut
 * that did not go as it should is reported as.
 *
 * Solids are in the file's length unit and the item's coordinates, as the faces
 * are; labels are paints.
 */
#ifndef TESSERA_IFC_CUT_H
#define TESSERA_IFC_CUT_H

#include "ifc_item.h"
#include "solid.h"

TCS_ARRAY_TYPE(ifc_solids, struct solid);

/* What one cut needs; all zero is empty. Half-spaces are always taken away. */
struct ifc_cut {
	enum solid_operation operation;
	struct solid host, result;
	struct ifc_solids tools;
	TCS_ARRAY(struct solid_half_space) half_spaces;
};

void ifc_cut_release(struct ifc_cut *cut);

/* Forget the tools and half-spaces. */
void ifc_cut_clear(struct ifc_cut *cut);

/* Append the faces from `first` to before `end` to a solid. */
enum ifc_outcome ifc_solid_add(struct solid *out, const struct ifc_faces *faces,
	size_t first, size_t end) TCS_CHECKED;

/* Append the faces of a solid. */
enum ifc_outcome ifc_solid_faces(struct ifc_shaper *shaper,
	const struct solid *solid, struct ifc_faces *out) TCS_CHECKED;

/* Another tool of the cut, empty. NULL without memory. */
struct solid *ifc_cut_tool(struct ifc_cut *cut);

/*
 * Carry the cut out: the result becomes the host. Where the kernel refuses to
 * do all at once, it is asked for one tool or half-space after the other. For
 * what it refuses even so, or leaves out, a remark is made about `item`; the
 * host is cut by the others. *open says that the host is not closed.
 */
enum ifc_outcome ifc_cut_run(struct ifc_shaper *shaper, uint32_t item,
	struct ifc_cut *cut, bool *open) TCS_CHECKED;

/* Note something that does not fail the product, to be reported with it. */
enum ifc_outcome ifc_remark(struct ifc_shaper *shaper, uint32_t instance,
	enum report_severity severity, const char *reason) TCS_CHECKED;

#endif
