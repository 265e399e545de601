#!/bin/bash
# What of the 24 by 24 boxes behind a building is seen past it and through it,
# from the street and from the air, with all of its triangles and with a fifth:
# tcs-compare(1) says how they are counted. A simplifier that opens no gaps lets
# no box appear that was hidden.
#
# source: the visibility analysis of Wang et al. 2021, ISPRS IJGI 10, 422.
#
#     RATE=0.8  BUILDINGS=12  FILES="a.ifc ..."
set -eu

rate=${RATE:-0.8}
buildings=${BUILDINGS:-12}
data=$ROOT/../shared/data/ifc
files=${FILES:-$data/web-ifc/duplex.ifc $data/web-ifc/AC20-FZK-Haus.ifc}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
peer=$BUILD/tests/bench/lod_peer

if ! [[ -x $peer ]]; then
	echo "only 'make bench BENCH=visibility' builds what this needs"
	exit
fi

# count WITH: per building of more than 1000 triangles, boxes seen and opened.
count() {
	tcs-compare -q --json "$folder/in" "$1" | jq -r '.objects[] |
		select(.triangles_before > 1000) |
		"\(.boxes_seen_before)\t\(.boxes_seen_after)\t\(.boxes_opened)"'
}

# measure NAME: the buildings in $folder/in.
measure() {
	tcs-simplify -q --rate "$rate" "$folder/in" "$folder/out"
	count "$folder/out" >"$folder/ours"
	"$peer" --peer qem --rate "$rate" <"$folder/in" >"$folder/out"
	count "$folder/out" >"$folder/qem"
	paste "$folder/ours" "$folder/qem" | awk -F '\t' -v name="$1" '{
		printf "%-24s %8d %8d %8d %8d %8d\n",
			name, $1, $2, $3, $5, $6
	}'
}

printf '%-24s %8s %8s %8s %8s %8s\n' boxes before ours opened qem opened
"$BUILD/samples/makeblock" --buildings "$buildings" |
	citygml2tcs -q - "$folder/in"
measure generated
for file in $files; do
	[[ -e $file ]] || continue
	ifc2tcs -q --no-spaces "$file" "$folder/read" 2>"$folder/log"
	tcs-simplify -q --rate 0 --expand "$folder/read" "$folder/in"
	measure "${file##*/}"
done
