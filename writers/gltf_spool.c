#include "gltf_spool.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { SPOOL_BUFFER = 1 << 18, POUR_BUFFER = 1 << 18 };

static const char pattern[] = "/.tessera-XXXXXX";

static char *
spool_pattern(const char *beside)
{
	const char *folder = beside, *slash;
	size_t length;
	char *path;

	if (beside) {
		slash = strrchr(beside, '/');
		folder = slash ? beside : ".";
		length = slash ? (size_t)(slash - beside) : 1;
	} else {
		folder = getenv("TMPDIR");
		if (!folder || !*folder)
			folder = "/tmp";
		length = strlen(folder);
	}
	path = malloc(length + sizeof pattern);
	if (path) {
		memcpy(path, folder, length);
		memcpy(path + length, pattern, sizeof pattern);
	}
	return path;
}

void
spool_open(struct spool *spool, const char *beside)
{
	*spool = (struct spool){.beside = beside};
}

/* An open file without a name. */
static enum tcs_status
spool_make_file(struct spool *spool, struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;
	char *path = spool_pattern(spool->beside);
	int descriptor;

	if (!path)
		return fault_memory(fault);
	descriptor = mkstemp(path);
	if (descriptor < 0) {
		*strrchr(path, '/') = '\0';
		status = fault_system(
			fault, "cannot make a temporary file in", path);
		goto done;
	}
	unlink(path);
	spool->file = fdopen(descriptor, "w+b");
	if (!spool->file) {
		close(descriptor);
		status = fault_system(fault, "cannot use", "a temporary file");
		goto done;
	}
	setvbuf(spool->file, NULL, _IOFBF, SPOOL_BUFFER);
done:
	free(path);
	return status;
}

static enum tcs_status
spool_to_file(struct spool *spool, const void *bytes, size_t size,
	struct tcs_fault *fault)
{
	return fwrite(bytes, 1, size, spool->file) == size
		? TCS_OK
		: fault_system(fault, "cannot write", "a temporary file");
}

static enum tcs_status
spool_spill(struct spool *spool, struct tcs_fault *fault)
{
	enum tcs_status status = spool_make_file(spool, fault);

	if (!status)
		status = spool_to_file(
			spool, spool->held.at, spool->held.count, fault);
	array_release(&spool->held);
	return status;
}

enum tcs_status
spool_write(struct spool *spool, const void *bytes, size_t size,
	struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	if (!size)
		return TCS_OK;
	if (!spool->file && spool->size + size > SPOOL_HELD)
		status = spool_spill(spool, fault);
	if (!status && spool->file)
		status = spool_to_file(spool, bytes, size, fault);
	if (status)
		return status;
	if (!spool->file) {
		if (array_grow(&spool->held, size))
			return fault_memory(fault);
		memcpy(spool->held.at + spool->held.count, bytes, size);
		spool->held.count += size;
	}
	spool->size += size;
	return TCS_OK;
}

enum tcs_status
spool_align(struct spool *spool, unsigned unit, struct tcs_fault *fault)
{
	static const unsigned char zeros[8];

	return spool_write(spool, zeros,
		(size_t)((unit - spool->size % unit) % unit), fault);
}

enum tcs_status
spool_pour(struct spool *spool, FILE *to, const char *name,
	struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;
	uint64_t left = spool->size;
	char *buffer;

	if (!spool->size)
		return TCS_OK;
	if (!spool->file)
		return fwrite(spool->held.at, 1, spool->held.count, to) ==
				spool->held.count
			? TCS_OK
			: fault_system(fault, "cannot write", name);
	buffer = malloc(POUR_BUFFER);
	if (!buffer)
		return fault_memory(fault);
	if (fflush(spool->file) || fseeko(spool->file, 0, SEEK_SET))
		status = fault_system(fault, "cannot read", "a temporary file");
	while (!status && left > 0) {
		size_t want = left < POUR_BUFFER ? (size_t)left : POUR_BUFFER;

		if (fread(buffer, 1, want, spool->file) != want)
			status = fault_system(
				fault, "cannot read", "a temporary file");
		else if (fwrite(buffer, 1, want, to) != want)
			status = fault_system(fault, "cannot write", name);
		left -= want;
	}
	free(buffer);
	return status;
}

void
spool_close(struct spool *spool)
{
	if (spool->file)
		fclose(spool->file);
	array_release(&spool->held);
	*spool = (struct spool){0};
}
