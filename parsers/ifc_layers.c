#include "ifc_layers.h"

#include <math.h>

enum { FOR_SET, DIRECTION, SENSE, OFFSET };

enum { LAYER_MATERIAL, LAYER_THICKNESS };

enum { MOST_LAYERS = 64 };

/* How far a body may reach beyond its layers, in metres. */
static const double SLACK = 1e-3;

/* From the first layer's outside to the last one's, along an axis. */
struct layers {
	int axis; /* 0 to 2 */
	size_t count;
	double bounds[MOST_LAYERS + 1]; /* rising or falling */
	uint32_t paints[MOST_LAYERS];
};

/* ---- which --------------------------------------------------------------- */

static uint32_t
usage_find(const struct ifc_model *model, uint32_t product)
{
	size_t count;
	const struct ifc_said *said = ifc_links_find(
		&model->links, product, IFC_SAYS_MATERIAL, &count);

	for (size_t i = 0; i < count; i++)
		if (ifc_entity_of(&model->file, said[i].target) ==
			IFC_MATERIALLAYERSETUSAGE)
			return said[i].target;
	return STEP_NONE;
}

/* Append a layer; one without thickness is none. */
static bool
layer_read(const struct ifc_model *model, uint32_t layer, double sense,
	struct layers *out)
{
	struct step_value value =
		ifc_value(&model->file, layer, LAYER_THICKNESS);
	double thickness;

	if (!ifc_is_kind(&model->file, layer, IFC_MATERIALLAYER) ||
		!step_number(&value, &thickness) || !(thickness >= 0) ||
		!isfinite(thickness) || out->count == MOST_LAYERS)
		return false;
	if (thickness == 0)
		return true;
	out->paints[out->count] = ifc_style_paint(&model->styles,
		ifc_target(&model->file, layer, LAYER_MATERIAL));
	out->count++;
	out->bounds[out->count] =
		out->bounds[out->count - 1] + sense * thickness;
	return true;
}

static bool
layers_read(const struct ifc_model *model, uint32_t product, struct layers *out)
{
	const struct ifc_file *file = &model->file;
	uint32_t usage = usage_find(model, product);
	struct step_value axis = ifc_value(file, usage, DIRECTION);
	struct step_value sense = ifc_value(file, usage, SENSE);
	struct step_value offset = ifc_value(file, usage, OFFSET);
	struct step_value list =
		ifc_value(file, ifc_target(file, usage, FOR_SET), 0);
	struct step_value item;

	out->count = 0;
	out->axis = step_is(&axis, "AXIS1") ? 0
		: step_is(&axis, "AXIS2")   ? 1
					    : 2;
	if (usage == STEP_NONE || list.kind != STEP_LIST ||
		!step_number(&offset, out->bounds))
		return false;
	while (step_next(&list.list, &item) > STEP_END)
		if (!layer_read(model, step_target(file->step, &item),
			    step_is(&sense, "NEGATIVE") ? -1 : 1, out))
			return false;
	return out->count > 1;
}

static double
along(struct tcs_point point, int axis)
{
	return axis == 0 ? point.x : axis == 1 ? point.y : point.z;
}

/* Whether the layers are all that the body is. */
static bool
layers_fit(const struct ifc_shaper *shaper, const struct layers *layers,
	const struct ifc_body *body)
{
	double first = layers->bounds[0], last = layers->bounds[layers->count];
	double slack = SLACK / shaper->unit;

	for (size_t i = 0; i < body->parts.count; i++)
		if (body->parts.at[i].kind == IFC_PART_SURFACE)
			return false;
	for (size_t i = 0; i < body->faces.points.count; i++) {
		double at = along(body->faces.points.at[i], layers->axis);

		if (at < fmin(first, last) - slack ||
			at > fmax(first, last) + slack)
			return false;
	}
	return body->parts.count > 0;
}

/* ---- cutting ------------------------------------------------------------- */

/* Take away what is beyond a bound, away from the layer. */
static bool
bound_add(struct ifc_cut *cut, const struct layers *layers, size_t bound,
	bool last, uint32_t paint)
{
	bool rising = layers->bounds[layers->count] > layers->bounds[0];
	double way = rising == last ? 1 : -1;
	struct solid_half_space half = {.label = paint};
	double at = layers->bounds[bound];

	if (array_grow(&cut->half_spaces, 1))
		return false;
	half.point = (struct tcs_point){layers->axis == 0 ? at : 0,
		layers->axis == 1 ? at : 0, layers->axis == 2 ? at : 0};
	half.normal = (struct tcs_point){layers->axis == 0 ? way : 0,
		layers->axis == 1 ? way : 0, layers->axis == 2 ? way : 0};
	cut->half_spaces.at[cut->half_spaces.count++] = half;
	return true;
}

/* Faces without a style of their own are the layer's. */
static void
faces_paint(struct ifc_faces *faces, size_t first, uint32_t from, uint32_t to)
{
	for (size_t i = first; i < faces->faces.count; i++)
		if (!faces->faces.at[i].paint ||
			faces->faces.at[i].paint == from)
			faces->faces.at[i].paint = to;
}

/* One layer of the solid whose faces are from `first` to before `end`. */
static enum ifc_outcome
layer_cut(struct ifc_shaper *shaper, uint32_t product,
	const struct layers *layers, size_t layer, const struct ifc_body *from,
	size_t first, size_t end, struct ifc_faces *out)
{
	struct ifc_cut cut = {.operation = SOLID_DIFFERENCE};
	enum ifc_outcome outcome =
		ifc_solid_add(&cut.host, &from->faces, first, end);
	bool open;

	/* The outermost bounds are the body's own faces. */
	if (!outcome &&
		((layer > 0 &&
			 !bound_add(&cut, layers, layer, false,
				 layers->paints[layer])) ||
			(layer + 1 < layers->count &&
				!bound_add(&cut, layers, layer + 1, true,
					layers->paints[layer]))))
		outcome = IFC_NO_MEMORY;
	if (!outcome)
		outcome = ifc_cut_run(shaper, product, &cut, &open);
	if (!outcome)
		outcome = ifc_solid_faces(shaper, &cut.host, out);
	ifc_cut_release(&cut);
	return outcome;
}

/* All layers of one solid with its voids. */
static enum ifc_outcome
solid_layer(struct ifc_shaper *shaper, uint32_t product,
	const struct layers *layers, uint32_t paint,
	const struct ifc_body *from, size_t part, size_t end,
	struct ifc_body *out)
{
	enum ifc_outcome outcome = IFC_SHAPED;

	for (size_t i = 0; i < layers->count && !outcome; i++) {
		size_t first = out->faces.faces.count;

		outcome = layer_cut(shaper, product, layers, i, from,
			from->parts.at[part].first_face,
			ifc_part_end(from, end - 1), &out->faces);
		if (outcome || out->faces.faces.count == first)
			continue;
		faces_paint(&out->faces, first, paint, layers->paints[i]);
		if (array_grow(&out->parts, 1))
			return IFC_NO_MEMORY;
		out->parts.at[out->parts.count++] =
			(struct ifc_part){(uint32_t)first, IFC_PART_SOLID,
				from->parts.at[part].item};
	}
	return outcome;
}

enum ifc_outcome
ifc_body_layer(struct ifc_shaper *shaper, const struct ifc_model *model,
	uint32_t product, uint32_t paint, struct ifc_body *body)
{
	struct ifc_body out = {.faces = {.points = {.count = 0}}};
	size_t remarks = shaper->scratch->remarks.count;
	enum ifc_outcome outcome = IFC_SHAPED;
	struct layers layers;

	if (!layers_read(model, product, &layers) ||
		!layers_fit(shaper, &layers, body))
		return IFC_SHAPED;
	for (size_t part = 0, end; part < body->parts.count && !outcome;
		part = end) {
		end = ifc_solid_end(body, part);
		outcome = solid_layer(
			shaper, product, &layers, paint, body, part, end, &out);
	}
	if (outcome || remarks != shaper->scratch->remarks.count) {
		ifc_body_release(&out);
		return outcome;
	}
	ifc_body_release(body);
	*body = out;
	return IFC_SHAPED;
}
