#!/bin/bash
# tests/bench/run.sh [NAME...]: run every measurement, or those named: the
# programs *_bench and the scripts tests/bench/*_bench.sh, one after the other.
# Scripts find the programs on PATH, and the folders in ROOT, BUILD, SAMPLES.
set -u

ROOT=$(cd "$(dirname "$0")/../.." && pwd)
SAMPLES=$ROOT/samples
PATH=$BUILD/bin:$PATH
export ROOT BUILD SAMPLES PATH LC_ALL=C
status=0

if (($# == 0)); then
	for file in "$ROOT"/tests/bench/*_bench.c "$ROOT"/tests/bench/*_bench.sh
	do
		[[ -e $file ]] || continue
		name=${file##*/}
		set -- "$@" "${name%_bench.*}"
	done
fi

for name; do
	echo "== $name"
	if [[ -e $ROOT/tests/bench/${name}_bench.sh ]]; then
		"$ROOT/tests/bench/${name}_bench.sh" || status=1
	else
		"$BUILD/tests/bench/${name}_bench" || status=1
	fi
done
exit $status
