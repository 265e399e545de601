#include "compare_metrics.h"

#include <math.h>
#include <string.h>

enum metric_sum {
	METRIC_SUM,
	METRIC_MAX,
	METRIC_BEFORE,
	METRIC_BEFORE_SQUARE,
	METRIC_AFTER,
	METRIC_AFTER_SQUARE,
	METRIC_PIXELS,
};

struct metric_row {
	const char *name;
	int decimals;
	enum metric_sum sum;
};

static const struct metric_row rows[] = {
#define METRIC_ROW(number, name, decimals, sum) {name, decimals, METRIC_##sum},
	COMPARE_METRICS(METRIC_ROW)
#undef METRIC_ROW
};

/* The mean over the areas so far and one more, of squares or of values. */
static double
mean_with(double mean, double area, double value, double more, bool square)
{
	double whole = area + more;

	if (!(whole > 0))
		return mean;
	if (square)
		return sqrt(
			(mean * mean * area + value * value * more) / whole);
	return (mean * area + value * more) / whole;
}

void
metrics_add(struct compare_metrics *sum, const struct compare_metrics *object)
{
	double before = sum->at[COMPARE_AREA_BEFORE];
	double after = sum->at[COMPARE_AREA_AFTER];
	double pixels = sum->at[COMPARE_PIXELS];

	for (int i = 0; i < COMPARE_METRIC_COUNT; i++) {
		double value = object->at[i];
		enum metric_sum how = rows[i].sum;

		if (!isfinite(value))
			continue;
		if (how == METRIC_SUM)
			sum->at[i] += value;
		else if (how == METRIC_MAX)
			sum->at[i] = fmax(sum->at[i], value);
		else if (how == METRIC_BEFORE || how == METRIC_BEFORE_SQUARE)
			sum->at[i] = mean_with(sum->at[i], before, value,
				object->at[COMPARE_AREA_BEFORE],
				how == METRIC_BEFORE_SQUARE);
		else if (how == METRIC_PIXELS)
			sum->at[i] = mean_with(sum->at[i], pixels, value,
				object->at[COMPARE_PIXELS], false);
		else
			sum->at[i] = mean_with(sum->at[i], after, value,
				object->at[COMPARE_AREA_AFTER],
				how == METRIC_AFTER_SQUARE);
	}
}

double
metrics_rate(const struct compare_metrics *metrics)
{
	double before = metrics->at[COMPARE_TRIANGLES_BEFORE];

	return before > 0 ? 1 - metrics->at[COMPARE_TRIANGLES_AFTER] / before
			  : 0;
}

/* Rounded, and without the sign of what rounds to zero. */
static void
print_rounded(double value, int decimals, FILE *to)
{
	double unit = pow(10, decimals);

	if (!isfinite(value)) {
		fputs("null", to);
		return;
	}
	if (fabs(value) * unit < 0.5)
		value = 0;
	fprintf(to, "%.*f", decimals, value);
}

void
metrics_print_json(const struct compare_metrics *metrics, FILE *to)
{
	fputs(",\"rate\":", to);
	print_rounded(metrics_rate(metrics), 6, to);
	for (int i = 0; i < COMPARE_METRIC_COUNT; i++) {
		fprintf(to, ",\"%s\":", rows[i].name);
		print_rounded(metrics->at[i], rows[i].decimals, to);
	}
}

void
metrics_print_html(const struct compare_metrics *metrics, FILE *to)
{
	for (int i = 0; i < COMPARE_METRIC_COUNT; i++) {
		fprintf(to, "<tr><th>%s<td>", rows[i].name);
		print_rounded(metrics->at[i], rows[i].decimals, to);
		putc('\n', to);
	}
}

static void
print_distances(
	const struct compare_metrics *m, const char *label, int first, FILE *to)
{
	if (!isfinite(m->at[first]))
		return;
	fprintf(to,
		"  %s  max %.6f m (at most %.6f), mean %.6f, rms %.6f,"
		" every %.3f m\n",
		label, m->at[first], m->at[first + 1], m->at[first + 2],
		m->at[first + 3], m->at[first + 4]);
}

static void
print_health(const struct compare_metrics *m, FILE *to)
{
	for (int i = COMPARE_OPEN_BEFORE; i < COMPARE_CROSSING_NEW; i += 2) {
		if (!(m->at[i] > 0) && !(m->at[i + 1] > 0))
			continue;
		fprintf(to, "  %.*s  %.0f -> %.0f\n",
			(int)(strlen(rows[i].name) - strlen("_before")),
			rows[i].name, m->at[i], m->at[i + 1]);
	}
	if (m->at[COMPARE_CROSSING_NEW] > 0)
		fprintf(to, "  crossing_components_new  %.0f\n",
			m->at[COMPARE_CROSSING_NEW]);
	if (m->at[COMPARE_FLIPPED] > 0)
		fprintf(to, "  flipped_triangles  %.0f\n",
			m->at[COMPARE_FLIPPED]);
}

static void
print_views(const struct compare_metrics *m, FILE *to)
{
	const double *at = m->at;

	if (!(at[COMPARE_PIXELS] > 0))
		return;
	fprintf(to,
		"  looks       %.2f %% similar, %.2f %% hit, %.2f %% of the same"
		" surface\n",
		at[COMPARE_SIMILARITY], at[COMPARE_HIT],
		at[COMPARE_SAME_SURFACE]);
	fprintf(to,
		"  seen        %.0f components, %.0f hidden; %.0f contacts, %.0f"
		" broken; %.0f surfaces, %.0f hidden, %.0f uncovered\n",
		at[COMPARE_COMPONENTS_SEEN], at[COMPARE_COMPONENTS_HIDDEN],
		at[COMPARE_CONTACTS_SEEN], at[COMPARE_CONTACTS_SEEN_BROKEN],
		at[COMPARE_SURFACES_SEEN], at[COMPARE_SURFACES_HIDDEN],
		at[COMPARE_SURFACES_UNCOVERED]);
	fprintf(to, "  behind      %.0f boxes seen -> %.0f, %.0f opened\n",
		at[COMPARE_BOXES_BEFORE], at[COMPARE_BOXES_AFTER],
		at[COMPARE_BOXES_OPENED]);
}

void
metrics_print(const struct compare_metrics *m, FILE *to)
{
	const double *at = m->at;

	fprintf(to, "  triangles   %.0f -> %.0f, rate %.1f %%\n",
		at[COMPARE_TRIANGLES_BEFORE], at[COMPARE_TRIANGLES_AFTER],
		100 * metrics_rate(m));
	fprintf(to,
		"  components  %.0f -> %.0f: %.0f lost, %.0f crushed,"
		" %.0f floating, %.0f flipped\n",
		at[COMPARE_COMPONENTS_BEFORE], at[COMPARE_COMPONENTS_AFTER],
		at[COMPARE_COMPONENTS_LOST], at[COMPARE_COMPONENTS_CRUSHED],
		at[COMPARE_COMPONENTS_FLOATING],
		at[COMPARE_COMPONENTS_FLIPPED]);
	fprintf(to,
		"  contacts    %.0f: %.0f kept, %.0f separated, %.0f half-open,"
		" %.0f lost; %.0f with a crushed side\n",
		at[COMPARE_CONTACTS_BEFORE], at[COMPARE_CONTACTS_KEPT],
		at[COMPARE_CONTACTS_SEPARATED], at[COMPARE_CONTACTS_HALF_OPEN],
		at[COMPARE_CONTACTS_LOST], at[COMPARE_CONTACTS_CRUSHED]);
	if (at[COMPARE_GAP_MAX] > 0)
		fprintf(to, "  widest gap  %.6f m\n", at[COMPARE_GAP_MAX]);
	fprintf(to, "  surfaces    %.0f: %.0f lost\n",
		at[COMPARE_SURFACES_BEFORE], at[COMPARE_SURFACES_LOST]);
	print_distances(m, "distance ", COMPARE_THERE_MAX, to);
	print_distances(m, "  and back", COMPARE_BACK_MAX, to);
	fprintf(to, "  area        %.3f -> %.3f m2\n", at[COMPARE_AREA_BEFORE],
		at[COMPARE_AREA_AFTER]);
	fprintf(to, "  volume      %.3f -> %.3f m3\n",
		at[COMPARE_VOLUME_BEFORE], at[COMPARE_VOLUME_AFTER]);
	print_health(m, to);
	print_views(m, to);
}
