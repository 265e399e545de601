/* Wavefront OBJ: points, faces, and the colours and images of materials. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "mesh_file.h"
#include "number.h"

struct obj {
	struct mesh_file *mesh;
	const struct mesh_source *source;
	const char **problem;
	struct tcs_fault *fault;
	uint32_t material; /* in force; TCS_NONE */
	int libraries; /* of materials, read so far */
	TCS_ARRAY(struct tcs_texcoord) texcoords;
};

/* A line, ended by a NUL, is taken word by word. */
struct words {
	char *at;
};

static bool
is_blank(char c)
{
	return c == ' ' || c == '\t' || c == '\r';
}

/* The next word; NULL at the end of the line. */
static char *
word_next(struct words *words)
{
	char *word;

	while (is_blank(*words->at))
		words->at++;
	if (!*words->at)
		return NULL;
	word = words->at;
	while (*words->at && !is_blank(*words->at))
		words->at++;
	if (*words->at)
		*words->at++ = 0;
	return word;
}

/* What is left of the line, without blanks at its end: names may have them. */
static char *
words_rest(struct words *words)
{
	char *end;

	while (is_blank(*words->at))
		words->at++;
	end = words->at + strlen(words->at);
	while (end > words->at && is_blank(end[-1]))
		*--end = 0;
	return words->at;
}

static int
numbers_take(struct words *words, double *out, int want)
{
	int count = 0;
	char *word;

	while (count < want && (word = word_next(words))) {
		const char *end = word + strlen(word);

		if (number_parse(word, end, &out[count]) != end)
			break;
		count++;
	}
	return count;
}

/* ---- materials --------------------------------------------------------------- */

static uint32_t
material_find(const struct mesh_file *mesh, const char *name)
{
	for (size_t i = 0; i < mesh->materials.count; i++)
		if (!strcmp(mesh->names.at + mesh->materials.at[i].name, name))
			return (uint32_t)i;
	return TCS_NONE;
}

static void
set_colour(struct mesh_material *material, struct words *words)
{
	double numbers[3];

	if (numbers_take(words, numbers, 3) != 3)
		return;
	for (int i = 0; i < 3; i++)
		if (numbers[i] >= 0 && numbers[i] <= 1)
			material->diffuse[i] = (float)numbers[i];
}

/* "d" is how opaque it is, "Tr" how clear. */
static void
set_clearness(struct mesh_material *material, struct words *words, bool opaque)
{
	double number;

	if (numbers_take(words, &number, 1) == 1 && number >= 0 && number <= 1)
		material->transparency = (float)(opaque ? 1 - number : number);
}

/* Whether the options before the name of an image leave it as it is: they are
 * taken, *wrap with them. */
static bool
image_options_take(struct words *words, uint32_t *wrap)
{
	static const char *const harmless[] = {"-blendu", "-blendv", "-boost",
		"-cc", "-texres", "-type", "-imfchan", "-bm"};
	bool known = true;

	*wrap = TCS_WRAP_REPEAT;
	while (known && *words_rest(words) == '-') {
		const char *option = word_next(words);
		const char *value = word_next(words);

		known = false;
		for (size_t i = 0; i < sizeof harmless / sizeof *harmless; i++)
			known |= !strcmp(option, harmless[i]);
		if (!strcmp(option, "-mm")) {
			known = true;
			word_next(words);
		}
		if (!strcmp(option, "-clamp")) {
			known = true;
			if (value && !strcmp(value, "on"))
				*wrap = TCS_WRAP_CLAMP;
		}
	}
	return known;
}

/* The image of the last material. */
static enum tcs_status
image_take(struct obj *obj, struct words *words)
{
	struct mesh_file *mesh = obj->mesh;
	uint32_t wrap, image;
	enum tcs_status status;
	char *uri;

	if (!image_options_take(words, &wrap) || !*words_rest(words))
		return TCS_OK;
	uri = mesh_path_beside(obj->source->path, words_rest(words));
	if (!uri)
		return fault_memory(obj->fault);
	status = mesh_add_image(mesh, obj->source, uri, "", wrap, NULL, &image,
		obj->problem, obj->fault);
	free(uri);
	if (!status && !*obj->problem)
		mesh->materials.at[mesh->materials.count - 1].image = image;
	return status;
}

enum { MOST_MATERIALS = 1000, MOST_LIBRARIES = 16 };

static enum tcs_status
material_line(struct obj *obj, char *line)
{
	struct words words = {line};
	struct mesh_file *mesh = obj->mesh;
	const char *key = word_next(&words), *name;
	struct mesh_material *last = mesh->materials.count
		? &mesh->materials.at[mesh->materials.count - 1]
		: NULL;

	if (!key)
		return TCS_OK;
	if (!strcmp(key, "newmtl")) {
		name = words_rest(&words);
		if (mesh->materials.count == MOST_MATERIALS) {
			*obj->problem = "it has more than 1000 materials";
			return TCS_OK;
		}
		return mesh_add_material(
			mesh, name, strlen(name), &last, obj->fault);
	}
	if (last && !strcmp(key, "Kd"))
		set_colour(last, &words);
	if (last && (!strcmp(key, "d") || !strcmp(key, "Tr")))
		set_clearness(last, &words, *key == 'd');
	if (last && !strcmp(key, "map_Kd") && last->image == TCS_NONE)
		return image_take(obj, &words);
	return TCS_OK;
}

/* ---- lines ------------------------------------------------------------------- */

/* Every line in turn, those that end in '\' joined with the next. */
static enum tcs_status
lines_take(struct obj *obj, struct mesh_bytes *bytes,
	enum tcs_status (*take)(struct obj *obj, char *line))
{
	char *at = (char *)bytes->at, *end = at + bytes->count;
	enum tcs_status status = TCS_OK;

	for (char *line = at; at < end && !status && !*obj->problem; at++) {
		if (*at != '\n' && at + 1 < end)
			continue;
		if (*at == '\n' && at > line && at[-1] == '\\') {
			at[-1] = *at = ' ';
			continue;
		}
		if (*at == '\n')
			*at = 0;
		status = take(obj, line);
		line = at + 1;
	}
	return status;
}

enum tcs_status
mesh_parse_mtl(struct mesh_file *mesh, const struct mesh_source *source,
	const struct mesh_bytes *bytes, const char **problem,
	struct tcs_fault *fault)
{
	struct obj obj = {
		.mesh = mesh,
		.source = source,
		.problem = problem,
		.fault = fault,
	};
	struct mesh_bytes text = *bytes;

	*problem = NULL;
	return lines_take(&obj, &text, material_line);
}

/* Without its colours a mesh is still one. */
static enum tcs_status
library_read(struct obj *obj, const char *name)
{
	struct mesh_source source = *obj->source;
	char *path = mesh_path_beside(source.path, name);
	struct mesh_bytes bytes;
	const char *problem;
	enum tcs_status status;

	if (!path)
		return fault_memory(obj->fault);
	status = mesh_bytes_read(
		&bytes, obj->source, name, &problem, obj->fault);
	source.path = path;
	if (problem)
		obj->mesh->lacks = "its materials cannot be read";
	else if (!status)
		status = mesh_parse_mtl(
			obj->mesh, &source, &bytes, obj->problem, obj->fault);
	free(bytes.at);
	free(path);
	return status;
}

static enum tcs_status
point_take(struct obj *obj, struct words *words)
{
	double numbers[3];

	if (numbers_take(words, numbers, 3) != 3) {
		*obj->problem = "a point has no three numbers";
		return TCS_OK;
	}
	return mesh_add_point(obj->mesh, obj->source,
		&(struct tcs_point){numbers[0], numbers[1], numbers[2]},
		obj->problem, obj->fault);
}

/* The height is 0 where it is left out. */
static enum tcs_status
texcoord_take(struct obj *obj, struct words *words)
{
	double numbers[2] = {(double)NAN, 0};

	if (obj->texcoords.count >=
		obj->source->limit / sizeof *obj->texcoords.at) {
		*obj->problem = "larger than --max-library";
		return TCS_OK;
	}
	if (array_grow(&obj->texcoords, 1))
		return fault_memory(obj->fault);
	numbers_take(words, numbers, 2);
	obj->texcoords.at[obj->texcoords.count++] =
		(struct tcs_texcoord){numbers[0], numbers[1]};
	return TCS_OK;
}

/* A number from 1, or from the end as "-1", as an index below `size`. */
static uint32_t
index_of(const char *word, size_t size)
{
	const char *end = word + strcspn(word, "/");
	int64_t number = 0, count = (int64_t)size;

	if (number_parse_integer(word, end, &number) != end)
		return TCS_NONE;
	if (number < 0)
		number += count + 1;
	return number > 0 && number <= count ? (uint32_t)(number - 1)
					     : TCS_NONE;
}

/* "7", "7/1", "7//3", "7/1/3". */
static enum tcs_status
corner_take(struct obj *obj, const char *word)
{
	const char *slash = strchr(word, '/');
	uint32_t texcoord =
		slash ? index_of(slash + 1, obj->texcoords.count) : TCS_NONE;

	return mesh_add_corner(obj->mesh, obj->source,
		index_of(word, obj->mesh->points.count),
		texcoord == TCS_NONE ? NULL : &obj->texcoords.at[texcoord],
		obj->problem, obj->fault);
}

static enum tcs_status
face_take(struct obj *obj, struct words *words)
{
	enum tcs_status status = TCS_OK;
	uint32_t count = 0;
	char *word;

	while (!status && !*obj->problem && (word = word_next(words))) {
		status = corner_take(obj, word);
		count++;
	}
	if (!status && !*obj->problem && count < 3)
		*obj->problem = "a face has fewer than three corners";
	if (status || *obj->problem)
		return status;
	return mesh_add_face(obj->mesh, count, obj->material, obj->fault);
}

static enum tcs_status
obj_line(struct obj *obj, char *line)
{
	struct words words = {line};
	const char *key = word_next(&words);

	if (!key)
		return TCS_OK;
	if (!strcmp(key, "v"))
		return point_take(obj, &words);
	if (!strcmp(key, "vt"))
		return texcoord_take(obj, &words);
	if (!strcmp(key, "f") || !strcmp(key, "fo"))
		return face_take(obj, &words);
	if (!strcmp(key, "mtllib") && obj->libraries++ < MOST_LIBRARIES)
		return library_read(obj, words_rest(&words));
	if (!strcmp(key, "usemtl"))
		obj->material = material_find(obj->mesh, words_rest(&words));
	return TCS_OK;
}

enum tcs_status
mesh_parse_obj(struct mesh_file *mesh, const struct mesh_source *source,
	const struct mesh_bytes *bytes, const char **problem,
	struct tcs_fault *fault)
{
	struct obj obj = {
		.mesh = mesh,
		.source = source,
		.problem = problem,
		.fault = fault,
		.material = TCS_NONE,
	};
	struct mesh_bytes text = *bytes;
	enum tcs_status status = TCS_OK;

	*problem = memchr(bytes->at, 0, bytes->count) ? "it is no text" : NULL;
	if (!*problem)
		status = lines_take(&obj, &text, obj_line);
	array_release(&obj.texcoords);
	return status;
}
