#include "image_files.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "folder.h"
#include "image_kind.h"
#include "output.h"

enum { FOLDER_MODE = 0777, COMPARED = 64 * 1024 };

/* One image on its way. */
struct image_file {
	char *name; /* below the document's folder; steps are cut with NULs */
	char *path; /* the same from where the program runs */
	const unsigned char *bytes;
	size_t length;
};

void
image_files_init(struct image_files *files, const char *document)
{
	struct stat there;

	*files = (struct image_files){.document = document};
	if (document &&
		(!strcmp(document, "-") ||
			(!stat(document, &there) && !S_ISREG(there.st_mode))))
		files->document = NULL;
}

/* ---- names ------------------------------------------------------------------ */

static const char *
name_refused(const char *name)
{
	const char *reason = folder_refuses(name);

	if (reason)
		return reason;
	for (; *name; name += *name == '/') {
		if (*name == '.' || *name == '/')
			return "a hidden name, or none";
		name += strcspn(name, "/");
	}
	return name[-1] == '/' ? "a hidden name, or none" : NULL;
}

static enum tcs_status
names_make(struct image_file *image, const char *document, const char *uri,
	struct tcs_fault *fault)
{
	const char *slash = strrchr(document, '/');
	size_t folder = slash ? (size_t)(slash - document) + 1 : 0;
	size_t length = strlen(uri) + 1;

	image->path = malloc(folder + length);
	image->name = malloc(length);
	if (!image->path || !image->name)
		return fault_memory(fault);
	memcpy(image->name, uri, length);
	for (char *at = image->name; *at; at++)
		if (*at == '\\')
			*at = '/';
	memcpy(image->path, document, folder);
	memcpy(image->path + folder, image->name, length);
	return TCS_OK;
}

/* ---- the way there ------------------------------------------------------------ */

static int
folder_open(const char *document)
{
	const char *slash = strrchr(document, '/');
	char *name = slash ? strndup(document, (size_t)(slash - document) + 1)
			   : strdup(".");
	int folder = -1;

	if (name)
		folder = open(name, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
	free(name);
	return folder;
}

/* Into a folder, made where it is missing; -1: there is something else. */
static int
step_down(int in, const char *name)
{
	if (mkdirat(in, name, FOLDER_MODE) && errno != EEXIST)
		return -1;
	return openat(
		in, name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
}

/* The folder of the file, and the last step of the name; -1 with errno. */
static int
walk(const char *document, char *name, const char **last)
{
	int at = folder_open(document);
	char *slash;

	for (; at >= 0 && (slash = strchr(name, '/')); name = slash + 1) {
		int next;

		*slash = '\0';
		next = step_down(at, name);
		close(at);
		at = next;
	}
	*last = name;
	return at;
}

/* ---- the file ------------------------------------------------------------------ */

static bool
holds(int file, const struct image_file *image)
{
	const struct image_bytes from = {NULL, file, image->length};
	unsigned char some[COMPARED];
	struct stat about;

	if (fstat(file, &about) || !S_ISREG(about.st_mode) ||
		(uint64_t)about.st_size != image->length)
		return false;
	for (size_t at = 0; at < image->length; at += COMPARED) {
		size_t left = image->length - at;
		size_t want = left < COMPARED ? left : COMPARED;

		if (image_read(&from, at, some, want) != want ||
			memcmp(some, image->bytes + at, want) != 0)
			return false;
	}
	return true;
}

static enum tcs_status
file_write(struct image_files *files, struct image_file *image,
	struct tcs_fault *fault)
{
	struct output out = {0};
	enum tcs_status status;

	if (array_grow(&files->written, 1))
		return fault_memory(fault);
	status = output_open(&out, image->path, fault);
	if (status)
		return status;
	if (fwrite(image->bytes, 1, image->length, out.file) != image->length) {
		fault_system(fault, "cannot write", image->path);
		output_discard(&out);
		return fault->status;
	}
	status = output_commit(&out, fault);
	if (status)
		return status;
	files->written.at[files->written.count++] = image->path;
	image->path = NULL;
	return TCS_OK;
}

/* *reason is NULL where the file is there now. */
static enum tcs_status
file_place(struct image_files *files, struct image_file *image,
	const char **reason, struct tcs_fault *fault)
{
	const char *last;
	int folder = walk(files->document, image->name, &last);
	int there;

	*reason = "its folder cannot be had";
	if (folder < 0)
		return TCS_OK;
	there = openat(
		folder, last, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
	close(folder);
	*reason = NULL;
	if (there < 0 && errno == ENOENT)
		return file_write(files, image, fault);
	if (there < 0 || !holds(there, image))
		*reason = "something else has its name";
	if (there >= 0)
		close(there);
	return TCS_OK;
}

static enum tcs_status
image_add(struct image_files *files, const struct tcs_palette *palette,
	const struct tcs_image *image, const char **reason,
	struct tcs_fault *fault)
{
	const char *uri = palette_text(palette, image->uri);
	struct image_file file = {
		.bytes = palette->bytes.at + image->first_byte,
		.length = (size_t)image->byte_count,
	};
	const struct image_bytes bytes = {file.bytes, -1, file.length};
	struct image_kind kind;
	enum tcs_status status = names_make(&file, files->document, uri, fault);

	if (!status) {
		*reason = name_refused(file.name);
		if (!*reason)
			*reason = image_examine(&bytes, &kind);
		if (!*reason)
			status = file_place(files, &file, reason, fault);
	}
	free(file.name);
	free(file.path);
	return status;
}

enum tcs_status
image_files_add(struct image_files *files, const struct tcs_palette *palette,
	struct report *report, struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	for (size_t i = 0;
		!status && files->document && i < palette->images.count; i++) {
		const struct tcs_image *image = &palette->images.at[i];
		const char *reason;

		if (!image->byte_count)
			continue;
		status = image_add(files, palette, image, &reason, fault);
		if (!status && reason)
			status = report_item(report, REPORT_SKIPPED, "image",
				reason, palette_text(palette, image->uri),
				TCS_NOWHERE, fault);
	}
	return status;
}

void
image_files_undo(struct image_files *files)
{
	for (size_t i = 0; i < files->written.count; i++)
		unlink(files->written.at[i]);
}

void
image_files_release(struct image_files *files)
{
	for (size_t i = 0; i < files->written.count; i++)
		free(files->written.at[i]);
	array_release(&files->written);
}
