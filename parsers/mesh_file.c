#include "mesh_file.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>

static const char too_large[] = "larger than --max-library";

void
mesh_file_release(struct mesh_file *mesh)
{
	array_release(&mesh->points);
	array_release(&mesh->corners);
	array_release(&mesh->texcoords);
	array_release(&mesh->faces);
	array_release(&mesh->materials);
	array_release(&mesh->images);
	array_release(&mesh->names);
	array_release(&mesh->bytes);
}

/* ---- building ---------------------------------------------------------------- */

enum tcs_status
mesh_add_point(struct mesh_file *mesh, const struct mesh_source *source,
	const struct tcs_point *point, const char **problem,
	struct tcs_fault *fault)
{
	if (!isfinite(point->x) || !isfinite(point->y) || !isfinite(point->z))
		*problem = "a coordinate is no finite number";
	else if (mesh->points.count >= source->limit / sizeof *point)
		*problem = too_large;
	if (*problem)
		return TCS_OK;
	if (array_grow(&mesh->points, 1))
		return fault_memory(fault);
	mesh->points.at[mesh->points.count++] = *point;
	return TCS_OK;
}

enum tcs_status
mesh_add_corner(struct mesh_file *mesh, const struct mesh_source *source,
	uint32_t point, const struct tcs_texcoord *texcoord,
	const char **problem, struct tcs_fault *fault)
{
	static const struct tcs_texcoord none = {(double)NAN, (double)NAN};

	if (point >= mesh->points.count)
		*problem = "a face names a point that is not there";
	else if (mesh->corners.count >= source->limit / sizeof point / 4)
		*problem = too_large;
	if (*problem)
		return TCS_OK;
	if (array_grow(&mesh->corners, 1) || array_grow(&mesh->texcoords, 1))
		return fault_memory(fault);
	mesh->corners.at[mesh->corners.count++] = point;
	mesh->texcoords.at[mesh->texcoords.count++] =
		texcoord ? *texcoord : none;
	return TCS_OK;
}

static bool
has_texcoords(const struct mesh_file *mesh, uint32_t count)
{
	const struct tcs_texcoord *end =
		mesh->texcoords.at + mesh->texcoords.count;

	for (const struct tcs_texcoord *at = end - count; at < end; at++)
		if (!isfinite(at->s) || !isfinite(at->t))
			return false;
	return true;
}

enum tcs_status
mesh_add_face(struct mesh_file *mesh, uint32_t count, uint32_t material,
	struct tcs_fault *fault)
{
	bool textured = material != TCS_NONE &&
		mesh->materials.at[material].image != TCS_NONE &&
		has_texcoords(mesh, count);

	if (array_grow(&mesh->faces, 1))
		return fault_memory(fault);
	mesh->faces.at[mesh->faces.count++] =
		(struct mesh_face){(uint32_t)mesh->corners.count - count, count,
			material, textured};
	return TCS_OK;
}

static enum tcs_status
name_add(struct mesh_file *mesh, const char *name, size_t length, size_t *out,
	struct tcs_fault *fault)
{
	if (array_grow(&mesh->names, length + 1))
		return fault_memory(fault);
	*out = mesh->names.count;
	if (length)
		memcpy(mesh->names.at + mesh->names.count, name, length);
	mesh->names.at[mesh->names.count + length] = 0;
	mesh->names.count += length + 1;
	return TCS_OK;
}

enum tcs_status
mesh_add_material(struct mesh_file *mesh, const char *name, size_t length,
	struct mesh_material **out, struct tcs_fault *fault)
{
	if (array_grow(&mesh->materials, 1))
		return fault_memory(fault);
	*out = &mesh->materials.at[mesh->materials.count++];
	**out = (struct mesh_material){
		.diffuse = {0.8f, 0.8f, 0.8f}, .image = TCS_NONE};
	return name_add(mesh, name, length, &(*out)->name, fault);
}

enum tcs_status
mesh_add_image(struct mesh_file *mesh, const struct mesh_source *source,
	const char *uri, const char *mime, uint32_t wrap,
	const struct mesh_bytes *bytes, uint32_t *out, const char **problem,
	struct tcs_fault *fault)
{
	size_t count = bytes ? bytes->count : 0;
	struct mesh_image *image;
	enum tcs_status status;

	if (count > source->limit - mesh->bytes.count)
		*problem = too_large;
	if (*problem)
		return TCS_OK;
	if (array_grow(&mesh->images, 1) || array_grow(&mesh->bytes, count))
		return fault_memory(fault);
	*out = (uint32_t)mesh->images.count;
	image = &mesh->images.at[mesh->images.count++];
	*image = (struct mesh_image){.wrap = wrap,
		.first_byte = mesh->bytes.count,
		.byte_count = count};
	if (count)
		memcpy(mesh->bytes.at + mesh->bytes.count, bytes->at, count);
	mesh->bytes.count += count;
	status = name_add(mesh, uri, strlen(uri), &image->uri, fault);
	if (!status)
		status =
			name_add(mesh, mime, strlen(mime), &image->mime, fault);
	return status;
}

static int
compare_faces(const void *a, const void *b)
{
	const struct mesh_face *one = a, *two = b;

	if (one->material != two->material)
		return one->material < two->material ? -1 : 1;
	if (one->textured != two->textured)
		return two->textured ? -1 : 1;
	return one->first_corner < two->first_corner ? -1 : 1;
}

/* ---- files ------------------------------------------------------------------- */

static enum tcs_status
file_take(struct mesh_bytes *bytes, const struct folder_file *file,
	const char **problem, struct tcs_fault *fault)
{
	bytes->at = malloc((size_t)file->size + 1);
	if (!bytes->at)
		return fault_memory(fault);
	while (bytes->count < file->size) {
		ssize_t got = read(file->file, bytes->at + bytes->count,
			(size_t)file->size - bytes->count);

		if (got < 0 && errno == EINTR)
			continue;
		if (got <= 0) {
			*problem = "it cannot be read";
			break;
		}
		bytes->count += (size_t)got;
	}
	bytes->at[bytes->count] = 0;
	return TCS_OK;
}

static enum tcs_status
path_read(struct mesh_bytes *bytes, const struct mesh_source *source,
	const char *path, const char **problem, struct tcs_fault *fault)
{
	const struct folder_limit limit = {source->limit, too_large};
	struct folder_file file;
	enum tcs_status status;

	*bytes = (struct mesh_bytes){.count = 0};
	*problem = "there is no folder to find it in";
	if (!source->folder || !source->folder->name)
		return TCS_OK;
	status = folder_open_file(
		source->folder, path, &limit, &file, problem, fault);
	if (status || *problem)
		return status;
	status = file_take(bytes, &file, problem, fault);
	close(file.file);
	return status;
}

static bool
is_beside(const char *name)
{
	return *name != '/' && !strchr(name, ':');
}

/* Take "." and what ".." takes back out of a path. */
static void
path_shorten(char *path)
{
	char *to = path;

	for (char *from = path, *next; *from; from = next) {
		size_t length = strcspn(from, "/");
		bool dots = length == 2 && !memcmp(from, "..", 2);
		bool first = to == path;
		bool climbs = to - path >= 3 && !memcmp(to - 3, "../", 3) &&
			(to - path == 3 || to[-4] == '/');

		next = from + length + (from[length] == '/');
		if (length == 1 && *from == '.')
			continue;
		if (dots && !first && !climbs) {
			for (to--; to > path && to[-1] != '/'; to--)
				;
			continue;
		}
		memmove(to, from, (size_t)(next - from));
		to += next - from;
	}
	*to = 0;
}

char *
mesh_path_beside(const char *path, const char *name)
{
	const char *slash = strrchr(path, '/');
	size_t length = slash ? (size_t)(slash + 1 - path) : 0;
	char *out;

	if (!is_beside(name))
		return strdup(name);
	out = malloc(length + strlen(name) + 1);
	if (!out)
		return NULL;
	memcpy(out, path, length);
	strcpy(out + length, name);
	for (char *at = out; *at; at++)
		if (*at == '\\')
			*at = '/';
	path_shorten(out);
	return out;
}

enum tcs_status
mesh_bytes_read(struct mesh_bytes *bytes, const struct mesh_source *source,
	const char *name, const char **problem, struct tcs_fault *fault)
{
	char *path;
	enum tcs_status status;

	if (!is_beside(name)) {
		*bytes = (struct mesh_bytes){.count = 0};
		*problem = "a file it needs is not beside it";
		return TCS_OK;
	}
	path = mesh_path_beside(source->path, name);
	if (!path)
		return fault_memory(fault);
	status = path_read(bytes, source, path, problem, fault);
	free(path);
	return status;
}

/* ---- kinds ------------------------------------------------------------------- */

enum mesh_kind { MESH_GLTF, MESH_OBJ, MESH_NONE };

static const struct {
	const char *suffix;
	enum mesh_kind kind;
	const char *problem;
} kinds[] = {
	{".glb", MESH_GLTF, NULL},
	{".gltf", MESH_GLTF, NULL},
	{".obj", MESH_OBJ, NULL},
	{".3ds", MESH_NONE, "3DS files are not read"},
	{".dae", MESH_NONE, "COLLADA files are not read"},
	{".dxf", MESH_NONE, "DXF files are not read"},
	{".fbx", MESH_NONE, "FBX files are not read"},
	{".ifc", MESH_NONE, "IFC files are not read here"},
	{".skp", MESH_NONE, "SketchUp files are not read"},
	{".stl", MESH_NONE, "STL files are not read"},
	{".wrl", MESH_NONE, "VRML files are not read"},
	{".x3d", MESH_NONE, "X3D files are not read"},
};

static int
kind_find(const char *path)
{
	size_t length = strlen(path);

	for (int i = 0; i < (int)(sizeof kinds / sizeof *kinds); i++) {
		size_t suffix = strlen(kinds[i].suffix);

		if (length >= suffix &&
			!strcasecmp(path + length - suffix, kinds[i].suffix))
			return i;
	}
	return -1;
}

const char *
mesh_kind_problem(const char *path)
{
	int found = kind_find(path);

	return found < 0 ? "files of its kind are not read"
			 : kinds[found].problem;
}

enum tcs_status
mesh_read(struct mesh_file *mesh, const struct mesh_source *source,
	const char **problem, struct tcs_fault *fault)
{
	int found = kind_find(source->path);
	struct mesh_bytes bytes;
	enum tcs_status status;

	*problem = mesh_kind_problem(source->path);
	if (*problem)
		return TCS_OK;
	status = path_read(&bytes, source, source->path, problem, fault);
	if (!status && !*problem)
		status = kinds[found].kind == MESH_GLTF
			? mesh_parse_gltf(mesh, source, &bytes, problem, fault)
			: mesh_parse_obj(mesh, source, &bytes, problem, fault);
	free(bytes.at);
	if (!status && !*problem && !mesh->faces.count)
		*problem = "it has no faces";
	if (mesh->faces.count)
		qsort(mesh->faces.at, mesh->faces.count, sizeof *mesh->faces.at,
			compare_faces);
	return status;
}
