# shellcheck shell=bash disable=SC2034 # the cases use what is set here
# Sourced by the cases of citygml2tcs: the parts of small documents.

# model [BODY]: a CityGML 2.0 document around BODY or standard input.
model() {
	printf '%s\n' '<CityModel xmlns="http://www.opengis.net/citygml/2.0"' \
		' xmlns:bldg="http://www.opengis.net/citygml/building/2.0"' \
		' xmlns:gen="http://www.opengis.net/citygml/generics/2.0"' \
		' xmlns:app="http://www.opengis.net/citygml/appearance/2.0"' \
		' xmlns:gml="http://www.opengis.net/gml"' \
		' xmlns:xlink="http://www.w3.org/1999/xlink">'
	if (($#)); then printf '%s\n' "$1"; else cat; fi
	printf '</CityModel>\n'
}

# building ID BODY: a building as a member.
building() {
	printf '<cityObjectMember><bldg:Building gml:id="%s">%s' "$1" "$2"
	printf '</bldg:Building></cityObjectMember>\n'
}

# polygon ID POSLIST...: outer ring, then holes.
polygon() {
	local id=$1 side=exterior ring
	shift
	printf '<gml:Polygon gml:id="%s">' "$id"
	for ring; do
		printf '<gml:%s><gml:LinearRing><gml:posList>%s</gml:posList>' \
			$side "$ring"
		printf '</gml:LinearRing></gml:%s>' $side
		side=interior
	done
	printf '</gml:Polygon>'
}

# surfaces POLYGON...: a gml:MultiSurface of them.
surfaces() {
	printf '<gml:MultiSurface>'
	printf '<gml:surfaceMember>%s</gml:surfaceMember>' "$@"
	printf '</gml:MultiSurface>'
}

# polygons: the polygons of the stream on standard input, one a line: id,
# owner of the geometry, surface, level of detail, triangles, flags.
polygons() {
	tcs2json | jq -r 'select(.record == "object") | . as $o |
		.geometries[] | . as $g | .polygons[] |
		[.id, $o.features[$g.feature].id, $o.features[.surface].id,
		 $g.lod, $g.kind, (.triangles | length),
		 (.flags // [] | tostring)] | @tsv'
}

square='0 0 0 4 0 0 4 4 0 0 4 0 0 0 0'
