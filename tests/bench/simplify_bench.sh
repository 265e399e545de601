#!/bin/bash
# What simplifying by a half costs on one core, in seconds of CPU time, every
# building an object of its own and simplified by itself: the whole of
# tcs-simplify, from stream to stream; the same without reading and writing the
# stream (simplify_bare); and what libraries take from a mesh of welded
# components to one of fewer triangles (BENCH=lod and BENCH=simplify build
# them). The second is what to compare these with, though it also finds the
# components and what they touch, and gives every triangle its surface and
# polygon. Then objects of more and more triangles, with the bytes of memory
# that each triangle of the object takes at the peak, the stream's own included.
# The least of some runs in turn.
#
#     ROUNDS=5  BUILDINGS=40  SIZES="24 250"  PEERS="..."  FILES="a.ifc ..."
set -eu

rounds=${ROUNDS:-5}
buildings=${BUILDINGS:-40}
sizes=${SIZES:-24 250}
peers=${PEERS:-meshoptimizer openmesh cgal qem}
data=$ROOT/../shared/data/ifc
files=${FILES:-$data/xbim-essentials/House.ifc $data/web-ifc/AC20-FZK-Haus.ifc}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

cat >"$folder/measure.py" <<'PYTHON'
import json, os, subprocess, sys

stream, rounds = sys.argv[1], int(sys.argv[2])
peers, folder = sys.argv[3:], os.path.dirname(sys.argv[0])
best, peak, count = {}, 0, 0

def ours():
    global peak, count
    child = subprocess.Popen(["tcs-simplify", "-q", "-j", "1", "--rate", "0.5",
        "--stats", folder + "/stats", stream, folder + "/out"])
    _, status, used = os.wait4(child.pid, 0)
    if status:
        sys.exit("tcs-simplify failed")
    peak = used.ru_maxrss * 1024
    with open(folder + "/stats") as stats:
        count = json.load(stats)["counts"]["triangles before"]
    return used.ru_utime + used.ru_stime

def alone():
    with open(stream, "rb") as source:
        return float(subprocess.run([os.environ["BUILD"] +
            "/tests/bench/simplify_bare", "0.5"], stdin=source,
            stdout=subprocess.PIPE, check=True).stdout)

def other(name):
    with open(stream, "rb") as source, open(os.devnull, "w") as sink:
        return float(subprocess.run([os.environ["BUILD"] +
            "/tests/bench/lod_peer", "--peer", name, "--rate", "0.5",
            "--seconds"], stdin=source, stdout=sink, stderr=subprocess.PIPE,
            check=True).stderr)

whole, bare = "tcs-simplify", "without stream"
for _ in range(rounds):
    for name in [whole, bare] + peers:
        taken = (ours() if name == whole else alone() if name == bare
            else other(name))
        best[name] = min(taken, best.get(name, taken))
for name, seconds in best.items():
    line = "  %-14s %8.3f s %7.2f Mtri/s" % (name, seconds,
        count / seconds / 1e6)
    if name in peers:
        line += "   takes %5.2f x, without stream %5.2f x ours" % (
            seconds / best[whole], seconds / best[bare])
    elif name == whole:
        line += "   %d triangles, %.2f us each; peak %.0f bytes each" % (
            count, 1e6 * seconds / count, peak / count)
    print(line)
PYTHON

[[ -x $BUILD/tests/bench/lod_peer ]] || peers=
measure() {
	python3 "$folder/measure.py" "$@"
}

echo "$buildings generated buildings, one by one"
"$BUILD/samples/makeblock" --buildings "$buildings" |
	citygml2tcs -q - "$folder/in"
# shellcheck disable=SC2086
measure "$folder/in" "$rounds" $peers
for file in $files; do
	[[ -e $file ]] || continue
	echo "${file##*/}"
	ifc2tcs -q "$file" "$folder/in" 2>"$folder/log"
	# shellcheck disable=SC2086
	measure "$folder/in" "$rounds" $peers
done
for size in $sizes; do
	echo "$size generated buildings as one object"
	"$BUILD/samples/makeblock" --together --buildings "$size" |
		citygml2tcs -q - "$folder/in"
	measure "$folder/in" 2
done
