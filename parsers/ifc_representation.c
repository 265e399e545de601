#include "ifc_representation.h"

#include <string.h>
#include <strings.h>

enum { PRODUCT_REPRESENTATION = 6, SHAPE_REPRESENTATIONS = 2 };

enum { IDENTIFIER = 1, TYPE = 2, ITEMS = 3 };

enum { NO_BODY = 100, UNKNOWN = 50 };

/* Identifiers by how much of a body each is. */
static const struct {
	const char *name;
	int rank;
} identifiers[] = {
	{"Body", 0},
	{"Body-FallBack", 1},
	{"Facetation", 2},
	{"Tessellation", 2},
	{"Mesh", 3},
	{"Surface", 4},
	{"Axis", NO_BODY},
	{"FootPrint", NO_BODY},
	{"Box", NO_BODY},
	{"Annotation", NO_BODY},
	{"Annotation2D", NO_BODY},
	{"Profile", NO_BODY},
	{"Plan", NO_BODY},
	{"CoG", NO_BODY},
	{"Clearance", NO_BODY},
	{"Lighting", NO_BODY},
	{"Reference", NO_BODY},
	{"SurveyPoints", NO_BODY},
};

/* Types that are no body whatever they are called. */
static const char *const flat_types[] = {"Annotation2D", "BoundingBox",
	"Curve2D", "Curve3D", "Curve", "GeometricCurveSet", "Point",
	"PointCloud"};

static bool
reads(const struct step_value *value, const char *text)
{
	return value->kind == STEP_STRING && value->length == strlen(text) &&
		!strncasecmp(value->text, text, value->length);
}

static int
body_rank(const struct ifc_file *file, uint32_t representation)
{
	struct step_value name = ifc_value(file, representation, IDENTIFIER);
	struct step_value type = ifc_value(file, representation, TYPE);

	/* The faces that a structural member is idealised as. */
	if (ifc_is_kind(file, representation, IFC_TOPOLOGYREPRESENTATION))
		return reads(&type, "Face") ? UNKNOWN : NO_BODY;
	for (size_t i = 0; i < sizeof identifiers / sizeof *identifiers; i++)
		if (reads(&name, identifiers[i].name))
			return identifiers[i].rank;
	for (size_t i = 0; i < sizeof flat_types / sizeof *flat_types; i++)
		if (reads(&type, flat_types[i]))
			return NO_BODY;
	return UNKNOWN;
}

static uint32_t
shape_of(const struct ifc_file *file, uint32_t product)
{
	return ifc_is_kind(file, product, IFC_PRODUCT)
		? ifc_target(file, product, PRODUCT_REPRESENTATION)
		: STEP_NONE;
}

bool
ifc_is_shown(const struct ifc_file *file, uint32_t product)
{
	return shape_of(file, product) != STEP_NONE;
}

uint32_t
ifc_body_of(const struct ifc_file *file, uint32_t product)
{
	struct step_value list =
		ifc_value(file, shape_of(file, product), SHAPE_REPRESENTATIONS);
	uint32_t best = STEP_NONE;
	int best_rank = NO_BODY;
	struct step_value item;

	while (list.kind == STEP_LIST &&
		step_next(&list.list, &item) > STEP_END) {
		uint32_t representation = step_target(file->step, &item);
		int rank = body_rank(file, representation);

		if (representation != STEP_NONE && rank < best_rank) {
			best = representation;
			best_rank = rank;
		}
	}
	return best;
}

struct step_value
ifc_items_of(const struct ifc_file *file, uint32_t representation)
{
	return ifc_value(file, representation, ITEMS);
}
