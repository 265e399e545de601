#!/bin/bash
# What reading CityGML costs: citygml2tcs beside libxml2 with handlers that do
# nothing, and beside libcitygml with tessellation where its headers are
# installed. Seconds of CPU time, medians; peak memory; two threads.
#
# The files: a town of ours, in two sizes, and tiles of real cities, each
# repeated with ids of its own, where a folder ../shared/data has them.
# libcitygml ends with an exception at the town's polygons that stand directly
# in a geometry property (gml:Polygon in lod2Geometry), and finds no polygon in
# the tile of CityGML 3.0, whose geometry properties it does not know; it reads
# the others.
#
#     MEGABYTES=300 ROUNDS=3 FILE=town.gml    what is read, and how often
set -eu

megabytes=${MEGABYTES:-300}
rounds=${ROUNDS:-3}
data=$ROOT/../shared/data/citygml
tiles=(
	kdmayer+CityGML-Preprocessing-Demo/LoD2_32_280_5657_1_NW.gml
	jklimke+libcitygml/berlin_open_data_sample_data.citygml
	citygml4j+citygml4j/datasets/lod2_buildings_v3.gml
)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# measure FILE COMMAND...: "CPU WALL PEAK", in seconds and megabytes; medians.
measure() {
	python3 - "$rounds" "$@" <<-'PYTHON'
		import os, statistics, subprocess, sys, time
		runs = []
		for _ in range(int(sys.argv[1])):
		    began = time.monotonic()
		    with open(sys.argv[2]) as file:
		        child = subprocess.Popen(sys.argv[3:], stdin=file,
		            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
		    _, status, used = os.wait4(child.pid, 0)
		    if status:
		        sys.exit("failed: " + " ".join(sys.argv[3:]))
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
	printf '  %-34s %9.2f %9.2f %9.0f\n' "$@"
}

build_other() {
	cat >"$folder/other.cpp" <<-'CPP'
		#include <citygml/citygml.h>
		#include <citygml/citymodel.h>
		#include <citygml/cityobject.h>
		#include <citygml/geometry.h>

		static bool has_polygons(const citygml::Geometry &geometry)
		{
			if (geometry.getPolygonsCount())
				return true;
			for (unsigned i = 0; i < geometry.getGeometriesCount(); i++)
				if (has_polygons(geometry.getGeometry(i)))
					return true;
			return false;
		}

		static bool has_polygons(const citygml::CityObject &object)
		{
			for (unsigned i = 0; i < object.getGeometriesCount(); i++)
				if (has_polygons(object.getGeometry(i)))
					return true;
			for (unsigned i = 0; i < object.getChildCityObjectsCount(); i++)
				if (has_polygons(object.getChildCityObject(i)))
					return true;
			return false;
		}

		/* Fails unless it finds a polygon. */
		int main(int, char **argv)
		{
			citygml::ParserParams params;
			auto model = citygml::load(argv[1], params);

			for (unsigned i = 0; model && i < model->getNumRootCityObjects(); i++)
				if (has_polygons(model->getRootCityObject(i)))
					return 0;
			return 1;
		}
	CPP
	"${CXX:-g++}" -O2 -o "$folder/other" "$folder/other.cpp" -lcitygml \
		2>"$folder/log" || echo 'libcitygml is not installed'
}

# beside_other FILE CPU
beside_other() {
	local cpu wall peak
	[[ -x $folder/other ]] || return 0
	if ! read -r cpu wall peak < <(measure "$1" "$folder/other" "$1" \
		2>"$folder/log"); then
		echo '  libcitygml cannot read this'
		return 0
	fi
	show libcitygml "$cpu" "$wall" "$peak"
	echo "  as fast as libcitygml: $(ratio "$cpu" "$2") times (wanted: 10)"
}

# bench_file NAME FILE
bench_file() {
	local sax one two wall wall2 peak
	printf '%s, %d MB\n  %-34s %9s %9s %9s\n' "$1" \
		"$(($(wc -c <"$2") / 1000000))" '' 'CPU s' 'wall s' 'peak MB'
	read -r sax wall peak < <(measure "$2" "$BUILD/tests/bench/sax_bare")
	show 'libxml2, empty handlers' "$sax" "$wall" "$peak"
	read -r one wall peak < <(measure "$2" citygml2tcs -q -j 1 "$2")
	show 'citygml2tcs -j 1' "$one" "$wall" "$peak"
	read -r two wall2 peak < <(measure "$2" citygml2tcs -q -j 2 "$2")
	show 'citygml2tcs -j 2' "$two" "$wall2" "$peak"
	beside_other "$2" "$one"
	echo "  of the speed of libxml2 alone: $(ratio "$sax" "$one")" \
		"(wanted: 0.6)"
	echo "  wall time of -j 2 to -j 1: $(ratio "$wall2" "$wall")" \
		"(wanted: 0.7)"
}

build_other
if [[ ${FILE:-} ]]; then
	bench_file "${FILE##*/}" "$FILE"
	exit
fi
for size in $((megabytes / 10)) "$megabytes"; do
	"$BUILD/samples/maketown" --megabytes "$size" --lod 2 \
		>"$folder/file.gml"
	bench_file 'the town' "$folder/file.gml"
done
for tile in "${tiles[@]}"; do
	[[ -e $data/$tile ]] || continue
	"$ROOT/tests/bench/replicate.py" "$data/$tile" $((megabytes / 3)) \
		>"$folder/file.gml"
	bench_file "${tile##*/}" "$folder/file.gml"
done
