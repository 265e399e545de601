/* Breps with curved faces against volumes in closed form. */
#include "ifc_shape_sample.h"
#include "parsers/ifc_item.h"

#define PLACES \
	"#1=IFCCARTESIANPOINT((0.,0.,0.));#2=IFCCARTESIANPOINT((0.,0.,3.));" \
	"#3=IFCAXIS2PLACEMENT3D(#1,$,$);#4=IFCAXIS2PLACEMENT3D(#2,$,$);" \
	"#5=IFCPLANE(#3);#6=IFCPLANE(#4);#7=IFCCYLINDRICALSURFACE(#3,2.);" \
	"#8=IFCCIRCLE(#3,2.);#9=IFCCIRCLE(#4,2.);" \
	"#11=IFCCARTESIANPOINT((2.,0.,0.));#12=IFCCARTESIANPOINT((2.,0.,3.));" \
	"#13=IFCCARTESIANPOINT((0.,2.,0.));#14=IFCCARTESIANPOINT((0.,2.,3.));" \
	"#15=IFCCARTESIANPOINT((0.,0.,2.));" \
	"#20=IFCVERTEXPOINT(#1);#21=IFCVERTEXPOINT(#11);" \
	"#22=IFCVERTEXPOINT(#12);#23=IFCVERTEXPOINT(#13);" \
	"#24=IFCVERTEXPOINT(#14);#25=IFCVERTEXPOINT(#15);" \
	"#26=IFCVERTEXPOINT(#2);" \
	"#100=IFCADVANCEDBREP(#99);"

/* Whole circles below and above, and an edge between them. */
#define ROUND_EDGES \
	"#30=IFCEDGECURVE(#21,#21,#8,.T.);#31=IFCEDGECURVE(#22,#22,#9,.T.);" \
	"#32=IFCEDGE(#21,#22);#33=IFCORIENTEDEDGE(*,*,#30,.T.);" \
	"#34=IFCORIENTEDEDGE(*,*,#30,.F.);#35=IFCORIENTEDEDGE(*,*,#31,.T.);" \
	"#36=IFCORIENTEDEDGE(*,*,#31,.F.);#37=IFCORIENTEDEDGE(*,*,#32,.T.);" \
	"#38=IFCORIENTEDEDGE(*,*,#32,.F.);#40=IFCEDGELOOP((#34));" \
	"#41=IFCFACEOUTERBOUND(#40,.T.);#42=IFCADVANCEDFACE((#41),#5,.F.);" \
	"#43=IFCEDGELOOP((#35));#44=IFCFACEOUTERBOUND(#43,.T.);" \
	"#45=IFCADVANCEDFACE((#44),#6,.T.);#46=IFCEDGELOOP((#33));" \
	"#47=IFCFACEBOUND(#46,.T.);"

#define CAPPED "#99=IFCCLOSEDSHELL((#42,#45,#50));"

/* A quarter of a cylinder: its edges, and its faces but for #50, the round. */
#define QUARTER \
	"#30=IFCEDGECURVE(#21,#23,#8,.T.);#31=IFCEDGECURVE(#22,#24,#9,.T.);" \
	"#32=IFCEDGE(#21,#22);#33=IFCEDGE(#23,#24);#34=IFCEDGE(#20,#21);" \
	"#35=IFCEDGE(#20,#23);#36=IFCEDGE(#26,#22);#37=IFCEDGE(#26,#24);" \
	"#38=IFCEDGE(#20,#26);" \
	"#39=IFCORIENTEDEDGE(*,*,#30,.F.);#40=IFCORIENTEDEDGE(*,*,#34,.F.);" \
	"#41=IFCEDGELOOP((#35,#39,#40));#42=IFCFACEOUTERBOUND(#41,.T.);" \
	"#43=IFCADVANCEDFACE((#42),#5,.F.);" \
	"#44=IFCORIENTEDEDGE(*,*,#37,.F.);#45=IFCEDGELOOP((#36,#31,#44));" \
	"#46=IFCFACEOUTERBOUND(#45,.T.);#47=IFCADVANCEDFACE((#46),#6,.T.);" \
	"#51=IFCORIENTEDEDGE(*,*,#36,.F.);#52=IFCORIENTEDEDGE(*,*,#38,.F.);" \
	"#53=IFCEDGELOOP((#34,#32,#51,#52));#54=IFCFACEOUTERBOUND(#53,.T.);" \
	"#55=IFCDIRECTION((0.,1.,0.));#56=IFCAXIS2PLACEMENT3D(#1,#55,$);" \
	"#57=IFCPLANE(#56);#58=IFCADVANCEDFACE((#54),#57,.F.);" \
	"#59=IFCORIENTEDEDGE(*,*,#33,.F.);#60=IFCORIENTEDEDGE(*,*,#35,.F.);" \
	"#61=IFCEDGELOOP((#38,#37,#59,#60));#62=IFCFACEOUTERBOUND(#61,.T.);" \
	"#63=IFCDIRECTION((1.,0.,0.));#64=IFCAXIS2PLACEMENT3D(#1,#63,#55);" \
	"#65=IFCPLANE(#64);#66=IFCADVANCEDFACE((#62),#65,.F.);" \
	"#67=IFCORIENTEDEDGE(*,*,#31,.F.);#68=IFCORIENTEDEDGE(*,*,#32,.F.);" \
	"#69=IFCEDGELOOP((#30,#33,#67,#68));#70=IFCFACEOUTERBOUND(#69,.T.);" \
	"#50=IFCADVANCEDFACE((#70),#80,.T.);" \
	"#99=IFCCLOSEDSHELL((#43,#47,#58,#66,#50));"

static enum ifc_outcome
brep_faces(struct ifc_shaper *shaper, uint32_t item, struct ifc_faces *out)
{
	struct ifc_body body = {.faces = {.points = {.count = 0}}};
	enum ifc_outcome outcome;
	struct tcs_fault fault;

	CHECK(!ifc_scratch_new(&shaper->scratch, &fault));
	outcome = ifc_brep(shaper, item, &body);
	ifc_scratch_free(shaper->scratch);
	*out = body.faces;
	array_release(&body.parts);
	return outcome;
}

/* The volume of the closed solid; -1 when it is refused. */
static double
volume_of(const char *data, double deflection)
{
	char text[8192];
	struct ifc_faces faces;
	struct solid_measure measure = {.volume = -1};

	snprintf(text, sizeof text, "%s%s", PLACES, data);
	if (sample_shape("IFC4", text, deflection, brep_faces, &faces)) {
		measure = sample_measure(&faces);
		CHECK(measure.closed);
	}
	ifc_faces_release(&faces);
	return measure.volume;
}

/* Off by no more than the surface times the deflection, ever finer. */
static void
check_volumes(const char *data, double volume, double surface)
{
	for (double deflection = 0.1; deflection > 5e-4; deflection /= 10)
		CHECK(is_near(volume_of(data, deflection), volume,
			surface * deflection));
}

static void
a_cylinder_needs_no_seam(void)
{
	check_volumes(ROUND_EDGES CAPPED
		"#48=IFCEDGELOOP((#33,#37,#36,#38));#49=IFCFACEOUTERBOUND(#48,"
		".T.);#50=IFCADVANCEDFACE((#49),#7,.T.);",
		12 * SAMPLE_PI, 12 * SAMPLE_PI);
	check_volumes(ROUND_EDGES CAPPED
		"#48=IFCEDGELOOP((#36));#49=IFCFACEOUTERBOUND(#48,.T.);"
		"#50=IFCADVANCEDFACE((#49,#47),#7,.T.);",
		12 * SAMPLE_PI, 12 * SAMPLE_PI);
}

static void
surfaces_may_have_no_bounds(void)
{
	check_volumes("#30=IFCVERTEXLOOP(#21);#31=IFCFACEBOUND(#30,.T.);"
		      "#32=IFCSPHERICALSURFACE(#3,2.);"
		      "#33=IFCADVANCEDFACE((#31),#32,.T.);"
		      "#99=IFCCLOSEDSHELL((#33));",
		32 * SAMPLE_PI / 3, 16 * SAMPLE_PI);
	check_volumes("#30=IFCVERTEXLOOP(#21);#31=IFCFACEBOUND(#30,.T.);"
		      "#32=IFCTOROIDALSURFACE(#4,4.,1.);"
		      "#33=IFCADVANCEDFACE((#31),#32,.F.);"
		      "#99=IFCCLOSEDSHELL((#33));",
		8 * SAMPLE_PI * SAMPLE_PI, 16 * SAMPLE_PI * SAMPLE_PI);
}

static void
poles_and_tips_are_points(void)
{
	/* Half a ball, an eighth of one, and a cone. */
	check_volumes(ROUND_EDGES "#80=IFCSPHERICALSURFACE(#3,2.);"
				  "#81=IFCADVANCEDFACE((#47),#80,.T.);"
				  "#99=IFCCLOSEDSHELL((#42,#81));",
		16 * SAMPLE_PI / 3, 8 * SAMPLE_PI);
	check_volumes(
		"#30=IFCDIRECTION((1.,0.,0.));#31=IFCDIRECTION((0.,1.,0.));"
		"#32=IFCDIRECTION((0.,0.,1.));"
		"#33=IFCAXIS2PLACEMENT3D(#1,#30,#31);"
		"#34=IFCAXIS2PLACEMENT3D(#1,#31,#32);#35=IFCCIRCLE(#33,2.);"
		"#36=IFCCIRCLE(#34,2.);#40=IFCEDGECURVE(#21,#23,#8,.T.);"
		"#41=IFCEDGECURVE(#23,#25,#35,.T.);"
		"#42=IFCEDGECURVE(#25,#21,#36,.T.);"
		"#43=IFCEDGE(#20,#21);#44=IFCEDGE(#20,#23);"
		"#45=IFCEDGE(#20,#25);#46=IFCORIENTEDEDGE(*,*,#43,.F.);"
		"#47=IFCORIENTEDEDGE(*,*,#44,.F.);"
		"#48=IFCORIENTEDEDGE(*,*,#45,.F.);"
		"#49=IFCORIENTEDEDGE(*,*,#40,.F.);"
		"#50=IFCORIENTEDEDGE(*,*,#41,.F.);"
		"#51=IFCORIENTEDEDGE(*,*,#42,.F.);"
		"#52=IFCEDGELOOP((#40,#41,#42));#53=IFCEDGELOOP((#44,#49,#46));"
		"#54=IFCEDGELOOP((#45,#50,#47));#55=IFCEDGELOOP((#43,#51,#48));"
		"#56=IFCFACEOUTERBOUND(#52,.T.);#57=IFCFACEOUTERBOUND(#53,.T.);"
		"#58=IFCFACEOUTERBOUND(#54,.T.);#59=IFCFACEOUTERBOUND(#55,.T.);"
		"#60=IFCSPHERICALSURFACE(#3,2.);#61=IFCPLANE(#33);"
		"#62=IFCPLANE(#34);#63=IFCADVANCEDFACE((#56),#60,.T.);"
		"#64=IFCADVANCEDFACE((#57),#5,.F.);"
		"#65=IFCADVANCEDFACE((#58),#61,.F.);"
		"#66=IFCADVANCEDFACE((#59),#62,.F.);"
		"#99=IFCCLOSEDSHELL((#63,#64,#65,#66));",
		4 * SAMPLE_PI / 3, 2 * SAMPLE_PI);
	check_volumes(ROUND_EDGES
		"#80=IFCDIRECTION((1.,0.,0.));#81=IFCDIRECTION((0.,-1.,0.));"
		"#82=IFCAXIS2PLACEMENT3D(#1,#81,#80);#83=IFCDIRECTION((0.,1.));"
		"#84=IFCAXIS1PLACEMENT(#1,#85);#85=IFCDIRECTION((0.,1.,0.));"
		"#86=IFCCARTESIANPOINT((2.,0.));#87=IFCCARTESIANPOINT((0.,3.));"
		"#88=IFCPOLYLINE((#86,#87));"
		"#89=IFCARBITRARYOPENPROFILEDEF(.CURVE.,$,#88);"
		"#90=IFCSURFACEOFREVOLUTION(#89,#82,#84);"
		"#91=IFCADVANCEDFACE((#47),#90,.T.);"
		"#99=IFCCLOSEDSHELL((#42,#91));",
		4 * SAMPLE_PI, 8 * SAMPLE_PI);
}

static void
all_kinds_of_surfaces_make_the_same_solid(void)
{
	static const char *const all[] = {
		"#80=IFCCYLINDRICALSURFACE(#3,2.);",
		"#80=IFCRATIONALBSPLINESURFACEWITHKNOTS(2,1,((#11,#12),(#81,"
		"#82),(#13,#14)),.UNSPECIFIED.,.F.,.F.,.F.,(3,3),(2,2),(0.,1.),"
		"(0.,1.),.UNSPECIFIED.,((1.,1.),(0.7071067811865476,"
		"0.7071067811865476),(1.,1.)));"
		"#81=IFCCARTESIANPOINT((2.,2.,0.));"
		"#82=IFCCARTESIANPOINT((2.,2.,3.));",
		"#80=IFCSURFACEOFLINEAREXTRUSION(#81,$,#82,3.);"
		"#81=IFCARBITRARYCLOSEDPROFILEDEF(.CURVE.,$,#8);"
		"#82=IFCDIRECTION((0.,0.,1.));",
		/* Its curve is where it should be already. */
		"#80=IFCSURFACEOFLINEAREXTRUSION(#81,#4,#82,3.);"
		"#81=IFCARBITRARYOPENPROFILEDEF(.CURVE.,$,#83);"
		"#82=IFCDIRECTION((0.,0.,1.));"
		"#83=IFCTRIMMEDCURVE(#8,(#11),(#13),.T.,.CARTESIAN.);",
		"#80=IFCSURFACEOFREVOLUTION(#81,#82,#83);"
		"#81=IFCARBITRARYOPENPROFILEDEF(.CURVE.,$,#84);"
		"#82=IFCAXIS2PLACEMENT3D(#1,#85,#63);"
		"#83=IFCAXIS1PLACEMENT(#1,#86);#84=IFCPOLYLINE((#87,#88));"
		"#85=IFCDIRECTION((0.,-1.,0.));#86=IFCDIRECTION((0.,1.,0.));"
		"#87=IFCCARTESIANPOINT((2.,-1.));"
		"#88=IFCCARTESIANPOINT((2.,4.));",
	};

	for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
		char data[8192];

		snprintf(data, sizeof data, "%s%s", QUARTER, all[i]);
		check_volumes(data, 3 * SAMPLE_PI, 3 * SAMPLE_PI);
	}
}

static void
senses_that_disagree_are_mended(void)
{
	CHECK(is_near(volume_of(ROUND_EDGES CAPPED
			      "#48=IFCEDGELOOP((#36));"
			      "#49=IFCFACEOUTERBOUND(#48,.F.);"
			      "#51=IFCFACEBOUND(#46,.F.);"
			      "#50=IFCADVANCEDFACE((#49,#51),#7,.T.);",
			      1e-4),
		12 * SAMPLE_PI, 1e-2));
}

static void
faces_that_are_none_are_refused(void)
{
	static const char *const all[] = {
		"#99=IFCCLOSEDSHELL((#30));"
		"#30=IFCADVANCEDFACE($,#7,.T.);",
		"#99=IFCCLOSEDSHELL((#30));#30=IFCADVANCEDFACE((#31),#7,.T.);"
		"#31=IFCFACEBOUND(#32,.T.);#32=IFCVERTEXLOOP(#21);",
		"#99=IFCCLOSEDSHELL((#30));#30=IFCADVANCEDFACE((#31),#32,.T.);"
		"#31=IFCFACEBOUND(#33,.T.);#32=IFCSPHERICALSURFACE(#3,0.);"
		"#33=IFCVERTEXLOOP(#21);",
		"#99=IFCCLOSEDSHELL((#30));#30=IFCADVANCEDFACE((#31),#30,.T.);"
		"#31=IFCFACEBOUND(#33,.T.);#33=IFCVERTEXLOOP(#21);",
		"#99=IFCCLOSEDSHELL((#30));#30=IFCADVANCEDFACE((#31),#7,.T.);"
		"#31=IFCFACEBOUND(#32,.T.);#32=IFCEDGELOOP((#33));"
		"#33=IFCEDGECURVE(#21,#99,#8,.T.);",
		"#99=IFCCLOSEDSHELL((#30));#30=IFCADVANCEDFACE((#31),#7,.T.);"
		"#31=IFCFACEBOUND(#32,.T.);#32=IFCEDGELOOP((#33));"
		"#33=IFCORIENTEDEDGE(*,*,#33,.T.);",
		"#99=IFCCLOSEDSHELL((#30));#30=IFCADVANCEDFACE((#31),#7,.T.);"
		"#31=IFCFACEBOUND(#32,.T.);#32=IFCEDGELOOP((#33));"
		"#33=IFCEDGECURVE(#21,#21,#8,.T.);",
		"#99=IFCCLOSEDSHELL((#30));#30=IFCADVANCEDFACE((#31),#34,.T.);"
		"#31=IFCFACEBOUND(#32,.T.);#32=IFCEDGELOOP((#33));"
		"#33=IFCEDGECURVE(#21,#21,#8,.T.);"
		"#34=IFCBSPLINESURFACEWITHKNOTS(1,1,((#11,#12),(#13)),"
		".UNSPECIFIED.,.F.,.F.,.F.,(2,2),(2,2),(0.,1.),(0.,1.),"
		".UNSPECIFIED.);",
	};

	for (size_t i = 0; i < sizeof all / sizeof *all; i++)
		CHECK(volume_of(all[i], 1e-3) == -1);
}

static const struct check_test tests[] = {
	CHECK_TEST(a_cylinder_needs_no_seam),
	CHECK_TEST(surfaces_may_have_no_bounds),
	CHECK_TEST(poles_and_tips_are_points),
	CHECK_TEST(all_kinds_of_surfaces_make_the_same_solid),
	CHECK_TEST(senses_that_disagree_are_mended),
	CHECK_TEST(faces_that_are_none_are_refused),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
