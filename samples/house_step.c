#include "house_step.h"

#include <stdarg.h>

unsigned
house_write(struct house *house, const char *format, ...)
{
	va_list arguments;

	fprintf(house->file, "#%u=", ++house->last);
	va_start(arguments, format);
	vfprintf(house->file, format, arguments);
	va_end(arguments);
	fputs(";\n", house->file);
	return house->last;
}

const char *
house_id(struct house *house, char out[23])
{
	snprintf(out, 23, "0House$%d$%013u", house->schema == HOUSE_4 ? 4 : 2,
		++house->ids);
	return out;
}

unsigned
house_point(struct house *house, double x, double y, double z)
{
	return house_write(
		house, "IFCCARTESIANPOINT((%.3f,%.3f,%.3f))", x, y, z);
}

unsigned
house_direction(struct house *house, double x, double y, double z)
{
	return house_write(house, "IFCDIRECTION((%.9f,%.9f,%.9f))", x, y, z);
}

unsigned
house_axes(struct house *house, double x, double y, double z)
{
	unsigned point = house_point(house, x, y, z);

	return house_write(house, "IFCAXIS2PLACEMENT3D(#%u,$,$)", point);
}

unsigned
house_turned(struct house *house, unsigned point, unsigned z, unsigned x)
{
	return house_write(
		house, "IFCAXIS2PLACEMENT3D(#%u,#%u,#%u)", point, z, x);
}

unsigned
house_place(struct house *house, unsigned within, unsigned axes)
{
	if (!within)
		return house_write(house, "IFCLOCALPLACEMENT($,#%u)", axes);
	return house_write(house, "IFCLOCALPLACEMENT(#%u,#%u)", within, axes);
}

unsigned
house_box(struct house *house, unsigned axes, double x, double y, double height)
{
	unsigned profile = house_write(
		house, "IFCRECTANGLEPROFILEDEF(.AREA.,$,$,%.3f,%.3f)", x, y);

	return house_write(house, "IFCEXTRUDEDAREASOLID(#%u,#%u,#%u,%.3f)",
		profile, axes, house->up, height);
}

unsigned
house_prism(struct house *house, unsigned axes, const double *corners,
	size_t count, double height)
{
	unsigned first = house->last + 1, outline, profile;

	for (size_t i = 0; i < count; i++)
		house_write(house, "IFCCARTESIANPOINT((%.3f,%.3f))",
			corners[2 * i], corners[2 * i + 1]);
	fprintf(house->file, "#%u=IFCPOLYLINE((", ++house->last);
	outline = house->last;
	for (size_t i = 0; i < count; i++)
		fprintf(house->file, "#%u,", first + (unsigned)i);
	fprintf(house->file, "#%u));\n", first);
	profile = house_write(
		house, "IFCARBITRARYCLOSEDPROFILEDEF(.AREA.,$,#%u)", outline);
	return house_write(house, "IFCEXTRUDEDAREASOLID(#%u,#%u,#%u,%.3f)",
		profile, axes, house->up, height);
}

unsigned
house_shape(struct house *house, const char *type, unsigned item)
{
	unsigned shape = house_write(house,
		"IFCSHAPEREPRESENTATION(#%u,'Body','%s',(#%u))", house->body,
		type, item);

	return house_write(
		house, "IFCPRODUCTDEFINITIONSHAPE($,$,(#%u))", shape);
}

void
house_paint(struct house *house, unsigned item, unsigned style)
{
	if (house->schema == HOUSE_2X3)
		style = house_write(
			house, "IFCPRESENTATIONSTYLEASSIGNMENT((#%u))", style);
	house_write(house, "IFCSTYLEDITEM(#%u,(#%u),$)", item, style);
}

unsigned
house_style(struct house *house, const char *name, double red, double green,
	double blue, double clear)
{
	unsigned colour = house_write(
		house, "IFCCOLOURRGB($,%.3f,%.3f,%.3f)", red, green, blue);
	unsigned shading = house_write(house,
		"IFCSURFACESTYLERENDERING(#%u,%.3f,$,$,$,$,$,$,.FLAT.)", colour,
		clear);

	return house_write(
		house, "IFCSURFACESTYLE('%s',.BOTH.,(#%u))", name, shading);
}

void
house_relate(struct house *house, const char *entity, bool list_first,
	unsigned one, const unsigned *others, size_t count)
{
	char id[23];

	fprintf(house->file, "#%u=%s('%s',#%u,$,$,", ++house->last, entity,
		house_id(house, id), house->history);
	if (!list_first)
		fprintf(house->file, "#%u,", one);
	if (!count)
		fprintf(house->file, "#%u", *others);
	for (size_t i = 0; i < count; i++)
		fprintf(house->file, "%s#%u%s", i ? "," : "(", others[i],
			i + 1 == count ? ")" : "");
	if (list_first)
		fprintf(house->file, ",#%u", one);
	fputs(");\n", house->file);
}
