#include "check.h"
#include "simplify/compare_object.h"
#include "town_sample.h"

/* A building with features "1", "2" and "3" below it. */
static void
begin(struct tcs_object *o)
{
	const char *ids[] = {"0", "1", "2", "3"};

	object_clear(o);
	for (uint32_t i = 0; i < 4; i++)
		SAMPLE_PUSH(o->features,
			(struct tcs_feature){.id = SAMPLE_TEXT(o, ids[i]),
				.parent = i ? 0 : TCS_NONE,
				.class = i ? TCS_CLASS_BuildingInstallation
					   : TCS_CLASS_Building});
	SAMPLE_PUSH(o->geometries,
		(struct tcs_geometry){.lod = 3,
			.kind = TCS_MULTI_SURFACE,
			.flags = TCS_GEOMETRY_SIMPLIFIED});
}

static void
put_triangle(struct tcs_object *o, uint32_t feature, struct tcs_point a,
	struct tcs_point b, struct tcs_point c)
{
	uint32_t vertex = (uint32_t)o->vertices.count;

	SAMPLE_PUSH(o->polygons,
		(struct tcs_polygon){.surface = feature,
			.first_vertex = vertex,
			.vertex_count = 3,
			.first_triangle = (uint32_t)o->triangles.count,
			.triangle_count = 1});
	SAMPLE_PUSH(o->vertices, a);
	SAMPLE_PUSH(o->vertices, b);
	SAMPLE_PUSH(o->vertices, c);
	SAMPLE_PUSH(o->triangles,
		(struct tcs_triangle){{vertex, vertex + 1, vertex + 2}});
	o->geometries.at[0].polygon_count = (uint32_t)o->polygons.count;
}

static void
put_quad(struct tcs_object *o, uint32_t feature, const struct tcs_point p[4])
{
	put_triangle(o, feature, p[0], p[1], p[2]);
	put_triangle(o, feature, p[0], p[2], p[3]);
}

/* A sheet in the plane z, seen from above. */
static void
put_sheet(struct tcs_object *o, uint32_t feature, double x0, double y0,
	double x1, double y1, double z)
{
	put_quad(o, feature,
		(struct tcs_point[]){
			{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}});
}

static void
put_box(struct tcs_object *o, uint32_t feature, const double l[3],
	const double h[3])
{
	const struct tcs_point p[8] = {{l[0], l[1], l[2]}, {h[0], l[1], l[2]},
		{h[0], h[1], l[2]}, {l[0], h[1], l[2]}, {l[0], l[1], h[2]},
		{h[0], l[1], h[2]}, {h[0], h[1], h[2]}, {l[0], h[1], h[2]}};
	static const int faces[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7},
		{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};

	for (int i = 0; i < 6; i++)
		put_quad(o, feature,
			(struct tcs_point[]){p[faces[i][0]], p[faces[i][1]],
				p[faces[i][2]], p[faces[i][3]]});
}

/* What happened, as numbers; compare_contacts.h names them. */
struct outcome {
	double before, after; /* components */
	double lost, crushed, hidden, kept, separated, half_open, contacts_lost;
	double gap;
	double images; /* of the component before that came last */
};

static struct outcome
compare(struct tcs_object *a, struct tcs_object *b)
{
	struct compare_settings settings = {.lods = {-1, -1}, .pixels = 64};
	const struct compared_object pair[2] = {{a, NULL}, {b, NULL}};
	struct comparer comparer = {0};
	struct compare_result result = {0};
	const double *at = result.metrics.at;
	struct outcome out;
	struct tcs_fault fault;

	for (int i = 0; i < 2; i++)
		settings.crs[i] = (struct tcs_crs){
			.metres_per_unit = 1, .metres_per_unit_up = 1};
	sample_must(
		compare_objects(&comparer, &settings, pair, &result, &fault),
		&fault);
	out = (struct outcome){at[COMPARE_COMPONENTS_BEFORE],
		at[COMPARE_COMPONENTS_AFTER], at[COMPARE_COMPONENTS_LOST],
		at[COMPARE_COMPONENTS_CRUSHED], at[COMPARE_COMPONENTS_HIDDEN],
		at[COMPARE_CONTACTS_KEPT], at[COMPARE_CONTACTS_SEPARATED],
		at[COMPARE_CONTACTS_HALF_OPEN], at[COMPARE_CONTACTS_LOST],
		at[COMPARE_GAP_MAX], 0};
	if (out.before > 0)
		out.images = (double)match_images(
			&comparer.match, (uint32_t)out.before - 1)
				     .count;
	comparer_release(&comparer);
	compare_result_release(&result);
	object_clear(a);
	object_clear(b);
	return out;
}

static bool
is(double value, double expected)
{
	return fabs(value - expected) < 1e-9;
}

/* Two boxes of one feature, a hair apart, and what is made of them. */
static struct outcome
two_boxes_become(const double (*boxes)[3], size_t count)
{
	struct tcs_object a = {0}, b = {0};
	struct outcome out;

	begin(&a);
	put_box(&a, 1, (double[]){0, 0, 0}, (double[]){1, 1, 1});
	put_box(&a, 1, (double[]){1.005, 0, 0}, (double[]){2, 1, 1});
	begin(&b);
	for (size_t i = 0; i < count; i++)
		put_box(&b, 1, boxes[2 * i], boxes[2 * i + 1]);
	out = compare(&a, &b);
	object_release(&a);
	object_release(&b);
	return out;
}

static void
parts_of_one_feature_that_become_one_are_there(void)
{
	const double both[2][3] = {{0, 0, 0}, {2, 1, 1}};
	struct outcome out = two_boxes_become(both, 1);

	CHECK(is(out.before, 2) && is(out.after, 1));
	CHECK(is(out.lost, 0) && is(out.crushed, 0) && is(out.hidden, 0));
	CHECK(is(out.kept, 1) && is(out.contacts_lost, 0));
}

/* Points of their seam are deep in it, far from the faces of either. */
static void
what_becomes_one_solid_does_not_gape(void)
{
	struct tcs_object a = {0}, b = {0};
	struct outcome out;

	begin(&a);
	put_box(&a, 1, (double[]){0, 0, 0}, (double[]){1.9, 10, 10});
	put_box(&a, 1, (double[]){1.905, 0.05, 0.05},
		(double[]){2, 9.95, 9.95});
	begin(&b);
	put_box(&b, 1, (double[]){0, 0, 0}, (double[]){2, 10, 10});
	out = compare(&a, &b);
	CHECK(is(out.before, 2) && is(out.lost, 0));
	CHECK(is(out.kept, 1) && is(out.half_open, 0));
	object_release(&a);
	object_release(&b);
}

/* A bar between two leaves is in what both became, not in one of its pieces. */
static void
what_is_swallowed_is_in_all_of_it(void)
{
	struct tcs_object a = {0}, b = {0};
	struct outcome out;

	begin(&a);
	put_box(&a, 1, (double[]){0, 0, 0}, (double[]){1, 1, 1});
	put_box(&a, 1, (double[]){1.015, 0, 0}, (double[]){2, 1, 1});
	put_box(&a, 1, (double[]){1.005, 0.1, 0.1}, (double[]){1.01, 0.9, 0.9});
	begin(&b);
	put_box(&b, 1, (double[]){0, 0, 0}, (double[]){2, 1, 1});
	out = compare(&a, &b);
	CHECK(is(out.before, 3) && is(out.lost, 0));
	CHECK(is(out.images, 2));
	object_release(&a);
	object_release(&b);
}

/* Two leaves become a panel, with the pane between them or behind. */
static void
a_part_inside_a_solid_of_its_feature_is_there(void)
{
	static const double panes[][2] = {{0.1, 0}, {0.3, 1}}; /* y, lost */
	struct tcs_object a = {0}, b = {0};
	struct outcome out;

	for (int i = 0; i < 2; i++) {
		double y = panes[i][0];

		begin(&a);
		put_box(&a, 1, (double[]){0, 0, 0}, (double[]){1, 0.05, 1});
		put_box(&a, 1, (double[]){0.1, y, 0.1},
			(double[]){0.9, y + 0.02, 0.9});
		put_box(&a, 1, (double[]){0, 0.15, 0}, (double[]){1, 0.2, 1});
		begin(&b);
		put_box(&b, 1, (double[]){0, 0, 0}, (double[]){1, 0.2, 1});
		out = compare(&a, &b);
		CHECK(is(out.before, 3) && is(out.lost, panes[i][1]));
	}
	object_release(&a);
	object_release(&b);
}

/* The frame of a window stays, and passes by all corners of the pane. */
static void
a_part_whose_middle_nothing_passes_is_lost(void)
{
	static const double bars[4][2][3] = {{{0, 0, 0}, {1, 0.05, 0.1}},
		{{0, 0, 0.9}, {1, 0.05, 1}}, {{0, 0, 0.11}, {0.1, 0.05, 0.89}},
		{{0.9, 0, 0.11}, {1, 0.05, 0.89}}};
	struct tcs_object a = {0}, b = {0};
	struct outcome out;

	begin(&a);
	begin(&b);
	for (int i = 0; i < 4; i++) {
		put_box(&a, 1, bars[i][0], bars[i][1]);
		put_box(&b, 1, bars[i][0], bars[i][1]);
	}
	put_box(&a, 1, (double[]){0.1, 0, 0.1}, (double[]){0.9, 0.008, 0.9});
	out = compare(&a, &b);
	CHECK(is(out.before, 5) && is(out.after, 4) && is(out.lost, 1));
	object_release(&a);
	object_release(&b);
}

static void
a_part_of_one_feature_that_is_gone_is_lost(void)
{
	const double first[2][3] = {{0, 0, 0}, {1, 1, 1}};
	const double second[2][3] = {{1.005, 0, 0}, {2, 1, 1}};
	struct outcome out = two_boxes_become(first, 1);

	CHECK(is(out.lost, 1) && is(out.contacts_lost, 1) && is(out.kept, 0));
	out = two_boxes_become(second, 1);
	CHECK(is(out.lost, 1) && is(out.contacts_lost, 1) && is(out.kept, 0));
}

/* Its only contact goes where its second half went. */
static void
a_part_may_become_two(void)
{
	struct tcs_object a = {0}, b = {0};
	struct outcome out;

	begin(&a);
	put_sheet(&a, 1, 0, 0, 2, 1, 0);
	put_sheet(&a, 2, 2.005, 0, 3, 1, 0);
	begin(&b);
	put_sheet(&b, 1, 0, 0, 0.9, 1, 0);
	put_sheet(&b, 1, 1.1, 0, 2, 1, 0);
	put_sheet(&b, 2, 2.005, 0, 3, 1, 0);
	out = compare(&a, &b);
	CHECK(is(out.after, 3) && is(out.lost, 0) && is(out.kept, 1));
	object_release(&a);
	object_release(&b);
}

/* A window becomes part of its wall, by its feature or by that and a point that
   they share; beside the wall nothing else remains of it. */
static void
what_becomes_part_of_another_feature_is_there(void)
{
	struct tcs_object a = {0}, b = {0};
	struct outcome out;

	for (int left = 0; left < 3; left++) {
		begin(&a);
		put_box(&a, 1, (double[]){0, 0, 0}, (double[]){4, 0.3, 3});
		put_box(&a, 2, (double[]){1, 0.3, 1}, (double[]){2, 0.4, 2});
		begin(&b);
		put_box(&b, 1, (double[]){0, 0, 0}, (double[]){4, 0.3, 3});
		if (left > 0)
			put_box(&b, 1, (double[]){1, 0.3, 1},
				(double[]){2, 0.4, 2});
		if (left > 1)
			put_triangle(&b, 1, (struct tcs_point){0, 0.3, 0},
				(struct tcs_point){0, 0.3, 3},
				(struct tcs_point){1, 0.3, 1});
		out = compare(&a, &b);
		CHECK(is(out.after, left == 1 ? 2 : 1));
		CHECK(is(out.lost, left == 0) && is(out.kept, left > 0));
		CHECK(is(out.contacts_lost, left == 0));
	}
	object_release(&a);
	object_release(&b);
}

/* One half of the first is a component, the other is sewn to the third. */
static void
a_part_may_become_one_and_a_region_of_another(void)
{
	struct tcs_object a = {0}, b = {0};
	struct outcome out;

	begin(&a);
	put_sheet(&a, 1, 0, 0, 2, 1, 0);
	put_sheet(&a, 3, 0, 1.005, 0.9, 3, 0);
	begin(&b);
	put_sheet(&b, 1, 1.1, 0, 2, 1, 0);
	put_sheet(&b, 1, 0, 0, 0.9, 1, 0);
	put_sheet(&b, 3, 0, 1, 0.9, 2, 0);
	put_sheet(&b, 3, 0, 2, 0.9, 3, 0);
	out = compare(&a, &b);
	CHECK(is(out.after, 2) && is(out.lost, 0) && is(out.kept, 1));
	object_release(&a);
	object_release(&b);
}

/* Coincident faces look different ways: what is left has not become both. */
static void
what_stood_on_a_part_of_its_feature_is_lost(void)
{
	const double plate[2][3] = {{-0.05, -0.05, 1}, {1.05, 1.05, 1.2}};
	struct tcs_object a = {0}, b = {0};
	struct outcome out;

	for (int left = 0; left < 2; left++) {
		begin(&a);
		put_box(&a, 1, plate[0], plate[1]);
		put_box(&a, 1, (double[]){0, 0, 0}, (double[]){1, 1, 1});
		begin(&b);
		if (left == 0)
			put_box(&b, 1, (double[]){0, 0, 0},
				(double[]){1, 1, 1});
		else
			put_box(&b, 1, plate[0], plate[1]);
		out = compare(&a, &b);
		CHECK(is(out.before, 2) && is(out.after, 1));
		CHECK(is(out.lost, 1) && is(out.contacts_lost, 1));
	}
	object_release(&a);
	object_release(&b);
}

/* Three sheets a hair apart: two side by side, one across both ends. */
static void
put_three(struct tcs_object *o)
{
	begin(o);
	put_sheet(o, 1, 0, 0, 1, 1, 0);
	put_sheet(o, 2, 1.005, 0, 2, 1, 0);
	put_sheet(o, 3, 0, 1.005, 2, 2, 0);
}

/* The same sewn to the third along edges of two triangles, so that all are one
   component; `gap` parts the first two. */
static void
put_sewn(struct tcs_object *o, double gap, bool with_second)
{
	double x0 = 1 - gap / 2, x1 = 1 + gap / 2;
	const struct tcs_point seam[] = {
		{0, 1, 0}, {x0, 1, 0}, {x1, 1, 0}, {2, 1, 0}};
	const struct tcs_point far[] = {{2, 2, 0}, {0, 2, 0}};

	begin(o);
	put_quad(o, 1,
		(struct tcs_point[]){{0, 0, 0}, {x0, 0, 0}, seam[1], seam[0]});
	if (with_second)
		put_quad(o, 2,
			(struct tcs_point[]){
				{x1, 0, 0}, {2, 0, 0}, seam[3], seam[2]});
	for (int i = 0; i < 3; i++)
		put_triangle(o, 3, seam[i], seam[i + 1], far[1]);
	put_triangle(o, 3, seam[3], far[0], far[1]);
}

static void
what_merges_across_features_is_there_and_joined(void)
{
	struct tcs_object a = {0}, b = {0};
	struct outcome out;

	put_three(&a);
	put_sewn(&b, 0.004, true);
	out = compare(&a, &b);
	CHECK(is(out.before, 3) && is(out.after, 1));
	CHECK(is(out.lost, 0) && is(out.kept, 3));
	object_release(&a);
	object_release(&b);
}

static void
what_does_not_merge_with_the_others_is_lost(void)
{
	struct tcs_object a = {0}, b = {0};
	struct outcome out;

	put_three(&a);
	put_sewn(&b, 0.004, false);
	out = compare(&a, &b);
	CHECK(is(out.before, 3) && is(out.after, 1));
	CHECK(is(out.lost, 1) && is(out.kept, 1) && is(out.contacts_lost, 2));
	object_release(&a);
	object_release(&b);
}

/* One component by way of the third; where they touched they gape. */
static void
the_gap_is_that_of_the_regions(void)
{
	struct tcs_object a = {0}, b = {0};
	struct outcome out;

	put_three(&a);
	put_sewn(&b, 0.4, true);
	out = compare(&a, &b);
	CHECK(is(out.after, 1) && is(out.lost, 0));
	CHECK(is(out.kept, 2) && is(out.separated, 1) && is(out.gap, 0.4));
	object_release(&a);
	object_release(&b);
}

/* A sheet of feature 1, and a triangle of legs of `size` that it is bent up
   to. */
static void
put_bent(struct tcs_object *o, double size)
{
	const struct tcs_point top = {0.1, 0.1, 0.5};

	put_sheet(o, 1, 0, 0, 4, 4, 0);
	put_triangle(o, 1, (struct tcs_point){4, 4, 0},
		(struct tcs_point){0, 4, 0}, top);
	put_triangle(o, 1, top, (struct tcs_point){0.1 + size, 0.1, 0.5},
		(struct tcs_point){0.1, 0.1 + size, 0.5});
}

/* Bent up to where another sheet of its feature was. */
static void
a_sliver_does_not_stand_for_a_part(void)
{
	struct tcs_object a = {0}, b = {0};
	struct outcome out;

	for (int large = 0; large < 2; large++) {
		begin(&a);
		put_sheet(&a, 1, 0, 0, 4, 4, 0);
		put_sheet(&a, 1, 0, 0, 1, 1, 0.5);
		begin(&b);
		put_bent(&b, large ? 0.6 : 0.1);
		out = compare(&a, &b);
		CHECK(is(out.before, 2) && is(out.after, 1));
		CHECK(is(out.lost, large ? 0 : 1));
	}
	object_release(&a);
	object_release(&b);
}

/* Where that one is still there, it stays what it is: what touches it there
   touches what was bent. */
static void
what_is_alive_takes_nothing_by_nearness(void)
{
	struct tcs_object a = {0}, b = {0};
	struct outcome out;

	begin(&a);
	put_sheet(&a, 1, 0, 0, 4, 4, 0);
	put_sheet(&a, 1, 0, 0, 1, 1, 0.5);
	put_sheet(&a, 2, -1, 0, -0.005, 1, 0);
	begin(&b);
	put_bent(&b, 0.6);
	put_sheet(&b, 1, 0, 0, 1, 1, 0.6);
	put_sheet(&b, 2, -1, 0.4, 0.095, 0.6, 0.5);
	out = compare(&a, &b);
	CHECK(is(out.before, 3) && is(out.after, 3));
	CHECK(is(out.lost, 0) && is(out.separated, 0));
	object_release(&a);
	object_release(&b);
}

int
main(void)
{
	static const struct check_test tests[] = {
		CHECK_TEST(parts_of_one_feature_that_become_one_are_there),
		CHECK_TEST(what_becomes_one_solid_does_not_gape),
		CHECK_TEST(what_is_swallowed_is_in_all_of_it),
		CHECK_TEST(a_part_inside_a_solid_of_its_feature_is_there),
		CHECK_TEST(a_part_whose_middle_nothing_passes_is_lost),
		CHECK_TEST(a_part_of_one_feature_that_is_gone_is_lost),
		CHECK_TEST(a_part_may_become_two),
		CHECK_TEST(a_part_may_become_one_and_a_region_of_another),
		CHECK_TEST(what_becomes_part_of_another_feature_is_there),
		CHECK_TEST(what_stood_on_a_part_of_its_feature_is_lost),
		CHECK_TEST(what_merges_across_features_is_there_and_joined),
		CHECK_TEST(what_does_not_merge_with_the_others_is_lost),
		CHECK_TEST(the_gap_is_that_of_the_regions),
		CHECK_TEST(a_sliver_does_not_stand_for_a_part),
		CHECK_TEST(what_is_alive_takes_nothing_by_nearness),
		{0},
	};

	return check_run(tests);
}
