/*
 * makehouse writes a small house as IFC2X3 or IFC4, the same bytes for the same
 * schema: walls with a door and windows in their openings, gables clipped by
 * half-spaces, bounded and not, a roof, a stair, rooms, furniture that is
 * mapped, property sets, layers, colours and, in IFC4, a map conversion.
 *
 * Millimetres. The house is 8 by 6 metres, its walls 300 thick, its eaves 3000
 * high and its ridge, along x in the middle, 5000.
 */
#include <string.h>

#include "house_step.h"
#include "output.h"
#include "program.h"

/* What stands in the storey, to be related to it in the end. */
struct plan {
	struct house house;
	unsigned project, site, building, storey, room;
	unsigned walls[4], wall_count;
	unsigned products[32], product_count;
	unsigned plaster, glass, wood, tiles; /* styles */
};

/* ---- the frame ----------------------------------------------------------- */

static void
header_write(struct house *house)
{
	const char *schema = house->schema == HOUSE_4 ? "IFC4" : "IFC2X3";

	fprintf(house->file,
		"ISO-10303-21;\nHEADER;\n"
		"FILE_DESCRIPTION(('ViewDefinition [CoordinationView]'),"
		"'2;1');\n"
		"FILE_NAME('house.ifc','2026-01-01T00:00:00',(''),(''),"
		"'tessera','makehouse','');\n"
		"FILE_SCHEMA(('%s'));\nENDSEC;\nDATA;\n",
		schema);
}

static unsigned
units_write(struct house *house)
{
	unsigned length =
		house_write(house, "IFCSIUNIT(*,.LENGTHUNIT.,.MILLI.,.METRE.)");
	unsigned area =
		house_write(house, "IFCSIUNIT(*,.AREAUNIT.,$,.SQUARE_METRE.)");
	unsigned volume =
		house_write(house, "IFCSIUNIT(*,.VOLUMEUNIT.,$,.CUBIC_METRE.)");
	unsigned radian =
		house_write(house, "IFCSIUNIT(*,.PLANEANGLEUNIT.,$,.RADIAN.)");
	unsigned factor = house_write(house,
		"IFCMEASUREWITHUNIT(IFCPLANEANGLEMEASURE(0.017453292519943295),"
		"#%u)",
		radian);
	unsigned exponents =
		house_write(house, "IFCDIMENSIONALEXPONENTS(0,0,0,0,0,0,0)");
	unsigned degree = house_write(house,
		"IFCCONVERSIONBASEDUNIT(#%u,.PLANEANGLEUNIT.,'DEGREE',#%u)",
		exponents, factor);

	return house_write(house, "IFCUNITASSIGNMENT((#%u,#%u,#%u,#%u))",
		length, area, volume, degree);
}

static void
owner_write(struct house *house)
{
	unsigned person =
		house_write(house, "IFCPERSON($,'Nobody',$,$,$,$,$,$)");
	unsigned office =
		house_write(house, "IFCORGANIZATION($,'tessera',$,$,$)");
	unsigned both = house_write(
		house, "IFCPERSONANDORGANIZATION(#%u,#%u,$)", person, office);
	unsigned program = house_write(house,
		"IFCAPPLICATION(#%u,'1','makehouse','makehouse')", office);

	house->history = house_write(house,
		"IFCOWNERHISTORY(#%u,#%u,$,.ADDED.,$,$,$,1767225600)", both,
		program);
}

/* In IFC4, 33 degrees turned and moved into EPSG:25832. */
static void
map_write(struct house *house, unsigned context)
{
	unsigned metre, system;

	if (house->schema != HOUSE_4)
		return;
	metre = house_write(house, "IFCSIUNIT(*,.LENGTHUNIT.,$,.METRE.)");
	system = house_write(house,
		"IFCPROJECTEDCRS('EPSG:25832','ETRS89 / UTM 32N','ETRS89',"
		"'DHHN2016','UTM','32N',#%u)",
		metre);
	house_write(house,
		"IFCMAPCONVERSION(#%u,#%u,458000.,5438000.,112.,0.838670568,"
		"0.544639035,0.001)",
		context, system);
}

static void
frame_write(struct plan *plan)
{
	struct house *house = &plan->house;
	unsigned axes, context, units, place;
	char id[23];

	header_write(house);
	owner_write(house);
	units = units_write(house);
	house->up = house_direction(house, 0, 0, 1);
	axes = house_axes(house, 0, 0, 0);
	context = house_write(house,
		"IFCGEOMETRICREPRESENTATIONCONTEXT($,'Model',3,1.E-5,#%u,$)",
		axes);
	house->body = house_write(house,
		"IFCGEOMETRICREPRESENTATIONSUBCONTEXT('Body','Model',*,*,*,*,"
		"#%u,$,.MODEL_VIEW.,$)",
		context);
	map_write(house, context);
	plan->project = house_write(house,
		"IFCPROJECT('%s',#%u,'Sample house',$,$,$,$,(#%u),#%u)",
		house_id(house, id), house->history, context, units);
	place = house_place(house, 0, house_axes(house, 0, 0, 0));
	plan->site = house_write(house,
		"IFCSITE('%s',#%u,'Plot 7',$,$,#%u,$,$,.ELEMENT.,(49,5,30),"
		"(8,25,40),112.,$,$)",
		house_id(house, id), house->history, place);
	place = house_place(house, place, house_axes(house, 0, 0, 0));
	plan->building = house_write(house,
		"IFCBUILDING('%s',#%u,'House',$,$,#%u,$,$,.ELEMENT.,$,$,$)",
		house_id(house, id), house->history, place);
	place = house_place(house, place, house_axes(house, 0, 0, 0));
	house->storey_place = place;
	plan->storey = house_write(house,
		"IFCBUILDINGSTOREY('%s',#%u,'Ground floor',$,$,#%u,$,$,"
		".ELEMENT.,0.)",
		house_id(house, id), house->history, place);
}

static void
styles_write(struct plan *plan)
{
	struct house *house = &plan->house;

	plan->plaster = house_style(house, "Plaster", 0.93, 0.9, 0.82, 0);
	plan->glass = house_style(house, "Glass", 0.55, 0.75, 0.9, 0.6);
	plan->wood = house_style(house, "Wood", 0.5, 0.33, 0.18, 0);
	plan->tiles = house_style(house, "Tiles", 0.7, 0.25, 0.17, 0);
}

/* ---- products ------------------------------------------------------------ */

static unsigned
product_keep(struct plan *plan, unsigned product)
{
	plan->products[plan->product_count++] = product;
	return product;
}

/* An element with a body at the origin of the storey. */
static unsigned
element_write(struct plan *plan, const char *entity, const char *name,
	unsigned shape, const char *rest)
{
	struct house *house = &plan->house;
	unsigned place = house_place(
		house, house->storey_place, house_axes(house, 0, 0, 0));
	char id[23];

	return house_write(house, "%s('%s',#%u,'%s',$,$,#%u,#%u,$%s)", entity,
		house_id(house, id), house->history, name, place, shape, rest);
}

/* What the older schema lacks behind the tag. */
static const char *
rest_of(const struct plan *plan, const char *in_4)
{
	return plan->house.schema == HOUSE_4 ? in_4 : "";
}

static unsigned
wall_write(struct plan *plan, const char *name, unsigned item, const char *type)
{
	unsigned wall = element_write(plan, "IFCWALL", name,
		house_shape(&plan->house, type, item),
		rest_of(plan, ",.STANDARD."));

	house_paint(&plan->house, item, plan->plaster);
	plan->walls[plan->wall_count++] = wall;
	return product_keep(plan, wall);
}

/* An opening of a wall, and what fills it: a thin box in its middle. */
static void
opening_write(struct plan *plan, unsigned wall, const char *filling, double x,
	double y, double z, double width, double height)
{
	struct house *house = &plan->house;
	bool door = !strcmp(filling, "IFCDOOR");
	unsigned box = house_box(
		house, house_axes(house, x, y, z), width, 300, height);
	unsigned opening = element_write(plan, "IFCOPENINGELEMENT", "Opening",
		house_shape(house, "SweptSolid", box),
		rest_of(plan, ",.OPENING."));
	char rest[80];
	unsigned product;

	house_relate(house, "IFCRELVOIDSELEMENT", false, wall, &opening, 0);
	box = house_box(house, house_axes(house, x, y, z), width, 60, height);
	house_paint(house, box, door ? plan->wood : plan->glass);
	snprintf(rest, sizeof rest, ",%.1f,%.1f%s", height, width,
		rest_of(plan,
			door ? ",.DOOR.,.SINGLE_SWING_LEFT.,$"
			     : ",.WINDOW.,.SINGLE_PANEL.,$"));
	product = product_keep(plan,
		element_write(plan, filling, door ? "Door" : "Window",
			house_shape(house, "SweptSolid", box), rest));
	house_relate(house, "IFCRELFILLSELEMENT", false, opening, &product, 0);
}

static void
long_walls_write(struct plan *plan)
{
	struct house *house = &plan->house;
	unsigned wall = wall_write(plan, "South wall",
		house_box(house, house_axes(house, 4000, 150, 0), 8000, 300,
			3000),
		"SweptSolid");

	opening_write(plan, wall, "IFCDOOR", 1500, 150, 0, 1000, 2100);
	opening_write(plan, wall, "IFCWINDOW", 5750, 150, 900, 1500, 1400);
	wall = wall_write(plan, "North wall",
		house_box(house, house_axes(house, 4000, 5850, 0), 8000, 300,
			3000),
		"SweptSolid");
	opening_write(plan, wall, "IFCWINDOW", 4000, 5850, 900, 2000, 1400);
}

/*
 * What lies above a plane through the eaves on one side: a half-space whose
 * normal looks up and out.
 */
static unsigned
roof_plane(struct house *house, bool south)
{
	/* 2000 up over 3000 across. */
	unsigned point = house_point(house, 0, south ? 0 : 6000, 3000);
	unsigned normal = house_direction(
		house, 0, south ? -0.554700196 : 0.554700196, 0.832050294);
	unsigned along = house_direction(house, 1, 0, 0);
	unsigned axes = house_turned(house, point, normal, along);

	return house_write(house, "IFCPLANE(#%u)", axes);
}

/* The upper side of the plane, whole or over the northern half only. */
static unsigned
half_space(struct house *house, bool south)
{
	unsigned plane = roof_plane(house, south), axes, first, outline;

	if (south)
		return house_write(house, "IFCHALFSPACESOLID(#%u,.F.)", plane);
	axes = house_axes(house, 0, 3000, 0);
	first = house->last + 1;
	house_write(house, "IFCCARTESIANPOINT((-1000.,-1000.))");
	house_write(house, "IFCCARTESIANPOINT((9000.,-1000.))");
	house_write(house, "IFCCARTESIANPOINT((9000.,4000.))");
	house_write(house, "IFCCARTESIANPOINT((-1000.,4000.))");
	outline = house_write(house, "IFCPOLYLINE((#%u,#%u,#%u,#%u,#%u))",
		first, first + 1, first + 2, first + 3, first);
	return house_write(house,
		"IFCPOLYGONALBOUNDEDHALFSPACE(#%u,.F.,#%u,#%u)", plane, axes,
		outline);
}

static void
gables_write(struct plan *plan)
{
	struct house *house = &plan->house;

	for (int i = 0; i < 2; i++) {
		unsigned box = house_box(house,
			house_axes(house, i ? 7850 : 150, 3000, 0), 300, 5400,
			6000);
		unsigned half = half_space(house, true);
		unsigned clipped = house_write(house,
			"IFCBOOLEANCLIPPINGRESULT(.DIFFERENCE.,#%u,#%u)", box,
			half);

		half = half_space(house, false);
		clipped = house_write(house,
			"IFCBOOLEANCLIPPINGRESULT(.DIFFERENCE.,#%u,#%u)",
			clipped, half);
		wall_write(plan, i ? "East wall" : "West wall", clipped,
			"Clipping");
	}
}

static void
floor_write(struct plan *plan)
{
	struct house *house = &plan->house;
	unsigned item = house_box(
		house, house_axes(house, 4000, 3000, -200), 8000, 6000, 200);

	product_keep(plan,
		element_write(plan, "IFCSLAB", "Floor",
			house_shape(house, "SweptSolid", item), ",.BASESLAB."));
}

/* Two slabs of 200, of which the roof consists; their undersides meet. */
static void
roof_write(struct plan *plan)
{
	struct house *house = &plan->house;
	const double outlines[2][8] = {
		{-300, 2800, 3000, 5000, 3000, 5240.370, -300, 3040.370},
		{3000, 5000, 6300, 2800, 6300, 3040.370, 3000, 5240.370}};
	unsigned slabs[2], roof, place;
	char id[23];

	for (int i = 0; i < 2; i++) {
		unsigned point = house_point(house, -300, 0, 0);
		unsigned z = house_direction(house, 1, 0, 0);
		unsigned x = house_direction(house, 0, 1, 0);
		unsigned item = house_prism(house,
			house_turned(house, point, z, x), outlines[i], 4, 8600);

		house_paint(house, item, plan->tiles);
		slabs[i] = element_write(plan, "IFCSLAB",
			i ? "North roof" : "South roof",
			house_shape(house, "SweptSolid", item), ",.ROOF.");
	}
	place = house_place(
		house, house->storey_place, house_axes(house, 0, 0, 0));
	roof = house_write(house, "IFCROOF('%s',#%u,'Roof',$,$,#%u,$,$,%s)",
		house_id(house, id), house->history, place, ".GABLE_ROOF.");
	house_relate(house, "IFCRELAGGREGATES", false, roof, slabs, 2);
	product_keep(plan, roof);
}

/* Ten steps of 180 by 270, a metre wide, their undersides level. */
static void
stair_write(struct plan *plan)
{
	struct house *house = &plan->house;
	double outline[44];
	size_t count = 0;
	unsigned point, z, x, item;

	for (int i = 0; i < 10; i++) {
		outline[count++] = 270 * i;
		outline[count++] = 180 * i;
		outline[count++] = 270 * i;
		outline[count++] = 180 * (i + 1);
	}
	outline[count++] = 2700;
	outline[count++] = 1800;
	outline[count++] = 2700;
	outline[count++] = 0;
	/* The first corner lies on the last edge. */
	point = house_point(house, 4000, 4400, 0);
	z = house_direction(house, 0, 1, 0);
	x = house_direction(house, -1, 0, 0);
	item = house_prism(house, house_turned(house, point, z, x), outline + 2,
		count / 2 - 1, 1000);
	house_paint(house, item, plan->wood);
	product_keep(plan,
		element_write(plan, "IFCSTAIRFLIGHT", "Stair",
			house_shape(house, "SweptSolid", item),
			house->schema == HOUSE_4 ? ",10,10,180.,270.,.STRAIGHT."
						 : ",10,10,180.,270."));
}

/* A post of a round pipe, and a bowl turned about its axis. */
static void
round_write(struct plan *plan)
{
	struct house *house = &plan->house;
	unsigned profile, axes, point, item;

	profile = house_write(
		house, "IFCCIRCLEHOLLOWPROFILEDEF(.AREA.,$,$,100.,10.)");
	axes = house_axes(house, 2500, 3000, 0);
	item = house_write(house, "IFCEXTRUDEDAREASOLID(#%u,#%u,#%u,2800.)",
		profile, axes, house->up);
	product_keep(plan,
		element_write(plan, "IFCCOLUMN", "Post",
			house_shape(house, "SweptSolid", item),
			rest_of(plan, ",.COLUMN.")));
	profile = house_write(
		house, "IFCRECTANGLEPROFILEDEF(.AREA.,$,$,100.,50.)");
	axes = house_axes(house, 6000, 3000, 725);
	point = house_point(house, 150, 0, 0);
	point = house_write(house, "IFCAXIS1PLACEMENT(#%u,#%u)", point,
		house_direction(house, 0, 1, 0));
	item = house_write(house, "IFCREVOLVEDAREASOLID(#%u,#%u,#%u,360.)",
		profile, axes, point);
	product_keep(plan,
		element_write(plan, "IFCFURNISHINGELEMENT", "Ring",
			house_shape(house, "SweptSolid", item), ""));
}

/* Two tables, mapped, one of them turned. */
static void
tables_write(struct plan *plan)
{
	struct house *house = &plan->house;
	unsigned item, map, target, axes, shape, turned;

	item = house_box(house, house_axes(house, 0, 0, 680), 1200, 800, 20);
	house_paint(house, item, plan->wood);
	shape = house_write(house,
		"IFCSHAPEREPRESENTATION(#%u,'Body','SweptSolid',(#%u))",
		house->body, item);
	axes = house_axes(house, 0, 0, 0);
	map = house_write(house, "IFCREPRESENTATIONMAP(#%u,#%u)", axes, shape);
	turned = house_direction(house, 0, 1, 0);
	for (int i = 0; i < 2; i++) {
		unsigned point = house_point(house, 6000, i ? 4500 : 3000, 0);

		target = i ? house_write(house,
				     "IFCCARTESIANTRANSFORMATIONOPERATOR3D("
				     "#%u,$,#%u,$,$)",
				     turned, point)
			   : house_write(house,
				     "IFCCARTESIANTRANSFORMATIONOPERATOR3D("
				     "$,$,#%u,$,$)",
				     point);
		item = house_write(
			house, "IFCMAPPEDITEM(#%u,#%u)", map, target);
		product_keep(plan,
			element_write(plan, "IFCFURNISHINGELEMENT", "Table",
				house_shape(
					house, "MappedRepresentation", item),
				""));
	}
}

static void
room_write(struct plan *plan)
{
	struct house *house = &plan->house;
	unsigned item = house_box(
		house, house_axes(house, 4000, 3000, 0), 7400, 5400, 2800);
	unsigned shape = house_shape(house, "SweptSolid", item);
	unsigned place = house_place(
		house, house->storey_place, house_axes(house, 0, 0, 0));
	char id[23];

	plan->room = house_write(house,
		"IFCSPACE('%s',#%u,'1',$,$,#%u,#%u,'Living room',.ELEMENT.,"
		".INTERNAL.,$)",
		house_id(house, id), house->history, place, shape);
}

/* ---- what is said about them --------------------------------------------- */

static void
layers_write(struct plan *plan)
{
	struct house *house = &plan->house;
	const char *rest = rest_of(plan, ",$,$");
	const char *more = rest_of(plan, ",$,$,$,$");
	unsigned brick = house_write(house, "IFCMATERIAL('Brick'%s)", rest);
	unsigned wool =
		house_write(house, "IFCMATERIAL('Mineral wool'%s)", rest);
	unsigned inner = house_write(
		house, "IFCMATERIALLAYER(#%u,175.,$%s)", brick, more);
	unsigned outer = house_write(
		house, "IFCMATERIALLAYER(#%u,125.,$%s)", wool, more);
	unsigned set = house_write(house,
		"IFCMATERIALLAYERSET((#%u,#%u),'Outer wall'%s)", inner, outer,
		rest_of(plan, ",$"));
	unsigned usage = house_write(house,
		"IFCMATERIALLAYERSETUSAGE(#%u,.AXIS2.,.POSITIVE.,0.%s)", set,
		rest_of(plan, ",$"));

	house_relate(house, "IFCRELASSOCIATESMATERIAL", true, usage,
		plan->walls, plan->wall_count);
}

static void
properties_write(struct plan *plan)
{
	struct house *house = &plan->house;
	unsigned outside = house_write(house,
		"IFCPROPERTYSINGLEVALUE('IsExternal',$,IFCBOOLEAN(.T.),$)");
	unsigned bears = house_write(house,
		"IFCPROPERTYSINGLEVALUE('LoadBearing',$,IFCBOOLEAN(.T.),$)");
	unsigned made = house_write(house,
		"IFCPROPERTYSINGLEVALUE('Reference',$,"
		"IFCIDENTIFIER('Au\\X2\\00DF\\X0\\enwand 30'),$)");
	unsigned quantity, set;
	char id[23];

	set = house_write(house,
		"IFCPROPERTYSET('%s',#%u,'Pset_WallCommon',$,(#%u,#%u,#%u))",
		house_id(house, id), house->history, outside, bears, made);
	house_relate(house, "IFCRELDEFINESBYPROPERTIES", true, set, plan->walls,
		plan->wall_count);
	quantity = house_write(house,
		"IFCQUANTITYVOLUME('NetVolume',$,$,111.888%s)",
		rest_of(plan, ",$"));
	set = house_write(house,
		"IFCELEMENTQUANTITY('%s',#%u,'Qto_SpaceBaseQuantities',$,$,"
		"(#%u))",
		house_id(house, id), house->history, quantity);
	house_relate(
		house, "IFCRELDEFINESBYPROPERTIES", true, set, &plan->room, 1);
}

static void
tree_write(struct plan *plan)
{
	struct house *house = &plan->house;

	house_relate(house, "IFCRELAGGREGATES", false, plan->project,
		&plan->site, 1);
	house_relate(house, "IFCRELAGGREGATES", false, plan->site,
		&plan->building, 1);
	house_relate(house, "IFCRELAGGREGATES", false, plan->building,
		&plan->storey, 1);
	house_relate(
		house, "IFCRELAGGREGATES", false, plan->storey, &plan->room, 1);
	house_relate(house, "IFCRELCONTAINEDINSPATIALSTRUCTURE", true,
		plan->storey, plan->products, plan->product_count);
	fputs("ENDSEC;\nEND-ISO-10303-21;\n", house->file);
}

static const char *
parse_schema(void *target, const char *argument)
{
	enum house_schema *schema = target;

	*schema = !strcmp(argument, "IFC2X3") ? HOUSE_2X3 : HOUSE_4;
	return *schema == HOUSE_2X3 || !strcmp(argument, "IFC4")
		? NULL
		: "neither IFC2X3 nor IFC4";
}

int
main(int argc, char **argv)
{
	struct plan plan = {.house.schema = HOUSE_4};
	const struct option_row rows[] = {
		{.type = OPTION_PARSE,
			.name = "schema",
			.argument = "NAME",
			.help = "IFC2X3 or IFC4 (the default).",
			.target = &plan.house.schema,
			.parse = parse_schema},
		{0},
	};
	const struct program program = {
		.name = "makehouse",
		.synopsis = "[options]",
		.summary = "Write a small house as IFC.",
		.options = rows,
	};
	struct output output = {0};
	struct command command;
	struct tcs_fault fault;

	program_begin(&program, argc, argv, &command);
	if (output_open(&output, command.output, &fault))
		return program_fail(&command, &fault);
	plan.house.file = output.file;
	frame_write(&plan);
	styles_write(&plan);
	long_walls_write(&plan);
	gables_write(&plan);
	floor_write(&plan);
	roof_write(&plan);
	stair_write(&plan);
	round_write(&plan);
	tables_write(&plan);
	room_write(&plan);
	layers_write(&plan);
	properties_write(&plan);
	tree_write(&plan);
	if (output_commit(&output, &fault))
		return program_fail(&command, &fault);
	program_end(&command);
	return EXIT_DONE;
}
