#include "citygml_raw.h"

#include <stdlib.h>

struct raw_object *
raw_new(void)
{
	return calloc(1, sizeof(struct raw_object));
}

void
raw_free(struct raw_object *raw)
{
	if (!raw)
		return;
	object_release(&raw->tree);
	array_release(&raw->positions);
	array_release(&raw->rings);
	array_release(&raw->polygons);
	array_release(&raw->members);
	array_release(&raw->shells);
	array_release(&raw->geometries);
	array_release(&raw->targets);
	array_release(&raw->paints);
	report_release(&raw->report);
	palette_release(&raw->palette);
	free(raw);
}

void
raw_clear(struct raw_object *raw)
{
	object_clear(&raw->tree);
	array_clear(&raw->positions);
	array_clear(&raw->rings);
	array_clear(&raw->polygons);
	array_clear(&raw->members);
	array_clear(&raw->shells);
	array_clear(&raw->geometries);
	array_clear(&raw->targets);
	array_clear(&raw->paints);
	report_clear(&raw->report);
	palette_clear(&raw->palette);
	raw->number = 0;
	raw->has_links = false;
	raw->next = NULL;
}
