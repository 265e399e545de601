#!/bin/bash
# The samples are what maketown and makehouse write; the towns are valid CityGML
# and their solids closed.

# shellcheck source=tests/check.sh
. "$(dirname "$0")/../check.sh"

maketown=$BUILD/samples/maketown
schemas=$ROOT/../shared/data/schemas

# validates VERSION FILE
validates() {
	XML_CATALOG_FILES=$schemas/catalog.xml xmllint --huge --nonet --noout \
		--schema "$schemas/citygml-$1.xsd" "$2"
}

closed() {
	awk -f "$ROOT/tests/closed.awk" "$1"
}

sample_is_what_maketown_writes() {
	"$maketown" --citygml "$1" | cmp - "$SAMPLES/town-$1.gml"
}

house_is_what_makehouse_writes() {
	"$BUILD/samples/makehouse" --schema "$1" |
		cmp - "$SAMPLES/house-$1.ifc"
}

sample_is_valid() {
	validates "$1" "$SAMPLES/town-$1.gml"
}

solids_are_closed() {
	closed "$SAMPLES/town-$1.gml"
}

# Every list of levels of detail gives a town of its own.
each_lod_is_valid_and_closed() {
	local lod
	for lod in 0 1 2 3 4 0,2 1,3,4; do
		"$maketown" --citygml "$1" --lod "$lod" >town.gml
		closed town.gml
		[[ ! -e $schemas ]] || validates "$1" town.gml
	done
}

walls_are_shared_everywhere() {
	"$maketown" --citygml "$1" --seed 7 --buildings 150 --global-xlinks \
		>town.gml
	closed town.gml
	is "$(grep -c '<bldg:Building ' town.gml)" 150
	(($(grep -c 'OrientableSurface orient' town.gml) > 20))
	[[ ! -e $schemas ]] || validates "$1" town.gml
}

# A solid with one wall missing, and one with all its points moved in one ring.
open_solids_are_noticed() {
	sed '0,/<gml:surfaceMember xlink/{/<gml:surfaceMember xlink/d}' \
		"$SAMPLES/town-2.0.gml" >open.gml
	status_is 1 closed open.gml
	sed '/<gml:Solid/,/posList/s/posList>45/posList>46/' \
		"$SAMPLES/town-2.0.gml" >moved.gml
	status_is 1 closed moved.gml
}

# All rings run backwards: the solid lies inside out.
turned_solids_are_noticed() {
	"$maketown" --lod 1 --buildings 1 --citygml 1.0 | awk '
		/posList>/ {
			text = $0
			gsub(/<[^>]*>/, "", text)
			n = split(text, word, " ")
			out = ""
			for (i = n - 2; i > 0; i -= 3)
				out = out word[i] " " word[i + 1] " " word[i + 2] " "
			sub(/posList>[^<]*/, "posList>" out)
		}
		{ print }' >turned.gml
	status_is 1 closed turned.gml
}

towns_grow_to_size() {
	local bytes
	bytes=$("$maketown" --megabytes 20 | wc -c)
	((bytes > 20000000 && bytes < 22000000))
	[[ $("$maketown" --seed 1 | cksum) != $("$maketown" --seed 2 | cksum) ]]
}

# 25 to 280 parts and 2,500 to 6,000 triangles each, the same for one seed.
blocks_have_many_parts() {
	local makeblock=$BUILD/samples/makeblock
	"$makeblock" --buildings 40 --seed "$1" >block.gml
	"$makeblock" --buildings 40 --seed "$1" | cmp - block.gml
	[[ ! -e $schemas ]] || validates 2.0 block.gml
	"$BUILD/bin/citygml2tcs" --strict -q block.gml | "$BUILD/bin/tcs2json" |
		jq 'select(.record == "object") |
			(.features | length - 1) as $parts |
			([.geometries[].polygons[].triangles | length] | add) as $n |
			$parts >= 25 and $parts <= 280 and $n >= 2500 and $n <= 6000' \
			>counts
	is "$(sort counts | uniq -c | tr -s ' ')" ' 40 true'
}

for version in 1.0 2.0 3.0; do
	run_test sample_is_what_maketown_writes $version
	run_test solids_are_closed $version
	if [[ -e $schemas ]]; then
		run_test sample_is_valid $version
	else
		skip "sample_is_valid $version" "no schemas beside the project"
	fi
	run_test each_lod_is_valid_and_closed $version
	run_test walls_are_shared_everywhere $version
done
for schema in IFC2X3 IFC4; do
	run_test house_is_what_makehouse_writes $schema
done
run_test open_solids_are_noticed
run_test turned_solids_are_noticed
run_test towns_grow_to_size
run_test blocks_have_many_parts 0
finish
