#include "check.h"
#include "town_sample.h"
#include "writers/gltf_material.h"
#include "writers/gltf_mesh.h"

#include <math.h>

static struct tcs_fault fault;

static bool
near(double a, double b)
{
	return fabs(a - b) < 1e-6;
}

static void
colours_become_linear(void)
{
	CHECK(near(colour_linear(0), 0));
	CHECK(near(colour_linear(1), 1));
	CHECK(near(colour_linear(0.5), 0.2140411));
	CHECK(near(colour_linear(0.04), 0.04 / 12.92));
	CHECK(near(colour_linear(7), 1));
	CHECK(near(colour_linear(-1), 0));
}

static void
a_class_has_one_material_per_sidedness(void)
{
	struct materials materials = {.looks = {NULL, 0, 0}};
	struct tcs_palette palette = {.text = {NULL, 0, 0}};
	uint32_t one, both, again;

	CHECK(!materials_find(&materials, TCS_CLASS_RoofSurface, &palette, NULL,
		&one, &fault));
	CHECK(!materials_find(&materials,
		TCS_CLASS_RoofSurface | PAINT_DOUBLE_SIDED, &palette, NULL,
		&both, &fault));
	CHECK(!materials_find(&materials, TCS_CLASS_RoofSurface, &palette, NULL,
		&again, &fault));
	CHECK(one == 0 && both == 1 && again == 0);
	CHECK(materials.looks.count == 2);
	CHECK(!strcmp(materials.looks.at[0].name, "RoofSurface"));
	CHECK(near(
		materials.looks.at[0].colour[0], colour_linear(0xa8 / 255.)));
	CHECK(!materials.looks.at[0].double_sided);
	CHECK(materials.looks.at[1].double_sided);
	materials_release(&materials);
}

static void
equal_materials_of_the_stream_become_one(void)
{
	struct materials materials = {.looks = {NULL, 0, 0}};
	struct tcs_palette palette = {.text = {NULL, 0, 0}};
	uint32_t numbers[3];

	SAMPLE_PUSH(palette.text, '\0');
	for (int i = 0; i < 3; i++)
		SAMPLE_PUSH(palette.materials,
			(struct tcs_material){.diffuse = {1, 0, 0},
				.shininess = 1,
				.specular = {0, i == 2 ? 0.5f : 0, 0},
				.transparency = i == 2 ? 0.25f : 0});
	for (uint32_t i = 0; i < 3; i++)
		CHECK(!materials_find(&materials, i | PAINT_MATERIAL, &palette,
			NULL, numbers + i, &fault));
	CHECK(numbers[0] == 0 && numbers[1] == 0 && numbers[2] == 1);
	CHECK(near(materials.looks.at[1].colour[3], 0.75));
	CHECK(near(materials.looks.at[0].roughness, 1));
	CHECK(near(materials.looks.at[1].roughness,
		1 - 0.5 * (1 - pow(2. / 130, 0.25))));
	materials_release(&materials);
	palette_release(&palette);
}

static void
a_paint_beyond_the_palette_is_unknown(void)
{
	struct materials materials = {.looks = {NULL, 0, 0}};
	struct tcs_palette palette = {.text = {NULL, 0, 0}};
	uint32_t number;

	CHECK(!materials_find(&materials, 5 | PAINT_MATERIAL, &palette, NULL,
		&number, &fault));
	CHECK(!strcmp(materials.looks.at[number].name, "Unknown"));
	materials_release(&materials);
}

int
main(void)
{
	static const struct check_test tests[] = {
		CHECK_TEST(colours_become_linear),
		CHECK_TEST(a_class_has_one_material_per_sidedness),
		CHECK_TEST(equal_materials_of_the_stream_become_one),
		CHECK_TEST(a_paint_beyond_the_palette_is_unknown),
		{0},
	};

	return check_run(tests);
}
