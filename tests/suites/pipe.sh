#!/bin/bash
# The programs together, on the samples: what must be equal, and what happens
# when a joint breaks.

# shellcheck source=tests/check.sh
. "$(dirname "$0")/../check.sh"

town=$SAMPLES/town-2.0.gml

for program in citygml2tcs tcs2gltf tcs2citygml tcs2json json2tcs tcs-simplify \
	tcs-exterior tessera; do
	[[ -x $BUILD/bin/$program ]] && continue
	skip "all of it" "$program is not built"
	finish
done

nothing_is_left_here() {
	is "$(find . -mindepth 1 ! -name err)" ''
}

one_job_and_many_write_the_same() {
	local version=$1
	citygml2tcs -q -j 1 "$SAMPLES/town-$version.gml" one.tcs
	citygml2tcs -q -j 4 "$SAMPLES/town-$version.gml" many.tcs
	cmp one.tcs many.tcs
	tcs2gltf -q -j 1 one.tcs one.glb
	tcs2gltf -q -j 4 one.tcs many.glb
	cmp one.glb many.glb
}

a_pipe_a_file_and_gzip_give_the_same() {
	citygml2tcs -q "$town" file.tcs
	gzip -c "$town" >town.gml.gz
	citygml2tcs -q town.gml.gz packed.tcs
	citygml2tcs -q <"$town" >stdin.tcs
	# shellcheck disable=SC2002 # a pipe is the point
	cat "$town" | citygml2tcs -q >pipe.tcs
	tcs2json packed.tcs | jq -c 'del(.sources)' >packed.json
	tcs2json file.tcs | jq -c 'del(.sources)' >file.json
	tcs2json pipe.tcs | jq -c 'del(.sources)' >pipe.json
	cmp file.json packed.json
	cmp file.json pipe.json
	cmp stdin.tcs pipe.tcs
	tcs2gltf -q file.tcs file.glb
	tcs2gltf -q <file.tcs >pipe.glb
	cmp file.glb pipe.glb
}

the_driver_is_the_pipe_it_prints() {
	tessera -q "$town" -o driver.glb
	mv driver.glb kept.glb
	bash -c "$(tessera -q -n "$town" -o driver.glb)"
	cmp driver.glb kept.glb
}

there_and_back_is_identity() {
	citygml2tcs -q "$SAMPLES/town-$1.gml" a.tcs
	tcs2json a.tcs b.json
	json2tcs b.json c.tcs
	tcs2json c.tcs d.json
	# Both stages sign the head; the rest is the same, byte for byte.
	cmp <(tail -n +2 b.json) <(tail -n +2 d.json)
}

statistics_of_the_driver_are_json() {
	tessera -q "$town" -o town.glb --stats stats.json
	is "$(jq -r '.stages | map(.program) | join(" ")' stats.json)" \
		'citygml2tcs tcs2gltf'
	is "$(jq '.stages[0].counts.objects == .stages[1].counts.objects' \
		stats.json)" true
}

# A stream that stops anywhere makes the writer fail without a file.
a_cut_stream_fails_every_reader() {
	local size cut
	citygml2tcs -q "$town" >../whole.tcs
	size=$(wc -c <../whole.tcs)
	for cut in 0 1 7 100 $((size / 2)) $((size - 100)) $((size - 1)); do
		status_is 1 tcs2gltf -q -o out.glb 2>err < <(
			head -c "$cut" ../whole.tcs
		)
		is "$(wc -l <err)" 1
		status_is 1 tcs2json -o out.json 2>err < <(
			head -c "$cut" ../whole.tcs
		)
	done
	rm ../whole.tcs
	nothing_is_left_here
}

a_broken_document_leaves_nothing() {
	head -c 700000 "$town" >../cut.gml
	status_is 1 tessera -q ../cut.gml -o out.glb 2>err
	grep -q '^citygml2tcs: ' err
	grep -q '^tessera: citygml2tcs failed' err
	is "$(wc -l <err)" 2
	status_is 1 tessera -q "$SAMPLES/demo.sh" --from gml -o out.glb 2>err
	status_is 1 tessera -q nowhere.gml -o out.glb 2>err
	rm ../cut.gml
	nothing_is_left_here
}

a_full_disk_is_a_failure() {
	local program=$1
	shift
	status_is 1 "$program" -q "$@" >/dev/full 2>err
	grep -q 'No space left on device' err
	is "$(wc -l <err)" 1
	status_is 1 "$program" -q "$@" -o /dev/full 2>err
	status_is 1 "$program" -q "$@" -o out --stats /dev/full 2>err
	[[ ! -e out ]]
}

a_closed_pipe_ends_quietly() {
	local statuses program=$1
	shift
	"$program" -q "$@" 2>err | head -c 10 >/dev/null
	statuses="${PIPESTATUS[*]}"
	is "$statuses" '141 0'
	is "$(cat err)" ''
}

# Its document never ends, so the parser works until it is killed.
a_killed_parser_fails_the_writer() {
	local parser
	mkfifo document joint
	citygml2tcs -q document joint &
	parser=$!
	exec 9>document
	head -c 500000 "$town" >&9 &
	(
		sleep 0.3
		kill -KILL "$parser"
	) &
	status_is 1 tcs2gltf -q -o out.glb <joint 2>err
	exec 9>&-
	is "$(grep -c '^tcs2gltf: ' err)" 1
	rm document joint
	nothing_is_left_here
}

a_writer_that_is_ended_leaves_nothing() {
	local signal=$1 out=$2 status=0 writer
	mkfifo joint
	env --default-signal="$signal" "${@:3}" -q -o "$out" <joint &
	writer=$!
	exec 9>joint
	citygml2tcs -q "$town" | head -c 500000 >&9 || :
	sleep 0.2
	kill "-$signal" "$writer"
	wait "$writer" || status=$?
	exec 9>&-
	is "$status" $((128 + $(kill -l "$signal")))
	rm joint
	nothing_is_left_here
}

binary_stays_off_the_terminal() {
	# script runs a command on a terminal of its own.
	status_is 2 script -qec "citygml2tcs '$town'" /dev/null >said
	grep -q terminal said
}

citygml2tcs -q "$town" "$tests_folder/town.tcs"
tcs2json "$tests_folder/town.tcs" "$tests_folder/town.json"

for version in 1.0 2.0 3.0; do
	run_test one_job_and_many_write_the_same $version
	run_test there_and_back_is_identity $version
done
run_test a_pipe_a_file_and_gzip_give_the_same
run_test the_driver_is_the_pipe_it_prints
run_test statistics_of_the_driver_are_json
run_test a_cut_stream_fails_every_reader
run_test a_broken_document_leaves_nothing
run_test a_killed_parser_fails_the_writer
for signal in TERM INT HUP; do
	run_test a_writer_that_is_ended_leaves_nothing $signal out.glb tcs2gltf
	run_test a_writer_that_is_ended_leaves_nothing $signal out.gml \
		tcs2citygml
	run_test a_writer_that_is_ended_leaves_nothing $signal out.tcs \
		tcs-simplify --rate 0.5
done
for way in a_full_disk_is_a_failure a_closed_pipe_ends_quietly; do
	run_test $way citygml2tcs "$town"
	run_test $way tcs2gltf "$tests_folder/town.tcs"
	run_test $way tcs2citygml "$tests_folder/town.tcs"
	run_test $way tcs-exterior "$tests_folder/town.tcs"
	run_test $way tcs-simplify "$tests_folder/town.tcs"
	run_test $way tcs2json "$tests_folder/town.tcs"
	run_test $way json2tcs "$tests_folder/town.json"
done
run_test a_closed_pipe_ends_quietly tessera --from gml --to jsonl "$town"
if command -v script >/dev/null; then
	run_test binary_stays_off_the_terminal
else
	skip binary_stays_off_the_terminal "there is no script(1)"
fi
finish
