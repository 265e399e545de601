#!/bin/bash
# Streams and lines of text from strangers: whatever they hold, the programs
# that read them end soon, within bounds, and with either a whole file or one
# line that says why not.

# shellcheck source=tests/check.sh
. "$(dirname "$0")/../check.sh"

PATH=$BUILD/bin:$PATH

# A triangle at a number that can be told from all others.
small_text() {
	printf '%s\n' '{"record":"head","crs":{"kind":"projected","metres_per_unit":1,"metres_per_unit_up":1}}' \
		"{\"record\":\"object\",\"features\":[{\"class\":\"Building\",\"id\":\"b\"}],\"geometries\":[{\"feature\":0,\"lod\":1,\"kind\":\"multi-surface\",\"polygons\":[{\"surface\":0,\"rings\":[{\"vertex_count\":3}],\"vertices\":[[0,0,0],[1234.5,0,0],[0,1,0]],\"triangles\":[[0,1,2]]}]}]}" \
		'{"record":"end","objects":1}'
}

# Every program that reads a stream, and what it makes of it.
readers=('tcs2json out.json' 'tcs2gltf out.glb' 'tcs2citygml out.gml'
	'tcs2citygml out.gml.gz' 'tcs-simplify out.tcs' 'tcs-exterior out.tcs')

# refused_by MEGABYTES TEXT COMMAND...: one line that holds TEXT, no output.
refused_by() {
	local megabytes=$1 text=$2
	shift 2
	status_is 1 bounded "$megabytes" "$@" 2>err
	is "$(wc -l <err)" 1
	grep -qF -- "$text" err || {
		cat err
		return 1
	}
	is "$(find . -name 'out.*' -o -name '.tessera-*')" ''
}

# refused TEXT: in.tcs, by every reader.
refused() {
	local text=$1 reader
	for reader in "${readers[@]}"; do
		refused_by 64 "$text" "${reader% *}" -q -j 1 in.tcs \
			-o "${reader#* }"
	done
}

# ---- damage ------------------------------------------------------------

every_cut_of_a_stream_is_noticed() {
	local size cut reader
	small_text | json2tcs >whole.tcs
	size=$(wc -c <whole.tcs)
	for ((cut = 0; cut < size; cut++)); do
		head -c "$cut" whole.tcs >in.tcs
		reader=${readers[cut % ${#readers[@]}]}
		refused_by 64 'in.tcs: the stream ' "${reader% *}" -q -j 1 \
			in.tcs -o "${reader#* }"
	done
	for cut in 0 5 8 16 500 $((size - 1)); do
		head -c "$cut" whole.tcs >in.tcs
		refused 'in.tcs: the stream '
	done
}

# But for the version, of which a higher one is another message.
every_changed_byte_of_a_stream_is_noticed() {
	small_text | json2tcs >whole.tcs
	python3 - "${readers[@]}" <<-'PYTHON'
		import os, subprocess, sys
		whole = open("whole.tcs", "rb").read()
		readers = [reader.split() for reader in sys.argv[1:]]
		for at in range(len(whole)):
		    bad = bytearray(whole)
		    bad[at] ^= 1 << at % 8
		    program, out = readers[at % len(readers)]
		    done = subprocess.run([program, "-q", "-j", "1", "-", "-o", out],
		        input=bytes(bad), stderr=subprocess.PIPE)
		    if done.returncode != 1 or done.stderr.count(b"\n") != 1 or \
		            os.path.exists(out):
		        sys.exit(f"byte {at}, {program}: {done}")
	PYTHON
}

every_cut_of_text_is_noticed() {
	local size cut
	small_text >whole.json
	size=$(wc -c <whole.json)
	# Behind the last brace nothing is missing.
	for ((cut = 0; cut < size - 1; cut++)); do
		head -c "$cut" whole.json >in.json
		refused_by 64 'json2tcs: ' json2tcs in.json -o out.tcs
	done
	gzip -c whole.json >whole.gz
	size=$(wc -c <whole.gz)
	for ((cut = 1; cut < size; cut++)); do
		head -c "$cut" whole.gz >in.json
		refused_by 64 'json2tcs: ' json2tcs in.json -o out.tcs
	done
}

# ---- claims and numbers ------------------------------------------------

# changed FROM TO: whole.tcs with a number of eight bytes changed wherever it
# stands, and the checksums put right.
changed() {
	python3 - "$1" "$2" <<-'PYTHON'
		import struct, sys, zlib
		stream = open("whole.tcs", "rb").read()
		def number(text):
		    return struct.pack("<Q", int(text)) if text.isdigit() \
		        else struct.pack("<d", float(text))
		out, at = [stream[:16]], 16
		while at < len(stream):
		    head = stream[at:at + 28]
		    size = struct.unpack_from("<Q", head, 8)[0]
		    body = stream[at + 32:at + 32 + size]
		    head, body = (part.replace(number(sys.argv[1]), number(sys.argv[2]))
		        for part in (head, body))
		    out += [head, struct.pack("<I", zlib.crc32(head + body)), body]
		    at += 32 + size
		open("in.tcs", "wb").write(b"".join(out))
	PYTHON
}

coordinates_that_are_none_are_refused() {
	local number
	small_text | json2tcs >whole.tcs
	for number in nan inf -inf; do
		changed 1234.5 "$number"
		refused 'is not finite'
	done
	changed 1234.5 1e300
	status_is 0 tcs2json -q in.tcs -o far.json
	status_is 0 tcs2citygml -q in.tcs -o far.gml
}

# Records as long as memory, of which nothing follows; runs of as many.
claims_are_not_believed() {
	local length
	small_text | json2tcs >whole.tcs
	length=$(python3 -c 'import struct
print(struct.unpack_from("<Q", open("whole.tcs", "rb").read(), 24)[0])')
	changed "$length" 4000000000000000000
	refused 'exceeds the limit of 8589934592'
	changed "$length" 8000000000
	refused 'the stream stops without its end record'
}

# A record of a thousandth of its length, and one that is longer than it says.
compressed_bombs_are_bounded() {
	python3 - <<-'PYTHON'
		import struct, zlib
		def stream(length, claim):
		    body = zlib.compress(bytes(length), 9)
		    body += bytes(-len(body) % 8)
		    head = struct.pack("<IIQQI", 0x44414548, 1, len(body), claim, 0)
		    return b"\x89TCS\r\n\x1a\n" + struct.pack("<II", 1, 0) + head + \
		        struct.pack("<I", zlib.crc32(head + body)) + body
		open("long.tcs", "wb").write(stream(400 << 20, 400 << 20))
		open("liar.tcs", "wb").write(stream(400 << 20, 8))
	PYTHON
	mv liar.tcs in.tcs
	refused 'in.tcs: '
	mv long.tcs in.tcs
	for reader in "${readers[@]}"; do
		refused_by 64 'exceeds the limit of 1048576' "${reader% *}" -q \
			-j 1 --max-record 1M in.tcs -o "${reader#* }"
	done
}

# line TEXT ARGUMENT...: standard input between two lines of head and end, to
# json2tcs, must fail so.
line_is_refused() {
	local text=$1
	shift
	{
		small_text | head -n 1
		cat
		small_text | tail -n 1
	} >in.json
	refused_by "${megabytes-64}" "$text" json2tcs -j 1 "$@" in.json \
		-o out.tcs
}

numbers_of_text_are_finite_or_refused() {
	local number
	for number in NaN Infinity -Infinity nan 1e 0x10 1,5 +1 .5; do
		small_text | sed -n "2s/1234.5/$number/p" | line_is_refused 'line 2: '
	done
	for number in 1e400 -1e400; do
		small_text | sed -n "2s/1234.5/$number/p" |
			line_is_refused 'real number overflow'
	done
	# null is how a number that is none is written.
	small_text | sed -n '2s/1234.5/null/p' | line_is_refused 'not a number'
}

text_of_any_size_is_bounded() {
	awk 'BEGIN { while (n++ < 1000000) printf "[" }' |
		line_is_refused 'maximum parsing depth'
	awk 'BEGIN { while (n++ < 500000) printf "{\"features\":" }' |
		line_is_refused 'maximum parsing depth'
	head -c 100000000 /dev/zero | tr '\0' ' ' | gzip -1 >in.gz
	refused_by 64 'line 1: more than 1048576 bytes' \
		json2tcs --max-record 1M in.gz -o out.tcs
	# A name of 12 MB is a name.
	{
		small_text | sed -n '1p; 2s/"b".*/"/p' | head -c -1
		head -c 12000000 /dev/zero | tr '\0' x
		small_text | sed -n '2s/.*"b"/"/p; 3p'
	} >in.json
	(($(wc -c <in.json) > 12000000))
	status_is 0 bounded 300 json2tcs -j 1 in.json -o out.tcs
	status_is 0 bounded 300 tcs2citygml -q -j 1 out.tcs -o out.gml
	(($(wc -c <out.gml) > 12000000))
}

encodings_other_than_utf_8_are_refused() {
	local said
	small_text | sed 's/"id":"b"/"id":"Straße"/' >utf-8.json
	for said in 'utf-16le:' 'utf-16:' 'utf-32le:'; do
		iconv -f utf-8 -t "${said%:*}" utf-8.json >in.json
		refused_by 64 'json2tcs: in.json: line 1: ' \
			json2tcs in.json -o out.tcs
	done
	iconv -f utf-8 -t iso-8859-1 utf-8.json >in.json
	refused_by 64 'line 2: column ' json2tcs in.json -o out.tcs
	printf 'a\0b\n' >in.json
	refused_by 64 'line 1: ' json2tcs in.json -o out.tcs
	head -c 100000 /dev/urandom >in.json
	refused_by 64 'json2tcs: in.json: ' json2tcs in.json -o out.tcs
	head -c 100000 /dev/urandom >in.tcs
	refused 'this is no component stream'
	printf '<gml/>' >in.tcs
	refused 'this is no component stream'
	status_is 0 json2tcs utf-8.json -o out.tcs
}

# ---- references --------------------------------------------------------

# What refers to what is not there, or to itself, or stands behind.
# shellcheck disable=SC2016
references_lead_backwards_or_are_refused() {
	local change
	for change in \
		'.features += [{class: "WallSurface", parent: 1}]' \
		'.features += [{class: "WallSurface", parent: 7}]' \
		'.geometries[0].feature = 1' \
		'.geometries[0].polygons[0].surface = 1' \
		'.geometries[0].polygons[0].triangles[0][2] = 4294967295' \
		'.paints = [{polygon: 1, material: 0}]' \
		'.paints = [{polygon: 0, material: 0}]' \
		'.paints = [{polygon: 0, image: 0, texcoords: []}]' \
		'.instances = [{feature: 0, prototype: 0, matrix: [range(16)], anchor: [0, 0, 0]}]' \
		'.relations = [{feature: 3, role: "a", target: "b"}]'; do
		small_text | sed -n 2p | jq -c "$change" | line_is_refused 'line 2: '
	done
	# A prototype that places itself.
	small_text | sed -n 2p | jq -c '.record = "prototype" |
		.instances = [{feature: 0, prototype: 0, matrix: [range(16)], anchor: [0, 0, 0]}]' |
		line_is_refused 'line 2: '
}

# A message stays one line, a document stays well-formed, and a file name of
# somebody else's is no file of ours.
hostile_text_does_no_harm() {
	small_text | jq -c 'if .record == "object" then
		.features[0] = {class: "Building",
			id: "../../a\u001b[2J\n<!--&\"]]>\u0001\u202e",
			name: "<x y=\u0027z\u0027/>\u0000"[:-1],
			type: "a:b c=\"\" ><"} |
		.geometries[0].role = "lod1Solid><a" else . end' >in.json
	status_is 0 json2tcs in.json -o in.tcs
	status_is 0 tcs2citygml -j 1 in.tcs -o out.gml 2>err
	xmllint --noout out.gml
	[[ $(cat err) != *[$'\t\e']* ]]
	status_is 0 tcs2gltf -j 1 in.tcs -o out.gltf 2>>err
	jq -e '.nodes | length' out.gltf >/dev/null
	status_is 0 tcs2json in.tcs -o out.json
	status_is 0 json2tcs out.json -o again.tcs
	cmp in.tcs again.tcs
	is "$(find . -type f | wc -l)" 8
}

for test in every_cut_of_a_stream_is_noticed \
	every_changed_byte_of_a_stream_is_noticed every_cut_of_text_is_noticed \
	coordinates_that_are_none_are_refused claims_are_not_believed \
	compressed_bombs_are_bounded numbers_of_text_are_finite_or_refused \
	text_of_any_size_is_bounded encodings_other_than_utf_8_are_refused \
	references_lead_backwards_or_are_refused hostile_text_does_no_harm; do
	run_test $test
done
finish
