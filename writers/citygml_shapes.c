/* Geometries: GML 3.1.1 for CityGML 1.0 and 2.0, GML 3.2 for 3.0. */
#include <string.h>

#include "citygml_polygons.h"

/* ---- surfaces ------------------------------------------------------------------- */

struct shape {
	const struct item *items;
	size_t item_count;
	const struct tcs_geometry *geometry; /* NULL: polygons only */
	uint32_t feature;
};

/* ---- triangulated surfaces ------------------------------------------------------- */

static void
write_patches(struct composer *composer, uint32_t polygon)
{
	uint32_t count = pieces_patch_count(composer, polygon);
	struct markup *markup = &composer->out->markup;

	for (uint32_t i = 0; i < count; i++) {
		composer->out->polygons++;
		markup_start(markup, "gml", "Triangle");
		shape_patch(composer, polygon, i);
		markup_end(markup, "gml", "Triangle");
	}
}

static void
write_tin(struct composer *composer, const struct tcs_geometry *geometry)
{
	const char *patches =
		compose_is_3(composer) ? "patches" : "trianglePatches";
	const char *id =
		composer->surfaces.at[geometry - composer->object.geometries.at]
			.id;
	struct markup *markup = &composer->out->markup;

	if (id)
		shape_start_named(composer, "TriangulatedSurface", id);
	else
		shape_start_in(composer, "TriangulatedSurface", geometry,
			geometry->id);
	markup_start(markup, "gml", patches);
	for (uint32_t i = 0; i < geometry->polygon_count; i++)
		write_patches(composer, geometry->first_polygon + i);
	markup_end(markup, "gml", patches);
	markup_end(markup, "gml", "TriangulatedSurface");
}

/* ---- surfaces ---------------------------------------------------------------------- */

static void
write_surface_items(struct composer *composer, const struct shape *shape)
{
	struct markup *markup = &composer->out->markup;

	for (size_t i = 0; i < shape->item_count; i++) {
		const struct item *item = &shape->items[i];
		const struct tcs_geometry *geometry;

		if (item->kind == ITEM_POLYGON) {
			shape_members(
				composer, item->index, shape->feature, false);
			continue;
		}
		geometry = &composer->object.geometries.at[item->index];
		if (geometry->kind == TCS_TIN) {
			markup_start(markup, "gml", "surfaceMember");
			write_tin(composer, geometry);
			markup_end(markup, "gml", "surfaceMember");
			continue;
		}
		for (uint32_t j = 0; j < geometry->polygon_count; j++) {
			uint32_t polygon = geometry->first_polygon + j;

			shape_members(composer, polygon, shape->feature,
				shape_is_reversed(composer, polygon));
		}
	}
}

static bool
is_tin(const struct shape *shape)
{
	return shape->geometry && shape->geometry->kind == TCS_TIN &&
		shape->item_count == 1;
}

static void
write_surfaces(
	struct composer *composer, const struct shape *shape, const char *name)
{
	const struct tcs_geometry *geometry = shape->geometry;

	shape_start_in(composer, name, geometry,
		geometry && geometry->kind != TCS_TIN ? geometry->id : 0);
	write_surface_items(composer, shape);
	markup_end(&composer->out->markup, "gml", name);
}

/* The only polygon of the shape; TCS_NONE when there are more. */
static uint32_t
only_polygon(const struct composer *composer, const struct shape *shape)
{
	uint32_t polygon;

	if (shape->item_count != 1)
		return TCS_NONE;
	if (!shape->geometry)
		polygon = shape->items[0].index;
	else if (shape->geometry->polygon_count == 1)
		polygon = shape->geometry->first_polygon;
	else
		return TCS_NONE;
	if (composer->pieces.at[polygon].home != shape->feature ||
		shape_face_count(composer, polygon) != 1 ||
		shape_reference(composer, polygon, 0, true) ||
		shape_is_reversed(composer, polygon))
		return TCS_NONE;
	return polygon;
}

/* The source had the polygon itself in the property. */
static bool
is_bare(const struct composer *composer, const struct shape *shape)
{
	uint32_t polygon = only_polygon(composer, shape);

	return polygon != TCS_NONE && shape->geometry &&
		shape->geometry->kind == TCS_MULTI_SURFACE &&
		!strcmp(compose_text(composer, shape->geometry->id),
			compose_text(composer,
				composer->object.polygons.at[polygon].id));
}

/* ---- solids --------------------------------------------------------------------- */

static void
write_shell(struct composer *composer, const struct shape *shape,
	const struct tcs_shell *shell)
{
	const char *name =
		compose_is_3(composer) ? "Shell" : "CompositeSurface";
	const char *side = shell->interior ? "interior" : "exterior";
	struct markup *markup = &composer->out->markup;

	markup_start(markup, "gml", side);
	shape_start_in(composer, name, shape->geometry, shell->id);
	for (uint32_t i = 0; i < shell->polygon_count; i++) {
		uint32_t polygon = shell->first_polygon + i;

		shape_members(composer, polygon, shape->feature,
			shape_is_reversed(composer, polygon));
	}
	markup_end(markup, "gml", name);
	markup_end(markup, "gml", side);
}

/* The shells from *at that make one solid; moves *at behind them. */
static void
write_solid(struct composer *composer, const struct shape *shape, uint32_t *at,
	tcs_text id)
{
	const struct tcs_geometry *geometry = shape->geometry;
	const struct tcs_shell *shells =
		&composer->object.shells.at[geometry->first_shell];
	uint32_t solid = shells[*at].solid;

	shape_start_in(composer, "Solid", geometry, id);
	for (; *at < geometry->shell_count && shells[*at].solid == solid; ++*at)
		write_shell(composer, shape, &shells[*at]);
	markup_end(&composer->out->markup, "gml", "Solid");
}

static void
write_solids(
	struct composer *composer, const struct shape *shape, const char *name)
{
	struct markup *markup = &composer->out->markup;
	uint32_t at = 0;

	shape_start_in(composer, name, shape->geometry, shape->geometry->id);
	while (at < shape->geometry->shell_count) {
		markup_start(markup, "gml", "solidMember");
		write_solid(composer, shape, &at, 0);
		markup_end(markup, "gml", "solidMember");
	}
	markup_end(markup, "gml", name);
}

/* ---- curves and points ------------------------------------------------------------ */

static void
write_line(struct composer *composer, uint32_t polygon)
{
	const struct tcs_polygon *of = &composer->object.polygons.at[polygon];
	const struct tcs_point *vertices =
		&composer->object.vertices.at[of->first_vertex];

	composer->out->polygons++;
	shape_start_with_id(
		composer, "LineString", composer->pieces.at[polygon].id);
	shape_start_positions(composer);
	for (uint32_t i = 0; i < of->vertex_count; i++)
		shape_point(composer, vertices[i]);
	markup_end(&composer->out->markup, "gml", "posList");
	markup_end(&composer->out->markup, "gml", "LineString");
}

static void
write_gml_point(struct composer *composer, uint32_t polygon)
{
	const struct tcs_polygon *of = &composer->object.polygons.at[polygon];
	struct markup *markup = &composer->out->markup;

	composer->out->polygons++;
	shape_start_with_id(composer, "Point", composer->pieces.at[polygon].id);
	markup_start(markup, "gml", "pos");
	markup_attribute(markup, "srsDimension", "3");
	markup_begin_text(markup);
	shape_point(composer, composer->object.vertices.at[of->first_vertex]);
	markup_end(markup, "gml", "pos");
	markup_end(markup, "gml", "Point");
}

static void
write_each(struct composer *composer, const struct shape *shape,
	const char *name, const char *member,
	void (*write)(struct composer *, uint32_t))
{
	const struct tcs_geometry *geometry = shape->geometry;
	struct markup *markup = &composer->out->markup;

	shape_start_in(composer, name, geometry, geometry->id);
	for (uint32_t i = 0; i < geometry->polygon_count; i++) {
		const char *id;

		markup_start(markup, "gml", member);
		id = shape_reference(
			composer, geometry->first_polygon + i, 0, true);
		if (id)
			markup_link(markup, "xlink:href", id);
		else
			write(composer, geometry->first_polygon + i);
		markup_end(markup, "gml", member);
	}
	markup_end(markup, "gml", name);
}

/* The points that place_geometry has given to an address. */
void
address_points_write(struct composer *composer, uint32_t address)
{
	struct markup *markup = &composer->out->markup;
	struct shape shape = {0};
	size_t low = 0, high = composer->addresses.count;

	while (low < high) {
		size_t middle = low + (high - low) / 2;

		if (composer->addresses.at[middle].attribute < address)
			low = middle + 1;
		else
			high = middle;
	}
	if (low == composer->addresses.count ||
		composer->addresses.at[low].attribute != address ||
		composer->addresses.at[low].points == TCS_NONE)
		return;
	shape.geometry = &composer->object.geometries
				  .at[composer->addresses.at[low].points];
	markup_start(markup, "core", "multiPoint");
	write_each(
		composer, &shape, "MultiPoint", "pointMember", write_gml_point);
	markup_end(markup, "core", "multiPoint");
}

/* ---- properties -------------------------------------------------------------------- */

static void
write_in_geometry(struct composer *composer, const struct shape *shape)
{
	const struct tcs_geometry *geometry = shape->geometry;
	uint32_t at = 0;

	switch (geometry ? geometry->kind : TCS_MULTI_SURFACE) {
	case TCS_SOLID:
		write_solid(composer, shape, &at, geometry->id);
		return;
	case TCS_MULTI_SOLID:
		write_solids(composer, shape, "MultiSolid");
		return;
	case TCS_COMPOSITE_SOLID:
		write_solids(composer, shape, "CompositeSolid");
		return;
	case TCS_TIN:
		write_tin(composer, shape->geometry);
		return;
	case TCS_MULTI_CURVE:
		write_each(composer, shape, "MultiCurve", "curveMember",
			write_line);
		return;
	case TCS_MULTI_POINT:
		write_each(composer, shape, "MultiPoint", "pointMember",
			write_gml_point);
		return;
	case TCS_COMPOSITE_SURFACE:
		write_surfaces(composer, shape, "CompositeSurface");
		return;
	default:
		if (!composer->wants_outer_id && is_bare(composer, shape))
			shape_polygon(
				composer, only_polygon(composer, shape), 0);
		else
			write_surfaces(composer, shape, "MultiSurface");
	}
}

static void
write_in_solid(struct composer *composer, const struct shape *shape)
{
	uint32_t at = 0;

	if (shape->geometry->kind == TCS_COMPOSITE_SOLID)
		write_solids(composer, shape, "CompositeSolid");
	else
		write_solid(composer, shape, &at, shape->geometry->id);
}

static void
write_content(
	struct composer *composer, const struct shape *shape, unsigned content)
{
	switch (content) {
	case CONTENT_SOLID:
		write_in_solid(composer, shape);
		return;
	case CONTENT_MULTISOLID:
		write_solids(composer, shape, "MultiSolid");
		return;
	case CONTENT_MULTISURFACE:
		write_surfaces(composer, shape, "MultiSurface");
		return;
	case CONTENT_SURFACE:
	case CONTENT_POLYGON:
		if (is_tin(shape))
			write_tin(composer, shape->geometry);
		else if (only_polygon(composer, shape) != TCS_NONE)
			shape_polygon(
				composer, only_polygon(composer, shape), 0);
		else
			write_surfaces(composer, shape, "CompositeSurface");
		return;
	case CONTENT_TIN:
		write_tin(composer, shape->geometry);
		return;
	case CONTENT_MULTICURVE:
		write_each(composer, shape, "MultiCurve", "curveMember",
			write_line);
		return;
	case CONTENT_COMPLEX:
		write_each(composer, shape, "GeometricComplex", "element",
			write_line);
		return;
	case CONTENT_MULTIPOINT:
		write_each(composer, shape, "MultiPoint", "pointMember",
			write_gml_point);
		return;
	case CONTENT_POINT:
		write_gml_point(composer, shape->geometry->first_polygon);
		return;
	default:
		write_in_geometry(composer, shape);
	}
}

/* ---- implicit geometry --------------------------------------------------------- */

/* All geometries of the prototype; more than one in a multi-geometry. */
void
prototype_write(struct composer *composer)
{
	const struct tcs_object *object = &composer->object;
	struct markup *markup = &composer->out->markup;
	bool many = object->geometries.count != 1;

	composer->wants_outer_id = true;
	if (many)
		shape_start(composer, "MultiGeometry");
	for (uint32_t i = 0; i < object->geometries.count; i++) {
		struct item item = {.index = i, .kind = ITEM_GEOMETRY};
		struct shape shape = {.items = &item,
			.item_count = 1,
			.geometry = &object->geometries.at[i]};

		if (many)
			markup_start(markup, "gml", "geometryMember");
		write_in_geometry(composer, &shape);
		if (many)
			markup_end(markup, "gml", "geometryMember");
	}
	if (many)
		markup_end(markup, "gml", "MultiGeometry");
	composer->wants_outer_id = false;
}

static void
write_matrix(struct composer *composer, const struct tcs_instance *instance)
{
	struct markup *markup = &composer->out->markup;

	markup_start(markup, "core", "transformationMatrix");
	markup_begin_text(markup);
	for (unsigned i = 0; i < 16; i++)
		markup_number(markup, instance->matrix[i]);
	markup_end(markup, "core", "transformationMatrix");
}

/* Whoever joins the texts knows whether the prototype was written before. */
static void
leave_hole(struct composer *composer, uint32_t prototype)
{
	struct composed *out = composer->out;

	if (array_grow(&out->holes, 1)) {
		out->markup.failed = true;
		return;
	}
	out->holes.at[out->holes.count++] = (struct hole){
		.at = out->markup.bytes.count,
		.prototype = prototype,
		.depth = out->markup.depth,
	};
}

static void
write_anchor(struct composer *composer, struct tcs_point anchor)
{
	struct markup *markup = &composer->out->markup;

	markup_start(markup, "core", "referencePoint");
	shape_start(composer, "Point");
	markup_start(markup, "gml", "pos");
	markup_attribute(markup, "srsDimension", "3");
	markup_begin_text(markup);
	shape_point(composer, anchor);
	markup_end(markup, "gml", "pos");
	markup_end(markup, "gml", "Point");
	markup_end(markup, "core", "referencePoint");
}

void
instance_write(struct composer *composer, const struct item *item)
{
	const struct property *property = compose_property(composer, item);
	const char *module = compose_module(composer, item->feature, property);
	const struct tcs_instance *instance =
		&composer->object.instances.at[item->index];
	const char *id = compose_text(composer, instance->id);
	struct markup *markup = &composer->out->markup;

	markup_start(markup, module, property->name);
	markup_start(markup, "core", "ImplicitGeometry");
	if (*id || compose_is_3(composer))
		markup_attribute(markup, "gml:id", compose_id(composer, id));
	write_matrix(composer, instance);
	if (!compose_is_3(composer))
		leave_hole(composer, instance->prototype);
	write_anchor(composer, instance->anchor);
	if (compose_is_3(composer))
		leave_hole(composer, instance->prototype);
	markup_end(markup, "core", "ImplicitGeometry");
	markup_end(markup, module, property->name);
}

/* ---- one property ----------------------------------------------------------------- */

void
shapes_write(struct composer *composer, const struct item *items, size_t count)
{
	const struct property *property = compose_property(composer, items);
	const char *module = compose_module(composer, items->feature, property);
	struct shape shape = {
		.items = items,
		.item_count = count,
		.feature = items->feature,
	};

	for (size_t i = 0; i < count; i++)
		if (items[i].kind == ITEM_GEOMETRY)
			shape.geometry =
				&composer->object.geometries.at[items[i].index];
	markup_start(&composer->out->markup, module, property->name);
	write_content(composer, &shape, property->content);
	markup_end(&composer->out->markup, module, property->name);
}
