#include "ifc_placement.h"

#include <math.h>

/* Parts of unit vectors below this are no direction any more. */
static const double NO_DIRECTION = 1e-9;

const struct ifc_matrix ifc_identity = {
	{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}};

static const struct tcs_point axis_x = {1, 0, 0};
static const struct tcs_point axis_y = {0, 1, 0};
static const struct tcs_point axis_z = {0, 0, 1};

struct ifc_matrix
ifc_multiply(const struct ifc_matrix *outer, const struct ifc_matrix *inner)
{
	struct ifc_matrix out;

	for (int row = 0; row < 4; row++) {
		for (int column = 0; column < 4; column++) {
			double sum = 0;

			for (int i = 0; i < 4; i++)
				sum += outer->at[4 * row + i] *
					inner->at[4 * i + column];
			out.at[4 * row + column] = sum;
		}
	}
	return out;
}

double
ifc_determinant(const struct ifc_matrix *matrix)
{
	const double *m = matrix->at;

	return m[0] * (m[5] * m[10] - m[6] * m[9]) -
		m[1] * (m[4] * m[10] - m[6] * m[8]) +
		m[2] * (m[4] * m[9] - m[5] * m[8]);
}

struct tcs_point
ifc_transform(const struct ifc_matrix *matrix, struct tcs_point point)
{
	const double *m = matrix->at;

	return (struct tcs_point){
		m[0] * point.x + m[1] * point.y + m[2] * point.z + m[3],
		m[4] * point.x + m[5] * point.y + m[6] * point.z + m[7],
		m[8] * point.x + m[9] * point.y + m[10] * point.z + m[11]};
}

bool
ifc_triple(
	const struct ifc_file *file, uint32_t instance, struct tcs_point *out)
{
	enum ifc_entity entity = ifc_entity_of(file, instance);
	struct step_value list;
	double numbers[4] = {0};
	size_t count;

	if (entity != IFC_CARTESIANPOINT && entity != IFC_DIRECTION)
		return false;
	list = ifc_value(file, instance, 0);
	if (list.kind != STEP_LIST)
		return false;
	count = step_numbers(&list.list, numbers, 4);
	if (list.list.state != STEP_OVER || count < 2 || count > 3)
		return false;
	*out = (struct tcs_point){numbers[0], numbers[1], numbers[2]};
	return true;
}

/* ---- directions ---------------------------------------------------------- */

static double
dot(struct tcs_point a, struct tcs_point b)
{
	return a.x * b.x + a.y * b.y + a.z * b.z;
}

static struct tcs_point
cross(struct tcs_point a, struct tcs_point b)
{
	return (struct tcs_point){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z,
		a.x * b.y - a.y * b.x};
}

static struct tcs_point
scaled(struct tcs_point a, double factor)
{
	return (struct tcs_point){a.x * factor, a.y * factor, a.z * factor};
}

/* Whatever its size, without overflow; false for one of no length. */
static bool
normalise(struct tcs_point *a)
{
	double largest = fmax(fabs(a->x), fmax(fabs(a->y), fabs(a->z)));

	if (!(largest > 0) || !isfinite(largest))
		return false;
	*a = scaled(*a, 1 / largest);
	if (!isfinite(a->x) || !isfinite(a->y) || !isfinite(a->z))
		return false;
	*a = scaled(*a, 1 / sqrt(dot(*a, *a)));
	return true;
}

/* Take out of `a` what lies along the unit vector `along`, and normalise. */
static bool
project_off(struct tcs_point *a, struct tcs_point along)
{
	double part = dot(*a, along);
	struct tcs_point off = {a->x - part * along.x, a->y - part * along.y,
		a->z - part * along.z};

	if (dot(off, off) < NO_DIRECTION * NO_DIRECTION || !normalise(&off))
		return false;
	*a = off;
	return true;
}

/* The unit vector of a direction; false leaves `out` as it is. */
static bool
direction_read(
	const struct ifc_file *file, uint32_t instance, struct tcs_point *out)
{
	struct tcs_point read;

	if (ifc_entity_of(file, instance) != IFC_DIRECTION ||
		!ifc_triple(file, instance, &read) || !normalise(&read))
		return false;
	*out = read;
	return true;
}

/* A unit vector square to `z`: from `wish`, else from the x or y axis. */
static struct tcs_point
square_to(struct tcs_point z, struct tcs_point wish)
{
	struct tcs_point x = wish;

	if (project_off(&x, z))
		return x;
	x = axis_x;
	if (project_off(&x, z))
		return x;
	x = axis_y;
	project_off(&x, z);
	return x;
}

static struct ifc_matrix
matrix_of(struct tcs_point x, struct tcs_point y, struct tcs_point z,
	struct tcs_point origin)
{
	return (struct ifc_matrix){{x.x, y.x, z.x, origin.x, x.y, y.y, z.y,
		origin.y, x.z, y.z, z.z, origin.z, 0, 0, 0, 1}};
}

/* ---- placements and operators -------------------------------------------- */

bool
ifc_axes(const struct ifc_file *file, uint32_t instance, struct ifc_matrix *out)
{
	struct tcs_point x = axis_x, z = axis_z, origin;
	uint32_t point = ifc_target(file, instance, 0);

	switch (ifc_entity_of(file, instance)) {
	case IFC_AXIS2PLACEMENT3D:
		direction_read(file, ifc_target(file, instance, 1), &z);
		direction_read(file, ifc_target(file, instance, 2), &x);
		break;
	case IFC_AXIS2PLACEMENT2D:
		direction_read(file, ifc_target(file, instance, 1), &x);
		x.z = 0;
		break;
	case IFC_AXIS1PLACEMENT:
		direction_read(file, ifc_target(file, instance, 1), &z);
		break;
	default:
		return false;
	}
	if (ifc_entity_of(file, point) != IFC_CARTESIANPOINT ||
		!ifc_triple(file, point, &origin))
		return false;
	x = square_to(z, x);
	*out = matrix_of(x, cross(z, x), z, origin);
	return true;
}

/* The scale at a position; `otherwise` where none is given. */
static double
scale_read(const struct ifc_file *file, uint32_t instance, int position,
	double otherwise)
{
	struct step_value value = ifc_value(file, instance, position);
	double scale;

	return step_number(&value, &scale) ? scale : otherwise;
}

/* Two axes in the plane: the second one says only on which side it is. */
static void
plane_axes(const struct ifc_file *file, uint32_t instance, struct tcs_point *x,
	struct tcs_point *y)
{
	struct tcs_point wish;
	bool given = direction_read(file, ifc_target(file, instance, 0), x);

	x->z = 0;
	*x = square_to(axis_z, *x);
	*y = cross(axis_z, *x);
	if (!direction_read(file, ifc_target(file, instance, 1), &wish))
		return;
	if (!given) {
		wish.z = 0;
		wish = square_to(axis_z, wish);
		*x = cross(wish, axis_z);
		*y = wish;
	} else if (dot(wish, *y) < 0) {
		*y = scaled(*y, -1);
	}
}

static void
space_axes(const struct ifc_file *file, uint32_t instance, struct tcs_point *x,
	struct tcs_point *y, struct tcs_point *z)
{
	struct tcs_point wish;

	direction_read(file, ifc_target(file, instance, 4), z);
	direction_read(file, ifc_target(file, instance, 0), x);
	*x = square_to(*z, *x);
	*y = cross(*z, *x);
	if (direction_read(file, ifc_target(file, instance, 1), &wish) &&
		dot(wish, *y) < 0)
		*y = scaled(*y, -1);
}

bool
ifc_operator(
	const struct ifc_file *file, uint32_t instance, struct ifc_matrix *out)
{
	struct tcs_point x = axis_x, y = axis_y, z = axis_z, origin;
	enum ifc_entity entity = ifc_entity_of(file, instance);
	double sx = scale_read(file, instance, 3, 1), sy = sx, sz = sx;
	uint32_t point = ifc_target(file, instance, 2);

	if (ifc_entity_of(file, point) != IFC_CARTESIANPOINT ||
		!ifc_triple(file, point, &origin))
		return false;
	if (ifc_is(file->version, entity,
		    IFC_CARTESIANTRANSFORMATIONOPERATOR3D)) {
		space_axes(file, instance, &x, &y, &z);
		if (entity == IFC_CARTESIANTRANSFORMATIONOPERATOR3DNONUNIFORM) {
			sy = scale_read(file, instance, 5, sx);
			sz = scale_read(file, instance, 6, sx);
		}
	} else if (ifc_is(file->version, entity,
			   IFC_CARTESIANTRANSFORMATIONOPERATOR2D)) {
		plane_axes(file, instance, &x, &y);
		if (entity == IFC_CARTESIANTRANSFORMATIONOPERATOR2DNONUNIFORM)
			sy = scale_read(file, instance, 4, sx);
	} else {
		return false;
	}
	*out = matrix_of(scaled(x, sx), scaled(y, sy), scaled(z, sz), origin);
	return sx != 0 && sy != 0 && sz != 0;
}
