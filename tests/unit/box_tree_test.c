#include "simplify/box_tree.h"

#include <math.h>

#include "check.h"

enum { COUNT = 100 };

static struct box
box_at(double x)
{
	return (struct box){{x, 0, 0}, {x + 0.5, 1, 1}};
}

static bool
take(void *context, uint32_t position)
{
	bool *found = context;

	found[position] = true;
	return true;
}

static bool
finds(const struct box_tree *tree, uint32_t root, uint32_t item, double x)
{
	const struct box place = box_at(x);
	bool found[COUNT] = {false};

	box_tree_near(tree, root, &place, 0, take, found);
	for (uint32_t i = 0; i < COUNT; i++)
		if (found[i] && tree->items.at[i] == item)
			return true;
	return false;
}

static void
an_item_is_found_where_it_has_grown(void)
{
	struct box_tree tree = {0};
	struct box boxes[COUNT], has;
	uint32_t items[COUNT], root;
	struct tcs_fault fault;

	for (uint32_t i = 0; i < COUNT; i++) {
		boxes[i] = box_at(i);
		items[i] = i;
	}
	CHECK(!box_tree_add(&tree, boxes, items, COUNT, &root, &fault));
	CHECK(finds(&tree, root, 30, 30) && !finds(&tree, root, 30, 80));
	CHECK(!finds(&tree, root, 30, 500));
	has = boxes[30];
	box_add_point(&has, (struct tcs_point){500, 0, 0});
	box_tree_enlarge(&tree, root, 30, &boxes[30], &has);
	CHECK(finds(&tree, root, 30, 30) && finds(&tree, root, 30, 80));
	CHECK(finds(&tree, root, 30, 500));
	CHECK(!finds(&tree, root, 90, 500));
	box_tree_release(&tree);
}

static const struct check_test tests[] = {
	CHECK_TEST(an_item_is_found_where_it_has_grown),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
