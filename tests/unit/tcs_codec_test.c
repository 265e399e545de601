#include "check.h"
#include "town_sample.h"

/* The sample object, encoded so that it may be decoded by itself. */
static void
encode_object(struct tcs_record *record)
{
	struct tcs_object object = {0};
	struct tcs_fault fault;

	sample_object(&object);
	sample_must(object_encode(&object, TCS_OBJECT, record, &fault), &fault);
	record->before = (struct tcs_tally){
		.materials = 1, .images = 2, .prototypes = 1};
	object_release(&object);
}

#define SAME(a, b, member) \
	((a).member.count == (b).member.count && \
		!memcmp((a).member.at, (b).member.at, \
			(b).member.count * sizeof *(b).member.at))

static void
decoding_gives_back_every_array(void)
{
	struct tcs_object in = {0}, out = {0};
	struct tcs_record record = {0};
	struct tcs_fault fault;

	sample_object(&in);
	encode_object(&record);
	CHECK(!object_decode(&out, &record, &fault));
	CHECK(out.features.count == 3);
	CHECK(!strcmp(object_text(&out, out.features.at[0].name),
		"Town hall \xc3\xa4"));
	CHECK(!strcmp(object_text(&out, out.features.at[2].type), "IfcDoor"));
	CHECK(out.attributes.count == 4);
	CHECK(isnan(out.attributes.at[2].number));
	CHECK(!strcmp(object_text(&out, out.attributes.at[3].code_space),
		"codes.xml"));
	CHECK(out.relations.count == 1);
	CHECK(out.geometries.count == 2 && out.geometries.at[0].lod == 2);
	CHECK(out.shells.count == 1 && out.rings.count == 3);
	CHECK(out.polygons.count == 3);
	CHECK(SAME(in, out, vertices));
	CHECK(SAME(in, out, triangles));
	CHECK(SAME(in, out, texcoords));
	CHECK(out.paints.count == 2 && out.instances.count == 1);
	CHECK(out.instances.at[0].anchor.z == 7);
	object_release(&in);
	object_release(&out);
	record_release(&record);
}

static void
equal_strings_are_written_once(void)
{
	struct tcs_object out = {0};
	struct tcs_record record = {0};
	struct tcs_fault fault;

	encode_object(&record);
	CHECK(!object_decode(&out, &record, &fault));
	CHECK(out.relations.at[0].target == out.features.at[1].id);
	CHECK(out.features.at[0].id == 1);
	object_release(&out);
	record_release(&record);
}

static void
text_that_nothing_names_is_left_out(void)
{
	struct tcs_object object = {0}, out = {0};
	struct tcs_record record = {0};
	struct tcs_fault fault;

	sample_prototype(&object);
	(void)SAMPLE_TEXT(&object, "nobody's");
	CHECK(!object_encode(&object, TCS_PROTOTYPE, &record, &fault));
	CHECK(!object_decode(&out, &record, &fault));
	CHECK(out.text.count == 1);
	object_release(&object);
	object_release(&out);
	record_release(&record);
}

static void
lent_arrays_lie_in_the_record_and_copy_when_they_grow(void)
{
	struct tcs_object out = {0};
	struct tcs_record record = {0};
	struct tcs_fault fault;
	const void *end;
	double kept;

	encode_object(&record);
	CHECK(!object_decode(&out, &record, &fault));
	end = record.bytes.at + record.bytes.count;
	CHECK((const void *)out.vertices.at > (const void *)record.bytes.at);
	CHECK((const void *)out.vertices.at < end);
	CHECK(out.vertices.room == 0);
	CHECK((size_t)(void *)out.vertices.at % 8 == 0);
	kept = out.vertices.at[0].x;
	SAMPLE_PUSH(out.vertices, (struct tcs_point){1, 2, 3});
	CHECK(out.vertices.count == 10 && out.vertices.room >= 10);
	CHECK(out.vertices.at[0].x == kept);
	object_release(&out);
	record_release(&record);
}

static void
an_object_may_be_encoded_into_the_record_that_lends_it(void)
{
	struct tcs_object out = {0};
	struct tcs_record record = {0}, same = {0};
	struct tcs_fault fault;

	if (array_grow(&record.bytes, 100000))
		abort();
	encode_object(&record);
	encode_object(&same);
	CHECK(!object_decode(&out, &record, &fault));
	for (int i = 0; i < 50; i++)
		SAMPLE_PUSH(out.relations, (struct tcs_relation){0});
	CHECK(!object_encode(&out, TCS_OBJECT, &record, &fault));
	CHECK(out.vertices.at[0].x == 500000.125);
	CHECK(!object_decode(&out, &record, &fault));
	CHECK(out.relations.count == 51);
	CHECK(!strcmp(object_text(&out, out.relations.at[0].role), "fills"));
	CHECK(out.vertices.at[0].x == 500000.125);
	out.relations.count = 1;
	CHECK(!object_encode(&out, TCS_OBJECT, &record, &fault));
	CHECK(SAME(record, same, bytes));
	object_release(&out);
	record_release(&record);
	record_release(&same);
}

/* Append a section of eight bytes that no version knows. */
static void
add_section(struct tcs_record *record, uint32_t tag, uint32_t size)
{
	uint32_t count;
	uint64_t elements = 8 / size;
	unsigned char *at;

	if (array_grow(&record->bytes, 24))
		abort();
	at = record->bytes.at;
	memcpy(&count, at, 4);
	memmove(at + 8 + 16 * (count + 1), at + 8 + 16 * count,
		record->bytes.count - 8 - 16 * count);
	memcpy(at + 8 + 16 * count, &tag, 4);
	memcpy(at + 8 + 16 * count + 4, &size, 4);
	memcpy(at + 8 + 16 * count + 8, &elements, 8);
	count++;
	memcpy(at, &count, 4);
	record->bytes.count += 24;
	memset(at + record->bytes.count - 8, 0, 8);
}

static void
unknown_sections_are_passed_over(void)
{
	struct tcs_object out = {0};
	struct tcs_record record = {0};
	struct tcs_fault fault;

	encode_object(&record);
	add_section(&record, TCS_TAG('N', 'E', 'W', '!'), 4);
	CHECK(!object_decode(&out, &record, &fault));
	CHECK(out.vertices.count == 9);
	object_release(&out);
	record_release(&record);
}

static void
a_section_twice_or_of_another_size_is_refused(void)
{
	struct tcs_object out = {0};
	struct tcs_record record = {0};
	struct tcs_fault fault;

	encode_object(&record);
	add_section(&record, TCS_TAG('T', 'E', 'X', 'T'), 1);
	CHECK(object_decode(&out, &record, &fault) == TCS_BAD_INPUT);
	record.bytes.count = 0;
	if (array_grow(&record.bytes, 8))
		abort();
	memset(record.bytes.at, 0, 8);
	record.bytes.count = 8;
	add_section(&record, TCS_TAG('V', 'E', 'R', 'T'), 8);
	CHECK(object_decode(&out, &record, &fault) == TCS_BAD_INPUT);
	CHECK(strstr(fault.text, "8 bytes, not 24"));
	object_release(&out);
	record_release(&record);
}

/* Decode with one field of the directory's first entry overwritten. */
static enum tcs_status
decode_with(size_t at, uint64_t value, size_t size)
{
	struct tcs_object out = {0};
	struct tcs_record record = {0};
	struct tcs_fault fault;
	enum tcs_status status;

	encode_object(&record);
	memcpy(record.bytes.at + at, &value, size);
	status = object_decode(&out, &record, &fault);
	object_release(&out);
	record_release(&record);
	return status;
}

static void
a_directory_that_does_not_fit_is_refused(void)
{
	CHECK(decode_with(0, UINT32_MAX, 4) == TCS_BAD_INPUT);
	CHECK(decode_with(0, 3, 4) == TCS_BAD_INPUT);
	CHECK(decode_with(4, 1, 4) == TCS_BAD_INPUT);
	CHECK(decode_with(12, 0, 4) == TCS_BAD_INPUT);
	CHECK(decode_with(16, UINT64_MAX, 8) == TCS_BAD_INPUT);
	CHECK(decode_with(16, UINT64_MAX / 24 + 2, 8) == TCS_BAD_INPUT);
	CHECK(decode_with(16, 2, 8) == TCS_BAD_INPUT);
}

static void
a_head_comes_back(void)
{
	struct tcs_head in = {0}, out = {0};
	struct tcs_record record = {0};
	struct tcs_fault fault;

	sample_head(&in);
	CHECK(!head_encode(&in, &record, &fault));
	CHECK(!head_decode(&out, &record, &fault));
	CHECK(out.crs.at[0].epsg == 25832 && out.crs.at[0].epsg_up == -1);
	CHECK(!strcmp(head_text(&out, out.crs.at[0].name), "EPSG:25832"));
	CHECK(out.stages.count == 2);
	CHECK(!strcmp(head_text(&out, out.stages.at[1].program), "other"));
	CHECK(out.stages.at[1].version == out.stages.at[0].version);
	CHECK(out.stages.at[1].arguments == 0);
	CHECK(!head_sign(&out, "third", "2", "-x", &fault));
	CHECK(!head_encode(&out, &record, &fault));
	head_release(&out);
	CHECK(!head_decode(&out, &record, &fault));
	CHECK(out.stages.count == 3);
	CHECK(!strcmp(head_text(&out, out.stages.at[2].arguments), "-x"));
	head_release(&in);
	head_release(&out);
	record_release(&record);
}

static void
a_head_without_one_sound_reference_system_is_refused(void)
{
	struct tcs_head head = {0}, out = {0};
	struct tcs_record record = {0};
	struct tcs_fault fault;

	CHECK(!head_encode(&head, &record, &fault));
	CHECK(head_decode(&out, &record, &fault) == TCS_BAD_INPUT);
	sample_head(&head);
	head.crs.at[0].metres_per_unit = 0;
	CHECK(!head_encode(&head, &record, &fault));
	CHECK(head_decode(&out, &record, &fault) == TCS_BAD_INPUT);
	head.crs.at[0].metres_per_unit = 1;
	head.crs.at[0].kind = 5;
	CHECK(!head_encode(&head, &record, &fault));
	CHECK(head_decode(&out, &record, &fault) == TCS_BAD_INPUT);
	head.crs.at[0].kind = 0;
	head.crs.at[0].origin.y = INFINITY;
	CHECK(!head_encode(&head, &record, &fault));
	CHECK(head_decode(&out, &record, &fault) == TCS_BAD_INPUT);
	head_release(&head);
	head_release(&out);
	record_release(&record);
}

static void
palettes_are_appended_with_text_and_bytes(void)
{
	struct tcs_palette all = {0}, more = {0}, out = {0};
	struct tcs_record record = {0};
	struct tcs_fault fault;

	sample_palette(&more);
	CHECK(!palette_append(&all, &more, &fault));
	CHECK(!palette_append(&all, &more, &fault));
	CHECK(!palette_encode(&all, &record, &fault));
	CHECK(!palette_decode(&out, &record, &fault));
	CHECK(out.images.count == 4 && out.materials.count == 2);
	CHECK(out.images.at[2].first_byte == 5);
	CHECK(out.images.at[2].byte_count == 5);
	CHECK(!memcmp(out.bytes.at + 5, out.bytes.at, 5));
	CHECK(!strcmp(palette_text(&all, all.images.at[2].uri), "brick.png"));
	CHECK(!strcmp(palette_text(&all, all.materials.at[1].id), "red"));
	CHECK(out.images.at[2].uri == out.images.at[0].uri);
	palette_release(&all);
	palette_release(&more);
	palette_release(&out);
	record_release(&record);
}

/* Whether a palette is refused after `spoil`. */
static int
palette_refused(void (*spoil)(struct tcs_palette *))
{
	struct tcs_palette palette = {0}, out = {0};
	struct tcs_record record = {0};
	struct tcs_fault fault;
	enum tcs_status status;

	sample_palette(&palette);
	if (spoil)
		spoil(&palette);
	sample_must(palette_encode(&palette, &record, &fault), &fault);
	status = palette_decode(&out, &record, &fault);
	palette_release(&palette);
	palette_release(&out);
	record_release(&record);
	return status == TCS_BAD_INPUT;
}

static void
spoil_wrap(struct tcs_palette *palette)
{
	palette->images.at[0].wrap = 5;
}

static void
spoil_border(struct tcs_palette *palette)
{
	palette->images.at[1].border[3] = NAN;
}

static void
spoil_first_byte(struct tcs_palette *palette)
{
	palette->images.at[1].first_byte = 4;
}

static void
spoil_byte_count(struct tcs_palette *palette)
{
	palette->images.at[1].byte_count = UINT64_MAX;
}

static void
spoil_bytes(struct tcs_palette *palette)
{
	SAMPLE_PUSH(palette->bytes, (unsigned char)0);
}

static void
spoil_material(struct tcs_palette *palette)
{
	palette->materials.at[0].smooth = 2;
}

static void
spoil_colour(struct tcs_palette *palette)
{
	palette->materials.at[0].specular[2] = -INFINITY;
}

static void
a_palette_that_breaks_a_rule_is_refused(void)
{
	CHECK(!palette_refused(NULL));
	CHECK(palette_refused(spoil_wrap));
	CHECK(palette_refused(spoil_border));
	CHECK(palette_refused(spoil_first_byte));
	CHECK(palette_refused(spoil_byte_count));
	CHECK(palette_refused(spoil_bytes));
	CHECK(palette_refused(spoil_material));
	CHECK(palette_refused(spoil_colour));
}

static const struct check_test tests[] = {
	CHECK_TEST(decoding_gives_back_every_array),
	CHECK_TEST(equal_strings_are_written_once),
	CHECK_TEST(text_that_nothing_names_is_left_out),
	CHECK_TEST(lent_arrays_lie_in_the_record_and_copy_when_they_grow),
	CHECK_TEST(an_object_may_be_encoded_into_the_record_that_lends_it),
	CHECK_TEST(unknown_sections_are_passed_over),
	CHECK_TEST(a_section_twice_or_of_another_size_is_refused),
	CHECK_TEST(a_directory_that_does_not_fit_is_refused),
	CHECK_TEST(a_head_comes_back),
	CHECK_TEST(a_head_without_one_sound_reference_system_is_refused),
	CHECK_TEST(palettes_are_appended_with_text_and_bytes),
	CHECK_TEST(a_palette_that_breaks_a_rule_is_refused),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
