#include "ifc_georeference.h"

#include <math.h>

enum {
	TARGET_CRS = 1,
	EASTINGS,
	NORTHINGS,
	HEIGHT,
	ABSCISSA,
	ORDINATE,
	SCALE,
	FACTOR_X
};

static double
number_or(const struct ifc_file *file, uint32_t instance, int position,
	double otherwise)
{
	struct step_value value = ifc_value(file, instance, position);
	double number;

	return step_number(&value, &number) && isfinite(number) ? number
								: otherwise;
}

static uint32_t
operation_find(const struct ifc_file *file)
{
	for (uint32_t i = 0; i < file->step->names.list.count; i++) {
		struct step_list list = step_instances(file->step, (uint16_t)i);

		if (list.count &&
			ifc_is_kind(file, list.at[0], IFC_COORDINATEOPERATION))
			return list.at[0];
	}
	return STEP_NONE;
}

/* The metres of the system's unit; 0 where it names none. */
static double
map_unit(const struct ifc_file *file, uint32_t crs)
{
	int position = ifc_attribute(
		file->version, ifc_entity_of(file, crs), "MapUnit");
	double factor;

	return ifc_unit_factor(file, ifc_target(file, crs, position), &factor)
		? factor
		: 0;
}

/* The rows of the matrix, in the units of the operation. */
static void
operation_matrix(const struct ifc_file *file, uint32_t operation,
	double otherwise, struct ifc_matrix *out)
{
	double x = number_or(file, operation, ABSCISSA, 1);
	double y = number_or(file, operation, ORDINATE, 0);
	double scale = number_or(file, operation, SCALE, otherwise);
	double length = hypot(x, y);
	double factors[3];

	if (!(length > 0)) {
		x = length = 1;
		y = 0;
	}
	if (!(scale > 0))
		scale = otherwise;
	x /= length;
	y /= length;
	for (int i = 0; i < 3; i++)
		factors[i] = scale *
			(ifc_entity_of(file, operation) ==
						IFC_MAPCONVERSIONSCALED
					? number_or(file, operation,
						  FACTOR_X + i, 1)
					: 1);
	*out = (struct ifc_matrix){{x * factors[0], -y * factors[1], 0,
		number_or(file, operation, EASTINGS, 0), y * factors[0],
		x * factors[1], 0, number_or(file, operation, NORTHINGS, 0), 0,
		0, factors[2], number_or(file, operation, HEIGHT, 0), 0, 0, 0,
		1}};
}

void
ifc_georeference_read(const struct ifc_file *file,
	const struct ifc_units *units, bool local, struct ifc_georeference *out)
{
	uint32_t operation = operation_find(file);
	double unit, by;

	*out = (struct ifc_georeference){ifc_identity, 1, STEP_NONE};
	for (int i = 0; i < 3; i++)
		out->world.at[5 * i] = units->length;
	if (local || operation == STEP_NONE)
		return;
	out->crs = ifc_target(file, operation, TARGET_CRS);
	unit = map_unit(file, out->crs);
	if (unit > 0)
		out->metres_per_unit = unit;
	/* Without a unit of the map, the operation is in the project's. */
	by = unit > 0 ? 1 : units->length;
	if (ifc_is_kind(file, operation, IFC_MAPCONVERSION)) {
		operation_matrix(file, operation,
			unit > 0 ? units->length / unit : 1, &out->world);
	} else {
		out->world = ifc_identity;
		for (int i = 0; i < 3; i++)
			out->world.at[5 * i] =
				unit > 0 ? units->length / unit : 1;
		out->world.at[3] = number_or(file, operation, EASTINGS, 0);
		out->world.at[7] = number_or(file, operation, NORTHINGS, 0);
		out->world.at[11] = number_or(file, operation, HEIGHT, 0);
	}
	for (int i = 0; i < 12; i++)
		out->world.at[i] *= by;
}
