# shellcheck shell=bash
# boxes [OFFSET] <LIST >STREAM: a building of boxes as a stream. A line of the
# list is a box, "ID X0 Y0 Z0 X1 Y1 Z1 [TILT [flip]]": its feature, which others
# may have, too, and corners; it rises by TILT metres along x. OFFSET is added to
# x and y.
boxes() {
	awk -v offset="${1-0}" '
	function at(i, j, k) {
		return sprintf("[%.6f,%.6f,%.6f]", offset + (i ? x1 : x0),
			offset + (j ? y1 : y0), (k ? z1 : z0) + (i ? tilt : 0))
	}
	function face(a, b, c, d) {
		polygons = polygons comma sprintf(\
			"{\"surface\":%d,\"vertices\":[%s,%s,%s,%s]," \
			"\"triangles\":%s}", feature[$1], a, b, c, d, \
			triangles)
		comma = ","
	}
	{
		x0 = $2; y0 = $3; z0 = $4; x1 = $5; y1 = $6; z1 = $7
		tilt = $8 + 0
		triangles = $9 == "flip" ? "[[0,2,1],[0,3,2]]" \
			: "[[0,1,2],[0,2,3]]"
		if (!($1 in feature)) {
			feature[$1] = ++count
			features = features sprintf(",{\"parent\":0," \
				"\"class\":\"BuildingInstallation\"," \
				"\"id\":\"%s\"}", $1)
		}
		face(at(0,0,0), at(0,1,0), at(1,1,0), at(1,0,0))
		face(at(0,0,1), at(1,0,1), at(1,1,1), at(0,1,1))
		face(at(0,0,0), at(1,0,0), at(1,0,1), at(0,0,1))
		face(at(1,0,0), at(1,1,0), at(1,1,1), at(1,0,1))
		face(at(1,1,0), at(0,1,0), at(0,1,1), at(1,1,1))
		face(at(0,1,0), at(0,0,0), at(0,0,1), at(0,1,1))
	}
	END {
		print "{\"record\":\"head\",\"crs\":{\"kind\":\"projected\"," \
			"\"metres_per_unit\":1,\"metres_per_unit_up\":1}}"
		print "{\"record\":\"object\",\"features\":[{\"class\":" \
			"\"Building\",\"id\":\"house\"}" features "]," \
			"\"geometries\":[{\"feature\":0,\"lod\":3," \
			"\"kind\":\"multi-surface\",\"flags\":[\"simplified\"]," \
			"\"polygons\":[" polygons "]}]}"
		print "{\"record\":\"end\"}"
	}' | json2tcs
}

# The list of a small house: what stands on what, from the ground up.
house() {
	cat <<-'END'
		slab 0 0 0 10 8 0.3
		left 1 1 0.3 1.4 1.4 3
		right 8.6 1 0.3 9 1.4 3
		roof 0 0 3 10 8 3.2
		chimney 4 4 3.2 5 5 4.5
	END
}

# what FILTER: those numbers of the comparison of a.tcs and b.tcs.
what() {
	tcs-compare --json a.tcs b.tcs | jq -c ".all | $1"
}
