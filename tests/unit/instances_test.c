#include "check.h"
#include "instances.h"
#include "town_sample.h"

static const struct tcs_crs plane = {
	.metres_per_unit = 1, .metres_per_unit_up = 1};

/* An object as it comes out of a record, and what it places. */
struct scene {
	struct prototypes prototypes;
	struct tcs_record record;
	struct tcs_object object;
};

/* The sample object, and itself as the prototype that it places. */
static void
scene_init(struct scene *scene, const double *matrix)
{
	struct tcs_object sample = {0};
	struct tcs_fault fault;

	*scene = (struct scene){0};
	sample_object(&sample);
	sample.polygons.at[0].flags = TCS_POLYGON_SHARED;
	sample.instances.count = 0;
	scene->record.before = (struct tcs_tally){
		.prototypes = 1, .images = 1, .materials = 1};
	sample_must(
		object_encode(&sample, TCS_PROTOTYPE, &scene->record, &fault),
		&fault);
	sample_must(prototypes_add(&scene->prototypes, &scene->record, &fault),
		&fault);
	sample_object(&sample);
	if (matrix)
		memcpy(sample.instances.at[0].matrix, matrix,
			sizeof sample.instances.at[0].matrix);
	sample_must(object_encode(&sample, TCS_OBJECT, &scene->record, &fault),
		&fault);
	sample_must(
		object_decode(&scene->object, &scene->record, &fault), &fault);
	object_release(&sample);
}

static void
scene_release(struct scene *scene)
{
	prototypes_release(&scene->prototypes);
	object_release(&scene->object);
	record_release(&scene->record);
}

static void
scene_expand(struct scene *scene)
{
	struct tcs_fault fault;

	sample_must(instances_expand(&scene->object, &scene->prototypes, &plane,
			    UINT64_MAX, &fault),
		&fault);
	CHECK(!object_check(&scene->object, &fault));
	CHECK(scene->object.instances.count == 0);
}

static void
what_is_placed_becomes_geometry_of_the_feature_that_places_it(void)
{
	const double grown[16] = {
		2, 0, 0, 1, 0, 2, 0, 2, 0, 0, 2, 3, 0, 0, 0, 1};
	struct tcs_point at, from;
	const struct tcs_object *o;
	struct scene scene;

	scene_init(&scene, grown);
	scene_expand(&scene);
	o = &scene.object;
	CHECK(o->geometries.count == 4 && o->polygons.count == 6);
	CHECK(o->geometries.at[2].kind == TCS_SOLID);
	CHECK(o->geometries.at[2].lod == 3 && o->geometries.at[3].lod == 3);
	CHECK(o->geometries.at[2].feature == 2);
	CHECK(!strcmp(object_text(o, o->geometries.at[2].id), "tree"));
	CHECK(!o->geometries.at[3].id && !o->shells.at[1].id);
	CHECK(!o->polygons.at[3].id && !o->polygons.at[3].flags);
	CHECK(o->polygons.at[3].surface == 2);
	CHECK(o->polygons.at[4].flags == TCS_POLYGON_REVERSED);
	CHECK(o->polygons.at[3].first_vertex == 9);
	CHECK(o->triangles.at[4].corner[2] == 11);
	at = o->vertices.at[10];
	from = o->vertices.at[1];
	CHECK(!(at.x < 2 * from.x + 1 + 500010) &&
		!(at.x > 2 * from.x + 1 + 500010));
	CHECK(!(at.y < 2 * from.y + 2 + 5333780) &&
		!(at.y > 2 * from.y + 2 + 5333780));
	CHECK(!(at.z < 2 * from.z + 3 + 7) && !(at.z > 2 * from.z + 3 + 7));
	scene_release(&scene);
}

static void
paints_and_texture_coordinates_come_along(void)
{
	const struct tcs_object *o;
	struct scene scene;

	scene_init(&scene, NULL);
	scene_expand(&scene);
	o = &scene.object;
	CHECK(o->paints.count == 4 && o->texcoords.count == 8);
	CHECK(o->paints.at[2].polygon == 4 && o->paints.at[3].polygon == 3);
	CHECK(o->paints.at[2].first_texcoord == 4);
	CHECK(o->paints.at[3].first_texcoord == TCS_NONE);
	CHECK(o->paints.at[2].flags == TCS_PAINT_BACK);
	CHECK(!strcmp(object_text(o, o->paints.at[2].theme), "summer"));
	CHECK(!strcmp(object_text(o, o->paints.at[3].theme), "winter"));
	CHECK(!memcmp(&o->texcoords.at[0], &o->texcoords.at[4],
		4 * sizeof *o->texcoords.at));
	scene_release(&scene);
}

/* Triangles turn, and so wind against rings that do not. */
static void
what_is_mirrored_keeps_its_outside(void)
{
	const double mirror[16] = {
		-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
	const struct tcs_object *o;
	struct scene scene;

	scene_init(&scene, mirror);
	scene_expand(&scene);
	o = &scene.object;
	CHECK(o->polygons.at[3].flags == TCS_POLYGON_REVERSED);
	CHECK(o->polygons.at[4].flags == 0);
	CHECK(o->polygons.at[5].flags == 0); /* a point */
	CHECK(o->triangles.at[4].corner[0] == 11);
	CHECK(o->triangles.at[4].corner[1] == 10);
	CHECK(o->triangles.at[4].corner[2] == 9);
	scene_release(&scene);
}

static void
themes_are_text_once(void)
{
	struct tcs_instance again;
	struct scene scene;
	size_t once;

	scene_init(&scene, NULL);
	scene_expand(&scene);
	once = scene.object.text.count;
	scene_release(&scene);
	scene_init(&scene, NULL);
	again = scene.object.instances.at[0];
	SAMPLE_PUSH(scene.object.instances, again);
	scene_expand(&scene);
	CHECK(scene.object.text.count == once);
	CHECK(scene.object.paints.count == 6);
	scene_release(&scene);
}

static void
over_degrees_a_prototype_is_in_metres(void)
{
	const struct tcs_crs degrees = {.metres_per_unit = 1,
		.metres_per_unit_up = 1,
		.kind = TCS_CRS_GEOGRAPHIC};
	struct prototypes prototypes = {0};
	struct tcs_record record = {0};
	struct tcs_object object = {0};
	struct tcs_fault fault;

	sample_prototype(&object);
	sample_must(
		object_encode(&object, TCS_PROTOTYPE, &record, &fault), &fault);
	sample_must(prototypes_add(&prototypes, &record, &fault), &fault);
	object_clear(&object);
	SAMPLE_PUSH(object.features, (struct tcs_feature){.parent = TCS_NONE});
	SAMPLE_PUSH(object.instances,
		(struct tcs_instance){.matrix = {100, 0, 0, 0, 0, 100, 0, 0, 0,
					      0, 100, 0, 0, 0, 0, 1},
			.anchor = {11, 48, 500}});
	CHECK(!instances_expand(
		&object, &prototypes, &degrees, UINT64_MAX, &fault));
	/* A degree of longitude at 48 degrees north is 74.6 km. */
	CHECK(fabs((object.vertices.at[1].x - 11) * 74625.3 - 100) < 0.01);
	CHECK(fabs(object.vertices.at[1].y - 48) < 1e-6);
	CHECK(fabs(object.vertices.at[2].z - 600) < 1e-6);
	prototypes_release(&prototypes);
	record_release(&record);
	object_release(&object);
}

static void
what_places_nothing_stays_as_it_is(void)
{
	struct tcs_fault fault;
	struct scene scene;
	const void *before;

	scene_init(&scene, NULL);
	scene.object.instances.count = 0;
	before = scene.object.vertices.at;
	CHECK(!instances_expand(
		&scene.object, &scene.prototypes, &plane, 0, &fault));
	CHECK(scene.object.vertices.at == before);
	CHECK(scene.object.geometries.count == 2);
	scene_release(&scene);
}

static void
too_much_is_refused(void)
{
	const double far[16] = {
		1, 0, 0, 1e308, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
	struct tcs_fault fault;
	struct scene scene;

	scene_init(&scene, NULL);
	CHECK(instances_expand(&scene.object, &scene.prototypes, &plane, 100,
		      &fault) == TCS_LIMIT);
	CHECK(strstr(fault.text, "b1"));
	scene_release(&scene);
	scene_init(&scene, far);
	scene.object.instances.at[0].anchor.x = 1e308;
	CHECK(instances_expand(&scene.object, &scene.prototypes, &plane,
		      UINT64_MAX, &fault) == TCS_LIMIT);
	scene_release(&scene);
}

int
main(void)
{
	static const struct check_test tests[] = {
		CHECK_TEST(
			what_is_placed_becomes_geometry_of_the_feature_that_places_it),
		CHECK_TEST(paints_and_texture_coordinates_come_along),
		CHECK_TEST(what_is_mirrored_keeps_its_outside),
		CHECK_TEST(themes_are_text_once),
		CHECK_TEST(over_degrees_a_prototype_is_in_metres),
		CHECK_TEST(what_places_nothing_stays_as_it_is),
		CHECK_TEST(too_much_is_refused),
		{0},
	};

	return check_run(tests);
}
