/* Positions, rings and polygons. */
#include <string.h>

#include "citygml_polygons.h"

/* ---- positions ----------------------------------------------------------------- */

void
shape_point(struct composer *composer, struct tcs_point point)
{
	struct markup *markup = &composer->out->markup;
	bool north_first =
		composer->plan->north_first && !composer->is_prototype;

	markup_number(markup, north_first ? point.y : point.x);
	markup_number(markup, north_first ? point.x : point.y);
	markup_number(markup, point.z);
}

void
shape_start_positions(struct composer *composer)
{
	struct markup *markup = &composer->out->markup;

	markup_start(markup, "gml", "posList");
	markup_attribute(markup, "srsDimension", "3");
	markup_begin_text(markup);
}

void
shape_start_with_id(struct composer *composer, const char *name, const char *id)
{
	struct markup *markup = &composer->out->markup;

	markup_start(markup, "gml", name);
	if (id && *id)
		markup_attribute(markup, "gml:id", id);
}

void
shape_start_in(struct composer *composer, const char *name,
	const struct tcs_geometry *geometry, tcs_text given)
{
	shape_start_named(composer, name,
		given ? compose_id_in(composer, geometry, given) : NULL);
}

void
shape_start_named(struct composer *composer, const char *name, const char *id)
{
	if (!id && (compose_is_3(composer) || composer->wants_outer_id))
		id = compose_id(composer, "");
	if (composer->wants_outer_id)
		composer->outer_id = id;
	composer->wants_outer_id = false;
	shape_start_with_id(composer, name, id);
}

void
shape_start(struct composer *composer, const char *name)
{
	shape_start_in(composer, name, NULL, 0);
}

/* ---- rings --------------------------------------------------------------------- */

static void
start_ring(struct composer *composer, bool outer, const char *id)
{
	markup_start(
		&composer->out->markup, "gml", outer ? "exterior" : "interior");
	shape_start_with_id(composer, "LinearRing", id);
	shape_start_positions(composer);
}

static void
end_ring(struct composer *composer, bool outer)
{
	struct markup *markup = &composer->out->markup;

	markup_end(markup, "gml", "posList");
	markup_end(markup, "gml", "LinearRing");
	markup_end(markup, "gml", outer ? "exterior" : "interior");
}

static void
write_ring(struct composer *composer, const struct tcs_ring *ring, bool outer,
	const char *id)
{
	const struct tcs_point *vertices =
		&composer->object.vertices.at[ring->first_vertex];

	start_ring(composer, outer, id);
	for (uint32_t i = 0; i < ring->vertex_count; i++)
		shape_point(composer, vertices[i]);
	shape_point(composer, vertices[0]);
	end_ring(composer, outer);
}

static void
write_merged_ring(struct composer *composer, const struct coplanar_ring *ring,
	bool outer, const char *id)
{
	const uint32_t *corners = composer->merged.corners.at + ring->first;
	const struct tcs_point *vertices = composer->object.vertices.at;

	start_ring(composer, outer, id);
	for (uint32_t i = 0; i < ring->count; i++)
		shape_point(composer, vertices[corners[i]]);
	shape_point(composer, vertices[corners[0]]);
	end_ring(composer, outer);
}

/* ---- polygons -------------------------------------------------------------------- */

/* The id that texture coordinates go by. */
static const char *
painted_ring_id(
	const struct composer *composer, uint32_t polygon, uint32_t ring)
{
	const struct piece *piece = &composer->pieces.at[polygon];

	return piece->first_ring_id == TCS_NONE
		? NULL
		: composer->ring_ids.at[piece->first_ring_id + ring];
}

/* That id, or the ring's own. */
static const char *
ring_id(struct composer *composer, uint32_t polygon, uint32_t ring)
{
	const struct tcs_polygon *of = &composer->object.polygons.at[polygon];
	const char *id = painted_ring_id(composer, polygon, ring);
	tcs_text given = composer->object.rings.at[of->first_ring + ring].id;

	if (id)
		return id;
	return given ? compose_id(composer, compose_text(composer, given))
		     : NULL;
}

void
shape_rings(struct composer *composer, uint32_t polygon)
{
	const struct tcs_polygon *of = &composer->object.polygons.at[polygon];

	for (uint32_t i = 0; i < of->ring_count; i++)
		write_ring(composer,
			&composer->object.rings.at[of->first_ring + i], i == 0,
			ring_id(composer, polygon, i));
}

void
shape_patch(struct composer *composer, uint32_t polygon, uint32_t n)
{
	const struct tcs_polygon *of = &composer->object.polygons.at[polygon];
	const struct tcs_point *vertices = composer->object.vertices.at;
	const uint32_t *corner;

	if (pieces_is_triangle(composer, polygon)) {
		shape_rings(composer, polygon);
		return;
	}
	corner = composer->object.triangles.at[of->first_triangle + n].corner;
	start_ring(composer, true, painted_ring_id(composer, polygon, n));
	for (unsigned i = 0; i < 4; i++)
		shape_point(composer, vertices[corner[i % 3]]);
	end_ring(composer, true);
}

static void
write_face(struct composer *composer, uint32_t polygon, uint32_t face)
{
	const struct piece *piece = &composer->pieces.at[polygon];
	const struct face *of = &composer->faces.at[piece->first_face + face];

	shape_start_with_id(composer, "Polygon", face ? of->id : piece->id);
	for (uint32_t i = 0; i < of->ring_count; i++)
		write_merged_ring(composer,
			&composer->merged.rings.at[of->first_ring + i], i == 0,
			painted_ring_id(
				composer, polygon, of->rings_before + i));
	markup_end(&composer->out->markup, "gml", "Polygon");
}

uint32_t
shape_face_count(const struct composer *composer, uint32_t polygon)
{
	if (composer->object.polygons.at[polygon].ring_count)
		return 1;
	return composer->pieces.at[polygon].face_count;
}

void
shape_polygon(struct composer *composer, uint32_t polygon, uint32_t face)
{
	composer->out->polygons++;
	if (!composer->object.polygons.at[polygon].ring_count) {
		write_face(composer, polygon, face);
		return;
	}
	shape_start_with_id(
		composer, "Polygon", composer->pieces.at[polygon].id);
	shape_rings(composer, polygon);
	markup_end(&composer->out->markup, "gml", "Polygon");
}

const char *
shape_reference(const struct composer *composer, uint32_t polygon,
	uint32_t face, bool at_home)
{
	const struct piece *piece = &composer->pieces.at[polygon];

	if (piece->foreign)
		return piece->id;
	if (piece->first != TCS_NONE) {
		const struct piece *first = &composer->pieces.at[piece->first];

		return face ? composer->faces.at[first->first_face + face].id
			    : first->id;
	}
	if (at_home)
		return NULL;
	return face ? composer->faces.at[piece->first_face + face].id
		    : piece->id;
}

bool
shape_is_reversed(const struct composer *composer, uint32_t polygon)
{
	const struct tcs_polygon *of = &composer->object.polygons.at[polygon];

	return of->ring_count && (of->flags & TCS_POLYGON_REVERSED);
}

static void
write_member(struct composer *composer, const char *property, uint32_t polygon,
	uint32_t face, bool at_home, bool reversed)
{
	const char *id = shape_reference(composer, polygon, face, at_home);
	struct markup *markup = &composer->out->markup;

	markup_start(markup, "gml", property);
	if (reversed) {
		shape_start(composer, "OrientableSurface");
		markup_attribute(markup, "orientation", "-");
		markup_start(markup, "gml", "baseSurface");
	}
	if (id)
		markup_link(markup, "xlink:href", id);
	else
		shape_polygon(composer, polygon, face);
	if (reversed) {
		markup_end(markup, "gml", "baseSurface");
		markup_end(markup, "gml", "OrientableSurface");
	}
	markup_end(markup, "gml", property);
}

void
shape_members(struct composer *composer, uint32_t polygon, uint32_t feature,
	bool reversed)
{
	const struct piece *piece = &composer->pieces.at[polygon];
	uint32_t like = piece->first == TCS_NONE ? polygon : piece->first;
	uint32_t count = piece->foreign ? 1 : shape_face_count(composer, like);

	for (uint32_t i = 0; i < count; i++)
		write_member(composer, "surfaceMember", polygon, i,
			piece->home == feature, reversed);
}
