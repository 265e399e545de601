#include "compare_html.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base64.h"
#include "program.h"

static const char *
id_of(const struct tcs_object *object)
{
	return object && object->features.count
		? object_text(object, object->features.at[0].id)
		: "";
}

/* ---- the gallery --------------------------------------------------------- */

static double
harm_of(const struct compare_metrics *m)
{
	return m->at[COMPARE_CONTACTS_LOST] +
		m->at[COMPARE_CONTACTS_HALF_OPEN] +
		m->at[COMPARE_CONTACTS_SEPARATED] +
		m->at[COMPARE_COMPONENTS_CRUSHED] +
		m->at[COMPARE_COMPONENTS_FLOATING] +
		m->at[COMPARE_COMPONENTS_FLIPPED];
}

static bool
is_worse(const struct compare_metrics *a, const struct compare_metrics *b)
{
	double p = harm_of(a), q = harm_of(b);

	if (p > q || p < q)
		return p > q;
	return a->at[COMPARE_THERE_MAX] > b->at[COMPARE_THERE_MAX];
}

static void
entry_release(struct gallery_entry *entry)
{
	free(entry->id);
	object_pictures_release(&entry->pictures);
	*entry = (struct gallery_entry){0};
}

enum tcs_status
gallery_take(struct gallery *gallery, struct compare_result *result,
	const struct tcs_object *before, struct tcs_fault *fault)
{
	struct gallery_entry entry = {.metrics = result->metrics};
	size_t at = gallery->count;

	if (!result->pictures.png[0].count)
		return TCS_OK;
	while (at > 0 &&
		is_worse(&entry.metrics, &gallery->entries[at - 1].metrics))
		at--;
	if (at == GALLERY_SIZE)
		return TCS_OK;
	entry.id = strdup(id_of(before));
	if (!entry.id)
		return fault_memory(fault);
	entry.pictures = result->pictures;
	result->pictures = (struct object_pictures){0};
	if (gallery->count == GALLERY_SIZE)
		entry_release(&gallery->entries[--gallery->count]);
	memmove(&gallery->entries[at + 1], &gallery->entries[at],
		(gallery->count - at) * sizeof *gallery->entries);
	gallery->entries[at] = entry;
	gallery->count++;
	return TCS_OK;
}

void
gallery_release(struct gallery *gallery)
{
	for (size_t i = 0; i < gallery->count; i++)
		entry_release(&gallery->entries[i]);
	gallery->count = 0;
}

/* ---- text ---------------------------------------------------------------- */

static void
print_text(const char *text, FILE *to)
{
	for (; *text; text++) {
		unsigned char c = (unsigned char)*text;

		if (c == '<')
			fputs("&lt;", to);
		else if (c == '&')
			fputs("&amp;", to);
		else
			putc(c < ' ' || c == 0x7f ? ' ' : c, to);
	}
}

static void
print_id(const char *id, FILE *to)
{
	print_text(*id ? id : "(no id)", to);
}

static void
print_base64(const struct png_bytes *bytes, FILE *to)
{
	enum { STEP = 3 * 1024 }; /* no padding but at the end */
	char text[BASE64_LENGTH(STEP)];

	for (size_t i = 0; i < bytes->count; i += STEP) {
		size_t left = bytes->count - i;
		size_t length = left < STEP ? left : STEP;

		base64_encode(text, bytes->at + i, length);
		fwrite(text, 1, BASE64_LENGTH(length), to);
	}
}

static void
print_picture(const struct png_bytes *png, const char *caption, FILE *to)
{
	fprintf(to,
		"<figure><img width=%d height=%d alt=\"%s\""
		" src=\"data:image/png;base64,",
		PICTURE_SIZE, PICTURE_SIZE, caption);
	print_base64(png, to);
	fprintf(to, "\"><figcaption>%s</figcaption></figure>\n", caption);
}

/* ---- the page ------------------------------------------------------------ */

/* Sections are printed as they become known, and shown in a better order. */
static const char head[] =
	"<!DOCTYPE html>\n<html lang=en>\n<meta charset=utf-8>\n"
	"<meta http-equiv=Content-Security-Policy content=\"default-src "
	"'none'; img-src data:; style-src 'unsafe-inline'\">\n"
	"<meta name=viewport content=\"width=device-width\">\n"
	"<title>tcs-compare</title>\n<style>\n"
	"body { display: flex; flex-direction: column; max-width: 66em;"
	" margin: 2em auto; padding: 0 1em;"
	" font: 15px/1.5 sans-serif; color: #222; background: #fff }\n"
	"h1, h2, h3 { font-weight: 600; line-height: 1.2 }\n"
	"h3 { margin: 1.5em 0 0.3em; overflow-wrap: anywhere }\n"
	"header { order: 0 } .gallery { order: 1 } .all { order: 2 }"
	" .objects { order: 3 }\n"
	"table { border-collapse: collapse; width: 100% }\n"
	"th, td { padding: 0.15em 0.6em; border-bottom: 1px solid #ddd;"
	" text-align: right; font-variant-numeric: tabular-nums }\n"
	"th:first-child, td:first-child { text-align: left;"
	" overflow-wrap: anywhere }\n"
	".all table { columns: 2; display: block } .all tr { display: flex;"
	" justify-content: space-between; break-inside: avoid }\n"
	".all th, .all td { border: 0 }\n"
	".row { display: flex; flex-wrap: wrap; gap: 0.8em }\n"
	"figure { margin: 0 } figcaption, p { color: #555 }\n"
	"img { display: block; border: 1px solid #ddd }\n"
	"</style>\n";

void
html_print_begin(FILE *to)
{
	fputs(head, to);
	fputs("<header><h1>How the second stream differs from the first</h1>\n"
	      "<p>Written by tcs-compare " TESSERA_VERSION
	      "; tcs-compare(1) says what each number means.</header>\n"
	      "<section class=objects><h2>Objects</h2>\n<table>\n"
	      "<tr><th>object<th>rate %<th>components lost<th>crushed"
	      "<th>floating<th>contacts<th>separated<th>half-open<th>lost"
	      "<th>surfaces lost<th>distance m<th>back m<th>similarity %\n",
		to);
}

static void
print_cell(double value, int decimals, FILE *to)
{
	if (isfinite(value))
		fprintf(to, "<td>%.*f", decimals, value);
	else
		fputs("<td>", to);
}

void
html_print_object(const struct compare_result *result,
	const struct tcs_object *before, const struct tcs_object *after,
	FILE *to)
{
	static const struct {
		enum compare_metric number;
		int decimals;
	} cells[] = {
		{COMPARE_COMPONENTS_LOST, 0},
		{COMPARE_COMPONENTS_CRUSHED, 0},
		{COMPARE_COMPONENTS_FLOATING, 0},
		{COMPARE_CONTACTS_BEFORE, 0},
		{COMPARE_CONTACTS_SEPARATED, 0},
		{COMPARE_CONTACTS_HALF_OPEN, 0},
		{COMPARE_CONTACTS_LOST, 0},
		{COMPARE_SURFACES_LOST, 0},
		{COMPARE_THERE_MAX, 3},
		{COMPARE_BACK_MAX, 3},
		{COMPARE_SIMILARITY, 1},
	};
	fputs("<tr><td>", to);
	print_id(id_of(before ? before : after), to);
	if (!before || !after)
		fputs(before ? " (lost)" : " (added)", to);
	print_cell(100 * metrics_rate(&result->metrics), 1, to);
	for (size_t i = 0; i < sizeof cells / sizeof *cells; i++)
		print_cell(result->metrics.at[cells[i].number],
			cells[i].decimals, to);
	putc('\n', to);
}

static void
print_gallery(const struct gallery *gallery, FILE *to)
{
	static const char *const captions[PICTURE_COUNT] = {
		"before", "after", "before, by its distance from after"};

	fputs("<section class=gallery><h2>Those that differ most</h2>\n", to);
	fputs("<p>In the third picture grey is unchanged, red is four times "
	      "eps or more away, and blue is where only the second stream "
	      "shows something.\n",
		to);
	for (size_t i = 0; i < gallery->count; i++) {
		const struct gallery_entry *entry = &gallery->entries[i];
		const double *at = entry->metrics.at;

		fputs("<article><h3>", to);
		print_id(entry->id, to);
		fprintf(to,
			"</h3>\n<p>%.0f of %.0f triangles, %.0f of %.0f "
			"contacts kept, %.0f components lost, %.3f m at most, "
			"%.1f %% similar\n<div class=row>\n",
			at[COMPARE_TRIANGLES_AFTER],
			at[COMPARE_TRIANGLES_BEFORE], at[COMPARE_CONTACTS_KEPT],
			at[COMPARE_CONTACTS_BEFORE],
			at[COMPARE_COMPONENTS_LOST], at[COMPARE_THERE_AT_MOST],
			at[COMPARE_SIMILARITY]);
		for (int k = 0; k < PICTURE_COUNT; k++)
			print_picture(&entry->pictures.png[k], captions[k], to);
		fputs("</div></article>\n", to);
	}
	fputs("</section>\n", to);
}

void
html_print_end(const struct compare_totals *totals,
	const struct gallery *gallery, FILE *to)
{
	fputs("</table></section>\n", to);
	print_gallery(gallery, to);
	fprintf(to,
		"<section class=all><h2>All objects</h2>\n<p>%" PRIu64
		" in both, %" PRIu64 " lost, %" PRIu64 " added\n<table>\n",
		totals->pairs, totals->lost, totals->added);
	metrics_print_html(&totals->metrics, to);
	fputs("</table></section>\n</html>\n", to);
}
