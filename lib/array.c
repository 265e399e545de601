#include "array.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/*
 * The typed arrays are separate struct types with one layout; memcpy is the
 * way to look at one through another that no optimiser may misread.
 */
static struct tcs_array
array_view(const void *array)
{
	struct tcs_array view;

	memcpy(&view, array, sizeof view);
	return view;
}

int
array_grow_bytes(void *array, size_t size, size_t more)
{
	struct tcs_array view = array_view(array);
	size_t room, want;
	void *at;

	if (more <= view.room && view.count <= view.room - more)
		return 0;
	if (more > SIZE_MAX - view.count)
		return -1;
	want = view.count + more;
	room = view.room > SIZE_MAX / 2 ? SIZE_MAX : view.room * 2;
	if (room < want)
		room = want;
	if (room < 8)
		room = 8;
	if (room > PTRDIFF_MAX / size)
		return -1;
	at = realloc(view.room ? view.at : NULL, room * size);
	if (!at)
		return -1;
	if (!view.room && view.count)
		memcpy(at, view.at, view.count * size);
	view.at = at;
	view.room = room;
	memcpy(array, &view, sizeof view);
	return 0;
}

void
array_release_bytes(void *array)
{
	struct tcs_array view = array_view(array);

	if (view.room)
		free(view.at);
	memset(array, 0, sizeof view);
}
