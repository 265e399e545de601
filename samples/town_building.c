#include "town_building.h"

#include "town_room.h"

#include <string.h>

/* One body while it is written. */
struct writing {
	struct gml *gml;
	const struct building *building;
	const struct body *body;
	struct shape *shape; /* its faces */
	struct shape *other; /* for what is built beside them */
	char id[32]; /* of the building or part */
	bool shares_wall; /* this body's first end wall is the neighbour's */
};

void
building_id(char out[GML_ID], unsigned number)
{
	snprintf(out, GML_ID, "B%u", number);
}

/* ---- ids ---- */

/* The polygon of a face in a LOD: "B12_L2_7". */
static void
polygon_id(char out[GML_ID], const char *body, int lod, size_t face)
{
	snprintf(out, GML_ID, "%.30s_L%d_%u", body, lod, (unsigned)face);
}

static void
opening_id(char out[GML_ID], const char *body, size_t opening)
{
	snprintf(out, GML_ID, "%s_L3_O%zu", body, opening);
}

static bool
is_shared(const struct writing *w, size_t face)
{
	return w->shares_wall && w->shape->faces[face].party;
}

/* ---- LOD0 and LOD1: from the ground face ---- */

static const struct face *
ground(const struct shape *shape)
{
	size_t i = 0;

	while (shape->faces[i].class != FACE_GROUND)
		i++;
	return &shape->faces[i];
}

/* A wall around one ring of the footprint; face 0 is the ground, 1 the lid. */
static void
block_walls(
	struct shape *out, const struct shape *in, struct ring ring, long top)
{
	for (size_t i = ring.count; i-- > 0;) {
		struct spot a = in->spots[ring.first + i];
		struct spot b = in->spots[ring.first +
			(i + ring.count - 1) % ring.count];
		struct spot quad[] = {a, b, b, a};

		quad[2].z = quad[3].z = top;
		shape_face(out, FACE_WALL);
		for (size_t j = 0; j < 4; j++)
			shape_point(out, 0, 0, 0);
		memcpy(&out->spots[out->spot_count - 4], quad, sizeof quad);
	}
}

/* The ground's rings at one height, as they are or turned over. */
static void
ground_copy(struct shape *out, const struct shape *in, long z, bool over,
	enum face_class class)
{
	const struct face *face = ground(in);

	shape_face(out, class);
	for (size_t r = 0; r < face->ring_count; r++) {
		struct ring ring = in->rings[face->first_ring + r];

		if (r > 0)
			shape_hole(out);
		for (size_t i = 0; i < ring.count; i++) {
			size_t at = over ? ring.count - 1 - i : i;

			shape_point(out, 0, 0, 0);
			out->spots[out->spot_count - 1] =
				in->spots[ring.first + at];
			out->spots[out->spot_count - 1].z = z;
		}
	}
}

static void
make_block(struct shape *out, const struct shape *in, long top)
{
	const struct face *face = ground(in);

	shape_begin(out, in->frame);
	ground_copy(out, in, in->frame.origin.z, false, FACE_GROUND);
	ground_copy(out, in, top, true, FACE_ROOF);
	for (size_t r = 0; r < face->ring_count; r++)
		block_walls(out, in, in->rings[face->first_ring + r], top);
}

static void
write_lod0(const struct writing *w)
{
	struct gml *gml = w->gml;
	long base = w->shape->frame.origin.z;

	if (!gml->lods[0] || gml->version == 1)
		return;
	shape_begin(w->other, w->shape->frame);
	ground_copy(w->other, w->shape, base, true, FACE_ROOF);
	gml_multi_surface(gml,
		gml_name(gml, "bldg:lod0FootPrint", "core:lod0MultiSurface"),
		w->other);
	if (gml->version == 3 || w->building->number % 2)
		return;
	shape_begin(w->other, w->shape->frame);
	ground_copy(w->other, w->shape, base + (long)(1000 * w->body->eaves),
		true, FACE_ROOF);
	gml_multi_surface(gml, "bldg:lod0RoofEdge", w->other);
}

static void
write_lod1(const struct writing *w)
{
	double half = w->body->eaves + w->body->rise / 2;

	if (!w->gml->lods[1])
		return;
	make_block(w->other, w->shape,
		w->shape->frame.origin.z + (long)(1000 * half));
	gml_solid(w->gml, gml_lod_name(w->gml, "bldg", 1, "Solid").text,
		w->other);
}

/* ---- LOD2 and LOD3 solids ---- */

static void
cavity(const struct writing *w)
{
	const struct body *body = w->body;

	shape_begin(w->other, w->shape->frame);
	shape_cavity(w->other, (struct local){body->u + 1, 1, 0.5},
		(struct local){body->u + body->width - 1, body->depth - 1,
			body->eaves - 0.5},
		FACE_INNER_WALL, FACE_FLOOR, FACE_CEILING);
}

static void
write_solid(const struct writing *w, int lod)
{
	struct gml *gml = w->gml;
	struct lod_name property = gml_lod_name(gml, "bldg", lod, "Solid");
	bool holds = lod == 2 && w->building->solid_holds;
	char id[GML_ID];

	gml_open(gml, property.text, NULL);
	gml_solid_open(gml, NULL);
	for (size_t i = 0; i < w->shape->face_count; i++) {
		polygon_id(id, w->id, lod, i);
		if (!holds) {
			gml_link(gml, "gml:surfaceMember", id);
			continue;
		}
		gml_open(gml, "gml:surfaceMember", NULL);
		gml_polygon(gml, id, w->shape, &w->shape->faces[i], false);
		gml_close(gml, "gml:surfaceMember");
	}
	for (size_t i = 0; lod == 3 && i < w->shape->opening_count; i++) {
		opening_id(id, w->id, i);
		gml_link(gml, "gml:surfaceMember", id);
	}
	if (w->building->has_void) {
		gml_solid_void(gml);
		cavity(w);
		gml_members(gml, w->other, 0, w->other->face_count);
	}
	gml_solid_close(gml);
	gml_close(gml, property.text);
}

/* ---- boundary surfaces ---- */

/* The wall that the neighbour before has written, turned over. */
static void
write_shared_wall(const struct writing *w, const char *id, size_t face)
{
	char neighbour[GML_ID], polygon[GML_ID], attributes[GML_ID + 16];

	building_id(neighbour, w->building->number - 1);
	polygon_id(polygon, neighbour, 2, face + 1);
	snprintf(attributes, sizeof attributes, "-\" gml:id=\"%s", id);
	gml_open_with(
		w->gml, "gml:OrientableSurface", "orientation", attributes);
	gml_link(w->gml, "gml:baseSurface", polygon);
	gml_close(w->gml, "gml:OrientableSurface");
}

static void
write_face_lod(const struct writing *w, size_t face, int lod)
{
	struct gml *gml = w->gml;
	struct lod_name property =
		gml_lod_name(gml, "bldg", lod, "MultiSurface");
	char id[GML_ID], fresh[GML_ID];

	polygon_id(id, w->id, lod, face);
	gml_fresh_id(gml, fresh);
	gml_open(gml, property.text, NULL);
	gml_open(gml, "gml:MultiSurface", fresh);
	if (lod == 2 && w->building->solid_holds) {
		gml_link(gml, "gml:surfaceMember", id);
	} else {
		gml_open(gml, "gml:surfaceMember", NULL);
		if (lod == 2 && is_shared(w, face))
			write_shared_wall(w, id, face);
		else
			gml_polygon(gml, id, w->shape, &w->shape->faces[face],
				lod == 3);
		gml_close(gml, "gml:surfaceMember");
	}
	gml_close(gml, "gml:MultiSurface");
	gml_close(gml, property.text);
}

static void
write_opening(const struct writing *w, size_t index)
{
	struct gml *gml = w->gml;
	const struct opening *opening = &w->shape->openings[index];
	const char *property =
		gml_name(gml, "bldg:opening", "con:fillingSurface");
	const char *name = opening->door
		? gml_name(gml, "bldg:Door", "con:DoorSurface")
		: gml_name(gml, "bldg:Window", "con:WindowSurface");
	struct lod_name lod = gml_lod_name(gml, "bldg", 3, "MultiSurface");
	char id[GML_ID];

	snprintf(id, sizeof id, "%s_O%zu", w->id, index);
	gml_open(gml, property, NULL);
	gml_open(gml, name, id);
	gml_fresh_id(gml, id);
	gml_open(gml, lod.text, NULL);
	gml_open(gml, "gml:MultiSurface", id);
	gml_open(gml, "gml:surfaceMember", NULL);
	opening_id(id, w->id, index);
	gml_ring_polygon(gml, id, w->shape, opening->ring, false);
	gml_close(gml, "gml:surfaceMember");
	gml_close(gml, "gml:MultiSurface");
	gml_close(gml, lod.text);
	gml_close(gml, name);
	gml_close(gml, property);
}

static void
write_surface(const struct writing *w, size_t index)
{
	const struct face *face = &w->shape->faces[index];
	const char *class = gml_surface_class(w->gml, face->class);
	bool lod3 = w->gml->lods[3] && w->building->lod3;
	char id[GML_ID];

	snprintf(id, sizeof id, "%s_S%zu", w->id, index);
	gml_boundary_open(w->gml, "bldg", class, id);
	if (w->gml->lods[2])
		write_face_lod(w, index, 2);
	if (lod3)
		write_face_lod(w, index, 3);
	for (size_t i = 0; lod3 && i < face->opening_count; i++)
		write_opening(w, face->first_opening + i);
	gml_boundary_close(w->gml, "bldg", class);
}

static void
write_surfaces(const struct writing *w)
{
	bool lod3 = w->gml->lods[3] && w->building->lod3;

	if (!w->gml->lods[2] && !lod3)
		return;
	for (size_t i = 0; i < w->shape->face_count; i++)
		write_surface(w, i);
}

/* ---- installations ---- */

static void
raise_installation(struct shape *shape, const struct writing *w,
	const struct installation *item)
{
	static const enum face_class classes[] = {
		FACE_GROUND,
		FACE_WALL,
		FACE_ROOF,
		FACE_ROOF,
		FACE_WALL,
	};
	struct local low = item->low, high = item->high;
	double middle = (low.u + high.u) / 2, eaves = high.z - 0.7;
	const double profile[][2] = {
		{-high.u, low.z},
		{-low.u, low.z},
		{-low.u, eaves},
		{-middle, high.z},
		{-high.u, eaves},
	};
	struct frame turned = w->shape->frame;

	if (item->kind != INSTALLATION_DORMER) {
		shape_begin(shape, w->shape->frame);
		shape_box(shape, low, high);
		return;
	}
	/* A gable that looks at the street: v runs along the wall. */
	turned.cosine = -w->shape->frame.sine;
	turned.sine = w->shape->frame.cosine;
	shape_begin(shape, turned);
	shape_extrude(shape, profile, classes, 5, low.v, high.v);
}

static void
write_installation(const struct writing *w, const struct installation *item)
{
	static const char *const codes[] = {
		[INSTALLATION_CHIMNEY] = "1030",
		[INSTALLATION_DORMER] = "1010",
		[INSTALLATION_BALCONY] = "1000",
	};
	struct gml *gml = w->gml;
	const char *property = gml_name(gml, "bldg:outerBuildingInstallation",
		"bldg:buildingInstallation");
	char id[GML_ID];

	snprintf(id, sizeof id, "%s_I%d", w->id, (int)item->kind);
	raise_installation(w->other, w, item);
	gml_open(gml, property, NULL);
	gml_open(gml, "bldg:BuildingInstallation", id);
	if (gml->version == 3) {
		gml_solid(gml, "core:lod2Solid", w->other);
		gml_leaf(gml, "con:relationToConstruction", "outside");
		gml_code(gml, "bldg:function", codes[item->kind]);
	} else {
		gml_code(gml, "bldg:function", codes[item->kind]);
		gml_solid(gml, "bldg:lod2Geometry", w->other);
	}
	gml_close(gml, "bldg:BuildingInstallation");
	gml_close(gml, property);
}

static void
write_installations(const struct writing *w)
{
	for (size_t i = 0; w->gml->lods[2] && i < 3; i++)
		if (w->body->installations[i].kind != INSTALLATION_NONE)
			write_installation(w, &w->body->installations[i]);
}

/* ---- facts ---- */

static void
write_facts_2(const struct writing *w)
{
	struct gml *gml = w->gml;
	const struct building *building = w->building;

	gml_code(gml, "bldg:class", "1000");
	gml_code(gml, "bldg:function", building->function);
	gml_code(gml, "bldg:usage", building->function);
	gml_number(gml, "bldg:yearOfConstruction", (long)building->year);
	gml_code(gml, "bldg:roofType", building->roof);
	gml_metres(gml, "bldg:measuredHeight",
		w->shape->top - w->shape->frame.origin.z);
	gml_number(gml, "bldg:storeysAboveGround", (long)w->body->storeys);
}

static void
write_facts_3(const struct writing *w)
{
	struct gml *gml = w->gml;
	const struct building *building = w->building;
	char date[16];

	snprintf(date, sizeof date, "%04u-01-01", building->year);
	gml_leaf(gml, "con:dateOfConstruction", date);
	gml_open(gml, "con:height", NULL);
	gml_open(gml, "con:Height", NULL);
	gml_leaf(gml, "con:highReference", "highestRoofEdge");
	gml_leaf(gml, "con:lowReference", "lowestGroundPoint");
	gml_leaf(gml, "con:status", "measured");
	gml_metres(gml, "con:value", w->shape->top - w->shape->frame.origin.z);
	gml_close(gml, "con:Height");
	gml_close(gml, "con:height");
	gml_code(gml, "bldg:class", "1000");
	gml_code(gml, "bldg:function", building->function);
	gml_code(gml, "bldg:usage", building->function);
	gml_code(gml, "bldg:roofType", building->roof);
	gml_number(gml, "bldg:storeysAboveGround", (long)w->body->storeys);
}

static void
write_generics(struct gml *gml, const struct building *building)
{
	char text[64];

	snprintf(text, sizeof text, "DEBW_%07u", building->number);
	gml_generic(gml, "string", "Gebäudekennzahl", text, NULL);
	if (building->number % 4)
		return;
	gml_generic(gml, "int", "households", building->number % 3 ? "3" : "12",
		NULL);
	gml_generic(gml, "double", "sunlight", "0.73", NULL);
	gml_generic(gml, "date", "surveyed", "2024-05-17", NULL);
	gml_generic(gml, "uri", "sheet",
		"https://example.org/sheet?id=7&amp;v=2", NULL);
	gml_generic(gml, "measure", "floorArea", "184.5", "m2");
	gml_generic_set_open(gml, "energy", "https://example.org/codes/energy");
	gml_generic(gml, "string", "class", "B", NULL);
	gml_generic(gml, "measure", "demand", "86.4", "kWh/(m2.a)");
	gml_generic_set_close(gml);
}

static void
write_reference(struct gml *gml, const struct building *building)
{
	char text[64];

	snprintf(text, sizeof text, "urn:x-cadastre:DEBW_%07u",
		building->number);
	gml_open(gml, "core:externalReference", NULL);
	if (gml->version == 3) {
		gml_open(gml, "core:ExternalReference", NULL);
		gml_leaf(gml, "core:targetResource", text);
		gml_leaf(gml, "core:informationSystem",
			"https://example.org/cadastre");
		gml_close(gml, "core:ExternalReference");
	} else {
		gml_leaf(gml, "core:informationSystem",
			"https://example.org/cadastre");
		gml_open(gml, "core:externalObject", NULL);
		gml_leaf(gml, "core:uri", text);
		gml_close(gml, "core:externalObject");
	}
	gml_close(gml, "core:externalReference");
}

/* ---- appearance ---- */

static void
write_targets(const struct writing *w, bool roof)
{
	char id[GML_ID + 1] = "#";

	for (size_t i = 0; i < w->shape->face_count; i++) {
		bool is_roof = w->shape->faces[i].class == FACE_ROOF;

		if (is_roof != roof || is_shared(w, i))
			continue;
		for (int lod = 2; lod <= 3; lod++) {
			if (!w->gml->lods[lod] ||
				(lod == 3 && !w->building->lod3))
				continue;
			polygon_id(id + 1, w->id, lod, i);
			gml_leaf(w->gml, "app:target", id);
		}
	}
}

static void
write_material(const struct writing *w, struct colour colour, const char *what,
	bool roof)
{
	char id[GML_ID];

	snprintf(id, sizeof id, "%s_M%s", w->id, what);
	gml_material_open(w->gml, id, colour);
	write_targets(w, roof);
	gml_material_close(w->gml);
}

/* Its own colours, and a second theme that tells old from new. */
static void
write_appearance(const struct writing *w)
{
	const struct colour old = {178, 122, 74, 0}, new = {108, 156, 188, 0};
	struct colour age = w->building->year < 1900 ? old : new;
	char id[GML_ID];

	if (!w->gml->lods[2] && !(w->gml->lods[3] && w->building->lod3))
		return;
	gml_fresh_id(w->gml, id);
	gml_appearance_open(w->gml, false, id, "Farben");
	write_material(w, w->building->wall, "wall", false);
	write_material(w, w->building->paint, "roof", true);
	gml_appearance_close(w->gml, false);
	if (w->building->number % 6)
		return;
	gml_fresh_id(w->gml, id);
	gml_appearance_open(w->gml, false, id, "age");
	write_material(w, age, "age", true);
	gml_appearance_close(w->gml, false);
}

/* ---- bodies, parts and the building ---- */

/* Everything of one body, in the order that the version asks for. */
static void
write_body_2(const struct writing *w)
{
	write_facts_2(w);
	write_lod0(w);
	write_lod1(w);
	if (w->gml->lods[2])
		write_solid(w, 2);
	write_installations(w);
	write_surfaces(w);
	if (w->gml->lods[3] && w->building->lod3)
		write_solid(w, 3);
	if (w->building->interior)
		rooms_write_2(w->gml, w->body, w->id, w->other);
}

static void
write_body_3(const struct writing *w)
{
	write_surfaces(w);
	write_lod0(w);
	write_lod1(w);
	if (w->gml->lods[2])
		write_solid(w, 2);
	if (w->gml->lods[3] && w->building->lod3)
		write_solid(w, 3);
	write_facts_3(w);
	write_installations(w);
	if (w->building->interior)
		rooms_write_3(w->gml, w->body, w->id, w->other);
}

static void
raise_body(struct writing *w, size_t body)
{
	w->body = &w->building->bodies[body];
	w->shares_wall = w->building->shares_wall && body == 0;
	shape_begin(w->shape, w->body->frame);
	w->body->raise(w->shape, w->body);
}

static void
write_body(const struct writing *w)
{
	if (w->gml->version == 3)
		write_body_3(w);
	else
		write_body_2(w);
}

static void
write_parts(struct writing *w)
{
	const char *property = gml_name(
		w->gml, "bldg:consistsOfBuildingPart", "bldg:buildingPart");

	for (size_t i = 0; i < w->building->body_count; i++) {
		snprintf(w->id, sizeof w->id, "B%u_P%zu", w->building->number,
			i + 1);
		raise_body(w, i);
		gml_open(w->gml, property, NULL);
		gml_open(w->gml, "bldg:BuildingPart", w->id);
		if (w->building->painted)
			write_appearance(w);
		write_body(w);
		gml_close(w->gml, "bldg:BuildingPart");
		gml_close(w->gml, property);
	}
}

static void
write_head(struct gml *gml, const struct building *building)
{
	if (building->name) {
		gml_leaf(gml, "gml:description",
			"Aus dem Mustermodell der Stadt " TOWN_NAME);
		gml_leaf(gml, "gml:name", building->name);
	}
	gml_leaf(gml, "core:creationDate",
		gml_name(gml, "2024-06-01", "2024-06-01T00:00:00"));
	write_reference(gml, building);
}

/*
 * In 3.0 generic attributes follow appearances, in 2.0 both are the same kind
 * of property; with parts, appearances are the parts' own.
 */
void
building_write(struct gml *gml, const struct building *building,
	struct shape scratch[2])
{
	struct writing w = {
		.gml = gml,
		.building = building,
		.shape = &scratch[0],
		.other = &scratch[1],
	};
	bool parts = building->body_count > 1;

	snprintf(w.id, sizeof w.id, "B%u", building->number);
	gml_member_open(gml, "bldg:Building", w.id);
	write_head(gml, building);
	raise_body(&w, 0);
	if (building->painted && !parts)
		write_appearance(&w);
	write_generics(gml, building);
	if (!parts)
		write_body(&w);
	else if (gml->version == 3)
		gml_code(gml, "bldg:function", building->function);
	if (parts && gml->version < 3)
		write_parts(&w);
	if (building->house > 0)
		gml_address(
			gml, "bldg:address", building->street, building->house);
	if (parts && gml->version == 3)
		write_parts(&w);
	gml_member_close(gml, "bldg:Building");
}
