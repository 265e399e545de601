/* Meshes are drawn: every '#' is a square metre of two triangles, seen from
 * above, the first line the northernmost. */
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "writers/coplanar.h"

enum { SIDE = 12, MOST = 2 * SIDE * SIDE };

struct mesh {
	struct tcs_point vertices[(SIDE + 1) * (SIDE + 1)];
	uint64_t coats[(SIDE + 1) * (SIDE + 1)];
	struct tcs_triangle triangles[MOST];
	size_t count;
};

static const struct tcs_point metre = {1, 1, 1};

static uint32_t
vertex_at(size_t x, size_t y)
{
	return (uint32_t)(y * (SIDE + 1) + x);
}

static void
add(struct mesh *mesh, uint32_t a, uint32_t b, uint32_t c)
{
	mesh->triangles[mesh->count++] = (struct tcs_triangle){{a, b, c}};
}

static void
add_square(struct mesh *mesh, size_t x, size_t y)
{
	uint32_t a = vertex_at(x, y), b = vertex_at(x + 1, y);
	uint32_t c = vertex_at(x + 1, y + 1), d = vertex_at(x, y + 1);

	add(mesh, a, b, c);
	add(mesh, a, c, d);
}

static void
draw(struct mesh *mesh, const char *const *lines, size_t height)
{
	memset(mesh, 0, sizeof *mesh);
	for (size_t y = 0; y <= SIDE; y++)
		for (size_t x = 0; x <= SIDE; x++)
			mesh->vertices[vertex_at(x, y)] =
				(struct tcs_point){(double)x, (double)y, 0};
	for (size_t y = 0; y < height; y++)
		for (size_t x = 0; lines[height - 1 - y][x]; x++)
			if (lines[height - 1 - y][x] == '#')
				add_square(mesh, x, y);
}

#define DRAW(mesh, ...) \
	draw((mesh), (const char *const[]){__VA_ARGS__}, \
		sizeof((const char *const[]){__VA_ARGS__}) / sizeof(char *))

static void
join(struct coplanar *out, const struct mesh *mesh)
{
	struct tcs_fault fault;

	coplanar_clear(out);
	CHECK(!coplanar_join(out, mesh->vertices, mesh->coats, metre,
		mesh->triangles, mesh->count, &fault));
}

/* "6 4, 3": a face of a ring of 6 and one of 4 corners, and one of 3. */
static bool
is(const struct coplanar *out, const char *faces)
{
	char text[512] = "";

	for (size_t i = 0; i < out->faces.count; i++)
		for (uint32_t j = 0; j < out->faces.at[i].ring_count; j++) {
			size_t used = strlen(text);

			snprintf(text + used, sizeof text - used, "%s%u",
				j	    ? " "
					: i ? ", "
					    : "",
				out->rings.at[out->faces.at[i].first_ring + j]
					.count);
		}
	if (strcmp(text, faces) != 0)
		fprintf(stderr, "it is \"%s\"\n", text);
	return !strcmp(text, faces);
}

static bool
join_to(const struct mesh *mesh, const char *faces)
{
	struct coplanar out = {0};
	bool same;

	join(&out, mesh);
	same = is(&out, faces);
	coplanar_release(&out);
	return same;
}

/* ---- drawings ---------------------------------------------------------------- */

static void
squares_become_one_polygon_that_keeps_every_border_vertex(void)
{
	struct mesh mesh;

	DRAW(&mesh, "#");
	CHECK(join_to(&mesh, "4"));
	DRAW(&mesh, "###", "###");
	CHECK(join_to(&mesh, "10"));
	DRAW(&mesh, "#  #", "####");
	CHECK(join_to(&mesh, "14"));
}

static void
holes_are_rings_of_their_own_and_run_the_other_way(void)
{
	struct coplanar out = {0};
	struct mesh mesh;

	DRAW(&mesh, "#####", "# # #", "#####");
	join(&out, &mesh);
	CHECK(is(&out, "16 4 4"));
	CHECK(out.rings.at[0].area == 30);
	CHECK(out.rings.at[1].area == -2);
	CHECK(out.rings.at[2].area == -2);
	CHECK(out.corners.at[0] == vertex_at(0, 0));
	CHECK(out.corners.at[1] == vertex_at(1, 0));
	coplanar_release(&out);
}

static void
rings_that_meet_in_a_point_are_cut_there(void)
{
	struct mesh mesh;

	DRAW(&mesh, "## ", "# #", "###");
	CHECK(join_to(&mesh, "12 4"));
	DRAW(&mesh, "####", "# ##", "## #", "####");
	CHECK(join_to(&mesh, "16 4 4"));
	DRAW(&mesh, "#####", "# ###", "## ##", "# ###", "#####");
	CHECK(join_to(&mesh, "20 4 4 4"));
}

static void
what_only_shares_a_point_is_apart(void)
{
	struct mesh mesh;

	DRAW(&mesh, "# ", " #");
	CHECK(join_to(&mesh, "4, 4"));
	DRAW(&mesh, "# #", "   ", "# #");
	CHECK(join_to(&mesh, "4, 4, 4, 4"));
}

static void
faces_stand_in_the_order_of_their_first_triangles(void)
{
	struct coplanar out = {0};
	struct mesh mesh;

	DRAW(&mesh, "## #", "   #");
	join(&out, &mesh);
	CHECK(is(&out, "6, 6"));
	CHECK(out.faces.at[0].first_triangle == 0);
	CHECK(out.faces.at[1].first_triangle == 2);
	coplanar_release(&out);
}

/* ---- planes ------------------------------------------------------------------- */

static void
bend(struct mesh *mesh, double height)
{
	for (size_t y = 0; y <= SIDE; y++)
		for (size_t x = 3; x <= SIDE; x++)
			mesh->vertices[vertex_at(x, y)].z =
				height * (double)(x - 2);
}

static void
a_bend_within_a_millimetre_is_flat(void)
{
	struct mesh mesh;

	DRAW(&mesh, "###");
	bend(&mesh, 0.0005);
	CHECK(join_to(&mesh, "8"));
	bend(&mesh, 0.01);
	CHECK(join_to(&mesh, "6, 4"));
	bend(&mesh, 1);
	CHECK(join_to(&mesh, "6, 4"));
}

/* A long slow curve: each bend is small, all of them together are not. */
static void
what_bends_slowly_is_cut_into_flat_pieces(void)
{
	struct coplanar out = {0};
	struct mesh mesh;

	DRAW(&mesh, "############");
	for (size_t y = 0; y <= SIDE; y++)
		for (size_t x = 0; x <= SIDE; x++)
			mesh.vertices[vertex_at(x, y)].z =
				0.0004 * (double)(x * x);
	join(&out, &mesh);
	CHECK(out.faces.count > 2 && out.faces.count < 12);
	coplanar_release(&out);
}

static void
the_two_sides_of_a_sheet_stay_two(void)
{
	struct mesh mesh;

	DRAW(&mesh, "#");
	add(&mesh, vertex_at(0, 0), vertex_at(1, 1), vertex_at(1, 0));
	add(&mesh, vertex_at(0, 0), vertex_at(0, 1), vertex_at(1, 1));
	/* every edge is there four times or, at the border, both ways */
	CHECK(join_to(&mesh, "3, 3, 3, 3"));
}

static void
an_edge_of_three_triangles_is_a_border(void)
{
	struct mesh mesh;

	DRAW(&mesh, "##");
	mesh.vertices[vertex_at(5, 5)] = (struct tcs_point){1, 0.5, 1};
	add(&mesh, vertex_at(1, 1), vertex_at(1, 0), vertex_at(5, 5));
	CHECK(join_to(&mesh, "4, 4, 3"));
}

static void
a_thin_triangle_goes_along(void)
{
	struct mesh mesh;

	/* the square's lower edge has a vertex that its triangles lack */
	DRAW(&mesh, "#");
	mesh.vertices[vertex_at(5, 5)] = (struct tcs_point){0.3, 0, 0};
	add(&mesh, vertex_at(1, 0), vertex_at(0, 0), vertex_at(5, 5));
	CHECK(join_to(&mesh, "5"));
	mesh.vertices[vertex_at(5, 5)].y = 1e-9;
	CHECK(join_to(&mesh, "5"));
	mesh.vertices[vertex_at(5, 5)].y = -1e-9;
	CHECK(join_to(&mesh, "5"));
}

static void
a_low_step_is_no_part_of_the_floor(void)
{
	struct mesh mesh;

	DRAW(&mesh, "#");
	mesh.vertices[vertex_at(5, 5)] = (struct tcs_point){0.5, 0, -0.0008};
	add(&mesh, vertex_at(1, 0), vertex_at(0, 0), vertex_at(5, 5));
	CHECK(join_to(&mesh, "4, 3"));
}

static void
a_triangle_without_three_positions_vanishes(void)
{
	struct mesh mesh;

	DRAW(&mesh, "#");
	mesh.vertices[vertex_at(5, 5)] = mesh.vertices[vertex_at(1, 0)];
	add(&mesh, vertex_at(1, 0), vertex_at(0, 0), vertex_at(5, 5));
	CHECK(join_to(&mesh, "4"));
	mesh.count = 0;
	CHECK(join_to(&mesh, ""));
}

static void
a_seam_is_a_border(void)
{
	struct mesh mesh;

	DRAW(&mesh, "##");
	for (uint32_t y = 0; y < 2; y++) {
		uint32_t to = vertex_at(5, 5 + y);

		mesh.vertices[to] = mesh.vertices[vertex_at(1, y)];
		mesh.coats[to] = 7;
		for (size_t i = 2; i < 4; i++)
			for (size_t k = 0; k < 3; k++)
				if (mesh.triangles[i].corner[k] ==
					vertex_at(1, y))
					mesh.triangles[i].corner[k] = to;
	}
	CHECK(join_to(&mesh, "4, 4"));
	mesh.coats[vertex_at(5, 5)] = mesh.coats[vertex_at(5, 6)] = 0;
	CHECK(join_to(&mesh, "6"));
}

static void
units_and_places_make_no_difference(void)
{
	struct tcs_point degrees = {71500, 111300, 1};
	struct coplanar out = {0};
	struct tcs_fault fault;
	struct mesh mesh;

	DRAW(&mesh, "###", "# #", "###");
	for (size_t i = 0; i < (SIDE + 1) * (SIDE + 1); i++) {
		mesh.vertices[i].x += 458000;
		mesh.vertices[i].y += 5438000;
	}
	CHECK(join_to(&mesh, "12 4"));
	DRAW(&mesh, "###");
	for (size_t i = 0; i < (SIDE + 1) * (SIDE + 1); i++) {
		mesh.vertices[i].x = 8 + mesh.vertices[i].x / degrees.x;
		mesh.vertices[i].y = 50 + mesh.vertices[i].y / degrees.y;
	}
	bend(&mesh, 0.01);
	CHECK(!coplanar_join(&out, mesh.vertices, NULL, degrees, mesh.triangles,
		mesh.count, &fault));
	CHECK(is(&out, "6, 4"));
	coplanar_release(&out);
}

/* ---- what always holds -------------------------------------------------------- */

static int edges[(SIDE + 1) * (SIDE + 1)][(SIDE + 1) * (SIDE + 1)];

/* Edges of the triangles less those of the rings, each way less the other. */
static bool
borders_agree(const struct mesh *mesh, const struct coplanar *out)
{
	const size_t count = (SIDE + 1) * (SIDE + 1);

	memset(edges, 0, sizeof edges);
	for (size_t i = 0; i < mesh->count; i++)
		for (size_t k = 0; k < 3; k++)
			edges[mesh->triangles[i].corner[k]]
			     [mesh->triangles[i].corner[(k + 1) % 3]]++;
	for (size_t i = 0; i < out->rings.count; i++) {
		const struct coplanar_ring *ring = &out->rings.at[i];
		const uint32_t *at = out->corners.at + ring->first;

		for (uint32_t k = 0; k < ring->count; k++)
			edges[at[k]][at[(k + 1) % ring->count]]--;
	}
	for (size_t a = 0; a < count; a++)
		for (size_t b = 0; b < count; b++)
			if (edges[a][b] != edges[b][a])
				return false;
	return true;
}

static bool
rings_are_simple(const struct coplanar *out)
{
	for (size_t i = 0; i < out->rings.count; i++) {
		const struct coplanar_ring *ring = &out->rings.at[i];
		const uint32_t *at = out->corners.at + ring->first;

		for (uint32_t j = 0; j < ring->count; j++)
			for (uint32_t k = 0; k < j; k++)
				if (at[j] == at[k])
					return false;
	}
	return true;
}

static double
area_of_faces(const struct coplanar *out)
{
	double area = 0;

	for (size_t i = 0; i < out->rings.count; i++)
		area += out->rings.at[i].area / 2;
	return area;
}

static void
any_drawing_keeps_its_border_and_its_area(void)
{
	struct coplanar out = {0};
	static struct mesh mesh;
	uint32_t random = 1;

	for (int run = 0; run < 300; run++) {
		DRAW(&mesh, "#");
		mesh.count = 0;
		for (size_t y = 0; y < SIDE; y++)
			for (size_t x = 0; x < SIDE; x++) {
				random = random * 1664525 + 1013904223;
				if (random >> 24 < 150)
					add_square(&mesh, x, y);
				mesh.vertices[vertex_at(x, y)].z = run % 3
					? (random >> 16 & 7) * 0.0002 *
						(run % 3)
					: 0;
			}
		join(&out, &mesh);
		CHECK(borders_agree(&mesh, &out));
		CHECK(rings_are_simple(&out));
		if (run % 3 == 0)
			CHECK(area_of_faces(&out) == (double)mesh.count / 2);
	}
	coplanar_release(&out);
}

static void
numbers_beyond_all_measure_do_no_harm(void)
{
	struct coplanar out = {0};
	struct mesh mesh;

	DRAW(&mesh, "##", "##");
	mesh.vertices[vertex_at(1, 1)].x = 1e308;
	mesh.vertices[vertex_at(0, 0)].x = -1e308;
	join(&out, &mesh);
	CHECK(out.faces.count > 0);
	CHECK(borders_agree(&mesh, &out));
	coplanar_release(&out);
}

static const struct check_test tests[] = {
	CHECK_TEST(squares_become_one_polygon_that_keeps_every_border_vertex),
	CHECK_TEST(holes_are_rings_of_their_own_and_run_the_other_way),
	CHECK_TEST(rings_that_meet_in_a_point_are_cut_there),
	CHECK_TEST(what_only_shares_a_point_is_apart),
	CHECK_TEST(faces_stand_in_the_order_of_their_first_triangles),
	CHECK_TEST(a_bend_within_a_millimetre_is_flat),
	CHECK_TEST(what_bends_slowly_is_cut_into_flat_pieces),
	CHECK_TEST(the_two_sides_of_a_sheet_stay_two),
	CHECK_TEST(an_edge_of_three_triangles_is_a_border),
	CHECK_TEST(a_thin_triangle_goes_along),
	CHECK_TEST(a_low_step_is_no_part_of_the_floor),
	CHECK_TEST(a_triangle_without_three_positions_vanishes),
	CHECK_TEST(a_seam_is_a_border),
	CHECK_TEST(units_and_places_make_no_difference),
	CHECK_TEST(any_drawing_keeps_its_border_and_its_area),
	CHECK_TEST(numbers_beyond_all_measure_do_no_harm),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
