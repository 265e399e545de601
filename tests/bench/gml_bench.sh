#!/bin/bash
# What writing CityGML costs: megabytes of XML per second of CPU time, on one
# core, of a town as it was read, of the same in other versions, and of one
# whose polygons are single triangles, which are joined again. Medians.
#
#     MEGABYTES=100 ROUNDS=3
set -eu

megabytes=${MEGABYTES:-100}
rounds=${ROUNDS:-3}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# measure NAME STREAM OPTION...
measure() {
	python3 - "$rounds" "$folder/out.gml" "$@" <<-'PYTHON'
		import os, resource, statistics, subprocess, sys
		rounds, out, name, stream = sys.argv[1:5]
		seconds = []
		for _ in range(int(rounds)):
		    child = subprocess.Popen(
		        ["tcs2citygml", "-q", "-j", "1", "-o", out, *sys.argv[5:], stream])
		    _, status, used = os.wait4(child.pid, 0)
		    if status:
		        sys.exit("failed: " + name)
		    seconds.append(used.ru_utime + used.ru_stime)
		size = os.path.getsize(out) / 1e6
		cpu = statistics.median(seconds)
		print("%-28s %7.1f MB %7.2f s %7.0f MB/s %7.0f MB peak" % (
		    name, size, cpu, size / cpu, used.ru_maxrss / 1024))
	PYTHON
}

"$BUILD/samples/maketown" --megabytes "$megabytes" --lod 2 |
	citygml2tcs -q --lod all -o "$folder/town.tcs"
measure 'as it was read, 2.0' "$folder/town.tcs"
measure 'the same, 3.0' "$folder/town.tcs" --citygml 3.0
measure 'the same, 1.0' "$folder/town.tcs" --citygml 1.0
"$BUILD/samples/maketown" --megabytes $((megabytes / 5)) --lod 3 |
	citygml2tcs -q --lod all -o "$folder/small.tcs"
measure 'LOD 3 as it was read' "$folder/small.tcs"
tcs2json "$folder/small.tcs" | python3 "$ROOT/tests/split_polygons.py" |
	json2tcs -o "$folder/triangles.tcs"
measure 'the same from triangles' "$folder/triangles.tcs"
