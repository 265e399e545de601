#!/bin/bash
# The filter at the end of tcs(5) is a program: it compiles, does what the page
# says, and fails as a stage should.

# shellcheck source=tests/check.sh
. "$(dirname "$0")/../check.sh"

build=$tests_folder/build
mkdir "$build"

# The C program in the page's source, its backslashes as C has them.
program_of_page() {
	awk '/^\.Bd -literal$/ { on = 1; next } /^\.Ed/ { on = 0 } on' \
		"$ROOT/lib/tcs.5" | sed 's/^\\&//; s/\\e/\\/g'
}

it_compiles_without_a_warning() {
	program_of_page >"$build/lift.c"
	"${CC:-cc}" -std=c11 -D_POSIX_C_SOURCE=200809L -O1 -Wall -Wextra \
		-Wpedantic -Werror -o "$build/lift" "$build/lift.c" -lz -lm
}

sample() {
	json2tcs "$@" <"$ROOT/tests/streams/every.json"
}

it_raises_vertices_and_anchors_and_nothing_else() {
	sample | "$build/lift" 0.3048 | tcs2json | tail -n +2 >out.json
	# The sample's heights are in feet.
	tail -n +2 "$ROOT/tests/streams/every.json" | jq -c '
		if .record == "object" then
			.geometries[].polygons[].vertices[][2] += 1 |
			.instances[].anchor[2] += 1
		else . end' >expect.json
	diff <(jq -cS . expect.json) <(jq -cS . out.json)
}

it_signs_the_head_and_raises_the_bounds() {
	sample | "$build/lift" 3.048 | tcs2json | head -n 1 >head.json
	is "$(jq -c '.stages | length' head.json)" 3
	is "$(jq -c '.stages[2]' head.json)" \
		'{"program":"lift","version":"1","arguments":"3.048"}'
	is "$(jq -c '.stages[0].program' head.json)" '"sample"'
	is "$(jq -c '.crs | [.lower[2], .upper[2], .origin[2]]' head.json)" \
		'[10,10.1,500]'
}

it_signs_a_head_without_stages_and_text() {
	printf '%s\n' '{"record":"head","crs":{"kind":"local",
		"metres_per_unit":1,"metres_per_unit_up":1}}' \
		'{"record":"end"}' | tr -d '\n' | sed 's/}{/}\n{/' | json2tcs |
		"$build/lift" 1 | tcs2json >out.json
	is "$(head -n 1 out.json | jq -c .stages)" \
		'[{"program":"lift","version":"1","arguments":"1"}]'
}

it_reads_compressed_records() {
	sample | "$build/lift" 2 >plain.tcs
	sample -z | "$build/lift" 2 | cmp - plain.tcs
}

twice_is_the_sum() {
	sample | "$build/lift" 1 | "$build/lift" 2 | tcs2json | sed -n '2,$p' \
		>twice.json
	sample | "$build/lift" 3 | tcs2json | sed -n '2,$p' >once.json
	awk -v tolerance=1e-9 -f "$ROOT/tests/near.awk" once.json twice.json
}

it_fails_without_an_end_record() {
	local size
	sample >town.tcs
	size=$(stat -c %s town.tcs)
	for bytes in 0 15 16 40 "$((size - 96))" "$((size - 1))"; do
		head -c "$bytes" town.tcs >short.tcs
		status_is 1 "$build/lift" 1 <short.tcs >out.tcs
		status_is 1 tcs2json out.tcs
	done
}

it_notices_damage_a_full_disk_and_wrong_usage() {
	sample >town.tcs
	printf X | dd of=town.tcs bs=1 seek=2000 conv=notrunc status=none
	status_is 1 "$build/lift" 1 <town.tcs >out.tcs
	sample >town.tcs
	status_is 1 "$build/lift" 1 <town.tcs >/dev/full
	status_is 2 "$build/lift" <town.tcs
	status_is 2 "$build/lift" high <town.tcs
	status_is 2 "$build/lift" nan <town.tcs
}

run_test it_compiles_without_a_warning
run_test it_raises_vertices_and_anchors_and_nothing_else
run_test it_signs_the_head_and_raises_the_bounds
run_test it_signs_a_head_without_stages_and_text
run_test it_reads_compressed_records
run_test twice_is_the_sum
run_test it_fails_without_an_end_record
run_test it_notices_damage_a_full_disk_and_wrong_usage
finish
