#include "tcs_field.h"

#include <string.h>

#include "check.h"
#include "tcs_layout.h"

static const struct tcs_fields *const every[] = {&fields_feature,
	&fields_attribute, &fields_relation, &fields_geometry, &fields_shell,
	&fields_polygon, &fields_ring, &fields_paint, &fields_instance,
	&fields_crs, &fields_source, &fields_model, &fields_stage,
	&fields_image, &fields_material, &fields_tally};

#define EVERY (sizeof every / sizeof *every)

static void
fields_cover_every_byte_once(void)
{
	for (size_t i = 0; i < EVERY; i++) {
		unsigned char seen[256] = {0};
		size_t wrong = 0;

		for (size_t k = 0; k < every[i]->count; k++) {
			const struct tcs_field *field = &every[i]->at[k];

			for (size_t b = 0; b < field->size * field->count; b++)
				seen[field->at + b]++;
		}
		for (size_t b = 0; b < every[i]->size; b++)
			wrong += seen[b] != 1;
		CHECK(!wrong);
		CHECK(!seen[every[i]->size]);
	}
}

static const struct tcs_column *
column_of(uint32_t tag)
{
	static const struct tcs_layout *const layouts[] = {
		&layout_object, &layout_head, &layout_palette, &layout_end};
	const struct tcs_column *column = NULL;

	for (size_t i = 0; !column && i < 4; i++)
		column = layout_column(layouts[i], tag);
	return column;
}

/* The layout says again where the text is; both must say the same. */
static void
fields_agree_with_the_layout(void)
{
	for (size_t i = 0; i < EVERY; i++) {
		const struct tcs_column *column = column_of(every[i]->tag);
		size_t texts = 0;

		CHECK(column && column->size == every[i]->size);
		for (size_t k = 0; column && k < every[i]->count; k++) {
			const struct tcs_field *field = &every[i]->at[k];
			int listed = 0;

			if (field->type != FIELD_TEXT)
				continue;
			texts++;
			for (size_t t = 0; t < column->text_count; t++)
				listed += column->texts[t] == field->at;
			CHECK(listed == 1);
		}
		CHECK(column && texts == column->text_count);
	}
}

static void
names_end_where_the_enumerations_do(void)
{
	const struct tcs_field *field = fields_find(&fields_attribute, "type");

	CHECK(!strcmp(field->names[TCS_SET], "set") &&
		!field->names[TCS_SET + 1]);
	field = fields_find(&fields_geometry, "kind");
	CHECK(!strcmp(field->names[TCS_MULTI_POINT], "multi-point"));
	CHECK(!strcmp(field->names[TCS_TIN], "tin"));
	CHECK(!field->names[TCS_MULTI_POINT + 1]);
	field = fields_find(&fields_crs, "kind");
	CHECK(!strcmp(field->names[TCS_CRS_LOCAL], "local"));
	CHECK(!field->names[TCS_CRS_LOCAL + 1]);
	field = fields_find(&fields_image, "wrap");
	CHECK(!strcmp(field->names[TCS_WRAP_BORDER], "border"));
	CHECK(!field->names[TCS_WRAP_BORDER + 1]);
}

static void
an_element_by_default_has_no_parent_and_no_lod(void)
{
	struct tcs_feature feature;
	struct tcs_instance instance;
	struct tcs_paint paint;

	fields_default(&fields_feature, &feature);
	CHECK(feature.parent == TCS_NONE && !feature.id);
	fields_default(&fields_instance, &instance);
	CHECK(instance.lod == TCS_LOD_NONE && instance.matrix[15] == 0);
	fields_default(&fields_paint, &paint);
	CHECK(paint.material == TCS_NONE && paint.image == TCS_NONE);
	CHECK(!fields_find(&fields_paint, "first_texcoord"));
}

static const struct check_test tests[] = {
	CHECK_TEST(fields_cover_every_byte_once),
	CHECK_TEST(fields_agree_with_the_layout),
	CHECK_TEST(names_end_where_the_enumerations_do),
	CHECK_TEST(an_element_by_default_has_no_parent_and_no_lod),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
