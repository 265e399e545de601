/*
 * srsName: which coordinate reference system a file names, in any spelling.
 *
 * Understood, whatever the case and with blanks around and after commas:
 *
 *     EPSG:25832   EPSG:25832+7837   urn:ogc:def:crs:EPSG::25832
 *     urn:ogc:def:crs:EPSG:6.12:25832   urn:x-ogc:def:crs:EPSG:25832
 *     urn:ogc:def:crs,crs:EPSG:6.12:25832,crs:EPSG:6.12:5783
 *     http://www.opengis.net/def/crs/EPSG/0/6697
 *     http://www.opengis.net/def/crs-compound?1=…EPSG/0/25832&2=…EPSG/0/7837
 *     http://www.opengis.net/gml/srs/epsg.xml#25832
 *     urn:adv:crs:ETRS89_UTM32*DE_DHHN2016_NH*GCG2016
 *     urn:ogc:def:crs:OGC:1.3:CRS84   OGC:CRS84h   #a-local-system
 *
 * Kind, units and axis order of an EPSG code come from PROJ's database, which
 * is the EPSG registry; it is opened for the call and closed again, and the
 * network is never used.
 *
 * source: OGC 07-092r3 (URNs), OGC 11-135 (http URIs), EPSG Guidance Note 7-1;
 * AdV, GeoInfoDok, list of coordinate reference systems.
 */
#ifndef TESSERA_SRS_H
#define TESSERA_SRS_H

#include <stdbool.h>
#include <stdint.h>

#include "tcs.h"

struct srs {
	double metres_per_unit; /* of x and y; 1 for degrees and unknown */
	double metres_per_unit_up; /* of z */
	double lower[2]; /* where the system is used: easting, northing or */
	double upper[2]; /* longitude, latitude; only if has_area */
	int32_t epsg; /* horizontal, 3D or compound code; 0 unknown */
	int32_t epsg_up; /* vertical code named beside it; 0 none */
	enum tcs_crs_kind kind;
	bool north_first; /* the registry puts northing or latitude first */
	bool order_promised; /* spelled so that the registry's order binds:
	                        a URN or an http URI, no plain EPSG:n */
	bool has_area;
	char assumed[192]; /* what had to be assumed; "" for nothing */
};

/*
 * Fill *out with what `name` says; NULL is an absent srsName. Never fails: what
 * is not understood becomes TCS_CRS_UNKNOWN, a plane in metres, and `assumed`
 * says so.
 */
void srs_read(const char *name, struct srs *out);

/*
 * Whether coordinates as written are northing or latitude first, given one of
 * them. Where the place fits the system's area of use one way round only, that
 * decides. Else latitude comes first if a promising spelling says so, while
 * plane systems are written easting first, as files do even where the registry
 * has northing first (DHDN / Gauss-Krüger, EPSG:31466 to 31469).
 *
 * *assumed becomes a static text when the answer is not simply what the
 * registry and the spelling say, NULL otherwise.
 */
bool srs_north_first(
	const struct srs *srs, struct tcs_point sample, const char **assumed);

#endif
