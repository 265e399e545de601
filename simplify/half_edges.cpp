#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <map>
#include <new>
#include <utility>
#include <vector>

/* The kernel's accessors assert; here they are inlined without. */
#ifndef NDEBUG
#define NDEBUG
#endif
#include <OpenMesh/Core/Mesh/ArrayKernel.hh>

#include "half_edges.h"

namespace
{

using Face = OpenMesh::FaceHandle;
using Half = OpenMesh::HalfedgeHandle;
using Vertex = OpenMesh::VertexHandle;

constexpr std::size_t max_faces = std::size_t{1} << 29;

template <typename Handle>
Handle
handle(std::size_t number)
{
	return Handle(static_cast<int>(number));
}

template <typename Handle>
std::uint32_t
number(Handle of)
{
	return of.is_valid() ? static_cast<std::uint32_t>(of.idx())
			     : HALF_EDGE_NONE;
}

using Ends = std::pair<std::uint32_t, std::uint32_t>; /* from, to */

/* Half-edges by their ends, and pairs of them that are free. */
struct refilling {
	std::map<Ends, Half> halves;
	std::vector<Half> free;
	std::vector<Vertex> vertices; /* of the faces */
};

} // namespace

struct half_edges {
	OpenMesh::ArrayKernel kernel;
	std::vector<std::uint32_t> triples; /* three vertices per face, from
	                                       where its half-edge begins */
	std::vector<std::uint32_t> marks; /* of vertices */
	std::uint32_t mark = 0;

	Half opposite(Half half) const
	{
		return handle<Half>(static_cast<std::size_t>(half.idx()) ^ 1);
	}

	Half next(Half half) const
	{
		return kernel.next_halfedge_handle(half);
	}

	Half previous(Half half) const
	{
		return kernel.prev_halfedge_handle(half);
	}

	Vertex head(Half half) const
	{
		return kernel.to_vertex_handle(half);
	}

	Face face(Half half) const
	{
		return kernel.face_handle(half);
	}

	bool is_open(Half half) const
	{
		return !face(half).is_valid();
	}

	/* The next outgoing half-edge counterclockwise. */
	Half turn(Half half) const
	{
		return opposite(previous(half));
	}

	/* Where a walk around the vertex begins, see half_edges_spokes. */
	Half first(Vertex vertex) const
	{
		Half half = kernel.halfedge_handle(vertex);

		return half.is_valid() && is_open(half) ? turn(half) : half;
	}

	/* The face is gone. */
	void forget(Face face)
	{
		kernel.set_halfedge_handle(face, Half());
		*corners(face) = HALF_EDGE_NONE;
	}

	std::uint32_t *corners(Face face)
	{
		return triples.data() +
			3 * static_cast<std::size_t>(face.idx());
	}

	template <typename Visit> void around(Vertex vertex, Visit visit) const
	{
		Half begin = first(vertex);
		Half half = begin;

		if (!begin.is_valid())
			return;
		do {
			visit(half);
			half = turn(half);
		} while (half != begin);
	}

	std::vector<Half> link_corners(const std::uint32_t *corners,
		const std::uint32_t *opposites, std::size_t face_count);
	void link_open(const std::vector<Half> &open);
	half_edges(const std::uint32_t *corners, const std::uint32_t *opposites,
		std::size_t face_count, std::size_t vertex_count);
	void settle(Vertex vertex, Half outgoing);
	void change_corner(Face face, Vertex from, Vertex to);
	void begin_at(Face face, Half half);
	void list_refilling(refilling &fill, const std::uint32_t *faces,
		std::size_t face_count) const;
	void give_halves(refilling &fill, const std::uint32_t *corners,
		std::size_t count);
	void link_refilling(const refilling &fill, const std::uint32_t *numbers,
		const std::uint32_t *corners, std::size_t count);
	bool drops_cleanly(Half half) const;
	std::uint32_t drop(Half half);
};

/* ---- building ------------------------------------------------------------ */

/* Edges in the order of their first corners; the half-edge of that corner is
   the even one. Returns the half-edges without a face. */
std::vector<Half>
half_edges::link_corners(const std::uint32_t *corners,
	const std::uint32_t *opposites, std::size_t face_count)
{
	std::vector<std::uint32_t> halves(3 * face_count);
	std::vector<Half> open;
	std::size_t edges = 0;

	for (std::size_t c = 0; c < 3 * face_count; c++) {
		if (opposites[c] == HALF_EDGE_NONE)
			open.push_back(handle<Half>(2 * edges + 1));
		if (opposites[c] == HALF_EDGE_NONE || opposites[c] > c)
			halves[c] = static_cast<std::uint32_t>(2 * edges++);
		else
			halves[c] = halves[opposites[c]] + 1;
	}
	kernel.resize(marks.size(), edges, face_count);
	for (std::size_t c = 0; c < 3 * face_count; c++) {
		std::size_t next_corner = c % 3 == 2 ? c - 2 : c + 1;
		Half half = handle<Half>(halves[c]);

		kernel.set_vertex_handle(
			half, handle<Vertex>(corners[next_corner]));
		kernel.set_next_halfedge_handle(
			half, handle<Half>(halves[next_corner]));
		kernel.set_face_handle(half, handle<Face>(c / 3));
		kernel.set_halfedge_handle(handle<Face>(c / 3), half);
		kernel.set_halfedge_handle(handle<Vertex>(corners[c]), half);
		triples[3 * (c / 3) + (c + 1) % 3] = corners[c];
	}
	return open;
}

/* A vertex has one of them outwards, or none. */
void
half_edges::link_open(const std::vector<Half> &open)
{
	for (Half half : open) {
		Half inner = opposite(half);

		kernel.set_vertex_handle(half, head(previous(inner)));
		kernel.set_halfedge_handle(head(inner), half);
	}
	for (Half half : open)
		kernel.set_next_halfedge_handle(
			half, kernel.halfedge_handle(head(half)));
}

half_edges::half_edges(const std::uint32_t *corners,
	const std::uint32_t *opposites, std::size_t face_count,
	std::size_t vertex_count)
    : triples(3 * face_count), marks(vertex_count)
{
	link_open(link_corners(corners, opposites, face_count));
}

enum tcs_status
half_edges_new(struct half_edges **out, const uint32_t *corners,
	const uint32_t *opposites, size_t face_count, size_t vertex_count,
	struct tcs_fault *fault) noexcept
{
	*out = nullptr;
	if (face_count > max_faces)
		return fault_set(fault, TCS_LIMIT, TCS_NOWHERE,
			"an object of more than 2^29 triangles");
	try {
		*out = new half_edges(
			corners, opposites, face_count, vertex_count);
	} catch (const std::exception &) {
		return fault_memory(fault);
	}
	return TCS_OK;
}

void
half_edges_free(struct half_edges *mesh) noexcept
{
	delete mesh;
}

/* ---- asking -------------------------------------------------------------- */

size_t
half_edges_spokes(const struct half_edges *mesh, uint32_t vertex,
	struct spoke *out, size_t room) noexcept
{
	std::size_t count = 0;

	mesh->around(handle<Vertex>(vertex), [&](Half half) {
		if (count < room)
			out[count] = {number(half), number(mesh->head(half)),
				number(mesh->face(half))};
		count++;
	});
	return count;
}

bool
half_edges_corners(const struct half_edges *mesh, uint32_t face,
	uint32_t corners[3]) noexcept
{
	const std::uint32_t *own =
		mesh->triples.data() + 3 * static_cast<std::size_t>(face);

	for (int k = 0; k < 3; k++)
		corners[k] = own[k];
	return own[0] != HALF_EDGE_NONE;
}

void
half_edges_across(const struct half_edges *mesh, uint32_t face,
	uint32_t faces[3]) noexcept
{
	Half half = mesh->kernel.halfedge_handle(handle<Face>(face));

	for (int k = 0; k < 3; k++, half = mesh->next(half))
		faces[k] = number(mesh->face(mesh->opposite(half)));
}

/* The face left of the half-edge may go: one of its other edges has a face
   behind it, and there is something left to hang on to. */
bool
half_edges::drops_cleanly(Half half) const
{
	return is_open(half) || !is_open(opposite(next(half))) ||
		!is_open(opposite(previous(half)));
}

bool
half_edges_may_collapse(struct half_edges *mesh, uint32_t half_edge) noexcept
{
	Half half = handle<Half>(half_edge), back = mesh->opposite(half);
	Vertex tail = mesh->head(back), head = mesh->head(half);
	bool inner = !mesh->is_open(half) && !mesh->is_open(back);
	std::size_t common = 0, tail_degree = 0, head_degree = 0;

	if (!mesh->drops_cleanly(half) || !mesh->drops_cleanly(back))
		return false;
	/* An inner edge between two open vertices would pinch the rim. */
	if (inner && mesh->is_open(mesh->kernel.halfedge_handle(tail)) &&
		mesh->is_open(mesh->kernel.halfedge_handle(head)))
		return false;
	mesh->mark++;
	mesh->around(tail, [&](Half spoke) {
		tail_degree++;
		mesh->marks[number(mesh->head(spoke))] = mesh->mark;
	});
	mesh->around(head, [&](Half spoke) {
		head_degree++;
		common += mesh->marks[number(mesh->head(spoke))] == mesh->mark;
	});
	if (common != (inner ? 2u : 1u))
		return false;
	/* A tetrahedron, or a triangle alone. */
	return !(inner && tail_degree == 3 && head_degree == 3);
}

/* ---- collapsing ---------------------------------------------------------- */

/* Let the vertex know an outgoing half-edge: the open one if it has any. */
void
half_edges::settle(Vertex vertex, Half outgoing)
{
	Half half = outgoing;

	do {
		if (is_open(half)) {
			outgoing = half;
			break;
		}
		half = turn(half);
	} while (half != outgoing);
	kernel.set_halfedge_handle(vertex, outgoing);
}

void
half_edges::change_corner(Face face, Vertex from, Vertex to)
{
	std::uint32_t *own = corners(face);

	for (int k = 0; k < 3; k++)
		if (own[k] == number(from))
			own[k] = number(to);
}

/* Let a face know one of its half-edges. */
void
half_edges::begin_at(Face face, Half half)
{
	std::uint32_t *own = corners(face);
	std::uint32_t tail = number(head(opposite(half)));

	kernel.set_halfedge_handle(face, half);
	while (own[0] != tail)
		std::rotate(own, own + 1, own + 3);
}

/*
 * Take the half-edge, whose ends are one by now, out of its loop. A triangle
 * goes with it: of its two other edges one takes the place of both.
 */
std::uint32_t
half_edges::drop(Half half)
{
	Half kept = next(half), lost = previous(half);
	Half outside = opposite(lost), back = opposite(kept);
	Vertex apex = head(kept);
	Face gone = face(half);

	if (!gone.is_valid()) {
		kernel.set_next_halfedge_handle(lost, kept);
		return HALF_EDGE_NONE;
	}
	kernel.set_face_handle(kept, face(outside));
	kernel.set_next_halfedge_handle(kept, next(outside));
	kernel.set_next_halfedge_handle(previous(outside), kept);
	if (face(outside).is_valid())
		begin_at(face(outside), kept);
	forget(gone);
	settle(apex, back);
	return number(gone);
}

size_t
half_edges_collapse(
	struct half_edges *mesh, uint32_t half_edge, uint32_t gone[2]) noexcept
{
	Half half = handle<Half>(half_edge), back = mesh->opposite(half);
	Vertex tail = mesh->head(back), head = mesh->head(half);
	/* It leaves the head, once that is all there is of the edge. */
	Half kept = mesh->next(mesh->is_open(half) ? back : half);
	std::size_t count = 0;
	std::uint32_t dropped;

	mesh->around(tail, [&](Half spoke) {
		mesh->kernel.set_vertex_handle(mesh->opposite(spoke), head);
		if (!mesh->is_open(spoke))
			mesh->change_corner(mesh->face(spoke), tail, head);
	});
	mesh->kernel.set_halfedge_handle(tail, Half());
	for (Half side : {half, back}) {
		dropped = mesh->drop(side);
		if (dropped != HALF_EDGE_NONE)
			gone[count++] = dropped;
	}
	mesh->settle(head, kept);
	return count;
}

void
half_edges_take_away(struct half_edges *mesh, uint32_t face) noexcept
{
	Face gone = handle<Face>(face);
	Half half = mesh->kernel.halfedge_handle(gone);

	if (!half.is_valid())
		return;
	for (int k = 0; k < 3; k++, half = mesh->next(half))
		mesh->kernel.set_halfedge_handle(mesh->head(half), Half());
	mesh->forget(gone);
}

/* ---- refilling ----------------------------------------------------------- */

/* What the faces leave: the half-edges of their rim, and those between them. */
void
half_edges::list_refilling(refilling &fill, const std::uint32_t *faces,
	std::size_t face_count) const
{
	std::map<std::uint32_t, bool> own, listed;

	for (std::size_t i = 0; i < face_count; i++)
		own[faces[i]] = true;
	for (std::size_t i = 0; i < face_count; i++) {
		Half half = kernel.halfedge_handle(handle<Face>(faces[i]));

		for (int k = 0; k < 3; k++, half = next(half)) {
			Half back = opposite(half);
			std::uint32_t tail = number(head(back));

			if (listed.insert({tail, true}).second)
				fill.vertices.push_back(head(back));
			if (!own.count(number(face(back))))
				fill.halves[{tail, number(head(half))}] = half;
			else if (half.idx() < back.idx())
				fill.free.push_back(half);
		}
	}
}

/* Give every edge of the triangles that is not on the rim a free pair, or a new
   one. */
void
half_edges::give_halves(
	refilling &fill, const std::uint32_t *corners, std::size_t count)
{
	std::size_t used = 0;

	for (std::size_t c = 0; c < 3 * count; c++) {
		Ends ends = {corners[c], corners[c % 3 == 2 ? c - 2 : c + 1]};

		if (fill.halves.count(ends))
			continue;
		Vertex to = handle<Vertex>(ends.second);
		Half half = used < fill.free.size() ? fill.free[used++]
						    : kernel.new_edge(to, to);

		fill.halves[ends] = half;
		fill.halves[{ends.second, ends.first}] =
			handle<Half>(static_cast<std::size_t>(half.idx()) ^ 1);
	}
}

void
half_edges::link_refilling(const refilling &fill, const std::uint32_t *numbers,
	const std::uint32_t *corners, std::size_t count)
{
	for (std::size_t i = 0; i < count; i++) {
		const std::uint32_t *own = corners + 3 * i;
		Half halves[3];

		for (std::size_t k = 0; k < 3; k++)
			halves[k] = fill.halves.at({own[k], own[(k + 1) % 3]});
		for (std::size_t k = 0; k < 3; k++) {
			kernel.set_vertex_handle(
				halves[k], handle<Vertex>(own[(k + 1) % 3]));
			kernel.set_next_halfedge_handle(
				halves[k], halves[(k + 1) % 3]);
			kernel.set_face_handle(
				halves[k], handle<Face>(numbers[i]));
		}
		kernel.set_halfedge_handle(handle<Face>(numbers[i]), halves[0]);
		std::copy(
			own, own + 3, this->corners(handle<Face>(numbers[i])));
	}
	for (std::size_t c = 0; c < 3 * count; c++) {
		Ends ends = {corners[c], corners[c % 3 == 2 ? c - 2 : c + 1]};

		settle(handle<Vertex>(corners[c]), fill.halves.at(ends));
	}
}

enum tcs_status
half_edges_refill(struct half_edges *mesh, const uint32_t *faces,
	size_t face_count, const uint32_t *numbers, const uint32_t *corners,
	size_t triangle_count, struct tcs_fault *fault) noexcept
{
	refilling fill;

	try {
		mesh->list_refilling(fill, faces, face_count);
		mesh->give_halves(fill, corners, triangle_count);
	} catch (const std::exception &) {
		return fault_memory(fault);
	}
	for (std::size_t i = 0; i < face_count; i++)
		mesh->forget(handle<Face>(faces[i]));
	for (Vertex vertex : fill.vertices)
		mesh->kernel.set_halfedge_handle(vertex, Half());
	mesh->link_refilling(fill, numbers, corners, triangle_count);
	return TCS_OK;
}
