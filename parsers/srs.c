#include "srs.h"

#include <ctype.h>
#include <math.h>
#include <proj.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* Longer names are no names; also bounds the work on hostile ones. */
#define MAX_NAME 512

/* The names of the German surveying authorities, and their EPSG codes. */
static const struct {
	const char *name;
	int epsg;
} adv_systems[] = {
	{"ETRS89_UTM31", 25831},
	{"ETRS89_UTM32", 25832},
	{"ETRS89_UTM33", 25833},
	{"ETRS89_Lat-Lon-h", 4937},
	{"ETRS89_Lat-Lon", 4258},
	{"ETRS89_X-Y-Z", 4936},
	{"DE_DHDN_3GK2", 31466},
	{"DE_DHDN_3GK3", 31467},
	{"DE_DHDN_3GK4", 31468},
	{"DE_DHDN_3GK5", 31469},
	{"DE_DHDN_Lat-Lon", 4314},
	{"DE_42-83_3GK3", 2397},
	{"DE_42-83_3GK4", 2398},
	{"DE_42-83_3GK5", 2399},
	{"DE_PD-83_3GK3", 3396},
	{"DE_PD-83_3GK4", 3397},
	{"DE_RD-83_3GK4", 3398},
	{"DE_RD-83_3GK5", 3399},
	{"DE_Soldner-Berlin", 3068},
	{"DE_DHHN2016_NH", 7837},
	{"DE_DHHN92_NH", 5783},
	{"DE_DHHN85_NOH", 5784},
	{"DE_DHHN12_NOH", 7699},
	{"DE_SNN76_NH", 5785},
};

static void
assume(struct srs *srs, const char *text)
{
	size_t used = strlen(srs->assumed);

	snprintf(srs->assumed + used, sizeof srs->assumed - used, "%s%s",
		used ? "; " : "", text);
}

/* ---- what PROJ knows of a code ------------------------------------------ */

struct axis {
	double unit; /* metres or radians */
	bool north_south;
	bool backward; /* counts south or west */
	bool sideways; /* east or west */
};

static bool
axis_read(PJ_CONTEXT *context, const PJ *system, int index, struct axis *out)
{
	const char *direction;

	if (!proj_cs_get_axis_info(context, system, index, NULL, NULL,
		    &direction, &out->unit, NULL, NULL, NULL))
		return false;
	out->north_south = !strcasecmp(direction, "north") ||
		!strcasecmp(direction, "south");
	out->sideways = !strcasecmp(direction, "east") ||
		!strcasecmp(direction, "west");
	out->backward = !strcasecmp(direction, "south") ||
		!strcasecmp(direction, "west");
	return out->unit > 0;
}

static enum tcs_crs_kind
kind_of(PJ_TYPE type)
{
	switch (type) {
	case PJ_TYPE_PROJECTED_CRS:
		return TCS_CRS_PROJECTED;
	case PJ_TYPE_GEOGRAPHIC_2D_CRS:
	case PJ_TYPE_GEOGRAPHIC_3D_CRS:
		return TCS_CRS_GEOGRAPHIC;
	case PJ_TYPE_GEOCENTRIC_CRS:
		return TCS_CRS_GEOCENTRIC;
	case PJ_TYPE_ENGINEERING_CRS:
		return TCS_CRS_LOCAL;
	default:
		return TCS_CRS_UNKNOWN;
	}
}

static void
read_axes(PJ_CONTEXT *context, const PJ *crs, struct srs *out)
{
	PJ *system = proj_crs_get_coordinate_system(context, crs);
	struct axis first, second, up;
	bool degrees = out->kind == TCS_CRS_GEOGRAPHIC;

	if (system && axis_read(context, system, 0, &first) &&
		axis_read(context, system, 1, &second)) {
		out->north_first = first.north_south && second.sideways;
		if (!degrees) {
			out->metres_per_unit = first.unit;
			out->metres_per_unit_up = first.unit;
		} else if (fabs(first.unit - acos(-1) / 180) > 1e-12) {
			assume(out, "angles taken as degrees");
		}
		if (first.sideways != second.sideways &&
			(first.backward || second.backward))
			assume(out,
				"axes that count south or west taken as "
				"counting north and east");
		if (proj_cs_get_axis_count(context, system) > 2 &&
			axis_read(context, system, 2, &up))
			out->metres_per_unit_up = up.unit;
	}
	proj_destroy(system);
}

static void
read_up_axis(PJ_CONTEXT *context, const PJ *crs, struct srs *out)
{
	PJ *system = proj_crs_get_coordinate_system(context, crs);
	struct axis up;

	if (system && axis_read(context, system, 0, &up))
		out->metres_per_unit_up = up.unit;
	proj_destroy(system);
}

/* The bounds of a plane system's area of use, easting first. */
static bool
project_area(PJ_CONTEXT *context, const PJ *crs, const double area[4],
	double bounds[4])
{
	PJ *base = proj_crs_get_geodetic_crs(context, crs);
	PJ *plain = NULL, *there = NULL;
	bool done = false;

	if (base)
		plain = proj_create_crs_to_crs_from_pj(
			context, base, crs, NULL, NULL);
	if (plain)
		there = proj_normalize_for_visualization(context, plain);
	if (there)
		done = proj_trans_bounds(context, there, PJ_FWD, area[0],
			area[1], area[2], area[3], &bounds[0], &bounds[1],
			&bounds[2], &bounds[3], 21);
	proj_destroy(there);
	proj_destroy(plain);
	proj_destroy(base);
	return done;
}

/* Where the system is used, a fifth wider; nothing across the date line. */
static void
read_area(PJ_CONTEXT *context, const PJ *crs, struct srs *out)
{
	double area[4], bounds[4];

	if (!proj_get_area_of_use(context, crs, &area[0], &area[1], &area[2],
		    &area[3], NULL) ||
		area[0] >= area[2] || area[1] >= area[3])
		return;
	if (out->kind == TCS_CRS_GEOGRAPHIC)
		memcpy(bounds, area, sizeof bounds);
	else if (out->kind != TCS_CRS_PROJECTED ||
		!project_area(context, crs, area, bounds))
		return;
	for (int i = 0; i < 2; i++) {
		double margin = (bounds[i + 2] - bounds[i]) / 5;
		double end = out->kind == TCS_CRS_PROJECTED ? HUGE_VAL
			: i == 0			    ? 180
							    : 90;

		if (!isfinite(margin) || margin <= 0)
			return;
		out->lower[i] = fmax(bounds[i] - margin, -end);
		out->upper[i] = fmin(bounds[i + 2] + margin, end);
	}
	out->has_area = true;
}

static void
read_horizontal(PJ_CONTEXT *context, const PJ *crs, int code, struct srs *out)
{
	out->epsg = code;
	out->kind = kind_of(proj_get_type(crs));
	read_axes(context, crs, out);
	read_area(context, crs, out);
}

static void
read_compound(PJ_CONTEXT *context, const PJ *crs, int code, struct srs *out)
{
	PJ *plane = proj_crs_get_sub_crs(context, crs, 0);
	PJ *up = proj_crs_get_sub_crs(context, crs, 1);

	if (plane)
		read_horizontal(context, plane, code, out);
	if (up)
		read_up_axis(context, up, out);
	proj_destroy(up);
	proj_destroy(plane);
}

/* Take one code into *out: the first horizontal one, the first vertical one. */
static void
read_code(PJ_CONTEXT *context, int code, struct srs *out)
{
	char digits[16], text[64];
	PJ *crs;

	snprintf(digits, sizeof digits, "%d", code);
	crs = proj_create_from_database(
		context, "EPSG", digits, PJ_CATEGORY_CRS, 0, NULL);
	if (!crs) {
		snprintf(text, sizeof text, "EPSG:%d is not known", code);
		assume(out, text);
		return;
	}
	switch (proj_get_type(crs)) {
	case PJ_TYPE_VERTICAL_CRS:
		if (!out->epsg_up) {
			out->epsg_up = code;
			read_up_axis(context, crs, out);
		}
		break;
	case PJ_TYPE_COMPOUND_CRS:
		if (!out->epsg)
			read_compound(context, crs, code, out);
		break;
	default:
		if (!out->epsg)
			read_horizontal(context, crs, code, out);
	}
	proj_destroy(crs);
}

/* ---- spellings ----------------------------------------------------------- */

static const char *
find_folded(const char *text, const char *wanted)
{
	size_t length = strlen(wanted);

	for (; *text; text++)
		if (!strncasecmp(text, wanted, length))
			return text;
	return NULL;
}

/* The number that ends a part of a name; 0 where none does. */
static int
last_number(const char *part)
{
	size_t end = strlen(part), start = end;

	while (start > 0 && isdigit((unsigned char)part[start - 1]))
		start--;
	if (start == end || end - start > 8)
		return 0;
	if (start > 0 && !strchr(":/#", part[start - 1]))
		return 0;
	return atoi(part + start);
}

/* "EPSG:6.12:25832" and all its relatives; a bare number behind one too. */
static int
epsg_code(const char *part, bool *after_epsg)
{
	const char *name = find_folded(part, "epsg");

	if (!name && !*after_epsg)
		return 0;
	*after_epsg = true;
	return last_number(name ? name : part);
}

/* CRS84 is WGS 84 with longitude first; the stream is longitude first. */
static int
ogc_code(const char *part)
{
	size_t length = strlen(part);

	if (length >= 6 && !strcasecmp(part + length - 6, "CRS84h"))
		return 4979;
	if (length >= 5 && !strcasecmp(part + length - 5, "CRS84"))
		return 4326;
	return 0;
}

/* Realisations of a state have the same name and more behind "_". */
static int
adv_code(const char *part)
{
	const char *name = strrchr(part, ':');

	name = name ? name + 1 : part;
	for (size_t i = 0; i < sizeof adv_systems / sizeof *adv_systems; i++) {
		size_t length = strlen(adv_systems[i].name);

		if (!strncasecmp(name, adv_systems[i].name, length) &&
			(!name[length] || name[length] == '_'))
			return adv_systems[i].epsg;
	}
	return 0;
}

static void
read_codes(PJ_CONTEXT *context, char *name, struct srs *out)
{
	bool adv = find_folded(name, "urn:adv:") != NULL;
	bool after_epsg = false, crs84 = false;
	char *rest = NULL;

	for (char *part = strtok_r(name, ", \t\r\n+&*", &rest); part;
		part = strtok_r(NULL, ", \t\r\n+&*", &rest)) {
		int code = adv ? adv_code(part) : epsg_code(part, &after_epsg);

		if (!code && (code = ogc_code(part)))
			crs84 = true;
		if (code)
			read_code(context, code, out);
		else if (adv && !strncasecmp(part, "DE_", 3))
			assume(out, "height system not known, taken as metres");
	}
	if (crs84)
		out->north_first = false;
}

static void
read_name(const char *name, size_t length, struct srs *out)
{
	PJ_CONTEXT *context = proj_context_create();
	char copy[MAX_NAME];

	if (!context) {
		assume(out, "no memory to look the system up");
		return;
	}
	proj_log_level(context, PJ_LOG_NONE);
	proj_context_set_enable_network(context, 0);
	memcpy(copy, name, length);
	copy[length] = '\0';
	out->order_promised = !strncasecmp(copy, "urn:", 4) ||
		find_folded(copy, "/def/crs") != NULL;
	read_codes(context, copy, out);
	proj_context_destroy(context);
}

void
srs_read(const char *name, struct srs *out)
{
	size_t length;

	*out = (struct srs){.metres_per_unit = 1, .metres_per_unit_up = 1};
	if (!name)
		name = "";
	while (isspace((unsigned char)*name))
		name++;
	length = strlen(name);
	while (length > 0 && isspace((unsigned char)name[length - 1]))
		length--;
	if (*name == '#') {
		out->kind = TCS_CRS_LOCAL;
		return;
	}
	if (length > 0 && length < MAX_NAME)
		read_name(name, length, out);
	if (out->kind != TCS_CRS_UNKNOWN)
		return;
	if (length == 0)
		assume(out, "no srsName; taken as a plane in metres");
	else if (!out->assumed[0])
		assume(out,
			"srsName not understood; taken as a plane in "
			"metres");
	else
		assume(out, "taken as a plane in metres");
}

/* ---- axis order ---------------------------------------------------------- */

static bool
in_area(const struct srs *srs, double x, double y)
{
	return x >= srs->lower[0] && x <= srs->upper[0] && y >= srs->lower[1] &&
		y <= srs->upper[1];
}

/* What the spelling means, without a look at the data. */
static bool
north_first_by_name(const struct srs *srs, const char **assumed)
{
	if (!srs->north_first)
		return false;
	if (srs->kind != TCS_CRS_GEOGRAPHIC) {
		*assumed = "written easting first, though the registry has "
			   "northing first";
		return false;
	}
	if (!srs->order_promised) {
		*assumed = "written longitude first, as EPSG:n often is, "
			   "though the registry has latitude first";
		return false;
	}
	return true;
}

bool
srs_north_first(
	const struct srs *srs, struct tcs_point sample, const char **assumed)
{
	bool by_name, as_written, exchanged;

	*assumed = NULL;
	by_name = north_first_by_name(srs, assumed);
	if (!srs->has_area)
		return by_name;
	as_written = in_area(srs, sample.x, sample.y);
	exchanged = in_area(srs, sample.y, sample.x);
	if (as_written == exchanged || exchanged == by_name)
		return by_name;
	if (exchanged == srs->north_first)
		*assumed = NULL;
	else
		*assumed = exchanged ? "written northing or latitude first, "
				       "as the coordinates' place shows"
				     : "written easting or longitude first, "
				       "as the coordinates' place shows";
	return exchanged;
}
