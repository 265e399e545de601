#include "citygml_raw.h"

#include <stdio.h>
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
	array_release(&raw->texrings);
	array_release(&raw->texmatrices);
	array_release(&raw->aliases);
	array_release(&raw->templates);
	array_release(&raw->instances);
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
	array_clear(&raw->texrings);
	array_clear(&raw->texmatrices);
	array_clear(&raw->aliases);
	array_clear(&raw->templates);
	array_clear(&raw->instances);
	report_clear(&raw->report);
	palette_clear(&raw->palette);
	raw->place = (struct raw_place){0};
	raw->has_links = raw->waits = false;
	raw->next = NULL;
}

enum tcs_status
raw_report(struct report *report, enum report_severity severity,
	const char *item, const char *reason, const char *id, uint32_t line,
	struct tcs_fault *fault)
{
	char place[32];

	if (!id || !*id) {
		snprintf(place, sizeof place, "line %u", line);
		id = place;
	}
	return report_item(
		report, severity, item, reason, id, TCS_NOWHERE, fault);
}
