/*
 * What everything that evaluates shapes shares: one worker's shaper, with the
 * limits it holds, and planar faces, which is what shapes become.
 *
 * Evaluators take a shaper, the instance to evaluate and the array to append
 * to. They return IFC_SHAPED, or IFC_REFUSED with the reason and the instance
 * to blame in the shaper, or IFC_NO_MEMORY; after a failure what they appended
 * is unspecified, and the caller cuts it off. Whoever follows a reference that
 * could lead back enters the instance first and leaves it behind:
 *
 *     outcome = ifc_enter(shaper, curve);
 *     if (outcome)
 *             return outcome;
 *     …
 *     ifc_leave(shaper);
 *
 * Depth and the count of points are bounded, so that cycles and instances that
 * are used again and again end in a refusal. Coordinates are in the file's
 * length unit and in the item's own system; they are scaled and placed once, at
 * the very end.
 */
#ifndef TESSERA_IFC_SHAPE_H
#define TESSERA_IFC_SHAPE_H

#include "ifc_placement.h"

enum ifc_outcome { IFC_SHAPED, IFC_REFUSED, IFC_NO_MEMORY };

enum {
	IFC_MOST_DEPTH = 48, /* evaluations within each other */
	IFC_MOST_POINTS = 1 << 24, /* that one product may have */
};

struct ifc_scratch;
struct ifc_styles;

struct ifc_shaper {
	const struct ifc_file *file; /* borrowed */
	double unit; /* metres of the file's unit of length */
	double angle; /* radians of the file's unit of plane angles */
	double deflection; /* most that a chord may be off its curve */
	double precision; /* points nearer than this are one */
	double reach; /* how far beside curves the things go that are made along
	                 them now; chords answer for these, too */
	unsigned depth; /* 0 between products */
	uint64_t points; /* made for this product */
	const struct ifc_styles *styles; /* borrowed; NULL: no colours */
	const char *reason; /* why it was refused: static text */
	uint32_t culprit; /* the instance refused */
	struct ifc_scratch *scratch; /* see ifc_item.h */
};

TCS_ARRAY_TYPE(ifc_points, struct tcs_point);

/*
 * A planar face: an outer ring and holes, none repeating its first point at
 * its end. Rings and points follow each other without gaps.
 */
struct ifc_face {
	uint32_t first_point;
	uint32_t first_ring;
	uint32_t ring_count;
	uint32_t paint; /* 1 + the material of the stream; 0: none of its own */
};

/* Faces of a solid wind counterclockwise seen from outside. */
struct ifc_faces {
	struct ifc_points points;
	TCS_ARRAY(uint32_t) rings; /* points of each */
	TCS_ARRAY(struct ifc_face) faces;
};

/* Note why and who is to blame; returns IFC_REFUSED. */
enum ifc_outcome ifc_refuse(
	struct ifc_shaper *shaper, uint32_t instance, const char *reason);

enum ifc_outcome ifc_enter(
	struct ifc_shaper *shaper, uint32_t instance) TCS_CHECKED;
void ifc_leave(struct ifc_shaper *shaper);

/* Room for `more` points, which count as made. */
enum ifc_outcome ifc_points_room(struct ifc_shaper *shaper,
	struct ifc_points *points, size_t more) TCS_CHECKED;

enum ifc_outcome ifc_point_add(struct ifc_shaper *shaper,
	struct ifc_points *points, struct tcs_point point) TCS_CHECKED;

/* Whether two points are one, as the file's precision has it. */
bool ifc_same_point(const struct ifc_shaper *shaper, struct tcs_point a,
	struct tcs_point b);

/*
 * Building faces: points are appended to faces->points, then a ring is closed
 * over those behind the last ring, then a face over the rings behind the last
 * face. A ring of fewer than three points is taken back: false in *kept, which
 * may be NULL. A face without rings is no face.
 */
enum ifc_outcome ifc_ring_end(struct ifc_shaper *shaper,
	struct ifc_faces *faces, bool *kept) TCS_CHECKED;
enum ifc_outcome ifc_face_end(
	struct ifc_shaper *shaper, struct ifc_faces *faces) TCS_CHECKED;

/* The same, with the holes turned against the outer ring. */
enum ifc_outcome ifc_face_end_wound(
	struct ifc_shaper *shaper, struct ifc_faces *faces) TCS_CHECKED;

/* Points that no ring has taken yet. */
size_t ifc_faces_loose(const struct ifc_faces *faces);

void ifc_faces_clear(struct ifc_faces *faces);
void ifc_faces_release(struct ifc_faces *faces);

/* Take back the faces from `first_face` on, with what they own. */
void ifc_faces_cut(struct ifc_faces *faces, size_t first_face);

/* The points of a face, all rings together. */
size_t ifc_face_points(
	const struct ifc_faces *faces, const struct ifc_face *face);

/* Append a copy of the faces from `first` to before `end` of another list. */
enum ifc_outcome ifc_faces_append_some(struct ifc_shaper *shaper,
	struct ifc_faces *out, const struct ifc_faces *from, size_t first,
	size_t end) TCS_CHECKED;

/* … of the face `first_face` and those after. */
enum ifc_outcome ifc_faces_append(struct ifc_shaper *shaper,
	struct ifc_faces *out, const struct ifc_faces *from,
	size_t first_face) TCS_CHECKED;

/* Turn one ring round; its first point stays the first. */
void ifc_ring_reverse(struct tcs_point *points, size_t count);

/* Turn the faces from `first_face` on over: each ring the other way round. */
void ifc_faces_reverse(struct ifc_faces *faces, size_t first_face);

/* Place the faces; a matrix that mirrors turns them over, too. */
void ifc_faces_transform(struct ifc_faces *faces, size_t first_face,
	const struct ifc_matrix *matrix);

/* Six times the volume that the faces from `first_face` on enclose. */
double ifc_faces_volume6(const struct ifc_faces *faces, size_t first_face);

#endif
