#!/bin/bash
# What tcs2gltf writes, seen by others: the Khronos validator, a reader of the
# metadata that was written from the specifications, a reader of the GML, and a
# viewer in a browser.

# shellcheck source=tests/check.sh
. "$(dirname "$0")/../check.sh"

node=$ROOT/tests/node
streams=$ROOT/tests/streams

# convert NAME: NAME.json to NAME.tcs, NAME.glb and NAME.gltf
convert() {
	json2tcs "$1.json" "$1.tcs"
	tcs2gltf -q "$1.tcs" "$1.glb"
	tcs2gltf -q "$1.tcs" "$1.gltf"
}

it_says_what_the_stream_says() {
	cp "$streams/$1.json" .
	convert "$1"
	node "$node/validate.mjs" "$1.glb" "$1.gltf"
	node "$node/compare.mjs" "$1.json" "$1.glb"
	node "$node/compare.mjs" "$1.json" "$1.gltf"
}

every_choice_of_options_is_valid() {
	local n=0 lod normals origin
	json2tcs "$streams/gltf.json" all.tcs
	for lod in highest all 0 1 2 3; do
		for normals in flat smooth none; do
			for origin in extras translation; do
				n=$((n + 1))
				tcs2gltf -q --lod "$lod" --normals "$normals" \
					--origin "$origin" all.tcs "$n.glb"
			done
		done
	done
	node "$node/validate.mjs" ./*.glb
}

# Images from a folder and from the stream, into either form of the file.
a_textured_house_is_valid() {
	json2tcs "$streams/textured.json" house.tcs
	tcs2gltf -q --images "$streams" house.tcs house.glb
	tcs2gltf -q --images "$streams" house.tcs house.gltf
	node "$node/validate.mjs" house.glb house.gltf
	node "$node/compare.mjs" "$streams/textured.json" house.glb
	jq -e '(.images | length) == 2 and (.textures | length) == 3' \
		house.gltf
}

# Prototypes in one place or many: the same triangles of the same features.
instances_look_the_same_however_they_are_written() {
	local how
	json2tcs "$1" town.tcs
	for how in baked nodes gpu; do
		tcs2gltf -q --instances "$how" town.tcs "$how.glb"
		tcs2gltf -q --instances "$how" -j 1 town.tcs again.glb
		cmp "$how.glb" again.glb
	done
	node "$node/validate.mjs" baked.glb nodes.glb gpu.glb
	node "$node/instances.mjs" baked.glb nodes.glb
	node "$node/instances.mjs" baked.glb gpu.glb
}

# Beyond 65,535 features ids are floats; beyond as many vertices indices are
# 32 bits wide.
a_large_city_says_what_its_stream_says() {
	python3 "$ROOT/tests/suites/many_features.py" 40000 >many.json
	convert many
	node "$node/validate.mjs" many.glb
	node "$node/compare.mjs" many.json many.glb
	jq -e '[.accessors[].componentType] | unique == [5123, 5125, 5126]' \
		many.gltf
}

a_city_without_objects_is_valid() {
	{
		sed 1q "$streams/every.json"
		echo '{"record":"end"}'
	} >none.json
	convert none
	node "$node/validate.mjs" none.glb none.gltf
	node "$node/compare.mjs" none.json none.glb
}

# altered SED: the comparison finds what differs.
a_difference_is_found() {
	cp "$streams/gltf.json" town.json
	convert town
	sed "$1" town.json >altered.json
	status_is 1 cmp -s town.json altered.json
	status_is 1 node "$node/compare.mjs" altered.json town.glb
}

# ---- the sample town ------------------------------------------------------

the_town_says_what_its_stream_says() {
	citygml2tcs -q "$SAMPLES/$1.gml" "$1.tcs"
	tcs2gltf -q "$1.tcs" "$1.glb"
	tcs2json "$1.tcs" "$1.json"
	node "$node/validate.mjs" "$1.glb"
	node "$node/compare.mjs" "$1.json" "$1.glb"
}

the_town_says_what_its_gml_says() {
	citygml2tcs -q "$SAMPLES/$1.gml" | tcs2gltf -q -o town.glb
	node "$node/compare_gml.mjs" "$SAMPLES/$1.gml" town.glb
}

the_town_is_the_same_for_any_number_of_jobs() {
	citygml2tcs -q "$SAMPLES/town-2.0.gml" town.tcs
	tcs2gltf -q -j1 town.tcs one.glb
	tcs2gltf -q -j2 town.tcs two.glb
	tcs2gltf -q -j7 <town.tcs >seven.glb
	cmp one.glb two.glb
	cmp one.glb seven.glb
}

a_browser_shows_the_town_and_its_walls() {
	citygml2tcs -q "$SAMPLES/town-2.0.gml" | tcs2gltf -q -o town.glb
	node "$node/browser.mjs" "$SAMPLES/town-2.0.gml" town.glb town.png
	cp town.png "$BUILD/town.png"
}

run_test it_says_what_the_stream_says every
run_test it_says_what_the_stream_says gltf
run_test a_textured_house_is_valid
run_test instances_look_the_same_however_they_are_written "$streams/gltf.json"
run_test instances_look_the_same_however_they_are_written \
	"$streams/forest.json"
run_test every_choice_of_options_is_valid
run_test a_large_city_says_what_its_stream_says
run_test a_city_without_objects_is_valid
run_test a_difference_is_found 's/"id":"w1"/"id":"w2"/'
run_test a_difference_is_found 's/"surface":1/"surface":0/'
run_test a_difference_is_found 's/1899/1900/g'
run_test a_difference_is_found 's/\[500006,/[500006.5,/g'
run_test a_difference_is_found 's/"class":"RoofSurface"/"class":"WallSurface"/'

if [[ -x $BUILD/bin/citygml2tcs ]]; then
	for version in 1.0 2.0 3.0; do
		run_test the_town_says_what_its_stream_says town-$version
		run_test the_town_says_what_its_gml_says town-$version
	done
	run_test the_town_is_the_same_for_any_number_of_jobs
	if [[ -x ${CHROMIUM:=/usr/bin/chromium} ]]; then
		export CHROMIUM
		run_test a_browser_shows_the_town_and_its_walls
	else
		skip a_browser_shows_the_town_and_its_walls 'no Chromium'
	fi
else
	skip the_town 'citygml2tcs is not built'
fi
finish
