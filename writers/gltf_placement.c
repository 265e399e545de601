#include "gltf_placement.h"

#include <float.h>
#include <math.h>

/* Cosines up to this count as right angles. */
#define SQUARE 1e-6

static double
dot(const double *a, const double *b)
{
	return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* What the frame does to a difference of two points. */
static struct tcs_point
frame_turn(const struct frame *frame, struct tcs_point by)
{
	const double *m = frame->turn;
	struct tcs_point at = {by.x * frame->scale[0], by.y * frame->scale[1],
		by.z * frame->scale[2]};

	if (frame->kind == TCS_CRS_GEOGRAPHIC)
		return by;
	if (frame->kind != TCS_CRS_GEOCENTRIC)
		return at;
	return (struct tcs_point){m[0] * at.x + m[1] * at.y + m[2] * at.z,
		m[3] * at.x + m[4] * at.y + m[5] * at.z,
		m[6] * at.x + m[7] * at.y + m[8] * at.z};
}

static void
set_column(double column[4], struct tcs_point at, double last)
{
	column[0] = at.x;
	column[1] = at.y;
	column[2] = at.z;
	column[3] = last;
}

static bool
is_rigid(const double matrix[16])
{
	double lengths[3];

	for (int i = 0; i < 16; i++)
		if (!(fabs(matrix[i]) <= FLT_MAX))
			return false;
	for (int i = 0; i < 3; i++) {
		lengths[i] = sqrt(dot(matrix + 4 * i, matrix + 4 * i));
		if (!(lengths[i] >= FLT_MIN))
			return false;
	}
	for (int i = 0; i < 3; i++) {
		int k = (i + 1) % 3;

		if (fabs(dot(matrix + 4 * i, matrix + 4 * k)) >
			SQUARE * lengths[i] * lengths[k])
			return false;
	}
	return true;
}

bool
placement_matrix(double matrix[16], const struct frame *frame,
	const struct tcs_instance *instance)
{
	const double *m = instance->matrix;
	struct tcs_point by = {m[3], m[7], m[11]}, at;

	for (int i = 0; i < 3; i++)
		set_column(matrix + 4 * i,
			frame_turn(frame,
				(struct tcs_point){m[i], m[4 + i], m[8 + i]}),
			0);
	at = frame_to_local(frame, instance->anchor);
	by = frame_turn(frame, by);
	set_column(matrix + 12,
		(struct tcs_point){at.x + by.x, at.y + by.y, at.z + by.z}, 1);
	return is_rigid(matrix);
}

/* From a rotation by columns; the largest part first, so as not to cancel. */
static void
make_quaternion(float out[4], double r[3][3])
{
	double trace = r[0][0] + r[1][1] + r[2][2];
	double q[4], length;
	int i = 0, j, k;

	if (trace > 0) {
		q[3] = 1 + trace;
		q[0] = r[1][2] - r[2][1];
		q[1] = r[2][0] - r[0][2];
		q[2] = r[0][1] - r[1][0];
	} else {
		i = r[1][1] > r[0][0];
		i = r[2][2] > r[i][i] ? 2 : i;
		j = (i + 1) % 3;
		k = (i + 2) % 3;
		q[i] = 1 + r[i][i] - r[j][j] - r[k][k];
		q[j] = r[i][j] + r[j][i];
		q[k] = r[i][k] + r[k][i];
		q[3] = r[j][k] - r[k][j];
	}
	length = sqrt(dot(q, q) + q[3] * q[3]);
	for (i = 0; i < 4; i++)
		out[i] = (float)(q[i] / length);
}

static bool
mirrors(const double *m)
{
	return m[0] * (m[5] * m[10] - m[6] * m[9]) -
		m[4] * (m[1] * m[10] - m[2] * m[9]) +
		m[8] * (m[1] * m[6] - m[2] * m[5]) <
		0;
}

struct placement
placement_split(const double matrix[16])
{
	struct placement out;
	double columns[3][3];

	for (int i = 0; i < 3; i++) {
		const double *from = matrix + 4 * i;
		double length = sqrt(dot(from, from));

		if (i == 0 && mirrors(matrix))
			length = -length;
		for (int k = 0; k < 3; k++)
			columns[i][k] = from[k] / length;
		out.scale[i] = (float)length;
		out.translation[i] = (float)matrix[12 + i];
	}
	make_quaternion(out.rotation, columns);
	return out;
}
