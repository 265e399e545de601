#!/bin/bash
# tests/acceptance.sh [FOLDER]: every CityGML file of ../shared/data/citygml, or
# of FOLDER, through the programs.
#
# Each file must become a GLB without a complaint of the Khronos validator, or
# end with status 1, one line on standard error and no output. What is counted
# in the stream must agree with the folder's MANIFEST.tsv; each difference must
# stand, with its reason, in acceptance-differences.tsv, and each line there
# must be needed. So must what text_kept.py misses of the text. The stream must not depend on the number of jobs, on coming
# from a file, a pipe or a gzip, and must survive its text twin.
#
# WORK names an empty folder to keep what is made; otherwise nothing is kept.
# Prints a table, and "N passed, N failed" as its last line.
set -u

ROOT=$(cd "$(dirname "$0")/.." && pwd)
BUILD=${BUILD:-$ROOT/build/release}
DATA=${1:-$ROOT/../shared/data/citygml}
PATH=$BUILD/bin:$PATH
if [[ ${WORK:-} ]]; then
	mkdir -p "$WORK" || exit 1
else
	WORK=$(mktemp -d) || exit 1
	trap 'rm -rf "$WORK"' EXIT
fi
export ROOT DATA WORK PATH LC_ALL=C

# Everything of a stream but its head, which names the source.
body() {
	tcs2json "$1" | sed 1d
}

# equal NAME ONE OTHER: note a difference under the file's number.
equal() {
	cmp -s "$2" "$3" || echo "$1" >>"$at.broken"
}

# The same bytes whatever the jobs; the same body from a pipe or a gzip; the
# same bytes after the text twin and back.
equalities() {
	local file=$1
	citygml2tcs -q -j 1 --lod all "$file" -o "$at.one"
	equal 'one job = two jobs' "$at.one" "$at.tcs"
	# A pipe, which cannot be read twice.
	# shellcheck disable=SC2002
	cat "$file" | citygml2tcs -q --lod all --images "${file%/*}" >"$at.pipe"
	body "$at.tcs" >"$at.body"
	body "$at.pipe" | cmp -s - "$at.body" || echo 'pipe = file' >>"$at.broken"
	if [[ $file == *.gz ]]; then
		gzip -dc "$file" >"$at.other"
	else
		gzip -1c "$file" >"$at.other"
	fi
	citygml2tcs -q --lod all --images "${file%/*}" "$at.other" \
		-o "$at.packed"
	body "$at.packed" | cmp -s - "$at.body" || echo 'gzip = plain' >>"$at.broken"
	tcs2json "$at.tcs" | json2tcs | cmp -s - "$at.tcs" ||
		echo 'text twin = stream' >>"$at.broken"
}

# one NUMBER PATH: what becomes of one file, as files named by its number.
one() {
	local at=$WORK/$1 file=$DATA/$2 status
	citygml2tcs -q -j 2 --lod all --stats "$at.stats" "$file" \
		-o "$at.tcs" 2>"$at.said"
	status=$?
	echo $status >"$at.status"
	tessera -q "$file" -o "$at.glb" 2>"$at.said-glb"
	[[ $? == "$status" ]] || echo 'both end alike' >>"$at.broken"
	if ((status == 0)); then
		[[ -s $at.glb && ! -s $at.said && ! -s $at.said-glb ]] ||
			echo 'output and no word on success' >>"$at.broken"
		tcs2json "$at.tcs" >"$at.json"
		node "$ROOT/tests/acceptance.mjs" count <"$at.json" \
			>"$at.counts"
		"$ROOT/tests/text_kept.py" "$file" "$at.json" >"$at.text"
		equalities "$file"
	else
		[[ $(wc -l <"$at.said") == 1 && ! -e $at.tcs && ! -e $at.glb ]] ||
			echo 'one line and no output on failure' >>"$at.broken"
	fi
	rm -f "$at".{one,pipe,body,other,packed,tcs,json}
}
export -f body equal equalities one

[[ -r $DATA/MANIFEST.tsv ]] || {
	echo "acceptance.sh: no MANIFEST.tsv in $DATA" >&2
	exit 1
}
[[ -d $ROOT/tests/node/node_modules ]] || make -s -C "$ROOT" \
	tests/node/node_modules/.package-lock.json || exit 1

tail -n +2 "$DATA/MANIFEST.tsv" | cut -f 1 |
	awk '{ printf "%d%c%s%c", NR, 0, $0, 0 }' |
	xargs -0 -n 2 -P "$(nproc)" bash -c 'one "$@"' one

shopt -s nullglob
glbs=("$WORK"/*.glb)
((${#glbs[@]} == 0)) ||
	node "$ROOT/tests/node/validate.mjs" "${glbs[@]}" >"$WORK/validator"
node "$ROOT/tests/acceptance.mjs" report "$DATA/MANIFEST.tsv" \
	"$ROOT/tests/acceptance-differences.tsv" "$WORK"
