# Are the solids of a CityGML file closed and the right way out? For files that
# maketown and tcs2citygml write: one element a line. Every edge of a solid must be passed once
# each way, its outer shell must have a positive volume and its voids negative
# ones. The last line counts solids and faults.

function attribute(name,    at, rest) {
	at = index($0, name "=\"")
	if (!at)
		return ""
	rest = substr($0, at + length(name) + 2)
	return substr(rest, 1, index(rest, "\"") - 1)
}

function fault(text) {
	print "solid " solid_name[s] ": " text
	faults++
}

# The points between tags, "x y z" each, behind what the ring has.
function points(    text, n, word, i) {
	text = $0
	gsub(/<[^>]*>/, " ", text)
	n = split(text, word, " ")
	for (i = 1; i + 2 <= n; i += 3)
		ring = ring word[i] " " word[i + 1] " " word[i + 2] ";"
}

/<gml:Solid/ { inside = 1; solid_name[++solids] = attribute("gml:id") }
/<\/gml:Solid>/ { inside = 0 }
/<gml:exterior>/ && inside && !polygon { shell = ++shells; shell_void[shell] = 0 }
/<gml:interior>/ && inside && !polygon { shell = ++shells; shell_void[shell] = 1 }
/<gml:(CompositeSurface|Shell)/ && inside { shell_solid[shell] = solids }
/<gml:Polygon/ {
	polygon = attribute("gml:id")
	if (polygon == "")
		polygon = "polygon#" ++unnamed
	if (inside && !oriented)
		members[shell] = members[shell] "+" polygon " "
	if (polygon in rings)
		print "polygon " polygon " stands twice", ++faults
	rings[polygon] = ""
}
/<gml:LinearRing>/ { ring = "" }
/<gml:pos/ || /<gml:pointProperty>/ { points() }
/<\/gml:LinearRing>/ { if (polygon) rings[polygon] = rings[polygon] ring "\n" }
/<\/gml:Polygon>/ { polygon = "" }
/<gml:OrientableSurface/ {
	oriented = attribute("gml:id")
	if (oriented == "")
		oriented = "oriented#" ++unnamed
	sign = attribute("orientation")
	if (inside)
		members[shell] = members[shell] "+" oriented " "
}
/<gml:baseSurface / {
	base[oriented] = substr(attribute("xlink:href"), 2)
	turned[oriented] = sign == "-"
}
/<\/gml:OrientableSurface>/ { oriented = "" }
/<gml:surfaceMember xlink/ && inside {
	members[shell] = members[shell] "+" substr(attribute("xlink:href"), 2) " "
}

# Add the edges of one ring, and its share of the volume, as a fan.
function add_ring(text, over,    n, p, i, a, b, first, u, v, w) {
	n = split(text, p, ";") - 1
	if (p[1] != p[n])
		fault("an open ring")
	split(p[1], first, " ")
	for (i = 1; i < n; i++) {
		a = over ? p[i + 1] : p[i]
		b = over ? p[i] : p[i + 1]
		passed[a "|" b]++
		split(a, v, " ")
		split(b, w, " ")
		volume += det(first[1] - ox, first[2] - oy, first[3] - oz,
			v[1] - ox, v[2] - oy, v[3] - oz,
			w[1] - ox, w[2] - oy, w[3] - oz) / 6
	}
}

function det(a, b, c, d, e, f, g, h, i) {
	return a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)
}

function add_shell(which,    n, list, i, id, over, m, parts, j, o) {
	volume = 0
	n = split(members[which], list, " ")
	for (i = 1; i <= n; i++) {
		id = substr(list[i], 2)
		over = 0
		while (id in base) {
			over = over != turned[id]
			id = base[id]
		}
		if (!(id in rings)) {
			fault("no polygon " id)
			continue
		}
		m = split(rings[id], parts, "\n") - 1
		if (!ox) {
			split(parts[1], o, /[ ;]/)
			ox = o[1]; oy = o[2]; oz = o[3]
		}
		for (j = 1; j <= m; j++)
			add_ring(parts[j], over)
	}
	if (n == 0)
		fault("a shell without members")
	if (shell_void[which] ? volume >= 0 : volume <= 0)
		fault("a shell of volume " volume)
}

END {
	k = 1
	for (s = 1; s <= solids; s++) {
		split("", passed)
		ox = 0
		for (; k <= shells && shell_solid[k] == s; k++)
			add_shell(k)
		for (edge in passed) {
			split(edge, end, "|")
			if (passed[edge] != 1 || passed[end[2] "|" end[1]] != 1) {
				fault("an open edge " edge)
				break
			}
		}
	}
	print solids + 0 " solids, " faults + 0 " faults"
	exit faults > 0 || solids == 0
}
