#!/bin/bash
# tcs2json and json2tcs undo each other on the streams of our own parsers: over
# the samples, and over the shared data where that is there.

# shellcheck source=tests/check.sh
. "$(dirname "$0")/../check.sh"

data=$ROOT/../shared/data/citygml

# Both directions, and with any number of jobs. Whatever the parser refuses is
# not for these programs.
text_and_back_is_the_same() {
	citygml2tcs -q "$1" >one.tcs 2>/dev/null || return 0
	files=$((files + 1))
	tcs2json -j1 one.tcs >one.json &&
		json2tcs -j3 --strict one.json >two.tcs &&
		cmp one.tcs two.tcs &&
		tcs2json -j3 two.tcs | cmp - one.json &&
		json2tcs -z one.json | tcs2json | cmp - one.json
}

# over_every_file_below FOLDER SIZE: those smaller than SIZE, as find says it.
over_every_file_below() {
	local file files=0 bad=0
	while IFS= read -r -d '' file; do
		text_and_back_is_the_same "$file" || {
			echo "of ${file##*/}"
			bad=1
		}
	done < <(find "$1" -name '*.gml' -size "$2" -print0)
	((files > 0 && bad == 0))
}

over_the_samples() {
	over_every_file_below "$SAMPLES" -100M
}

over_the_shared_data() {
	over_every_file_below "$data" -8M
}

if [[ ! -x $BUILD/bin/citygml2tcs ]]; then
	skip over_the_samples "no citygml2tcs"
	finish
fi
run_test over_the_samples
if [[ -d $data ]]; then
	run_test over_the_shared_data
else
	skip over_the_shared_data "no shared data"
fi
finish
