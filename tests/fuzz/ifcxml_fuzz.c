/*
 * The bytes as ifcXML: what becomes of them is a STEP file, all of whose
 * statements are well-formed, and no instance of it is malformed.
 */
#include <stdlib.h>

#include "parsers/ifcxml.h"
#include "parsers/step_file.h"

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size);

static void
values_check(const struct step_file *file)
{
	for (uint32_t i = 0; i < file->instances.count; i++) {
		struct step_cursor cursor = step_parameters(file, i);
		struct step_value value;

		while (step_next(&cursor, &value) > STEP_END)
			continue;
		if (value.kind == STEP_BAD)
			abort();
	}
}

int
LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
	struct step_bytes text = {.count = 0};
	struct report report = {.counts.count = 0};
	struct step_file file = {.text = NULL};
	struct tcs_fault fault;

	if (!ifcxml_decode((const char *)bytes, size, &text, &report, &fault)) {
		report_clear(&report);
		if (step_index(&file, text.at, text.count, &report, &fault) ==
			TCS_BAD_INPUT)
			abort();
		values_check(&file);
	}
	step_release(&file);
	array_release(&text);
	report_release(&report);
	return 0;
}
