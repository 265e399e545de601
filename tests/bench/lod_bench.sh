#!/bin/bash
# What simplifiers do to buildings of many parts: one row for each method and
# rate, as tcs-compare sees it. Of the contacts, per cent separated, lost and
# half-open; components lost and floating; the largest and the mean distance
# from the original in metres, and back; of the pixels, per cent that show both
# and that show the same surface; boxes seen that the original hides; likeness in
# per cent; seconds of CPU time. All methods get
# the same stream, one number of triangles per building, and components that
# share no vertex; placed prototypes are passed on, so that where there are many
# the rate reached is lower.
#
#     RATES="50 60 70 80 90"  PEERS="qem cgal ..."  FILES="a.gml b.tcs ..."
set -eu

rates=${RATES:-50 60 70 80 90}
peers=${PEERS:-qem clustering meshoptimizer openmesh cgal}
data=$ROOT/../shared/data
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
peer=$BUILD/tests/bench/lod_peer

if ! [[ -x $peer ]]; then
	echo "only 'make bench BENCH=lod' builds what this needs"
	exit
fi

# row NAME RATE COMMAND...: simplify $folder/in and print what came of it.
row() {
	local name=$1 rate=$2 seconds
	shift 2
	TIMEFORMAT='%U %S'
	{ time "$@" <"$folder/in" >"$folder/out" 2>"$folder/log"; } \
		2>"$folder/time" || {
		printf '%-15s %3s  failed: %s\n' "$name" "$rate" \
			"$(tail -n 1 "$folder/log")"
		return
	}
	seconds=$(awk '{ print $1 + $2 }' "$folder/time")
	printf '%-15s %3s ' "$name" "$rate"
	tcs-compare -q --json "$folder/in" "$folder/out" |
		jq -r --arg seconds "$seconds" '.all |
		def share(n): if .contacts_before > 0 then
			100 * n / .contacts_before else 0 end;
		[100 * .rate, share(.contacts_separated),
			share(.contacts_lost), share(.contacts_half_open),
			.components_lost, .components_floating,
			.distance_max, .distance_mean, .distance_back_max,
			.pixels_hit_share, .pixels_surface_share,
			.boxes_opened, .similarity,
			($seconds | tonumber)] | @tsv' |
		awk '{ printf "%6.1f %6.1f %6.1f %6.1f %6d %6d %8.3f %8.4f " \
			"%8.3f %6.2f %6.2f %5d %6.2f %7.2f\n", $1, $2, $3, $4,
			$5, $6, $7, $8, $9, $10, $11, $12, $13, $14 }'
}

# table NAME: all methods at all rates over $folder/in.
table() {
	local rate name
	tcs-compare -q --json "$folder/in" "$folder/in" | jq -r --arg name "$1" \
		'.all | "\n\($name): \(.objects) objects, \(.triangles_before)" +
		" triangles, \(.components_before) components," +
		" \(.contacts_before) contacts"'
	printf '%-15s %3s %6s %6s %6s %6s %6s %6s %8s %8s %8s %6s %6s %5s %6s %7s\n' \
		method % rate apart lost ajar gone float max mean back hit same \
		boxes like CPU
	for name in $peers; do
		for rate in $rates; do
			row "$name" "$rate" "$peer" --peer "$name" \
				--rate "0.$rate"
		done
	done
	[[ -x $BUILD/bin/tcs-simplify ]] || return 0
	for rate in $rates; do
		row tcs-simplify "$rate" tcs-simplify -q --rate "0.$rate"
	done
}

# take FILE: read it into $folder/in.
take() {
	case $1 in
	*.tcs) cp "$1" "$folder/in" ;;
	*.ifc) ifc2tcs -q "$1" "$folder/in" 2>"$folder/log" ;;
	*) citygml2tcs -q "$1" "$folder/in" 2>"$folder/log" ;;
	esac
}

if [[ ${FILES:-} ]]; then
	for file in $FILES; do
		take "$file"
		table "${file##*/}"
	done
	exit
fi

"$BUILD/samples/makeblock" --buildings 12 | citygml2tcs -q - "$folder/in"
table 'generated buildings'
for file in \
	citygml/cesiumlab+aiCityGML/FZK-Haus-LoD3-KIT-IAI-KHH-B36-V1.gml \
	citygml/cesiumlab+aiCityGML/GeoBIM_BuildingsLOD3.gml \
	citygml/citygml4j+citygml4j/datasets/lod3_building_v2.gml \
	ifc/web-ifc/duplex.ifc ifc/web-ifc/AC20-FZK-Haus.ifc \
	ifc/xbim-essentials/House.ifc; do
	[[ -e $data/$file ]] || continue
	take "$data/$file"
	table "${file##*/}"
done
