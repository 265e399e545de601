#!/bin/bash
# lod_pictures.sh PICTURE.png FILE.ifc...: the largest building of each file as
# it is, and with a half and a fifth of its triangles, by tcs-simplify and by
# plain quadric error metrics, one row a file. The pictures are those of
# tcs-compare; `make bench-peers` builds what else this needs, and Chromium puts
# them side by side. ROOT, BUILD and PATH as tests/bench/run.sh sets them.
set -eu

picture=$1
shift
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# largest FILE: its largest building into $folder/in.
largest() {
	local name
	ifc2tcs -q --no-spaces "$1" "$folder/read" 2>"$folder/log"
	tcs-simplify -q --rate 0 --expand "$folder/read" "$folder/flat"
	tcs2json "$folder/flat" >"$folder/json"
	name=$(jq -r 'select(.record == "object" and
		.features[0].class == "Building") |
		"\([.geometries[].triangles | length] | add) \(.features[0].id)"' \
		"$folder/json" | sort -n | tail -n 1 | cut -d ' ' -f 2-)
	jq -c --arg name "$name" 'if .record == "end" then {record}
		else select(.record != "object" or
			.features[0].id == $name) end' \
		"$folder/json" | json2tcs -q - "$folder/in"
}

# cell WHICH CAPTION: picture WHICH of the report, 1 before and 2 after.
cell() {
	printf '<td><img src="%s"><br>%s</td>\n' "$(grep -o \
		'data:image/png;base64,[A-Za-z0-9+/=]*' "$folder/report" |
		sed -n "$1p")" "$2"
}

# compare WITH: the report, and into $whole and $kept the triangles and contacts
# before and after.
compare() {
	tcs-compare -q --html "$folder/in" "$1" -o "$folder/report"
	tcs-compare -q --json "$folder/in" "$1" >"$folder/numbers"
	whole=$(jq -r '.all | "\(.triangles_before) triangles, " +
		"\(.contacts_before) contacts"' "$folder/numbers")
	kept=$(jq -r '.all | "\(.triangles_after) triangles, " +
		"\(.contacts_kept) contacts"' "$folder/numbers")
}

{
	echo '<!DOCTYPE html><meta charset="utf-8"><style>
		body { margin: 0; font: 14px sans-serif; text-align: center }
		img { width: 300px } td, th { padding: 4px } </style><table>
		<tr><th>original<th colspan=2>a half: tcs-simplify, plain QEM
		<th colspan=2>a fifth: tcs-simplify, plain QEM'
	for file; do
		largest "$file"
		echo '<tr>'
		for rate in 0.5 0.8; do
			tcs-simplify -q --rate $rate "$folder/in" "$folder/out"
			compare "$folder/out"
			[[ $rate != 0.5 ]] || cell 1 "${file##*/}: $whole"
			cell 2 "$kept"
			"$BUILD/tests/bench/lod_peer" --peer qem --rate $rate \
				<"$folder/in" >"$folder/out"
			compare "$folder/out"
			cell 2 "$kept"
		done
	done
} >"$folder/page.html"
"${CHROMIUM:-chromium}" --headless --no-sandbox --hide-scrollbars \
	--window-size=1570,$((40 + 332 * $#)) --screenshot="$picture" \
	"file://$folder/page.html" 2>"$folder/log"
