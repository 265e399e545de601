#include "compare_print.h"

#include <inttypes.h>
#include <math.h>

#include "json_quote.h"
#include "labels.h"
#include "plain.h"
#include "program.h"

static const char *const states[] = {"kept", "separated", "half-open", "lost"};

static const char *
feature_id(const struct tcs_object *object, uint32_t feature)
{
	return object_text(object, object->features.at[feature].id);
}

static const char *
object_id(const struct tcs_object *object)
{
	return object && object->features.count ? feature_id(object, 0) : "";
}

static const char *
outcome_of(const struct tcs_object *before, const struct tcs_object *after)
{
	return !before ? "added" : !after ? "lost" : "both";
}

/* ---- JSON ---------------------------------------------------------------- */

static void
print_broken_json(const struct compare_result *result,
	const struct tcs_object *before, FILE *to)
{
	fputs(",\"broken\":[", to);
	for (size_t i = 0; i < result->broken.count; i++) {
		const struct broken_contact *broken = &result->broken.at[i];
		uint32_t a = result->features.at[2 * i];
		uint32_t b = result->features.at[2 * i + 1];

		fprintf(to, "%s\n   {\"state\":\"%s\",\"a\":", i ? "," : "",
			states[broken->state]);
		json_quote(feature_id(before, a), to);
		fputs(",\"b\":", to);
		json_quote(feature_id(before, b), to);
		if (broken->state == CONTACT_SEPARATED)
			fprintf(to, ",\"gap\":%.6f", broken->gap);
		putc('}', to);
	}
	putc(']', to);
}

static void
print_lost_json(const struct compare_result *result,
	const struct tcs_object *before, FILE *to)
{
	fputs(",\"surfaces_lost_ids\":[", to);
	for (size_t i = 0; i < result->lost.count; i++) {
		uint32_t feature = result->lost.at[i];

		fprintf(to, "%s\n   {\"class\":\"%s\",\"id\":", i ? "," : "",
			label_of(before->features.at[feature].class)->name);
		json_quote(feature_id(before, feature), to);
		putc('}', to);
	}
	putc(']', to);
}

void
compare_print_begin(bool json, FILE *to)
{
	if (json)
		fputs("{\"program\":\"tcs-compare\",\"version\":\"" TESSERA_VERSION
		      "\",\"objects\":[",
			to);
}

static void
print_object_json(const struct compare_result *result,
	const struct tcs_object *before, const struct tcs_object *after,
	bool first, FILE *to)
{
	fprintf(to, "%s\n {\"id\":", first ? "" : ",");
	json_quote(object_id(before ? before : after), to);
	fprintf(to, ",\"outcome\":\"%s\"", outcome_of(before, after));
	metrics_print_json(&result->metrics, to);
	print_broken_json(result, before, to);
	print_lost_json(result, before, to);
	putc('}', to);
}

/* ---- text ---------------------------------------------------------------- */

void
compare_print_object(const struct compare_result *result,
	const struct tcs_object *before, const struct tcs_object *after,
	bool json, bool first, FILE *to)
{
	const char *id = object_id(before ? before : after);

	if (json) {
		print_object_json(result, before, after, first, to);
		return;
	}
	plain_print(to, *id ? id : "(no id)");
	if (!before || !after)
		fprintf(to, ": %s", outcome_of(before, after));
	putc('\n', to);
	metrics_print(&result->metrics, to);
}

void
compare_print_end(const struct compare_totals *totals, bool json, FILE *to)
{
	if (!json) {
		fprintf(to,
			"all: %" PRIu64 " objects, %" PRIu64 " lost, %" PRIu64
			" added\n",
			totals->pairs, totals->lost, totals->added);
		metrics_print(&totals->metrics, to);
		return;
	}
	fprintf(to,
		"],\n \"all\":{\"objects\":%" PRIu64
		",\"objects_lost\":%" PRIu64 ",\"objects_added\":%" PRIu64,
		totals->pairs, totals->lost, totals->added);
	metrics_print_json(&totals->metrics, to);
	fputs("}}\n", to);
}
