/* CityGML 1.0 and 2.0; see citygml_schema.h for how to read a row. */
#include "citygml_schema.h"

/* Surfaces of bridges and tunnels are the same, in their own module. */
static const struct schema_row rows[] = {
	{"core", "_CityObject", NULL,
		"description:string@g name:code*@g creationDate:date "
		"terminationDate:date externalReference:external* "
		"generalizesTo:link* relativeToTerrain:terrain@2 "
		"relativeToWater:water@2 generic:generic* "
		"appearance:appearance*"},
	{"brid", "_Bridge", "_CityObject",
		"class:code function:code* usage:code* "
		"yearOfConstruction:year yearOfDemolition:year "
		"isMovable:boolean lod1Solid:solid "
		"lod1MultiSurface:multisurface "
		"lod1TerrainIntersection:multicurve lod2Solid:solid "
		"lod2MultiSurface:multisurface lod2MultiCurve:multicurve "
		"lod2TerrainIntersection:multicurve "
		"outerBridgeConstruction:>BridgeConstructionElement* "
		"outerBridgeInstallation:>BridgeInstallation* "
		"interiorBridgeInstallation:>IntBridgeInstallation* "
		"boundedBy:>SURFACE* lod3Solid:solid "
		"lod3MultiSurface:multisurface lod3MultiCurve:multicurve "
		"lod3TerrainIntersection:multicurve lod4Solid:solid "
		"lod4MultiSurface:multisurface lod4MultiCurve:multicurve "
		"lod4TerrainIntersection:multicurve "
		"interiorBridgeRoom:>BridgeRoom* "
		"consistsOfBridgePart:>BridgePart* address:address*"},
	{"brid", "Bridge", "_Bridge", ""},
	{"brid", "BridgePart", "_Bridge", ""},
	{"brid", "BridgeInstallation", "_CityObject",
		"class:code function:code* usage:code* "
		"lod2Geometry:geometry lod3Geometry:geometry "
		"lod4Geometry:geometry lod2ImplicitRepresentation:implicit "
		"lod3ImplicitRepresentation:implicit "
		"lod4ImplicitRepresentation:implicit boundedBy:>SURFACE*"},
	{"brid", "IntBridgeInstallation", "_CityObject",
		"class:code function:code* usage:code* "
		"lod4Geometry:geometry lod4ImplicitRepresentation:implicit "
		"boundedBy:>SURFACE*"},
	{"brid", "BridgeConstructionElement", "_CityObject",
		"class:code function:code* usage:code* "
		"lod1Geometry:geometry lod2Geometry:geometry "
		"lod3Geometry:geometry lod4Geometry:geometry "
		"lod1TerrainIntersection:multicurve "
		"lod2TerrainIntersection:multicurve "
		"lod3TerrainIntersection:multicurve "
		"lod4TerrainIntersection:multicurve "
		"lod1ImplicitRepresentation:implicit "
		"lod2ImplicitRepresentation:implicit "
		"lod3ImplicitRepresentation:implicit "
		"lod4ImplicitRepresentation:implicit boundedBy:>SURFACE*"},
	{"bldg", "_BoundarySurface", "_CityObject",
		"lod2MultiSurface:multisurface "
		"lod3MultiSurface:multisurface "
		"lod4MultiSurface:multisurface opening:>Window|Door*"},
	{"bldg", "RoofSurface", "_BoundarySurface", ""},
	{"bldg", "WallSurface", "_BoundarySurface", ""},
	{"bldg", "GroundSurface", "_BoundarySurface", ""},
	{"bldg", "ClosureSurface", "_BoundarySurface", ""},
	{"bldg", "OuterFloorSurface", "_BoundarySurface", ""},
	{"bldg", "OuterCeilingSurface", "_BoundarySurface", ""},
	{"bldg", "FloorSurface", "_BoundarySurface", ""},
	{"bldg", "InteriorWallSurface", "_BoundarySurface", ""},
	{"bldg", "CeilingSurface", "_BoundarySurface", ""},
	{"bldg", "_Opening", "_CityObject",
		"lod3MultiSurface:multisurface "
		"lod4MultiSurface:multisurface "
		"lod3ImplicitRepresentation:implicit@2 "
		"lod4ImplicitRepresentation:implicit@2"},
	{"bldg", "Window", "_Opening", ""},
	{"bldg", "Door", "_Opening", "address:address*"},
	{"brid", "BridgeRoom", "_CityObject",
		"class:code function:code* usage:code* lod4Solid:solid "
		"lod4MultiSurface:multisurface boundedBy:>SURFACE* "
		"interiorFurniture:>BridgeFurniture* "
		"bridgeRoomInstallation:>IntBridgeInstallation*"},
	{"brid", "BridgeFurniture", "_CityObject",
		"class:code function:code* usage:code* "
		"lod4Geometry:geometry lod4ImplicitRepresentation:implicit"},
	{"bldg", "_Building", "_CityObject",
		"class:code function:code* usage:code* "
		"yearOfConstruction:year yearOfDemolition:year "
		"roofType:code measuredHeight:measure "
		"storeysAboveGround:count storeysBelowGround:count "
		"storeyHeightsAboveGround:measures "
		"storeyHeightsBelowGround:measures "
		"lod0FootPrint:multisurface@2 lod0RoofEdge:multisurface@2 "
		"lod1Solid:solid lod1MultiSurface:multisurface "
		"lod1TerrainIntersection:multicurve lod2Solid:solid "
		"lod2MultiSurface:multisurface lod2MultiCurve:multicurve "
		"lod2TerrainIntersection:multicurve "
		"outerBuildingInstallation:>BuildingInstallation* "
		"interiorBuildingInstallation:>IntBuildingInstallation* "
		"boundedBy:>SURFACE* lod3Solid:solid "
		"lod3MultiSurface:multisurface lod3MultiCurve:multicurve "
		"lod3TerrainIntersection:multicurve lod4Solid:solid "
		"lod4MultiSurface:multisurface lod4MultiCurve:multicurve "
		"lod4TerrainIntersection:multicurve "
		"interiorRoom:>BuildingRoom* "
		"consistsOfBuildingPart:>BuildingPart* address:address*"},
	{"bldg", "Building", "_Building", ""},
	{"bldg", "BuildingPart", "_Building", ""},
	{"bldg", "BuildingInstallation", "_CityObject",
		"class:code function:code* usage:code* "
		"lod2Geometry:geometry lod3Geometry:geometry "
		"lod4Geometry:geometry "
		"lod2ImplicitRepresentation:implicit@2 "
		"lod3ImplicitRepresentation:implicit@2 "
		"lod4ImplicitRepresentation:implicit@2 "
		"boundedBy:>SURFACE*@2"},
	{"bldg", "IntBuildingInstallation", "_CityObject",
		"class:code function:code* usage:code* "
		"lod4Geometry:geometry "
		"lod4ImplicitRepresentation:implicit@2 "
		"boundedBy:>SURFACE*@2"},
	{"bldg", "Room", "_CityObject",
		"class:code function:code* usage:code* lod4Solid:solid "
		"lod4MultiSurface:multisurface boundedBy:>SURFACE* "
		"interiorFurniture:>BuildingFurniture* "
		"roomInstallation:>IntBuildingInstallation*"},
	{"bldg", "BuildingFurniture", "_CityObject",
		"class:code function:code* usage:code* "
		"lod4Geometry:geometry lod4ImplicitRepresentation:implicit"},
	{"frn", "CityFurniture", "_CityObject",
		"class:code function:code* usage:code*@2 "
		"lod1Geometry:geometry lod2Geometry:geometry "
		"lod3Geometry:geometry lod4Geometry:geometry "
		"lod1TerrainIntersection:multicurve "
		"lod2TerrainIntersection:multicurve "
		"lod3TerrainIntersection:multicurve "
		"lod4TerrainIntersection:multicurve "
		"lod1ImplicitRepresentation:implicit "
		"lod2ImplicitRepresentation:implicit "
		"lod3ImplicitRepresentation:implicit "
		"lod4ImplicitRepresentation:implicit"},
	{"grp", "CityObjectGroup", "_CityObject",
		"class:code function:code* usage:code* groupMember:member* "
		"parent:link geometry:geometry"},
	{"gen", "GenericCityObject", "_CityObject",
		"class:code function:code* usage:code* "
		"lod0Geometry:geometry lod1Geometry:geometry "
		"lod2Geometry:geometry lod3Geometry:geometry "
		"lod4Geometry:geometry lod0TerrainIntersection:multicurve "
		"lod1TerrainIntersection:multicurve "
		"lod2TerrainIntersection:multicurve "
		"lod3TerrainIntersection:multicurve "
		"lod4TerrainIntersection:multicurve "
		"lod0ImplicitRepresentation:implicit "
		"lod1ImplicitRepresentation:implicit "
		"lod2ImplicitRepresentation:implicit "
		"lod3ImplicitRepresentation:implicit "
		"lod4ImplicitRepresentation:implicit"},
	{"luse", "LandUse", "_CityObject",
		"class:code function:code* usage:code* "
		"lod0MultiSurface:multisurface "
		"lod1MultiSurface:multisurface "
		"lod2MultiSurface:multisurface "
		"lod3MultiSurface:multisurface "
		"lod4MultiSurface:multisurface"},
	{"dem", "ReliefFeature", "_CityObject",
		"lod:level! "
		"reliefComponent:>TINRelief|MassPointRelief|BreaklineRelief|RasterRelief*"},
	{"dem", "_ReliefComponent", "_CityObject", "lod:level! extent:polygon"},
	{"dem", "TINRelief", "_ReliefComponent", "tin:tin"},
	{"dem", "RasterRelief", "_ReliefComponent", "grid:grid"},
	{"dem", "MassPointRelief", "_ReliefComponent",
		"reliefPoints:multipoint"},
	{"dem", "BreaklineRelief", "_ReliefComponent",
		"ridgeOrValleyLines:multicurve breaklines:multicurve"},
	{"tran", "TransportationComplex", "_CityObject",
		"class:code@2 function:code* usage:code* "
		"trafficArea:>TrafficArea* "
		"auxiliaryTrafficArea:>AuxiliaryTrafficArea* "
		"lod0Network:complex* lod1MultiSurface:multisurface "
		"lod2MultiSurface:multisurface "
		"lod3MultiSurface:multisurface "
		"lod4MultiSurface:multisurface"},
	{"tran", "TrafficArea", "_CityObject",
		"class:code@2 function:code*@2 usage:code* function:code*@1 "
		"surfaceMaterial:code lod2MultiSurface:multisurface "
		"lod3MultiSurface:multisurface "
		"lod4MultiSurface:multisurface"},
	{"tran", "AuxiliaryTrafficArea", "_CityObject",
		"class:code@2 function:code* usage:code*@2 "
		"surfaceMaterial:code lod2MultiSurface:multisurface "
		"lod3MultiSurface:multisurface "
		"lod4MultiSurface:multisurface"},
	{"tran", "Track", "TransportationComplex", ""},
	{"tran", "Road", "TransportationComplex", ""},
	{"tran", "Railway", "TransportationComplex", ""},
	{"tran", "Square", "TransportationComplex", ""},
	{"tun", "_Tunnel", "_CityObject",
		"class:code function:code* usage:code* "
		"yearOfConstruction:year yearOfDemolition:year "
		"lod1Solid:solid lod1MultiSurface:multisurface "
		"lod1TerrainIntersection:multicurve lod2Solid:solid "
		"lod2MultiSurface:multisurface lod2MultiCurve:multicurve "
		"lod2TerrainIntersection:multicurve "
		"outerTunnelInstallation:>TunnelInstallation* "
		"interiorTunnelInstallation:>IntTunnelInstallation* "
		"boundedBy:>SURFACE* lod3Solid:solid "
		"lod3MultiSurface:multisurface lod3MultiCurve:multicurve "
		"lod3TerrainIntersection:multicurve lod4Solid:solid "
		"lod4MultiSurface:multisurface lod4MultiCurve:multicurve "
		"lod4TerrainIntersection:multicurve "
		"interiorHollowSpace:>HollowSpace* "
		"consistsOfTunnelPart:>TunnelPart*"},
	{"tun", "Tunnel", "_Tunnel", ""},
	{"tun", "TunnelPart", "_Tunnel", ""},
	{"tun", "TunnelInstallation", "_CityObject",
		"class:code function:code* usage:code* "
		"lod2Geometry:geometry lod3Geometry:geometry "
		"lod4Geometry:geometry lod2ImplicitRepresentation:implicit "
		"lod3ImplicitRepresentation:implicit "
		"lod4ImplicitRepresentation:implicit boundedBy:>SURFACE*"},
	{"tun", "IntTunnelInstallation", "_CityObject",
		"class:code function:code* usage:code* "
		"lod4Geometry:geometry lod4ImplicitRepresentation:implicit "
		"boundedBy:>SURFACE*"},
	{"tun", "HollowSpace", "_CityObject",
		"class:code function:code* usage:code* lod4Solid:solid "
		"lod4MultiSurface:multisurface boundedBy:>SURFACE* "
		"interiorFurniture:>TunnelFurniture* "
		"hollowSpaceInstallation:>IntTunnelInstallation*"},
	{"tun", "TunnelFurniture", "_CityObject",
		"class:code function:code* usage:code* "
		"lod4Geometry:geometry lod4ImplicitRepresentation:implicit"},
	{"veg", "PlantCover", "_CityObject",
		"class:code function:code* usage:code*@2 "
		"averageHeight:measure lod1MultiSurface:multisurface "
		"lod2MultiSurface:multisurface "
		"lod3MultiSurface:multisurface "
		"lod4MultiSurface:multisurface lod1MultiSolid:multisolid "
		"lod2MultiSolid:multisolid lod3MultiSolid:multisolid "
		"lod4MultiSolid:multisolid@2"},
	{"veg", "SolitaryVegetationObject", "_CityObject",
		"class:code function:code* usage:code*@2 species:code "
		"height:measure trunkDiameter:measure crownDiameter:measure "
		"lod1Geometry:geometry lod2Geometry:geometry "
		"lod3Geometry:geometry lod4Geometry:geometry "
		"lod1ImplicitRepresentation:implicit "
		"lod2ImplicitRepresentation:implicit "
		"lod3ImplicitRepresentation:implicit "
		"lod4ImplicitRepresentation:implicit"},
	{"wtr", "WaterBody", "_CityObject",
		"class:code function:code* usage:code* "
		"lod0MultiCurve:multicurve lod0MultiSurface:multisurface "
		"lod1MultiCurve:multicurve lod1MultiSurface:multisurface "
		"lod1Solid:solid lod2Solid:solid lod3Solid:solid "
		"lod4Solid:solid "
		"boundedBy:>WaterSurface|WaterGroundSurface|WaterClosureSurface*"},
	{"wtr", "_WaterBoundarySurface", "_CityObject",
		"lod2Surface:surface lod3Surface:surface "
		"lod4Surface:surface"},
	{"wtr", "WaterSurface", "_WaterBoundarySurface", "waterLevel:code"},
	{"wtr", "WaterGroundSurface", "_WaterBoundarySurface", ""},
	{"wtr", "WaterClosureSurface", "_WaterBoundarySurface", ""},
};

const struct schema_table schema_table_2 = {rows, sizeof rows / sizeof *rows};
