/*
 * The colours of a file: surface styles as materials of the stream, and which
 * items, faces and products have them.
 *
 * source: IfcStyledItem, IfcSurfaceStyle, IfcPresentationStyleAssignment,
 * IfcIndexedColourMap (ISO 16739-1 8.12, 8.13), and those of materials, by way
 * of IfcMaterialDefinitionRepresentation.
 */
#ifndef TESSERA_IFC_STYLE_H
#define TESSERA_IFC_STYLE_H

#include "ifc_file.h"
#include "report.h"
#include "tcs.h"

/* An instance and its paint: 1 + the number of a material. */
struct ifc_painted {
	uint32_t instance;
	uint32_t paint;
};

/* An IfcIndexedColourMap: colour n is the material `first` + n - 1. */
struct ifc_colour_map {
	uint32_t item; /* the face set */
	uint32_t map;
	uint32_t first, count;
};

struct ifc_styles {
	const struct ifc_file *file; /* borrowed */
	struct tcs_palette palette; /* the materials */
	TCS_ARRAY(struct ifc_painted) items; /* by instance */
	TCS_ARRAY(struct ifc_colour_map) maps; /* by item */
};

/* Read all styles of the file. Fails with TCS_NO_MEMORY. */
enum tcs_status ifc_styles_read(const struct ifc_file *file,
	struct ifc_styles *out, struct tcs_fault *fault) TCS_CHECKED;

void ifc_styles_release(struct ifc_styles *styles);

/* The paint of an item or material; 0 for none, and where `styles` is NULL. */
uint32_t ifc_style_paint(const struct ifc_styles *styles, uint32_t instance);

/* A walk over the faces of a set, in order: what a map says of each. */
struct ifc_colour_walk {
	struct step_cursor indices;
	uint32_t first, count; /* count 0: no map */
};

void ifc_colours_begin(const struct ifc_styles *styles, uint32_t item,
	struct ifc_colour_walk *out);

/* The paint of the next face; 0 for none. */
uint32_t ifc_colours_next(struct ifc_colour_walk *walk);

#endif
