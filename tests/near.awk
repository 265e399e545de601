# awk -v tolerance=T -f near.awk EXPECTED ACTUAL: exit 0 when the two texts
# are equal but for numbers that differ by at most T, absolutely or relative
# to their size.

function abs(x) {
	return x < 0 ? -x : x
}

function near(a, b, size) {
	size = abs(a) > 1 ? abs(a) : 1
	return abs(a - b) <= tolerance * size
}

# Whether two lines are: text between numbers equal, numbers near.
function alike(a, b, number, x, y) {
	number = "[-+]?[0-9]+(\\.[0-9]+)?([eE][-+]?[0-9]+)?"
	while (match(a, number)) {
		x = substr(a, RSTART, RLENGTH)
		if (substr(a, 1, RSTART - 1) != substr(b, 1, RSTART - 1))
			return 0
		a = substr(a, RSTART + RLENGTH)
		b = substr(b, RSTART)
		if (!match(b, number) || RSTART != 1)
			return 0
		y = substr(b, 1, RLENGTH)
		b = substr(b, RLENGTH + 1)
		if (x != y && !near(x + 0, y + 0))
			return 0
	}
	return a == b
}

FNR == NR {
	expected[FNR] = $0
	lines = FNR
	next
}

!(FNR in expected) || !alike(expected[FNR], $0) {
	differs = 1
	exit
}

{
	seen = FNR
}

END {
	exit differs || seen != lines
}
