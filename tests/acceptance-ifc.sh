#!/bin/bash
# tests/acceptance-ifc.sh [FOLDER]: every IFC file of ../shared/data/ifc, or of
# FOLDER, through ifc2tcs.
#
# Each file must become a stream that does not depend on the number of jobs, or
# end with status 1, one line on standard error and no output. The products
# that the folder's REFERENCE.tsv names must have its boxes and volumes; each
# that has not must stand in acceptance-ifc-by-hand.tsv, which has them as
# worked out from what the file says, with the reason, and must have those; and
# each line there must be needed. What is worked out knows no chords: those
# files are read with short ones for it.
#
# Each stream must become CityGML 2.0 and 3.0 that is valid, where the schemas
# are beside FOLDER, with ids that are unique and links that lead somewhere.
#
# WORK names an empty folder to keep what is made; otherwise nothing is kept.
# Prints what disagrees, and "N passed, N failed" as its last line.
set -u

ROOT=$(cd "$(dirname "$0")/.." && pwd)
BUILD=${BUILD:-$ROOT/build/release}
DATA=${1:-$ROOT/../shared/data/ifc}
PATH=$BUILD/bin:$PATH
if [[ ${WORK:-} ]]; then
	mkdir -p "$WORK" || exit 1
else
	WORK=$(mktemp -d) || exit 1
	trap 'rm -rf "$WORK"' EXIT
fi
BY_HAND=$ROOT/tests/acceptance-ifc-by-hand.tsv
export ROOT DATA WORK PATH BY_HAND LC_ALL=C

# written NUMBER PATH: the stream as CityGML, with sound ids.
written() {
	local version
	for version in 2.0 3.0; do
		tcs2citygml -q --citygml $version "$at.tcs" -o "$at-$version.gml" ||
			echo "$2: not written as CityGML $version" >>"$at.broken"
	done
	python3 "$ROOT/tests/check_ids.py" - "$at"-[23].0.gml >"$at.ids" ||
		sed "s|^|$2: |" "$at.ids" >>"$at.broken"
}
export -f written

# one NUMBER PATH: what becomes of one file, as files named by its number.
one() {
	local at=$WORK/$1 file=$DATA/$2 status
	timeout 120 ifc2tcs -q --local -j 2 "$file" -o "$at.tcs" 2>"$at.said"
	status=$?
	if ((status == 0)); then
		ifc2tcs -q --local -j 1 "$file" | cmp -s - "$at.tcs" ||
			echo "$2: one job is not two jobs" >>"$at.broken"
		tcs2json "$at.tcs" | python3 "$ROOT/tests/ifc_reference.py" \
			"$DATA/REFERENCE.tsv" "$2" | sed "s|^|$2\t|" >"$at.verdicts"
		if cut -f 1 "$BY_HAND" | grep -qxF "$2"; then
			ifc2tcs -q --local --deflection 0.00001 "$file" | tcs2json |
				python3 "$ROOT/tests/ifc_reference.py" "$BY_HAND" "$2" |
				sed "s|^|$2\t|" >"$at.by-hand"
		fi
		written "$@"
	elif ((status != 1)) || [[ $(wc -l <"$at.said") != 1 || -e $at.tcs ]]; then
		echo "$2: status $status" >>"$at.broken"
	fi
	rm -f "$at.tcs"
}
export -f one

[[ -r $DATA/MANIFEST.tsv ]] || {
	echo "acceptance-ifc.sh: no MANIFEST.tsv in $DATA" >&2
	exit 1
}
tail -n +2 "$DATA/MANIFEST.tsv" | cut -f 1 |
	awk '{ printf "%d%c%s%c", NR, 0, $0, 0 }' |
	xargs -0 -n 2 -P "$(nproc)" bash -c 'one "$@"' one

# Files in one call: a schema is read once.
schemas=$DATA/../schemas
for version in 2.0 3.0; do
	[[ -d $schemas ]] || break
	printf '%s\0' "$WORK"/*-$version.gml |
		XML_CATALOG_FILES=$schemas/catalog.xml xargs -0 xmllint --huge \
			--nonet --noout --schema "$schemas/citygml-$version.xsd" 2>&1 |
		grep -v ' validates$' >"$WORK/invalid-$version.broken"
done

cat "$WORK"/*.verdicts | sort >"$WORK/verdicts"
cat "$WORK"/*.broken 2>/dev/null
broken=$(cat "$WORK"/*.broken 2>/dev/null | wc -l)
files=$(tail -n +2 "$DATA/MANIFEST.tsv" | wc -l)
agree=$(cut -f 2 "$WORK/verdicts" | grep -c '^agrees$')
rows=$(tail -n +2 "$DATA/REFERENCE.tsv" | wc -l)

# differs FILE...: what does not agree, without the verdict.
differs() {
	cat "$@" | awk -F '\t' '$2 != "agrees" { print $1 "\t" $3 }' | sort
}
differs "$WORK/verdicts" >"$WORK/differ"
differs "$WORK"/*.by-hand >"$WORK/wrong"
tail -n +2 "$BY_HAND" | cut -f 1,2 | sort >"$WORK/worked-out"
comm -23 "$WORK/differ" "$WORK/worked-out" | sed 's/^/differs: /' >"$WORK/bad"
comm -13 "$WORK/differ" "$WORK/worked-out" |
	sed 's/^/is worked out, but agrees: /' >>"$WORK/bad"
sed 's/^/differs from what is worked out: /' "$WORK/wrong" >>"$WORK/bad"
cat "$WORK/bad"
bad=$(wc -l <"$WORK/bad")
right=$(($(wc -l <"$WORK/worked-out") - $(wc -l <"$WORK/wrong")))
missing=$((rows - $(wc -l <"$WORK/verdicts")))
((missing == 0)) || echo "$missing products were not looked at"

echo "$agree of $rows products are as the references have them," \
	"$right as worked out by hand"
failed=$((broken + bad + missing))
echo "$((files + rows - failed)) passed, $failed failed"
((failed == 0))
