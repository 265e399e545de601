/* The first byte chooses glTF or OBJ for the others: faces are in order, and
 * every corner is a point, within the limit. */
#include "parsers/mesh_file.h"

#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size);

static void
check(const struct mesh_file *mesh, uint64_t limit)
{
	size_t corners = 0;

	if (mesh->points.count > limit || mesh->corners.count > limit)
		abort();
	for (size_t i = 0; i < mesh->faces.count; i++) {
		const struct mesh_face *face = &mesh->faces.at[i];

		if (face->first_corner != corners || face->corner_count < 3 ||
			(face->material != TCS_NONE &&
				face->material >= mesh->materials.count))
			abort();
		corners += face->corner_count;
	}
	if (corners > mesh->corners.count)
		abort();
	for (size_t i = 0; i < corners; i++)
		if (mesh->corners.at[i] >= mesh->points.count)
			abort();
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
		: mesh_parse_obj(&mesh, &source, &copy, &problem, &fault);
	if (status && status != TCS_NO_MEMORY)
		abort();
	if (!status && !problem)
		check(&mesh, source.limit);
	mesh_file_release(&mesh);
	free(copy.at);
	return 0;
}
