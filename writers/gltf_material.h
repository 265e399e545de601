/*
 * The materials of a glTF: one per distinct look, numbered as they come up.
 *
 * source: glTF 2.0, 3.9 (materials); IEC 61966-2-1 (sRGB); X3DMaterial of
 * CityGML 2.0, 9.2. A shininess s is the Blinn-Phong exponent 128 s, and that
 * the width 2 / (2 + 128 s) = roughness^4 of the microfacets (Walter et al.
 * 2007, 5.2). glTF has no specular colour without an extension, so the darker
 * it is, the rougher the material is made instead: no shine, no gloss.
 */
#ifndef TESSERA_GLTF_MATERIAL_H
#define TESSERA_GLTF_MATERIAL_H

#include <stdbool.h>
#include <stdint.h>

#include "array.h"
#include "byte_index.h"
#include "fault.h"

struct tcs_palette;
struct textures;

#define MATERIAL_PLAIN UINT32_MAX /* without a texture */

/* What a texture does beyond the edges of its image. */
enum texture_wrap {
	TEXTURE_REPEAT,
	TEXTURE_MIRROR,
	TEXTURE_CLAMP, /* for TCS_WRAP_NONE and _BORDER too */
	TEXTURE_WRAPS,
};

/* One material, values linear, 0…1. */
struct material_look {
	double colour[4]; /* red, green, blue, alpha */
	double emissive[3];
	double roughness;
	uint32_t texture; /* of the glTF; MATERIAL_PLAIN */
	bool has_holes; /* the texture's alpha cuts them */
	bool double_sided;
	char *name; /* class, id of the first one, or image; owned */
};

/* All zero is empty. */
struct materials {
	TCS_ARRAY(struct material_look) looks;
	struct byte_index by_look; /* same numbers as the looks */
	struct byte_index by_paint; /* paints seen before … */
	TCS_ARRAY(uint32_t) of_paint; /* … and the look of each */
};

/* sRGB 0…1 to linear light. */
double colour_linear(double srgb);

/*
 * The number of the material for a paint (PAINT_… of gltf_mesh.h). A paint
 * beyond the palette is shown as class Unknown; a texture is one of those
 * given. Fails with TCS_NO_MEMORY.
 */
enum tcs_status materials_find(struct materials *materials, uint32_t paint,
	const struct tcs_palette *palette, const struct textures *textures,
	uint32_t *number, struct tcs_fault *fault) TCS_CHECKED;

void materials_release(struct materials *materials);

#endif
