#include "simplify/touches.h"

#include <stdlib.h>

#include "check.h"
#include "simplify/seams.h"
#include "simplify/vector.h"

enum { PARTS = 60 };

struct scene {
	struct component_set set;
	struct sheets sheets;
	struct seams seams;
	struct contact_list contacts;
};

/* A box of 12 triangles as a feature of its own, turned about z. */
static void
add_box(struct scene *scene, uint32_t feature, struct tcs_point low,
	struct tcs_point size, double turn)
{
	static const unsigned char corners[12][3] = {{0, 2, 1}, {1, 2, 3},
		{4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4}, {2, 6, 3},
		{3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
	struct tcs_fault fault;

	for (int i = 0; i < 12; i++) {
		struct tcs_point at[3];

		for (int k = 0; k < 3; k++) {
			unsigned corner = corners[i][k];
			double x = corner & 1 ? size.x : 0;
			double y = corner & 2 ? size.y : 0;

			at[k] = (struct tcs_point){
				low.x + cos(turn) * x - sin(turn) * y,
				low.y + sin(turn) * x + cos(turn) * y,
				low.z + (corner & 4 ? size.z : 0)};
		}
		CHECK(!component_set_add(
			&scene->set, at, feature, TCS_NONE, &fault));
	}
}

static void
find(struct scene *scene, double reach)
{
	struct tcs_fault fault;

	CHECK(!component_set_build(&scene->set, &fault));
	CHECK(!sheets_build(&scene->sheets, &scene->set, &fault));
	CHECK(!seams_find(&scene->seams, &scene->set, &scene->sheets, reach,
		&scene->contacts, &fault));
}

static void
release(struct scene *scene)
{
	component_set_release(&scene->set);
	sheets_release(&scene->sheets);
	seams_release(&scene->seams);
	array_release(&scene->contacts);
}

static double
random_between(double low, double high)
{
	return low + (high - low) * rand() / (double)RAND_MAX;
}

static void
add_random_boxes(struct scene *scene, double room)
{
	for (uint32_t i = 0; i < PARTS; i++)
		add_box(scene, i + 1,
			(struct tcs_point){random_between(0, room),
				random_between(0, room),
				random_between(0, room)},
			(struct tcs_point){random_between(0.01, 3),
				random_between(0.01, 3),
				random_between(0.01, 3)},
			random_between(0, 6));
}

/* The search that knows distances alone finds the same. */
static void
contacts_are_those_that_distances_tell(void)
{
	srand(5);
	for (int round = 0; round < 20; round++) {
		struct scene scene = {0};
		struct contact_list other = {0};
		struct tcs_fault fault;
		bool same;

		add_random_boxes(&scene, 2 + round);
		find(&scene, 0.05);
		CHECK(!contacts_find(&scene.set, 0.05, &other, &fault));
		same = scene.contacts.count == other.count;
		for (size_t i = 0; same && i < other.count; i++)
			same = scene.contacts.at[i].a == other.at[i].a &&
				scene.contacts.at[i].b == other.at[i].b &&
				scene.contacts.at[i].inside ==
					other.at[i].inside;
		CHECK(same);
		CHECK(other.count > 0);
		array_release(&other);
		release(&scene);
	}
}

static double
gap_from(const struct scene *scene, uint32_t face, struct tcs_point point)
{
	struct triangle_shape shape = component_set_shape(
		&scene->set, scene->sheets.face_triangles.at[face]);

	return vector_length(
		vector_difference(point, triangle_nearest(&shape, point)));
}

static void
points_lie_on_the_faces_that_hold_them(void)
{
	struct scene scene = {0};

	srand(6);
	add_random_boxes(&scene, 5);
	find(&scene, 0.05);
	CHECK(scene.seams.points.count > 100);
	for (size_t i = 0; i < scene.seams.points.count; i++) {
		const struct seam_point *point = &scene.seams.points.at[i];
		const struct contact *contact =
			&scene.contacts.at[point->contact];

		for (int side = 0; side < 2; side++) {
			uint32_t face =
				scene.seams.holds.at[2 * i + (size_t)side].face;
			uint32_t triangle =
				scene.sheets.face_triangles.at[face];

			/* A lengthened edge begins before its face. */
			CHECK(gap_from(&scene, face, point->at) < 0.06);
			CHECK(scene.set.numbers.at[triangle] ==
				(side ? contact->b : contact->a));
		}
	}
	release(&scene);
}

/* A small box on a slab: its lower corners, once each. */
static void
a_box_on_a_slab_is_watched_at_its_corners(void)
{
	struct scene scene = {0};

	add_box(&scene, 1, (struct tcs_point){0, 0, 0},
		(struct tcs_point){4, 4, 0.2}, 0);
	add_box(&scene, 2, (struct tcs_point){1, 1.5, 0.2},
		(struct tcs_point){1, 1, 2}, 0);
	find(&scene, 0.01);
	CHECK(scene.contacts.count == 1);
	CHECK(scene.seams.points.count >= 4);
	for (size_t i = 0; i < scene.seams.points.count; i++)
		for (size_t k = 0; k < i; k++)
			CHECK(vector_length(vector_difference(
				      scene.seams.points.at[i].at,
				      scene.seams.points.at[k].at)) > 0.001);
	release(&scene);
}

static size_t
count_planes(const struct scene *scene, uint32_t node)
{
	size_t count = 0;

	for (uint32_t i = scene->seams.nodes.at[node]; i != TCS_NONE;
		i = scene->seams.planes.at[i].next)
		count++;
	return count;
}

/* A beam through a wall: its ends lie outside, yet they are boundary
   vertices. What stands apart has none. */
static void
vertices_of_a_beam_through_a_wall_meet_it(void)
{
	struct scene scene = {0};
	size_t met = 0, apart = 0;

	add_box(&scene, 1, (struct tcs_point){0, 0, 0},
		(struct tcs_point){0.3, 5, 3}, 0);
	add_box(&scene, 2, (struct tcs_point){-1, 2, 1},
		(struct tcs_point){3, 0.2, 0.2}, 0);
	add_box(&scene, 3, (struct tcs_point){9, 9, 9},
		(struct tcs_point){1, 1, 1}, 0);
	find(&scene, 0.01);
	CHECK(scene.contacts.count == 1);
	for (uint32_t i = 0; i < scene.sheets.node_count; i++) {
		met += scene.sheets.nodes.at[i].component == 1 &&
			count_planes(&scene, i) > 0;
		apart += scene.sheets.nodes.at[i].component == 2 &&
			count_planes(&scene, i) > 0;
	}
	CHECK(met == 8);
	CHECK(apart == 0);
	release(&scene);
}

/* W3 (c) is for what is embedded as its diagonals are. */
static void
the_far_end_of_a_column_on_a_slab_is_free(void)
{
	struct scene scene = {0};
	size_t low = 0, high = 0;

	add_box(&scene, 1, (struct tcs_point){0, 0, 0},
		(struct tcs_point){5, 5, 0.3}, 0);
	add_box(&scene, 2, (struct tcs_point){2, 2, 0.3},
		(struct tcs_point){0.5, 0.5, 3}, 0);
	find(&scene, 0.01);
	CHECK(scene.contacts.count == 1);
	for (uint32_t i = 0; i < scene.sheets.node_count; i++) {
		const struct sheet_node *node = &scene.sheets.nodes.at[i];
		bool met = count_planes(&scene, i) > 0;

		if (node->component != 1)
			continue;
		if (scene.set.points.at[node->point].z > 1)
			high += met;
		else
			low += met;
	}
	CHECK(low == 4);
	CHECK(high == 0);
	release(&scene);
}

enum { CELLS = 30 };

/* A rug of many faces in random order, as one component. */
static void
add_rug(struct scene *scene)
{
	struct tcs_fault fault;
	static bool taken[CELLS * CELLS];

	for (int i = 0; i < CELLS * CELLS; i++)
		taken[i] = false;
	for (int left = CELLS * CELLS; left > 0;) {
		int cell = rand() % (CELLS * CELLS);
		double x = cell % CELLS, y = cell / CELLS;
		const struct tcs_point at[4] = {{x, y, sin(x + y)},
			{x + 1, y, sin(x + 1 + y)}, {x, y + 1, sin(x + y + 1)},
			{x + 1, y + 1, sin(x + y + 2)}};

		if (taken[cell])
			continue;
		taken[cell] = true;
		left--;
		CHECK(!component_set_add(&scene->set, at, 1, TCS_NONE, &fault));
		CHECK(!component_set_add(
			&scene->set, at + 1, 1, TCS_NONE, &fault));
	}
}

static bool
meets(const struct scene *scene, uint32_t face, const struct float_box *box)
{
	struct triangle_shape shape = component_set_shape(
		&scene->set, scene->sheets.face_triangles.at[face]);
	struct box own = BOX_EMPTY;
	bool apart = false;

	for (int k = 0; k < 3; k++)
		box_add_point(&own, shape.corner[k]);
	for (int i = 0; i < 3; i++)
		apart |= own.low[i] > (double)box->high[i] ||
			own.high[i] < (double)box->low[i];
	return !apart;
}

static void
faces_near_a_box_are_found(void)
{
	struct scene scene = {0};
	struct face_boxes boxes = {0};
	struct face_list found = {0};
	struct tcs_fault fault;

	srand(8);
	add_rug(&scene);
	find(&scene, 0.01);
	CHECK(scene.set.components.count == 1);
	CHECK(!face_boxes_build(&boxes, &scene.set, &scene.sheets, &fault));
	for (int i = 0; i < 100; i++) {
		struct tcs_point at = {random_between(-2, CELLS),
			random_between(-2, CELLS), random_between(-1, 1)};
		struct float_box box =
			float_box_around(at, at, random_between(0, 3));
		size_t wanted = 0;

		CHECK(!face_boxes_near(&boxes, 0, &box, &found, &fault));
		for (uint32_t k = 0; k < 2 * CELLS * CELLS; k++)
			wanted += meets(&scene, k, &box);
		/* Boxes are a little larger than what is in them. */
		CHECK(found.count >= wanted && found.count <= wanted + 8);
	}
	array_release(&found);
	face_boxes_release(&boxes);
	release(&scene);
}

static void
threads_change_nothing(void)
{
	struct scene one = {0}, two = {0};

	srand(7);
	add_random_boxes(&one, 4);
	srand(7);
	add_random_boxes(&two, 4);
	two.set.jobs = 2;
	find(&one, 0.05);
	find(&two, 0.05);
	CHECK(one.seams.points.count == two.seams.points.count);
	CHECK(one.seams.planes.count == two.seams.planes.count);
	for (size_t i = 0; i < one.seams.holds.count; i++)
		CHECK(one.seams.holds.at[i].face == two.seams.holds.at[i].face);
	release(&one);
	release(&two);
}

static const struct check_test tests[] = {
	CHECK_TEST(contacts_are_those_that_distances_tell),
	CHECK_TEST(points_lie_on_the_faces_that_hold_them),
	CHECK_TEST(a_box_on_a_slab_is_watched_at_its_corners),
	CHECK_TEST(vertices_of_a_beam_through_a_wall_meet_it),
	CHECK_TEST(the_far_end_of_a_column_on_a_slab_is_free),
	CHECK_TEST(faces_near_a_box_are_found),
	CHECK_TEST(threads_change_nothing),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
