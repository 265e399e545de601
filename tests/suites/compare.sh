#!/bin/bash
# The report of tcs-compare as a page, in a browser without a network.

# shellcheck source=tests/check.sh
. "$(dirname "$0")/../check.sh"

node=$ROOT/tests/node

# page [OPTION...]: three buildings and three others of the same ids.
page() {
	"$BUILD/samples/makeblock" --buildings 3 | citygml2tcs -q - a.tcs
	"$BUILD/samples/makeblock" --buildings 3 --seed 1 |
		citygml2tcs -q - b.tcs
	tcs-compare -q --html "$@" a.tcs b.tcs -o report.html
}

a_browser_shows_the_report_and_asks_for_nothing() {
	page
	node "$node/report.mjs" report.html report.png 9
	cp report.png "$BUILD/report.png"
}

# A page that asks for something must be caught.
a_page_that_loads_something_is_refused() {
	page
	sed -i 's|<header>|<header><img src="elsewhere.png">|' report.html
	status_is 1 node "$node/report.mjs" report.html report.png 9
}

the_page_is_the_same_for_any_number_of_jobs() {
	page -j1
	mv report.html one.html
	page -j2
	cmp one.html report.html
}

what_an_id_holds_stays_text() {
	json2tcs - a.tcs <<-'END'
		{"record":"head","crs":{"kind":"projected","metres_per_unit":1,"metres_per_unit_up":1}}
		{"record":"object","features":[{"class":"Building","id":"<b>&x"}],"geometries":[{"feature":0,"lod":2,"kind":"multi-surface","flags":["simplified"],"polygons":[{"surface":0,"vertices":[[0,0,0],[9,0,0],[0,9,9]],"triangles":[[0,1,2]]}]}]}
		{"record":"end"}
	END
	tcs2json a.tcs | sed 's/\[9,0,0\]/[8,0,0]/' | json2tcs - b.tcs
	tcs-compare -q --html a.tcs b.tcs -o report.html
	grep -q '<td>&lt;b>&amp;x<td>' report.html
	grep -q '<h3>&lt;b>&amp;x</h3>' report.html
	is "$(grep -c '<img ' report.html)" 3
}

what_is_the_same_is_not_drawn() {
	citygml2tcs -q "$SAMPLES/town-2.0.gml" town.tcs
	tcs-compare -q --html town.tcs town.tcs -o report.html
	is "$(grep -c '<img ' report.html)" 0
	grep -q '<td>B7<' report.html
}

run_test the_page_is_the_same_for_any_number_of_jobs
run_test what_an_id_holds_stays_text
run_test what_is_the_same_is_not_drawn
if [[ -x ${CHROMIUM:=/usr/bin/chromium} ]]; then
	export CHROMIUM
	run_test a_browser_shows_the_report_and_asks_for_nothing
	run_test a_page_that_loads_something_is_refused
else
	skip a_browser_shows_the_report 'no Chromium'
fi
finish
