#!/bin/bash
# CityGML through the stream and back: an equal stream, valid documents, ids
# that are unique and links that lead somewhere.

# shellcheck source=tests/check.sh
. "$(dirname "$0")/../check.sh"

PATH=$BUILD/bin:$PATH
data=$ROOT/../shared/data
schemas=$data/schemas
all=0,1,2,3,4

# validates VERSION FILE...
validates() {
	[[ -e $schemas ]] || return 0
	XML_CATALOG_FILES=$schemas/catalog.xml xmllint --huge --nonet --noout \
		--schema "$schemas/citygml-$1.xsd" "${@:2}"
}

same_stream() {
	tcs2json "$1" before.json
	tcs2json "$2" after.json
	python3 "$ROOT/tests/same_stream.py" before.json after.json
}

# comes_back VERSION FILE: the same version out of the stream again.
comes_back() {
	citygml2tcs -q --lod "$all" "$2" a.tcs
	tcs2citygml -q --citygml "$1" a.tcs out.gml
	citygml2tcs -q --lod "$all" out.gml b.tcs
	same_stream a.tcs b.tcs
}

town_comes_back() {
	comes_back "$1" "$SAMPLES/town-$1.gml"
	validates "$1" out.gml
	python3 "$ROOT/tests/check_ids.py" "$SAMPLES/town-$1.gml" out.gml
}

# goes_there FROM TO FILE: out of the stream a.tcs in another version, and back.
goes_there() {
	tcs2citygml -q --citygml "$2" a.tcs there.gml
	citygml2tcs -q --lod "$all" there.gml b.tcs
	tcs2citygml -q --citygml "$1" b.tcs back.gml
	validates "$2" there.gml
	validates "$1" out.gml back.gml
	python3 "$ROOT/tests/check_ids.py" "$3" out.gml there.gml back.gml
}

town_goes_there() {
	local town=$SAMPLES/town-$1.gml
	comes_back "$1" "$town"
	goes_there "$1" "$2" "$town"
}

solids_stay_closed() {
	citygml2tcs -q "$SAMPLES/town-$1.gml" |
		tcs2citygml -q --citygml "$2" -o town.gml
	awk -f "$ROOT/tests/closed.awk" town.gml
}

jobs_make_no_difference() {
	citygml2tcs -q --lod "$all" "$SAMPLES/town-2.0.gml" town.tcs
	tcs2citygml -q -j1 town.tcs one.gml
	tcs2citygml -q -j4 town.tcs four.gml
	tcs2citygml -q <town.tcs >pipe.gml
	tcs2citygml -q -j3 -o packed.gml.gz town.tcs
	cmp one.gml four.gml
	cmp one.gml pipe.gml
	gzip -dc packed.gml.gz | cmp - one.gml
}

# A polygon moved, a name changed, a surface less: the comparison notices.
differences_are_noticed() {
	citygml2tcs -q "$SAMPLES/town-2.0.gml" a.tcs
	tcs2json a.tcs before.json
	local change
	for change in 's/458008/458009/' 's/Uferstraße/Uferweg/' \
		's/"class":"RoofSurface"/"class":"WallSurface"/'; do
		sed "0,/$(cut -d/ -f2 <<<"$change")/$change" before.json \
			>after.json
		status_is 1 python3 "$ROOT/tests/same_stream.py" \
			before.json after.json
	done
	sed 's/gml:id="B1"/gml:id="B2"/' "$SAMPLES/town-2.0.gml" >twice.gml
	status_is 1 python3 "$ROOT/tests/check_ids.py" - twice.gml
	status_is 1 python3 "$ROOT/tests/check_ids.py" "$SAMPLES/town-2.0.gml" \
		"$SAMPLES/town-2.0.gml" twice.gml
}

# Two streams in one: every id is there twice.
ids_stay_unique() {
	citygml2tcs -q "$SAMPLES/town-2.0.gml" | tcs2json >town.json
	grep '"record":"object"' town.json >objects.json
	{
		grep -v '"record":"end"' town.json
		cat objects.json
		grep '"record":"end"' town.json
	} | json2tcs >twice.tcs
	tcs2citygml -q -j1 twice.tcs one.gml
	tcs2citygml -q -j4 twice.tcs four.gml
	cmp one.gml four.gml
	python3 "$ROOT/tests/check_ids.py" - one.gml
	validates 2.0 one.gml
}

# corners FILE: one line for each ring, its corners in an order of their own.
corners() {
	sed -n 's/.*<gml:posList[^>]*>\([^<]*\)<.*/\1/p' "$1" |
		awk '{
			n = (NF - 3) / 3
			for (i = 1; i <= n; i++)
				p[i] = $(3 * i - 2) " " $(3 * i - 1) " " $(3 * i)
			least = 1
			for (i = 2; i <= n; i++)
				if (p[i] < p[least])
					least = i
			for (i = 0; i < n; i++)
				printf "%s%s", p[(least - 1 + i) % n + 1],
					i < n - 1 ? "," : "\n"
		}' | sort
}

# Every polygon in triangles: nearly all rings come back, the rest being those
# of walls in one plane that were two polygons, and solids stay closed.
triangles_become_polygons_again() {
	citygml2tcs -q --lod "$all" "$SAMPLES/town-$1.gml" whole.tcs
	tcs2json whole.tcs | python3 "$ROOT/tests/split_polygons.py" |
		json2tcs >split.tcs
	tcs2citygml -q --citygml "$1" whole.tcs whole.gml
	tcs2citygml -q --citygml "$1" split.tcs split.gml
	validates "$1" split.gml
	python3 "$ROOT/tests/check_ids.py" - split.gml
	awk -f "$ROOT/tests/closed.awk" split.gml
	corners whole.gml >whole.txt
	corners split.gml >split.txt
	(($(comm -12 whole.txt split.txt | wc -l) > $(wc -l <whole.txt) * 99 / 100))
}

# A level made of the original's triangles beside the original: each in its
# own properties, the original with its ids and coordinates as before.
levels_stand_beside_each_other() {
	"$BUILD/samples/maketown" --citygml "$1" --lod 3 >town.gml
	citygml2tcs -q --lod "$all" town.gml one.tcs
	tcs2json one.tcs | python3 "$ROOT/tests/split_polygons.py" \
		--add "$2" | json2tcs >both.tcs
	tcs2citygml -q --citygml "$1" both.tcs both.gml
	validates "$1" both.gml
	python3 "$ROOT/tests/check_ids.py" - both.gml
	awk -f "$ROOT/tests/closed.awk" both.gml
	is "$(grep -c '<gml:Solid gml:id="[^"]*_lod[0-4]"' both.gml)" \
		"$(grep -c "<[a-z]*:lod3Solid>" town.gml)"
	citygml2tcs -q --lod 3 both.gml original.tcs
	citygml2tcs -q --lod 3 town.gml before.tcs
	same_stream before.tcs original.tcs
}

# The polygons of a simplified stream have triangles only.
outlines_come_from_triangles() {
	citygml2tcs -q "$SAMPLES/town-2.0.gml" | tcs2json |
		jq -c 'if .record == "object" then
			(.geometries[]?.polygons[]? |
				select(.triangles)) |= del(.rings, .flags) |
			del(.paints) else . end' | json2tcs >bare.tcs
	tcs2citygml -q bare.tcs bare.gml
	validates 2.0 bare.gml
	python3 "$ROOT/tests/check_ids.py" - bare.gml
	awk -f "$ROOT/tests/closed.awk" bare.gml
}

# hostile N FEATURES: a stream of one object, whose features jq makes of [0, N).
hostile() {
	jq -nc "{record: \"head\", crs: {kind: \"projected\",
			metres_per_unit: 1, metres_per_unit_up: 1}},
		{record: \"object\", features: [range($1) as \$i | $2]},
		{record: \"end\", objects: 1}" | json2tcs
}

# Nested parts and attribute sets, and one id for all: none takes the square of
# its number in time or bytes. (It was minutes, and gigabytes.)
what_nests_deep_costs_no_more() {
	# shellcheck disable=SC2016
	hostile 50000 '{class: "BuildingPart", id: "same"} +
		if $i > 0 then {parent: ($i - 1)} else {} end' >parts.tcs
	# shellcheck disable=SC2016
	hostile 1 '{class: "Building", attributes: [range(50000) as $j |
		{name: "Address", type: "set"} +
		if $j > 0 then {member_of: ($j - 1)} else {name: "address"}
		end]}' >sets.tcs
	local stream
	for stream in parts sets; do
		timeout 20 tcs2citygml -q -o out.gml "$stream.tcs"
		(($(wc -c <out.gml) < 50000000))
	done
}

broken_streams_write_nothing() {
	citygml2tcs -q "$SAMPLES/town-2.0.gml" town.tcs
	head -c 100000 town.tcs >broken.tcs
	status_is 1 tcs2citygml -q broken.tcs out.gml
	[[ ! -e out.gml ]]
	is "$(tcs2citygml -q broken.tcs 2>&1 >/dev/null | wc -l)" 1
	is "$(tcs2citygml -q broken.tcs 2>/dev/null | wc -c)" 0
	status_is 1 tcs2citygml -q -o /dev/full town.tcs
}

# corpus_file PATH VERSION FOLDER: one line of the table, and why when it is not
# well. A shell of its own for each way: -e means nothing before ||.
# shellcheck disable=SC2016
corpus_file() {
	local other=3.0 verdict=equal
	[[ $2 != 3.0 ]] || other=2.0
	mkdir -p "$3" && cd "$3" || exit 1
	bash -euc 'comes_back "$@"' - "$2" "$data/citygml/$1" >log 2>&1 ||
		verdict=DIFFERENT
	bash -euc 'goes_there "$@"' - "$2" "$other" "$data/citygml/$1" \
		>>log 2>&1 || verdict+=,NOT-CONVERTED
	printf '%s\t%s\t%s\n' "$2" "$verdict" "$1"
	[[ $verdict == equal ]] || grep -v ' validates$' log | head -n 4
	cd .. && rm -rf "$3"
}

# Every valid file of the corpus, in its version and through another one. Those
# in roundtrip-differences.tsv differ for the reason it gives.
# shellcheck disable=SC2016
corpus_comes_back() {
	export -f corpus_file comes_back goes_there validates same_stream
	export data schemas all ROOT
	awk -F'\t' '$23 ~ /^valid\([123]\.0\)/ {
		version = substr($23, 7, 3)
		printf "%s%c%s%cf%d%c", $1, 0, version, 0, NR, 0
	}' "$data/citygml/MANIFEST.tsv" |
		xargs -0 -n 3 -P "$(nproc)" \
			bash -c 'corpus_file "$@"' - >table
	awk -F'\t' 'NF == 3 { seen[$1 " " $2]++ }
		END { for (i in seen) print seen[i], i }' table |
		sort -k2 >"$tests_folder/counts"
	sed '/^#/d; s/\t.*//' "$ROOT/tests/roundtrip-differences.tsv" >known
	! grep -A4 -P '^\d\.\d\t(?!equal\t)' table | grep -v -F -f known |
		grep -P '^\d\.\d\t(?!equal\t)' || {
		cat table
		return 1
	}
}

for version in 1.0 2.0 3.0; do
	run_test town_comes_back $version
done
run_test town_goes_there 2.0 3.0
run_test town_goes_there 3.0 2.0
run_test town_goes_there 2.0 1.0
run_test town_goes_there 1.0 3.0
run_test solids_stay_closed 2.0 2.0
run_test solids_stay_closed 2.0 3.0
run_test solids_stay_closed 3.0 2.0
run_test jobs_make_no_difference
run_test differences_are_noticed
run_test ids_stay_unique
for version in 1.0 2.0 3.0; do
	run_test triangles_become_polygons_again $version
done
run_test levels_stand_beside_each_other 2.0 3:2
run_test levels_stand_beside_each_other 2.0 3:1
run_test levels_stand_beside_each_other 3.0 3:2
run_test outlines_come_from_triangles
run_test what_nests_deep_costs_no_more
run_test broken_streams_write_nothing
# Minutes, most of them xmllint's: once is enough.
if [[ ! -e $data/citygml/MANIFEST.tsv || ! -e $schemas ]]; then
	skip corpus_comes_back "no ../shared/data"
elif [[ ${BUILD##*/} != release ]]; then
	skip corpus_comes_back "only in the release build"
else
	run_test corpus_comes_back
	cat "$tests_folder/counts"
fi
finish
