#!/bin/bash
# What reading IFC costs: ifc2tcs beside web-ifc (tests/node), both parsing and
# tessellating all products on one thread, in megabytes of STEP text per second
# of CPU time, medians; their start-up, and our dynamic linker's, left out.
# Over the files of 100 kB and more of ../shared/data/ifc, and those of some
# size repeated with ids of their own; of these, as whole processes, also peak
# memory, the STEP reader alone, and two threads: wall time, and the CPU time of
# the thread that works the longest, which other load does not change.
#
#     MEGABYTES=200 ROUNDS=3 FILE=house.ifc    what is read, and how often
set -eu

megabytes=${MEGABYTES:-200}
rounds=${ROUNDS:-3}
data=$ROOT/../shared/data/ifc
large=(
	web-ifc/duplex.ifc
	web-ifc/AC20-FZK-Haus.ifc
	bsi-community/unzipped/002.ifc
)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# beside FILE...: a row each, and one of all that both read.
beside() {
	"$BUILD/tests/bench/ifc_bare" "$rounds" "$@" >"$folder/ours"
	node "$ROOT/tests/node/web_ifc.mjs" "$rounds" "$@" >"$folder/theirs"
	printf '%s\n' "$@" | paste "$folder/ours" "$folder/theirs" - |
		python3 -c '
import os, sys
row = "%-40.40s %7s %9s %9s %7s %9s %9s"
print(row % ("", "MB", "ifc2tcs", "web-ifc", "times", "triangles", "web-ifc"))
size = ours = theirs = 0
for line in sys.stdin:
    mine, other, name = line.rstrip("\n").split("\t")
    (a, na), (b, nb) = mine.split(), other.split()
    mb = os.path.getsize(name) / 1e6
    name = os.path.basename(name)
    if "failed" in (a, b):
        print(row % (name, "%.2f" % mb, a[:6], b[:6], "", na, nb))
        continue
    a, b = float(a), float(b)
    size, ours, theirs = size + mb, ours + a, theirs + b
    print(row % (name, "%.2f" % mb, "%.1f" % (mb / a), "%.1f" % (mb / b),
                 "%.1f" % (b / a), na, nb))
print(row % ("all", "%.2f" % size, "%.1f" % (size / ours),
             "%.1f" % (size / theirs), "%.1f" % (theirs / ours), "", ""))
print("  as fast as web-ifc: %.1f times (wanted: 3; goal: 10)"
      % (theirs / ours))'
}

# measure JOBS FILE: "CPU WALL LONGEST PEAK" of ifc2tcs, in seconds and
# megabytes; the median of each. What a thread used is looked at while it runs.
measure() {
	python3 - "$rounds" "$@" <<-'PYTHON'
		import os, statistics, subprocess, sys, time

		def threads(process):
		    used = {}
		    try:
		        for thread in os.listdir("/proc/%d/task" % process):
		            with open("/proc/%d/task/%s/schedstat"
		                      % (process, thread)) as file:
		                used[thread] = int(file.read().split()[0]) / 1e9
		    except OSError:
		        pass
		    return used

		runs = []
		for _ in range(int(sys.argv[1])):
		    began, seen = time.monotonic(), {}
		    child = subprocess.Popen(["ifc2tcs", "-q", "-j", *sys.argv[2:]],
		        stdout=subprocess.DEVNULL)
		    done = 0
		    while not done:
		        seen.update(threads(child.pid))
		        time.sleep(0.002)
		        done, status, used = os.wait4(child.pid, os.WNOHANG)
		    if status:
		        sys.exit("failed: " + sys.argv[3])
		    runs.append((used.ru_utime + used.ru_stime,
		        time.monotonic() - began, max(seen.values()),
		        used.ru_maxrss / 1024))
		print(*("%.3f" % statistics.median(column) for column in zip(*runs)))
	PYTHON
}

# ratio A B
ratio() {
	awk -v a="$1" -v b="$2" 'BEGIN { printf "%.2f", a / b }'
}

# bench_large NAME FILE
bench_large() {
	local one wall path peak two wall2 path2 peak2 size
	size=$(awk -v n="$(wc -c <"$2")" 'BEGIN { print n / 1e6 }')
	printf '%s, %.0f MB\n  %-14s %8s %8s %15s %8s\n' "$1" "$size" '' \
		'CPU s' 'wall s' 'longest thread' 'peak MB'
	read -r one wall path peak < <(measure 1 "$2")
	printf '  %-14s %8.2f %8.2f %15.2f %8.0f\n' 'ifc2tcs -j 1' \
		"$one" "$wall" "$path" "$peak"
	read -r two wall2 path2 peak2 < <(measure 2 "$2")
	printf '  %-14s %8.2f %8.2f %15.2f %8.0f\n' 'ifc2tcs -j 2' \
		"$two" "$wall2" "$path2" "$peak2"
	echo "  -j 2 is faster than -j 1, wall: $(ratio "$wall" "$wall2")," \
		"longest thread: $(ratio "$path" "$path2") (wanted: 1.6)"
	echo "  peak memory to the file: $(ratio "$peak" "$size") (wanted: 4)"
	"$BUILD/tests/bench/step_bench" "$2" | awk '
		/total/ { print "  STEP reader: index", $3, "MB/s (wanted: 300)," \
			" every parameter", $4, "MB/s" }'
}

if [[ ${FILE:-} ]]; then
	beside "$FILE"
	bench_large "${FILE##*/}" "$FILE"
	exit
fi
[[ -d $data ]] || {
	echo 'no ../shared/data/ifc: FILE=house.ifc names what to read'
	exit
}
mapfile -t files < <(find "$data" -name '*.ifc' -size +99k | sort)
beside "${files[@]}"
for name in "${large[@]}"; do
	"$ROOT/tests/bench/replicate_step.py" "$data/$name" "$megabytes" \
		>"$folder/file.ifc"
	bench_large "${name##*/} repeated" "$folder/file.ifc"
	rm "$folder/file.ifc"
done
