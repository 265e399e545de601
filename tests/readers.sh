#!/bin/bash
# Readers that are not ours find as many polygons in what is written as in what
# was read: libcitygml (libcitygml-dev), and GDAL (python3-gdal), each where it
# is installed, over the valid files of ../shared/data.

# shellcheck source=tests/check.sh
. "$(dirname "$0")/check.sh"

ROOT=$(cd "$(dirname "$0")/.." && pwd)
PATH=${BUILD:-$ROOT/build/release}/bin:$PATH
data=$ROOT/../shared/data/citygml
differences=$ROOT/tests/readers-differences.tsv

# count READER FILE: how many it finds; "refused".
count() {
	local found
	case $1 in
	libcitygml) found=$(timeout 60 ./libcitygml "$2" 2>/dev/null) || : ;;
	GDAL) found=$(timeout 60 /usr/bin/python3 \
		"$ROOT/tests/gdal_polygons.py" "$2" 2>/dev/null) || : ;;
	esac
	tail -n 1 <<<"${found:-refused}"
}

# corpus_file READER PATH VERSION FOLDER: READER, path, counts before and after.
corpus_file() {
	mkdir "$4"
	ln -s ../libcitygml "$4"
	cd "$4" || exit 1
	cp "$data/$2" before.gml
	citygml2tcs -q --lod all before.gml |
		tcs2citygml -q --citygml "$3" -o after.gml
	printf '%s\t%s\t%s\t%s\n' "$1" "$2" "$(count "$1" before.gml)" \
		"$(count "$1" after.gml)"
	cd .. && rm -rf "$4"
}

# Every valid file; those that differ stand in readers-differences.tsv, each
# with its counts and the reason, and no other stands there.
# shellcheck disable=SC2016
counts_agree() {
	export -f corpus_file count
	export ROOT data
	[[ ! -e ../libcitygml ]] || mv ../libcitygml .
	awk -F'\t' -v reader="$1" '$23 ~ /^valid\([123]\.0\)/ {
		version = substr($23, 7, 3)
		if (reader != "libcitygml" || version != "3.0")
			printf "%s%c%s%c%s%cf%d%c", reader, 0, $1, 0,
				version, 0, NR, 0
	}' "$data/MANIFEST.tsv" |
		xargs -0 -n 4 -P "$(nproc)" bash -c 'corpus_file "$@"' - >table
	awk -F'\t' '$3 == "refused" { refused++; next }
		$3 == $4 { same++; n += $3 }
		END {
			printf "%s: %d of %d files agree, %d polygons; ",
				$1, same, NR - refused, n
			print refused + 0 " originals are refused"
		}' table | tee -a "$tests_folder/counts"
	awk -F'\t' '$3 != $4' table | sort >found
	grep "^$1	" "$differences" | cut -f1-4 | sort >known
	diff known found
}

if [[ ! -e $data/MANIFEST.tsv ]]; then
	skip counts_agree "no ../shared/data"
	finish
fi
if "${CXX:-g++}" -std=c++17 -o "$tests_folder/libcitygml" \
	"$ROOT/tests/libcitygml_polygons.cpp" -lcitygml 2>/dev/null; then
	run_test counts_agree libcitygml
else
	skip "counts_agree libcitygml" "it is not installed"
fi
if /usr/bin/python3 -c 'import osgeo.ogr' 2>/dev/null; then
	run_test counts_agree GDAL
else
	skip "counts_agree GDAL" "it is not installed"
fi
[[ ! -e $tests_folder/counts ]] || cat "$tests_folder/counts"
finish
