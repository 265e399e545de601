/*
 * Lists of coordinates: IfcCartesianPointList2D and 3D.
 */
#ifndef TESSERA_IFC_POINT_LIST_H
#define TESSERA_IFC_POINT_LIST_H

#include "ifc_shape.h"

/* Append all points of a list, in order; z is 0 in a plane. */
enum ifc_outcome ifc_point_list_read(struct ifc_shaper *shaper, uint32_t list,
	struct ifc_points *out) TCS_CHECKED;

#endif
