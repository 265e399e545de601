#include "tally_report.h"

#include "tcs_field.h"

enum tcs_status
tally_report(const struct tcs_tally *tally, struct report *report,
	struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	for (size_t i = 0; !status && i < fields_tally.count; i++) {
		const struct tcs_field *field = &fields_tally.at[i];

		status = report_add(
			report, field->name, field_get(field, tally), fault);
	}
	return status;
}
