/*
 * Relations, properties, materials, units, representations, presentation.
 * X(entity, supertype, versions, "attributes"), as ifc_schema.h says.
 */
#ifndef TESSERA_IFC_ROWS_RELATION_H
#define TESSERA_IFC_ROWS_RELATION_H

#define IFC_RELATION_ROWS(X) \
	X(RELATIONSHIP, ROOT, "245", "") \
	X(RELDECOMPOSES, RELATIONSHIP, "245", \
		"RelatingObject:2 RelatedObjects:2") \
	X(RELAGGREGATES, RELDECOMPOSES, "245", \
		"RelatingObject:45 RelatedObjects:45") \
	X(RELNESTS, RELDECOMPOSES, "245", \
		"RelatingObject:45 RelatedObjects:45") \
	X(RELCONNECTS, RELATIONSHIP, "245", "") \
	X(RELVOIDSELEMENT, RELDECOMPOSES, "245", \
		"RelatingBuildingElement RelatedOpeningElement") \
	X(RELPROJECTSELEMENT, RELDECOMPOSES, "245", \
		"RelatingElement RelatedFeatureElement") \
	X(RELADHERESTOELEMENT, RELDECOMPOSES, "5", \
		"RelatingElement RelatedSurfaceFeatures") \
	X(RELFILLSELEMENT, RELCONNECTS, "245", \
		"RelatingOpeningElement RelatedBuildingElement") \
	X(RELCONTAINEDINSPATIALSTRUCTURE, RELCONNECTS, "245", \
		"RelatedElements RelatingStructure") \
	X(RELREFERENCEDINSPATIALSTRUCTURE, RELCONNECTS, "245", \
		"RelatedElements RelatingStructure") \
	X(RELCOVERSBLDGELEMENTS, RELCONNECTS, "245", \
		"RelatingBuildingElement RelatedCoverings") \
	X(RELCOVERSSPACES, RELCONNECTS, "245", \
		"RelatingSpace RelatedCoverings") \
	X(RELCONNECTSELEMENTS, RELCONNECTS, "245", \
		"ConnectionGeometry RelatingElement RelatedElement") \
	X(RELCONNECTSPATHELEMENTS, RELCONNECTSELEMENTS, "245", \
		"RelatingPriorities RelatedPriorities " \
		"RelatedConnectionType RelatingConnectionType") \
	X(RELCONNECTSPORTS, RELCONNECTS, "245", \
		"RelatingPort RelatedPort RealizingElement") \
	X(RELCONNECTSPORTTOELEMENT, RELCONNECTS, "245", \
		"RelatingPort RelatedElement") \
	X(RELPOSITIONS, RELCONNECTS, "5", \
		"RelatingPositioningElement RelatedProducts") \
	X(RELSERVICESBUILDINGS, RELCONNECTS, "245", \
		"RelatingSystem RelatedBuildings") \
	X(RELSPACEBOUNDARY, RELCONNECTS, "245", \
		"RelatingSpace RelatedBuildingElement ConnectionGeometry " \
		"PhysicalOrVirtualBoundary InternalOrExternalBoundary") \
	X(RELSPACEBOUNDARY1STLEVEL, RELSPACEBOUNDARY, "45", "ParentBoundary") \
	X(RELSPACEBOUNDARY2NDLEVEL, RELSPACEBOUNDARY1STLEVEL, "45", \
		"CorrespondingBoundary") \
	X(RELDEFINES, RELATIONSHIP, "245", "RelatedObjects:2") \
	X(RELDEFINESBYPROPERTIES, RELDEFINES, "245", \
		"RelatedObjects:45 RelatingPropertyDefinition") \
	X(RELOVERRIDESPROPERTIES, RELDEFINESBYPROPERTIES, "2", \
		"OverridingProperties") \
	X(RELDEFINESBYTYPE, RELDEFINES, "245", \
		"RelatedObjects:45 RelatingType") \
	X(RELDEFINESBYOBJECT, RELDEFINES, "45", \
		"RelatedObjects RelatingObject") \
	X(RELDEFINESBYTEMPLATE, RELDEFINES, "45", \
		"RelatedPropertySets RelatingTemplate") \
	X(RELDECLARES, RELATIONSHIP, "45", \
		"RelatingContext RelatedDefinitions") \
	X(RELASSOCIATES, RELATIONSHIP, "245", "RelatedObjects") \
	X(RELASSOCIATESCLASSIFICATION, RELASSOCIATES, "245", \
		"RelatingClassification") \
	X(RELASSOCIATESDOCUMENT, RELASSOCIATES, "245", "RelatingDocument") \
	X(RELASSOCIATESLIBRARY, RELASSOCIATES, "245", "RelatingLibrary") \
	X(RELASSOCIATESMATERIAL, RELASSOCIATES, "245", "RelatingMaterial") \
	X(RELASSIGNS, RELATIONSHIP, "245", \
		"RelatedObjects RelatedObjectsType") \
	X(RELASSIGNSTOGROUP, RELASSIGNS, "245", "RelatingGroup") \
	X(RELASSIGNSTOPRODUCT, RELASSIGNS, "245", "RelatingProduct") \
	X(PROPERTYDEFINITION, ROOT, "245", "") \
	X(PROPERTYSETDEFINITION, PROPERTYDEFINITION, "245", "") \
	X(PROPERTYSET, PROPERTYSETDEFINITION, "245", "HasProperties") \
	X(QUANTITYSET, PROPERTYSETDEFINITION, "45", "") \
	X(ELEMENTQUANTITY, QUANTITYSET, "245", \
		"MethodOfMeasurement Quantities") \
	X(PROPERTY, NONE, "245", "Name Description") \
	X(SIMPLEPROPERTY, PROPERTY, "245", "") \
	X(PROPERTYSINGLEVALUE, SIMPLEPROPERTY, "245", "NominalValue Unit") \
	X(PROPERTYENUMERATEDVALUE, SIMPLEPROPERTY, "245", \
		"EnumerationValues EnumerationReference") \
	X(PROPERTYBOUNDEDVALUE, SIMPLEPROPERTY, "245", \
		"UpperBoundValue LowerBoundValue Unit SetPointValue:45") \
	X(PROPERTYLISTVALUE, SIMPLEPROPERTY, "245", "ListValues Unit") \
	X(PROPERTYTABLEVALUE, SIMPLEPROPERTY, "245", \
		"DefiningValues DefinedValues Expression DefiningUnit " \
		"DefinedUnit CurveInterpolation:45") \
	X(PROPERTYREFERENCEVALUE, SIMPLEPROPERTY, "245", \
		"UsageName PropertyReference") \
	X(COMPLEXPROPERTY, PROPERTY, "245", "UsageName HasProperties") \
	X(PROPERTYENUMERATION, NONE, "245", "Name EnumerationValues Unit") \
	X(PHYSICALQUANTITY, NONE, "245", "Name Description") \
	X(PHYSICALSIMPLEQUANTITY, PHYSICALQUANTITY, "245", "Unit") \
	X(QUANTITYLENGTH, PHYSICALSIMPLEQUANTITY, "245", \
		"LengthValue Formula:45") \
	X(QUANTITYAREA, PHYSICALSIMPLEQUANTITY, "245", "AreaValue Formula:45") \
	X(QUANTITYVOLUME, PHYSICALSIMPLEQUANTITY, "245", \
		"VolumeValue Formula:45") \
	X(QUANTITYCOUNT, PHYSICALSIMPLEQUANTITY, "245", \
		"CountValue Formula:45") \
	X(QUANTITYWEIGHT, PHYSICALSIMPLEQUANTITY, "245", \
		"WeightValue Formula:45") \
	X(QUANTITYTIME, PHYSICALSIMPLEQUANTITY, "245", "TimeValue Formula:45") \
	X(PHYSICALCOMPLEXQUANTITY, PHYSICALQUANTITY, "245", \
		"HasQuantities Discrimination Quality Usage") \
	X(MATERIALDEFINITION, NONE, "45", "") \
	X(MATERIAL, MATERIALDEFINITION, "245", \
		"Name Description:45 Category:45") \
	X(MATERIALLAYER, MATERIALDEFINITION, "245", \
		"Material LayerThickness IsVentilated Name:45 " \
		"Description:45 Category:45 Priority:45") \
	X(MATERIALLAYERWITHOFFSETS, MATERIALLAYER, "45", \
		"OffsetDirection OffsetValues") \
	X(MATERIALLAYERSET, MATERIALDEFINITION, "245", \
		"MaterialLayers LayerSetName Description:45") \
	X(MATERIALCONSTITUENT, MATERIALDEFINITION, "45", \
		"Name Description Material Fraction Category") \
	X(MATERIALCONSTITUENTSET, MATERIALDEFINITION, "45", \
		"Name Description MaterialConstituents") \
	X(MATERIALPROFILE, MATERIALDEFINITION, "45", \
		"Name Description Material Profile Priority Category") \
	X(MATERIALPROFILEWITHOFFSETS, MATERIALPROFILE, "45", "OffsetValues") \
	X(MATERIALPROFILESET, MATERIALDEFINITION, "45", \
		"Name Description MaterialProfiles CompositeProfile") \
	X(MATERIALUSAGEDEFINITION, NONE, "45", "") \
	X(MATERIALLAYERSETUSAGE, MATERIALUSAGEDEFINITION, "245", \
		"ForLayerSet LayerSetDirection DirectionSense " \
		"OffsetFromReferenceLine ReferenceExtent:45") \
	X(MATERIALPROFILESETUSAGE, MATERIALUSAGEDEFINITION, "45", \
		"ForProfileSet CardinalPoint ReferenceExtent") \
	X(MATERIALPROFILESETUSAGETAPERING, MATERIALPROFILESETUSAGE, "45", \
		"ForProfileEndSet CardinalEndPoint") \
	X(MATERIALLIST, NONE, "245", "Materials") \
	X(UNITASSIGNMENT, NONE, "245", "Units") \
	X(NAMEDUNIT, NONE, "245", "Dimensions UnitType") \
	X(SIUNIT, NAMEDUNIT, "245", "Prefix Name") \
	X(CONVERSIONBASEDUNIT, NAMEDUNIT, "245", "Name ConversionFactor") \
	X(CONVERSIONBASEDUNITWITHOFFSET, CONVERSIONBASEDUNIT, "45", \
		"ConversionOffset") \
	X(CONTEXTDEPENDENTUNIT, NAMEDUNIT, "245", "Name") \
	X(DERIVEDUNIT, NONE, "245", \
		"Elements UnitType UserDefinedType Name:5") \
	X(DERIVEDUNITELEMENT, NONE, "245", "Unit Exponent") \
	X(MEASUREWITHUNIT, NONE, "245", "ValueComponent UnitComponent") \
	X(MONETARYUNIT, NONE, "245", "Currency") \
	X(DIMENSIONALEXPONENTS, NONE, "245", \
		"LengthExponent MassExponent TimeExponent " \
		"ElectricCurrentExponent ThermodynamicTemperatureExponent " \
		"AmountOfSubstanceExponent LuminousIntensityExponent") \
	X(OWNERHISTORY, NONE, "245", \
		"OwningUser OwningApplication State ChangeAction " \
		"LastModifiedDate LastModifyingUser " \
		"LastModifyingApplication CreationDate") \
	X(APPLICATION, NONE, "245", \
		"ApplicationDeveloper Version ApplicationFullName " \
		"ApplicationIdentifier") \
	X(PERSON, NONE, "245", "Identification FamilyName GivenName") \
	X(ORGANIZATION, NONE, "245", "Identification Name Description") \
	X(PERSONANDORGANIZATION, NONE, "245", \
		"ThePerson TheOrganization Roles") \
	X(ADDRESS, NONE, "245", "Purpose Description UserDefinedPurpose") \
	X(POSTALADDRESS, ADDRESS, "245", \
		"InternalLocation AddressLines PostalBox Town Region " \
		"PostalCode Country") \
	X(CLASSIFICATION, NONE, "245", \
		"Source Edition EditionDate Name Description:45 " \
		"Specification:45 ReferenceTokens:45") \
	X(EXTERNALREFERENCE, NONE, "245", "Location Identification Name") \
	X(CLASSIFICATIONREFERENCE, EXTERNALREFERENCE, "245", \
		"ReferencedSource Description:45 Sort:45") \
	X(COORDINATEREFERENCESYSTEM, NONE, "45", \
		"Name Description GeodeticDatum VerticalDatum:4") \
	X(PROJECTEDCRS, COORDINATEREFERENCESYSTEM, "45", \
		"VerticalDatum:5 MapProjection MapZone MapUnit") \
	X(GEOGRAPHICCRS, COORDINATEREFERENCESYSTEM, "5", \
		"PrimeMeridian AngleUnit HeightUnit") \
	X(COORDINATEOPERATION, NONE, "45", "SourceCRS TargetCRS") \
	X(MAPCONVERSION, COORDINATEOPERATION, "45", \
		"Eastings Northings OrthogonalHeight XAxisAbscissa " \
		"XAxisOrdinate Scale") \
	X(MAPCONVERSIONSCALED, MAPCONVERSION, "5", "FactorX FactorY FactorZ") \
	X(RIGIDOPERATION, COORDINATEOPERATION, "5", \
		"FirstCoordinate SecondCoordinate Height") \
	X(PRODUCTREPRESENTATION, NONE, "245", \
		"Name Description Representations") \
	X(PRODUCTDEFINITIONSHAPE, PRODUCTREPRESENTATION, "245", "") \
	X(MATERIALDEFINITIONREPRESENTATION, PRODUCTREPRESENTATION, "245", \
		"RepresentedMaterial") \
	X(REPRESENTATION, NONE, "245", \
		"ContextOfItems RepresentationIdentifier " \
		"RepresentationType Items") \
	X(SHAPEMODEL, REPRESENTATION, "245", "") \
	X(SHAPEREPRESENTATION, SHAPEMODEL, "245", "") \
	X(TOPOLOGYREPRESENTATION, SHAPEMODEL, "245", "") \
	X(STYLEMODEL, REPRESENTATION, "245", "") \
	X(STYLEDREPRESENTATION, STYLEMODEL, "245", "") \
	X(REPRESENTATIONMAP, NONE, "245", \
		"MappingOrigin MappedRepresentation") \
	X(SHAPEASPECT, NONE, "245", \
		"ShapeRepresentations Name Description " \
		"ProductDefinitional PartOfProductDefinitionShape") \
	X(REPRESENTATIONCONTEXT, NONE, "245", "ContextIdentifier ContextType") \
	X(GEOMETRICREPRESENTATIONCONTEXT, REPRESENTATIONCONTEXT, "245", \
		"CoordinateSpaceDimension Precision WorldCoordinateSystem " \
		"TrueNorth") \
	X(GEOMETRICREPRESENTATIONSUBCONTEXT, GEOMETRICREPRESENTATIONCONTEXT, \
		"245", \
		"ParentContext TargetScale TargetView " \
		"UserDefinedTargetView") \
	X(OBJECTPLACEMENT, NONE, "245", "PlacementRelTo:5") \
	X(LOCALPLACEMENT, OBJECTPLACEMENT, "245", \
		"PlacementRelTo:24 RelativePlacement") \
	X(GRIDPLACEMENT, OBJECTPLACEMENT, "245", \
		"PlacementLocation PlacementRefDirection") \
	X(LINEARPLACEMENT, OBJECTPLACEMENT, "5", \
		"RelativePlacement CartesianPosition") \
	X(GRIDAXIS, NONE, "245", "AxisTag AxisCurve SameSense") \
	X(VIRTUALGRIDINTERSECTION, NONE, "245", \
		"IntersectingAxes OffsetDistances") \
	X(STYLEDITEM, REPRESENTATIONITEM, "245", "Item Styles Name") \
	X(PRESENTATIONSTYLEASSIGNMENT, NONE, "24", "Styles") \
	X(PRESENTATIONSTYLE, NONE, "245", "Name") \
	X(SURFACESTYLE, PRESENTATIONSTYLE, "245", "Side Styles") \
	X(CURVESTYLE, PRESENTATIONSTYLE, "245", \
		"CurveFont CurveWidth CurveColour ModelOrDraughting:45") \
	X(FILLAREASTYLE, PRESENTATIONSTYLE, "245", \
		"FillStyles ModelOrDraughting:45") \
	X(SURFACESTYLESHADING, NONE, "245", "SurfaceColour Transparency:45") \
	X(SURFACESTYLERENDERING, SURFACESTYLESHADING, "245", \
		"Transparency:2 DiffuseColour TransmissionColour " \
		"DiffuseTransmissionColour ReflectionColour " \
		"SpecularColour SpecularHighlight ReflectanceMethod") \
	X(SURFACESTYLEWITHTEXTURES, NONE, "245", "Textures") \
	X(COLOURSPECIFICATION, NONE, "245", "Name") \
	X(COLOURRGB, COLOURSPECIFICATION, "245", "Red Green Blue") \
	X(COLOURRGBLIST, NONE, "45", "ColourList") \
	X(PREDEFINEDITEM, NONE, "245", "Name") \
	X(PREDEFINEDCOLOUR, PREDEFINEDITEM, "245", "") \
	X(DRAUGHTINGPREDEFINEDCOLOUR, PREDEFINEDCOLOUR, "245", "") \
	X(INDEXEDCOLOURMAP, NONE, "45", \
		"MappedTo Opacity Colours ColourIndex") \
	X(SURFACETEXTURE, NONE, "245", \
		"RepeatS RepeatT TextureType:2 Mode:45 TextureTransform " \
		"Parameter:45") \
	X(IMAGETEXTURE, SURFACETEXTURE, "245", "URLReference") \
	X(BLOBTEXTURE, SURFACETEXTURE, "245", "RasterFormat RasterCode") \
	X(PIXELTEXTURE, SURFACETEXTURE, "245", \
		"Width Height ColourComponents Pixel") \
	X(TEXTURECOORDINATE, NONE, "245", "Maps:45") \
	X(INDEXEDTEXTUREMAP, TEXTURECOORDINATE, "45", "MappedTo TexCoords") \
	X(INDEXEDTRIANGLETEXTUREMAP, INDEXEDTEXTUREMAP, "45", "TexCoordIndex") \
	X(TEXTUREVERTEXLIST, NONE, "45", "TexCoordsList") \
	X(PRESENTATIONLAYERASSIGNMENT, NONE, "245", \
		"Name Description AssignedItems Identifier") \
	X(PRESENTATIONLAYERWITHSTYLE, PRESENTATIONLAYERASSIGNMENT, "245", \
		"LayerOn LayerFrozen LayerBlocked LayerStyles")

#endif
