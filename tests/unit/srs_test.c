#include "../../parsers/srs.h"

#include <math.h>
#include <string.h>

#include "check.h"

static const struct tcs_point nowhere = {0, 0, 0};

static bool
north_first(const char *name, double x, double y, const char **assumed)
{
	struct srs srs;

	srs_read(name, &srs);
	return srs_north_first(&srs, (struct tcs_point){x, y, 0}, assumed);
}

/* One spelling and what it must say. */
struct spelling {
	const char *name;
	int epsg, epsg_up;
	enum tcs_crs_kind kind;
	bool north_first, promised, assumed;
};

static const struct spelling spellings[] = {
	{"EPSG:25832", 25832, 0, TCS_CRS_PROJECTED, false, false, false},
	{"epsg:25832", 25832, 0, TCS_CRS_PROJECTED, false, false, false},
	{" \tEPSG:25832\n", 25832, 0, TCS_CRS_PROJECTED, false, false, false},
	{"EPSG:25832+7837", 25832, 7837, TCS_CRS_PROJECTED, false, false,
		false},
	{"EPSG:25832+EPSG:7837", 25832, 7837, TCS_CRS_PROJECTED, false, false,
		false},
	{"EPSG::25833", 25833, 0, TCS_CRS_PROJECTED, false, false, false},
	{"urn:ogc:def:crs:EPSG::25832", 25832, 0, TCS_CRS_PROJECTED, false,
		true, false},
	{"URN:OGC:DEF:CRS:EPSG::25832", 25832, 0, TCS_CRS_PROJECTED, false,
		true, false},
	{"urn:ogc:def:crs:EPSG:6.12:25832", 25832, 0, TCS_CRS_PROJECTED, false,
		true, false},
	{"urn:x-ogc:def:crs:EPSG:25832", 25832, 0, TCS_CRS_PROJECTED, false,
		true, false},
	{"urn:ogc:def:crs,crs:EPSG::25832,crs:EPSG::5783", 25832, 5783,
		TCS_CRS_PROJECTED, false, true, false},
	{"urn:ogc:def:crs,crs:EPSG:6.12:31466,crs:EPSG:6.12:5783", 31466, 5783,
		TCS_CRS_PROJECTED, true, true, false},
	{"urn:ogc:def:crs,crs:EPSG::5783,crs:EPSG::25832", 25832, 5783,
		TCS_CRS_PROJECTED, false, true, false},
	{"urn:ogc:def:crs,crs:EPSG:6.12:3068,crs:EPSG:6.12:5783,crs:EPSG::5783",
		3068, 5783, TCS_CRS_PROJECTED, true, true, false},
	{"urn:ogc:def:crs:EPSG:25832, crs:EPSG:5783", 25832, 5783,
		TCS_CRS_PROJECTED, false, true, false},
	{"urn:ogc:def:crs,crs:EPSG:27700,crs:EPSG:5701", 27700, 5701,
		TCS_CRS_PROJECTED, false, true, false},
	{"urn:ogc:def:crs,crs:EPSG:27700,crs:EPSG:5101", 27700, 0,
		TCS_CRS_PROJECTED, false, true, true},
	{"urn:ogc:def:crs,crs:EPSG::2180,crs:PL-KRON86-NH", 2180, 0,
		TCS_CRS_PROJECTED, true, true, false},
	{"urn:ogc:def:crs:EPSG::7415", 7415, 0, TCS_CRS_PROJECTED, false, true,
		false},
	{"urn:ogc:def:crs:EPSG::4326", 4326, 0, TCS_CRS_GEOGRAPHIC, true, true,
		false},
	{"http://www.opengis.net/def/crs/EPSG/0/6697", 6697, 0,
		TCS_CRS_GEOGRAPHIC, true, true, false},
	{"https://www.opengis.net/def/crs/EPSG/0/6668", 6668, 0,
		TCS_CRS_GEOGRAPHIC, true, true, false},
	{"http://www.opengis.net/def/crs-compound?"
	 "1=http://www.opengis.net/def/crs/EPSG/0/25832&"
	 "2=http://www.opengis.net/def/crs/EPSG/0/7837",
		25832, 7837, TCS_CRS_PROJECTED, false, true, false},
	{"http://www.opengis.net/gml/srs/epsg.xml#25832", 25832, 0,
		TCS_CRS_PROJECTED, false, false, false},
	{"http://www.opengis.net/gml/srs/epsg.xml#4326", 4326, 0,
		TCS_CRS_GEOGRAPHIC, true, false, false},
	{"EPSG:4979", 4979, 0, TCS_CRS_GEOGRAPHIC, true, false, false},
	{"EPSG:4978", 4978, 0, TCS_CRS_GEOCENTRIC, false, false, false},
	{"EPSG:4807", 4807, 0, TCS_CRS_GEOGRAPHIC, true, false, true},
	{"EPSG:2046", 2046, 0, TCS_CRS_PROJECTED, false, false, true},
	{"EPSG:32661", 32661, 0, TCS_CRS_PROJECTED, false, false, false},
	{"EPSG:3035", 3035, 0, TCS_CRS_PROJECTED, true, false, false},
	{"EPSG:2056", 2056, 0, TCS_CRS_PROJECTED, false, false, false},
	{"OGC:CRS84", 4326, 0, TCS_CRS_GEOGRAPHIC, false, false, false},
	{"urn:ogc:def:crs:OGC:1.3:CRS84", 4326, 0, TCS_CRS_GEOGRAPHIC, false,
		true, false},
	{"http://www.opengis.net/def/crs/OGC/0/CRS84h", 4979, 0,
		TCS_CRS_GEOGRAPHIC, false, true, false},
	{"urn:adv:crs:ETRS89_UTM32*DE_DHHN92_NH", 25832, 5783,
		TCS_CRS_PROJECTED, false, true, false},
	{"URN:ADV:CRS:etrs89_utm33*de_dhhn2016_nh", 25833, 7837,
		TCS_CRS_PROJECTED, false, true, false},
	{"urn:adv:crs:ETRS89_UTM32*DE_DHHN2016_NH*GCG2016", 25832, 7837,
		TCS_CRS_PROJECTED, false, true, false},
	{"urn:adv:crs:DE_DHDN_3GK4*DE_DHHN92_NH", 31468, 5783,
		TCS_CRS_PROJECTED, true, true, false},
	{"urn:adv:crs:DE_DHDN_3GK3_NI200", 31467, 0, TCS_CRS_PROJECTED, true,
		true, false},
	{"urn:adv:crs:DE_DHDN_3GK4*DE_DHN92_NH", 31468, 0, TCS_CRS_PROJECTED,
		true, true, true},
	{"urn:adv:crs:ETRS89_UTM321*DE_DHHN92_NH", 0, 5783, TCS_CRS_UNKNOWN,
		false, true, true},
	{"#localCRS1", 0, 0, TCS_CRS_LOCAL, false, false, false},
	{"#local-CRS-1", 0, 0, TCS_CRS_LOCAL, false, false, false},
	{"CH1903+", 0, 0, TCS_CRS_UNKNOWN, false, false, true},
	{"srsName", 0, 0, TCS_CRS_UNKNOWN, false, false, true},
	{"EPSG:23632", 0, 0, TCS_CRS_UNKNOWN, false, false, true},
	{"EPSG:999999999999", 0, 0, TCS_CRS_UNKNOWN, false, false, true},
	{"EPSG:-1", 0, 0, TCS_CRS_UNKNOWN, false, false, true},
	{"EPSG:", 0, 0, TCS_CRS_UNKNOWN, false, false, true},
	{"EPSG:5783", 0, 5783, TCS_CRS_UNKNOWN, false, false, true},
	{"urn:ogc:def:crs:EPSG::", 0, 0, TCS_CRS_UNKNOWN, false, true, true},
	{"25832", 0, 0, TCS_CRS_UNKNOWN, false, false, true},
	{",,,+&* ", 0, 0, TCS_CRS_UNKNOWN, false, false, true},
	{"", 0, 0, TCS_CRS_UNKNOWN, false, false, true},
	{"  ", 0, 0, TCS_CRS_UNKNOWN, false, false, true},
	{NULL, 0, 0, TCS_CRS_UNKNOWN, false, false, true},
};

static void
every_spelling_is_understood(void)
{
	struct srs srs;

	for (size_t i = 0; i < sizeof spellings / sizeof *spellings; i++) {
		const struct spelling *want = &spellings[i];
		bool same;

		srs_read(want->name, &srs);
		same = srs.epsg == want->epsg && srs.epsg_up == want->epsg_up &&
			srs.kind == want->kind &&
			srs.north_first == want->north_first &&
			srs.order_promised == want->promised &&
			(srs.assumed[0] != '\0') == want->assumed;
		CHECK(same);
		if (!same)
			fprintf(stderr,
				"  %s: epsg %d, up %d, kind %d, north %d, "
				"promised %d, \"%s\"\n",
				want->name ? want->name : "(absent)",
				(int)srs.epsg, (int)srs.epsg_up, (int)srs.kind,
				srs.north_first, srs.order_promised,
				srs.assumed);
	}
}

static void
units_come_with_the_code(void)
{
	const double survey_foot = 1200.0 / 3937;
	struct srs srs;

	srs_read("EPSG:25832", &srs);
	CHECK(srs.metres_per_unit == 1 && srs.metres_per_unit_up == 1);
	srs_read("EPSG:2225", &srs);
	CHECK(fabs(srs.metres_per_unit - survey_foot) < 1e-12);
	CHECK(fabs(srs.metres_per_unit_up - survey_foot) < 1e-12);
	srs_read("urn:ogc:def:crs,crs:EPSG::2225,crs:EPSG::5703", &srs);
	CHECK(fabs(srs.metres_per_unit - survey_foot) < 1e-12);
	CHECK(srs.metres_per_unit_up == 1);
	srs_read("EPSG:6697", &srs);
	CHECK(srs.metres_per_unit == 1 && srs.metres_per_unit_up == 1);
}

static void
latitude_comes_first_where_it_is_promised(void)
{
	const char *assumed;

	CHECK(north_first("http://www.opengis.net/def/crs/EPSG/0/6697", 35.69,
		139.69, &assumed));
	CHECK(!assumed);
	CHECK(north_first("urn:ogc:def:crs:EPSG::4326", 49, 8.4, &assumed));
	CHECK(!assumed);
	CHECK(!north_first("urn:ogc:def:crs:OGC:1.3:CRS84", 8.4, 49, &assumed));
	CHECK(!assumed);
}

static void
a_plain_code_is_longitude_first(void)
{
	const char *assumed;

	CHECK(!north_first("EPSG:4979", -77.005, 38.888, &assumed));
	CHECK(assumed);
	CHECK(north_first("EPSG:4326", 35.69, 139.69, &assumed));
	CHECK(!assumed);
}

static void
the_place_overrules_the_spelling(void)
{
	const char *assumed;

	CHECK(!north_first("http://www.opengis.net/def/crs/EPSG/0/6697", 139.69,
		35.69, &assumed));
	CHECK(assumed && strstr(assumed, "longitude first"));
	CHECK(north_first("EPSG:25832", 5438340, 458868, &assumed));
	CHECK(assumed && strstr(assumed, "northing"));
	CHECK(north_first("EPSG:31467", 5439690, 3459000, &assumed));
	CHECK(!assumed);
}

static void
plane_systems_are_easting_first(void)
{
	const char *assumed;

	CHECK(!north_first("EPSG:25832", 458868, 5438340, &assumed));
	CHECK(!assumed);
	CHECK(!north_first("urn:adv:crs:DE_DHDN_3GK4*DE_DHHN92_NH", 4490660,
		5322010, &assumed));
	CHECK(assumed && strstr(assumed, "easting first"));
	CHECK(!north_first("EPSG:2180", 500000, 400000, &assumed));
	CHECK(assumed);
	CHECK(!north_first("EPSG:31466", 1, 3, &assumed));
	CHECK(assumed);
	CHECK(!north_first(NULL, 0, 0, &assumed));
	CHECK(!assumed);
}

static void
an_endless_name_is_not_understood(void)
{
	static char name[100000];
	struct srs srs;
	const char *assumed;

	memset(name, 'E', sizeof name - 1);
	memcpy(name, "EPSG:", 5);
	srs_read(name, &srs);
	CHECK(srs.kind == TCS_CRS_UNKNOWN && srs.epsg == 0);
	CHECK(srs.assumed[0]);
	CHECK(!srs_north_first(&srs, nowhere, &assumed));
}

static void
many_unknown_codes_fit_their_text(void)
{
	struct srs srs;

	srs_read("EPSG:90001,EPSG:90002,EPSG:90003,EPSG:90004,EPSG:90005,"
		 "EPSG:90006,EPSG:90007,EPSG:90008,EPSG:90009,EPSG:90010,"
		 "EPSG:90011,EPSG:90012",
		&srs);
	CHECK(srs.kind == TCS_CRS_UNKNOWN);
	CHECK(strlen(srs.assumed) < sizeof srs.assumed);
}

static const struct check_test tests[] = {
	CHECK_TEST(every_spelling_is_understood),
	CHECK_TEST(units_come_with_the_code),
	CHECK_TEST(latitude_comes_first_where_it_is_promised),
	CHECK_TEST(a_plain_code_is_longitude_first),
	CHECK_TEST(the_place_overrules_the_spelling),
	CHECK_TEST(plane_systems_are_easting_first),
	CHECK_TEST(an_endless_name_is_not_understood),
	CHECK_TEST(many_unknown_codes_fit_their_text),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
