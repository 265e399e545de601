#include "check.h"
#include "writers/gltf_assembly.h"

#include <stdlib.h>
#include <string.h>

static struct tcs_fault fault;

static struct assembly_root
plain_root(void)
{
	return (struct assembly_root){.generator = "test",
		.name = "city",
		.matrix = {[0] = 1, [6] = -1, [9] = 1, [15] = 1},
		.crs = ""};
}

/* The JSON text; the caller frees it. */
static char *
finished(struct gltf_assembly *assembly, const struct assembly_root *root)
{
	uint64_t size = 0;
	FILE *file = tmpfile();
	char *text;

	CHECK(!assembly_finish(assembly, root, &size, &fault));
	CHECK(!assembly_pour(assembly, file, "test", &fault));
	CHECK((uint64_t)ftell(file) == size);
	rewind(file);
	text = calloc(size + 1, 1);
	CHECK(fread(text, 1, size, file) == size);
	fclose(file);
	return text;
}

static void
without_objects_the_scene_is_empty_and_no_null(void)
{
	struct gltf_assembly *assembly = assembly_new(NULL, &fault);
	struct assembly_root root = plain_root();
	char *text = finished(assembly, &root);

	CHECK(!strstr(text, "null"));
	CHECK(strstr(text, "\"scenes\":[{\"name\":\"city\"}]"));
	CHECK(!strstr(text, "\"nodes\""));
	CHECK(!strstr(text, "\"buffers\""));
	free(text);
	assembly_free(assembly);
}

static void
batches_join_into_one_array(void)
{
	struct gltf_assembly *assembly = assembly_new(NULL, &fault);
	struct assembly_root root = plain_root();
	char name[32], *text, *at;
	int found = 0;

	for (int i = 0; i < 200; i++) {
		snprintf(name, sizeof name, "n[%d]{\"\\,", i);
		CHECK(!assembly_add_node(
			assembly, name, NULL, NULL, 0, &fault));
	}
	text = finished(assembly, &root);
	for (at = text; (at = strstr(at, "\"n[")); at++)
		found++;
	CHECK(found == 200);
	CHECK(strstr(text,
		"{\"name\":\"n[63]{\\\"\\\\,\"},"
		"{\"name\":\"n[64]{\\\"\\\\,\"}"));
	CHECK(strstr(text, "\"scenes\":[{\"name\":\"city\",\"nodes\":[200]}]"));
	CHECK(text[0] == '{' && text[strlen(text) - 1] == '}');
	free(text);
	assembly_free(assembly);
}

static void
text_that_is_not_utf8_fails_without_throwing(void)
{
	struct gltf_assembly *assembly = assembly_new(NULL, &fault);
	struct assembly_root root = plain_root();
	uint64_t size;

	CHECK(!assembly_add_node(assembly, "a\xff", NULL, NULL, 0, &fault));
	CHECK(assembly_finish(assembly, &root, &size, &fault) == TCS_BAD_INPUT);
	CHECK(strstr(fault.text, "UTF-8"));
	assembly_free(assembly);
}

static void
the_buffer_is_named_with_its_size(void)
{
	struct gltf_assembly *assembly = assembly_new(NULL, &fault);
	struct assembly_root root = plain_root();
	struct assembly_view view = {
		.offset = UINT64_C(5000000000), .length = UINT64_C(6000000000)};
	char *text;

	root.buffer_size = UINT64_C(11000000000);
	root.buffer_uri = "a%20b.bin";
	CHECK(!assembly_add_view(assembly, &view, &fault));
	text = finished(assembly, &root);
	CHECK(strstr(text,
		"\"buffers\":[{\"byteLength\":11000000000,"
		"\"uri\":\"a%20b.bin\"}]"));
	CHECK(strstr(text,
		"\"byteLength\":6000000000,"
		"\"byteOffset\":5000000000"));
	free(text);
	assembly_free(assembly);
}

int
main(void)
{
	static const struct check_test tests[] = {
		CHECK_TEST(without_objects_the_scene_is_empty_and_no_null),
		CHECK_TEST(batches_join_into_one_array),
		CHECK_TEST(text_that_is_not_utf8_fails_without_throwing),
		CHECK_TEST(the_buffer_is_named_with_its_size),
		{0},
	};

	return check_run(tests);
}
