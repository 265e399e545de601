/* The tables of tcs(5) say what the structs are. */
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "labels.h"
#include "tcs_field.h"
#include "tcs_layout.h"

static char *page;

static void
the_page_is_there(void)
{
	FILE *file = fopen("lib/tcs.5", "rb");
	size_t room = 1 << 20, length = 0;

	page = calloc(1, room);
	if (file && page)
		length = fread(page, 1, room - 1, file);
	CHECK(length > 10000);
	if (file)
		fclose(file);
}

/* What follows the heading of a section, up to the next heading. */
static char *
section_of(uint32_t tag, size_t size)
{
	char name[5] = {0}, unit[40];
	char *at = page, *end, *copy;

	memcpy(name, &tag, 4);
	name[strcspn(name, " ")] = '\0';
	snprintf(unit, sizeof unit, ", %zu byte", size);
	while ((at = strstr(at, "\n.Ss \""))) {
		at += strlen("\n.Ss \"");
		if (!strncmp(at, name, strlen(name)) && at[strlen(name)] == ':')
			break;
	}
	if (!at)
		return NULL;
	end = strstr(at, "\n.S");
	copy = end ? strndup(at, (size_t)(end - at)) : NULL;
	if (copy && !strstr(copy, unit)) {
		fprintf(stderr, "%s: not%ss\n", name, unit);
		free(copy);
		return NULL;
	}
	return copy;
}

static const char *
type_of(const struct tcs_field *field, char out[32])
{
	const char *name = NULL;

	switch (field->type) {
	case FIELD_TEXT:
		name = "text";
		break;
	case FIELD_DOUBLE:
		name = "f64";
		break;
	case FIELD_FLOAT:
		name = "f32";
		break;
	case FIELD_INTEGER:
		name = "i32";
		break;
	default:
		break;
	}
	if (!name)
		snprintf(out, 32, "u%zu", 8 * field->size);
	else if (field->count > 1)
		snprintf(out, 32, "%s[%zu]", name, field->count);
	else
		snprintf(out, 32, "%s", name);
	return out;
}

static void
every_field_stands_in_its_table(void)
{
	static const struct tcs_fields *const every[] = {&fields_feature,
		&fields_attribute, &fields_relation, &fields_geometry,
		&fields_shell, &fields_polygon, &fields_ring, &fields_paint,
		&fields_instance, &fields_crs, &fields_source, &fields_model,
		&fields_stage, &fields_image, &fields_material, &fields_tally};

	for (size_t i = 0; i < sizeof every / sizeof *every; i++) {
		char *section = section_of(every[i]->tag, every[i]->size);

		CHECK(section);
		for (size_t k = 0; section && k < every[i]->count; k++) {
			const struct tcs_field *field = &every[i]->at[k];
			char row[128], type[32];

			snprintf(row, sizeof row, "\n.It %zu Ta %s Ta %s Ta",
				field->at, type_of(field, type), field->name);
			if (!strstr(section, row))
				fprintf(stderr, "tcs.5 lacks%s\n", row + 4);
			CHECK(strstr(section, row));
		}
		free(section);
	}
}

static void
every_section_is_described(void)
{
	static const struct tcs_layout *const layouts[] = {
		&layout_object, &layout_head, &layout_palette, &layout_end};

	for (size_t i = 0; i < 4; i++) {
		for (size_t k = 0; k < layouts[i]->count; k++) {
			const struct tcs_column *column =
				&layouts[i]->columns[k];
			char *section = section_of(column->tag, column->size);

			CHECK(section);
			free(section);
		}
	}
}

static void
every_class_has_its_number(void)
{
	for (unsigned i = 0; i < TCS_CLASS_COUNT; i++) {
		char row[80];

		snprintf(row, sizeof row, "\n.It %u Ta %s\n", i,
			label_of(i)->name);
		CHECK(strstr(page, row));
	}
}

static const struct check_test tests[] = {
	CHECK_TEST(the_page_is_there),
	CHECK_TEST(every_section_is_described),
	CHECK_TEST(every_field_stands_in_its_table),
	CHECK_TEST(every_class_has_its_number),
	{0},
};

int
main(void)
{
	int result = check_run(tests);

	free(page);
	return result;
}
