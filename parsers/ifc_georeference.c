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

enum { CONTEXT_NORTH = 5 };

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

/* A rigid operation neither turns nor scales. */
static void
operation_read(const struct ifc_file *file, uint32_t operation,
	struct ifc_map_operation *out)
{
	uint32_t crs = ifc_target(file, operation, TARGET_CRS);

	*out = (struct ifc_map_operation){
		.eastings = number_or(file, operation, EASTINGS, 0),
		.northings = number_or(file, operation, NORTHINGS, 0),
		.height = number_or(file, operation, HEIGHT, 0),
		.abscissa = 1,
		.factors = {1, 1, 1},
		.unit = map_unit(file, crs),
		.system = ifc_value(file, crs, 0)};
	if (!ifc_is_kind(file, operation, IFC_MAPCONVERSION))
		return;
	out->abscissa = number_or(file, operation, ABSCISSA, 1);
	out->ordinate = number_or(file, operation, ORDINATE, 0);
	out->scale = number_or(file, operation, SCALE, 0);
	for (int i = 0; i < 3; i++)
		if (ifc_entity_of(file, operation) == IFC_MAPCONVERSIONSCALED)
			out->factors[i] =
				number_or(file, operation, FACTOR_X + i, 1);
}

/* The rows of the matrix, in the units of the operation. */
static void
operation_matrix(const struct ifc_map_operation *operation, double otherwise,
	struct ifc_matrix *out)
{
	double x = operation->abscissa, y = operation->ordinate;
	double scale = operation->scale > 0 ? operation->scale : otherwise;
	double length = hypot(x, y);
	double factors[3];

	if (!(length > 0)) {
		x = length = 1;
		y = 0;
	}
	x /= length;
	y /= length;
	for (int i = 0; i < 3; i++)
		factors[i] = scale * operation->factors[i];
	*out = (struct ifc_matrix){
		{x * factors[0], -y * factors[1], 0, operation->eastings,
			y * factors[0], x * factors[1], 0, operation->northings,
			0, 0, factors[2], operation->height, 0, 0, 0, 1}};
}

void
ifc_georeference_read(
	const struct ifc_model *model, bool local, struct ifc_georeference *out)
{
	uint32_t entity = operation_find(&model->file);
	double length = model->units.length, by;
	struct ifc_map_operation operation;

	*out = (struct ifc_georeference){
		.world = ifc_identity, .metres_per_unit = 1, .is_local = true};
	for (int i = 0; i < 3; i++)
		out->world.at[5 * i] = length;
	if (local)
		return;
	if (entity != STEP_NONE)
		operation_read(&model->file, entity, &operation);
	else if (!ifc_map_properties_read(model, &operation))
		return;
	out->is_local = false;
	out->system = operation.system;
	if (operation.unit > 0)
		out->metres_per_unit = operation.unit;
	/* Without a unit of the map, the operation is in the project's. */
	by = operation.unit > 0 ? 1 : length;
	operation_matrix(&operation,
		operation.unit > 0 ? length / operation.unit : 1, &out->world);
	for (int i = 0; i < 12; i++)
		out->world.at[i] *= by;
}

bool
ifc_true_north(const struct ifc_model *model, double *degrees)
{
	const struct ifc_file *file = &model->file;
	struct step_list contexts = step_instances(file->step,
		step_names_find(&file->step->names,
			"IFCGEOMETRICREPRESENTATIONCONTEXT"));
	struct ifc_map_operation operation;
	struct tcs_point north;

	if (operation_find(file) != STEP_NONE ||
		ifc_map_properties_read(model, &operation))
		return false;
	for (size_t i = 0; i < contexts.count; i++) {
		uint32_t direction =
			ifc_target(file, contexts.at[i], CONTEXT_NORTH);

		if (!ifc_triple(file, direction, &north) ||
			!(hypot(north.x, north.y) > 0))
			continue;
		/* Not -0. */
		*degrees = atan2(north.x, north.y) * 180 / acos(-1) + 0.0;
		return true;
	}
	return false;
}
