#include "gltf_shared.h"

#include <stdlib.h>
#include <string.h>

#include "gltf_numbers.h"
#include "gltf_placement.h"

struct shared_key {
	uint32_t prototype;
	uint32_t class;
};

static uint32_t
find(const struct city *city, const struct mesh_instance *of)
{
	const struct shared_key key = {of->prototype, of->class};

	return byte_index_find(&city->shared.keys, &key, sizeof key);
}

bool
shared_is_there(const struct city *city, const struct mesh_instance *of)
{
	return find(city, of) != INDEX_NONE;
}

uint32_t
shared_mesh(const struct city *city, const struct mesh_instance *of)
{
	return city->shared.all.at[find(city, of)].mesh;
}

enum tcs_status
shared_add(struct city *city, const struct mesh_instance *of, const char *name,
	struct mesh *mesh, struct report *report, struct tcs_fault *fault)
{
	const struct shared_key key = {of->prototype, of->class};
	struct assembly_mesh made = {.primitives = NULL};
	struct shared_mesh shared = {.mesh = TCS_NONE};
	enum tcs_status status = TCS_OK;
	uint32_t number;
	bool added;

	if (mesh->features.count) {
		status = city_add_mesh(city, mesh, &made, report, fault);
		if (!status)
			status = assembly_add_mesh(city->assembly, name, &made,
				&shared.mesh, fault);
	}
	if (!status)
		status = byte_index_add(&city->shared.keys, &key, sizeof key,
			&number, &added, fault);
	if (status)
		return status;
	shared.name = strdup(name);
	if (!shared.name || array_grow(&city->shared.all, 1)) {
		free(shared.name);
		return fault_memory(fault);
	}
	city->shared.all.at[city->shared.all.count++] = shared;
	return TCS_OK;
}

enum tcs_status
shared_stand(struct city *city, const struct mesh *mesh, uint32_t object_row,
	uint32_t base, struct tcs_fault *fault)
{
	for (size_t i = 0; i < mesh->instances.count; i++) {
		const struct mesh_instance *from = mesh->instances.at + i;
		struct shared_mesh *of = city->shared.all.at + find(city, from);
		struct shared_stand to = {
			.rows = {object_row, base + from->feature}};

		memcpy(to.matrix, from->matrix, sizeof to.matrix);
		if (of->mesh == TCS_NONE)
			continue;
		if (array_grow(&of->stands, 1))
			return fault_memory(fault);
		of->stands.at[of->stands.count++] = to;
	}
	return TCS_OK;
}

/* ---- the end --------------------------------------------------------- */

static enum tcs_status
add_translations(struct city *city, const struct shared_mesh *of,
	struct assembly_instances *out, struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;
	size_t count = of->stands.count;
	float *rooms = malloc(count * 10 * sizeof *rooms);

	if (!rooms)
		return fault_memory(fault);
	for (size_t i = 0; i < count; i++) {
		struct placement at = placement_split(of->stands.at[i].matrix);

		memcpy(rooms + 3 * i, at.translation, sizeof at.translation);
		memcpy(rooms + 3 * (count + i), at.scale, sizeof at.scale);
		memcpy(rooms + 6 * count + 4 * i, at.rotation,
			sizeof at.rotation);
	}
	status = city_add_floats(city, CITY_POSITIONS, rooms, 3 * count, 3,
		&out->translations, fault);
	if (!status)
		status = city_add_floats(city, CITY_POSITIONS,
			rooms + 3 * count, 3 * count, 3, &out->scales, fault);
	if (!status)
		status =
			city_add_floats(city, CITY_ROTATIONS, rooms + 6 * count,
				4 * count, 4, &out->rotations, fault);
	free(rooms);
	return status;
}

static int
compare_rows(const void *left, const void *right)
{
	const uint32_t *a = left, *b = right;

	return *a < *b ? -1 : *a > *b;
}

static enum tcs_status
add_rows(struct city *city, const struct shared_mesh *of, int set,
	struct assembly_instances *out, struct tcs_fault *fault)
{
	size_t count = of->stands.count;
	uint32_t *rows = malloc(count * sizeof *rows);
	enum tcs_status status;

	if (!rows)
		return fault_memory(fault);
	for (size_t i = 0; i < count; i++)
		rows[i] = of->stands.at[i].rows[set];
	status = city_add_ids(city, rows, count, 0,
		city->tables[set].row_count - 1, out->sets + set, fault);
	qsort(rows, count, sizeof *rows, compare_rows);
	for (size_t i = 0; i < count; i++)
		out->feature_counts[set] += !i || rows[i - 1] != rows[i];
	free(rows);
	return status;
}

enum tcs_status
shared_finish(struct city *city, struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	for (size_t i = 0; i < city->shared.all.count && !status; i++) {
		const struct shared_mesh *of = city->shared.all.at + i;
		struct assembly_instances all = {.mesh = of->mesh};

		if (!of->stands.count)
			continue;
		status = add_translations(city, of, &all, fault);
		for (int set = 0; set < ASSEMBLY_SETS && !status; set++)
			status = add_rows(city, of, set, &all, fault);
		if (!status)
			status = assembly_add_instances(
				city->assembly, of->name, &all, fault);
	}
	return status;
}

void
shared_release(struct shared_meshes *shared)
{
	for (size_t i = 0; i < shared->all.count; i++) {
		free(shared->all.at[i].name);
		array_release(&shared->all.at[i].stands);
	}
	array_release(&shared->all);
	byte_index_release(&shared->keys);
}
