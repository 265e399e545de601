#include "check.h"
#include "town_sample.h"

/*
 * One rule of object_check each: a way to break the sample object. The names
 * say which.
 */
#define RULES(X) \
	X(no_feature, o->features.count = 0) \
	X(root_with_parent, o->features.at[0].parent = 0) \
	X(parent_behind, o->features.at[1].parent = 2) \
	X(own_parent, o->features.at[1].parent = 1) \
	X(second_root, o->features.at[1].parent = TCS_NONE) \
	X(attribute_feature, o->attributes.at[3].feature = 3) \
	X(attribute_order, o->attributes.at[0].feature = 1) \
	X(attribute_type, o->attributes.at[0].type = TCS_SET + 1) \
	X(set_behind, o->attributes.at[2].parent = 2) \
	X(set_of_another, o->attributes.at[3].parent = 1) \
	X(relation_feature, o->relations.at[0].feature = 3) \
	X(geometry_feature, o->geometries.at[0].feature = 3) \
	X(geometry_lod, o->geometries.at[0].lod = 5) \
	X(geometry_kind, o->geometries.at[1].kind = TCS_MULTI_POINT + 1) \
	X(geometry_gap, o->geometries.at[1].first_polygon = 3) \
	X(geometry_overlap, o->geometries.at[1].first_polygon = 1) \
	X(geometry_shell_gap, o->geometries.at[1].first_shell = 0) \
	X(geometry_too_long, o->geometries.at[1].polygon_count = 2) \
	X(geometry_huge, o->geometries.at[1].polygon_count = UINT32_MAX) \
	X(polygon_of_none, o->geometries.at[1].polygon_count = 0) \
	X(shells_of_a_point, o->geometries.at[0].kind = TCS_MULTI_SURFACE) \
	X(solid_without_shell, o->geometries.at[1].kind = TCS_SOLID) \
	X(shell_start, o->shells.at[0].first_polygon = 1) \
	X(shell_short, o->shells.at[0].polygon_count = 1) \
	X(shell_huge, o->shells.at[0].polygon_count = UINT32_MAX) \
	X(shell_interior, o->shells.at[0].interior = 2) \
	X(shell_of_none, SAMPLE_PUSH(o->shells, (struct tcs_shell){0})) \
	X(polygon_surface, o->polygons.at[1].surface = 3) \
	X(polygon_vertex_gap, o->polygons.at[1].first_vertex = 5) \
	X(polygon_ring_gap, o->polygons.at[2].first_ring = 1) \
	X(polygon_triangle_gap, o->polygons.at[2].first_triangle = 3) \
	X(polygon_too_long, o->polygons.at[2].vertex_count = 2) \
	X(polygon_huge, o->polygons.at[2].triangle_count = UINT32_MAX) \
	X(vertex_of_none, \
		SAMPLE_PUSH(o->vertices, (struct tcs_point){0, 0, 0})) \
	X(triangle_of_none, \
		SAMPLE_PUSH(o->triangles, (struct tcs_triangle){{0, 1, 2}})) \
	X(ring_of_none, SAMPLE_PUSH(o->rings, (struct tcs_ring){0, 9, 1})) \
	X(ring_start, o->rings.at[1].first_vertex = 5) \
	X(ring_empty, o->rings.at[2].vertex_count = 0) \
	X(ring_long, o->rings.at[0].vertex_count = 5) \
	X(corner_before, o->triangles.at[2].corner[0] = 3) \
	X(corner_behind, o->triangles.at[0].corner[2] = 4) \
	X(triangle_of_a_point, o->polygons.at[1].triangle_count = 1, \
		o->polygons.at[2].first_triangle = 3, \
		o->polygons.at[2].triangle_count = 1, \
		o->triangles.at[3] = (struct tcs_triangle){{8, 8, 8}}) \
	X(paint_polygon, o->paints.at[1].polygon = 3) \
	X(texcoord_gap, o->paints.at[0].first_texcoord = 1) \
	X(texcoord_without_image, o->paints.at[1].first_texcoord = 4) \
	X(image_without_texcoord, o->paints.at[0].first_texcoord = TCS_NONE) \
	X(texcoord_short, o->texcoords.count = 3) \
	X(texcoord_of_none, \
		SAMPLE_PUSH(o->texcoords, (struct tcs_texcoord){0, 0})) \
	X(instance_feature, o->instances.at[0].feature = 3) \
	X(instance_lod, o->instances.at[0].lod = 6) \
	X(matrix_nan, o->instances.at[0].matrix[5] = NAN) \
	X(anchor_infinite, o->instances.at[0].anchor.y = INFINITY) \
	X(vertex_nan, o->vertices.at[8].z = NAN) \
	X(vertex_infinite, o->vertices.at[3].x = -INFINITY) \
	X(texcoord_nan, o->texcoords.at[3].t = NAN) \
	X(text_start, o->text.at[0] = 'x') \
	X(text_end, o->text.at[o->text.count - 1] = 'x') \
	X(text_not_utf8, o->text.at[o->features.at[0].name] = '\xff') \
	X(offset_beyond, o->features.at[0].id = (tcs_text)o->text.count) \
	X(offset_huge, o->polygons.at[1].id = UINT32_MAX) \
	X(offset_within, o->features.at[0].name++) \
	X(offset_of_nothing, \
		o->instances.at[0].id = (tcs_text)o->text.count - 1)

#define SPOIL(name, ...) \
	static void spoil_##name(struct tcs_object *o) \
	{ \
		__VA_ARGS__; \
	}
RULES(SPOIL)

static const struct {
	const char *name;
	void (*spoil)(struct tcs_object *object);
} rules[] = {
#define ROW(name, ...) {#name, spoil_##name},
	RULES(ROW)
#undef ROW
};

static void
the_sample_keeps_the_rules(void)
{
	struct tcs_object object = {0};
	struct tcs_fault fault;

	sample_object(&object);
	CHECK(!object_check(&object, &fault));
	sample_prototype(&object);
	CHECK(!object_check(&object, &fault));
	object_release(&object);
}

static void
every_broken_rule_is_found(void)
{
	struct tcs_object object = {0};
	struct tcs_fault fault;

	for (size_t i = 0; i < sizeof rules / sizeof *rules; i++) {
		enum tcs_status status;

		sample_object(&object);
		rules[i].spoil(&object);
		fault.text[0] = '\0';
		status = object_check(&object, &fault);
		CHECK(status == TCS_BAD_INPUT);
		CHECK(fault.text[0]);
		if (status != TCS_BAD_INPUT)
			fprintf(stderr, "rule not checked: %s\n",
				rules[i].name);
	}
	object_release(&object);
}

static void
a_newer_class_and_unknown_flags_pass(void)
{
	struct tcs_object object = {0};
	struct tcs_fault fault;

	sample_object(&object);
	object.features.at[1].class = 60000;
	object.polygons.at[0].flags = 1u << 31;
	CHECK(!object_check(&object, &fault));
	object_release(&object);
}

static enum tcs_status
decode_after(const struct tcs_tally *before)
{
	struct tcs_object object = {0}, out = {0};
	struct tcs_record record = {0};
	struct tcs_fault fault;
	enum tcs_status status;

	sample_object(&object);
	sample_must(
		object_encode(&object, TCS_OBJECT, &record, &fault), &fault);
	record.before = *before;
	status = object_decode(&out, &record, &fault);
	object_release(&object);
	object_release(&out);
	record_release(&record);
	return status;
}

static void
what_an_object_names_stands_before_it(void)
{
	struct tcs_tally before = {
		.materials = 1, .images = 1, .prototypes = 1};

	CHECK(!decode_after(&before));
	before.materials = 0;
	CHECK(decode_after(&before) == TCS_BAD_INPUT);
	before.materials = 1;
	before.images = 0;
	CHECK(decode_after(&before) == TCS_BAD_INPUT);
	before.images = 1;
	before.prototypes = 0;
	CHECK(decode_after(&before) == TCS_BAD_INPUT);
}

static const struct check_test tests[] = {
	CHECK_TEST(the_sample_keeps_the_rules),
	CHECK_TEST(every_broken_rule_is_found),
	CHECK_TEST(a_newer_class_and_unknown_flags_pass),
	CHECK_TEST(what_an_object_names_stands_before_it),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
