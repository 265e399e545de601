#include "simplify/half_edges.h"

#include <stdlib.h>
#include <string.h>

#include "check.h"

enum { MAX_FACES = 2048, MAX_VERTICES = 1200 };

struct mesh {
	uint32_t corners[3 * MAX_FACES], opposites[3 * MAX_FACES];
	size_t faces, vertices;
	struct half_edges *half_edges;
};

static uint32_t
head_of(const uint32_t *corners, size_t corner)
{
	return corners[corner % 3 == 2 ? corner - 2 : corner + 1];
}

/* Opposites by trying all pairs. */
static void
open_mesh(struct mesh *mesh)
{
	size_t count = 3 * mesh->faces;
	struct tcs_fault fault;

	for (size_t a = 0; a < count; a++)
		mesh->opposites[a] = HALF_EDGE_NONE;
	for (size_t a = 0; a < count; a++)
		for (size_t b = 0; b < count; b++)
			if (mesh->corners[a] == head_of(mesh->corners, b) &&
				mesh->corners[b] == head_of(mesh->corners, a))
				mesh->opposites[a] = (uint32_t)b;
	CHECK(!half_edges_new(&mesh->half_edges, mesh->corners, mesh->opposites,
		mesh->faces, mesh->vertices, &fault));
}

static void
add_face(struct mesh *mesh, size_t a, size_t b, size_t c)
{
	uint32_t *corner = mesh->corners + 3 * mesh->faces++;

	corner[0] = (uint32_t)a;
	corner[1] = (uint32_t)b;
	corner[2] = (uint32_t)c;
}

/* A sheet of n by m quads, its columns or both ways closed to a ring. */
static void
make_grid(struct mesh *mesh, size_t n, size_t m, bool ring, bool torus)
{
	size_t columns = ring ? n : n + 1, rows = torus ? m : m + 1;

	memset(mesh, 0, sizeof *mesh);
	mesh->vertices = columns * rows;
	for (size_t y = 0; y < m; y++)
		for (size_t x = 0; x < n; x++) {
			size_t right = (x + 1) % columns;
			size_t up = (y + 1) % rows;

			add_face(mesh, y * columns + x, y * columns + right,
				up * columns + right);
			add_face(mesh, y * columns + x, up * columns + right,
				up * columns + x);
		}
	open_mesh(mesh);
}

static void
close_mesh(struct mesh *mesh)
{
	half_edges_free(mesh->half_edges);
}

struct counts {
	long vertices, edges, faces, open;
};

/* Count what is left, and check that faces and spokes tell the same. */
static struct counts
count(const struct mesh *mesh)
{
	struct counts counts = {0, 0, 0, 0};
	long spokes = 0, gaps = 0, corners = 0;

	for (size_t v = 0; v < mesh->vertices; v++) {
		struct spoke spoke[256];
		size_t degree = half_edges_spokes(
			mesh->half_edges, (uint32_t)v, spoke, 256);

		CHECK(degree <= 256);
		counts.vertices += degree > 0;
		spokes += (long)degree;
		for (size_t i = 0; i < degree; i++) {
			uint32_t c[3], next = spoke[(i + 1) % degree].to;
			bool found = false;

			CHECK(spoke[i].to != v);
			if (spoke[i].face == HALF_EDGE_NONE) {
				CHECK(i == degree - 1);
				gaps++;
				continue;
			}
			CHECK(half_edges_corners(
				mesh->half_edges, spoke[i].face, c));
			for (int k = 0; k < 3; k++)
				found |= c[k] == v &&
					c[(k + 1) % 3] == spoke[i].to &&
					c[(k + 2) % 3] == next;
			CHECK(found);
			corners++;
		}
	}
	for (size_t f = 0; f < mesh->faces; f++) {
		uint32_t c[3];

		counts.faces +=
			half_edges_corners(mesh->half_edges, (uint32_t)f, c);
	}
	CHECK(corners == 3 * counts.faces);
	CHECK(spokes % 2 == 0);
	counts.edges = spokes / 2;
	counts.open = gaps;
	return counts;
}

static uint32_t random_state = 1;

static uint32_t
random_below(size_t bound)
{
	random_state = random_state * 1664525u + 1013904223u;
	return (uint32_t)((random_state >> 8) % bound);
}

/* Collapse at random until nothing may be; the shape of the whole stays. */
static struct counts
collapse_all(struct mesh *mesh)
{
	struct counts before = count(mesh), now = before;
	long shape = before.vertices - before.edges + before.faces;
	int refused = 0;

	while (refused < 4000) {
		struct spoke spoke[256];
		size_t degree = half_edges_spokes(mesh->half_edges,
			random_below(mesh->vertices), spoke, 256);
		uint32_t half_edge, gone[2], corners[3];
		size_t faces;

		refused++;
		if (!degree)
			continue;
		half_edge = spoke[random_below(degree)].half_edge;
		if (!half_edges_may_collapse(mesh->half_edges, half_edge))
			continue;
		faces = half_edges_collapse(mesh->half_edges, half_edge, gone);
		CHECK(faces == 1 || faces == 2);
		for (size_t i = 0; i < faces; i++)
			CHECK(!half_edges_corners(
				mesh->half_edges, gone[i], corners));
		now = count(mesh);
		CHECK(now.faces == before.faces - (long)faces);
		CHECK(now.vertices == before.vertices - 1);
		CHECK(now.vertices - now.edges + now.faces == shape);
		before = now;
		refused = 0;
	}
	return now;
}

static void
a_vertex_has_its_spokes_counterclockwise(void)
{
	struct mesh mesh;
	struct spoke spoke[8];

	make_grid(&mesh, 2, 2, false, false);
	CHECK(half_edges_spokes(mesh.half_edges, 4, spoke, 8) == 6);
	CHECK(half_edges_spokes(mesh.half_edges, 0, spoke, 8) == 3);
	CHECK(spoke[0].to == 1 && spoke[1].to == 4 && spoke[2].to == 3);
	CHECK(spoke[0].face == 0 && spoke[1].face == 1);
	CHECK(spoke[2].face == HALF_EDGE_NONE);
	/* Too little room: told, and nothing written behind. */
	CHECK(half_edges_spokes(mesh.half_edges, 4, spoke, 1) == 6);
	CHECK(spoke[1].to == 4);
	close_mesh(&mesh);
}

static void
a_sheet_falls_to_one_triangle(void)
{
	struct mesh mesh;
	struct counts left;

	make_grid(&mesh, 12, 9, false, false);
	left = collapse_all(&mesh);
	CHECK(left.faces == 1 && left.open == 3);
	close_mesh(&mesh);
}

static void
an_open_tube_stays_a_tube(void)
{
	struct mesh mesh;
	struct counts left;

	make_grid(&mesh, 9, 12, true, false);
	left = collapse_all(&mesh);
	CHECK(left.open == 6 && left.faces >= 6);
	close_mesh(&mesh);
}

static void
a_torus_stays_a_torus(void)
{
	struct mesh mesh;
	struct counts left;

	make_grid(&mesh, 14, 11, true, true);
	left = collapse_all(&mesh);
	CHECK(left.open == 0 && left.faces >= 14);
	CHECK(left.vertices - left.edges + left.faces == 0);
	close_mesh(&mesh);
}

/* An octahedron, each side of its upper half a fan. */
static void
a_sphere_falls_to_a_tetrahedron(void)
{
	struct mesh mesh;
	struct counts left;

	memset(&mesh, 0, sizeof mesh);
	mesh.vertices = 42;
	for (size_t i = 0; i < 40; i++) {
		add_face(&mesh, i, (i + 1) % 40, 40);
		add_face(&mesh, (i + 1) % 40, i, 41);
	}
	open_mesh(&mesh);
	left = collapse_all(&mesh);
	CHECK(left.faces == 4 && left.vertices == 4 && left.open == 0);
	close_mesh(&mesh);
}

static void
two_triangles_back_to_back_stay(void)
{
	struct mesh mesh;
	struct spoke spoke[4];

	memset(&mesh, 0, sizeof mesh);
	mesh.vertices = 3;
	add_face(&mesh, 0, 1, 2);
	add_face(&mesh, 0, 2, 1);
	open_mesh(&mesh);
	CHECK(half_edges_spokes(mesh.half_edges, 0, spoke, 4) == 2);
	CHECK(!half_edges_may_collapse(mesh.half_edges, spoke[0].half_edge));
	CHECK(!half_edges_may_collapse(mesh.half_edges, spoke[1].half_edge));
	close_mesh(&mesh);
}

/* A band goes all around the tube of a torus, and fans close it: a sphere. */
static void
a_torus_cut_and_closed_is_a_sphere(void)
{
	enum { AROUND = 14, TUBE = 11, CAP = TUBE - 2 };

	struct mesh mesh;
	struct counts left;
	uint32_t faces[2 * TUBE], corners[2 * CAP * 3], c[3], across[3];
	uint32_t *next = corners;
	struct tcs_fault fault;

	make_grid(&mesh, AROUND, TUBE, true, true);
	/* Column 0: its left rim goes up, the right one down. */
	for (uint32_t y = 0; y < TUBE; y++) {
		faces[2 * y] = 2 * AROUND * y;
		faces[2 * y + 1] = 2 * AROUND * y + 1;
	}
	for (uint32_t i = 1; i <= CAP; i++) {
		*next++ = 0;
		*next++ = AROUND * (i + 1);
		*next++ = AROUND * i;
		*next++ = 1;
		*next++ = AROUND * i + 1;
		*next++ = AROUND * (i + 1) + 1;
	}
	CHECK(!half_edges_refill(mesh.half_edges, faces, 2 * (size_t)TUBE,
		faces, corners, 2 * (size_t)CAP, &fault));
	left = count(&mesh);
	CHECK(left.open == 0);
	CHECK(left.faces == (AROUND - 1) * TUBE * 2 + 2 * CAP);
	CHECK(left.vertices - left.edges + left.faces == 2);
	CHECK(!half_edges_corners(mesh.half_edges, faces[2 * CAP], c));
	CHECK(half_edges_corners(mesh.half_edges, faces[0], c));
	half_edges_across(mesh.half_edges, faces[0], across);
	for (int k = 0; k < 3; k++)
		CHECK(across[k] != HALF_EDGE_NONE && across[k] != faces[0]);
	left = collapse_all(&mesh);
	CHECK(left.faces == 4 && left.vertices == 4);
	close_mesh(&mesh);
}

/* Two tetrahedra make way for one, which has faces and vertices of the second,
   some of which are gone already. */
static void
what_is_gone_comes_back(void)
{
	static const uint32_t sides[4][3] = {
		{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
	static const uint32_t left[] = {0, 1, 2, 3, 4, 5, 6, 7};
	static const uint32_t numbers[] = {8, 9, 10, 11};
	struct mesh mesh = {.vertices = 12};
	struct counts counts;
	uint32_t corners[12];
	struct tcs_fault fault;

	for (uint32_t i = 0; i < 12; i++)
		add_face(&mesh, sides[i % 4][0] + i / 4 * 4,
			sides[i % 4][1] + i / 4 * 4,
			sides[i % 4][2] + i / 4 * 4);
	open_mesh(&mesh);
	for (uint32_t i = 8; i < 12; i++)
		half_edges_take_away(mesh.half_edges, i);
	for (uint32_t i = 0; i < 12; i++)
		corners[i] = 8 + sides[i / 3][i % 3];
	CHECK(!half_edges_refill(
		mesh.half_edges, left, 8, numbers, corners, 4, &fault));
	counts = count(&mesh);
	CHECK(counts.faces == 4 && counts.vertices == 4 && counts.edges == 6);
	CHECK(counts.open == 0);
	CHECK(half_edges_corners(mesh.half_edges, 8, corners));
	CHECK(!half_edges_corners(mesh.half_edges, 0, corners));
	close_mesh(&mesh);
}

/* A tetrahedron makes way for an octahedron, for which it has too few edges. */
static void
there_may_be_more_than_before(void)
{
	static const uint32_t sides[8][3] = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4},
		{0, 4, 1}, {5, 2, 1}, {5, 3, 2}, {5, 4, 3}, {5, 1, 4}};
	static const uint32_t pyramid[4][3] = {
		{6, 8, 7}, {6, 7, 9}, {7, 8, 9}, {8, 6, 9}};
	static const uint32_t left[] = {8, 9, 10, 11};
	static const uint32_t numbers[] = {0, 1, 2, 3, 4, 5, 6, 7};
	struct mesh mesh = {.vertices = 10};
	struct counts counts;
	uint32_t corners[24];
	struct tcs_fault fault;

	for (uint32_t i = 0; i < 8; i++)
		add_face(&mesh, sides[i][0], sides[i][1], sides[i][2]);
	for (uint32_t i = 0; i < 4; i++)
		add_face(&mesh, pyramid[i][0], pyramid[i][1], pyramid[i][2]);
	open_mesh(&mesh);
	for (uint32_t i = 0; i < 8; i++)
		half_edges_take_away(mesh.half_edges, i);
	for (uint32_t i = 0; i < 24; i++)
		corners[i] = sides[i / 3][i % 3];
	CHECK(!half_edges_refill(
		mesh.half_edges, left, 4, numbers, corners, 8, &fault));
	counts = count(&mesh);
	CHECK(counts.faces == 8 && counts.vertices == 6 && counts.edges == 12);
	CHECK(counts.open == 0);
	close_mesh(&mesh);
}

static const struct check_test tests[] = {
	CHECK_TEST(a_vertex_has_its_spokes_counterclockwise),
	CHECK_TEST(a_sheet_falls_to_one_triangle),
	CHECK_TEST(an_open_tube_stays_a_tube),
	CHECK_TEST(a_torus_stays_a_torus),
	CHECK_TEST(a_sphere_falls_to_a_tetrahedron),
	CHECK_TEST(two_triangles_back_to_back_stay),
	CHECK_TEST(a_torus_cut_and_closed_is_a_sphere),
	CHECK_TEST(what_is_gone_comes_back),
	CHECK_TEST(there_may_be_more_than_before),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
