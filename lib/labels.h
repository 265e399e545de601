/*
 * The classes of features: the stream's labels and what CityGML calls them.
 *
 * One table for all stages. Numbers are part of the stream format (tcs(5)):
 * new classes get new numbers, old ones keep theirs. The label is the
 * CityGML 3.0 name except where 2.0 tells apart what 3.0 does not; a label
 * without a name in a version has no class of its own there.
 *
 * source: CityGML 1.0 and 2.0 (OGC 08-007r1, 12-019), clause 10;
 * CityGML 3.0 (OGC 20-010), clause 7.
 */
#ifndef TESSERA_LABELS_H
#define TESSERA_LABELS_H

#include <stddef.h>
#include <stdint.h>

enum label_kind {
	LABEL_OBJECT, /* stands by itself: a building, a road */
	LABEL_PART, /* a part or installation of an object, a room */
	LABEL_SURFACE, /* a boundary surface; shares its host's LODs */
	LABEL_OPENING, /* a door or window; shares its host's LODs */
};

/*
 * X(number, LABEL, kind, module in 1.0 and 2.0, name there, module in 3.0,
 *   name there, colour as 0xRRGGBB)
 * "-" : no such class in that version.
 */
#define TCS_CLASSES(X) \
	X(0, Unknown, OBJECT, "-", "-", "-", "-", 0xb0b0b0) \
	X(1, Building, OBJECT, "bldg", "Building", "bldg", "Building", \
		0xd6cfc4) \
	X(2, BuildingPart, PART, "bldg", "BuildingPart", "bldg", \
		"BuildingPart", 0xd6cfc4) \
	X(3, BuildingInstallation, PART, "bldg", "BuildingInstallation", \
		"bldg", "BuildingInstallation", 0xa89f91) \
	X(4, IntBuildingInstallation, PART, "bldg", "IntBuildingInstallation", \
		"bldg", "BuildingInstallation", 0xbcb3a5) \
	X(5, BuildingRoom, PART, "bldg", "Room", "bldg", "BuildingRoom", \
		0xe9e2d0) \
	X(6, BuildingFurniture, PART, "bldg", "BuildingFurniture", "bldg", \
		"BuildingFurniture", 0x9a7b4f) \
	X(7, BuildingConstructiveElement, PART, "-", "-", "bldg", \
		"BuildingConstructiveElement", 0xc2b8a8) \
	X(8, BuildingUnit, PART, "-", "-", "bldg", "BuildingUnit", 0xddd5c8) \
	X(9, Storey, PART, "-", "-", "bldg", "Storey", 0xddd5c8) \
	X(10, Bridge, OBJECT, "brid", "Bridge", "brid", "Bridge", 0xb5b5ae) \
	X(11, BridgePart, PART, "brid", "BridgePart", "brid", "BridgePart", \
		0xb5b5ae) \
	X(12, BridgeInstallation, PART, "brid", "BridgeInstallation", "brid", \
		"BridgeInstallation", 0x8f8f89) \
	X(13, IntBridgeInstallation, PART, "brid", "IntBridgeInstallation", \
		"brid", "BridgeInstallation", 0x9f9f98) \
	X(14, BridgeConstructionElement, PART, "brid", \
		"BridgeConstructionElement", "brid", \
		"BridgeConstructiveElement", 0xa5a59e) \
	X(15, BridgeRoom, PART, "brid", "BridgeRoom", "brid", "BridgeRoom", \
		0xe9e2d0) \
	X(16, BridgeFurniture, PART, "brid", "BridgeFurniture", "brid", \
		"BridgeFurniture", 0x9a7b4f) \
	X(17, Tunnel, OBJECT, "tun", "Tunnel", "tun", "Tunnel", 0x9d9a94) \
	X(18, TunnelPart, PART, "tun", "TunnelPart", "tun", "TunnelPart", \
		0x9d9a94) \
	X(19, TunnelInstallation, PART, "tun", "TunnelInstallation", "tun", \
		"TunnelInstallation", 0x84817b) \
	X(20, IntTunnelInstallation, PART, "tun", "IntTunnelInstallation", \
		"tun", "TunnelInstallation", 0x8f8c86) \
	X(21, TunnelConstructiveElement, PART, "-", "-", "tun", \
		"TunnelConstructiveElement", 0x95928c) \
	X(22, HollowSpace, PART, "tun", "HollowSpace", "tun", "HollowSpace", \
		0xcfcabf) \
	X(23, TunnelFurniture, PART, "tun", "TunnelFurniture", "tun", \
		"TunnelFurniture", 0x9a7b4f) \
	X(24, OtherConstruction, OBJECT, "-", "-", "con", "OtherConstruction", \
		0xbdb6ab) \
	X(25, RoofSurface, SURFACE, "bldg", "RoofSurface", "con", \
		"RoofSurface", 0xa8452f) \
	X(26, WallSurface, SURFACE, "bldg", "WallSurface", "con", \
		"WallSurface", 0xe6dcc8) \
	X(27, GroundSurface, SURFACE, "bldg", "GroundSurface", "con", \
		"GroundSurface", 0x7d7468) \
	X(28, ClosureSurface, SURFACE, "bldg", "ClosureSurface", "core", \
		"ClosureSurface", 0xc9d3d8) \
	X(29, FloorSurface, SURFACE, "bldg", "FloorSurface", "con", \
		"FloorSurface", 0xb89b74) \
	X(30, OuterFloorSurface, SURFACE, "bldg", "OuterFloorSurface", "con", \
		"OuterFloorSurface", 0xa39a8b) \
	X(31, InteriorWallSurface, SURFACE, "bldg", "InteriorWallSurface", \
		"con", "InteriorWallSurface", 0xf0ebe0) \
	X(32, CeilingSurface, SURFACE, "bldg", "CeilingSurface", "con", \
		"CeilingSurface", 0xf5f2ea) \
	X(33, OuterCeilingSurface, SURFACE, "bldg", "OuterCeilingSurface", \
		"con", "OuterCeilingSurface", 0xd9d2c4) \
	X(34, Window, OPENING, "bldg", "Window", "con", "Window", 0x6f9fc4) \
	X(35, Door, OPENING, "bldg", "Door", "con", "Door", 0x7a5230) \
	X(36, WindowSurface, SURFACE, "-", "-", "con", "WindowSurface", \
		0x6f9fc4) \
	X(37, DoorSurface, SURFACE, "-", "-", "con", "DoorSurface", 0x7a5230) \
	X(38, GenericThematicSurface, SURFACE, "-", "-", "gen", \
		"GenericThematicSurface", 0xb0b0b0) \
	X(39, TransportationComplex, OBJECT, "tran", "TransportationComplex", \
		"-", "-", 0x77777c) \
	X(40, Road, OBJECT, "tran", "Road", "tran", "Road", 0x77777c) \
	X(41, Track, OBJECT, "tran", "Track", "tran", "Track", 0x9b8a6b) \
	X(42, Railway, OBJECT, "tran", "Railway", "tran", "Railway", 0x6b5f57) \
	X(43, Square, OBJECT, "tran", "Square", "tran", "Square", 0x8d8a86) \
	X(44, Waterway, OBJECT, "-", "-", "tran", "Waterway", 0x6ea3c0) \
	X(45, Section, PART, "-", "-", "tran", "Section", 0x77777c) \
	X(46, Intersection, PART, "-", "-", "tran", "Intersection", 0x77777c) \
	X(47, TrafficSpace, PART, "-", "-", "tran", "TrafficSpace", 0x77777c) \
	X(48, AuxiliaryTrafficSpace, PART, "-", "-", "tran", \
		"AuxiliaryTrafficSpace", 0x8a8f7e) \
	X(49, ClearanceSpace, PART, "-", "-", "tran", "ClearanceSpace", \
		0xc5cbd0) \
	X(50, TrafficArea, SURFACE, "tran", "TrafficArea", "tran", \
		"TrafficArea", 0x6a6a70) \
	X(51, AuxiliaryTrafficArea, SURFACE, "tran", "AuxiliaryTrafficArea", \
		"tran", "AuxiliaryTrafficArea", 0x869078) \
	X(52, Marking, SURFACE, "-", "-", "tran", "Marking", 0xf2f2f2) \
	X(53, Hole, PART, "-", "-", "tran", "Hole", 0x4a4a4a) \
	X(54, HoleSurface, SURFACE, "-", "-", "tran", "HoleSurface", 0x4a4a4a) \
	X(55, ReliefFeature, OBJECT, "dem", "ReliefFeature", "dem", \
		"ReliefFeature", 0x9fb07a) \
	X(56, TINRelief, PART, "dem", "TINRelief", "dem", "TINRelief", \
		0x9fb07a) \
	X(57, MassPointRelief, PART, "dem", "MassPointRelief", "dem", \
		"MassPointRelief", 0x9fb07a) \
	X(58, BreaklineRelief, PART, "dem", "BreaklineRelief", "dem", \
		"BreaklineRelief", 0x9fb07a) \
	X(59, RasterRelief, PART, "dem", "RasterRelief", "dem", \
		"RasterRelief", 0x9fb07a) \
	X(60, SolitaryVegetationObject, OBJECT, "veg", \
		"SolitaryVegetationObject", "veg", "SolitaryVegetationObject", \
		0x5f8f3e) \
	X(61, PlantCover, OBJECT, "veg", "PlantCover", "veg", "PlantCover", \
		0x7da453) \
	X(62, WaterBody, OBJECT, "wtr", "WaterBody", "wtr", "WaterBody", \
		0x4f8fb8) \
	X(63, WaterSurface, SURFACE, "wtr", "WaterSurface", "wtr", \
		"WaterSurface", 0x4f8fb8) \
	X(64, WaterGroundSurface, SURFACE, "wtr", "WaterGroundSurface", "wtr", \
		"WaterGroundSurface", 0x6f6a58) \
	X(65, WaterClosureSurface, SURFACE, "wtr", "WaterClosureSurface", "-", \
		"-", 0x86b3cf) \
	X(66, LandUse, OBJECT, "luse", "LandUse", "luse", "LandUse", 0xb7c48f) \
	X(67, CityFurniture, OBJECT, "frn", "CityFurniture", "frn", \
		"CityFurniture", 0x8c6f4e) \
	X(68, GenericCityObject, OBJECT, "gen", "GenericCityObject", "-", "-", \
		0xb0a7b8) \
	X(69, GenericLogicalSpace, OBJECT, "-", "-", "gen", \
		"GenericLogicalSpace", 0xb0a7b8) \
	X(70, GenericOccupiedSpace, OBJECT, "-", "-", "gen", \
		"GenericOccupiedSpace", 0xb0a7b8) \
	X(71, GenericUnoccupiedSpace, OBJECT, "-", "-", "gen", \
		"GenericUnoccupiedSpace", 0xb0a7b8) \
	X(72, CityObjectGroup, OBJECT, "grp", "CityObjectGroup", "grp", \
		"CityObjectGroup", 0xb0b0b0) \
	X(73, PointCloud, PART, "-", "-", "pcl", "PointCloud", 0xb0b0b0)

enum tcs_class {
#define TCS_CLASS_NUMBER(number, label, kind, m2, n2, m3, n3, colour) \
	TCS_CLASS_##label = (number),
	TCS_CLASSES(TCS_CLASS_NUMBER)
#undef TCS_CLASS_NUMBER
		TCS_CLASS_COUNT,
};

struct label {
	const char *name; /* the stream's label: "WallSurface" */
	const char *module_2; /* "bldg"; NULL: not in 1.0, 2.0 */
	const char *name_2;
	const char *module_3; /* NULL: not in 3.0 */
	const char *name_3;
	uint32_t colour; /* 0xRRGGBB, for what has no material */
	enum label_kind kind;
};

/* The row of a class; that of Unknown for a number this version lacks. */
const struct label *label_of(unsigned class);

/* The class whose label is `name`; TCS_CLASS_Unknown for none. */
enum tcs_class label_find(const char *name, size_t length);

/*
 * The class that CityGML calls `name` in some module of the given major
 * version (2 stands for 1.0 too); TCS_CLASS_Unknown for none. A boundary
 * surface of a bridge or tunnel has the class of a building's. Names are
 * unique over the modules of a version.
 */
enum tcs_class label_find_citygml(int version, const char *name, size_t length);

#endif
