/*
 * A whole IFC file to a stream: the head, the materials, then the objects one
 * by one, each put together from pieces that a crew works on.
 */
#ifndef TESSERA_IFC_CONVERT_H
#define TESSERA_IFC_CONVERT_H

#include <stdio.h>

#include "ifc_objects.h"
#include "input.h"
#include "program.h"
#include "report.h"

struct ifc_options {
	double deflection; /* metres */
	uint64_t max_bytes; /* of the file, unpacked; 0: no limit */
	bool local; /* engineering coordinates, whatever the georeference */
	struct ifc_keep keep;
	bool bake; /* no prototypes */
	bool layers; /* of materials, as parts of their own */
	bool compress; /* the records */
};

/*
 * Read all of `input` and write the stream to `file`, with `command` giving
 * the name of the source, the jobs, and what the head is signed with. What
 * happened is in *report, also after a failure.
 */
enum tcs_status ifc_convert(struct input *input, FILE *file,
	const struct ifc_options *options, const struct command *command,
	struct report *report, struct tcs_fault *fault) TCS_CHECKED;

#endif
