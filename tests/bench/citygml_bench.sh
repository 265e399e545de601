#!/bin/bash
# What reading CityGML costs: citygml2tcs on one core beside libxml2 with
# handlers that do nothing, and beside libcitygml with tessellation where its
# headers are installed. Seconds of CPU time, medians; peak memory; two threads.
#
#     MEGABYTES=300 ROUNDS=3 FILE=town.gml    what is read, and how often
set -eu

megabytes=${MEGABYTES:-300}
rounds=${ROUNDS:-3}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
small=$folder/small.gml
large=${FILE:-$folder/large.gml}

# measure COMMAND...: "CPU WALL PEAK", in seconds and megabytes; medians.
measure() {
	python3 - "$rounds" "$@" <<-'PYTHON'
		import os, resource, statistics, subprocess, sys, time
		runs = []
		for _ in range(int(sys.argv[1])):
		    began = time.monotonic()
		    child = subprocess.Popen(sys.argv[2:], stdin=open(os.environ["IN"]),
		        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
		    _, status, used = os.wait4(child.pid, 0)
		    if status:
		        sys.exit("failed: " + " ".join(sys.argv[2:]))
		    runs.append((used.ru_utime + used.ru_stime,
		        time.monotonic() - began, used.ru_maxrss / 1024))
		print(*("%.3f" % statistics.median(column) for column in zip(*runs)))
	PYTHON
}

# ratio A B
ratio() {
	awk -v a="$1" -v b="$2" 'BEGIN { printf "%.2f", a / b }'
}

show() {
	printf '%-36s %9.2f %9.2f %9.0f\n' "$@"
}

"$BUILD/samples/maketown" --megabytes 30 --lod 2 >"$small"
[[ ${FILE:-} ]] ||
	"$BUILD/samples/maketown" --megabytes "$megabytes" --lod 2 >"$large"
export IN=$large
printf '%s bytes\n%-36s %9s %9s %9s\n' "$(wc -c <"$large")" '' \
	'CPU s' 'wall s' 'peak MB'

read -r sax sax_wall sax_peak < <(measure "$BUILD/tests/bench/sax_bare")
show 'libxml2, empty handlers' "$sax" "$sax_wall" "$sax_peak"
read -r cpu wall peak < <(measure citygml2tcs -q -j 1 "$large")
show 'citygml2tcs -j 1' "$cpu" "$wall" "$peak"
read -r cpu2 wall2 peak2 < <(measure citygml2tcs -q -j 2 "$large")
show 'citygml2tcs -j 2' "$cpu2" "$wall2" "$peak2"
read -r cpu_small wall_small peak_small < <(
	measure citygml2tcs -q -j 1 "$small"
)
show 'citygml2tcs -j 1, 30 MB' "$cpu_small" "$wall_small" "$peak_small"

echo "of the speed of libxml2 alone: $(ratio "$sax" "$cpu") (wanted: 0.6)"
echo "wall time of -j 2 to -j 1: $(ratio "$wall2" "$wall") (wanted: 0.7)"

cat >"$folder/other.cpp" <<-'CPP'
	#include <citygml/citygml.h>
	#include <citygml/citymodel.h>
	int main(int, char **argv)
	{
		citygml::ParserParams params;
		return !citygml::load(argv[1], params);
	}
CPP
if ! "${CXX:-g++}" -O2 -o "$folder/other" "$folder/other.cpp" -lcitygml \
	2>"$folder/log"; then
	echo 'libcitygml is not installed'
	exit
fi
if ! (exec "$folder/other" "$small") >"$folder/log" 2>&1; then
	echo "libcitygml cannot read this: $(tail -n 1 "$folder/log")"
	exit
fi
IN=$small
read -r other other_wall other_peak < <(measure "$folder/other" "$small")
show 'libcitygml, tessellating, 30 MB' "$other" "$other_wall" "$other_peak"
echo "as fast as libcitygml: $(ratio "$other" "$cpu_small") times (wanted: 10)"
