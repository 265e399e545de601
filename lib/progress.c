#include "progress.h"

#include <inttypes.h>
#include <stdio.h>
#include <time.h>
#include <unistd.h>

static const double first_after = 1.0;
static const double then_every = 1.0 / 6;

static double
seconds_now(void)
{
	struct timespec now;

	clock_gettime(CLOCK_MONOTONIC, &now);
	return (double)now.tv_sec + (double)now.tv_nsec * 1e-9;
}

void
progress_begin(struct progress *progress, const char *program, const char *item,
	bool quiet)
{
	*progress = (struct progress){
		.program = program,
		.item = item,
		.off = quiet || !isatty(STDERR_FILENO),
		.began = seconds_now(),
	};
	progress->last = progress->began + first_after - then_every;
}

void
progress_show(struct progress *progress, uint64_t items, uint64_t done,
	uint64_t total)
{
	double now;

	if (progress->off)
		return;
	now = seconds_now();
	if (now - progress->last < then_every)
		return;
	progress->last = now;
	progress->shown = true;
	fprintf(stderr, "\r\033[K%s: %" PRIu64 " %s", progress->program, items,
		progress->item);
	if (total)
		fprintf(stderr, ", %.0f %%",
			100.0 * (double)done / (double)total);
	fprintf(stderr, ", %.0f s", now - progress->began);
	fflush(stderr);
}

void
progress_end(struct progress *progress)
{
	if (!progress->shown)
		return;
	fputs("\r\033[K", stderr);
	fflush(stderr);
	progress->shown = false;
}
