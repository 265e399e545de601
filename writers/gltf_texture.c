#include "gltf_texture.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { COPY_ROOM = 65536 };

static const char unread[] = "no folder of images is given";

static enum tcs_status
note_missing(const char *uri, const char *reason, struct report *report,
	struct tcs_fault *fault)
{
	return report_item(report, REPORT_SKIPPED, "image", reason, uri,
		TCS_NOWHERE, fault);
}

/* All of it: less means that the file is changing. */
static enum tcs_status
copy_part(const struct image_bytes *from, uint64_t at, uint64_t size,
	const char *uri, struct spool *spool, struct tcs_fault *fault)
{
	unsigned char room[COPY_ROOM];
	enum tcs_status status = TCS_OK;

	while (size && !status) {
		size_t most = size < sizeof room ? (size_t)size : sizeof room;
		size_t got = image_read(from, at, room, most);

		if (!got)
			return fault_set(fault, TCS_SYSTEM, at,
				"cannot read %s to its end", uri);
		status = spool_write(spool, room, got, fault);
		at += got;
		size -= got;
	}
	return status;
}

static enum tcs_status
copy_image(const struct image_bytes *from, enum image_format format,
	const char *uri, struct spool *spool, struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;
	uint64_t at = 0, part, size;

	while (!status && (size = image_part(from, format, &at, &part)) > 0)
		status = copy_part(from, part, size, uri, spool, fault);
	return status;
}

static char *
last_part(const char *uri)
{
	for (const char *at = uri; *at; at++)
		if (*at == '/' || *at == '\\')
			uri = at + 1;
	return strdup(*uri ? uri : "image");
}

/* Append what is a good image; else *reason says what is wrong with it. */
static enum tcs_status
add_image(struct textures *textures, const struct image_bytes *from,
	const char *uri, struct spool *spool, uint32_t *number,
	const char **reason, struct report *report, struct tcs_fault *fault)
{
	struct texture_image image = {.start = 0};
	enum tcs_status status;

	*reason = image_examine(from, &image.kind);
	if (*reason)
		return TCS_OK;
	status = spool_align(spool, 8, fault);
	if (status)
		return status;
	image.start = spool->size;
	status = copy_image(from, image.kind.format, uri, spool, fault);
	if (status)
		return status;
	image.end = spool->size;
	image.name = last_part(uri);
	if (!image.name || array_grow(&textures->images, 1)) {
		free(image.name);
		return fault_memory(fault);
	}
	*number = (uint32_t)textures->images.count;
	textures->images.at[textures->images.count++] = image;
	return report_add(report, "images", 1, fault);
}

static enum tcs_status
load_image(struct textures *textures, const char *uri, struct spool *spool,
	uint32_t *number, const char **reason, struct report *report,
	struct tcs_fault *fault)
{
	const struct folder_limit limit = {
		textures->limit, "larger than --max-image"};
	struct folder_file file;
	struct image_bytes from;
	enum tcs_status status;

	*reason = unread;
	if (!textures->folder.name)
		return TCS_OK;
	status = folder_open_file(
		&textures->folder, uri, &limit, &file, reason, fault);
	if (status || *reason)
		return status;
	from = (struct image_bytes){NULL, file.file, file.size};
	status = add_image(
		textures, &from, uri, spool, number, reason, report, fault);
	close(from.file);
	return status;
}

/* Where an image comes from: its own bytes, "#7", or its URI. */
struct image_source {
	const unsigned char *bytes; /* NULL: not at hand */
	uint64_t size;
	const char *uri;
	uint32_t entry;
	bool embedded;
};

static enum tcs_status
find_image(struct textures *textures, const struct image_source *source,
	struct spool *spool, uint32_t *number, struct report *report,
	struct tcs_fault *fault)
{
	const struct image_bytes held = {source->bytes, -1, source->size};
	char own[16];
	const char *key = source->uri, *reason;
	uint32_t seen;
	bool added;
	enum tcs_status status;

	snprintf(own, sizeof own, "#%u", source->entry);
	if (source->embedded)
		key = own;
	status = byte_index_add(
		&textures->by_source, key, strlen(key), &seen, &added, fault);
	if (!status && added && array_grow(&textures->of_source, 1))
		status = fault_memory(fault);
	if (status)
		return status;
	if (!added) {
		*number = textures->of_source.at[seen];
		return TCS_OK;
	}
	*number = TCS_NONE;
	status = source->bytes ? add_image(textures, &held, source->uri, spool,
					 number, &reason, report, fault)
			       : load_image(textures, source->uri, spool,
					 number, &reason, report, fault);
	if (!status && reason)
		status = note_missing(source->uri, reason, report, fault);
	textures->of_source.at[textures->of_source.count++] = *number;
	return status;
}

enum tcs_status
textures_take(struct textures *textures, uint32_t entry, const char *uri,
	const unsigned char *bytes, uint64_t size, struct spool *spool,
	struct report *report, struct tcs_fault *fault)
{
	const struct image_source source = {bytes, size, uri, entry, true};
	uint32_t number;

	return find_image(textures, &source, spool, &number, report, fault);
}

static enum texture_wrap
wrap_of(uint32_t wrap)
{
	if (wrap == TCS_WRAP_REPEAT)
		return TEXTURE_REPEAT;
	return wrap == TCS_WRAP_MIRROR ? TEXTURE_MIRROR : TEXTURE_CLAMP;
}

static enum tcs_status
find_texture(struct textures *textures, uint32_t image, enum texture_wrap wrap,
	uint32_t *number, struct tcs_fault *fault)
{
	const uint32_t key[2] = {image, wrap};
	bool added;
	enum tcs_status status = byte_index_add(
		&textures->by_texture, key, sizeof key, number, &added, fault);

	if (status || !added)
		return status;
	if (array_grow(&textures->list, 1))
		return fault_memory(fault);
	textures->list.at[textures->list.count++] =
		(struct texture){image, wrap};
	return TCS_OK;
}

enum tcs_status
textures_find(struct textures *textures, uint32_t entry,
	const struct tcs_palette *palette, struct spool *spool,
	uint32_t *number, struct report *report, struct tcs_fault *fault)
{
	const struct tcs_image *image = palette->images.at + entry;
	const struct image_source source = {
		.uri = palette_text(palette, image->uri),
		.entry = entry,
		.embedded = image->byte_count > 0,
	};
	enum tcs_status status =
		find_image(textures, &source, spool, number, report, fault);

	if (status || *number == TCS_NONE)
		return status;
	return find_texture(
		textures, *number, wrap_of(image->wrap), number, fault);
}

void
textures_release(struct textures *textures)
{
	for (size_t i = 0; i < textures->images.count; i++)
		free(textures->images.at[i].name);
	array_release(&textures->images);
	array_release(&textures->list);
	array_release(&textures->of_source);
	byte_index_release(&textures->by_source);
	byte_index_release(&textures->by_texture);
	folder_close(&textures->folder);
}
