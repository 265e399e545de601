#include "check.h"
#include "town_sample.h"
#include "writers/gltf_mesh.h"

#include <math.h>

static struct tcs_fault fault;
static struct frame frame;
static struct tcs_object object;
static struct mesh mesh;

static const struct mesh_place directly = {&frame, NULL};

static const struct mesh_paint grey = {1, TCS_NONE, NULL};

static void
start(void)
{
	static const struct tcs_crs crs = {
		.metres_per_unit = 1, .metres_per_unit_up = 1};
	static const struct tcs_point origin = {500000, 5300000, 100};

	frame_init(&frame, &crs, &origin);
	object_clear(&object);
	mesh_release(&mesh);
	mesh = (struct mesh){.triangle_limit = 0};
}

/* A fan over points given relative to the origin. */
static void
polygon(const struct tcs_point *points, uint32_t count)
{
	uint32_t first = (uint32_t)object.vertices.count;

	SAMPLE_PUSH(object.polygons,
		(struct tcs_polygon){.first_vertex = first,
			.vertex_count = count,
			.first_triangle = (uint32_t)object.triangles.count,
			.triangle_count = count - 2});
	for (uint32_t i = 0; i < count; i++)
		SAMPLE_PUSH(object.vertices,
			(struct tcs_point){500000 + points[i].x,
				5300000 + points[i].y, 100 + points[i].z});
	for (uint32_t i = 1; i + 1 < count; i++)
		SAMPLE_PUSH(object.triangles,
			(struct tcs_triangle){
				{first, first + i, first + i + 1}});
}

static enum mesh_outcome
add(size_t number, uint32_t feature, uint32_t paint)
{
	const struct mesh_paint plain = {paint, TCS_NONE, NULL};
	enum mesh_outcome outcome = MESH_TOO_FAR;

	CHECK(!mesh_add_polygon(&mesh, &object, object.polygons.at + number,
		&directly, feature, &plain, MESH_FLAT, &outcome, &fault));
	return outcome;
}

/*   3---2
 *   |  /|
 *   | / |
 *   0---1   at z = 0, seen from above */
static const struct tcs_point square[] = {
	{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};

static void
a_flat_square_has_four_vertices_and_one_normal(void)
{
	float lower[3], upper[3];

	start();
	polygon(square, 4);
	CHECK(add(0, 7, 1) == MESH_DRAWN);
	CHECK(mesh.features.count == 4 && mesh.features.at[3] == 7);
	CHECK(mesh.indices.count == 6);
	for (size_t i = 0; i < 4; i++) {
		CHECK(mesh.normals.at[3 * i] == 0);
		CHECK(mesh.normals.at[3 * i + 1] == 0);
		CHECK(mesh.normals.at[3 * i + 2] == 1);
	}
	mesh_bounds(&mesh, lower, upper);
	CHECK(lower[0] == 0 && upper[1] == 2 && upper[2] == 0);
}

static void
a_bent_polygon_is_shaded_triangle_by_triangle(void)
{
	static const struct tcs_point bent[] = {
		{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 3}};

	start();
	polygon(bent, 4);
	CHECK(add(0, 0, 1) == MESH_DRAWN);
	CHECK(mesh.features.count == 6);
	CHECK(mesh.normals.at[2] == 1 && mesh.normals.at[11] < 0.9f);
}

static void
a_triangle_without_area_is_left_out_and_counted(void)
{
	static const struct tcs_point spiked[] = {
		{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 2, 0}};
	static const struct tcs_point line[] = {
		{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};

	start();
	polygon(spiked, 4);
	polygon(line, 3);
	CHECK(add(0, 0, 1) == MESH_DRAWN);
	CHECK(mesh.indices.count == 3 && mesh.features.count == 3);
	CHECK(mesh.flat_triangles == 1);
	CHECK(add(1, 0, 1) == MESH_NO_AREA);
	CHECK(mesh.indices.count == 3);
}

/* Collinear once rounded, not before: flat where it is drawn. */
static void
a_triangle_that_floats_flatten_is_left_out(void)
{
	static const struct tcs_point nearly[] = {{6.580710678, 6.44, 3.1},
		{6.570104076, 6.4506066, 3.1}, {6.555961941, 6.46474874, 3.1},
		{9, 9, 3.1}};

	start();
	polygon(nearly, 4);
	for (size_t i = 0; i < 4; i++)
		object.vertices.at[i] = nearly[i];
	frame.origin = (struct tcs_point){0, 0, 0};
	CHECK(add(0, 0, 1) == MESH_DRAWN);
	CHECK(mesh.indices.count == 3 && mesh.flat_triangles == 1);
}

static void
what_does_not_fit_a_float_is_told(void)
{
	static const struct tcs_point far_away[] = {
		{0, 0, 0}, {1e39, 0, 0}, {1e39, 1e39, 0}};

	start();
	polygon(far_away, 3);
	CHECK(add(0, 0, 1) == MESH_TOO_FAR);
	CHECK(mesh.indices.count == 0);
}

static void
runs_are_grouped_by_paint(void)
{
	start();
	for (int i = 0; i < 5; i++)
		polygon(square, 4);
	for (size_t i = 0; i < 5; i++)
		CHECK(add(i, (uint32_t)i, i % 2 ? 9 : 4) == MESH_DRAWN);
	CHECK(!mesh_group(&mesh, &fault));
	CHECK(mesh.runs.count == 2);
	CHECK(mesh.runs.at[0].paint == 4 && mesh.runs.at[0].count == 18);
	CHECK(mesh.runs.at[1].paint == 9 && mesh.runs.at[1].first == 18);
	CHECK(mesh.indices.count == 30);
	for (size_t i = 0; i < 30; i++)
		CHECK(mesh.features.at[mesh.indices.at[i]] % 2 == (i >= 18));
}

static void
the_triangle_limit_holds(void)
{
	enum mesh_outcome outcome;

	start();
	mesh.triangle_limit = 3;
	polygon(square, 4);
	polygon(square, 4);
	CHECK(add(0, 0, 1) == MESH_DRAWN);
	CHECK(mesh_add_polygon(&mesh, &object, object.polygons.at + 1,
		      &directly, 0, &grey, MESH_FLAT, &outcome,
		      &fault) == TCS_LIMIT);
}

static void
an_instance_is_placed_and_a_mirror_keeps_the_outside_out(void)
{
	struct tcs_instance instance = {
		.matrix = {[0] = -1, [5] = 1, [10] = 1, [15] = 1, [3] = 4},
		.anchor = {500010, 5300020, 100}};
	struct mesh_place place = {&frame, &instance};
	enum mesh_outcome outcome;

	start();
	polygon(square, 4);
	for (size_t i = 0; i < 4; i++)
		object.vertices.at[i] = square[i];
	CHECK(!mesh_add_polygon(&mesh, &object, object.polygons.at, &place, 0,
		&grey, MESH_FLAT, &outcome, &fault));
	for (size_t i = 0; i < 4; i++) {
		const float *at = mesh.positions.at + 3 * i;

		CHECK(at[0] >= 12 && at[0] <= 14);
		CHECK(at[1] >= 20 && at[1] <= 22);
	}
	CHECK(mesh.normals.at[2] == 1);
	{
		const float *p = mesh.positions.at;
		const uint32_t *c = mesh.indices.at;
		const float *a = p + 3 * c[0], *b = p + 3 * c[1],
			    *d = p + 3 * c[2];

		CHECK((b[0] - a[0]) * (d[1] - a[1]) -
				(b[1] - a[1]) * (d[0] - a[0]) >
			0);
	}
}

/* Two roofs that meet at a ridge, 20 degrees apart, of one surface. */
static void
smooth_normals_stop_at_the_crease(void)
{
	double rise = tan(10 * acos(-1) / 180);
	const struct tcs_point left[] = {
		{-1, 0, -rise}, {0, 0, 0}, {0, 1, 0}, {-1, 1, -rise}};
	const struct tcs_point right[] = {
		{0, 0, 0}, {1, 0, -rise}, {1, 1, -rise}, {0, 1, 0}};

	start();
	polygon(left, 4);
	polygon(right, 4);
	CHECK(add(0, 3, 1) == MESH_DRAWN && add(1, 3, 1) == MESH_DRAWN);
	CHECK(!mesh_smooth(&mesh, cos(15 * acos(-1) / 180), &fault));
	CHECK(fabsf(mesh.normals.at[3]) > 0.1f);
	CHECK(!mesh_smooth(&mesh, cos(30 * acos(-1) / 180), &fault));
	CHECK(fabsf(mesh.normals.at[3]) < 1e-6f);
	CHECK(fabsf(mesh.normals.at[5] - 1) < 1e-6f);
	CHECK(fabsf(mesh.normals.at[0]) > 0.1f);

	start();
	polygon(left, 4);
	polygon(right, 4);
	CHECK(add(0, 3, 1) == MESH_DRAWN && add(1, 4, 1) == MESH_DRAWN);
	CHECK(!mesh_smooth(&mesh, cos(30 * acos(-1) / 180), &fault));
	CHECK(fabsf(mesh.normals.at[3]) > 0.1f);
	mesh_release(&mesh);
	object_release(&object);
}

/* Vertices before the first image get coordinates too, and those after. */
static void
texture_coordinates_follow_the_vertices(void)
{
	static const struct tcs_texcoord at[] = {
		{0, 0}, {3, 0}, {3, 1}, {0, 0.25}};
	const struct mesh_paint bricks = {1, 5, at};
	enum mesh_outcome outcome;

	start();
	polygon(square, 4);
	CHECK(add(0, 0, 1) == MESH_DRAWN);
	CHECK(!mesh.texcoords.count);
	CHECK(!mesh_add_polygon(&mesh, &object, object.polygons.at, &directly,
		0, &bricks, MESH_FLAT, &outcome, &fault));
	CHECK(add(0, 0, 2) == MESH_DRAWN);
	CHECK(mesh.texcoords.count == 2 * mesh.features.count);
	CHECK(mesh.texcoords.at[0] == 0 && mesh.texcoords.at[7] == 0);
	CHECK(mesh.texcoords.at[8] == 0 && mesh.texcoords.at[9] == 1);
	CHECK(mesh.texcoords.at[12] == 3 && mesh.texcoords.at[13] == 0);
	CHECK(mesh.texcoords.at[15] == 0.75f && mesh.texcoords.at[17] == 0);
	CHECK(!mesh_group(&mesh, &fault));
	CHECK(mesh.runs.count == 3 && mesh.runs.at[0].image == 5);
}

int
main(void)
{
	static const struct check_test tests[] = {
		CHECK_TEST(a_flat_square_has_four_vertices_and_one_normal),
		CHECK_TEST(a_bent_polygon_is_shaded_triangle_by_triangle),
		CHECK_TEST(a_triangle_without_area_is_left_out_and_counted),
		CHECK_TEST(a_triangle_that_floats_flatten_is_left_out),
		CHECK_TEST(what_does_not_fit_a_float_is_told),
		CHECK_TEST(runs_are_grouped_by_paint),
		CHECK_TEST(the_triangle_limit_holds),
		CHECK_TEST(
			an_instance_is_placed_and_a_mirror_keeps_the_outside_out),
		CHECK_TEST(smooth_normals_stop_at_the_crease),
		CHECK_TEST(texture_coordinates_follow_the_vertices),
		{0},
	};

	return check_run(tests);
}
