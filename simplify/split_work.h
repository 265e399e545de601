/*
 * One loop on several threads, with the same result for any number of them:
 * the numbers are cut into pieces of a fixed size, and each piece keeps what it
 * finds in a place of its own.
 */
#ifndef TESSERA_SPLIT_WORK_H
#define TESSERA_SPLIT_WORK_H

#include <stddef.h>

#include "fault.h"

/* `piece` counts from 0; its numbers are those from `first` below `end`. */
typedef void split_piece(void *context, size_t piece, size_t first, size_t end);

/* How many pieces there are, for an array of their results. */
static inline size_t
split_pieces(size_t count, size_t size)
{
	return (count + size - 1) / size;
}

/*
 * Call `work` for every piece of `size` > 0 numbers below `count`; on this
 * thread alone if `jobs` is at most 1 or there is only one piece. Fails with
 * TCS_NO_MEMORY, or TCS_SYSTEM when no thread can be started.
 */
enum tcs_status split_work(size_t count, size_t size, unsigned jobs,
	split_piece *work, void *context, struct tcs_fault *fault) TCS_CHECKED;

#endif
