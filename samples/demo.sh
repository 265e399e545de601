#!/bin/sh
# samples/demo.sh: a CityGML town becomes a GLB. `make demo` runs it once all is
# built; BUILD names the build folder.
set -eu

root=$(cd "$(dirname "$0")/.." && pwd)
town=$root/samples/town-2.0.gml
glb=$BUILD/demo/town.glb
stats=$BUILD/demo/town.json
PATH=$BUILD/bin:$PATH

bytes_of() {
	wc -c <"$1" | tr -d ' '
}

# A path as one types it from the project's folder.
short() {
	echo "${1#"$root"/}"
}

mkdir -p "$BUILD/demo"
echo
echo "\$ tessera --dry-run $(short "$town") -o $(short "$glb")"
(cd "$root" && tessera --dry-run "$(short "$town")" -o "$(short "$glb")")
tessera "$town" -o "$glb" --stats "$stats"
echo
echo "$(short "$town"): $(bytes_of "$town") bytes of CityGML"
echo "$(short "$glb"): $(bytes_of "$glb") bytes of glTF"
echo "$(short "$stats"): what was read, written, left out"
echo
echo "To look at it, open the GLB in a glTF viewer: Blender (import glTF),"
echo "CesiumJS, three.js, Windows 3D Viewer. Every node is a city object under"
echo "its gml:id; every face knows its surface's id, class and attributes"
echo "(EXT_mesh_features and EXT_structural_metadata)."
echo
echo "Any joint of the pipe is readable:"
echo "  $(short "$BUILD")/bin/citygml2tcs $(short "$town") |"
echo "    $(short "$BUILD")/bin/tcs2json | head -c 2000"
