#include "gltf_file.h"

#include <stdlib.h>

#include "gltf_name.h"
#include "program.h"

enum tcs_status
file_open(struct gltf_file *file, const char *name, struct output *json,
	struct output *bin, struct tcs_fault *fault)
{
	enum tcs_status status = output_open(json, name, fault);

	*file = (struct gltf_file){.json = json, .bin = bin};
	if (status || !bin)
		return status;
	if (!json->temporary)
		return fault_set(fault, TCS_SYSTEM, TCS_NOWHERE,
			"cannot write %s: a .gltf needs a regular file",
			json->name);
	file->bin_name = name_of_bin(name);
	if (!file->bin_name)
		return fault_memory(fault);
	file->bin_uri = name_as_uri(file->bin_name);
	if (!file->bin_uri)
		return fault_memory(fault);
	return output_open(bin, file->bin_name, fault);
}

const char *
file_beside(const struct gltf_file *file)
{
	return file->json->temporary;
}

/* z up becomes y up: (x, y, z) to (x, z, -y). */
static void
make_matrix(struct assembly_root *root, const struct tcs_crs *crs)
{
	double *m = root->matrix;
	double scale = crs->metres_per_unit;

	m[0] = 1;
	m[6] = -1;
	m[9] = 1;
	m[15] = 1;
	if (!root->origin_is_translation)
		return;
	m[12] = root->origin[0] * scale;
	m[13] = root->origin[2] * crs->metres_per_unit_up;
	m[14] = -root->origin[1] * scale;
}

static enum tcs_status
make_root(struct assembly_root *root, const struct stream_head *head,
	bool translate, struct tcs_fault *fault)
{
	const struct tcs_crs *crs = head->head.crs.at;
	const char *name = "";

	if (translate &&
		(crs->kind == TCS_CRS_GEOGRAPHIC ||
			crs->kind == TCS_CRS_GEOCENTRIC))
		return fault_set(fault, TCS_BAD_INPUT, TCS_NOWHERE,
			"--origin translation needs projected coordinates, "
			"and these are %s",
			crs->kind == TCS_CRS_GEOGRAPHIC ? "geographic"
							: "geocentric");
	if (head->head.sources.count)
		name = head_text(&head->head, head->head.sources.at->name);
	*root = (struct assembly_root){
		.generator = "tessera tcs2gltf " TESSERA_VERSION,
		.name = *name ? name : "city",
		.origin = {head->origin.x, head->origin.y, head->origin.z},
		.origin_is_translation = translate,
		.crs = head_text(&head->head, crs->name),
		.epsg = crs->epsg,
		.epsg_up = crs->epsg_up,
	};
	make_matrix(root, crs);
	return TCS_OK;
}

enum tcs_status
file_write(struct gltf_file *file, struct city *city,
	const struct stream_head *head, bool translate, struct tcs_fault *fault)
{
	struct assembly_root root;
	uint64_t json_size;
	enum tcs_status status = make_root(&root, head, translate, fault);

	if (status)
		return status;
	root.buffer_uri = file->bin_uri;
	status = city_finish(city, &root, &json_size, fault);
	if (status)
		return status;
	if (file->bin)
		return city_write_pair(city, file->json, file->bin, fault);
	return city_write_glb(
		city, json_size, root.buffer_size, file->json, fault);
}

void
file_release(struct gltf_file *file)
{
	free(file->bin_name);
	free(file->bin_uri);
	file->bin_name = file->bin_uri = NULL;
}
