#include <math.h>
#include <string.h>

#include "tcs.h"
#include "tcs_codec.h"

const char *
head_text(const struct tcs_head *head, tcs_text text)
{
	return text ? head->text.at + text : "";
}

void
head_release(struct tcs_head *head)
{
	array_release(&head->text);
	array_release(&head->crs);
	array_release(&head->sources);
	array_release(&head->models);
	array_release(&head->stages);
}

enum tcs_status
head_sign(struct tcs_head *head, const char *program, const char *version,
	const char *arguments, struct tcs_fault *fault)
{
	const char *strings[3] = {program, version, arguments};
	tcs_text texts[3];

	for (int i = 0; i < 3; i++) {
		enum tcs_status status = text_append(
			head, strings[i], strlen(strings[i]), &texts[i], fault);
		if (status)
			return status;
	}
	if (array_grow(&head->stages, 1))
		return fault_memory(fault);
	head->stages.at[head->stages.count++] =
		(struct tcs_stage){texts[0], texts[1], texts[2]};
	return TCS_OK;
}

static bool
point_is_finite(const struct tcs_point *point)
{
	return isfinite(point->x) && isfinite(point->y) && isfinite(point->z);
}

static bool
crs_is_sound(const struct tcs_crs *crs)
{
	return isfinite(crs->metres_per_unit) && crs->metres_per_unit > 0 &&
		isfinite(crs->metres_per_unit_up) &&
		crs->metres_per_unit_up > 0 && point_is_finite(&crs->origin) &&
		point_is_finite(&crs->lower) && point_is_finite(&crs->upper) &&
		crs->kind <= TCS_CRS_LOCAL;
}

enum tcs_status
head_decode(struct tcs_head *out, const struct tcs_record *record,
	struct tcs_fault *fault)
{
	enum tcs_status status =
		record_decode(out, &layout_head, record, fault);

	if (status)
		return status;
	if (out->crs.count != 1)
		return fault_set(fault, TCS_BAD_INPUT, record->at,
			"the head has %zu reference systems, not one",
			out->crs.count);
	if (!crs_is_sound(out->crs.at))
		return fault_set(fault, TCS_BAD_INPUT, record->at,
			"the head's reference system has a value out of range");
	return TCS_OK;
}

enum tcs_status
head_encode(const struct tcs_head *head, struct tcs_record *record,
	struct tcs_fault *fault)
{
	record->type = TCS_HEAD;
	return record_encode(head, &layout_head, record, fault);
}
