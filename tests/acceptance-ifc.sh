#!/bin/bash
# tests/acceptance-ifc.sh [FOLDER]: the products of every file of
# ../shared/data/ifc, or of FOLDER, that its REFERENCE.tsv names, compared with
# the boxes and volumes there: how many agree, and each that does not.
#
# WORK names an empty folder to keep the list in; otherwise nothing is kept.
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
export ROOT DATA WORK PATH LC_ALL=C

# one PATH: the verdicts about a file's products, behind its path.
one() {
	timeout 120 ifc2tcs -q --local "$DATA/$1" | tcs2json 2>/dev/null |
		python3 "$ROOT/tests/ifc_reference.py" \
			"$DATA/REFERENCE.tsv" "$1" | sed "s|^|$1\t|"
}
export -f one

# shellcheck disable=SC2016
sed 1d "$DATA/REFERENCE.tsv" | cut -f1 | sort -u |
	xargs -d '\n' -P "$(nproc)" -I{} bash -c 'one "$1"' _ {} >"$WORK/verdicts"
sort -o "$WORK/verdicts" "$WORK/verdicts"
grep -vP '^[^\t]*\tagrees\t' "$WORK/verdicts"
agree=$(grep -cP '^[^\t]*\tagrees\t' "$WORK/verdicts")
all=$(sed 1d "$DATA/REFERENCE.tsv" | wc -l)
echo "$agree of $all products agree"
