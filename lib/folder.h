/*
 * The folder that a document's other files are read from, and nothing outside
 * of it.
 *
 * The names come from a stranger's file. A name is followed step by step from
 * the folder down; absolute names, "..", addresses, symbolic links and what is
 * no regular file are refused, so that no name reaches a file that its author
 * was not given.
 */
#ifndef TESSERA_FOLDER_H
#define TESSERA_FOLDER_H

#include <stdbool.h>
#include <stdint.h>

#include "fault.h"

struct folder {
	const char *name; /* NULL: there is none; borrowed */
	int file; /* the folder, while is_open */
	bool is_open;
};

/* Larger files are not opened; `reason` is static text that says so. */
struct folder_limit {
	uint64_t bytes;
	const char *reason;
};

/* A regular file, open for reading. */
struct folder_file {
	int file; /* the caller closes it */
	uint64_t size;
};

/*
 * Open the file of that URI, relative to the folder; '\' is taken for '/', and
 * %XX for its byte when no file is called so literally. *reason is NULL with
 * *out filled, or static text that says why the file cannot be had. Fails when
 * the folder itself cannot be opened.
 */
enum tcs_status folder_open_file(struct folder *folder, const char *uri,
	const struct folder_limit *limit, struct folder_file *out,
	const char **reason, struct tcs_fault *fault) TCS_CHECKED;

/* Why a name is never followed, as static text; NULL: it may be. */
const char *folder_refuses(const char *name);

void folder_close(struct folder *folder);

#endif
