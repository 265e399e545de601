#include "simplify/sheets.h"

#include "check.h"

struct split {
	struct component_set set;
	struct sheets sheets;
};

static void
add(struct split *split, uint32_t feature, struct tcs_point a,
	struct tcs_point b, struct tcs_point c)
{
	const struct tcs_point corners[3] = {a, b, c};
	struct tcs_fault fault;

	CHECK(!component_set_add(
		&split->set, corners, feature, TCS_NONE, &fault));
}

static void
add_box(struct split *split, uint32_t feature, double x, double y, double z)
{
	static const unsigned char corners[12][3] = {{0, 2, 1}, {1, 2, 3},
		{4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4}, {2, 6, 3},
		{3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};

	for (int i = 0; i < 12; i++) {
		struct tcs_point at[3];

		for (int k = 0; k < 3; k++) {
			unsigned corner = corners[i][k];

			at[k] = (struct tcs_point){x + (corner & 1 ? 1 : 0),
				y + (corner & 2 ? 1 : 0),
				z + (corner & 4 ? 1 : 0)};
		}
		add(split, feature, at[0], at[1], at[2]);
	}
}

static void
run(struct split *split)
{
	struct tcs_fault fault;

	CHECK(!component_set_build(&split->set, &fault));
	CHECK(!sheets_build(&split->sheets, &split->set, &fault));
}

static void
release(struct split *split)
{
	component_set_release(&split->set);
	sheets_release(&split->sheets);
}

static size_t
count_open(const struct split *split)
{
	size_t open = 0;

	for (size_t i = 0; i < split->sheets.opposites.count; i++)
		open += split->sheets.opposites.at[i] == HALF_EDGE_NONE;
	return open;
}

/* Every corner's vertex belongs to a node at that corner's point, and what is
   opposite is opposite back, the other way round. */
static void
check_numbers(const struct split *split)
{
	const struct sheets *sheets = &split->sheets;

	for (size_t i = 0; i < sheets->corners.count; i++) {
		uint32_t triangle = sheets->face_triangles.at[i / 3];
		uint32_t node = sheets->vertex_nodes.at[sheets->corners.at[i]];
		uint32_t back = sheets->opposites.at[i];

		CHECK(sheets->nodes.at[node].point ==
			split->set.triangles.at[triangle].corner[i % 3]);
		CHECK(sheets->nodes.at[node].component ==
			split->set.numbers.at[triangle]);
		CHECK(sheets->corners.at[i] >=
				sheets->nodes.at[node].first_vertex &&
			sheets->corners.at[i] <
				sheets->nodes.at[node + 1].first_vertex);
		if (back == HALF_EDGE_NONE)
			continue;
		CHECK(sheets->opposites.at[back] == i);
		CHECK(sheets->corners.at[back] ==
			sheets->corners.at[i % 3 == 2 ? i - 2 : i + 1]);
	}
}

static void
a_box_is_one_sheet(void)
{
	struct split split = {0};

	add_box(&split, 1, 0, 0, 0);
	run(&split);
	check_numbers(&split);
	CHECK(split.sheets.node_count == 8);
	CHECK(split.sheets.vertex_nodes.count == 8);
	CHECK(count_open(&split) == 0);
	release(&split);
}

/* Four faces at one edge: each box gets its own two, and both stay closed. */
static void
boxes_of_one_feature_at_an_edge_are_parted_there(void)
{
	struct split split = {0};

	add_box(&split, 1, 0, 0, 0);
	add_box(&split, 1, 1, 1, 0);
	run(&split);
	check_numbers(&split);
	CHECK(split.set.components.count == 1);
	CHECK(split.sheets.node_count == 14);
	CHECK(split.sheets.vertex_nodes.count == 16);
	CHECK(count_open(&split) == 0);
	for (size_t i = 0; i < split.sheets.opposites.count; i++)
		CHECK(split.sheets.face_triangles.at[i / 3] / 12 ==
			split.sheets.face_triangles
					.at[split.sheets.opposites.at[i] / 3] /
				12);
	release(&split);
}

static void
boxes_of_two_features_share_no_node(void)
{
	struct split split = {0};

	add_box(&split, 1, 0, 0, 0);
	add_box(&split, 2, 1, 1, 0);
	run(&split);
	check_numbers(&split);
	CHECK(split.set.components.count == 2);
	CHECK(split.sheets.node_count == 16);
	CHECK(split.sheets.vertex_nodes.count == 16);
	CHECK(count_open(&split) == 0);
	release(&split);
}

/* A fin on an edge of two: which two belong together is what winds so. */
static void
three_faces_at_an_edge_leave_one_open(void)
{
	const struct tcs_point low = {0, 0, 0}, high = {0, 0, 1};
	struct split split = {0};

	add(&split, 1, low, high, (struct tcs_point){1, 0, 0});
	add(&split, 1, high, low, (struct tcs_point){-1, 0, 0});
	add(&split, 1, low, high, (struct tcs_point){0, 1, 0});
	run(&split);
	check_numbers(&split);
	CHECK(count_open(&split) == 7);
	release(&split);
}

static void
two_faces_that_wind_alike_are_not_joined(void)
{
	const struct tcs_point low = {0, 0, 0}, high = {0, 0, 1};
	struct split split = {0};

	add(&split, 1, low, high, (struct tcs_point){1, 0, 0});
	add(&split, 1, low, high, (struct tcs_point){-1, 0, 0});
	run(&split);
	check_numbers(&split);
	CHECK(count_open(&split) == 6);
	CHECK(split.sheets.node_count == 4);
	CHECK(split.sheets.vertex_nodes.count == 6);
	release(&split);
}

static void
collapsed_triangles_are_no_faces(void)
{
	const struct tcs_point low = {0, 0, 0}, high = {0, 0, 1};
	struct split split = {0};

	add(&split, 1, low, high, high);
	add(&split, 1, low, high, (struct tcs_point){1, 0, 0});
	run(&split);
	check_numbers(&split);
	CHECK(split.sheets.face_triangles.count == 1);
	CHECK(split.sheets.triangle_faces.at[0] == TCS_NONE);
	CHECK(split.sheets.triangle_faces.at[1] == 0);
	release(&split);
}

static const struct check_test tests[] = {
	CHECK_TEST(a_box_is_one_sheet),
	CHECK_TEST(boxes_of_one_feature_at_an_edge_are_parted_there),
	CHECK_TEST(boxes_of_two_features_share_no_node),
	CHECK_TEST(three_faces_at_an_edge_leave_one_open),
	CHECK_TEST(two_faces_that_wind_alike_are_not_joined),
	CHECK_TEST(collapsed_triangles_are_no_faces),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
