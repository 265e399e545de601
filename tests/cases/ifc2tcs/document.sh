# shellcheck shell=bash
# Sourced by cases: small IFC files.

# ifc SCHEMA < DATA: a file in millimetres with a project, a site, a building
# and a storey (#4 to #7), which the lines of standard input follow.
ifc() {
	cat <<-END
	ISO-10303-21;
	HEADER;
	FILE_DESCRIPTION((''),'2;1');
	FILE_NAME('','',(''),(''),'','','');
	FILE_SCHEMA(('$1'));
	ENDSEC;
	DATA;
	#1=IFCSIUNIT(*,.LENGTHUNIT.,.MILLI.,.METRE.);
	#2=IFCSIUNIT(*,.PLANEANGLEUNIT.,\$,.RADIAN.);
	#3=IFCUNITASSIGNMENT((#1,#2));
	#4=IFCPROJECT('0\$ScRe4drECQ4DMSqUjd6d',\$,'Project',\$,\$,\$,\$,(),#3);
	#5=IFCSITE('1\$ScRe4drECQ4DMSqUjd6d',\$,'Site',\$,\$,\$,\$,\$,.ELEMENT.,\$,\$,\$,\$,\$);
	#6=IFCBUILDING('2\$ScRe4drECQ4DMSqUjd6d',\$,'House',\$,\$,\$,\$,\$,.ELEMENT.,\$,\$,\$);
	#7=IFCBUILDINGSTOREY('3\$ScRe4drECQ4DMSqUjd6d',\$,'Ground floor',\$,\$,\$,\$,\$,.ELEMENT.,0.);
	#8=IFCRELAGGREGATES('4\$ScRe4drECQ4DMSqUjd6d',\$,\$,\$,#4,(#5));
	#9=IFCRELAGGREGATES('5\$ScRe4drECQ4DMSqUjd6d',\$,\$,\$,#5,(#6));
	#10=IFCRELAGGREGATES('6\$ScRe4drECQ4DMSqUjd6d',\$,\$,\$,#6,(#7));
	#11=IFCCARTESIANPOINT((0.,0.,0.));
	#12=IFCAXIS2PLACEMENT3D(#11,\$,\$);
	#13=IFCLOCALPLACEMENT(\$,#12);
	#14=IFCDIRECTION((0.,0.,1.));
	END
	cat
	printf '%s\n' 'ENDSEC;' 'END-ISO-10303-21;'
}

# product ID ENTITY ITEM...: #ID is an element with these items as its body, in
# the storey.
product() {
	local id=$1 entity=$2
	shift 2
	cat <<-END
	#$id=$entity('$entity$id',\$,'$entity',\$,\$,#13,#${id}1,\$);
	#${id}1=IFCPRODUCTDEFINITIONSHAPE(\$,\$,(#${id}2));
	#${id}2=IFCSHAPEREPRESENTATION(\$,'Body','SweptSolid',($(IFS=,; echo "$*")));
	#${id}3=IFCRELCONTAINEDINSPATIALSTRUCTURE('R$id',\$,\$,\$,(#$id),#7);
	END
}

# measured FILE [OPTION...]: the box and the volume of each product.
measured() {
	ifc2tcs -o out.tcs "$@" && tcs2json out.tcs | python3 -c '
import json, sys
sys.path.insert(0, sys.argv[1])
import ifc_reference
for name, found in sorted(ifc_reference.measures(sys.stdin).items()):
    print(name, *(round(v, 4) + 0.0 for v in found.lower + found.upper),
          round(found.volume(), 6) + 0.0)' "$ROOT/tests"
}
