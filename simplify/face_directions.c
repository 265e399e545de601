#include "face_directions.h"

/* So parallel are ways taken as one: about a degree. */
#define SAME_WAY 0.9998

void
face_directions_add(struct face_directions *directions, struct tcs_point normal,
	double area)
{
	if (!(vector_dot(normal, normal) > 0.5))
		return;
	for (unsigned i = 0; i < directions->count; i++)
		if (fabs(vector_dot(directions->at[i].way, normal)) >
			SAME_WAY) {
			directions->at[i].area += area;
			return;
		}
	if (directions->count < MOST_DIRECTIONS)
		directions->at[directions->count++] =
			(struct face_direction){normal, area};
}

/* They are few. */
void
face_directions_sort(struct face_directions *directions)
{
	for (unsigned i = 1; i < directions->count; i++) {
		struct face_direction own = directions->at[i];
		unsigned k = i;

		for (; k > 0 && directions->at[k - 1].area < own.area; k--)
			directions->at[k] = directions->at[k - 1];
		directions->at[k] = own;
	}
}
