#include "ifc_class.h"

#include <stddef.h>

/* The first row whose entity is the one asked for, or above it, counts. */
static const struct {
	enum ifc_entity entity;
	enum tcs_class alone, within;
} rows[] = {
#define ROW(entity, alone, within) \
	{ \
		IFC_##entity, TCS_CLASS_##alone, TCS_CLASS_##within \
	}
	ROW(BUILDING, Building, BuildingPart),
	ROW(BUILDINGSTOREY, Building, Storey),
	ROW(SPACE, Building, BuildingRoom),
	ROW(SITE, LandUse, GenericLogicalSpace),
	ROW(BRIDGE, Bridge, BridgePart),
	ROW(BRIDGEPART, Bridge, BridgePart),
	ROW(TUNNEL, Tunnel, TunnelPart),
	ROW(ROAD, Road, Section),
	ROW(ROADPART, Road, Section),
	ROW(RAILWAY, Railway, Section),
	ROW(RAILWAYPART, Railway, Section),
	ROW(FACILITY, OtherConstruction, OtherConstruction),
	ROW(FACILITYPART, OtherConstruction, OtherConstruction),
	ROW(SPATIALELEMENT, GenericLogicalSpace, BuildingUnit),
	ROW(DOOR, OtherConstruction, Door),
	ROW(WINDOW, OtherConstruction, Window),
	ROW(STAIR, OtherConstruction, BuildingInstallation),
	ROW(STAIRFLIGHT, OtherConstruction, BuildingInstallation),
	ROW(RAMP, OtherConstruction, BuildingInstallation),
	ROW(RAMPFLIGHT, OtherConstruction, BuildingInstallation),
	ROW(RAILING, OtherConstruction, BuildingInstallation),
	ROW(CHIMNEY, OtherConstruction, BuildingInstallation),
	ROW(SHADINGDEVICE, OtherConstruction, BuildingInstallation),
	ROW(BUILDINGELEMENTPROXY, OtherConstruction, BuildingInstallation),
	ROW(BUILDINGELEMENTPART, OtherConstruction,
		BuildingConstructiveElement),
	ROW(REINFORCINGELEMENT, OtherConstruction, BuildingConstructiveElement),
	ROW(BUILDINGELEMENT, OtherConstruction, BuildingConstructiveElement),
	ROW(BUILTELEMENT, OtherConstruction, BuildingConstructiveElement),
	ROW(FURNISHINGELEMENT, CityFurniture, BuildingFurniture),
	ROW(GEOGRAPHICELEMENT, GenericOccupiedSpace, BuildingInstallation),
	ROW(VIRTUALELEMENT, GenericLogicalSpace, BuildingUnit),
	ROW(TRANSPORTATIONDEVICE, OtherConstruction, BuildingInstallation),
	ROW(ELEMENT, OtherConstruction, BuildingInstallation),
	ROW(PRODUCT, GenericOccupiedSpace, BuildingInstallation),
#undef ROW
};

static size_t
row_of(const struct ifc_file *file, enum ifc_entity entity)
{
	size_t row = sizeof rows / sizeof *rows - 1;

	for (; entity != IFC_NONE;
		entity = (enum ifc_entity)file->supers[entity])
		for (size_t i = 0; i < row; i++)
			if (rows[i].entity == entity)
				row = i;
	return row;
}

enum tcs_class
ifc_class_alone(const struct ifc_file *file, enum ifc_entity entity)
{
	return rows[row_of(file, entity)].alone;
}

/* Parts of bridges and tunnels have classes of their own. */
static const struct {
	enum tcs_class building, bridge, tunnel;
} others[] = {
	{TCS_CLASS_BuildingConstructiveElement,
		TCS_CLASS_BridgeConstructionElement,
		TCS_CLASS_TunnelConstructiveElement},
	{TCS_CLASS_BuildingInstallation, TCS_CLASS_BridgeInstallation,
		TCS_CLASS_TunnelInstallation},
	{TCS_CLASS_BuildingFurniture, TCS_CLASS_BridgeFurniture,
		TCS_CLASS_TunnelFurniture},
	{TCS_CLASS_BuildingRoom, TCS_CLASS_BridgeRoom, TCS_CLASS_HollowSpace},
	{TCS_CLASS_OtherConstruction, TCS_CLASS_BridgePart,
		TCS_CLASS_TunnelPart},
	{TCS_CLASS_Door, TCS_CLASS_BridgeInstallation,
		TCS_CLASS_TunnelInstallation},
	{TCS_CLASS_Window, TCS_CLASS_BridgeInstallation,
		TCS_CLASS_TunnelInstallation},
};

enum tcs_class
ifc_class_within(const struct ifc_file *file, enum ifc_entity entity,
	enum tcs_class object)
{
	enum tcs_class class = rows[row_of(file, entity)].within;

	if (object != TCS_CLASS_Bridge && object != TCS_CLASS_Tunnel)
		return class;
	for (size_t i = 0; i < sizeof others / sizeof *others; i++)
		if (others[i].building == class)
			return object == TCS_CLASS_Bridge ? others[i].bridge
							  : others[i].tunnel;
	return class;
}
