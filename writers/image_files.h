/*
 * Images that a stream carries, as files beside a document that names them.
 *
 * The names are a stranger's: an image is written to the folder of the document
 * or below it, never through a symbolic link, never over a file that is there,
 * under no hidden name, and only where its bytes are those of an image.
 */
#ifndef TESSERA_IMAGE_FILES_H
#define TESSERA_IMAGE_FILES_H

#include <stdbool.h>

#include "report.h"
#include "tcs.h"

struct image_files {
	const char *document; /* its name, borrowed; NULL: it has no folder */
	TCS_ARRAY(char *) written; /* names of files; owned */
};

/* `document` is the output's name as given: a standard stream, a device and a
 * pipe have no folder. */
void image_files_init(struct image_files *files, const char *document);

/*
 * Write the embedded images of some more entries. What is not written is in the
 * report, skipped, with the reason; the same image again is no fault. Nothing
 * happens without a folder. Fails with TCS_SYSTEM (a full disk) or
 * TCS_NO_MEMORY.
 */
enum tcs_status image_files_add(struct image_files *files,
	const struct tcs_palette *palette, struct report *report,
	struct tcs_fault *fault) TCS_CHECKED;

/* Remove what was written: the document does not appear. */
void image_files_undo(struct image_files *files);

void image_files_release(struct image_files *files);

#endif
