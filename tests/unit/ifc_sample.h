/* An IFC file made of a few lines, for unit tests. */
#ifndef TESSERA_IFC_SAMPLE_H
#define TESSERA_IFC_SAMPLE_H

#include <stdlib.h>
#include <string.h>

#include "parsers/ifc_file.h"

struct sample {
	char *text;
	struct step_file step;
	struct ifc_file file;
	struct report report;
	struct tcs_fault fault;
};

static inline enum tcs_status
sample_open(struct sample *sample, const char *schema, const char *data)
{
	static const char format[] =
		"ISO-10303-21;HEADER;FILE_SCHEMA(('%s'));ENDSEC;DATA;%s"
		"ENDSEC;END-ISO-10303-21;";
	size_t room = sizeof format + strlen(schema) + strlen(data);

	*sample = (struct sample){.text = malloc(room)};
	if (!sample->text)
		abort();
	snprintf(sample->text, room, format, schema, data);
	if (step_index(&sample->step, sample->text, strlen(sample->text),
		    &sample->report, &sample->fault))
		abort();
	return ifc_open(&sample->file, &sample->step, &sample->fault);
}

static inline void
sample_close(struct sample *sample)
{
	ifc_close(&sample->file);
	step_release(&sample->step);
	report_release(&sample->report);
	free(sample->text);
}

static inline uint32_t
instance(const struct sample *sample, uint64_t id)
{
	return step_find(&sample->step, id);
}

#endif
