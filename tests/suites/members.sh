#!/bin/bash
# Members read by several threads, out of order, beside the same document read
# by one parser from its first byte to its last: one whose encoding has to be
# converted is, even if it holds nothing but ASCII.

# shellcheck source=tests/check.sh
. "$(dirname "$0")/../check.sh"

if ! [[ -x $BUILD/bin/citygml2tcs ]]; then
	skip "all of it" "citygml2tcs is not built"
	finish
fi

# plain_town VERSION: the sample town in ASCII.
plain_town() {
	LC_ALL=C tr -d '\200-\377' <"$SAMPLES/town-$1.gml"
}

# libxml2 names a fault by how it came by the bytes.
without_names() {
	sed 's/\(not well-formed XML\).*/\1/' "$1"
}

# same_alone: doc.gml gives the same output, messages and status read alone, and
# for any number of jobs.
same_alone() {
	local jobs status=0 first=
	sed '1s/UTF-8/ISO-8859-1/' doc.gml >latin.gml
	status_is 1 cmp -s doc.gml latin.gml
	citygml2tcs -v -j 1 --stats alone.json <latin.gml \
		>alone.tcs 2>alone.err || status=$?
	for jobs in 1 2 5; do
		status_is "$status" citygml2tcs -v -j "$jobs" \
			--stats some.json <doc.gml >some.tcs 2>some.err
		diff some.err "${first:-some.err}"
		cp some.err first.err
		first=first.err
		diff <(without_names alone.err) <(without_names some.err)
		((status)) || cmp alone.tcs some.tcs
		((status)) || cmp alone.json some.json
	done
}

the_town_is_the_same() {
	plain_town "$1" >doc.gml
	same_alone
	[[ -s alone.tcs ]]
}

# Behind every third member something that a cut at end tags stumbles over.
odd_things() {
	awk '{ print }
	/<\/core:cityObjectMember>/ && ++members % 3 == 0 {
		kind = members / 3 % 8
		if (kind == 0)
			print "<!-- </core:cityObjectMember> <core:cityObjectMember> -->"
		if (kind == 1)
			print "<core:cityObjectMember><gen:GenericCityObject " \
				"gml:id=\"g" members "\"><gml:name><![CDATA[" \
				"</core:cityObjectMember>]]></gml:name>" \
				"</gen:GenericCityObject></core:cityObjectMember>"
		if (kind == 2)
			print "<core:cityObjectMember xmlns:xlink=\"http://www" \
				".w3.org/1999/xlink\" xlink:href=\"other.gml#x\"/>"
		if (kind == 3)
			print "<gml:featureMember><gen:GenericCityObject/>" \
				"<gen:GenericCityObject gml:id=\"h" members "\"/>" \
				"</gml:featureMember>"
		if (kind == 4)
			print "<core:cityObjectMember></core:cityObjectMember >"
		if (kind == 5)
			print "<core:cityObjectMember><gen:GenericCityObject>" \
				"<gml:boundedBy><gml:Envelope srsName=\"EPSG:" \
				"31467\"><gml:lowerCorner>5400000 3500000 0" \
				"</gml:lowerCorner></gml:Envelope></gml:boundedBy>" \
				"<gen:lod1Geometry><gml:Polygon><gml:exterior>" \
				"<gml:LinearRing><gml:posList>5400000 3500000 0 " \
				"5400009 3500000 0 5400009 3500009 0 5400000 " \
				"3500000 0</gml:posList></gml:LinearRing>" \
				"</gml:exterior></gml:Polygon></gen:lod1Geometry>" \
				"</gen:GenericCityObject></core:cityObjectMember>"
		if (kind == 6)
			print "<?note </core:cityObjectMember>?> text "
		if (kind == 7)
			print "<core:cityObjectMember><gen:GenericCityObject>" \
				"<gen:lod1Geometry><core:cityObjectMember>" \
				"</core:cityObjectMember></gen:lod1Geometry>" \
				"</gen:GenericCityObject></core:cityObjectMember>"
	}'
}

odd_members_are_the_same() {
	plain_town 2.0 | odd_things >doc.gml
	same_alone
	is "$(tcs2json some.tcs | grep -c '"g[0-9]*"' || :)" \
		"$(grep -c 'gml:id="g[0-9]*"' doc.gml)"
}

# The bounds of the model tell what coordinates are from there on.
late_bounds_are_the_same() {
	plain_town 2.0 | awk '{ print }
		/<\/core:cityObjectMember>/ && ++members == 20 {
			print "<gml:boundedBy><gml:Envelope " \
				"srsName=\"EPSG:31467\"/></gml:boundedBy>"
		}' >doc.gml
	same_alone
}

# Whatever is not well-formed, the message is that of one parser.
faults_are_the_same() {
	local lines at
	lines=$(plain_town 2.0 | wc -l)
	for at in 30 150 $((lines / 2)) $((lines - 40)); do
		plain_town 2.0 | sed "${at}s|<|</|" >doc.gml
		same_alone
		grep -q 'not well-formed' alone.err
		plain_town 2.0 | sed "${at}s|>| & |" >doc.gml
		same_alone
		plain_town 2.0 | head -n "$at" >doc.gml
		same_alone
		grep -q 'not well-formed' alone.err
	done
}

limits_are_the_same() {
	plain_town 2.0 >doc.gml
	for limit in --max-depth=9 --max-bytes=900000; do
		for jobs in 1 4; do
			status_is 1 citygml2tcs -j "$jobs" "$limit" doc.gml \
				>/dev/null 2>"err$jobs"
		done
		diff err1 err4
		[[ -s err1 ]]
	done
}

run_test the_town_is_the_same 1.0
run_test the_town_is_the_same 2.0
run_test the_town_is_the_same 3.0
run_test odd_members_are_the_same
run_test late_bounds_are_the_same
run_test faults_are_the_same
run_test limits_are_the_same
finish
