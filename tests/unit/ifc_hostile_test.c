/*
 * A small file of everything but much, cut short at every byte, and with every
 * byte gone or another: none may crash, hang, or break the rules that the fuzz
 * target checks.
 */
#include "tests/fuzz/ifc_fuzz.c"

#include <stdio.h>
#include <string.h>

#include "check.h"

static const char document[] =
	"ISO-10303-21;HEADER;FILE_SCHEMA(('IFC2X3'));ENDSEC;DATA;"
	"#1=IFCSIUNIT(*,.LENGTHUNIT.,.MILLI.,.METRE.);"
	"#2=IFCUNITASSIGNMENT((#1));"
	"#3=IFCPROJECT('p',$,$,$,$,$,$,(),#2);"
	"#4=IFCSITE('s',$,$,$,$,$,$,$,.ELEMENT.,(50,43,58),(-7,-6,0),1.,'12',"
	"#6);"
	"#5=IFCBUILDING('b',$,$,$,$,$,$,$,.ELEMENT.,0.,0.,#6);"
	"#6=IFCPOSTALADDRESS(.OFFICE.,$,$,'in',('1'),'7','Bonn','NRW',$,'D');"
	"#7=IFCRELAGGREGATES('r',$,$,$,#5,(#8));"
	"#8=IFCWALL('w',$,$,$,$,#9,#12,$);"
	"#9=IFCLOCALPLACEMENT($,#10);#10=IFCAXIS2PLACEMENT3D(#11,$,$);"
	"#11=IFCCARTESIANPOINT((0.,0.,0.));"
	"#12=IFCPRODUCTDEFINITIONSHAPE($,$,(#13));"
	"#13=IFCSHAPEREPRESENTATION($,'Body','SweptSolid',(#14));"
	"#14=IFCEXTRUDEDAREASOLID(#15,$,#20,30.);"
	"#15=IFCARBITRARYCLOSEDPROFILEDEF(.AREA.,$,#16);"
	"#16=IFCPOLYLINE((#17,#18,#19,#21,#17));"
	"#17=IFCCARTESIANPOINT((0.,0.));#18=IFCCARTESIANPOINT((9.,9.));"
	"#19=IFCCARTESIANPOINT((9.,0.));#21=IFCCARTESIANPOINT((0.,9.));"
	"#20=IFCDIRECTION((0.,0.,1.));"
	"#22=IFCPROJECTIONELEMENT('j',$,$,$,$,#9,#12,$);"
	"#27=IFCRELPROJECTSELEMENT('q',$,$,$,#8,#22);"
	"#28=IFCOPENINGELEMENT('o',$,$,$,$,#9,#29,$);"
	"#29=IFCPRODUCTDEFINITIONSHAPE($,$,(#30));"
	"#30=IFCSHAPEREPRESENTATION($,'Body','SweptSolid',(#31));"
	"#31=IFCEXTRUDEDAREASOLID(#32,$,#20,2.);"
	"#32=IFCRECTANGLEPROFILEDEF(.AREA.,$,$,2.,2.);"
	"#33=IFCRELVOIDSELEMENT('v',$,$,$,#8,#28);"
	"#34=IFCRELASSOCIATESMATERIAL('m',$,$,$,(#8),#35);"
	"#35=IFCMATERIALLAYERSETUSAGE(#36,.AXIS2.,.POSITIVE.,0.);"
	"#36=IFCMATERIALLAYERSET((#37),'set');"
	"#37=IFCMATERIALLAYER(#38,240.,.T.);#38=IFCMATERIAL('Brick');"
	"#39=IFCRELDEFINESBYPROPERTIES('d',$,$,$,(#4,#8),#40);"
	"#40=IFCPROPERTYSET('e',$,'ePset_MapConversion',$,(#41,#42,#43));"
	"#41=IFCPROPERTYSINGLEVALUE('Eastings',$,IFCREAL(6.5),$);"
	"#42=IFCPROPERTYSINGLEVALUE('Northings',$,IFCLABEL('5.6'),$);"
	"#43=IFCPROPERTYREFERENCEVALUE('a',$,$,#6);";

static const char end[] = "ENDSEC;END-ISO-10303-21;";

enum { LENGTH = sizeof document - 1, ROOM = LENGTH + sizeof end };

/* The first bytes of the document, and behind them its end or nothing. */
static void
prefix_read(size_t length, bool ended)
{
	uint8_t *bytes = malloc(ROOM); /* so that no byte behind is ours */
	size_t size = length;

	if (!bytes)
		abort();
	memcpy(bytes, document, length);
	if (ended) {
		memcpy(bytes + length, end, sizeof end - 1);
		size += sizeof end - 1;
	}
	bytes = realloc(bytes, size + !size);
	if (!bytes)
		abort();
	CHECK(!LLVMFuzzerTestOneInput(bytes, size));
	free(bytes);
}

static void
cut_short_at_every_byte_it_ends(void)
{
	for (size_t length = 0; length <= LENGTH; length++)
		prefix_read(length, false);
}

static void
every_statement_may_be_the_last_or_half_of_it(void)
{
	for (size_t length = 0; length <= LENGTH; length++)
		prefix_read(length, true);
}

static void
every_byte_may_be_another_one(void)
{
	static const char others[] = "$*#9-(),'";
	char bytes[ROOM];

	memcpy(bytes, document, LENGTH);
	memcpy(bytes + LENGTH, end, sizeof end);
	for (size_t at = 0; at < LENGTH; at++) {
		bytes[at] = others[at % (sizeof others - 1)];
		CHECK(!LLVMFuzzerTestOneInput(
			(const uint8_t *)bytes, ROOM - 1));
		bytes[at] = document[at];
	}
}

static void
every_byte_may_be_gone(void)
{
	char bytes[ROOM];

	for (size_t at = 0; at < LENGTH; at++) {
		memcpy(bytes, document, at);
		memcpy(bytes + at, document + at + 1, LENGTH - at - 1);
		memcpy(bytes + LENGTH - 1, end, sizeof end);
		CHECK(!LLVMFuzzerTestOneInput(
			(const uint8_t *)bytes, ROOM - 2));
	}
}

static const struct check_test tests[] = {
	CHECK_TEST(cut_short_at_every_byte_it_ends),
	CHECK_TEST(every_statement_may_be_the_last_or_half_of_it),
	CHECK_TEST(every_byte_may_be_another_one),
	CHECK_TEST(every_byte_may_be_gone),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
