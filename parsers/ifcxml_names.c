#include "ifcxml_names.h"

#include <string.h>

/* Whether `names`, with blanks around each, has the name. */
static bool
has_name(const char *names, const char *name)
{
	size_t length = strlen(name);
	const char *at = names;

	while (length && (at = strstr(at, name))) {
		if (at[-1] == ' ' && at[length] == ' ')
			return true;
		at++;
	}
	return false;
}

static const char strings[] =
	" GlobalId Name Description LongName ObjectType Tag Tags TagList "
	"Identification Id ItemReference Identifier ProfileName UsageName "
	"Category RepresentationIdentifier RepresentationType "
	"ContextIdentifier ContextType Phase LandTitleNumber PostalCode "
	"PostalBox Town Region Country InternalLocation AddressLines Version "
	"ApplicationFullName ApplicationIdentifier FamilyName GivenName "
	"GeodeticDatum VerticalDatum MapProjection MapZone LayerSetName "
	"Currency SteelGrade Expression AxisTag StartTag EndTag Source Edition "
	"EditionDate Specification Sort UserDefinedType UserDefinedPurpose "
	"UserDefinedOperationType UserDefinedPartitioningType "
	"UserDefinedTargetView UserDefinedFunction ElementType ApplicableOccurrence "
	"URLReference RasterFormat BendingShapeCode ControlElementId Formula "
	"Purpose ";

static const char enumerations[] =
	" PredefinedType CompositionType UnitType Prefix Operator ProfileType "
	"OperationType PartitioningType ConstructionType AssemblyPlace "
	"Transition MasterRepresentation CurveForm SurfaceForm KnotSpec "
	"LayerSetDirection DirectionSense PhysicalOrVirtualBoundary "
	"InternalOrExternalBoundary InteriorOrExteriorSpace FlowDirection "
	"ReflectanceMethod Side TargetView GlobalOrLocal ProxyType "
	"RelatedConnectionType RelatingConnectionType RelatedObjectsType "
	"BarRole BarSurface TextureType CurveInterpolation ChangeAction State "
	"PanelPosition PanelOperation ";

static const char lists[] =
	" Points Segments Styles Items Elements Quantities HasQuantities "
	"CrossSections CrossSectionPositions Faces Bounds Voids EdgeList "
	"Polygon Units Materials MaterialLayers MaterialProfiles "
	"MaterialConstituents Profiles RepresentationMaps Representations "
	"RelatedObjects RelatedElements RelatedBuildings RelatedDefinitions "
	"RelatedCoverings RelatedProducts RelatedPropertySets "
	"RelatedSurfaceFeatures HasProperties HasPropertySets "
	"RepresentationContexts EnumerationValues ListValues DefiningValues "
	"DefinedValues Trim1 Trim2 DirectionRatios RefLatitude RefLongitude "
	"Textures InnerCurves InnerBoundaries Boundaries CfsFaces FbsmFaces "
	"SbsmBoundary Coordinates CoordList CoordIndex PnIndex ColourIndex "
	"ColourList KnotMultiplicities Knots UMultiplicities VMultiplicities "
	"UKnots VKnots WeightsData ControlPointsList UAxes VAxes WAxes "
	"IntersectingAxes OffsetDistances OffsetValues AddressLines "
	"AssignedItems AssociatedGeometry InnerCoordIndices TexCoordsList "
	"TexCoordIndex Maps ShapeRepresentations LayerStyles FillStyles Tags "
	"TagList Normals CoefficientsX CoefficientsY CoefficientsZ Slopes "
	"Widths ReferenceTokens ";

enum ifcxml_kind
ifcxml_kind_of(enum ifc_entity entity, const char *attribute)
{
	if (entity == IFC_SIUNIT && !strcmp(attribute, "Name"))
		return IFCXML_ENUMERATION;
	if (has_name(enumerations, attribute))
		return IFCXML_ENUMERATION;
	if (has_name(strings, attribute))
		return IFCXML_STRING;
	return IFCXML_PLAIN;
}

bool
ifcxml_is_list(enum ifc_entity entity, const char *attribute)
{
	if (!strcmp(attribute, "Coordinates"))
		return entity == IFC_CARTESIANPOINT;
	if (!strcmp(attribute, "Points"))
		return entity != IFC_INDEXEDPOLYCURVE;
	return has_name(lists, attribute);
}

unsigned
ifcxml_row_length(enum ifc_entity entity, const char *attribute)
{
	static const struct {
		enum ifc_entity entity;
		const char *attribute;
		unsigned length;
	} rows[] = {
		{IFC_CARTESIANPOINTLIST2D, "CoordList", 2},
		{IFC_CARTESIANPOINTLIST3D, "CoordList", 3},
		{IFC_TRIANGULATEDFACESET, "CoordIndex", 3},
		{IFC_TRIANGULATEDFACESET, "Normals", 3},
		{IFC_TRIANGULATEDIRREGULARNETWORK, "CoordIndex", 3},
		{IFC_TRIANGULATEDIRREGULARNETWORK, "Normals", 3},
		{IFC_COLOURRGBLIST, "ColourList", 3},
		{IFC_TEXTUREVERTEXLIST, "TexCoordsList", 2},
		{IFC_INDEXEDTRIANGLETEXTUREMAP, "TexCoordIndex", 3},
	};

	for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
		if (rows[i].entity == entity &&
			!strcmp(rows[i].attribute, attribute))
			return rows[i].length;
	return 0;
}

/* ---- instances ----------------------------------------------------------- */

static const struct {
	const char *attribute;
	enum ifc_entity type;
} declared[] = {
	{"OwnerHistory", IFC_OWNERHISTORY},
	{"Location", IFC_CARTESIANPOINT},
	{"LocalOrigin", IFC_CARTESIANPOINT},
	{"Pnt", IFC_CARTESIANPOINT},
	{"Corner", IFC_CARTESIANPOINT},
	{"Axis", IFC_DIRECTION},
	{"RefDirection", IFC_DIRECTION},
	{"Axis1", IFC_DIRECTION},
	{"Axis2", IFC_DIRECTION},
	{"Axis3", IFC_DIRECTION},
	{"ExtrudedDirection", IFC_DIRECTION},
	{"TrueNorth", IFC_DIRECTION},
	{"Orientation", IFC_DIRECTION},
	{"FixedReference", IFC_DIRECTION},
	{"Dir", IFC_VECTOR},
	{"AxisPosition", IFC_AXIS1PLACEMENT},
	{"Position", IFC_AXIS2PLACEMENT3D},
	{"ConditionCoordinateSystem", IFC_AXIS2PLACEMENT3D},
	{"Dimensions", IFC_DIMENSIONALEXPONENTS},
	{"ConversionFactor", IFC_MEASUREWITHUNIT},
	{"UnitsInContext", IFC_UNITASSIGNMENT},
	{"ForLayerSet", IFC_MATERIALLAYERSET},
	{"ForProfileSet", IFC_MATERIALPROFILESET},
	{"ForProfileEndSet", IFC_MATERIALPROFILESET},
	{"Material", IFC_MATERIAL},
	{"RepresentedMaterial", IFC_MATERIAL},
	{"MappingSource", IFC_REPRESENTATIONMAP},
	{"Outer", IFC_CLOSEDSHELL},
	{"SurfaceColour", IFC_COLOURRGB},
	{"Enclosure", IFC_BOUNDINGBOX},
	{"Coordinates", IFC_CARTESIANPOINTLIST3D},
	{"Colours", IFC_COLOURRGBLIST},
	{"BuildingAddress", IFC_POSTALADDRESS},
	{"SiteAddress", IFC_POSTALADDRESS},
	{"ParentContext", IFC_GEOMETRICREPRESENTATIONCONTEXT},
	{"EnumerationReference", IFC_PROPERTYENUMERATION},
	{"EdgeElement", IFC_EDGE},
	{"TexCoords", IFC_TEXTUREVERTEXLIST},
};

enum ifc_entity
ifcxml_declared(enum ifc_entity entity, const char *attribute)
{
	bool in_plane = ifc_is(IFC_4X3, entity, IFC_PARAMETERIZEDPROFILEDEF);

	if (!strcmp(attribute, "Axis") &&
		ifc_is(IFC_4X3, entity, IFC_REVOLVEDAREASOLID))
		return IFC_AXIS1PLACEMENT;
	if (!strcmp(attribute, "Position") && in_plane)
		return IFC_AXIS2PLACEMENT2D;
	if (!strcmp(attribute, "BasisSurface") &&
		entity == IFC_CURVEBOUNDEDPLANE)
		return IFC_PLANE;
	if (!strcmp(attribute, "Operator") &&
		ifc_is(IFC_4X3, entity, IFC_DERIVEDPROFILEDEF))
		return IFC_CARTESIANTRANSFORMATIONOPERATOR2D;
	for (size_t i = 0; i < sizeof declared / sizeof *declared; i++)
		if (!strcmp(declared[i].attribute, attribute))
			return declared[i].type;
	return IFC_NONE;
}

static const struct ifcxml_inverse inverses[] = {
	{"IsDecomposedBy", IFC_RELAGGREGATES, "RelatingObject"},
	{"IsNestedBy", IFC_RELNESTS, "RelatingObject"},
	{"Decomposes", IFC_RELAGGREGATES, "RelatedObjects"},
	{"Nests", IFC_RELNESTS, "RelatedObjects"},
	{"ContainsElements", IFC_RELCONTAINEDINSPATIALSTRUCTURE,
		"RelatingStructure"},
	{"ContainedInStructure", IFC_RELCONTAINEDINSPATIALSTRUCTURE,
		"RelatedElements"},
	{"HasOpenings", IFC_RELVOIDSELEMENT, "RelatingBuildingElement"},
	{"VoidsElements", IFC_RELVOIDSELEMENT, "RelatedOpeningElement"},
	{"HasProjections", IFC_RELPROJECTSELEMENT, "RelatingElement"},
	{"HasFillings", IFC_RELFILLSELEMENT, "RelatingOpeningElement"},
	{"FillsVoids", IFC_RELFILLSELEMENT, "RelatedBuildingElement"},
	{"HasCoverings", IFC_RELCOVERSBLDGELEMENTS, "RelatingBuildingElement"},
	{"BoundedBy", IFC_RELSPACEBOUNDARY, "RelatingSpace"},
	{"IsDefinedBy", IFC_RELDEFINESBYPROPERTIES, "RelatedObjects"},
	{"IsTypedBy", IFC_RELDEFINESBYTYPE, "RelatedObjects"},
	{"Types", IFC_RELDEFINESBYTYPE, "RelatingType"},
	{"ObjectTypeOf", IFC_RELDEFINESBYTYPE, "RelatingType"},
	{"HasAssociations", IFC_RELASSOCIATESMATERIAL, "RelatedObjects"},
	{"IsGroupedBy", IFC_RELASSIGNSTOGROUP, "RelatingGroup"},
	{"StyledByItem", IFC_STYLEDITEM, "Item"},
	{"HasColours", IFC_INDEXEDCOLOURMAP, "MappedTo"},
	{"HasTextures", IFC_INDEXEDTRIANGLETEXTUREMAP, "MappedTo"},
	{"HasCoordinateOperation", IFC_MAPCONVERSION, "SourceCRS"},
	{"HasSubContexts", IFC_GEOMETRICREPRESENTATIONSUBCONTEXT,
		"ParentContext"},
	{"HasRepresentation", IFC_MATERIALDEFINITIONREPRESENTATION,
		"RepresentedMaterial"},
	{"LayerAssignment", IFC_PRESENTATIONLAYERASSIGNMENT, "AssignedItems"},
	{"LayerAssignments", IFC_PRESENTATIONLAYERASSIGNMENT, "AssignedItems"},
};

const struct ifcxml_inverse *
ifcxml_inverse_of(const char *name)
{
	for (size_t i = 0; i < sizeof inverses / sizeof *inverses; i++)
		if (!strcmp(inverses[i].name, name))
			return inverses + i;
	return NULL;
}

bool
ifcxml_type_is_text(const char *type)
{
	return has_name(" IFCLABEL IFCTEXT IFCIDENTIFIER IFCDESCRIPTIVEMEASURE "
			"IFCDATE IFCDATETIME IFCTIME IFCDURATION "
			"IFCURIREFERENCE IFCGLOBALLYUNIQUEID "
			"IFCPRESENTABLETEXT IFCTEXTALIGNMENT IFCBOXALIGNMENT "
			"IFCFONTSTYLE IFCFONTVARIANT IFCFONTWEIGHT ",
		type);
}
