#include "block_parts.h"

#include <math.h>
#include <stdio.h>

unsigned
block_choice(struct block *block, unsigned low, unsigned high)
{
	block->random =
		block->random * 6364136223846793005u + 1442695040888963407u;
	return low + (unsigned)(block->random >> 33) % (high - low + 1);
}

/* Whole centimetres, so that what should touch does. */
double
block_length(struct block *block, double low, double high)
{
	unsigned steps = (unsigned)lround(100 * (high - low));

	return low + block_choice(block, 0, steps) / 100.0;
}

unsigned
block_left(const struct block *block, unsigned others)
{
	unsigned done = block->parts + others;

	return done < block->part_goal ? block->part_goal - done : 0;
}

/* ---- parts --------------------------------------------------------------- */

static void
count_part(struct block *block)
{
	const struct shape *shape = block->shape;

	block->parts++;
	for (size_t i = 0; i < shape->ring_count; i++)
		block->triangles += (unsigned)shape->rings[i].count - 2;
}

static void
part_begin(struct block *block)
{
	shape_begin(block->shape, block->frame);
}

static void
part_end(struct block *block, const char *kind)
{
	struct gml *gml = block->gml;
	char id[GML_ID];

	count_part(block);
	snprintf(id, sizeof id, "K%u_%s%u", block->building + 1, kind,
		block->parts);
	gml_open(gml, "bldg:outerBuildingInstallation", NULL);
	gml_open(gml, "bldg:BuildingInstallation", id);
	gml_multi_surface(gml, "bldg:lod3Geometry", block->shape);
	gml_close(gml, "bldg:BuildingInstallation");
	gml_close(gml, "bldg:outerBuildingInstallation");
}

void
block_box(struct block *block, const char *kind, struct local low,
	struct local high)
{
	part_begin(block);
	shape_box(block->shape, low, high);
	part_end(block, kind);
}

void
block_prism(struct block *block, const char *kind, const double (*outline)[2],
	unsigned count, double low, double high)
{
	part_begin(block);
	shape_block(block->shape, outline, count, low, high);
	part_end(block, kind);
}

static void
circle(double outline[BLOCK_SIDES][2], struct local middle, double radius,
	unsigned sides)
{
	for (unsigned i = 0; i < sides; i++) {
		double angle = 2 * acos(-1) * i / sides;

		outline[i][0] = middle.u + radius * cos(angle);
		outline[i][1] = middle.v + radius * sin(angle);
	}
}

void
block_round(struct block *block, const char *kind, struct local foot,
	double radius, unsigned sides, double high)
{
	double outline[BLOCK_SIDES][2];

	circle(outline, foot, radius, sides);
	block_prism(
		block, kind, (const double(*)[2])outline, sides, foot.z, high);
}

void
block_cone(struct block *block, const char *kind, struct local foot,
	double radius, unsigned sides, double high)
{
	double outline[BLOCK_SIDES][2];

	circle(outline, foot, radius, sides);
	part_begin(block);
	shape_face(block->shape, FACE_EAVES);
	for (unsigned i = sides; i-- > 0;)
		shape_point(block->shape, outline[i][0], outline[i][1], foot.z);
	for (unsigned i = 0; i < sides; i++) {
		const double *b = outline[(i + 1) % sides];
		const struct local side[] = {
			{outline[i][0], outline[i][1], foot.z},
			{b[0], b[1], foot.z},
			{foot.u, foot.v, high},
		};

		shape_polygon(block->shape, FACE_ROOF, side, 3);
	}
	part_end(block, kind);
}

void
block_slant(struct block *block, const char *kind, struct local from,
	struct local to, double wide, double thick)
{
	const double profile[][2] = {{from.v, from.z}, {to.v, to.z},
		{to.v, to.z + thick}, {from.v, from.z + thick}};
	const enum face_class classes[] = {
		FACE_EAVES, FACE_WALL, FACE_ROOF, FACE_WALL};

	part_begin(block);
	shape_extrude(block->shape, profile, classes, 4, from.u, from.u + wide);
	part_end(block, kind);
}

void
block_beam(struct block *block, const char *kind, struct local from,
	struct local to, double thick)
{
	double u = to.u - from.u, v = to.v - from.v;
	double half = thick / 2 / hypot(u, v);
	const double outline[][2] = {
		{from.u + half * v, from.v - half * u},
		{to.u + half * v, to.v - half * u},
		{to.u - half * v, to.v + half * u},
		{from.u - half * v, from.v + half * u},
	};

	block_prism(block, kind, outline, 4, from.z, from.z + thick);
}

/* ---- hulls --------------------------------------------------------------- */

static void
boundary_end(struct block *block, const char *class)
{
	struct gml *gml = block->gml;
	char id[GML_ID];

	count_part(block);
	snprintf(id, sizeof id, "K%u_%s%u", block->building + 1, class,
		block->parts);
	gml_boundary_open(gml, "bldg", class, id);
	gml_multi_surface(gml, "bldg:lod3MultiSurface", block->shape);
	gml_boundary_close(gml, "bldg", class);
}

/* Between two corners, exactly the one or the other at the ends, so that what
   is rounded to millimetres is the same for all that meet there. */
static struct local
between(struct local from, struct local to, unsigned part, unsigned grid)
{
	double b = (double)part / grid, a = 1 - b;

	return (struct local){a * from.u + b * to.u, a * from.v + b * to.v,
		a * from.z + b * to.z};
}

/* One wall: a grid of quads. */
static void
hull_wall(struct block *block, struct local from, struct local to, double top,
	unsigned grid)
{
	const struct local low = {0, 0, from.z}, high = {0, 0, top};

	part_begin(block);
	for (unsigned i = 0; i < grid * grid; i++) {
		struct local left = between(from, to, i % grid, grid);
		struct local right = between(from, to, i % grid + 1, grid);
		double foot = between(low, high, i / grid, grid).z;
		double head = between(low, high, i / grid + 1, grid).z;
		const struct local quad[] = {
			{left.u, left.v, foot},
			{right.u, right.v, foot},
			{right.u, right.v, head},
			{left.u, left.v, head},
		};

		shape_polygon(block->shape, FACE_WALL, quad, 4);
	}
	boundary_end(block, "WallSurface");
}

/* Floor and ceiling have the grid's points on their edges. */
static void
hull_lid(struct block *block, const struct local corners[4], double z,
	unsigned grid, bool up)
{
	part_begin(block);
	shape_face(block->shape, up ? FACE_ROOF : FACE_GROUND);
	for (unsigned i = 0; i < 4 * grid; i++) {
		unsigned at = up ? i : 4 * grid - 1 - i;
		struct local spot = between(corners[at / grid],
			corners[(at / grid + 1) % 4], at % grid, grid);

		shape_point(block->shape, spot.u, spot.v, z);
	}
	boundary_end(block, up ? "RoofSurface" : "GroundSurface");
}

/* With n rows and columns there are 8 n² + 8 n - 4 triangles. */
void
block_hull(struct block *block, struct local low, struct local high)
{
	const struct local corners[] = {{low.u, low.v, low.z},
		{high.u, low.v, low.z}, {high.u, high.v, low.z},
		{low.u, high.v, low.z}};
	unsigned grid = 2;

	while (grid < 22 &&
		block->triangles + 8 * (grid + 1) * (grid + 2) <=
			block->triangle_goal)
		grid++;
	for (int i = 0; i < 4; i++)
		hull_wall(
			block, corners[i], corners[(i + 1) % 4], high.z, grid);
	hull_lid(block, corners, low.z, grid, false);
	hull_lid(block, corners, high.z, grid, true);
}

void
block_gable(struct block *block, struct local low, struct local high)
{
	const double profile[][2] = {{low.v, low.z}, {high.v, low.z},
		{(low.v + high.v) / 2, high.z}};
	const enum face_class classes[] = {FACE_EAVES, FACE_ROOF, FACE_ROOF};

	part_begin(block);
	shape_extrude(block->shape, profile, classes, 3, low.u, high.u);
	boundary_end(block, "RoofSurface");
}
