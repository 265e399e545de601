#!/bin/bash
# Documents from strangers: whatever they hold, citygml2tcs ends soon, within
# bounds, and with either a whole stream or one line that says why not.

# shellcheck source=tests/check.sh
. "$(dirname "$0")/../check.sh"
# shellcheck source=tests/cases/citygml2tcs/document.sh
. "$(dirname "$0")/../cases/citygml2tcs/document.sh"

town=$SAMPLES/town-2.0.gml
if [[ ! -x $BUILD/bin/citygml2tcs ]]; then
	skip "all of it" "citygml2tcs is not built"
	finish
fi

# refused MEGABYTES TEXT [OPTION...]: in.gml ends with one line that holds
# TEXT, and with no output.
refused() {
	local megabytes=$1 text=$2
	shift 2
	status_is 1 bounded "$megabytes" \
		citygml2tcs -j 1 "$@" in.gml out.tcs 2>err
	is "$(wc -l <err)" 1
	grep -qF -- "$text" err || {
		cat err
		return 1
	}
	is "$(find . -name out.tcs -o -name '.tessera-*')" ''
}

# accepted MEGABYTES [OPTION...]: in.gml becomes out.tcs.
accepted() {
	local megabytes=$1
	shift
	status_is 0 bounded "$megabytes" \
		citygml2tcs -j 1 "$@" in.gml out.tcs 2>err
}

# times N TEXT: the text so often, on one line.
times() {
	awk -v n="$1" -v text="$2" \
		'BEGIN { while (n-- > 0) printf "%s", text }'
}

# numbered N FORMAT: FORMAT printed with 0 … N-1.
numbered() {
	awk -v n="$1" -v text="$2" \
		'BEGIN { for (i = 0; i < n; i++) printf text, i, i }'
}

# declared TEXT: a document with this internal subset.
declared() {
	printf '<!DOCTYPE CityModel [%s]>\n' "$1"
	model "$(building a '<gml:name>&a;</gml:name>')"
}

# around OPENING CLOSING: standard input within a document.
around() {
	model '' | head -n -1
	printf '%s' "$1"
	cat
	printf '%s</CityModel>\n' "$2"
}

surface_begin='<cityObjectMember><bldg:Building gml:id="a"><bldg:lod1MultiSurface>
<gml:MultiSurface><gml:surfaceMember><gml:Polygon gml:id="p"><gml:exterior>
<gml:LinearRing><gml:posList>'
surface_end='</gml:posList></gml:LinearRing></gml:exterior></gml:Polygon>
</gml:surfaceMember></gml:MultiSurface></bldg:lod1MultiSurface>
</bldg:Building></cityObjectMember>'

# ---- declarations ------------------------------------------------------

entities_are_refused() {
	local refusal='entity declarations are refused'
	declared "<!ENTITY a 'ha'>$(numbered 20 '<!ENTITY b%d "&a;&a;&a;">')" \
		>in.gml
	refused 64 "$refusal"
	declared "<!ENTITY a '$(times 100000 ha)'>" >in.gml
	refused 64 "$refusal"
	declared '<!ENTITY % a "<!ENTITY b SYSTEM \"file:///etc/passwd\">"> %a;' \
		>in.gml
	refused 64 "$refusal"
	declared '<!ENTITY a SYSTEM "file:///etc/passwd">' >in.gml
	refused 64 "$refusal"
	declared '<!ENTITY a SYSTEM "http://127.0.0.1:9/a">' >in.gml
	refused 64 "$refusal"
	declared '' >in.gml
	refused 64 "Entity 'a' not defined"
}

attribute_defaults_are_refused() {
	declared "<!ATTLIST Building a CDATA '$(times 100000 ha)'>" >in.gml
	refused 64 'attribute declarations are refused: Building'
	declared "$(numbered 20000 '<!ATTLIST Building a%d CDATA "">')" >in.gml
	refused 64 'attribute declarations are refused: Building'
	declared '<!ATTLIST Building a (b|c) "b">' >in.gml
	refused 64 'attribute declarations are refused: Building'
}

# A pipe that nobody writes to: who opens it, waits.
a_document_type_is_not_fetched() {
	mkfifo trap.dtd
	{
		echo '<!DOCTYPE CityModel PUBLIC "-//x//y" "trap.dtd">'
		model "$(building a '')"
	} >in.gml
	accepted 64
	{
		echo '<?xml-stylesheet href="trap.dtd"?>'
		model "$(building a '')" | sed '1s|>*$| xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xsi:schemaLocation="urn:x trap.dtd"|'
	} >in.gml
	accepted 64
}

# Files whose content would show, were they read.
what_stands_elsewhere_does_not_come_in() {
	printf '<!ENTITY a "SECRET"><!ATTLIST bldg:Building gml:id CDATA "SECRET">' \
		>outside.dtd
	printf '<gml:name xmlns:gml="http://www.opengis.net/gml">SECRET</gml:name>' \
		>outside.xml
	{
		echo '<!DOCTYPE CityModel SYSTEM "outside.dtd">'
		model "$(building a '<gml:name>&a;</gml:name>')"
	} >in.gml
	refused 64 "Entity 'a' not defined"
	{
		echo '<!DOCTYPE CityModel SYSTEM "outside.dtd">'
		model '<cityObjectMember><bldg:Building/></cityObjectMember>'
	} >in.gml
	accepted 64
	[[ $(tcs2json out.tcs) != *SECRET* ]]
	rm out.tcs
	declared '<!ENTITY % all SYSTEM "outside.dtd"> %all;' >in.gml
	refused 64 'entity declarations are refused'
	model "$(building a '<xi:include xmlns:xi="http://www.w3.org/2001/XInclude" href="outside.xml"/>')" \
		>in.gml
	accepted 64
	[[ $(tcs2json out.tcs) != *SECRET* ]]
}

images_and_links_are_not_opened() {
	mkfifo trap
	model "<app:appearanceMember><app:Appearance><app:surfaceDataMember>
<app:ParameterizedTexture><app:imageURI>$PWD/../../$PWD/trap</app:imageURI>
<app:target uri='#p'><app:TexCoordList><app:textureCoordinates ring='#r'>0 0 1 0 1 1 0 1 0 0</app:textureCoordinates></app:TexCoordList></app:target>
</app:ParameterizedTexture></app:surfaceDataMember></app:Appearance></app:appearanceMember>
<cityObjectMember xlink:href='trap#x'/>
$(building a "<bldg:lod1MultiSurface><gml:MultiSurface>
<gml:surfaceMember xlink:href='trap#q'/><gml:surfaceMember xlink:href='file:trap#q'/>
<gml:surfaceMember>$(polygon p "$square")</gml:surfaceMember></gml:MultiSurface></bldg:lod1MultiSurface>")" >in.gml
	accepted 64
	grep -q '1 member skipped: a link, not followed' err
	is "$(tcs2json out.tcs | jq -c 'select(.record == "palette").images[0].uri')" \
		"\"$PWD/../../$PWD/trap\""
}

# ---- size --------------------------------------------------------------

nesting_is_bounded() {
	times 1000000 '<a>' | around '<cityObjectMember><Building>' '' >in.gml
	refused 64 'nest deeper than 512 (--max-depth)'
	times 1000000 '<a>' | around '<unknown>' '' >in.gml
	refused 64 'nest deeper than 512 (--max-depth)'
	times 1000000 '<gml:MultiSurface><gml:surfaceMember>' | around \
		'<cityObjectMember><Building><lod1MultiSurface>' '' >in.gml
	refused 64 'nest deeper than 512 (--max-depth)'
}

long_attributes_are_read() {
	times 12000000 x | around '<cityObjectMember><bldg:Building gml:id="' \
		'"/></cityObjectMember>' >in.gml
	accepted 200
	is "$(tcs2json out.tcs | jq 'select(.record == "object").features[0].id | length')" \
		12000000
	rm out.tcs
	refused 64 'a tag or comment is longer than 1048576 bytes (--max-tag)' \
		--max-tag 1M
}

markup_without_end_is_bounded() {
	local opening
	for opening in '<!--' '<?x ' '<cityObjectMember a="' '<!DOCTYPE x [' \
		"<!DOCTYPE x 'y"; do
		{
			printf '%s' "$opening"
			times 20000000 'x      '
		} >in.gml
		refused 300 'a tag or comment is longer than 67108864 bytes (--max-tag)'
	done
}

long_text_is_read() {
	times 30000000 x | around \
		'<cityObjectMember><bldg:Building><gml:name><![CDATA[' \
		']]></gml:name></bldg:Building></cityObjectMember>' >in.gml
	accepted 400
	is "$(tcs2json out.tcs | jq 'select(.record == "object").features[0].name | length')" \
		30000000
}

long_position_lists_are_read() {
	awk 'BEGIN {
		for (i = 0; i < 1600000; i++)
			printf "%.6f %.6f 100.000000\n",
				4e5 + 1000 * cos(i / 254647.9),
				5e6 + 1000 * sin(i / 254647.9)
	}' | around "$surface_begin" "$surface_end" >in.gml
	(($(wc -c <in.gml) > 50000000))
	accepted 1000
	is "$(tcs2json out.tcs | jq 'select(.record == "object").geometries[0].polygons[0].vertices | length')" \
		1600000
	rm out.tcs
	refused 64 'a feature is longer than 10485760 bytes (--max-feature)' \
		--max-feature 10M
}

attributes_and_names_are_bounded() {
	numbered 1000000 ' a%d=""' | around '<cityObjectMember' '/>' >in.gml
	refused 64 'an element has more than 2000 attributes'
	numbered 1000000 ' xmlns:a%d="b%d"' | around '<cityObjectMember' '/>' \
		>in.gml
	refused 64 'an element has more than 2000 attributes'
	{
		numbered 3000 '<a xmlns:a%d="b%d">'
		numbered 3000 '</a>'
	} | around '<cityObjectMember><bldg:Building>' \
		'</bldg:Building></cityObjectMember>' >in.gml
	refused 64 'more than 2000 namespaces are in force' --max-depth 4000
	numbered 1000000 '<a%d b%d=""/>' | around '' '' >in.gml
	refused 64 'there are more than 50000 different names'
	# Commented out, they are none.
	numbered 100000 ' a%d=""' | around '<!--' '-->' >in.gml
	accepted 64
}

compressed_bombs_are_bounded() {
	model "" | head -n -1 >begin.gml
	yes "$(building a '')" | head -c 100000000 | cat begin.gml - | gzip -1 >in.gml
	refused 64 'more than 50000000 bytes' --max-bytes 50000000
	head -c 100000000 /dev/zero | tr '\0' ' ' | gzip >in.gml
	refused 200 'line 1: '
}

many_small_features_take_little_memory() {
	[[ $sanitized ]] && return
	{
		model '' | head -n -1
		yes "$(building a "<bldg:lod1MultiSurface>$(surfaces \
			"$(polygon p "$square")")</bldg:lod1MultiSurface>")" |
			head -n 200000
		echo '</CityModel>'
	} >in.gml
	python3 - citygml2tcs -q -j 1 in.gml out.tcs >peak <<-'PYTHON'
		import resource, subprocess, sys
		subprocess.check_call(sys.argv[1:])
		print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss)
	PYTHON
	(($(cat peak) < 64 * 1024))
}

# ---- damage ------------------------------------------------------------

every_cut_is_noticed() {
	local size step cut
	size=$(wc -c <"$town")
	step=$((size / 60))
	for ((cut = 1; cut < size - 12; cut += step)); do
		head -c "$cut" "$town" >in.gml
		refused 256 ': '
	done
	gzip -c "$town" >whole.gz
	size=$(wc -c <whole.gz)
	for ((cut = 3; cut < size; cut += size / 20)); do
		head -c "$cut" whole.gz >in.gml
		refused 512 ': '
	done
}

# Behind the last '>' nothing is missing.
every_byte_of_a_small_file_counts() {
	local size cut
	model "<app:appearanceMember><app:Appearance><app:surfaceDataMember>
<app:X3DMaterial><app:target>#p</app:target></app:X3DMaterial>
</app:surfaceDataMember></app:Appearance></app:appearanceMember>
$(building a "<gml:name>&#65;</gml:name><bldg:lod1MultiSurface>$(
		surfaces "$(polygon p '0 0 0 4 0 0 4 4 0 0 0 0')")</bldg:lod1MultiSurface>")" \
		>whole.gml
	size=$(wc -c <whole.gml)
	for ((cut = 0; cut < size - 1; cut++)); do
		head -c "$cut" whole.gml >in.gml
		refused 64 ': '
	done
	cp whole.gml in.gml
	accepted 64
}

# Either way it ends as it should; what comes out is sound.
flipped_bytes_end_well() {
	local round ended=0
	for ((round = 0; round < 50; round++)); do
		python3 - "$round" "$town" >in.gml <<-'PYTHON'
			import random, sys
			random.seed(int(sys.argv[1]))
			data = bytearray(open(sys.argv[2], "rb").read())
			for _ in range(random.choice((1, 1, 20))):
			    data[random.randrange(len(data))] = random.choice(
			        (0, 9, 32, 34, 45, 48, 60, 62, 101, 128, 255))
			sys.stdout.buffer.write(data)
		PYTHON
		ended=0
		bounded 512 citygml2tcs -j 1 in.gml out.tcs 2>err || ended=$?
		if ((ended)); then
			is "$ended" 1
			is "$(wc -l <err)" 1
			[[ ! -e out.tcs ]]
		else
			tcs2json out.tcs >/dev/null
			rm out.tcs
		fi
	done
}

wrong_encodings_are_named() {
	local name=$'Stra\xdfe'
	model "$(building a "<gml:name>$name</gml:name>")" >in.gml
	refused 64 'not proper UTF-8'
	{
		echo '<?xml version="1.0" encoding="EBCDIC-XY"?>'
		model ''
	} >in.gml
	refused 64 'encoding'
	{
		echo '<?xml version="1.0" encoding="UTF-16"?>'
		model ''
	} | iconv -f utf-8 -t utf-16le | head -c 301 >in.gml
	refused 64 'line '
	model "$(building a '<gml:name>a@b</gml:name>')" | tr @ '\0' >in.gml
	refused 64 'line 7: '
	model "$(building a '<gml:name>a@b</gml:name>')" | tr @ '\1' >in.gml
	refused 64 'Char value 1'
	model "$(building a '<gml:name>&#0;</gml:name>')" >in.gml
	refused 64 'value 0'
	model "$(building a '<gml:name>&#xD800;</gml:name>')" >in.gml
	refused 64 'value 55296'
	head -c 100000 /dev/urandom >in.gml
	refused 64 'line 1: '
	head -c 100000 /dev/zero >in.gml
	refused 64 'line 1: '
}

# A message stays one line, and a terminal is told nothing by it.
controls_in_ids_do_no_harm() {
	model "$(building 'a&#10;b&#9;&#x9b;31m' "<bldg:lod1MultiSurface>$(
		surfaces "$(polygon 'x&#10;y&#x9b;2J' '0 0 0 1 0 0 0 0 0')"
	)</bldg:lod1MultiSurface>")" >in.gml
	accepted 64
	is "$(wc -l <err)" 1
	[[ $(cat err) != *[$'\t\e']* && $(cat err) != *$'\xc2\x9b'* ]]
	is "$(tcs2json out.tcs | jq -c 'select(.record == "object").features[0].id |
		explode')" '[97,10,98,9,155,51,49,109]'
}

# ---- references --------------------------------------------------------

links_in_circles_end() {
	model "$(building a "<bldg:lod1MultiSurface><gml:MultiSurface gml:id='m'>
<gml:surfaceMember xlink:href='#m'/><gml:surfaceMember><gml:CompositeSurface gml:id='n'>
<gml:surfaceMember xlink:href='#m'/></gml:CompositeSurface></gml:surfaceMember>
<gml:surfaceMember>$(polygon p "$square")</gml:surfaceMember></gml:MultiSurface></bldg:lod1MultiSurface>")
$(building b "<bldg:lod1MultiSurface xlink:href='#c1'/>")
$(building c "<bldg:lod1MultiSurface><gml:MultiSurface gml:id='c1'><gml:surfaceMember xlink:href='#d1'/></gml:MultiSurface></bldg:lod1MultiSurface>")
$(building d "<bldg:lod1MultiSurface><gml:MultiSurface gml:id='d1'><gml:surfaceMember xlink:href='#c1'/></gml:MultiSurface></bldg:lod1MultiSurface>")" >in.gml
	accepted 64
	grep -q 'skipped' err
	is "$(tcs2json out.tcs | jq -s '[.[] | select(.record == "object")] | length')" 4
}

# Ten links each, ten levels: ten thousand million polygons if followed.
links_that_multiply_end() {
	local level
	{
		echo "<bldg:lod1MultiSurface>$(surfaces "<gml:CompositeSurface gml:id='s0'><gml:surfaceMember>$(polygon p "$square")</gml:surfaceMember></gml:CompositeSurface>")</bldg:lod1MultiSurface>"
		for level in {1..10}; do
			echo "<bldg:lod1MultiSurface><gml:MultiSurface gml:id='s$level'>$(
				times 10 "<gml:surfaceMember xlink:href='#s$((level - 1))'/>"
			)</gml:MultiSurface></bldg:lod1MultiSurface>"
		done
	} | around '<cityObjectMember><bldg:Building gml:id="a">' \
		'</bldg:Building></cityObjectMember>' >in.gml
	accepted 128
	grep -q 'skipped' err
}

dangling_and_double_ids_are_named() {
	model "$(building a "<bldg:lod1MultiSurface><gml:MultiSurface>
<gml:surfaceMember xlink:href='#nowhere'/><gml:surfaceMember xlink:href=''/>
<gml:surfaceMember xlink:href='#'/></gml:MultiSurface></bldg:lod1MultiSurface>")
$(building a "<bldg:lod1MultiSurface>$(surfaces "$(polygon p "$square")" \
		"$(polygon p "$square")")</bldg:lod1MultiSurface>")" >in.gml
	accepted 64
	grep -q 'nothing in the document has this id.*nowhere' err
	is "$(tcs2json out.tcs | jq -s '[.[] | select(.record == "object")] | length')" 2
	rm out.tcs
	refused 64 'nowhere' --strict -q
}

# ---- coordinates -------------------------------------------------------

# ring_ends REASON POSLIST: the polygon is skipped for this reason.
ring_is_skipped() {
	around "$surface_begin" "$surface_end" <<<"$2" >in.gml
	accepted 64
	grep -q "1 polygon skipped: .*$1" err || {
		cat err
		return 1
	}
	is "$(tcs2json out.tcs | jq -c 'select(.record == "object").geometries[0].polygons')" null
	rm out.tcs
	refused 64 "$1" --strict -q
}

# ring_is_read POINTS TRIANGLES POSLIST
ring_is_read() {
	around "$surface_begin" "$surface_end" <<<"$3" >in.gml
	accepted 64
	is "$(tcs2json out.tcs | jq -c 'select(.record == "object").geometries[0] |
		[(.polygons[0].vertices | length), (.polygons[0].triangles | length)]')" \
		"[$1,$2]"
	rm out.tcs
}

numbers_that_are_none_are_skipped() {
	ring_is_skipped 'finite' '0 0 0 NaN 0 0 4 4 0 0 0 0'
	ring_is_skipped 'finite' '0 0 0 INF 0 0 4 4 0 0 0 0'
	ring_is_skipped 'finite' '0 0 0 1e400 0 0 4 4 0 0 0 0'
	ring_is_skipped '' '0 0 0 4 0 0 4 4 zero 0 0 0'
	ring_is_skipped '' '0x10 0 0 4 0 0 4 4 0 0 0 0'
	ring_is_skipped '' '0 0 0 4 0 0 4 4'
	ring_is_skipped '' ''
}

# implicit MATRIX POSITION: a template put there.
implicit() {
	printf '<ImplicitGeometry><transformationMatrix>%s</transformationMatrix><relativeGMLGeometry>%s</relativeGMLGeometry><referencePoint><gml:Point><gml:pos>%s</gml:pos></gml:Point></referencePoint></ImplicitGeometry>' \
		"$1" "$(surfaces "$(polygon p "$square")")" "$2"
}

# Wherever a number may stand, the stream has finite ones only.
numbers_elsewhere_are_none_or_finite() {
	local number texture
	for number in NaN INF -INF 1e400 -1e400 0x1p3 1e99999999999 '' zero; do
		texture="<app:appearanceMember><app:Appearance><app:surfaceDataMember>
<app:ParameterizedTexture><app:imageURI>a.png</app:imageURI><app:borderColor>$number 0 0 1</app:borderColor>
<app:target uri='#q'><app:TexCoordGen><app:worldToTexture>$number 0 0 0 0 1 0 0 0 0 0 1</app:worldToTexture></app:TexCoordGen></app:target>
</app:ParameterizedTexture></app:surfaceDataMember><app:surfaceDataMember>
<app:X3DMaterial><app:shininess>$number</app:shininess><app:diffuseColor>$number 0 0</app:diffuseColor><app:target>#q</app:target></app:X3DMaterial>
</app:surfaceDataMember><app:surfaceDataMember>
<app:GeoreferencedTexture><app:imageURI>a.png</app:imageURI><app:referencePoint><gml:Point><gml:pos>0 $number</gml:pos></gml:Point></app:referencePoint>
<app:orientation>1 0 0 $number</app:orientation><app:target>#q</app:target></app:GeoreferencedTexture>
</app:surfaceDataMember></app:Appearance></app:appearanceMember>"
		model "<gml:boundedBy><gml:Envelope><gml:lowerCorner>$number 0 0</gml:lowerCorner>
<gml:upperCorner>0 $number 0</gml:upperCorner></gml:Envelope></gml:boundedBy>$texture
$(building a "<bldg:measuredHeight uom='m'>$number</bldg:measuredHeight>
<gen:doubleAttribute name='d'><gen:value>$number</gen:value></gen:doubleAttribute>
<bldg:lod1MultiSurface>$(surfaces "$(polygon q "$square")")</bldg:lod1MultiSurface>
<bldg:outerBuildingInstallation><bldg:BuildingInstallation><bldg:lod2ImplicitRepresentation>$(
			implicit "$number 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1" "0 0 0")</bldg:lod2ImplicitRepresentation>
</bldg:BuildingInstallation></bldg:outerBuildingInstallation>
<bldg:outerBuildingInstallation><bldg:BuildingInstallation><bldg:lod2ImplicitRepresentation>$(
			implicit "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1" "0 $number 0")</bldg:lod2ImplicitRepresentation>
</bldg:BuildingInstallation></bldg:outerBuildingInstallation>")" >in.gml
		accepted 64
		# A reader checks that all of it is finite.
		tcs2json out.tcs >out.json
		rm out.tcs
	done
}

# What a file says of its own size is not believed.
claims_are_not_believed() {
	around "${surface_begin/<gml:posList>/<gml:posList count=\"4000000000\" srsDimension=\"4000000000\">}" \
		"$surface_end" <<<'0 0 0 4 0 0 4 4 0 0 0 0' >in.gml
	accepted 64
	is "$(tcs2json out.tcs | jq -c 'select(.record == "object").geometries[0].polygons[0].vertices | length')" 3
}

# Ten thousand themes that show the same, and links to what is not there.
appearances_do_not_multiply() {
	{
		echo "<app:appearanceMember><app:Appearance><app:theme>t</app:theme><app:surfaceDataMember>
<app:X3DMaterial gml:id='m'><app:target>#p</app:target></app:X3DMaterial></app:surfaceDataMember></app:Appearance></app:appearanceMember>"
		numbered 10000 "<app:appearanceMember><app:Appearance><app:theme>t%d</app:theme><app:surfaceDataMember xlink:href='#m'/></app:Appearance></app:appearanceMember><!--%d-->"
		numbered 10000 "<app:appearanceMember><app:Appearance><app:surfaceDataMember xlink:href='#x%d%d'/></app:Appearance></app:appearanceMember>"
		building a "<bldg:lod1MultiSurface>$(surfaces "$(polygon p "$square")")</bldg:lod1MultiSurface>"
	} | around '' '' >in.gml
	accepted 64
	grep -q '9936 appearances skipped: more than 64 themes' err
	grep -q '10000 appearances skipped: no global material' err
	is "$(tcs2json out.tcs | jq 'select(.record == "object").paints | length')" 65
}

rings_of_every_kind_end_well() {
	ring_is_skipped '' '0 0 0 0 0 0 0 0 0 0 0 0'
	ring_is_skipped '' '0 0 0 4 0 0 8 0 0 0 0 0'
	ring_is_skipped '' '0 0 0 4 0 0'
	ring_is_read 4 2 '0 0 0 4 0 0 4 4 0 0 4 0'
	around "$surface_begin" "$surface_end" \
		<<<'0 0 0 4 4 0 4 0 0 0 4 0 0 0 0' >in.gml
	accepted 64
	grep -q repaired err
	rm out.tcs
	ring_is_read 4 2 '0 0 0 4 0 0 4 4 3 0 4 0 0 0 0'
	ring_is_read 3 1 '0 0 0 1e-9 0 0 0 1e-9 0 0 0 0'
	ring_is_skipped 'too far apart' '0 0 0 1e300 0 0 0 1e300 0 0 0 0'
	ring_is_skipped 'no area' '0 0 0 1e-300 0 0 0 1e-300 0 0 0 0'
}

for test in entities_are_refused attribute_defaults_are_refused \
	a_document_type_is_not_fetched what_stands_elsewhere_does_not_come_in \
	images_and_links_are_not_opened \
	nesting_is_bounded long_attributes_are_read \
	markup_without_end_is_bounded long_text_is_read \
	long_position_lists_are_read attributes_and_names_are_bounded \
	compressed_bombs_are_bounded many_small_features_take_little_memory \
	every_cut_is_noticed every_byte_of_a_small_file_counts flipped_bytes_end_well wrong_encodings_are_named \
	controls_in_ids_do_no_harm links_in_circles_end links_that_multiply_end \
	dangling_and_double_ids_are_named numbers_that_are_none_are_skipped \
	numbers_elsewhere_are_none_or_finite claims_are_not_believed \
	appearances_do_not_multiply \
	rings_of_every_kind_end_well; do
	run_test $test
done
finish
