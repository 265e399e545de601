#include "peer.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <new>
#include <vector>

namespace
{

typedef CGAL::Simple_cartesian<double> kernel;
typedef CGAL::Surface_mesh<kernel::Point_3> mesh_type;

kernel::Point_3
position(const tcs_point &point)
{
	return kernel::Point_3(point.x, point.y, point.z);
}

/* A triangle whose edges are taken already gets vertices of its own, as few as
   it takes. */
void
add_triangle(mesh_type &mesh, const peer_mesh &in, const tcs_triangle &triangle,
	std::vector<uint32_t> &components)
{
	mesh_type::Vertex_index own[3];

	if (triangle.corner[0] == triangle.corner[1] ||
		triangle.corner[1] == triangle.corner[2] ||
		triangle.corner[2] == triangle.corner[0])
		return;
	for (unsigned split : peer_splits) {
		for (unsigned i = 0; i < 3; i++)
			own[i] = split >> i & 1
				? mesh.add_vertex(position(
					  in.points[triangle.corner[i]]))
				: mesh_type::Vertex_index(triangle.corner[i]);
		components.resize(mesh.number_of_vertices(),
			in.components[triangle.corner[0]]);
		if (mesh.add_face(own[0], own[1], own[2]) !=
			mesh_type::null_face())
			return;
	}
}

/* The library's own stop by edges. */
struct stop_at_faces {
	size_t target;
	const mesh_type *mesh;

	template <typename FT, typename Profile>
	bool operator()(const FT &, const Profile &, size_t, size_t) const
	{
		return mesh->number_of_faces() <= target;
	}
};

void
simplify(const peer_mesh &in, size_t target, peer_mesh &out)
{
	mesh_type mesh;
	std::vector<uint32_t> components(
		in.components, in.components + in.point_count);

	for (size_t i = 0; i < in.point_count; i++)
		mesh.add_vertex(position(in.points[i]));
	for (size_t i = 0; i < in.triangle_count; i++)
		add_triangle(mesh, in, in.triangles[i], components);
	CGAL::Surface_mesh_simplification::edge_collapse(
		mesh, stop_at_faces{target, &mesh});
	out.point_count = 0;
	for (auto face : mesh.faces())
		for (auto vertex :
			vertices_around_face(mesh.halfedge(face), mesh)) {
			const kernel::Point_3 &at = mesh.point(vertex);
			size_t corner = out.point_count++;

			/* Three points for each triangle, welded later. */
			out.points[corner] = {at.x(), at.y(), at.z()};
			out.triangles[corner / 3].corner[corner % 3] =
				(uint32_t)corner;
			out.components[corner / 3] = components[vertex];
		}
	out.triangle_count = out.point_count / 3;
}

} // namespace

int
peer_cgal(const peer_mesh *in, size_t target, peer_mesh *out)
{
	try {
		simplify(*in, target, *out);
	} catch (const std::bad_alloc &) {
		return -1;
	}
	return 0;
}
