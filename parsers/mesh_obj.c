/* Wavefront OBJ: points, faces and the plain colours of materials. */
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

/* Without its colours a mesh is still one. */
static enum tcs_status
library_read(struct obj *obj, const char *name)
{
	struct mesh_bytes bytes;
	const char *problem;
	enum tcs_status status = mesh_bytes_read(
		&bytes, obj->source, name, &problem, obj->fault);

	if (!status && !problem)
		status = lines_take(obj, &bytes, material_line);
	free(bytes.at);
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

/* "7", "7/1", "7//3", "7/1/3", or from the end as "-1". */
static uint32_t
corner_of(const struct mesh_file *mesh, const char *word)
{
	const char *end = word + strcspn(word, "/");
	int64_t number = 0, count = (int64_t)mesh->points.count;

	if (number_parse_integer(word, end, &number) != end)
		return TCS_NONE;
	if (number < 0)
		number += count + 1;
	return number > 0 && number <= count ? (uint32_t)(number - 1)
					     : TCS_NONE;
}

static enum tcs_status
face_take(struct obj *obj, struct words *words)
{
	enum tcs_status status = TCS_OK;
	uint32_t count = 0;
	char *word;

	while (!status && !*obj->problem && (word = word_next(words))) {
		status = mesh_add_corner(obj->mesh, obj->source,
			corner_of(obj->mesh, word), obj->problem, obj->fault);
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
	struct obj obj = {mesh, source, problem, fault, TCS_NONE, 0};
	struct mesh_bytes text = *bytes;

	*problem = memchr(bytes->at, 0, bytes->count) ? "it is no text" : NULL;
	return *problem ? TCS_OK : lines_take(&obj, &text, obj_line);
}
