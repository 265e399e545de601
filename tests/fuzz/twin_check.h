/*
 * What must hold of every sound record: encoding is stable, and the text twin
 * gives it back.
 */
#ifndef TESSERA_TWIN_CHECK_H
#define TESSERA_TWIN_CHECK_H

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "parsers/json_build.h"
#include "tcs.h"
#include "writers/json_record.h"

struct twin_check {
	struct json_builder decoded;
	struct json_builder builder;
	struct json_decoder decoder;
	struct json_text text;
	struct tcs_record once;
	struct tcs_record twice;
};

static inline void
twin_check_release(struct twin_check *check)
{
	json_builder_release(&check->decoded);
	json_builder_release(&check->builder);
	json_decoder_release(&check->decoder);
	json_text_release(&check->text);
	record_release(&check->once);
	record_release(&check->twice);
}

/* The text knows one NaN only. */
static inline void
twin_settle_numbers(struct tcs_object *object)
{
	for (size_t i = 0; i < object->attributes.count; i++)
		if (isnan(object->attributes.at[i].number))
			object->attributes.at[i].number = NAN;
}

/* Decode `from` and encode it into `to`; false where it is not sound. */
static inline bool
twin_again(struct twin_check *check, const struct tcs_record *from,
	struct tcs_record *to)
{
	struct tcs_fault fault;

	to->before = from->before;
	switch (from->type) {
	case TCS_HEAD:
		return !head_decode(&check->decoded.head, from, &fault) &&
			!head_encode(&check->decoded.head, to, &fault);
	case TCS_PALETTE:
		return !palette_decode(&check->decoded.palette, from, &fault) &&
			!palette_encode(&check->decoded.palette, to, &fault);
	case TCS_OBJECT:
	case TCS_PROTOTYPE:
		if (object_decode(&check->decoded.object, from, &fault))
			return false;
		twin_settle_numbers(&check->decoded.object);
		return !object_encode(&check->decoded.object,
			(enum tcs_record_type)from->type, to, &fault);
	default:
		return false;
	}
}

static inline void
twin_same(const struct tcs_record *a, const struct tcs_record *b)
{
	if (a->type != b->type || a->bytes.count != b->bytes.count ||
		memcmp(a->bytes.at, b->bytes.at, a->bytes.count) != 0)
		abort();
}

/* Abort unless a record that decodes is stable and its text gives it back. */
static inline void
twin_check(struct twin_check *check, const struct tcs_record *record)
{
	struct tcs_tally claimed;
	struct tcs_fault fault;

	if (!twin_again(check, record, &check->once))
		return;
	if (!twin_again(check, &check->once, &check->twice))
		abort();
	twin_same(&check->once, &check->twice);
	json_text_clear(&check->text);
	if (print_record(&check->text, &check->decoder, &check->once, &fault))
		abort();
	if (json_build_line(&check->builder, check->text.bytes.at,
		    check->text.bytes.count, 1, &check->twice, &claimed,
		    &fault))
		abort();
	twin_same(&check->once, &check->twice);
}

#endif
