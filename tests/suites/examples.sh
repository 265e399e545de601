#!/bin/bash
# The EXAMPLES of every man page run as they stand there, one after the other
# in a folder that has the files they name.

# shellcheck source=tests/check.sh
. "$(dirname "$0")/../check.sh"

# examples_of PAGE: each command with a NUL behind it, without its prompt.
examples_of() {
	awk '/^\.Sh/ { inside = $2 == "EXAMPLES"; next }
		!inside { next }
		/^\.Dl / {
			sub(/^\.Dl (\$ )?/, "")
			printf "%s%c", $0, 0
		}
		/^\.Bd/ { block = ""; within = 1; next }
		/^\.Ed/ { printf "%s%c", block, 0; within = 0; next }
		within { block = block $0 "\n" }' "$1" |
		sed 's/\\(aq/'\''/g; s/\\(dq/"/g; s/\\e/\\/g; s/\\-/-/g'
}

files_of_the_examples() {
	local name
	mkdir data
	for name in town city trees data/city; do
		cp "$SAMPLES/town-2.0.gml" "$name.gml"
	done
	gzip -k town.gml city.gml
	cp "$SAMPLES/house-IFC4.ifc" house.ifc
	citygml2tcs -q town.gml town.tcs
	cp town.tcs city.tcs
	ifc2tcs -q house.ifc house.tcs
	printf '#!/bin/sh\nexec tcs-simplify -q --rate 0.9\n' >some-filter
	chmod +x some-filter
}

examples_run() {
	local example number=0
	files_of_the_examples
	while read -r -d '' example; do
		echo "$example"
		PATH=$PATH:. bash -euo pipefail -c "$example" >out </dev/null
		number=$((number + 1))
	done < <(examples_of "$1")
	((number > 0))
}

for page in "$ROOT"/*.1 "$ROOT"/*/*.1; do
	program=$(basename "$page" .1)
	if [[ -x $BUILD/bin/$program ]]; then
		run_test examples_run "$page"
	else
		skip "$program" "it is not built"
	fi
done
finish
