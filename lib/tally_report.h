/* What passed in a stream, as the counts of a report. */
#ifndef TESSERA_TALLY_REPORT_H
#define TESSERA_TALLY_REPORT_H

#include "report.h"
#include "tcs.h"

/* Add every count of the tally, also zeros, by its field's name. */
enum tcs_status tally_report(const struct tcs_tally *tally,
	struct report *report, struct tcs_fault *fault) TCS_CHECKED;

#endif
