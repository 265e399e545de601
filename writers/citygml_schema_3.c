/* CityGML 3.0; see citygml_schema.h for how to read a row. */
#include "citygml_schema.h"

static const struct schema_row rows[] = {
	{"core", "_Feature", NULL,
		"description:string@g identifier:code@g name:code*@g"},
	{"core", "_FeatureWithLifespan", "_Feature",
		"creationDate:time terminationDate:time validFrom:time "
		"validTo:time"},
	{"core", "_CityObject", "_FeatureWithLifespan",
		"externalReference:external* generalizesTo:link* "
		"relativeToTerrain:terrain relativeToWater:water "
		"relatedTo:set=core* appearance:appearance* "
		"genericAttribute:generic* dynamizer:set=dyn*"},
	{"core", "_Space", "_CityObject",
		"spaceType:spacetype volume:set=core* area:set=core* "
		"boundary:>BOUNDARY* lod0Point:point "
		"lod0MultiSurface:multisurface lod0MultiCurve:multicurve "
		"lod1Solid:solid lod2Solid:solid "
		"lod2MultiSurface:multisurface lod2MultiCurve:multicurve "
		"lod3Solid:solid lod3MultiSurface:multisurface "
		"lod3MultiCurve:multicurve"},
	{"core", "_PhysicalSpace", "_Space",
		"lod1TerrainIntersectionCurve:multicurve "
		"lod2TerrainIntersectionCurve:multicurve "
		"lod3TerrainIntersectionCurve:multicurve "
		"pointCloud:>PointCloud"},
	{"core", "_OccupiedSpace", "_PhysicalSpace",
		"lod1ImplicitRepresentation:implicit "
		"lod2ImplicitRepresentation:implicit "
		"lod3ImplicitRepresentation:implicit"},
	{"con", "_Construction", "_OccupiedSpace",
		"conditionOfConstruction:condition dateOfConstruction:date "
		"dateOfDemolition:date constructionEvent:set=con* "
		"elevation:set=con* height:set=con* occupancy:set=core*"},
	{"brid", "_Bridge", "_Construction",
		"class:code function:code* usage:code* isMovable:boolean "
		"bridgeConstructiveElement:>BridgeConstructionElement* "
		"bridgeInstallation:>BridgeInstallation|IntBridgeInstallation* "
		"bridgeRoom:>BridgeRoom* bridgeFurniture:>BridgeFurniture* "
		"address:address*"},
	{"brid", "Bridge", "_Bridge", "bridgePart:>BridgePart*"},
	{"con", "_ConstructiveElement", "_OccupiedSpace",
		"isStructuralElement:boolean filling:>Window|Door*"},
	{"brid", "BridgeConstructiveElement", "_ConstructiveElement",
		"class:code function:code* usage:code*"},
	{"brid", "BridgeFurniture", "_OccupiedSpace",
		"class:code function:code* usage:code*"},
	{"con", "_Installation", "_OccupiedSpace",
		"relationToConstruction:relation"},
	{"brid", "BridgeInstallation", "_Installation",
		"class:code function:code* usage:code*"},
	{"brid", "BridgePart", "_Bridge", ""},
	{"brid", "BridgeRoom", "_PhysicalSpace",
		"class:code function:code* usage:code* "
		"bridgeFurniture:>BridgeFurniture* "
		"bridgeInstallation:>BridgeInstallation|IntBridgeInstallation*"},
	{"bldg", "_Building", "_Construction",
		"class:code function:code* usage:code* roofType:code "
		"storeysAboveGround:integer storeysBelowGround:integer "
		"storeyHeightsAboveGround:measures "
		"storeyHeightsBelowGround:measures "
		"buildingConstructiveElement:>BuildingConstructiveElement* "
		"buildingInstallation:>BuildingInstallation|IntBuildingInstallation* "
		"buildingRoom:>BuildingRoom* "
		"buildingFurniture:>BuildingFurniture* "
		"buildingSubdivision:>Storey|BuildingUnit* address:address*"},
	{"bldg", "Building", "_Building", "buildingPart:>BuildingPart*"},
	{"bldg", "BuildingConstructiveElement", "_ConstructiveElement",
		"class:code function:code* usage:code*"},
	{"bldg", "BuildingFurniture", "_OccupiedSpace",
		"class:code function:code* usage:code*"},
	{"bldg", "BuildingInstallation", "_Installation",
		"class:code function:code* usage:code*"},
	{"bldg", "BuildingPart", "_Building", ""},
	{"bldg", "BuildingRoom", "_PhysicalSpace",
		"class:code function:code* usage:code* roomHeight:set=bldg* "
		"buildingFurniture:>BuildingFurniture* "
		"buildingInstallation:>BuildingInstallation|IntBuildingInstallation*"},
	{"bldg", "_BuildingSubdivision", "_Space",
		"class:code function:code* usage:code* elevation:set=con* "
		"sortKey:double "
		"buildingConstructiveElement:>BuildingConstructiveElement* "
		"buildingFurniture:>BuildingFurniture* "
		"buildingInstallation:>BuildingInstallation|IntBuildingInstallation* "
		"buildingRoom:>BuildingRoom*"},
	{"bldg", "BuildingUnit", "_BuildingSubdivision",
		"storey:>Storey* address:address*"},
	{"bldg", "Storey", "_BuildingSubdivision",
		"buildingUnit:>BuildingUnit*"},
	{"frn", "CityFurniture", "_OccupiedSpace",
		"class:code function:code* usage:code*"},
	{"grp", "CityObjectGroup", "_Space",
		"class:code function:code* usage:code* groupMember:role* "
		"parent:link"},
	{"core", "_ThematicSurface", "_CityObject",
		"area:set=core* lod0MultiCurve:multicurve "
		"lod0MultiSurface:multisurface "
		"lod1MultiSurface:multisurface "
		"lod2MultiSurface:multisurface "
		"lod3MultiSurface:multisurface pointCloud:>PointCloud"},
	{"con", "_ConstructionSurface", "_ThematicSurface",
		"fillingSurface:>WindowSurface|DoorSurface*"},
	{"con", "CeilingSurface", "_ConstructionSurface", ""},
	{"con", "Door", "_OccupiedSpace",
		"class:code function:code* usage:code* address:address*"},
	{"con", "DoorSurface", "_ThematicSurface", "address:address*"},
	{"con", "FloorSurface", "_ConstructionSurface", ""},
	{"con", "GroundSurface", "_ConstructionSurface", ""},
	{"con", "InteriorWallSurface", "_ConstructionSurface", ""},
	{"con", "OtherConstruction", "_Construction",
		"class:code function:code* usage:code*"},
	{"con", "OuterCeilingSurface", "_ConstructionSurface", ""},
	{"con", "OuterFloorSurface", "_ConstructionSurface", ""},
	{"con", "RoofSurface", "_ConstructionSurface", ""},
	{"con", "WallSurface", "_ConstructionSurface", ""},
	{"con", "Window", "_OccupiedSpace",
		"class:code function:code* usage:code*"},
	{"con", "WindowSurface", "_ThematicSurface", ""},
	{"core", "ClosureSurface", "_ThematicSurface", ""},
	{"gen", "GenericLogicalSpace", "_Space",
		"class:code function:code* usage:code*"},
	{"gen", "GenericOccupiedSpace", "_OccupiedSpace",
		"class:code function:code* usage:code*"},
	{"gen", "GenericThematicSurface", "_ThematicSurface",
		"class:code function:code* usage:code*"},
	{"gen", "GenericUnoccupiedSpace", "_PhysicalSpace",
		"class:code function:code* usage:code*"},
	{"luse", "LandUse", "_ThematicSurface",
		"class:code function:code* usage:code*"},
	{"core", "_PointCloud", "_Feature", ""},
	{"pcl", "PointCloud", "_PointCloud",
		"mimeType:code pointFile:uri pointFileSrsName:string "
		"points:multipoint"},
	{"dem", "_ReliefComponent", "_CityObject", "lod:level! extent:surface"},
	{"dem", "BreaklineRelief", "_ReliefComponent",
		"ridgeOrValleyLines:multicurve breaklines:multicurve"},
	{"dem", "MassPointRelief", "_ReliefComponent",
		"reliefPoints:multipoint pointCloud:>PointCloud"},
	{"dem", "RasterRelief", "_ReliefComponent", "grid:grid"},
	{"dem", "ReliefFeature", "_CityObject",
		"lod:level! "
		"reliefComponent:>TINRelief|MassPointRelief|BreaklineRelief|RasterRelief*"},
	{"dem", "TINRelief", "_ReliefComponent", "tin:tin"},
	{"tran", "AuxiliaryTrafficArea", "_ThematicSurface",
		"class:code function:code* usage:code* surfaceMaterial:code"},
	{"tran", "AuxiliaryTrafficSpace", "_PhysicalSpace",
		"class:code function:code* usage:code* "
		"granularity:granularity!"},
	{"tran", "ClearanceSpace", "_PhysicalSpace", "class:code*"},
	{"tran", "Hole", "_PhysicalSpace", "class:code"},
	{"tran", "HoleSurface", "_ThematicSurface", ""},
	{"tran", "_TransportationSpace", "_PhysicalSpace",
		"trafficDirection:direction occupancy:set=core* "
		"trafficSpace:>TrafficSpace* "
		"auxiliaryTrafficSpace:>AuxiliaryTrafficSpace* hole:>Hole* "
		"marking:>Marking*"},
	{"tran", "Intersection", "_TransportationSpace", "class:code"},
	{"tran", "Marking", "_ThematicSurface", "class:code"},
	{"tran", "Railway", "_TransportationSpace",
		"class:code function:code* usage:code* section:>Section* "
		"intersection:>Intersection*"},
	{"tran", "Road", "_TransportationSpace",
		"class:code function:code* usage:code* section:>Section* "
		"intersection:>Intersection*"},
	{"tran", "Section", "_TransportationSpace", "class:code"},
	{"tran", "Square", "_TransportationSpace",
		"class:code function:code* usage:code*"},
	{"tran", "Track", "_TransportationSpace",
		"class:code function:code* usage:code* section:>Section* "
		"intersection:>Intersection*"},
	{"tran", "TrafficArea", "_ThematicSurface",
		"class:code function:code* usage:code* surfaceMaterial:code"},
	{"tran", "TrafficSpace", "_PhysicalSpace",
		"class:code function:code* usage:code* "
		"granularity:granularity! trafficDirection:direction "
		"occupancy:set=core* predecessor:link* successor:link* "
		"clearanceSpace:>ClearanceSpace*"},
	{"tran", "Waterway", "_TransportationSpace",
		"class:code function:code* usage:code* section:>Section* "
		"intersection:>Intersection*"},
	{"tun", "HollowSpace", "_PhysicalSpace",
		"class:code function:code* usage:code* "
		"tunnelFurniture:>TunnelFurniture* "
		"tunnelInstallation:>TunnelInstallation|IntTunnelInstallation*"},
	{"tun", "_Tunnel", "_Construction",
		"class:code function:code* usage:code* "
		"tunnelConstructiveElement:>TunnelConstructiveElement* "
		"tunnelInstallation:>TunnelInstallation|IntTunnelInstallation* "
		"hollowSpace:>HollowSpace* "
		"tunnelFurniture:>TunnelFurniture*"},
	{"tun", "Tunnel", "_Tunnel", "tunnelPart:>TunnelPart*"},
	{"tun", "TunnelConstructiveElement", "_ConstructiveElement",
		"class:code function:code* usage:code*"},
	{"tun", "TunnelFurniture", "_OccupiedSpace",
		"class:code function:code* usage:code*"},
	{"tun", "TunnelInstallation", "_Installation",
		"class:code function:code* usage:code*"},
	{"tun", "TunnelPart", "_Tunnel", ""},
	{"veg", "PlantCover", "_OccupiedSpace",
		"class:code function:code* usage:code* "
		"averageHeight:measure minHeight:measure maxHeight:measure"},
	{"veg", "SolitaryVegetationObject", "_OccupiedSpace",
		"class:code function:code* usage:code* species:code "
		"height:measure trunkDiameter:measure crownDiameter:measure "
		"rootBallDiameter:measure maxRootBallDepth:measure"},
	{"wtr", "WaterBody", "_OccupiedSpace",
		"class:code function:code* usage:code*"},
	{"wtr", "WaterGroundSurface", "_ThematicSurface", ""},
	{"wtr", "WaterSurface", "_ThematicSurface", "waterLevel:code"},
};

const struct schema_table schema_table_3 = {rows, sizeof rows / sizeof *rows};
