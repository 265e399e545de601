#!/bin/bash
# What is written in either spelling of ifcXML is read as what it was in STEP:
# over the sample houses and, where they are there, the shared data.

# shellcheck source=tests/check.sh
. "$(dirname "$0")/../check.sh"

data=$ROOT/../shared/data/ifc

# Objects in any order: what nests changes it, and so the numbers of instances
# that name materials without a name.
body() {
	ifc2tcs -q "$1" | tcs2json | sed -e 1d -e 's/"id":"#[0-9.]*"//g' | sort
}

# same_in_xml FILE: one that ifc2tcs refuses is not for this test.
same_in_xml() {
	body "$1" >step.json
	[[ -s step.json ]] || return 0
	files=$((files + 1))
	for spelling in 2 4; do
		"$BUILD/tests/tools/step_to_ifcxml" "$spelling" <"$1" >"$spelling.ifcxml"
		body "$spelling.ifcxml" | cmp - step.json || {
			echo "of ${1##*/} in spelling $spelling"
			return 1
		}
	done
}

the_sample_houses_are_the_same_in_xml() {
	local files=0
	for schema in IFC2X3 IFC4; do
		same_in_xml "$SAMPLES/house-$schema.ifc"
	done
	is "$files" 2
}

files_of_the_standard_are_the_same_in_xml() {
	local files=0
	for file in "$data"/bsi-4.3-samples/*.ifc; do
		(($(stat -c %s "$file") < 100000)) || continue
		same_in_xml "$file"
	done
	((files > 20))
}

real_files_are_read() {
	for file in "$data"/*/*.ifcxml; do
		ifc2tcs -q "$file" | tcs2json | tail -n 1 >end.json
		[[ $(jq '.polygons > 10' end.json) == true ]]
	done
}

run_test the_sample_houses_are_the_same_in_xml
if [[ -d $data ]]; then
	run_test files_of_the_standard_are_the_same_in_xml
	run_test real_files_are_read
else
	skip files_of_the_standard_are_the_same_in_xml "no shared data"
	skip real_files_are_read "no shared data"
fi
finish
