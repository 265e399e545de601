#include "simplify/face_boxes.h"

#include "check.h"

enum { FACES = 1000 };

static struct float_box
box_at(double x)
{
	return float_box_around((struct tcs_point){x, 0, 0},
		(struct tcs_point){x + 0.5, 0.5, 0.5}, 0);
}

static size_t
count_near(const struct face_boxes *boxes, double x, uint32_t *face)
{
	struct float_box box = box_at(x);
	struct face_list near = {0};
	struct tcs_fault fault;
	size_t count;

	CHECK(!face_boxes_near(boxes, 0, &box, &near, &fault));
	count = near.count;
	*face = count ? near.at[0] : UINT32_MAX;
	array_release(&near);
	return count;
}

/* In a row, a metre apart. */
static void
a_box_that_grows_is_found_where_it_is_then(void)
{
	struct face_boxes boxes = {0};
	struct float_box own[FACES], by;
	uint32_t faces[FACES], face, place = 0;
	struct tcs_fault fault;

	for (uint32_t i = 0; i < FACES; i++) {
		faces[i] = i;
		own[i] = box_at(i);
	}
	CHECK(!face_boxes_add(&boxes, faces, own, FACES, &fault));
	CHECK(count_near(&boxes, 500, &face) == 1 && face == 500);
	CHECK(count_near(&boxes, 2000, &face) == 0);
	while (boxes.faces.at[place] != 990)
		place++;
	by = float_box_at((struct tcs_point){2000.2, 0.2, 0.2});
	face_boxes_grow(&boxes, 0, place, &by);
	CHECK(count_near(&boxes, 2000, &face) == 1 && face == 990);
	CHECK(count_near(&boxes, 500, &face) == 1 && face == 500);
	CHECK(count_near(&boxes, 995, &face) == 2);
	face_boxes_release(&boxes);
}

static void
a_box_that_is_dropped_is_found_where_it_grows_again(void)
{
	struct face_boxes boxes = {0};
	struct float_box own[FACES], by;
	uint32_t faces[FACES], face, place = 0;
	struct tcs_fault fault;

	for (uint32_t i = 0; i < FACES; i++) {
		faces[i] = i;
		own[i] = box_at(i);
	}
	CHECK(!face_boxes_add(&boxes, faces, own, FACES, &fault));
	while (boxes.faces.at[place] != 500)
		place++;
	face_boxes_drop(&boxes, 0, place);
	CHECK(count_near(&boxes, 500, &face) == 0);
	CHECK(count_near(&boxes, 501, &face) == 1 && face == 501);
	by = float_box_at((struct tcs_point){700.2, 0.2, 0.2});
	face_boxes_grow(&boxes, 0, place, &by);
	CHECK(count_near(&boxes, 500, &face) == 0);
	CHECK(count_near(&boxes, 700, &face) == 2);
	face_boxes_release(&boxes);
}

static bool
have_the_same(const struct face_list *a, const struct face_list *b)
{
	bool same = a->count == b->count;

	for (size_t i = 0; same && i < a->count; i++)
		same = a->at[i] == b->at[i];
	return same;
}

/* Whether it is a copy or not. */
static void
an_extract_answers_in_the_order_of_all(void)
{
	static const struct {
		double low, high;
	} spans[] = {{10, 13}, {20, 60}, {100, 700}, {2000, 2001}};
	struct face_boxes boxes = {0};
	struct face_extract extract = {0};
	struct face_list all = {0}, some = {0};
	struct float_box own[FACES], wide, box;
	uint32_t faces[FACES];
	struct tcs_fault fault;

	for (uint32_t i = 0; i < FACES; i++) {
		faces[i] = i;
		own[i] = box_at(i % 97 * 10 + i / 97);
	}
	CHECK(!face_boxes_add(&boxes, faces, own, FACES, &fault));
	for (size_t i = 0; i < sizeof spans / sizeof *spans; i++) {
		wide = float_box_around((struct tcs_point){spans[i].low, 0, 0},
			(struct tcs_point){spans[i].high, 1, 1}, 0);
		CHECK(!face_extract_fill(&extract, &boxes, 0, &wide, &fault));
		CHECK(extract.is_copy == (i != 2));
		for (double x = spans[i].low; x < spans[i].high; x += 0.7) {
			box = float_box_around((struct tcs_point){x, 0, 0},
				(struct tcs_point){spans[i].high, 0.1, 0.1}, 0);
			CHECK(!face_boxes_near(&boxes, 0, &box, &all, &fault));
			CHECK(!face_extract_near(
				&extract, &box, &some, &fault));
			CHECK(have_the_same(&all, &some));
			CHECK(all.count > 0 || i == 3);
		}
	}
	array_release(&all);
	array_release(&some);
	face_extract_release(&extract);
	face_boxes_release(&boxes);
}

static const struct check_test tests[] = {
	CHECK_TEST(a_box_that_grows_is_found_where_it_is_then),
	CHECK_TEST(a_box_that_is_dropped_is_found_where_it_grows_again),
	CHECK_TEST(an_extract_answers_in_the_order_of_all),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
