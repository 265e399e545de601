#include "town_room.h"

#define WALL 0.4 /* thickness of outer walls and ceilings, metres */
#define STOREY 2.9

struct room {
	const char *name;
	unsigned storey;
	double table; /* height of the piece of furniture */
};

static const struct room rooms[] = {
	{"Lesesaal", 0, 0.75},
	{"Magazin", 1, 1.9},
};

enum { ROOMS = sizeof rooms / sizeof *rooms };

static void
raise_room(struct shape *shape, const struct body *body, unsigned storey)
{
	double floor = STOREY * storey + 0.15;

	shape_begin(shape, body->frame);
	shape_cavity(shape, (struct local){body->u + WALL, WALL, floor},
		(struct local){body->u + body->width - WALL, body->depth - WALL,
			floor + STOREY - WALL},
		FACE_INNER_WALL, FACE_FLOOR, FACE_CEILING);
}

static const char *room_class(enum face_class class)
{
	if (class == FACE_FLOOR)
		return "FloorSurface";
	return class == FACE_CEILING ? "CeilingSurface" : "InteriorWallSurface";
}

static void
write_surfaces(struct gml *gml, const char *id, const struct shape *shape)
{
	struct lod_name lod = gml_lod_name(gml, "bldg", 4, "MultiSurface");

	for (size_t i = 0; i < shape->face_count; i++) {
		const char *class = room_class(shape->faces[i].class);
		char face[GML_ID];

		snprintf(face, sizeof face, "%s_S%zu", id, i);
		gml_boundary_open(gml, "bldg", class, face);
		gml_open(gml, lod.text, NULL);
		gml_fresh_id(gml, face);
		gml_open(gml, "gml:MultiSurface", face);
		gml_open(gml, "gml:surfaceMember", NULL);
		snprintf(face, sizeof face, "%s_L4_%zu", id, i);
		gml_polygon(gml, face, shape, &shape->faces[i], false);
		gml_close(gml, "gml:surfaceMember");
		gml_close(gml, "gml:MultiSurface");
		gml_close(gml, lod.text);
		gml_boundary_close(gml, "bldg", class);
	}
}

/* The room as a solid: its surfaces, which look inwards, turned over. */
static void
write_solid(struct gml *gml, const char *id, const struct shape *shape)
{
	struct lod_name lod = gml_lod_name(gml, "bldg", 4, "Solid");
	char text[2 * GML_ID];

	gml_open(gml, lod.text, NULL);
	gml_solid_open(gml, NULL);
	for (size_t i = 0; i < shape->face_count; i++) {
		char fresh[GML_ID];

		gml_fresh_id(gml, fresh);
		snprintf(text, sizeof text, "-\" gml:id=\"%s", fresh);
		gml_open(gml, "gml:surfaceMember", NULL);
		gml_open_with(
			gml, "gml:OrientableSurface", "orientation", text);
		snprintf(text, sizeof text, "%s_L4_%zu", id, i);
		gml_link(gml, "gml:baseSurface", text);
		gml_close(gml, "gml:OrientableSurface");
		gml_close(gml, "gml:surfaceMember");
	}
	gml_solid_close(gml);
	gml_close(gml, lod.text);
}

static void
write_furniture(struct gml *gml, const struct body *body, const char *id,
	const struct room *room, struct shape *scratch)
{
	const char *property = gml_name(
		gml, "bldg:interiorFurniture", "bldg:buildingFurniture");
	double floor = STOREY * room->storey + 0.15;
	char piece[GML_ID];

	snprintf(piece, sizeof piece, "%s_F", id);
	shape_begin(scratch, body->frame);
	shape_box(scratch, (struct local){body->u + 3, 3, floor},
		(struct local){body->u + 5, 4, floor + room->table});
	gml_open(gml, property, NULL);
	gml_open(gml, "bldg:BuildingFurniture", piece);
	if (gml->version < 3)
		gml_code(gml, "bldg:function", "1310");
	gml_multi_surface(gml,
		gml_name(gml, "bldg:lod4Geometry", "core:lod3MultiSurface"),
		scratch);
	if (gml->version == 3)
		gml_code(gml, "bldg:function", "1310");
	gml_close(gml, "bldg:BuildingFurniture");
	gml_close(gml, property);
}

static void
room_id(char out[GML_ID], const char *id, const struct room *room)
{
	snprintf(out, GML_ID, "%s_R%u", id, room->storey + 1);
}

void
rooms_write_2(struct gml *gml, const struct body *body, const char *id,
	struct shape *scratch)
{
	for (size_t i = 0; gml->lods[4] && i < ROOMS; i++) {
		char room[GML_ID];

		room_id(room, id, &rooms[i]);
		raise_room(scratch, body, rooms[i].storey);
		gml_open(gml, "bldg:interiorRoom", NULL);
		gml_open(gml, "bldg:Room", room);
		gml_leaf(gml, "gml:name", rooms[i].name);
		write_solid(gml, room, scratch);
		write_surfaces(gml, room, scratch);
		write_furniture(gml, body, room, &rooms[i], scratch);
		gml_close(gml, "bldg:Room");
		gml_close(gml, "bldg:interiorRoom");
	}
}

static void
write_storey(struct gml *gml, const char *id, const struct room *room)
{
	char storey[GML_ID], inside[GML_ID];

	snprintf(storey, sizeof storey, "%s_St%u", id, room->storey + 1);
	room_id(inside, id, room);
	gml_open(gml, "bldg:buildingSubdivision", NULL);
	gml_open(gml, "bldg:Storey", storey);
	gml_leaf(
		gml, "gml:name", room->storey ? "Obergeschoss" : "Erdgeschoss");
	gml_number(gml, "bldg:sortKey", (long)room->storey);
	gml_link(gml, "bldg:buildingRoom", inside);
	gml_close(gml, "bldg:Storey");
	gml_close(gml, "bldg:buildingSubdivision");
}

static void
write_unit(struct gml *gml, const char *id)
{
	char text[GML_ID];

	snprintf(text, sizeof text, "%s_U", id);
	gml_open(gml, "bldg:buildingSubdivision", NULL);
	gml_open(gml, "bldg:BuildingUnit", text);
	gml_leaf(gml, "gml:name", "Bücherei");
	gml_code(gml, "bldg:function", "2500");
	room_id(text, id, &rooms[0]);
	gml_link(gml, "bldg:buildingRoom", text);
	snprintf(text, sizeof text, "%s_St1", id);
	gml_link(gml, "bldg:storey", text);
	gml_close(gml, "bldg:BuildingUnit");
	gml_close(gml, "bldg:buildingSubdivision");
}

void
rooms_write_3(struct gml *gml, const struct body *body, const char *id,
	struct shape *scratch)
{
	if (!gml->lods[3])
		return;
	for (size_t i = 0; i < ROOMS; i++) {
		char room[GML_ID];

		room_id(room, id, &rooms[i]);
		raise_room(scratch, body, rooms[i].storey);
		gml_open(gml, "bldg:buildingRoom", NULL);
		gml_open(gml, "bldg:BuildingRoom", room);
		gml_leaf(gml, "gml:name", rooms[i].name);
		write_surfaces(gml, room, scratch);
		write_solid(gml, room, scratch);
		write_furniture(gml, body, room, &rooms[i], scratch);
		gml_close(gml, "bldg:BuildingRoom");
		gml_close(gml, "bldg:buildingRoom");
	}
	for (size_t i = 0; i < ROOMS; i++)
		write_storey(gml, id, &rooms[i]);
	write_unit(gml, id);
}
