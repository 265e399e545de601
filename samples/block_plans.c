#include "block_plans.h"

#include <math.h>

#define GROUND 0.3 /* the top of the slab, metres */

/* Posts along a line at v, and a rail that rests on all but every fourth,
   which ends 5 mm below. */
static void
railing(struct block *block, double left, double right, double v, double z,
	unsigned posts)
{
	for (unsigned i = 0; i < posts; i++) {
		double u = left +
			(right - left - 0.04) * i / (posts > 1 ? posts - 1 : 1);
		double top = z + (i % 4 == 3 ? 0.895 : 0.9);

		block_box(block, "post", (struct local){u, v, z},
			(struct local){u + 0.04, v + 0.04, top});
	}
	block_box(block, "rail", (struct local){left - 0.05, v - 0.02, z + 0.9},
		(struct local){right + 0.05, v + 0.06, z + 0.95});
}

/* Steps against the edge at u, each behind the one before, and two stringers
   that pass through them. */
static void
stairs(struct block *block, double u, double v, double top, unsigned steps)
{
	double run = 0.28, rise = top / steps;

	for (unsigned i = 0; i < steps; i++)
		block_box(block, "step",
			(struct local){u, v + run * i, rise * i},
			(struct local){
				u + 1.2, v + run * (i + 1), rise * (i + 1)});
	for (int i = 0; i < 2; i++)
		block_slant(block, "stringer",
			(struct local){u + 1.1 * i, v - 0.1, 0},
			(struct local){u, v + run * steps, top}, 0.1, 0.25);
}

void
plan_hall(struct block *block)
{
	double wide = block_length(block, 16, 22);
	double deep = block_length(block, 8, 12);
	double top = block_length(block, 5, 8);
	unsigned columns = block_choice(block, 5, 12), windows, posts;
	unsigned sides = block_choice(block, 8, 40);

	block_box(block, "slab", (struct local){-2, -3, 0},
		(struct local){wide + 2, deep + 1, GROUND});
	for (unsigned i = 0; i < columns; i++)
		block_round(block, "column",
			(struct local){wide * i / (columns - 1), -2.3, GROUND},
			0.2, sides, i % 4 == 3 ? top - 0.005 : top);
	/* Through the roof. */
	block_box(block, "chimney", (struct local){4, deep - 2, top + 0.5},
		(struct local){4.8, deep - 1.2, top + 4});
	stairs(block, wide + 2, 0, GROUND, 3);
	posts = block_left(block, HULL_PARTS + 2) * 2 / 3;
	railing(block, -1.9, wide + 1.9, -2.9, GROUND, posts);
	/* Half inside the wall. */
	windows = block_left(block, HULL_PARTS + 1);
	for (unsigned i = 0; i < windows; i++)
		block_box(block, "window",
			(struct local){0.5 + (wide - 1) * i / windows,
				deep - 0.1, 1.3},
			(struct local){0.5 + (wide - 1) * (i + 0.7) / windows,
				deep + 0.05, 2.6});
	block_hull(block, (struct local){0, 0, GROUND},
		(struct local){wide, deep, top});
	block_gable(block, (struct local){-1, -3, top},
		(struct local){wide + 1, deep + 0.8, top + 3.5});
}

/* A frame of four, and a pane in it, 2 mm from the upper one. */
static void
inset_window(struct block *block, double u, double v, double z)
{
	const double w = 1, h = 1.2, f = 0.08;

	block_box(block, "sill", (struct local){u - 0.05, v - 0.1, z - f},
		(struct local){u + w + 0.05, v + 0.1, z});
	block_box(block, "head", (struct local){u, v - 0.04, z + h - f},
		(struct local){u + w, v + 0.1, z + h});
	block_box(block, "jamb", (struct local){u, v - 0.04, z},
		(struct local){u + f, v + 0.1, z + h - f});
	block_box(block, "jamb", (struct local){u + w - f, v - 0.04, z},
		(struct local){u + w, v + 0.1, z + h - f});
	block_box(block, "pane", (struct local){u + f, v - 0.02, z},
		(struct local){u + w - f, v - 0.01, z + h - f - 0.002});
}

static void
parapet(struct block *block, double wide, double deep, double z)
{
	const double t = 0.2, o = 0.6;

	block_box(block, "roof", (struct local){-o, -o, z},
		(struct local){wide + o, deep + o, z + 0.25});
	z += 0.25;
	block_box(block, "parapet", (struct local){-o, -o, z},
		(struct local){wide + o, -o + t, z + 0.5});
	block_box(block, "parapet", (struct local){-o, deep + o - t, z},
		(struct local){wide + o, deep + o, z + 0.5});
	block_box(block, "parapet", (struct local){-o, -o + t, z},
		(struct local){-o + t, deep + o - t, z + 0.5});
	block_box(block, "parapet", (struct local){wide + o - t, -o + t, z},
		(struct local){wide + o, deep + o - t, z + 0.5});
}

void
plan_terrace(struct block *block)
{
	double wide = block_length(block, 14, 20);
	double deep = block_length(block, 9, 12), storey = 3.2;
	unsigned storeys = block_choice(block, 2, 4), bays, windows, posts;
	double top = GROUND + storeys * storey;

	bays = (unsigned)(wide / 1.8);
	block_box(block, "slab", (struct local){-1, -1, 0},
		(struct local){wide + 1, deep + 1, GROUND});
	parapet(block, wide, deep, top);
	stairs(block, wide + 1, 1, GROUND + storey / 4, 6);
	windows = block_left(block, HULL_PARTS) / 8;
	if (windows > bays * storeys)
		windows = bays * storeys;
	for (unsigned i = 0; i < windows; i++)
		inset_window(block, 0.5 + 1.8 * (i % bays), 0,
			GROUND + 1 + storey * (i / bays));
	/* Balconies go into the wall at the back. */
	for (unsigned i = 1; i < storeys && block_left(block, HULL_PARTS) > 4;
		i++) {
		double z = GROUND + storey * i;

		block_box(block, "balcony",
			(struct local){1, deep - 0.2, z - 0.2},
			(struct local){wide - 1, deep + 1.5, z});
		posts = block_left(block, HULL_PARTS) / (storeys - i);
		railing(block, 1.1, wide - 1.1, deep + 1.4, z,
			posts > 2 ? posts - 2 : 1);
	}
	block_hull(block, (struct local){0, 0, GROUND},
		(struct local){wide, deep, top});
}

/* Base, shaft and capital; the shaft stands free of the capital by 5 mm in
   every fifth. */
static void
order(struct block *block, struct local foot, double top, unsigned sides,
	bool gap)
{
	double r = 0.22;

	block_box(block, "base",
		(struct local){foot.u - 0.35, foot.v - 0.35, foot.z},
		(struct local){foot.u + 0.35, foot.v + 0.35, foot.z + 0.25});
	block_round(block, "shaft",
		(struct local){foot.u, foot.v, foot.z + 0.25}, r, sides,
		top - (gap ? 0.305 : 0.3));
	block_box(block, "capital",
		(struct local){foot.u - 0.35, foot.v - 0.35, top - 0.3},
		(struct local){foot.u + 0.35, foot.v + 0.35, top});
}

static struct local
on_circle(double radius, double part, double z)
{
	double angle = 2 * acos(-1) * part;

	return (struct local){
		8 + radius * cos(angle), 7 + radius * sin(angle), z};
}

void
plan_pavilion(struct block *block)
{
	double radius = block_length(block, 4.5, 6);
	double top = block_length(block, 4, 6);
	unsigned columns = block_choice(block, 6, 12), posts;
	unsigned sides = block_choice(block, 8, 36);
	const struct local middle = {8, 7, 0};

	if (columns > block_left(block, HULL_PARTS + 8) / 4)
		columns = block_left(block, HULL_PARTS + 8) / 4;
	block_round(block, "terrace", middle, radius + 1.5, 32, 0.15);
	block_round(block, "terrace", (struct local){8, 7, 0.15}, radius + 1,
		32, GROUND);
	for (unsigned i = 0; i < columns; i++) {
		double part = (double)i / columns;

		order(block, on_circle(radius, part, GROUND), top, sides,
			i % 5 == 4);
		block_beam(block, "beam", on_circle(radius, part, top),
			on_circle(radius, part + 1.0 / columns, top), 0.4);
	}
	block_cone(block, "roof", (struct local){8, 7, top + 0.4}, radius + 0.8,
		columns, top + 2.9);
	block_box(block, "neck", (struct local){7.95, 6.95, top + 2.8},
		(struct local){8.05, 7.05, top + 3.1});
	block_round(block, "ball", (struct local){8, 7, top + 3.1}, 0.25, 16,
		top + 3.6);
	posts = block_left(block, HULL_PARTS);
	for (unsigned i = 0; i < posts; i++)
		block_round(block, "baluster",
			on_circle(radius + 0.8, (double)i / posts, GROUND),
			0.03, 4, GROUND + 0.9);
	block_hull(block, (struct local){6.5, 5.5, GROUND},
		(struct local){9.5, 8.5, top});
}

/* The tank hangs on four legs, those on small plates, and on one pipe. */
static void
water_tank(struct block *block, double z)
{
	for (int i = 0; i < 4; i++) {
		double u = 3 + 2 * (i % 2), v = 3 + 2 * (i / 2);

		block_box(block, "plate", (struct local){u - 0.15, v - 0.15, z},
			(struct local){u + 0.15, v + 0.15, z + 0.02});
		block_box(block, "leg",
			(struct local){u - 0.05, v - 0.05, z + 0.02},
			(struct local){u + 0.05, v + 0.05, z + 2.5});
	}
	block_beam(block, "brace", (struct local){3, 3, z + 1.2},
		(struct local){5, 5, z + 1.2}, 0.06);
	block_beam(block, "brace", (struct local){5, 3, z + 1.2},
		(struct local){3, 5, z + 1.2}, 0.06);
	block_round(
		block, "tank", (struct local){4, 4, z + 2.5}, 1.6, 24, z + 4.5);
	block_round(block, "pipe", (struct local){4, 4, z}, 0.1, 8, z + 2.6);
}

/* Mullions on the wall from floor to floor, and panes between them, 4 mm from
   either and 1 cm before the wall. */
static void
curtain(struct block *block, double wide, double low, double high,
	unsigned panes)
{
	for (unsigned i = 0; i < panes; i++) {
		double u = wide * i / panes, next = wide * (i + 1) / panes;

		block_box(block, "mullion", (struct local){u, -0.15, low},
			(struct local){u + 0.06, 0, high});
		block_box(block, "glass",
			(struct local){u + 0.064, -0.03, low + 0.01},
			(struct local){next - 0.004, -0.01, high - 0.01});
	}
}

void
plan_tower(struct block *block)
{
	double wide = block_length(block, 9, 12);
	double deep = block_length(block, 9, 12), storey = 3.3;
	unsigned storeys = block_choice(block, 3, 6), left;
	double top = GROUND + storeys * storey;

	block_box(block, "slab", (struct local){-2, -2, 0},
		(struct local){wide + 2, deep + 2, GROUND});
	/* Floors go through the walls. */
	for (unsigned i = 1; i < storeys; i++)
		block_box(block, "floor",
			(struct local){-0.3, -0.3, GROUND + storey * i - 0.2},
			(struct local){
				wide + 0.3, deep + 0.3, GROUND + storey * i});
	if (block_left(block, HULL_PARTS) > 16)
		water_tank(block, top);
	for (unsigned i = 0; i < storeys; i++) {
		left = block_left(block, HULL_PARTS) / (storeys - i) / 2;
		curtain(block, wide, GROUND + storey * i,
			GROUND + storey * (i + 1) - 0.2, left);
	}
	block_hull(block, (struct local){0, 0, GROUND},
		(struct local){wide, deep, top});
}
