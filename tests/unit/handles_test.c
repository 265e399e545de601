#include "simplify/handles.h"

#include "collapse_sample.h"

static const struct collapse_settings settings = {
	.base_ratio = 2, .contact_cost = INFINITY};

enum { WALL, WINDOW, OTHER };

struct scene {
	struct collapse_sample sample;
	struct removals removals;
	struct handles handles;
};

static void
begin_with(struct scene *scene, const struct collapse_settings *with)
{
	struct collapse_sample *sample = &scene->sample;
	struct tcs_fault fault;

	sample_begin(sample, with);
	CHECK(!removals_begin(&scene->removals, &sample->work,
		&sample->contacts, contact_reach(&sample->set), false, &fault));
	CHECK(!handles_find(&scene->handles, &sample->set, &sample->work,
		&scene->removals, &fault));
}

static void
begin(struct scene *scene)
{
	begin_with(scene, &settings);
}

static void
end(struct scene *scene)
{
	handles_release(&scene->handles);
	removals_release(&scene->removals);
	sample_release(&scene->sample);
}

/* Close all that can be closed, then collapse what costs nothing. */
static void
close_all(struct scene *scene)
{
	struct tcs_fault fault;

	while (handles_next_cost(&scene->handles) < INFINITY)
		CHECK(!handles_try(&scene->handles, &fault));
	CHECK(!collapses_run(&scene->sample.work, 0, 1e-6, &fault));
}

/* ---- what is left -------------------------------------------------------- */

static size_t
faces(const struct scene *scene, uint32_t feature)
{
	const struct collapses *work = &scene->sample.work;
	size_t count = 0;
	uint32_t nodes[3];

	for (uint32_t i = 0; i < work->features.count; i++)
		count += work->features.at[i] == feature &&
			collapses_face(work, i, nodes);
	return count;
}

static bool
has_edge(const struct collapses *work, uint32_t a, uint32_t b)
{
	uint32_t nodes[3];

	for (uint32_t i = 0; i < work->features.count; i++)
		for (int k = 0; collapses_face(work, i, nodes) && k < 3; k++)
			if (nodes[k] == a && nodes[(k + 1) % 3] == b)
				return true;
	return false;
}

/* Whether every edge is used as often one way as the other, and only once. */
static bool
is_closed(const struct scene *scene)
{
	const struct collapses *work = &scene->sample.work;
	uint32_t nodes[3];
	size_t left = 0;

	for (uint32_t i = 0; i < work->features.count; i++) {
		if (!collapses_face(work, i, nodes))
			continue;
		left++;
		for (int k = 0; k < 3; k++)
			if (!has_edge(work, nodes[(k + 1) % 3], nodes[k]))
				return false;
	}
	return left == work->face_count;
}

/* ---- what is built ------------------------------------------------------- */

enum { MOST_CUTS = 8 };

/* A wall along x, 0.3 m thick and 3 m high. Columns between the cuts alternate:
   wall, opening, wall … Openings go from 1 to 2 m. */
struct wall {
	double cuts[MOST_CUTS];
	int count;
	double depth; /* of the openings: 0.3 goes through */
};

#define THICK 0.3

static struct tcs_point
at(double x, double y, double z)
{
	return (struct tcs_point){x, y, z};
}

static void
add_cell(struct scene *scene, double x, double to, double z, double top)
{
	sample_add_quad(&scene->sample, WALL, at(x, 0, z), at(to, 0, z),
		at(to, 0, top), at(x, 0, top));
}

static void
add_back(struct scene *scene, double x, double to, double z, double top)
{
	sample_add_quad(&scene->sample, WALL, at(to, THICK, z), at(x, THICK, z),
		at(x, THICK, top), at(to, THICK, top));
}

/* The four sides of an opening, and its bottom. */
static void
add_reveal(
	struct scene *scene, double x, double to, double depth, uint32_t bottom)
{
	struct collapse_sample *sample = &scene->sample;

	sample_add_quad(sample, WALL, at(x, 0, 1), at(to, 0, 1),
		at(to, depth, 1), at(x, depth, 1));
	sample_add_quad(sample, WALL, at(x, 0, 2), at(x, depth, 2),
		at(to, depth, 2), at(to, 0, 2));
	sample_add_quad(sample, WALL, at(x, 0, 1), at(x, depth, 1),
		at(x, depth, 2), at(x, 0, 2));
	sample_add_quad(sample, WALL, at(to, 0, 1), at(to, 0, 2),
		at(to, depth, 2), at(to, depth, 1));
	if (depth < THICK)
		sample_add_quad(sample, bottom, at(x, depth, 1),
			at(to, depth, 1), at(to, depth, 2), at(x, depth, 2));
}

static void
add_wall(struct scene *scene, const struct wall *wall, uint32_t bottom)
{
	struct collapse_sample *sample = &scene->sample;
	double length = wall->cuts[wall->count - 1];

	for (int i = 0; i + 1 < wall->count; i++) {
		double x = wall->cuts[i], to = wall->cuts[i + 1];
		bool open = i % 2 == 1;

		for (int row = 0; row < 3; row++) {
			if (!open || row != 1)
				add_cell(scene, x, to, row, row + 1);
			if (!open || row != 1 || wall->depth < THICK)
				add_back(scene, x, to, row, row + 1);
		}
		if (open)
			add_reveal(scene, x, to, wall->depth, bottom);
		sample_add_quad(sample, WALL, at(x, THICK, 0), at(to, THICK, 0),
			at(to, 0, 0), at(x, 0, 0));
		sample_add_quad(sample, WALL, at(x, 0, 3), at(to, 0, 3),
			at(to, THICK, 3), at(x, THICK, 3));
	}
	for (int row = 0; row < 3; row++) {
		sample_add_quad(sample, WALL, at(0, THICK, row), at(0, 0, row),
			at(0, 0, row + 1), at(0, THICK, row + 1));
		sample_add_quad(sample, WALL, at(length, 0, row),
			at(length, THICK, row), at(length, THICK, row + 1),
			at(length, 0, row + 1));
	}
}

static const struct wall two_openings = {{0, 1, 2, 4, 5, 6}, 6, THICK};
static const struct wall one_opening = {{0, 3, 4, 7}, 4, THICK};
static const struct wall one_recess = {{0, 3, 4, 7}, 4, 0.1};

/* ---- the tests ----------------------------------------------------------- */

static void
a_wall_with_two_openings_closes_to_a_box(void)
{
	struct scene scene = {0};

	add_wall(&scene, &two_openings, WALL);
	begin(&scene);
	CHECK(scene.handles.at.count == 2);
	close_all(&scene);
	CHECK(scene.handles.closed == 2);
	CHECK(is_closed(&scene));
	CHECK(faces(&scene, WALL) == 12);
	CHECK(fabs(sample_volume(&scene.sample, WALL) - 6 * 3 * THICK) < 1e-9);
	end(&scene);
}

/* The same after collapses have moved what they may. */
static void
what_is_left_of_an_opening_closes(void)
{
	struct scene scene = {0};

	add_wall(&scene, &two_openings, WALL);
	begin(&scene);
	sample_run(&scene.sample, 60);
	CHECK(is_closed(&scene));
	close_all(&scene);
	CHECK(scene.handles.closed == 2);
	CHECK(is_closed(&scene));
	CHECK(fabs(sample_volume(&scene.sample, WALL) - 6 * 3 * THICK) < 0.5);
	end(&scene);
}

static void
a_recess_is_filled(void)
{
	struct scene scene = {0};

	add_wall(&scene, &one_recess, WALL);
	begin(&scene);
	CHECK(scene.handles.at.count == 1);
	close_all(&scene);
	CHECK(is_closed(&scene));
	CHECK(faces(&scene, WALL) == 12);
	CHECK(fabs(sample_volume(&scene.sample, WALL) - 7 * 3 * THICK) < 1e-9);
	CHECK(fabs(scene.sample.work.volume.volumes.at[0] - 7 * 3 * THICK) <
		1e-9);
	end(&scene);
}

/* And keeps its outline, for it is a surface of its own. */
static void
a_window_in_a_recess_comes_forward(void)
{
	struct scene scene = {0};

	add_wall(&scene, &one_recess, WINDOW);
	begin(&scene);
	close_all(&scene);
	CHECK(scene.handles.closed == 1);
	CHECK(is_closed(&scene));
	CHECK(faces(&scene, WINDOW) == 2);
	CHECK(sample_has(&scene.sample, 3, 0, 1));
	CHECK(!sample_has(&scene.sample, 3, 0.1, 1));
	end(&scene);
}

/* And comes forward on both sides. */
static void
what_stands_in_an_opening_stays_in_touch(void)
{
	const struct collapse_settings cheap = {
		.base_ratio = 2, .contact_cost = 1e-3};
	struct scene scene = {0};
	uint32_t part;

	add_wall(&scene, &one_opening, WALL);
	sample_add_box(&scene.sample, WINDOW, at(3, 0.1, 1), at(1, 0.1, 1));
	begin_with(&scene, &cheap);
	CHECK(scene.sample.contacts.count == 1);
	close_all(&scene);
	CHECK(scene.handles.closed == 1);
	CHECK(scene.handles.panels.made == 1);
	/* A corner of its rims may stay, where the panel meets it. */
	CHECK(faces(&scene, WALL) <= 14);
	CHECK(faces(&scene, WINDOW) == 12);
	CHECK(sample_has(&scene.sample, 3, -0.01, 1));
	CHECK(sample_has(&scene.sample, 4, THICK + 0.01, 2));
	part = scene.removals.parts.numbers
		       .at[scene.sample.work.features.count - 1];
	CHECK(scene.removals.visible.at[part] > 0);
	/* It counts as a contact still, if the window goes. */
	CHECK(scene.sample.seams.counts.at[0].open == 0);
	CHECK(scene.removals.parts.enclosed.at[0] == 1);
	end(&scene);
}

/* A frame and its pane become one, which has the surface of both. */
static void
a_window_of_parts_becomes_a_panel(void)
{
	const struct collapse_settings cheap = {
		.base_ratio = 2, .contact_cost = 1e-3};
	struct scene scene = {0};

	add_wall(&scene, &one_opening, WALL);
	sample_add_box(&scene.sample, WINDOW, at(3, 0.05, 1), at(1, 0.1, 0.2));
	sample_add_box(
		&scene.sample, WINDOW, at(3, 0.08, 1.2), at(1, 0.02, 0.8));
	begin_with(&scene, &cheap);
	close_all(&scene);
	CHECK(scene.handles.panels.made == 1);
	CHECK(faces(&scene, WINDOW) == 12);
	CHECK(sample_has(&scene.sample, 3, -0.01, 1));
	CHECK(sample_has(&scene.sample, 4, THICK + 0.01, 2));
	end(&scene);
}

/* One that reached farther out than another still does. */
static void
panels_keep_their_order(void)
{
	const struct collapse_settings cheap = {
		.base_ratio = 2, .contact_cost = 1e-3};
	struct scene scene = {0};

	add_wall(&scene, &one_opening, WALL);
	sample_add_box(&scene.sample, WINDOW, at(3, 0.1, 1), at(1, 0.1, 0.5));
	sample_add_box(&scene.sample, OTHER, at(3, 0.05, 1.5), at(1, 0.1, 0.5));
	begin_with(&scene, &cheap);
	close_all(&scene);
	CHECK(scene.handles.panels.made == 2);
	CHECK(sample_has(&scene.sample, 3, -0.01, 1));
	CHECK(sample_has(&scene.sample, 3, -0.02, 2));
	CHECK(sample_has(&scene.sample, 3, THICK + 0.02, 1));
	CHECK(sample_has(&scene.sample, 3, THICK + 0.01, 2));
	end(&scene);
}

/* What leaves a panel smaller has a price. */
static void
a_panel_is_not_pressed_into_its_wall(void)
{
	const struct collapse_settings dear = {
		.base_ratio = 2, .contact_cost = 1e6};
	struct scene scene = {0};
	struct tcs_fault fault;

	add_wall(&scene, &one_opening, WALL);
	sample_add_box(&scene.sample, WINDOW, at(3, 0.1, 1), at(1, 0.1, 1));
	begin_with(&scene, &dear);
	close_all(&scene);
	CHECK(scene.handles.panels.made == 1);
	CHECK(!collapses_run(&scene.sample.work, 0, 1e4, &fault));
	CHECK(faces(&scene, WINDOW) == 12);
	end(&scene);
}

static void
what_is_of_the_same_surface_becomes_one(void)
{
	struct scene scene = {0};

	add_wall(&scene, &one_opening, WALL);
	sample_add_box(&scene.sample, WALL, at(3, 0.1, 1), at(1, 0.1, 1));
	begin(&scene);
	close_all(&scene);
	CHECK(scene.handles.closed == 1);
	CHECK(scene.sample.work.face_count == 12);
	end(&scene);
}

static void
what_has_become_one_stays_covered(void)
{
	struct scene scene = {0};
	const struct cover_watch *covers = &scene.sample.work.covers;

	add_wall(&scene, &two_openings, WALL);
	sample_add_box(&scene.sample, WALL, at(1, 0.005, 1), at(1, 0.1, 1));
	begin(&scene);
	close_all(&scene);
	CHECK(scene.handles.closed == 2);
	/* The wall, and what stood in one of its openings. */
	CHECK(covers->at.at[covers->at.count - 1].count == 2);
	/* Where they touched is within it, and not open. */
	CHECK(scene.sample.seams.counts.at[0].open == 0);
	sample_run(&scene.sample, 4);
	CHECK(scene.sample.work.face_count == 12);
	CHECK(fabs(sample_volume(&scene.sample, WALL) - 6 * 3 * THICK) < 1e-9);
	end(&scene);
}

/* What covers something costs the contacts of that, too, if it goes. */
static void
what_has_become_one_goes_for_the_price_of_both(void)
{
	struct scene scene = {0};
	struct tcs_fault fault;
	double price[2];

	for (int box = 0; box < 2; box++) {
		add_wall(&scene, &one_opening, WALL);
		sample_add_box(&scene.sample, WALL, at(7, 0, 0), at(1, 1, 1));
		sample_add_box(&scene.sample, box ? WALL : WINDOW,
			at(3, 0.1, 1), at(1, 0.1, 1));
		begin(&scene);
		close_all(&scene);
		CHECK(!cover_watch_worth(&scene.sample.work,
			scene.removals.parts.faces.at,
			scene.removals.parts.at.at[0].count, &price[box],
			&fault));
		end(&scene);
		scene = (struct scene){0};
	}
	CHECK(!(price[0] > 0));
	CHECK(price[1] > 0);
}

/* A ring of boxes around nothing has no flat face with an inner outline, but
   for its top and bottom: it closes from there, or not at all. */
static void
a_round_ring_stays(void)
{
	enum { ROUND = 12, TUBE = 8 };

	struct scene scene = {0};
	struct tcs_point ring[ROUND][TUBE];

	for (int i = 0; i < ROUND; i++)
		for (int k = 0; k < TUBE; k++) {
			double turn = 2 * acos(-1) * i / ROUND;
			double roll = 2 * acos(-1) * k / TUBE;
			double from = 2 + 0.5 * cos(roll);

			ring[i][k] = at(from * cos(turn), from * sin(turn),
				0.5 * sin(roll));
		}
	for (int i = 0; i < ROUND; i++)
		for (int k = 0; k < TUBE; k++)
			sample_add_quad(&scene.sample, WALL, ring[i][k],
				ring[(i + 1) % ROUND][k],
				ring[(i + 1) % ROUND][(k + 1) % TUBE],
				ring[i][(k + 1) % TUBE]);
	begin(&scene);
	CHECK(sample_volume(&scene.sample, WALL) > 0);
	CHECK(scene.handles.at.count == 0);
	end(&scene);
}

/* Two plates on a rod: without it they would come apart. */
static void
a_rod_between_plates_stays(void)
{
	struct scene scene = {0};
	struct collapse_sample *sample = &scene.sample;

	for (int upper = 0; upper < 2; upper++) {
		double z = upper ? 5 : 0;
		double inner = upper ? 5 : 1, outer = upper ? 6 : 0;

		/* The side of the rod, with a square missing. */
		for (int x = 0; x < 3; x++)
			for (int y = 0; y < 3; y++) {
				struct tcs_point a = at(x, y, inner);
				struct tcs_point b = at(x + 1, y, inner);
				struct tcs_point c = at(x + 1, y + 1, inner);
				struct tcs_point d = at(x, y + 1, inner);

				if (x == 1 && y == 1)
					continue;
				if (upper)
					sample_add_quad(
						sample, WALL, a, d, c, b);
				else
					sample_add_quad(
						sample, WALL, a, b, c, d);
			}
		for (int i = 0; i < 3; i++) {
			double s = i, e = i + 1;

			sample_add_quad(sample, WALL, at(s, 0, z), at(e, 0, z),
				at(e, 0, z + 1), at(s, 0, z + 1));
			sample_add_quad(sample, WALL, at(e, 3, z), at(s, 3, z),
				at(s, 3, z + 1), at(e, 3, z + 1));
			sample_add_quad(sample, WALL, at(0, e, z), at(0, s, z),
				at(0, s, z + 1), at(0, e, z + 1));
			sample_add_quad(sample, WALL, at(3, s, z), at(3, e, z),
				at(3, e, z + 1), at(3, s, z + 1));
			for (int k = 0; k < 3; k++) {
				struct tcs_point a = at(i, k, outer);
				struct tcs_point b = at(i + 1, k, outer);
				struct tcs_point c = at(i + 1, k + 1, outer);
				struct tcs_point d = at(i, k + 1, outer);

				if (upper)
					sample_add_quad(
						sample, WALL, a, b, c, d);
				else
					sample_add_quad(
						sample, WALL, a, d, c, b);
			}
		}
	}
	sample_add_quad(sample, WALL, at(1, 1, 1), at(2, 1, 1), at(2, 1, 5),
		at(1, 1, 5));
	sample_add_quad(sample, WALL, at(2, 1, 1), at(2, 2, 1), at(2, 2, 5),
		at(2, 1, 5));
	sample_add_quad(sample, WALL, at(2, 2, 1), at(1, 2, 1), at(1, 2, 5),
		at(2, 2, 5));
	sample_add_quad(sample, WALL, at(1, 2, 1), at(1, 1, 1), at(1, 1, 5),
		at(1, 2, 5));
	begin(&scene);
	CHECK(is_closed(&scene));
	CHECK(fabs(sample_volume(&scene.sample, WALL) - (9 + 9 + 4)) < 1e-9);
	CHECK(scene.handles.at.count == 0);
	end(&scene);
}

/* What may be off is watched face by face, and no face may change its place. */
static void
nothing_closes_while_errors_are_watched(void)
{
	static const struct collapse_settings watched = {
		.base_ratio = 2, .contact_cost = INFINITY, .max_error = 1};
	struct scene scene = {0};

	add_wall(&scene, &two_openings, WALL);
	begin_with(&scene, &watched);
	CHECK(!(handles_next_cost(&scene.handles) < INFINITY));
	end(&scene);
}

static const struct check_test tests[] = {
	CHECK_TEST(a_wall_with_two_openings_closes_to_a_box),
	CHECK_TEST(what_is_left_of_an_opening_closes),
	CHECK_TEST(a_recess_is_filled),
	CHECK_TEST(a_window_in_a_recess_comes_forward),
	CHECK_TEST(what_stands_in_an_opening_stays_in_touch),
	CHECK_TEST(a_window_of_parts_becomes_a_panel),
	CHECK_TEST(panels_keep_their_order),
	CHECK_TEST(a_panel_is_not_pressed_into_its_wall),
	CHECK_TEST(what_is_of_the_same_surface_becomes_one),
	CHECK_TEST(what_has_become_one_stays_covered),
	CHECK_TEST(what_has_become_one_goes_for_the_price_of_both),
	CHECK_TEST(a_round_ring_stays),
	CHECK_TEST(a_rod_between_plates_stays),
	CHECK_TEST(nothing_closes_while_errors_are_watched),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
