#include "folder.h"

#include <errno.h>
#include <fcntl.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* ---- names --------------------------------------------------------------- */

/* "http:", "file:", "data:", and a drive's "C:" as well. */
static bool
has_scheme(const char *name)
{
	size_t length = strcspn(name, ":/");

	return length && name[length] == ':';
}

static bool
climbs(const char *name)
{
	for (; *name; name += *name == '/') {
		size_t length = strcspn(name, "/");

		if (length == 2 && name[0] == '.' && name[1] == '.')
			return true;
		name += length;
	}
	return false;
}

const char *
folder_refuses(const char *name)
{
	if (!*name)
		return "no name";
	if (*name == '/')
		return "an absolute name";
	if (has_scheme(name))
		return "an address, not a file of the folder";
	if (climbs(name))
		return "the name leaves the folder";
	return NULL;
}

static int
hex_digit(char c)
{
	if (c >= '0' && c <= '9')
		return c - '0';
	c = (char)(c | 0x20);
	return c >= 'a' && c <= 'f' ? c - 'a' + 10 : -1;
}

/* In place; whether anything was decoded. "%00" stays. */
static bool
decode_percents(char *name)
{
	char *to = name;
	bool decoded = false;

	for (const char *from = name; *from; from++, to++) {
		int high = *from == '%' ? hex_digit(from[1]) : -1;
		int low = high < 0 ? -1 : hex_digit(from[2]);

		*to = *from;
		if (low < 0 || !(high | low))
			continue;
		*to = (char)(high << 4 | low);
		from += 2;
		decoded = true;
	}
	*to = '\0';
	return decoded;
}

static void
turn_slashes(char *name)
{
	for (; *name; name++)
		if (*name == '\\')
			*name = '/';
}

/* ---- the walk ------------------------------------------------------------ */

static const char *
reason_of(int problem)
{
	switch (problem) {
	case ENOENT:
	case ENOTDIR:
	case ENAMETOOLONG:
		return "not found";
	case ELOOP:
		return "a symbolic link";
	default:
		return "it cannot be read";
	}
}

/* Open the folder `name` of `in`, never through a link. */
static int
step_down(int in, const char *name, const char **reason)
{
	struct stat about;
	int next;

	if (fstatat(in, name, &about, AT_SYMLINK_NOFOLLOW)) {
		*reason = reason_of(errno);
		return -1;
	}
	if (S_ISLNK(about.st_mode)) {
		*reason = reason_of(ELOOP);
		return -1;
	}
	next = openat(
		in, name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
	if (next < 0)
		*reason = reason_of(errno);
	return next;
}

/* Before a file is opened it is known to be regular: opening others acts. */
static const char *
open_regular(int in, const char *name, const struct folder_limit *limit,
	struct folder_file *out)
{
	const int flags =
		O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC;
	const char *reason = NULL;
	struct stat about;

	if (fstatat(in, name, &about, AT_SYMLINK_NOFOLLOW))
		return reason_of(errno);
	if (S_ISLNK(about.st_mode))
		return reason_of(ELOOP);
	if (!S_ISREG(about.st_mode))
		return "not a regular file";
	out->file = openat(in, name, flags);
	if (out->file < 0)
		return reason_of(errno);
	if (fstat(out->file, &about))
		reason = reason_of(errno);
	else if (!S_ISREG(about.st_mode))
		reason = "not a regular file";
	else if ((uint64_t)about.st_size > limit->bytes)
		reason = limit->reason;
	if (reason)
		close(out->file);
	out->size = (uint64_t)about.st_size;
	return reason;
}

/* `name` is taken apart. */
static const char *
walk(int folder, char *name, const struct folder_limit *limit,
	struct folder_file *out)
{
	const char *reason = NULL;
	int in = folder;

	while (!reason) {
		char *slash = strchr(name, '/');
		int next = in;

		if (!slash) {
			reason = open_regular(in, name, limit, out);
			break;
		}
		*slash = '\0';
		if (*name && strcmp(name, ".") != 0)
			next = step_down(in, name, &reason);
		if (next != in && in != folder)
			close(in);
		in = next;
		name = slash + 1;
	}
	if (in != folder && in >= 0)
		close(in);
	return reason;
}

/* `name` is changed. */
static const char *
open_name(const struct folder *folder, char *name,
	const struct folder_limit *limit, struct folder_file *out)
{
	const char *reason;

	turn_slashes(name);
	reason = folder_refuses(name);
	return reason ? reason : walk(folder->file, name, limit, out);
}

static enum tcs_status
open_folder(struct folder *folder, struct tcs_fault *fault)
{
	if (folder->is_open)
		return TCS_OK;
	folder->file = open(folder->name, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
	if (folder->file < 0)
		return fault_system(fault, "cannot read", folder->name);
	folder->is_open = true;
	return TCS_OK;
}

enum tcs_status
folder_open_file(struct folder *folder, const char *uri,
	const struct folder_limit *limit, struct folder_file *out,
	const char **reason, struct tcs_fault *fault)
{
	char *literal = strdup(uri), *decoded = strdup(uri);
	enum tcs_status status = literal && decoded ? open_folder(folder, fault)
						    : fault_memory(fault);

	*out = (struct folder_file){.file = -1};
	if (!status)
		*reason = open_name(folder, literal, limit, out);
	if (!status && *reason && decode_percents(decoded))
		*reason = open_name(folder, decoded, limit, out);
	free(literal);
	free(decoded);
	return status;
}

void
folder_close(struct folder *folder)
{
	if (folder->is_open)
		close(folder->file);
	folder->is_open = false;
}
