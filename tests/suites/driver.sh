#!/bin/bash
# What tessera does when its stages die, hang, or are not there. The stages
# here are small scripts beside a copy of the driver.

# shellcheck source=tests/check.sh
. "$(dirname "$0")/../check.sh"

tessera=$BUILD/bin/tessera

# stage NAME: a stage beside a copy of the driver, its script from stdin.
stage() {
	mkdir -p bin
	[[ -e bin/tessera ]] || cp "$tessera" bin/
	{
		echo '#!/bin/bash'
		cat
	} >"bin/$1"
	chmod +x "bin/$1"
}

# A writer that takes everything, then writes OUT whole.
good_writer() {
	stage tcs2gltf <<'END'
while [[ $1 != -o ]]; do shift; done
cat >"$2.part" && mv "$2.part" "$2"
END
}

# A reader that passes its file on; the file is its last argument.
good_reader() {
	stage citygml2tcs <<'END'
cat "${@: -1}"
END
}

no_processes_left() {
	silent grep -l -a -s "$PWD/bin/" /proc/[0-9]*/cmdline
}

both_succeed() {
	good_reader
	good_writer
	echo town >in.gml
	status_is 0 bin/tessera in.gml -o out.glb
	is "$(cat out.glb)" town
}

the_first_fails_after_writing() {
	stage citygml2tcs <<'END'
echo half
echo "citygml2tcs: in.gml: broken" >&2
exit 1
END
	good_writer
	status_is 1 bin/tessera in.gml -o out.glb 2>err
	is "$(cat err)" "citygml2tcs: in.gml: broken
tessera: citygml2tcs failed with exit status 1"
	[[ ! -e out.glb ]]
}

the_first_is_killed() {
	stage citygml2tcs <<'END'
echo half
kill -KILL $$
END
	good_writer
	status_is 1 bin/tessera in.gml -o out.glb 2>err
	grep -q '^tessera: citygml2tcs was ended by signal 9' err
	[[ ! -e out.glb ]]
}

the_last_fails_while_the_first_writes_on() {
	stage citygml2tcs <<'END'
exec yes
END
	stage tcs2gltf <<'END'
head -c 100 >/dev/null
exit 1
END
	status_is 1 bin/tessera in.gml -o out.glb 2>err
	is "$(cat err)" "tessera: tcs2gltf failed with exit status 1"
}

# It neither reads nor writes, so only a signal ends it.
the_last_fails_while_the_first_hangs() {
	stage citygml2tcs <<'END'
exec -a "$0" sleep 1000
END
	stage tcs2gltf <<'END'
exit 1
END
	status_is 1 timeout 20 bin/tessera in.gml -o out.glb 2>err
	is "$(cat err)" "tessera: tcs2gltf failed with exit status 1"
	no_processes_left
}

a_stage_that_ignores_the_end_is_killed() {
	stage citygml2tcs <<'END'
trap '' TERM
while :; do sleep 1; done
END
	stage tcs2gltf <<'END'
exit 1
END
	status_is 1 timeout 30 bin/tessera in.gml -o out.glb 2>err
	no_processes_left
}

a_stage_refuses_its_options() {
	stage citygml2tcs <<'END'
echo "citygml2tcs: --lod 'x': not a level" >&2
exit 2
END
	good_writer
	status_is 2 bin/tessera --lod x in.gml -o out.glb 2>err
	[[ ! -e out.glb ]]
}

# terminated SIGNAL: the driver gets it while its stages work.
terminated() {
	local signal=$1 status=0
	stage citygml2tcs <<'END'
echo half
touch started
exec -a "$0" sleep 1000
END
	good_writer
	# In the background a shell has INT ignored; env gives it back.
	env --default-signal="$signal" bin/tessera in.gml -o out.glb &
	while [[ ! -e started ]]; do sleep 0.05; done
	kill "-$signal" $!
	wait $! || status=$?
	is "$status" $((128 + $(kill -l "$signal")))
	[[ ! -e out.glb ]]
	no_processes_left
}

one_stage_alone() {
	stage citygml2tcs <<'END'
[[ "$*" == "-o out.tcs in.gml" ]] && echo stream >"$2"
END
	status_is 0 bin/tessera in.gml -o out.tcs
	is "$(cat out.tcs)" stream
}

standard_streams_pass_through() {
	stage citygml2tcs <<'END'
(($# == 0)) && tr a-z A-Z
END
	stage tcs2json <<'END'
(($# == 0)) && cat
END
	is "$(echo town | bin/tessera --from gml --to json)" TOWN
}

nobody_reads_the_output() {
	local statuses
	stage citygml2tcs <<'END'
exec yes
END
	stage tcs2json <<'END'
exec cat
END
	bin/tessera --from gml --to json 2>err | head -n 1 >first
	statuses="${PIPESTATUS[*]}"
	is "$statuses" "141 0"
	is "$(cat first err)" y
}

statistics_are_joined() {
	local program
	for program in citygml2tcs tcs2gltf; do
		stage "$program" <<'END'
while [[ $1 != --stats ]]; do shift; done
echo "{\"program\": \"$(basename "$0")\"}" >"$2"
cat "$3" >/dev/null 2>&1
:
END
	done
	mkdir tmp
	status_is 0 env TMPDIR="$PWD/tmp" bin/tessera in.gml -o out.glb \
		--stats stats.json
	is "$(jq -c '[.program, (.stages | map(.program))]' stats.json)" \
		'["tessera",["citygml2tcs","tcs2gltf"]]'
	is "$(find tmp -mindepth 1)" ''
}

no_statistics_without_success() {
	stage citygml2tcs <<'END'
exit 1
END
	good_writer
	mkdir tmp
	status_is 1 env TMPDIR="$PWD/tmp" bin/tessera in.gml -o out.glb \
		--stats stats.json
	[[ ! -e stats.json ]]
	is "$(find tmp -mindepth 1)" ''
}

# The driver's own folder comes before PATH, and PATH is the way out.
programs_are_found_beside_then_on_path() {
	good_writer
	mkdir other
	printf '#!/bin/sh\necho other\n' >other/citygml2tcs
	chmod +x other/citygml2tcs
	status_is 0 env PATH="$PWD/other:$PATH" bin/tessera in.gml -o out.glb
	is "$(cat out.glb)" other
	stage citygml2tcs <<'END'
echo beside
END
	status_is 0 env PATH="$PWD/other:$PATH" bin/tessera in.gml -o out.glb
	is "$(cat out.glb)" beside
}

arguments_survive_quoting() {
	local pipe
	stage citygml2tcs <<'END'
printf '<%s>' "$@"
END
	stage tcs2gltf <<'END'
cat; printf '<%s>' "$@"
END
	pipe=$(bin/tessera -n "it's \$a \"b\".gml" -o 'o ut.glb')
	is "$(PATH=$PWD/bin:$PATH bash -c "$pipe")" \
		"$(bin/tessera "it's \$a \"b\".gml" -o 'o ut.glb')"
}

a_stage_that_cannot_be_started() {
	good_writer
	cp /dev/null bin/citygml2tcs
	printf '#!/no/such/interpreter\n' >bin/citygml2tcs
	chmod +x bin/citygml2tcs
	status_is 1 bin/tessera in.gml -o out.glb 2>err
	grep -q 'bin/citygml2tcs: cannot be started: ' err
	[[ ! -e out.glb ]]
}

run_test both_succeed
run_test the_first_fails_after_writing
run_test the_first_is_killed
run_test the_last_fails_while_the_first_writes_on
run_test the_last_fails_while_the_first_hangs
run_test a_stage_that_ignores_the_end_is_killed
run_test a_stage_refuses_its_options
run_test terminated TERM
run_test terminated INT
run_test terminated HUP
run_test one_stage_alone
run_test standard_streams_pass_through
run_test nobody_reads_the_output
run_test statistics_are_joined
run_test no_statistics_without_success
run_test programs_are_found_beside_then_on_path
run_test arguments_survive_quoting
run_test a_stage_that_cannot_be_started
finish
