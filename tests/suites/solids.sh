#!/bin/bash
# Solids that are closed, flat and the right way out are so in what is written.

# shellcheck source=tests/check.sh
. "$(dirname "$0")/../check.sh"

PATH=$BUILD/bin:$BUILD/tests/tools:$PATH
data=$ROOT/../shared/data/citygml
all=0,1,2,3,4

# written VERSION IN.tcs OUT.tcs: through a file and back.
written() {
	tcs2citygml -q --citygml "$1" "$2" written.gml
	citygml2tcs -q --lod "$all" written.gml "$3"
}

# in_triangles IN.tcs OUT.tcs: every polygon as triangles without rings.
in_triangles() {
	tcs2json "$1" | python3 "$ROOT/tests/split_polygons.py" | json2tcs >"$2"
}

solids_of_the_samples_are_good() {
	citygml2tcs -q --lod "$all" "$SAMPLES/town-$1.gml" town.tcs
	written "$2" town.tcs there.tcs
	solids there.tcs
	in_triangles town.tcs triangles.tcs
	written "$2" triangles.tcs there.tcs
	solids there.tcs
}

# change JQ: what `solids` says of a town in which one solid is so changed.
change() {
	citygml2tcs -q --lod 2 "$SAMPLES/town-2.0.gml" good.tcs
	tcs2json good.tcs | jq -c "
		if .record == \"object\" and .features[0].id == \"B1\" then
			.geometries[0] |= ($1)
		else . end" | jq -c 'if .record == "end" then {record, objects}
			else . end' | json2tcs >bad.tcs
	written 2.0 bad.tcs there.tcs
	status_is 1 solids there.tcs >said
	status_is 1 solids good.tcs there.tcs
	cat said
	grep -q "^B1, .*: $2\$" said
}

# A polygon turned round, one less, a vertex moved, a corner of all lifted,
# everything turned round.
# shellcheck disable=SC2016
broken_solids_are_noticed() {
	change '.polygons[3] |= (.vertices |= reverse |
		.triangles |= map(reverse))' 'not closed'
	change 'del(.polygons[3]) | .shells[0].polygon_count -= 1' 'not closed'
	change '.polygons[3].vertices[1][0] += 0.001' 'not closed'
	change '(.polygons[0].vertices[0]) as $p | .polygons |= map(.vertices |=
		map(if . == $p then .[2] += 0.01 else . end))' 'not flat'
	change '.polygons |= map(.vertices |= reverse |
		.triangles |= map(reverse))' 'inside out'
}

# corpus_file PATH VERSION FOLDER: nothing but what is wrong.
# shellcheck disable=SC2016
corpus_file() {
	mkdir "$3" && cd "$3" || exit 1
	bash -euc '
		citygml2tcs -q --lod "$all" "$data/$1" a.tcs
		written "$2" a.tcs b.tcs
		solids a.tcs b.tcs
		in_triangles a.tcs triangles.tcs
		written "$2" triangles.tcs c.tcs
		solids triangles.tcs c.tcs' - "$1" "$2" >log 2>&1 || {
		echo "$1:"
		head -n 6 log
	}
	tail -qn 1 log | awk '{ print "#", $1 }'
	cd .. && rm -rf "$3"
}

# shellcheck disable=SC2016
solids_of_the_corpus_stay_as_good() {
	export -f corpus_file written in_triangles
	export data all ROOT
	awk -F'\t' '$23 ~ /^valid\([123]\.0\)/ {
		printf "%s%c%s%cf%d%c", $1, 0, substr($23, 7, 3), 0, NR, 0
	}' "$data/MANIFEST.tsv" |
		xargs -0 -n 3 -P "$(nproc)" bash -c 'corpus_file "$@"' - >table
	awk '/^#/ { files++; shells += $2 }
		END { print shells " shells in " files " files" }' table |
		tee "$tests_folder/counts"
	! grep -v '^#' table
}

for version in 1.0 2.0 3.0; do
	run_test solids_of_the_samples_are_good $version $version
done
run_test solids_of_the_samples_are_good 2.0 3.0
run_test solids_of_the_samples_are_good 3.0 2.0
run_test broken_solids_are_noticed
if [[ -e $data/MANIFEST.tsv && ${BUILD##*/} == release ]]; then
	run_test solids_of_the_corpus_stay_as_good
	cat "$tests_folder/counts"
else
	skip solids_of_the_corpus_stay_as_good \
		"no ../shared/data, or not the release build"
fi
finish
