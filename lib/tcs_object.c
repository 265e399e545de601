#include <string.h>

#include "tcs.h"

const char *
object_text(const struct tcs_object *object, tcs_text text)
{
	return text ? object->text.at + text : "";
}

void
object_release(struct tcs_object *object)
{
	array_release(&object->text);
	array_release(&object->features);
	array_release(&object->attributes);
	array_release(&object->relations);
	array_release(&object->geometries);
	array_release(&object->shells);
	array_release(&object->polygons);
	array_release(&object->rings);
	array_release(&object->vertices);
	array_release(&object->triangles);
	array_release(&object->paints);
	array_release(&object->texcoords);
	array_release(&object->instances);
}

void
object_clear(struct tcs_object *object)
{
	array_clear(&object->text);
	array_clear(&object->features);
	array_clear(&object->attributes);
	array_clear(&object->relations);
	array_clear(&object->geometries);
	array_clear(&object->shells);
	array_clear(&object->polygons);
	array_clear(&object->rings);
	array_clear(&object->vertices);
	array_clear(&object->triangles);
	array_clear(&object->paints);
	array_clear(&object->texcoords);
	array_clear(&object->instances);
}

enum tcs_status
text_append_to(struct tcs_strings *text, const char *string, size_t length,
	tcs_text *out, struct tcs_fault *fault)
{
	size_t start = text->count ? text->count : 1;

	*out = 0;
	if (!length)
		return TCS_OK;
	if (length >= UINT32_MAX || start > UINT32_MAX - length - 1)
		return fault_set(fault, TCS_LIMIT, TCS_NOWHERE,
			"the text of one record exceeds 4 GiB");
	if (array_grow(text, length + 2))
		return fault_memory(fault);
	text->at[0] = '\0';
	memcpy(text->at + start, string, length);
	text->at[start + length] = '\0';
	text->count = start + length + 1;
	*out = (tcs_text)start;
	return TCS_OK;
}
