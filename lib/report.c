#include "report.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "json_quote.h"
#include "output.h"
#include "plain.h"
#include "program.h"

static bool
same(const char *a, const char *b)
{
	return a == b || !strcmp(a, b);
}

void
report_clear(struct report *report)
{
	for (size_t i = 0; i < report->reasons.count; i++)
		for (int k = 0; k < REPORT_EXAMPLES; k++)
			free(report->reasons.at[i].examples[k]);
	for (size_t i = 0; i < report->entries.count; i++)
		free(report->entries.at[i].id);
	array_clear(&report->reasons);
	array_clear(&report->counts);
	report->last = 0;
	array_clear(&report->entries);
}

void
report_release(struct report *report)
{
	report_clear(report);
	array_release(&report->reasons);
	array_release(&report->counts);
	array_release(&report->entries);
}

/* Nearly always the very same text, which is looked for first. */
static size_t
count_find(const struct report *report, const char *name)
{
	const struct report_count *counts = report->counts.at;
	size_t i = report->last;

	for (; i < report->counts.count && i < report->last + 2; i++)
		if (counts[i].name == name)
			return i;
	for (i = 0; i < report->counts.count; i++)
		if (counts[i].name == name)
			return i;
	for (i = 0; i < report->counts.count; i++)
		if (*counts[i].name == *name && !strcmp(counts[i].name, name))
			break;
	return i;
}

enum tcs_status
report_add(struct report *report, const char *name, uint64_t count,
	struct tcs_fault *fault)
{
	size_t found = count_find(report, name);

	if (found == report->counts.count) {
		if (array_grow(&report->counts, 1))
			return fault_memory(fault);
		report->counts.at[report->counts.count++] =
			(struct report_count){name, 0};
	}
	report->counts.at[found].count += count;
	report->last = found;
	return TCS_OK;
}

/* The row of a reason, new where need be; NULL without memory. */
static struct report_reason *
reason_row(struct report *report, enum report_severity severity,
	const char *item, const char *reason)
{
	struct report_reason *row;

	for (size_t i = 0; i < report->reasons.count; i++) {
		row = &report->reasons.at[i];
		if (row->severity == severity && same(row->reason, reason) &&
			same(row->item, item))
			return row;
	}
	if (array_grow(&report->reasons, 1))
		return NULL;
	row = &report->reasons.at[report->reasons.count++];
	*row = (struct report_reason){
		.severity = severity, .item = item, .reason = reason};
	return row;
}

/* Keep `example` while there is room for one. */
static enum tcs_status
keep_example(
	struct report_reason *row, const char *example, struct tcs_fault *fault)
{
	for (int i = 0; i < REPORT_EXAMPLES; i++) {
		if (row->examples[i])
			continue;
		row->examples[i] = strdup(example);
		return row->examples[i] ? TCS_OK : fault_memory(fault);
	}
	return TCS_OK;
}

enum tcs_status
report_item(struct report *report, enum report_severity severity,
	const char *item, const char *reason, const char *id, uint64_t at,
	struct tcs_fault *fault)
{
	struct report_reason *row = reason_row(report, severity, item, reason);
	char place[32];

	if (!row)
		return fault_memory(fault);
	row->count++;
	if (id && *id)
		return keep_example(row, id, fault);
	if (at == TCS_NOWHERE)
		return TCS_OK;
	snprintf(place, sizeof place, "at %" PRIu64, at);
	return keep_example(row, place, fault);
}

static enum tcs_status
keep_entry(struct report *report, const struct report_entry *entry,
	struct tcs_fault *fault)
{
	struct report_entry own = *entry;

	if (report->entries.count == REPORT_ENTRIES)
		return TCS_OK;
	if (array_grow(&report->entries, 1))
		return fault_memory(fault);
	own.id = strdup(entry->id);
	if (!own.id)
		return fault_memory(fault);
	report->entries.at[report->entries.count++] = own;
	return TCS_OK;
}

enum tcs_status
report_listed(struct report *report, const char *item, const char *reason,
	const char *id, const char *class, struct tcs_fault *fault)
{
	const struct report_entry entry = {item, reason, (char *)id, class};
	enum tcs_status status = report_item(
		report, REPORT_NOTE, item, reason, id, TCS_NOWHERE, fault);

	return status ? status : keep_entry(report, &entry, fault);
}

enum tcs_status
report_merge(
	struct report *into, const struct report *from, struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	for (size_t i = 0; !status && i < from->counts.count; i++)
		status = report_add(into, from->counts.at[i].name,
			from->counts.at[i].count, fault);
	for (size_t i = 0; !status && i < from->reasons.count; i++) {
		const struct report_reason *more = &from->reasons.at[i];
		struct report_reason *row = reason_row(
			into, more->severity, more->item, more->reason);

		if (!row)
			return fault_memory(fault);
		row->count += more->count;
		for (int k = 0; k < REPORT_EXAMPLES; k++)
			if (!status && more->examples[k])
				status = keep_example(
					row, more->examples[k], fault);
	}
	for (size_t i = 0; !status && i < from->entries.count; i++)
		status = keep_entry(into, &from->entries.at[i], fault);
	return status;
}

enum tcs_status
report_strict(const struct report *report, struct tcs_fault *fault)
{
	for (size_t i = 0; i < report->reasons.count; i++) {
		const struct report_reason *row = &report->reasons.at[i];

		if (row->severity != REPORT_SKIPPED)
			continue;
		return fault_set(fault, TCS_BAD_INPUT, TCS_NOWHERE,
			"%s%s%s: %s", row->item, row->examples[0] ? " " : "",
			row->examples[0] ? row->examples[0] : "", row->reason);
	}
	return TCS_OK;
}

/* ---- lines ------------------------------------------------------------- */

/* "polygons", "geometries", "storeys", "classes" */
static void
print_plural(const char *item, FILE *to)
{
	size_t length = strlen(item);
	char last = length ? item[length - 1] : '\0';

	if (last == 'y' && length > 1 && !strchr("aeou", item[length - 2]))
		fprintf(to, "%.*sies", (int)length - 1, item);
	else if (last == 's')
		fprintf(to, "%ses", item);
	else
		fprintf(to, "%ss", item);
}

static void
print_reason(const struct report_reason *row, FILE *to)
{
	static const char *const done[] = {[REPORT_NOTE] = "",
		[REPORT_REPAIRED] = " repaired",
		[REPORT_SKIPPED] = " skipped"};
	uint64_t shown = 0;

	fprintf(to, "%" PRIu64 " ", row->count);
	if (row->count == 1)
		fputs(row->item, to);
	else
		print_plural(row->item, to);
	fprintf(to, "%s: %s", done[row->severity], row->reason);
	for (; shown < REPORT_EXAMPLES && row->examples[shown]; shown++) {
		fputs(shown ? ", " : " (", to);
		plain_print(to, row->examples[shown]);
	}
	if (shown)
		fputs(shown < row->count ? ", ...)" : ")", to);
	putc('\n', to);
}

void
report_print(const struct report *report, const char *program, FILE *to)
{
	for (size_t i = 0; i < report->reasons.count; i++) {
		fprintf(to, "%s: ", program);
		print_reason(&report->reasons.at[i], to);
	}
}

/* ---- JSON -------------------------------------------------------------- */

static void
json_list(
	const struct report *report, const struct report_reason *row, FILE *to)
{
	const char *before = ",\n   \"list\": [";

	for (size_t i = 0; i < report->entries.count; i++) {
		const struct report_entry *entry = &report->entries.at[i];

		if (!same(entry->reason, row->reason) ||
			!same(entry->item, row->item))
			continue;
		fprintf(to, "%s\n    {\"id\": ", before);
		json_quote(entry->id, to);
		fputs(", \"class\": ", to);
		json_quote(entry->class, to);
		putc('}', to);
		before = ",";
	}
	if (*before == ',' && before[1] == '\0')
		putc(']', to);
}

static void
json_reason(
	const struct report *report, const struct report_reason *row, FILE *to)
{
	fputs("\n  {\"item\": ", to);
	json_quote(row->item, to);
	fputs(", \"reason\": ", to);
	json_quote(row->reason, to);
	fprintf(to, ", \"count\": %" PRIu64 ", \"examples\": [", row->count);
	for (int i = 0; i < REPORT_EXAMPLES && row->examples[i]; i++) {
		if (i)
			fputs(", ", to);
		json_quote(row->examples[i], to);
	}
	putc(']', to);
	json_list(report, row, to);
	putc('}', to);
}

static void
json_reasons(const struct report *report, enum report_severity severity,
	const char *key, FILE *to)
{
	bool first = true;

	fprintf(to, ",\n \"%s\": [", key);
	for (size_t i = 0; i < report->reasons.count; i++) {
		const struct report_reason *row = &report->reasons.at[i];

		if (row->severity != severity)
			continue;
		if (!first)
			putc(',', to);
		first = false;
		json_reason(report, row, to);
	}
	putc(']', to);
}

static void
json_report(const struct report *report, const char *program, FILE *to)
{
	fputs("{\"program\": ", to);
	json_quote(program, to);
	fputs(", \"version\": \"" TESSERA_VERSION "\",\n \"counts\": {", to);
	for (size_t i = 0; i < report->counts.count; i++) {
		fputs(i ? ",\n  " : "\n  ", to);
		json_quote(report->counts.at[i].name, to);
		fprintf(to, ": %" PRIu64, report->counts.at[i].count);
	}
	putc('}', to);
	json_reasons(report, REPORT_SKIPPED, "skipped", to);
	json_reasons(report, REPORT_REPAIRED, "repaired", to);
	json_reasons(report, REPORT_NOTE, "notes", to);
	fputs("}\n", to);
}

enum tcs_status
report_write(const struct report *report, const char *program,
	const char *file_name, struct tcs_fault *fault)
{
	struct output output;
	enum tcs_status status = output_open(&output, file_name, fault);

	if (status)
		return status;
	json_report(report, program, output.file);
	return output_commit(&output, fault);
}
