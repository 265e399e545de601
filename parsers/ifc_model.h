/*
 * An IFC file, read: what every object and product of it needs, once. Nothing
 * here is changed after ifc_model_read, so threads may share it.
 */
#ifndef TESSERA_IFC_MODEL_H
#define TESSERA_IFC_MODEL_H

#include "ifc_direct.h"
#include "ifc_links.h"
#include "ifc_objects.h"
#include "ifc_opening.h"
#include "ifc_placement.h"
#include "ifc_style.h"
#include "ifc_unit_names.h"
#include "ifc_units.h"

struct ifc_model {
	struct step_file step;
	struct ifc_file file;
	struct ifc_units units;
	struct ifc_placements placements;
	struct ifc_tree tree;
	struct ifc_objects objects;
	struct ifc_openings openings;
	struct ifc_styles styles;
	struct ifc_links links;
	struct ifc_project_units project_units;
	struct ifc_direct_places *direct; /* by the number of a name; owned */
	double precision; /* of the file's lengths */
	double north; /* see ifc_true_north … */
	bool has_north; /* … where it is told */
};

/*
 * Read a file from its text, which is borrowed, on `jobs` threads. `keep` says
 * which products are members of objects.
 * Fails as step_index and ifc_open do; then the model is still to be released.
 */
enum tcs_status ifc_model_read(struct ifc_model *model, const char *text,
	size_t length, const struct ifc_keep *keep, unsigned jobs,
	struct report *report, struct tcs_fault *fault) TCS_CHECKED;

void ifc_model_release(struct ifc_model *model);

/* The GlobalId of an instance, or "#12" where it has none. */
#define IFC_GLOBAL_ID_ROOM 64
void ifc_global_id(const struct ifc_file *file, uint32_t instance,
	char out[IFC_GLOBAL_ID_ROOM]);

#endif
