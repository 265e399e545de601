#include "peer.h"

/* What gcc 12 says of a default value within OpenMesh's properties. */
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <new>
#include <vector>

namespace
{

struct traits : OpenMesh::DefaultTraits {
	VertexAttributes(OpenMesh::Attributes::Status);
	typedef OpenMesh::Vec3d Point;
	typedef OpenMesh::Vec3d Normal;
};
typedef OpenMesh::TriMesh_ArrayKernelT<traits> mesh_type;
typedef OpenMesh::Decimater::DecimaterT<mesh_type> decimater_type;

OpenMesh::Vec3d
position(const tcs_point &point)
{
	return OpenMesh::Vec3d(point.x, point.y, point.z);
}

/* A triangle whose edges are taken already gets vertices of its own, as few as
   it takes. */
void
add_triangle(mesh_type &mesh, const peer_mesh &in, const tcs_triangle &triangle,
	std::vector<uint32_t> &components)
{
	std::vector<mesh_type::VertexHandle> own(3);

	if (triangle.corner[0] == triangle.corner[1] ||
		triangle.corner[1] == triangle.corner[2] ||
		triangle.corner[2] == triangle.corner[0])
		return;
	for (unsigned split : peer_splits) {
		for (unsigned i = 0; i < 3; i++)
			own[i] = split >> i & 1
				? mesh.add_vertex(position(
					  in.points[triangle.corner[i]]))
				: mesh.vertex_handle(triangle.corner[i]);
		components.resize(
			mesh.n_vertices(), in.components[triangle.corner[0]]);
		if (mesh.add_face(own).is_valid())
			return;
	}
}

void
simplify(const peer_mesh &in, size_t target, peer_mesh &out)
{
	mesh_type mesh;
	decimater_type decimater(mesh);
	OpenMesh::Decimater::ModQuadricT<mesh_type>::Handle quadric;
	std::vector<uint32_t> components(
		in.components, in.components + in.point_count);

	for (size_t i = 0; i < in.point_count; i++)
		mesh.add_vertex(position(in.points[i]));
	omerr().disable(); /* it names every complex edge */
	for (size_t i = 0; i < in.triangle_count; i++)
		add_triangle(mesh, in, in.triangles[i], components);
	/* Its quadrics do not hold an open rim: pieces that are no solids would
	   shrink to nothing at no cost. */
	for (auto vertex : mesh.vertices())
		if (mesh.is_boundary(vertex))
			mesh.status(vertex).set_locked(true);
	decimater.add(quadric);
	decimater.module(quadric).unset_max_err();
	decimater.initialize();
	decimater.decimate_to_faces(0, target);
	out.triangle_count = out.point_count = 0;
	for (auto face : mesh.faces())
		for (auto vertex : mesh.fv_range(face)) {
			auto at = mesh.point(vertex);
			size_t corner = out.point_count++;

			/* Three points for each triangle, welded later. */
			out.points[corner] = {at[0], at[1], at[2]};
			out.triangles[corner / 3].corner[corner % 3] =
				(uint32_t)corner;
			out.components[corner / 3] =
				components[(size_t)vertex.idx()];
		}
	out.triangle_count = out.point_count / 3;
}

} // namespace

int
peer_openmesh(const peer_mesh *in, size_t target, peer_mesh *out)
{
	try {
		simplify(*in, target, *out);
	} catch (const std::bad_alloc &) {
		return -1;
	}
	return 0;
}
