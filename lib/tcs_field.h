/*
 * The fields of every element of a stream by name: what the text twin prints
 * and reads back, from one table, so that one undoes the other.
 */
#ifndef TESSERA_TCS_FIELD_H
#define TESSERA_TCS_FIELD_H

#include <stddef.h>
#include <stdint.h>

#include "tcs.h"

/* What a field is, and for which value its name is left out of the text. */
enum tcs_field_type {
	FIELD_TEXT, /* tcs_text; out when absent */
	FIELD_CLASS, /* uint16_t: a label; never out */
	FIELD_INDEX, /* uint32_t; never out */
	FIELD_LINK, /* uint32_t; out when TCS_NONE */
	FIELD_COUNT, /* uint32_t; out when 0 */
	FIELD_INTEGER, /* int32_t; out when 0 */
	FIELD_YES, /* uint32_t: 0 or 1; out when 0 */
	FIELD_LOD, /* out when TCS_LOD_NONE */
	FIELD_NAMED, /* one of `names`; never out */
	FIELD_FLAGS, /* bits of `names`, lowest first; out when 0 */
	FIELD_DOUBLE, /* out when all of them are 0 */
	FIELD_FLOAT, /* out when all of them are 0 */
	FIELD_RUN, /* follows from the order of things: never in the text */
};

struct tcs_field {
	const char *name;
	enum tcs_field_type type;
	size_t at; /* where in the element */
	size_t size; /* bytes of one value */
	size_t count; /* values; 1, or more for DOUBLE and FLOAT */
	const char *const *names; /* NAMED, FLAGS: up to a NULL */
};

/* The fields of one kind of element, all of them, as the text orders them. */
struct tcs_fields {
	const struct tcs_field *at;
	size_t count;
	size_t size; /* of the element */
	uint32_t tag; /* of its section */
};

extern const struct tcs_fields fields_feature;
extern const struct tcs_fields fields_attribute;
extern const struct tcs_fields fields_relation;
extern const struct tcs_fields fields_geometry;
extern const struct tcs_fields fields_shell;
extern const struct tcs_fields fields_polygon;
extern const struct tcs_fields fields_ring;
extern const struct tcs_fields fields_paint;
extern const struct tcs_fields fields_instance;
extern const struct tcs_fields fields_crs;
extern const struct tcs_fields fields_source;
extern const struct tcs_fields fields_model;
extern const struct tcs_fields fields_stage;
extern const struct tcs_fields fields_image;
extern const struct tcs_fields fields_material;
extern const struct tcs_fields fields_tally;

/* The value of a field of up to 8 bytes, zero-extended. */
uint64_t field_get(const struct tcs_field *field, const void *element);
void field_set(const struct tcs_field *field, void *element, uint64_t value);

/* An element as it is when the text says nothing. */
void fields_default(const struct tcs_fields *fields, void *element);

/* The field called `name`; NULL for none, and for runs. */
const struct tcs_field *fields_find(
	const struct tcs_fields *fields, const char *name);

#endif
