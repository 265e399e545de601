/*
 * The tables of a STEP file that follow from its instances: from ids and from
 * names to them. Internal to the STEP reader.
 */
#ifndef TESSERA_STEP_TABLES_H
#define TESSERA_STEP_TABLES_H

#include "step_file.h"

/* Fill file->by_id or file->keys. Ids met before are reported. */
enum tcs_status step_tabulate_ids(struct step_file *file, struct report *report,
	struct tcs_fault *fault) TCS_CHECKED;

/* Fill file->by_name and file->name_begins. */
enum tcs_status step_tabulate_names(
	struct step_file *file, struct tcs_fault *fault) TCS_CHECKED;

#endif
