#include "ifc_point_list.h"

enum ifc_outcome
ifc_point_list_read(
	struct ifc_shaper *shaper, uint32_t list, struct ifc_points *out)
{
	enum ifc_entity entity = ifc_entity_of(shaper->file, list);
	size_t size = entity == IFC_CARTESIANPOINTLIST2D ? 2 : 3;
	struct step_value all, point;
	enum ifc_outcome outcome = IFC_SHAPED;

	if (size == 3 && entity != IFC_CARTESIANPOINTLIST3D)
		return ifc_refuse(shaper, list, "not a list of points");
	all = ifc_value(shaper->file, list, 0);
	if (all.kind != STEP_LIST)
		return ifc_refuse(shaper, list, "a list of points is bad");
	while (!outcome && step_next(&all.list, &point) > STEP_END) {
		double at[4] = {0};

		if (point.kind != STEP_LIST ||
			step_numbers(&point.list, at, 4) != size ||
			point.list.state != STEP_OVER)
			return ifc_refuse(shaper, list, "a point is bad");
		outcome = ifc_point_add(
			shaper, out, (struct tcs_point){at[0], at[1], at[2]});
	}
	return outcome;
}
