#include "json_record.h"

#include "json_object.h"
#include "tcs_codec.h"

void
json_decoder_release(struct json_decoder *decoder)
{
	head_release(&decoder->head);
	palette_release(&decoder->palette);
	object_release(&decoder->object);
}

static void
print_begin(struct json_text *json, const char *kind)
{
	print_raw(json, "{\"record\":");
	print_string(json, kind);
}

/* ---- head, palette, end ---------------------------------------------- */

static void
print_models(struct json_text *json, const struct tcs_head *head)
{
	print_key(json, "models");
	print_raw(json, "[");
	for (size_t i = 0; i < head->models.count; i++) {
		print_raw(json, i ? ",{" : "{");
		print_fields(json, &fields_model, &head->models.at[i],
			head->text.at);
		print_raw(json, "}");
	}
	print_raw(json, "]");
}

static void
print_head(struct json_text *json, const struct tcs_head *head)
{
	print_begin(json, "head");
	print_key(json, "crs");
	print_raw(json, "{");
	print_fields(json, &fields_crs, head->crs.at, head->text.at);
	print_raw(json, "}");
	print_key(json, "sources");
	print_raw(json, "[");
	for (size_t i = 0; i < head->sources.count; i++) {
		print_raw(json, i ? ",{" : "{");
		print_fields(json, &fields_source, &head->sources.at[i],
			head->text.at);
		print_raw(json, "}");
	}
	print_raw(json, "]");
	if (head->models.count)
		print_models(json, head);
	print_key(json, "stages");
	print_raw(json, "[");
	for (size_t i = 0; i < head->stages.count; i++) {
		print_raw(json, i ? ",{" : "{");
		print_fields(json, &fields_stage, &head->stages.at[i],
			head->text.at);
		print_raw(json, "}");
	}
	print_raw(json, "]}\n");
}

static void
print_palette(struct json_text *json, const struct tcs_palette *palette)
{
	print_begin(json, "palette");
	print_key(json, "images");
	print_raw(json, "[");
	for (size_t i = 0; i < palette->images.count; i++) {
		const struct tcs_image *image = &palette->images.at[i];

		print_raw(json, i ? ",{" : "{");
		print_fields(json, &fields_image, image, palette->text.at);
		if (image->byte_count) {
			print_key(json, "bytes");
			print_bytes(json, palette->bytes.at + image->first_byte,
				image->byte_count);
		}
		print_raw(json, "}");
	}
	print_raw(json, "]");
	print_key(json, "materials");
	print_raw(json, "[");
	for (size_t i = 0; i < palette->materials.count; i++) {
		print_raw(json, i ? ",{" : "{");
		print_fields(json, &fields_material, &palette->materials.at[i],
			palette->text.at);
		print_raw(json, "}");
	}
	print_raw(json, "]}\n");
}

static void
print_end(struct json_text *json, const struct tcs_tally *tally)
{
	print_begin(json, "end");
	print_fields(json, &fields_tally, tally, NULL);
	print_raw(json, "}\n");
}

/* ---- what is not known ----------------------------------------------- */

static const struct tcs_layout *
layout_of(uint32_t type)
{
	switch (type) {
	case TCS_HEAD:
		return &layout_head;
	case TCS_PALETTE:
		return &layout_palette;
	case TCS_OBJECT:
	case TCS_PROTOTYPE:
		return &layout_object;
	default:
		return NULL;
	}
}

/* Whether a record holds what only its bytes can tell. */
static enum tcs_status
has_unknown(
	const struct tcs_record *record, bool *unknown, struct tcs_fault *fault)
{
	const struct tcs_layout *layout = layout_of(record->type);
	struct section_walk walk;
	struct section section;
	enum tcs_status status;
	bool done;

	*unknown = !layout;
	if (!layout)
		return TCS_OK;
	status = sections_begin(&walk, record, fault);
	while (!status) {
		status = sections_next(&walk, &section, &done, fault);
		if (status || done)
			break;
		if (!layout_column(layout, section.tag))
			*unknown = true;
	}
	return status;
}

static void
print_other(struct json_text *json, const struct tcs_record *record)
{
	char name[5] = {0};
	bool printable = true;

	for (int i = 0; i < 4; i++) {
		name[i] = (char)(record->type >> 8 * i & 0xff);
		printable = printable && name[i] >= ' ' && name[i] <= '~';
	}
	print_begin(json, "other");
	print_key(json, "type");
	if (printable)
		print_string(json, name);
	else
		print_unsigned(json, record->type);
	print_key(json, "bytes");
	print_bytes(json, record->bytes.at, record->bytes.count);
	print_raw(json, "}\n");
}

/* ---- records --------------------------------------------------------- */

static enum tcs_status
print_known(struct json_text *json, struct json_decoder *decoder,
	const struct tcs_record *record, struct tcs_fault *fault)
{
	enum tcs_status status;

	switch (record->type) {
	case TCS_HEAD:
		status = head_decode(&decoder->head, record, fault);
		if (!status)
			print_head(json, &decoder->head);
		return status;
	case TCS_PALETTE:
		status = palette_decode(&decoder->palette, record, fault);
		if (!status)
			print_palette(json, &decoder->palette);
		return status;
	default:
		status = object_decode(&decoder->object, record, fault);
		if (status)
			return status;
		print_begin(json,
			record->type == TCS_OBJECT ? "object" : "prototype");
		print_object(json, &decoder->object);
		print_raw(json, "}\n");
		return TCS_OK;
	}
}

enum tcs_status
print_record(struct json_text *json, struct json_decoder *decoder,
	const struct tcs_record *record, struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;
	bool unknown;

	if (record->type == TCS_END) {
		print_end(json, &record->before);
		return json_text_status(json, fault);
	}
	status = has_unknown(record, &unknown, fault);
	if (!status && unknown)
		print_other(json, record);
	else if (!status)
		status = print_known(json, decoder, record, fault);
	return status ? status : json_text_status(json, fault);
}
