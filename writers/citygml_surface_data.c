/* The materials and images of the stream, for all workers. */
#include <string.h>

#include "citygml_compose.h"

enum tcs_status
gml_palette_add(struct gml_palette *palette, const struct tcs_palette *more,
	uint64_t object, struct tcs_fault *fault)
{
	size_t materials = more->materials.count, images = more->images.count;
	struct tcs_palette named = *more;
	enum tcs_status status;

	named.bytes.at = NULL;
	named.bytes.count = 0;
	pthread_rwlock_wrlock(&palette->lock);
	status = palette_append(&palette->all, &named, fault);
	if (!status &&
		(array_grow(&palette->material_objects, materials) ||
			array_grow(&palette->image_objects, images)))
		status = fault_memory(fault);
	for (size_t i = 0; i < materials && !status; i++)
		palette->material_objects
			.at[palette->material_objects.count++] = object;
	for (size_t i = 0; i < images && !status; i++)
		palette->image_objects.at[palette->image_objects.count++] =
			object;
	pthread_rwlock_unlock(&palette->lock);
	return status;
}

void
gml_palette_release(struct gml_palette *palette)
{
	palette_release(&palette->all);
	array_release(&palette->material_objects);
	array_release(&palette->image_objects);
}

static const char *
kept(struct composer *composer, const struct tcs_palette *palette,
	tcs_text text)
{
	const char *from = palette_text(palette, text);
	const char *copy = arena_copy(&composer->arena, from, strlen(from));

	if (!copy)
		composer->out->markup.failed = true;
	return copy ? copy : "";
}

/* Only in the object it stands before, and in prototypes between them, does an
 * entry keep its id: it would be there twice, and which object is the first to
 * use it no worker knows. */
static const char *
own_id(struct composer *composer, uint64_t object, tcs_text id)
{
	if (object != composer->before)
		return "";
	return kept(composer, &composer->plan->palette->all, id);
}

struct gml_material
gml_material_at(struct composer *composer, uint32_t index)
{
	struct gml_palette *palette = composer->plan->palette;
	struct gml_material material;

	pthread_rwlock_rdlock(&palette->lock);
	material.is = palette->all.materials.at[index];
	material.id = own_id(
		composer, palette->material_objects.at[index], material.is.id);
	pthread_rwlock_unlock(&palette->lock);
	return material;
}

struct gml_image
gml_image_at(struct composer *composer, uint32_t index)
{
	struct gml_palette *palette = composer->plan->palette;
	struct gml_image image;

	pthread_rwlock_rdlock(&palette->lock);
	image.is = palette->all.images.at[index];
	image.id =
		own_id(composer, palette->image_objects.at[index], image.is.id);
	image.uri = kept(composer, &palette->all, image.is.uri);
	image.mime = kept(composer, &palette->all, image.is.mime);
	image.type = kept(composer, &palette->all, image.is.type);
	pthread_rwlock_unlock(&palette->lock);
	return image;
}
