#include "ifc_head.h"

#include <math.h>
#include <string.h>

#include "srs.h"
#include "step_string.h"

static enum tcs_status
head_append(struct tcs_head *head, const char *text, tcs_text *out,
	struct tcs_fault *fault)
{
	return text_append(head, text, strlen(text), out, fault);
}

/* The name of the system; the stream's coordinates are easting first. */
static enum tcs_status
crs_name(struct tcs_head *head, const struct step_value *system,
	struct tcs_crs *crs, struct tcs_fault *fault)
{
	struct step_text name = {.count = 0};
	enum tcs_status status = TCS_OK;
	struct srs srs;
	unsigned trouble = 0;

	if (system->kind == STEP_STRING)
		status = step_decode(
			&name, system->text, system->length, &trouble, fault);
	if (!status && name.count) {
		srs_read(name.at, &srs);
		crs->epsg = srs.epsg;
		crs->epsg_up = srs.epsg_up;
		if (srs.kind != TCS_CRS_UNKNOWN)
			crs->kind = srs.kind;
		status = head_append(head, name.at, &crs->name, fault);
	}
	array_release(&name);
	return status;
}

/* Whole metres near the first object placement that is no origin itself. */
static void
crs_origin(const struct ifc_model *model, const struct ifc_georeference *place,
	struct tcs_crs *crs)
{
	struct tcs_point at = {0, 0, 0};

	for (size_t i = 0; i < model->placements.count; i++) {
		const struct ifc_placement *placement =
			model->placements.at + i;
		const double *m = placement->world.at;

		if (!placement->known || (m[3] == 0 && m[7] == 0 && m[11] == 0))
			continue;
		at = (struct tcs_point){m[3], m[7], m[11]};
		break;
	}
	at = ifc_transform(&place->world, at);
	crs->origin = (struct tcs_point){floor(at.x), floor(at.y), floor(at.z)};
	crs->flags |= TCS_HAS_ORIGIN;
}

static enum tcs_status
crs_build(struct tcs_head *head, const struct ifc_model *model,
	const struct ifc_georeference *place, struct tcs_fault *fault)
{
	struct tcs_crs crs = {.metres_per_unit = place->metres_per_unit,
		.metres_per_unit_up = place->metres_per_unit,
		.kind = TCS_CRS_LOCAL};
	enum tcs_status status = TCS_OK;

	if (!place->is_local) {
		crs.kind = TCS_CRS_PROJECTED;
		status = crs_name(head, &place->system, &crs, fault);
	}
	crs_origin(model, place, &crs);
	if (!status && array_grow(&head->crs, 1))
		return fault_memory(fault);
	if (!status)
		head->crs.at[head->crs.count++] = crs;
	return status;
}

static enum tcs_status
source_build(struct tcs_head *head, const struct ifc_model *model,
	const struct command *command, struct tcs_fault *fault)
{
	static const char *const formats[IFC_VERSIONS] = {
		[IFC_2X3] = "IFC2X3", [IFC_4] = "IFC4", [IFC_4X3] = "IFC4X3"};
	const char *name = command->input ? command->input : "";
	const char *slash = strrchr(name, '/');
	struct tcs_source source = {0};
	enum tcs_status status;

	status = head_append(
		head, formats[model->file.version], &source.format, fault);
	if (!status)
		status = head_append(
			head, slash ? slash + 1 : name, &source.name, fault);
	if (!status && array_grow(&head->sources, 1))
		return fault_memory(fault);
	if (!status)
		head->sources.at[head->sources.count++] = source;
	return status;
}

enum tcs_status
ifc_head_build(struct tcs_head *head, const struct ifc_model *model,
	const struct ifc_georeference *place, const struct command *command,
	struct tcs_fault *fault)
{
	enum tcs_status status = crs_build(head, model, place, fault);

	if (!status)
		status = source_build(head, model, command, fault);
	if (!status)
		status = head_sign(head, command->program->name,
			TESSERA_VERSION, command->arguments, fault);
	return status;
}
