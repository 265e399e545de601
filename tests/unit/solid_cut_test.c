/* Booleans against volumes and faces worked out by hand. */
#include "solid_shapes.h"

static struct solid_cutter *cutter;

static bool
near(double a, double b)
{
	return fabs(a - b) <= 1e-9 * (1 + fabs(b));
}

static void
cut(const struct solid_task *task, struct solid *out,
	struct solid_report *report)
{
	shape_must(solid_cut(cutter, task, out, report, NULL, &shape_fault));
	CHECK(shape_measure(out).closed || report->outcome == SOLID_OPEN);
}

/* The volume of one tool's effect; 1e9 where something went wrong. */
static double
volume_of(enum solid_operation operation, const struct solid *host,
	const struct solid *tool)
{
	struct solid_task task = {.operation = operation,
		.host = host,
		.tools = &tool,
		.tool_count = 1};
	struct solid_report report;
	struct solid out = {0};
	double volume;

	cut(&task, &out, &report);
	volume = shape_measure(&out).volume;
	CHECK(near(report.volume, volume));
	CHECK((report.outcome == SOLID_EMPTY) == (out.faces.count == 0));
	solid_release(&out);
	return report.outcome > SOLID_EMPTY ? 1e9 : volume;
}

static size_t
faces_of(const struct solid *solid, uint32_t origin)
{
	size_t count = 0;

	for (size_t i = 0; i < solid->faces.count; i++)
		count += solid->faces.at[i].origin == origin;
	return count;
}

/* ---- two boxes --------------------------------------------------------------- */

static void
boxes_that_overlap_at_a_corner(void)
{
	struct solid a = shape_box(0, 0, 0, 1, 1, 1);
	struct solid b = shape_box(0.5, 0.5, 0.5, 2, 2, 2);

	CHECK(near(volume_of(SOLID_DIFFERENCE, &a, &b), 0.875));
	CHECK(near(volume_of(SOLID_INTERSECTION, &a, &b), 0.125));
	CHECK(near(volume_of(SOLID_UNION, &a, &b), 4.25));
	solid_release(&a);
	solid_release(&b);
}

static void
boxes_that_share_a_face_an_edge_or_a_corner(void)
{
	struct solid a = shape_box(0, 0, 0, 1, 1, 1);
	double shifts[3][3] = {{1, 0, 0}, {1, 1, 0}, {1, 1, 1}};

	for (int i = 0; i < 3; i++) {
		const double *s = shifts[i];
		struct solid b = shape_box(
			s[0], s[1], s[2], s[0] + 1, s[1] + 1, s[2] + 1);

		CHECK(near(volume_of(SOLID_DIFFERENCE, &a, &b), 1));
		CHECK(volume_of(SOLID_INTERSECTION, &a, &b) == 0);
		CHECK(near(volume_of(SOLID_UNION, &a, &b), 2));
		solid_release(&b);
	}
	solid_release(&a);
}

static void
a_solid_and_itself(void)
{
	struct solid a = shape_column(3, 4, 1, 24, 0.3, 0, 2);
	double volume = shape_measure(&a).volume;

	CHECK(volume_of(SOLID_DIFFERENCE, &a, &a) == 0);
	CHECK(near(volume_of(SOLID_INTERSECTION, &a, &a), volume));
	CHECK(near(volume_of(SOLID_UNION, &a, &a), volume));
	solid_release(&a);
}

static void
a_cavity_is_a_shell_inside(void)
{
	struct solid a = shape_box(0, 0, 0, 3, 3, 3);
	struct solid b = shape_box(1, 1, 1, 2, 2, 2);
	struct solid hollow = {0};
	struct solid_report report;
	const struct solid *tool = &b;
	struct solid_task task = {.host = &a, .tools = &tool, .tool_count = 1};

	cut(&task, &hollow, &report);
	CHECK(near(report.volume, 26) && hollow.faces.count == 12);
	/* and filling it again leaves the box */
	task = (struct solid_task){.operation = SOLID_UNION,
		.host = &hollow,
		.tools = &tool,
		.tool_count = 1};
	{
		struct solid filled = {0};

		cut(&task, &filled, &report);
		CHECK(near(report.volume, 27) && filled.faces.count == 6);
		solid_release(&filled);
	}
	solid_release(&a);
	solid_release(&b);
	solid_release(&hollow);
}

/* ---- walls and openings ------------------------------------------------------ */

static const struct shape_place places[] = {
	{{1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 0, 0}},
	{{0.8, -0.6, 0, 0.6, 0.8, 0, 0, 0, 1}, {691000.25, 5333000.5, 512}},
	{{0.36, 0.48, -0.8, -0.8, 0.6, 0, 0.48, 0.64, 0.6}, {3, -4, 100}},
};
enum { PLACES = sizeof places / sizeof *places };

static void
an_opening_flush_with_the_wall_leaves_no_skin(void)
{
	const double off[] = {0, 1e-6, -1e-6, 1e-9, -4e-6};

	for (int i = 0; i < PLACES * 5; i++) {
		double by = off[i / PLACES];
		struct solid wall = shape_box(0, 0, 0, 5, 0.24, 3);
		struct solid hole = shape_box(1, by, 1, 2, 0.24 - by, 2);
		const struct solid *tool = &hole;
		struct solid_task task = {
			.host = &wall, .tools = &tool, .tool_count = 1};
		struct solid_report report;
		struct solid out = {0};

		shape_move(&wall, &places[i % PLACES]);
		shape_move(&hole, &places[i % PLACES]);
		cut(&task, &out, &report);
		CHECK(report.outcome == SOLID_DONE);
		CHECK(fabs(report.volume - 3.36) < 1e-5);
		CHECK(out.faces.count == 10 && out.ring_ends.count == 12);
		CHECK(faces_of(&out, 0) == 6 && faces_of(&out, 1) == 4);
		solid_release(&wall);
		solid_release(&hole);
		solid_release(&out);
	}
}

static void
openings_that_touch_each_other_and_the_edge(void)
{
	struct solid wall = shape_box(0, 0, 0, 6, 0.3, 3), out = {0};
	struct solid holes[4] = {shape_box(1, -1, 1, 2, 1, 2),
		shape_box(2, -1, 1, 3, 1, 2), shape_box(3, -1, 2, 4, 1, 3),
		shape_box(0, -1, 0, 1, 1, 1)};
	const struct solid *tools[4] = {
		&holes[0], &holes[1], &holes[2], &holes[3]};
	struct solid_task task = {
		.host = &wall, .tools = tools, .tool_count = 4};
	struct solid_report report;

	cut(&task, &out, &report);
	CHECK(near(report.volume, (18 - 4) * 0.3));
	for (int i = 0; i < 4; i++)
		solid_release(&holes[i]);
	solid_release(&wall);
	solid_release(&out);
}

static void
openings_that_touch_in_a_corner_are_two_holes(void)
{
	struct solid wall = shape_box(0, 0, 0, 6, 0.3, 4), out = {0};
	struct solid holes[2] = {
		shape_box(1, -1, 1, 2, 1, 2), shape_box(2, -1, 2, 3, 1, 3)};
	const struct solid *tools[2] = {&holes[0], &holes[1]};
	struct solid_task task = {
		.host = &wall, .tools = tools, .tool_count = 2};
	struct solid_report report;

	cut(&task, &out, &report);
	CHECK(near(report.volume, (24 - 2) * 0.3));
	CHECK(out.faces.count == 6 + 8 && out.ring_ends.count == 14 + 4);
	CHECK(out.points.count == 14 * 4 + 4 * 4);
	for (int i = 0; i < 2; i++)
		solid_release(&holes[i]);
	solid_release(&wall);
	solid_release(&out);
}

static void
an_opening_through_several_layers(void)
{
	const double at[] = {0, 0.02, 0.14, 0.14001, 0.3};
	struct solid hole = shape_box(1, -1, 1, 2, 1, 2);
	double volume = 0;

	for (int i = 0; i < 4; i++) {
		struct solid layer = shape_box(0, at[i], 0, 4, at[i + 1], 3);

		if (i != 2)
			volume += volume_of(SOLID_DIFFERENCE, &layer, &hole);
		solid_release(&layer);
	}
	CHECK(fabs(volume - 11 * (0.3 - 0.00001)) < 1e-6);
	solid_release(&hole);
}

static void
a_wall_that_is_all_opening_is_empty(void)
{
	struct solid wall = shape_box(0, 0, 0, 4, 0.2, 3);
	struct solid left = shape_box(-1, -1, -1, 2, 1, 4);
	struct solid right = shape_box(2, 0, 0, 4, 0.2, 3);
	const struct solid *tools[2] = {&left, &right};
	struct solid_task task = {
		.host = &wall, .tools = tools, .tool_count = 2};
	struct solid_report report;
	struct solid out = {0};

	cut(&task, &out, &report);
	CHECK(report.outcome == SOLID_EMPTY && out.faces.count == 0);
	CHECK(near(report.host_volume, 2.4) && report.volume == 0);
	solid_release(&wall);
	solid_release(&left);
	solid_release(&right);
	solid_release(&out);
}

static void
round_holes_in_a_slab_come_out_as_rings(void)
{
	enum { HOLES = 12 };

	struct solid slab = shape_box(0, 0, 0, 8, 6, 0.25), out = {0};
	struct solid holes[HOLES];
	const struct solid *tools[HOLES];
	struct solid_task task = {
		.host = &slab, .tools = tools, .tool_count = HOLES};
	struct solid_report report;
	double area = 12 * 0.16 * sin(6.283185307179586 / 24);

	for (int i = 0; i < HOLES; i++) {
		holes[i] = shape_column(1 + 2 * (i % 4), 1 + 2 * (i / 4), 0.4,
			24, i * 0.1, i % 2 ? 0 : -1, 0.25);
		tools[i] = &holes[i];
	}
	cut(&task, &out, &report);
	CHECK(near(report.volume, (48 - HOLES * area) * 0.25));
	CHECK(out.faces.count == 6 + HOLES * 24);
	CHECK(out.ring_ends.count == 6 + HOLES * 24 + 2 * HOLES);
	for (int i = 0; i < HOLES; i++)
		solid_release(&holes[i]);
	solid_release(&slab);
	solid_release(&out);
}

/* ---- half-spaces ------------------------------------------------------------- */

static double
clipped(const struct solid *host, const struct solid_half_space *half_spaces,
	size_t count, struct solid *out)
{
	struct solid_task task = {.host = host,
		.half_spaces = half_spaces,
		.half_space_count = count};
	struct solid_report report;

	cut(&task, out, &report);
	CHECK(report.outcome <= SOLID_EMPTY);
	return report.volume;
}

static void
a_gable_is_clipped_by_its_roofs(void)
{
	struct solid wall = shape_box(0, 0, 0, 4, 0.3, 5), out = {0};
	struct solid_half_space roofs[2] = {
		{{0, 0, 3}, {-1, 0, 1}, 5}, {{4, 7, 3}, {30, 0, 30}, 6}};

	CHECK(near(clipped(&wall, roofs, 2, &out), 0.3 * (4 * 3 + 4)));
	CHECK(out.faces.count == 7 && out.points.count == 2 * 5 + 5 * 4);
	for (size_t i = 0; i < out.faces.count; i++) {
		const struct solid_face *face = &out.faces.at[i];

		CHECK(face->origin == 0 ? face->face != SOLID_NO_FACE
					: face->label == 4 + face->origin &&
					face->face == SOLID_NO_FACE);
	}
	solid_release(&wall);
	solid_release(&out);
}

static void
planes_through_corners_edges_and_faces(void)
{
	struct solid cube = shape_box(0, 0, 0, 1, 1, 1), out = {0};
	struct solid_half_space half = {{1, 0, 0}, {1, 1, 1}, 0};

	CHECK(near(clipped(&cube, &half, 1, &out), 1.0 / 6));
	CHECK(out.faces.count == 4);
	half = (struct solid_half_space){{0, 0, 0}, {1, -1, 0}, 0};
	CHECK(near(clipped(&cube, &half, 1, &out), 0.5));
	CHECK(out.faces.count == 5);
	half = (struct solid_half_space){{0, 0, 1}, {0, 0, 1}, 0};
	CHECK(near(clipped(&cube, &half, 1, &out), 1));
	CHECK(out.faces.count == 6 && faces_of(&out, 0) == 6);
	half = (struct solid_half_space){{0, 0, 1}, {0, 0, -1}, 0};
	CHECK(clipped(&cube, &half, 1, &out) == 0);
	half = (struct solid_half_space){{0, 0, 1 - 1e-6}, {0, 0, 1}, 0};
	CHECK(fabs(clipped(&cube, &half, 1, &out) - 1) < 1e-5);
	CHECK(out.faces.count == 6);
	half = (struct solid_half_space){{0, 0, 9}, {0, 0, 1}, 0};
	CHECK(clipped(&cube, &half, 1, &out) == 1);
	half = (struct solid_half_space){{0, 0, 9}, {0, 0, -1}, 0};
	CHECK(clipped(&cube, &half, 1, &out) == 0);
	solid_release(&cube);
	solid_release(&out);
}

static void
coordinates_that_stay_keep_every_bit(void)
{
	struct solid column = shape_column(0, 0, 0.7, 11, 0.3, 0, 3), out = {0};
	struct solid_half_space roof = {{0, 0, 0}, {0.3, 0.1, 1}, 0};
	size_t kept = 0;

	shape_move(&column, &places[1]);
	roof.point = shape_placed(&places[1], 0, 0, 2.5);
	clipped(&column, &roof, 1, &out);
	for (size_t i = 0; i < out.points.count; i++)
		for (size_t j = 0; j < 11; j++)
			kept += out.points.at[i].x == column.points.at[j].x &&
				out.points.at[i].y == column.points.at[j].y &&
				out.points.at[i].z == column.points.at[j].z;
	CHECK(kept == 33); /* eleven corners of three faces each */
	solid_release(&column);
	solid_release(&out);
}

/* ---- operands that are not as they should be --------------------------------- */

static void
an_open_tool_is_left_out(void)
{
	struct solid wall = shape_box(0, 0, 0, 4, 0.3, 3), out = {0};
	struct solid good = shape_box(1, -1, 1, 2, 1, 2);
	struct solid open = shape_box(3, -1, 1, 3.5, 1, 2);
	struct solid flat = shape_box(0.5, -1, 1, 0.500001, 1, 2);
	const struct solid *tools[3] = {&open, &good, &flat};
	enum solid_tool_fault faults[3];
	struct solid_task task = {
		.host = &wall, .tools = tools, .tool_count = 3};
	struct solid_report report;

	shape_drop_face(&open);
	shape_must(
		solid_cut(cutter, &task, &out, &report, faults, &shape_fault));
	CHECK(report.outcome == SOLID_DONE && near(report.volume, 3.3));
	CHECK(report.tools_left_out == 2);
	CHECK(faults[0] == SOLID_TOOL_OPEN && faults[1] == SOLID_TOOL_SOUND);
	CHECK(faults[2] == SOLID_TOOL_FLAT);
	solid_release(&wall);
	solid_release(&good);
	solid_release(&open);
	solid_release(&flat);
	solid_release(&out);
}

static void
faces_that_look_inwards_are_turned_over(void)
{
	struct solid wall = shape_box(0, 0, 0, 4, 0.3, 3), out = {0};
	struct solid hole = shape_box(1, -1, 1, 2, 1, 2);
	const struct shape_place mirror = {
		{-1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 0, 0}};
	const struct solid *tool = &hole;
	struct solid_task task = {
		.host = &wall, .tools = &tool, .tool_count = 1};
	struct solid_report report;

	shape_move(&wall, &mirror);
	shape_move(&hole, &mirror);
	cut(&task, &out, &report);
	CHECK(report.turned && report.tools_turned == 1);
	CHECK(report.outcome == SOLID_DONE && near(report.volume, 3.3));
	CHECK(near(shape_measure(&out).volume, 3.3));
	solid_release(&wall);
	solid_release(&hole);
	solid_release(&out);
}

static void
an_open_host_is_cut_but_not_capped(void)
{
	struct solid sheet = {0}, out = {0};
	struct solid hole = shape_box(1, 1, -1, 2, 2, 1);
	const struct tcs_point square[4] = {
		{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}};
	const uint32_t four = 4;
	const struct solid *tool = &hole;
	struct solid_half_space half = {{2.5, 0, 0}, {1, 0, 0}, 0};
	struct solid_task task = {.host = &sheet,
		.tools = &tool,
		.tool_count = 1,
		.half_spaces = &half,
		.half_space_count = 1};
	struct solid_report report;

	shape_must(solid_add_face(&sheet, square, &four, 1, 3, &shape_fault));
	cut(&task, &out, &report);
	CHECK(report.outcome == SOLID_OPEN);
	CHECK(out.faces.count == 1 && out.ring_ends.count == 2);
	CHECK(near(shape_measure(&out).area, 2.5 * 3 - 1));
	CHECK(out.faces.at[0].label == 3);
	solid_release(&sheet);
	solid_release(&hole);
	solid_release(&out);
}

static void
faces_that_meet_at_other_corners_are_closed(void)
{
	struct solid host = shape_box(0, 0, 0, 2, 1, 1);
	struct solid tool = shape_box(0.5, -1, 0.5, 1, 2, 2);
	const struct tcs_point halves[8] = {{0, 0, 1}, {1, 0, 1}, {1, 1, 1},
		{0, 1, 1}, {1, 0, 1}, {2, 0, 1}, {2, 1, 1}, {1, 1, 1}};
	const uint32_t four = 4;

	/* Its top as two halves, which the sides know nothing of. */
	for (int i = 0; i < 4; i++)
		host.points.at[4 + i] = halves[i];
	shape_must(
		solid_add_face(&host, halves + 4, &four, 1, 0, &shape_fault));
	CHECK(!shape_measure(&host).closed);
	CHECK(near(volume_of(SOLID_DIFFERENCE, &host, &tool), 1.75));
	CHECK(near(volume_of(SOLID_DIFFERENCE, &tool, &host), 2.25 - 0.25));
	solid_release(&host);
	solid_release(&tool);
}

static void
a_host_that_crosses_itself_is_said_to(void)
{
	struct solid host = shape_box(0, 0, 0, 2, 1, 1);
	struct solid tool = shape_box(0, 0, 0.5, 3, 1, 1);
	const struct solid *tools = &tool;
	struct solid_task task = {
		.host = &host, .tools = &tools, .tool_count = 1};
	struct solid_report report;
	struct solid out = {0};

	shape_add_box(&host, 1, 0, 0, 3, 1, 1);
	cut(&task, &out, &report);
	CHECK(report.outcome == SOLID_DONE && report.crossing);
	CHECK(near(report.volume, 1.5));
	solid_release(&host);
	solid_release(&tool);
	solid_release(&out);
}

static void
a_host_without_volume_is_refused_or_joined(void)
{
	struct solid flat = shape_box(0, 0, 0, 2, 1, 0), out = {0};
	struct solid_task task = {.operation = SOLID_UNION, .host = &flat};
	struct solid_report report;

	cut(&task, &out, &report);
	CHECK(report.outcome == SOLID_EMPTY);
	task.operation = SOLID_DIFFERENCE;
	cut(&task, &out, &report);
	CHECK(report.outcome == SOLID_REFUSED && out.faces.count == 6);
	solid_release(&flat);
	solid_release(&out);
}

static void
what_is_not_a_number_is_refused(void)
{
	struct solid host = shape_box(0, 0, 0, 2, 1, 1), out = {0};
	struct solid_half_space half = {{0, 0, 0}, {0, 0, 0}, 0};
	struct solid_task task = {
		.host = &host, .half_spaces = &half, .half_space_count = 1};
	struct solid_report report;

	cut(&task, &out, &report);
	CHECK(report.outcome == SOLID_REFUSED && report.reason);
	CHECK(out.faces.count == 6);
	task.half_space_count = 0;
	host.points.at[3].y = NAN;
	shape_must(solid_cut(cutter, &task, &out, &report, NULL, &shape_fault));
	CHECK(report.outcome == SOLID_REFUSED);
	solid_release(&host);
	solid_release(&out);
}

static const struct check_test tests[] = {
	CHECK_TEST(boxes_that_overlap_at_a_corner),
	CHECK_TEST(boxes_that_share_a_face_an_edge_or_a_corner),
	CHECK_TEST(a_solid_and_itself),
	CHECK_TEST(a_cavity_is_a_shell_inside),
	CHECK_TEST(an_opening_flush_with_the_wall_leaves_no_skin),
	CHECK_TEST(openings_that_touch_each_other_and_the_edge),
	CHECK_TEST(openings_that_touch_in_a_corner_are_two_holes),
	CHECK_TEST(an_opening_through_several_layers),
	CHECK_TEST(a_wall_that_is_all_opening_is_empty),
	CHECK_TEST(round_holes_in_a_slab_come_out_as_rings),
	CHECK_TEST(a_gable_is_clipped_by_its_roofs),
	CHECK_TEST(planes_through_corners_edges_and_faces),
	CHECK_TEST(coordinates_that_stay_keep_every_bit),
	CHECK_TEST(an_open_tool_is_left_out),
	CHECK_TEST(faces_that_look_inwards_are_turned_over),
	CHECK_TEST(an_open_host_is_cut_but_not_capped),
	CHECK_TEST(faces_that_meet_at_other_corners_are_closed),
	CHECK_TEST(a_host_that_crosses_itself_is_said_to),
	CHECK_TEST(a_host_without_volume_is_refused_or_joined),
	CHECK_TEST(what_is_not_a_number_is_refused),
	{0},
};

int
main(void)
{
	int status;

	cutter = solid_cutter_new();
	status = check_run(tests);
	solid_cutter_free(cutter);
	return status;
}
