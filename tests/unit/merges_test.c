#include "simplify/merges.h"

#include "collapse_sample.h"

static const struct collapse_settings settings = {
	.base_ratio = 2, .contact_cost = INFINITY};

enum { WINDOW, WALL, VASE };

struct scene {
	struct collapse_sample sample;
	struct removals removals;
	struct merges merges;
};

static void
begin_with(struct scene *scene, const struct collapse_settings *with)
{
	struct collapse_sample *sample = &scene->sample;
	struct tcs_fault fault;

	sample_begin(sample, with);
	CHECK(!removals_begin(&scene->removals, &sample->work,
		&sample->contacts, contact_reach(&sample->set), false, &fault));
	CHECK(!merges_find(&scene->merges, &sample->set, &sample->work,
		&scene->removals, &fault));
	CHECK(!merges_aim(&scene->merges, 0, &fault));
}

static void
begin(struct scene *scene)
{
	begin_with(scene, &settings);
}

static void
end(struct scene *scene)
{
	merges_release(&scene->merges);
	removals_release(&scene->removals);
	sample_release(&scene->sample);
}

/* All that costs less. */
static void
merge_below(struct scene *scene, double dearest)
{
	struct tcs_fault fault;

	while (merges_next_cost(&scene->merges) < dearest)
		CHECK(!merges_try(&scene->merges, &fault));
}

static struct tcs_point
at(double x, double y, double z)
{
	return (struct tcs_point){x, y, z};
}

/* ---- what is left -------------------------------------------------------- */

static double
volume(const struct scene *scene, uint32_t feature)
{
	const struct collapses *work = &scene->sample.work;
	double sum = 0;
	uint32_t nodes[3];

	for (uint32_t i = 0; i < work->features.count; i++)
		if (work->features.at[i] == feature &&
			collapses_face(work, i, nodes))
			sum += vector_dot(work->positions.at[nodes[0]],
				vector_cross(work->positions.at[nodes[1]],
					work->positions.at[nodes[2]]));
	return sum / 6;
}

/* The faces that are left of a feature: as the mesh has them, and as told. */
static size_t
faces(const struct scene *scene, uint32_t feature)
{
	const struct collapses *work = &scene->sample.work;
	size_t count = 0;
	uint32_t nodes[3];

	for (uint32_t i = 0; i < work->features.count; i++)
		count += work->features.at[i] == feature &&
			collapses_face(work, i, nodes);
	CHECK(count == work->surfaces.at[feature]);
	return count;
}

/* The part that a face of a feature, which has but one, is in. */
static uint32_t
part_of(const struct scene *scene, uint32_t feature)
{
	const struct collapses *work = &scene->sample.work;
	uint32_t nodes[3];

	for (uint32_t i = 0; i < work->features.count; i++)
		if (work->features.at[i] == feature &&
			collapses_face(work, i, nodes))
			return scene->removals.parts.numbers.at[i];
	return TCS_NONE;
}

static bool
goes(struct scene *scene, uint32_t feature)
{
	struct tcs_fault fault;
	bool gone;

	CHECK(!parts_take_away(&scene->removals.parts, part_of(scene, feature),
		&gone, &fault));
	return gone;
}

/* ---- what is built ------------------------------------------------------- */

/* A window 1.2 m wide and high, its frame 8 cm thick, and 1 cm of glass in the
   middle; z tells where it stands. */
static void
add_window(struct scene *scene, double z)
{
	struct collapse_sample *sample = &scene->sample;

	sample_add_box(sample, WINDOW, at(0, 0, z), at(1.2, 0.08, 0.1));
	sample_add_box(sample, WINDOW, at(0, 0, z + 1.1), at(1.2, 0.08, 0.1));
	sample_add_box(sample, WINDOW, at(0, 0, z + 0.1), at(0.1, 0.08, 1));
	sample_add_box(sample, WINDOW, at(1.1, 0, z + 0.1), at(0.1, 0.08, 1));
	sample_add_box(sample, WINDOW, at(0.1, 0.035, z + 0.1), at(1, 0.01, 1));
}

#define WINDOW_VOLUME (1.2 * 0.08 * 1.2)

/* Boards with no corner in common, side by side. */
static void
add_boards(struct scene *scene, int count)
{
	for (int i = 0; i < count; i++)
		sample_add_box(&scene->sample, WINDOW,
			at(0.1 * i, 0.001 * i, 0), at(0.1, 2, 0.03));
}

/* ---- the tests ----------------------------------------------------------- */

static void
boards_side_by_side_become_one(void)
{
	struct scene scene = {0};

	add_boards(&scene, 5);
	begin(&scene);
	CHECK(scene.removals.parts.count == 5);
	merge_below(&scene, 1e-5);
	CHECK(faces(&scene, WINDOW) == 12);
	CHECK(scene.sample.work.face_count == 12);
	CHECK(scene.merges.joined == 4);
	CHECK(fabs(volume(&scene, WINDOW) - 0.5 * 2.004 * 0.03) < 1e-4);
	end(&scene);
}

/* Those that share corners are one component already. */
static void
cells_of_one_component_become_one(void)
{
	struct scene scene = {0};

	for (int i = 0; i < 4; i++)
		sample_add_box(&scene.sample, WINDOW, at(i, 0, 0), at(1, 1, 1));
	begin(&scene);
	CHECK(scene.sample.set.components.count == 1);
	CHECK(scene.removals.parts.count == 4);
	merge_below(&scene, 1e-3);
	CHECK(faces(&scene, WINDOW) == 12);
	CHECK(fabs(volume(&scene, WINDOW) - 4) < 1e-9);
	CHECK(sample_has(&scene.sample, 0, 0, 0));
	CHECK(sample_has(&scene.sample, 4, 1, 1));
	end(&scene);
}

static void
a_frame_and_its_pane_become_a_panel(void)
{
	struct scene scene = {0};
	const struct collapses *work = &scene.sample.work;
	uint32_t nodes[3];
	size_t glass = 0;

	add_window(&scene, 0);
	begin(&scene);
	merge_below(&scene, 0.02);
	CHECK(faces(&scene, WINDOW) == 12);
	CHECK(fabs(volume(&scene, WINDOW) - WINDOW_VOLUME) < 1e-9);
	CHECK(sample_has(&scene.sample, 0, 0, 0));
	CHECK(sample_has(&scene.sample, 1.2, 0.08, 1.2));
	/* Its two large sides look like the glass, which came last. */
	for (uint32_t i = 0; i < work->features.count; i++)
		glass += collapses_face(work, i, nodes) &&
			collapses_source(work, i) >= 48;
	CHECK(glass == 4);
	end(&scene);
}

/* After collapses have taken some of the faces that it needs. */
static void
what_is_left_of_a_window_becomes_a_panel(void)
{
	struct scene scene = {0};

	add_window(&scene, 0);
	begin(&scene);
	sample_run(&scene.sample, 40);
	merge_below(&scene, 0.1);
	CHECK(faces(&scene, WINDOW) == 12);
	CHECK(fabs(volume(&scene, WINDOW) - WINDOW_VOLUME) < 1e-9);
	end(&scene);
}

/* Where contacts may break: what comes out of the prism is lost. */
static void
what_is_merged_goes_on_collapsing(void)
{
	const struct collapse_settings free = {
		.base_ratio = 2, .contact_cost = 1e-9};
	struct scene scene = {0};
	const struct cover_watch *covers = &scene.sample.work.covers;
	size_t bare = 0;

	add_window(&scene, 0);
	begin_with(&scene, &free);
	merge_below(&scene, 0.02);
	sample_run(&scene.sample, 4);
	CHECK(faces(&scene, WINDOW) < 12);
	CHECK(volume(&scene, WINDOW) > 0);
	for (size_t i = 0; i < covers->covered.count; i++)
		bare += covers->covered.at[i].bare;
	CHECK(bare > 0);
	end(&scene);
}

static void
what_is_in_a_prism_stays_in_it(void)
{
	struct scene scene = {0};

	add_window(&scene, 0);
	begin(&scene);
	merge_below(&scene, 0.02);
	sample_run(&scene.sample, 4);
	CHECK(faces(&scene, WINDOW) == 12);
	end(&scene);
}

/* All boards lose a corner, and so all contacts would be lost. */
static void
what_comes_out_of_a_prism_has_the_price_of_its_contacts(void)
{
	struct scene scene = {0};
	struct collapses *work = &scene.sample.work;
	struct tcs_fault fault;
	bool fine = false;
	double worth = 0;

	add_boards(&scene, 5);
	begin(&scene);
	CHECK(scene.sample.contacts.count == 4);
	merge_below(&scene, 1e-5);
	for (size_t i = 0; i < 4; i++)
		worth += (double)work->worths.at[i];
	work->settings.contact_cost = 1;
	CHECK(!collapse_check(work, sample_node(&scene.sample, 0, 0, 0),
		sample_node(&scene.sample, 0, 2.004, 0), &fine, &fault));
	CHECK(fine && fabs(work->broken - worth) < 1e-9);
	end(&scene);
}

static void
a_prism_covers_what_a_smaller_one_did(void)
{
	struct scene scene = {0};
	const struct cover_watch *covers = &scene.sample.work.covers;
	struct tcs_fault fault;

	add_boards(&scene, 5);
	begin(&scene);
	CHECK(!merges_aim(&scene.merges, 48, &fault));
	merge_below(&scene, 1e-5);
	CHECK(covers->at.count == 1 && covers->at.at[0].count == 2);
	CHECK(!merges_aim(&scene.merges, 0, &fault));
	merge_below(&scene, 1e-5);
	CHECK(covers->at.at[covers->at.count - 1].count == 5);
	CHECK(covers->at.at[covers->at.count - 1].face_count == 12);
	end(&scene);
}

static void
boxes_that_meet_at_an_edge_stay(void)
{
	struct scene scene = {0};

	sample_add_box(&scene.sample, WINDOW, at(0, 0, 0), at(1, 1, 1));
	sample_add_box(&scene.sample, WINDOW, at(1, 1, 0), at(1, 1, 1));
	begin(&scene);
	CHECK(scene.merges.groups.at.count == 1);
	merge_below(&scene, 0.02);
	CHECK(scene.sample.work.face_count == 24);
	end(&scene);
}

static void
parts_of_two_surfaces_stay(void)
{
	struct scene scene = {0};

	sample_add_box(&scene.sample, WINDOW, at(0, 0, 0), at(1, 1, 1));
	sample_add_box(&scene.sample, WALL, at(1, 0, 0), at(1, 1, 1));
	begin(&scene);
	CHECK(merges_next_cost(&scene.merges) == INFINITY);
	end(&scene);
}

static void
open_parts_stay(void)
{
	struct scene scene = {0};

	sample_add_sheet(&scene.sample, WINDOW, at(0, 0, 0), 1, 2, 2);
	sample_add_box(&scene.sample, WINDOW, at(0.5, 0.5, 0), at(1, 1, 1));
	begin(&scene);
	CHECK(merges_next_cost(&scene.merges) == INFINITY);
	end(&scene);
}

static void
nothing_is_merged_where_the_error_is_watched(void)
{
	const struct collapse_settings watched = {
		.base_ratio = 2, .contact_cost = INFINITY, .max_error = 0.1};
	struct scene scene = {0};

	add_boards(&scene, 3);
	begin_with(&scene, &watched);
	CHECK(scene.merges.groups.at.count > 0);
	CHECK(merges_next_cost(&scene.merges) == INFINITY);
	end(&scene);
}

/* A wall to the left of the window: its side does not move. */
static void
what_touched_one_of_them_touches_the_prism(void)
{
	struct scene scene = {0};
	const struct seam_count *counts;
	size_t open = 0, kept = 0;
	uint32_t wall;

	add_window(&scene, 0);
	sample_add_box(&scene.sample, WALL, at(-3, -0.1, -1), at(3, 0.3, 3));
	begin(&scene);
	merge_below(&scene, 0.02);
	CHECK(faces(&scene, WINDOW) == 12);
	counts = scene.sample.seams.counts.at;
	wall = (uint32_t)scene.sample.set.components.count - 1;
	for (size_t i = 0; i < scene.sample.contacts.count; i++) {
		const struct contact *own = &scene.sample.contacts.at[i];

		open += counts[i].open;
		kept += own->b == wall && counts[i].points > 0;
	}
	CHECK(open == 0 && kept > 0);
	end(&scene);
}

static void
what_stood_on_one_of_them_stands_on_the_prism(void)
{
	struct scene scene = {0};

	sample_add_box(&scene.sample, WALL, at(0, 0, -1), at(1.2, 0.08, 1));
	add_window(&scene, 0);
	sample_add_box(
		&scene.sample, VASE, at(0.5, 0.02, 1.2), at(0.1, 0.04, 0.2));
	begin(&scene);
	merge_below(&scene, 0.02);
	CHECK(faces(&scene, WINDOW) == 12);
	CHECK(!goes(&scene, WALL));
	CHECK(!goes(&scene, WINDOW));
	CHECK(goes(&scene, VASE));
	CHECK(goes(&scene, WINDOW));
	CHECK(goes(&scene, WALL));
	end(&scene);
}

/* A rod that passes between the boards would pass through what they become. */
static double
price_with_a_rod(bool rod)
{
	struct scene scene = {0};
	double price;

	sample_add_box(&scene.sample, WINDOW, at(0, 0, 0), at(2, 0.1, 0.1));
	sample_add_box(&scene.sample, WINDOW, at(0, 0, 0.15), at(2, 0.1, 0.1));
	sample_add_box(
		&scene.sample, WINDOW, at(0, 0.02, 0.1), at(0.05, 0.05, 0.05));
	sample_add_box(&scene.sample, WALL, at(1, -2, rod ? 0.115 : 0.28),
		at(0.02, 4, 0.02));
	begin(&scene);
	do {
		struct tcs_fault fault;

		price = merges_next_cost(&scene.merges);
		CHECK(!merges_try(&scene.merges, &fault));
	} while (scene.merges.joined < 2 && price < INFINITY);
	end(&scene);
	return price;
}

static void
going_through_another_part_has_a_price(void)
{
	CHECK(price_with_a_rod(true) > 1.1 * price_with_a_rod(false));
}

static void
what_one_could_look_through_has_a_price(void)
{
	struct scene closed = {0}, open = {0};

	add_window(&closed, 0);
	begin(&closed);
	merge_below(&closed, 0.02);
	CHECK(faces(&closed, WINDOW) == 12);
	add_window(&open, 0);
	/* Without its glass. */
	open.sample.set.triangles.count -= 12;
	open.sample.set.features.count -= 12;
	begin(&open);
	merge_below(&open, 0.02);
	CHECK(faces(&open, WINDOW) > 12);
	end(&closed);
	end(&open);
}

static void
no_more_is_saved_than_is_wanted(void)
{
	struct scene scene = {0};
	struct tcs_fault fault;

	add_window(&scene, 0);
	begin(&scene);
	CHECK(!merges_aim(&scene.merges, 58, &fault));
	merge_below(&scene, 0.02);
	CHECK(scene.sample.work.face_count == 60);
	CHECK(!merges_aim(&scene.merges, 12, &fault));
	merge_below(&scene, 0.02);
	CHECK(scene.sample.work.face_count == 12);
	end(&scene);
}

static void
the_prism_has_the_faces_of_all(void)
{
	struct scene scene = {0};
	uint32_t host;

	add_boards(&scene, 5);
	begin(&scene);
	merge_below(&scene, 1e-5);
	host = part_of(&scene, WINDOW);
	CHECK(scene.removals.parts.at.at[host].count == 60);
	CHECK(removals_faces(&scene.removals, host) == 12);
	for (uint32_t i = 0; i < 5; i++)
		CHECK(parts_host(&scene.removals.parts, i) == host);
	end(&scene);
}

static const struct check_test tests[] = {
	CHECK_TEST(boards_side_by_side_become_one),
	CHECK_TEST(cells_of_one_component_become_one),
	CHECK_TEST(a_frame_and_its_pane_become_a_panel),
	CHECK_TEST(what_is_left_of_a_window_becomes_a_panel),
	CHECK_TEST(what_is_merged_goes_on_collapsing),
	CHECK_TEST(what_is_in_a_prism_stays_in_it),
	CHECK_TEST(what_comes_out_of_a_prism_has_the_price_of_its_contacts),
	CHECK_TEST(a_prism_covers_what_a_smaller_one_did),
	CHECK_TEST(boxes_that_meet_at_an_edge_stay),
	CHECK_TEST(parts_of_two_surfaces_stay),
	CHECK_TEST(open_parts_stay),
	CHECK_TEST(nothing_is_merged_where_the_error_is_watched),
	CHECK_TEST(what_touched_one_of_them_touches_the_prism),
	CHECK_TEST(what_stood_on_one_of_them_stands_on_the_prism),
	CHECK_TEST(going_through_another_part_has_a_price),
	CHECK_TEST(what_one_could_look_through_has_a_price),
	CHECK_TEST(no_more_is_saved_than_is_wanted),
	CHECK_TEST(the_prism_has_the_faces_of_all),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
