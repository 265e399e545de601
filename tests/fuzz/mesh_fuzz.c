/* The first byte chooses glTF or OBJ for the others: faces are in order, and
 * every corner is a point, within the limit, what is textured has an image. */
#include "parsers/mesh_file.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size);

static void
check_face(const struct mesh_file *mesh, const struct mesh_face *face)
{
	uint32_t image;

	if (face->corner_count < 3 ||
		(face->material != TCS_NONE &&
			face->material >= mesh->materials.count))
		abort();
	if (!face->textured)
		return;
	image = mesh->materials.at[face->material].image;
	if (image >= mesh->images.count)
		abort();
	for (uint32_t i = 0; i < face->corner_count; i++)
		if (!isfinite(mesh->texcoords.at[face->first_corner + i].s) ||
			!isfinite(mesh->texcoords.at[face->first_corner + i].t))
			abort();
}

static void
check_images(const struct mesh_file *mesh, uint64_t limit)
{
	if (mesh->bytes.count > limit)
		abort();
	for (size_t i = 0; i < mesh->images.count; i++) {
		const struct mesh_image *image = &mesh->images.at[i];

		if (image->uri >= mesh->names.count ||
			image->mime >= mesh->names.count ||
			image->first_byte > mesh->bytes.count ||
			image->byte_count >
				mesh->bytes.count - image->first_byte)
			abort();
	}
}

static void
check(const struct mesh_file *mesh, uint64_t limit)
{
	size_t corners = 0;

	if (mesh->points.count > limit || mesh->corners.count > limit)
		abort();
	for (size_t i = 0; i < mesh->faces.count; i++) {
		const struct mesh_face *face = &mesh->faces.at[i];

		if (face->first_corner != corners)
			abort();
		check_face(mesh, face);
		corners += face->corner_count;
	}
	if (corners > mesh->corners.count ||
		mesh->texcoords.count != mesh->corners.count)
		abort();
	check_images(mesh, limit);
	for (size_t i = 0; i < corners; i++)
		if (mesh->corners.at[i] >= mesh->points.count)
			abort();
}

/* What stands before a NUL is the OBJ's materials. */
static enum tcs_status
parse_obj(struct mesh_file *mesh, const struct mesh_source *source,
	struct mesh_bytes bytes, const char **problem, struct tcs_fault *fault)
{
	size_t length = strlen((const char *)bytes.at);
	struct mesh_bytes materials = {bytes.at, length};
	enum tcs_status status;

	if (length == bytes.count)
		return mesh_parse_obj(mesh, source, &bytes, problem, fault);
	status = mesh_parse_mtl(mesh, source, &materials, problem, fault);
	bytes.at += length + 1;
	bytes.count -= length + 1;
	return status || *problem
		? status
		: mesh_parse_obj(mesh, source, &bytes, problem, fault);
}

int
LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
	const struct mesh_source source = {NULL, "a/b", 65536};
	struct mesh_file mesh = {0};
	struct mesh_bytes copy = {.count = size ? size - 1 : 0};
	const char *problem;
	struct tcs_fault fault;
	enum tcs_status status;

	copy.at = calloc(copy.count + 1, 1);
	if (!size || !copy.at) {
		free(copy.at);
		return 0;
	}
	memcpy(copy.at, bytes + 1, copy.count);
	status = *bytes & 1
		? mesh_parse_gltf(&mesh, &source, &copy, &problem, &fault)
		: parse_obj(&mesh, &source, copy, &problem, &fault);
	if (status && status != TCS_NO_MEMORY)
		abort();
	if (!status && !problem)
		check(&mesh, source.limit);
	mesh_file_release(&mesh);
	free(copy.at);
	return 0;
}
