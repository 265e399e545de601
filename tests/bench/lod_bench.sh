#!/bin/bash
# What simplifiers do to buildings of many parts, as tcs-compare sees it: a line
# for each file, method and rate, and then one table for each set of files.
#
# The sets: generated buildings, and of the real ones in ../shared/data all IFC
# files and all CityGML files at LOD 3 whose buildings, taken together, have at
# least 25 components and 1000 triangles. Placed prototypes are made geometry
# first, and what is no building (sites, spaces, signals) is left out. All
# methods get the same stream, one number of triangles per building, and
# components that share no vertex.
#
# Columns, per cent unless said: the rate reached; of the contacts, those apart,
# lost, squashed (a side crushed) and ajar (half-open), and of those of which both
# sides can be seen from outside, those apart or lost; of the components, those gone; components that
# float; the Hausdorff distance and the mean distance by the diagonal; of the
# pixels, those that show only one of both models; seconds of CPU time. The
# tables add up contacts and components, take the mean over the buildings of
# distances and over the files of pixels, and leave out the files of which a
# method missed the rate by more than one per cent: `files` says how many are
# left. A contact is what is within 1 cm or 0.1 % of the diagonal in the one
# table, and within 1 cm alone in the other.
#
#     RATES="50 60 70 80 90"  PEERS="qem cgal ..."  FILES="a.gml b.tcs ..."
set -eu

rates=${RATES:-50 60 70 80 90}
peers=${PEERS:-qem clustering meshoptimizer openmesh cgal tcs-simplify}
least_components=25
least_triangles=1000
data=$ROOT/../shared/data
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
peer=$BUILD/tests/bench/lod_peer

if ! [[ -x $peer ]]; then
	echo "only 'make bench BENCH=lod' builds what this needs"
	exit
fi

# ---- files ------------------------------------------------------------------

# take FILE: its buildings into $folder/in.
take() {
	case $1 in
	*.tcs) cp "$1" "$folder/read" ;;
	*.ifc*) ifc2tcs -q "$1" "$folder/read" ;;
	*) citygml2tcs -q --lod "${2:-0,1,2,3,4}" "$1" "$folder/read" ;;
	esac 2>"$folder/log" || return 1
	tcs-simplify -q --rate 0 --expand "$folder/read" "$folder/flat" \
		2>"$folder/log" || return 1
	tcs2json "$folder/flat" | jq -c 'if .record == "end" then {record}
		else select(.record != "object" or
			.features[0].class == "Building") end' |
		json2tcs -q - "$folder/in" 2>"$folder/log"
}

# is_large: whether $folder/in is worth measuring.
is_large() {
	tcs-compare -q --json --pixels 0 "$folder/in" "$folder/in" |
		jq -e --argjson components $least_components \
			--argjson triangles $least_triangles '.all |
			.components_before >= $components and
			.triangles_before >= $triangles' >"$folder/log"
}

# ---- one file ---------------------------------------------------------------

# What tcs-compare says, as numbers: rate, contacts, apart, lost, ajar, seen,
# broken, components, gone, floating, objects, sums of Hausdorff and mean
# distances by the diagonal, pixels of one model only, contacts squashed.
# shellcheck disable=SC2016 # a variable of jq
numbers='[.objects[] | select(.contacts_before > 0)] as $own | .all |
	[100 * .rate, .contacts_before, .contacts_separated, .contacts_lost,
	.contacts_half_open, .contacts_seen, .contacts_seen_broken,
	.components_before, .components_lost, .components_floating,
	($own | length),
	([$own[] | 100 * ([.distance_max // .diagonal,
		.distance_back_max // .diagonal] | max) / .diagonal] | add // 0),
	([$own[] | 100 * (.distance_mean // .diagonal) / .diagonal] |
		add // 0),
	100 - .pixels_hit_share, .contacts_crushed] | @tsv'

# Lines of files or sums of them: method, rate, files, and the numbers above.
# shellcheck disable=SC2016 # fields of awk
show='function mean(sum, of) { return of > 0 ? sum / of : 0 }
	function share(part, of) { return mean(100 * part, of) }
	{ printf "%-14s %3s %5s %5.1f %6.2f %6.2f %6.2f %6.2f %6.2f %5.1f %5d " \
		"%6.2f %7.4f %6.3f %8.2f\n", $1, $2, $3, $4, share($6, $5),
		share($7, $5), share($18, $5), share($8, $5), share($10, $9),
		share($12, $11), $13, mean($15, $14), mean($16, $14), $17,
		$19 }'

heading() {
	printf '%-14s %3s %5s %5s %6s %6s %6s %6s %6s %5s %5s %6s %7s %6s %8s\n' \
		method % files rate apart lost squash ajar seen gone float \
		far mean hit CPU
}

# measure METHOD RATE: add a line to $folder/wide and to $folder/narrow.
measure() {
	local command=("$peer" --peer "$1")
	local TIMEFORMAT='%U %S' seconds
	[[ $1 != tcs-simplify ]] || command=(tcs-simplify -q -j1)
	{ time "${command[@]}" --rate "0.$2" <"$folder/in" >"$folder/out" \
		2>"$folder/log"; } 2>"$folder/time" || {
		printf '%-14s %3s failed: %s\n' "$1" "$2" \
			"$(tail -n 1 "$folder/log")"
		return
	}
	seconds=$(awk '{ print $1 + $2 }' "$folder/time")
	tcs-compare -q --json "$folder/in" "$folder/out" | jq -r "$numbers" |
		sed "s/^/$1\t$2\t1\t/; s/\$/\t$seconds/" |
		tee -a "$folder/wide" | awk "$show"
	tcs-compare -q --json --eps 0.01 "$folder/in" "$folder/out" |
		jq -r "$numbers" | sed "s/^/$1\t$2\t1\t/; s/\$/\t$seconds/" \
		>>"$folder/narrow"
}

# measure_all NAME: all methods at all rates over $folder/in.
measure_all() {
	local method rate
	tcs-compare -q --json --pixels 0 "$folder/in" "$folder/in" |
		jq -r --arg name "$1" '.all | "\n\($name): " +
		"\(.objects) buildings, \(.triangles_before) triangles, " +
		"\(.components_before) components, " +
		"\(.contacts_before) contacts"'
	heading
	for method in $peers; do
		for rate in $rates; do
			measure "$method" "$rate"
		done
	done
}

# ---- a set of files ---------------------------------------------------------

# add_up TITLE LINES: the table over the files that reached the rate.
add_up() {
	awk -F '\t' '
	!(($1, $2) in files) { order[++count] = $1 "\t" $2 }
	{
		files[$1, $2] += 0
		if ($4 < $2 - 1)
			next
		files[$1, $2]++
		rate[$1, $2] += $4
		for (i = 5; i <= 19; i++)
			sum[$1, $2, i] += $i
	}
	END {
		for (i = 1; i <= count; i++) {
			split(order[i], key, "\t")
			n = files[key[1], key[2]]
			printf "%s\t%d\t%.3f", order[i], n,
				rate[key[1], key[2]] / (n ? n : 1)
			sum[key[1], key[2], 17] /= n ? n : 1
			for (k = 5; k <= 19; k++)
				printf "\t%.9g", sum[key[1], key[2], k]
			print ""
		}
	}' "$2" >"$folder/sums"
	printf '\n%s\n' "$1"
	heading
	awk -F '\t' "$show" "$folder/sums"
}

# measure_set NAME LODS FILE...: the large ones of the files.
measure_set() {
	local name=$1 lods=$2 file count=0
	shift 2
	: >"$folder/wide"
	: >"$folder/narrow"
	for file; do
		{ take "$file" "$lods" && is_large; } || continue
		measure_all "${file##*/}"
		count=$((count + 1))
	done
	((count)) || return 0
	add_up "$name, $count files, contacts within 1 cm or 0.1 %:" \
		"$folder/wide"
	add_up "$name, $count files, contacts within 1 cm:" "$folder/narrow"
}

# files_of FOLDER PATTERN...: what is in it, one a line.
files_of() {
	local where=$1 pattern
	shift
	[[ -d $where ]] || return 0
	for pattern; do
		find "$where" -name "$pattern"
	done | sort
}

if [[ ${FILES:-} ]]; then
	least_components=0
	least_triangles=0
	# shellcheck disable=SC2086 # names are separated by blanks
	measure_set 'Files given' '' $FILES
	exit
fi

"$BUILD/samples/makeblock" --buildings 12 >"$folder/generated.gml"
measure_set 'Generated buildings' '' "$folder/generated.gml"
mapfile -t ifc < <(files_of "$data/ifc" '*.ifc' '*.ifczip')
measure_set 'IFC buildings' '' "${ifc[@]}"
mapfile -t citygml < <(files_of "$data/citygml" '*.gml' '*.xml')
measure_set 'CityGML buildings at LOD 3' 3 "${citygml[@]}"
