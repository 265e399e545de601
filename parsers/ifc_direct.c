#include "ifc_direct.h"

#include <stdlib.h>

const struct ifc_direct_row ifc_direct_rows[IFC_DIRECT_ROWS + 1] = {
	{"Description", false},
	{"ObjectType", false},
	{"LongName", false},
	{"Tag", false},
	{"PredefinedType", false},
	{"Elevation", true},
	{"RefElevation", true},
	{"ElevationOfRefHeight", true},
	{"ElevationOfTerrain", true},
	{"LandTitleNumber", false},
	{"OverallHeight", true},
	{"OverallWidth", true},
	{"OperationType", false},
	{"NumberOfRisers", false},
	{"NumberOfTreads", false},
	{"RiserHeight", true},
	{"TreadLength", true},
};

enum tcs_status
ifc_direct_read(const struct ifc_file *file, struct ifc_direct_places **out,
	struct tcs_fault *fault)
{
	size_t names = file->step->names.list.count;

	*out = calloc(names + 1, sizeof **out);
	if (!*out)
		return fault_memory(fault);
	for (size_t name = 0; name < names; name++) {
		enum ifc_entity entity = (enum ifc_entity)file->entities[name];

		if (!ifc_is(file->version, entity, IFC_PRODUCT))
			continue;
		for (int i = 0; i < IFC_DIRECT_ROWS; i++) {
			int position = ifc_attribute(
				file->version, entity, ifc_direct_rows[i].name);

			(*out)[name].at[i] = position < IFC_DIRECT_REACH
				? (signed char)position
				: -1;
		}
	}
	return TCS_OK;
}
