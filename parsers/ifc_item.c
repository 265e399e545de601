#include "ifc_item.h"

#include <stdlib.h>

#include "ifc_style.h"
#include "ifc_sweep_curve.h"
#include "solid.h"

/* ---- bodies -------------------------------------------------------------- */

enum tcs_status
ifc_scratch_new(struct ifc_scratch **out, struct tcs_fault *fault)
{
	*out = calloc(1, sizeof **out);
	return *out ? TCS_OK : fault_memory(fault);
}

void
ifc_scratch_free(struct ifc_scratch *scratch)
{
	if (!scratch)
		return;
	ifc_faces_release(&scratch->profile);
	array_release(&scratch->points);
	array_release(&scratch->remarks);
	solid_cutter_free(scratch->cutter);
	free(scratch);
}

void
ifc_body_clear(struct ifc_body *body)
{
	ifc_faces_clear(&body->faces);
	array_clear(&body->parts);
}

void
ifc_body_release(struct ifc_body *body)
{
	ifc_faces_release(&body->faces);
	array_release(&body->parts);
}

void
ifc_body_cut(struct ifc_body *body, size_t first_part)
{
	if (first_part < body->parts.count) {
		ifc_faces_cut(
			&body->faces, body->parts.at[first_part].first_face);
		body->parts.count = first_part;
	} else {
		ifc_faces_cut(&body->faces, body->faces.faces.count);
	}
}

size_t
ifc_part_end(const struct ifc_body *body, size_t part)
{
	return part + 1 < body->parts.count
		? body->parts.at[part + 1].first_face
		: body->faces.faces.count;
}

size_t
ifc_solid_end(const struct ifc_body *body, size_t part)
{
	do
		part++;
	while (part < body->parts.count &&
		body->parts.at[part].kind == IFC_PART_VOID);
	return part;
}

enum ifc_outcome
ifc_part_begin(struct ifc_body *body, enum ifc_part_kind kind, uint32_t item)
{
	if (array_grow(&body->parts, 1))
		return IFC_NO_MEMORY;
	body->parts.at[body->parts.count++] = (struct ifc_part){
		(uint32_t)body->faces.faces.count, kind, item};
	return IFC_SHAPED;
}

/* Faces without a paint get the style of the item, if it has one. */
static void
item_paint(const struct ifc_shaper *shaper, uint32_t item,
	struct ifc_faces *faces, size_t first_face)
{
	uint32_t paint = ifc_style_paint(shaper->styles, item);

	if (!paint)
		return;
	for (size_t i = first_face; i < faces->faces.count; i++)
		if (!faces->faces.at[i].paint)
			faces->faces.at[i].paint = paint;
}

/* ---- items --------------------------------------------------------------- */

static enum ifc_outcome
geometric_set(struct ifc_shaper *shaper, uint32_t item, struct ifc_body *out)
{
	struct step_value list = ifc_value(shaper->file, item, 0), element;
	enum ifc_outcome outcome = IFC_SHAPED;

	while (!outcome && list.kind == STEP_LIST &&
		step_next(&list.list, &element) > STEP_END)
		outcome = ifc_item_body(
			shaper, step_target(shaper->file->step, &element), out);
	return outcome;
}

static bool
has_no_faces(const struct ifc_file *file, uint32_t item)
{
	return ifc_is_kind(file, item, IFC_CURVE) ||
		ifc_is_kind(file, item, IFC_POINT) ||
		ifc_is_kind(file, item, IFC_VERTEX) ||
		ifc_is_kind(file, item, IFC_EDGE);
}

/* One solid, of faces that its evaluator appends. */
static enum ifc_outcome
solid(struct ifc_shaper *shaper, uint32_t item,
	enum ifc_outcome (*evaluate)(
		struct ifc_shaper *, uint32_t, struct ifc_faces *),
	struct ifc_body *out)
{
	enum ifc_outcome outcome = ifc_part_begin(out, IFC_PART_SOLID, item);

	return outcome ? outcome : evaluate(shaper, item, &out->faces);
}

/* An item whose instance was entered. */
static enum ifc_outcome
body_inside(struct ifc_shaper *shaper, uint32_t item, struct ifc_body *out)
{
	switch (ifc_entity_of(shaper->file, item)) {
	case IFC_EXTRUDEDAREASOLID:
		return ifc_extrusion(shaper, item, out);
	case IFC_REVOLVEDAREASOLID:
		return ifc_revolution(shaper, item, out);
	case IFC_EXTRUDEDAREASOLIDTAPERED:
	case IFC_REVOLVEDAREASOLIDTAPERED:
		return solid(shaper, item, ifc_tapered, out);
	case IFC_SWEPTDISKSOLID:
	case IFC_SWEPTDISKSOLIDPOLYGONAL:
		return solid(shaper, item, ifc_swept_disk, out);
	case IFC_FIXEDREFERENCESWEPTAREASOLID:
	case IFC_DIRECTRIXDERIVEDREFERENCESWEPTAREASOLID:
	case IFC_SURFACECURVESWEPTAREASOLID:
		return solid(shaper, item, ifc_swept_area, out);
	case IFC_SECTIONEDSOLIDHORIZONTAL:
	case IFC_SECTIONEDSPINE:
		return solid(shaper, item, ifc_sectioned, out);
	case IFC_BLOCK:
	case IFC_RECTANGULARPYRAMID:
	case IFC_RIGHTCIRCULARCONE:
	case IFC_RIGHTCIRCULARCYLINDER:
	case IFC_SPHERE:
		return solid(shaper, item, ifc_primitive, out);
	case IFC_FACETEDBREP:
	case IFC_FACETEDBREPWITHVOIDS:
	case IFC_ADVANCEDBREP:
	case IFC_ADVANCEDBREPWITHVOIDS:
		return ifc_brep(shaper, item, out);
	case IFC_FACE:
	case IFC_FACESURFACE:
	case IFC_ADVANCEDFACE:
		return ifc_lone_face(shaper, item, out);
	case IFC_FACEBASEDSURFACEMODEL:
	case IFC_SHELLBASEDSURFACEMODEL:
		return ifc_surface_model(shaper, item, out);
	case IFC_POLYGONALFACESET:
	case IFC_TRIANGULATEDFACESET:
	case IFC_TRIANGULATEDIRREGULARNETWORK:
		return ifc_faceset(shaper, item, out);
	case IFC_BOOLEANRESULT:
	case IFC_BOOLEANCLIPPINGRESULT:
		return ifc_boolean(shaper, item, out);
	case IFC_MAPPEDITEM:
		return ifc_mapped(shaper, item, out);
	case IFC_CSGSOLID:
		return ifc_item_body(
			shaper, ifc_target(shaper->file, item, 0), out);
	case IFC_GEOMETRICSET:
	case IFC_GEOMETRICCURVESET:
		return geometric_set(shaper, item, out);
	default:
		if (has_no_faces(shaper->file, item))
			return IFC_SHAPED;
		return ifc_refuse(shaper, item, "not read");
	}
}

enum ifc_outcome
ifc_item_body(struct ifc_shaper *shaper, uint32_t item, struct ifc_body *out)
{
	size_t first = out->faces.faces.count;
	enum ifc_outcome outcome = ifc_enter(shaper, item);

	if (outcome)
		return outcome;
	outcome = body_inside(shaper, item, out);
	ifc_leave(shaper);
	if (!outcome)
		item_paint(shaper, item, &out->faces, first);
	return outcome;
}
