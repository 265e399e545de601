#include <math.h>

#include "ifc_curve.h"
#include "ifc_cut.h"

enum { OPERATOR, FIRST, SECOND };

enum { HALF_PLANE, HALF_AGREES, HALF_POSITION, HALF_BOUNDARY };

enum { MOST_STEPS = 1 << 14 };

/* A second operand, and what is to be done with it. */
struct step {
	uint32_t result; /* the IfcBooleanResult */
	uint32_t operand;
	enum solid_operation operation;
};

/* One boolean result: its chain of first operands unrolled. */
struct boolean {
	struct ifc_shaper *shaper;
	TCS_ARRAY(struct step) steps; /* the last to be done first */
	struct ifc_cut cut;
	struct ifc_body operand;
	bool open; /* the host is no closed solid */
};

static void
boolean_release(struct boolean *boolean)
{
	array_release(&boolean->steps);
	ifc_cut_release(&boolean->cut);
	ifc_body_release(&boolean->operand);
}

/* ---- half-spaces --------------------------------------------------------- */

/*
 * The half-space as what it takes away: the side its plane's normal points
 * to. Material lies behind the plane when AgreementFlag is true.
 */
static enum ifc_outcome
half_space_read(
	struct ifc_shaper *shaper, uint32_t half, struct solid_half_space *out)
{
	const struct ifc_file *file = shaper->file;
	struct step_value agrees = ifc_value(file, half, HALF_AGREES);
	uint32_t plane = ifc_target(file, half, HALF_PLANE);
	double sign = step_is(&agrees, "F") ? 1 : -1;
	struct ifc_matrix at;

	if (ifc_entity_of(file, plane) != IFC_PLANE)
		return ifc_refuse(shaper, half, "bounded by no plane");
	if (!ifc_axes(file, ifc_target(file, plane, 0), &at))
		return ifc_refuse(shaper, half, "a plane has no position");
	*out = (struct solid_half_space){{at.at[3], at.at[7], at.at[11]},
		{sign * at.at[2], sign * at.at[6], sign * at.at[10]}, 0};
	return IFC_SHAPED;
}

static void
half_space_turn(struct solid_half_space *half)
{
	half->normal = (struct tcs_point){
		-half->normal.x, -half->normal.y, -half->normal.z};
}

/* How far the points reach along the z axis of a matrix, and how far apart. */
static void
reach_along(const struct solid *solid, const struct ifc_matrix *axes,
	double *low, double *high)
{
	const double *m = axes->at;

	*low = HUGE_VAL;
	*high = -HUGE_VAL;
	for (size_t i = 0; i < solid->points.count; i++) {
		struct tcs_point p = solid->points.at[i];
		double z = (p.x - m[3]) * m[2] + (p.y - m[7]) * m[6] +
			(p.z - m[11]) * m[10];

		*low = fmin(*low, z);
		*high = fmax(*high, z);
	}
}

/* A prism over the boundary, beyond the host on both sides. */
static enum ifc_outcome
boundary_prism(struct boolean *boolean, uint32_t half, struct solid *out)
{
	struct ifc_shaper *shaper = boolean->shaper;
	const struct ifc_file *file = shaper->file;
	struct ifc_points ring = {.count = 0};
	struct ifc_matrix at;
	enum ifc_outcome outcome;
	struct tcs_fault fault;
	double low, high, margin;
	uint32_t count;

	if (!ifc_axes(file, ifc_target(file, half, HALF_POSITION), &at))
		return ifc_refuse(shaper, half, "a boundary has no position");
	reach_along(&boolean->cut.host, &at, &low, &high);
	margin = 1 / shaper->unit + (high - low);
	outcome = ifc_curve_ring(
		shaper, ifc_target(file, half, HALF_BOUNDARY), &ring);
	if (!outcome && ring.count < 3)
		outcome = ifc_refuse(shaper, half, "a boundary has no area");
	for (size_t i = 0; i < ring.count; i++)
		ring.at[i] = ifc_transform(&at,
			(struct tcs_point){
				ring.at[i].x, ring.at[i].y, low - margin});
	count = (uint32_t)ring.count;
	high += 2 * margin - low;
	if (!outcome &&
		solid_add_prism(out, ring.at, &count, 1,
			(struct tcs_point){at.at[2] * high, at.at[6] * high,
				at.at[10] * high},
			0, &fault))
		outcome = IFC_NO_MEMORY;
	array_release(&ring);
	return outcome;
}

/* The bounded half-space as a solid that is larger than the host. */
static enum ifc_outcome
bounded_tool(struct boolean *boolean, const struct step *step)
{
	struct solid_half_space *half;
	struct ifc_cut cut = {.operation = SOLID_DIFFERENCE};
	enum ifc_outcome outcome;
	bool open;

	if (array_grow(&cut.half_spaces, 1))
		return IFC_NO_MEMORY;
	half = cut.half_spaces.at + cut.half_spaces.count++;
	outcome = half_space_read(boolean->shaper, step->operand, half);
	half_space_turn(half);
	if (!outcome)
		outcome = boundary_prism(boolean, step->operand, &cut.host);
	if (!outcome)
		outcome = ifc_cut_run(
			boolean->shaper, step->operand, &cut, &open);
	if (!outcome && cut.host.faces.count) {
		struct solid *tool = ifc_cut_tool(&boolean->cut);

		if (!tool)
			outcome = IFC_NO_MEMORY;
		else
			*tool = cut.host;
		if (tool)
			cut.host = (struct solid){.faces = {0}};
	}
	ifc_cut_release(&cut);
	return outcome;
}

static enum ifc_outcome
half_space_add(struct boolean *boolean, const struct step *step)
{
	struct solid_half_space half;
	enum ifc_outcome outcome =
		half_space_read(boolean->shaper, step->operand, &half);

	if (outcome)
		return outcome;
	if (step->operation == SOLID_UNION)
		return ifc_refuse(boolean->shaper, step->operand,
			"a half-space is without end");
	if (step->operation == SOLID_INTERSECTION)
		half_space_turn(&half);
	if (array_grow(&boolean->cut.half_spaces, 1))
		return IFC_NO_MEMORY;
	boolean->cut.half_spaces.at[boolean->cut.half_spaces.count++] = half;
	return IFC_SHAPED;
}

/* ---- operands ------------------------------------------------------------ */

/* All parts of an item together. */
static enum ifc_outcome
operand_solid(struct boolean *boolean, uint32_t item, struct solid *out)
{
	enum ifc_outcome outcome;

	ifc_body_clear(&boolean->operand);
	outcome = ifc_item_body(boolean->shaper, item, &boolean->operand);
	return outcome ? outcome
		       : ifc_solid_add(out, &boolean->operand.faces, 0,
				 boolean->operand.faces.faces.count);
}

static enum ifc_outcome
operand_add(struct boolean *boolean, const struct step *step)
{
	enum ifc_entity entity =
		ifc_entity_of(boolean->shaper->file, step->operand);
	struct solid *tool;

	if (entity == IFC_POLYGONALBOUNDEDHALFSPACE)
		return bounded_tool(boolean, step);
	if (ifc_is_kind(
		    boolean->shaper->file, step->operand, IFC_HALFSPACESOLID))
		return half_space_add(boolean, step);
	tool = ifc_cut_tool(&boolean->cut);
	return tool ? operand_solid(boolean, step->operand, tool)
		    : IFC_NO_MEMORY;
}

/* ---- the chain ----------------------------------------------------------- */

static bool
operation_read(
	const struct ifc_file *file, uint32_t item, enum solid_operation *out)
{
	struct step_value value = ifc_value(file, item, OPERATOR);

	if (step_is(&value, "DIFFERENCE"))
		*out = SOLID_DIFFERENCE;
	else if (step_is(&value, "INTERSECTION"))
		*out = SOLID_INTERSECTION;
	else if (step_is(&value, "UNION"))
		*out = SOLID_UNION;
	else
		return false;
	return true;
}

/* Unroll the first operands; *root is the innermost. */
static enum ifc_outcome
steps_read(struct boolean *boolean, uint32_t item, uint32_t *root)
{
	const struct ifc_file *file = boolean->shaper->file;

	while (ifc_is_kind(file, item, IFC_BOOLEANRESULT)) {
		struct step step = {
			item, ifc_target(file, item, SECOND), SOLID_UNION};

		if (!operation_read(file, item, &step.operation))
			return ifc_refuse(
				boolean->shaper, item, "no such operation");
		if (boolean->steps.count == MOST_STEPS)
			return ifc_refuse(boolean->shaper, item,
				"nested too deep, or in itself");
		if (array_grow(&boolean->steps, 1))
			return IFC_NO_MEMORY;
		boolean->steps.at[boolean->steps.count++] = step;
		item = ifc_target(file, item, FIRST);
	}
	*root = item;
	return IFC_SHAPED;
}

/* How many steps from the last one can be done at once. */
static size_t
steps_together(const struct boolean *boolean)
{
	const struct step *last = boolean->steps.at + boolean->steps.count - 1;
	size_t count = 1;

	if (last->operation == SOLID_INTERSECTION)
		return 1;
	while (count < boolean->steps.count &&
		last[-(ptrdiff_t)count].operation == last->operation)
		count++;
	return count;
}

static enum ifc_outcome
steps_run(struct boolean *boolean)
{
	enum ifc_outcome outcome = IFC_SHAPED;

	while (boolean->steps.count && !outcome) {
		size_t count = steps_together(boolean);
		struct step step;

		ifc_cut_clear(&boolean->cut);
		do {
			step = boolean->steps.at[--boolean->steps.count];
			boolean->cut.operation = step.operation;
			outcome = operand_add(boolean, &step);
		} while (--count && !outcome);
		/* Without tools, nothing but half-spaces is to be done. */
		if (!boolean->cut.tools.count)
			boolean->cut.operation = SOLID_DIFFERENCE;
		if (!outcome)
			outcome = ifc_cut_run(boolean->shaper, step.result,
				&boolean->cut, &boolean->open);
	}
	return outcome;
}

enum ifc_outcome
ifc_boolean(struct ifc_shaper *shaper, uint32_t item, struct ifc_body *out)
{
	struct boolean boolean = {.shaper = shaper};
	enum ifc_outcome outcome;
	uint32_t root = STEP_NONE;

	outcome = steps_read(&boolean, item, &root);
	if (!outcome)
		outcome = operand_solid(&boolean, root, &boolean.cut.host);
	if (!outcome)
		outcome = steps_run(&boolean);
	if (!outcome && boolean.cut.host.faces.count)
		outcome = ifc_part_begin(out,
			boolean.open ? IFC_PART_SURFACE : IFC_PART_SOLID, item);
	if (!outcome)
		outcome =
			ifc_solid_faces(shaper, &boolean.cut.host, &out->faces);
	boolean_release(&boolean);
	return outcome;
}
