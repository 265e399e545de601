#define _GNU_SOURCE /* sched_getaffinity */

#include "crew.h"

#include <errno.h>
#include <pthread.h>
#include <sched.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/*
 * Item n lives in slot n % slot_count. Items read and not yet written are
 * those from next_write to next_read; `worked` tells, by slot, which of them
 * are ready for writing. Everything but `plan` is guarded by `lock`.
 */
struct crew {
	const struct crew_plan *plan;
	pthread_mutex_t lock;
	pthread_cond_t changed;
	bool *worked;
	uint64_t next_read, next_write;
	uint64_t failed; /* the earliest item that failed; UINT64_MAX: none */
	enum tcs_status status; /* of that item */
	struct tcs_fault fault; /* of that item */
	bool reading, writing, done;
};

struct worker {
	struct crew *crew;
	size_t number;
	pthread_t thread;
};

size_t
crew_slots(unsigned jobs)
{
	return jobs > 1 ? (size_t)jobs * 3 : 1;
}

unsigned
crew_processors(void)
{
	cpu_set_t set;
	long online;

	if (!sched_getaffinity(0, sizeof set, &set) && CPU_COUNT(&set) > 0)
		return (unsigned)CPU_COUNT(&set);
	online = sysconf(_SC_NPROCESSORS_ONLN);
	return online > 1 ? (unsigned)online : 1;
}

static void *
slot_of(const struct crew *crew, uint64_t item)
{
	const struct crew_plan *plan = crew->plan;

	return (char *)plan->slots +
		(size_t)(item % plan->slot_count) * plan->slot_size;
}

/* Items from here on are not written. */
static uint64_t
write_limit(const struct crew *crew)
{
	return crew->failed < crew->next_read ? crew->failed : crew->next_read;
}

static bool
can_read(const struct crew *crew)
{
	return !crew->reading && !crew->done && crew->failed == UINT64_MAX &&
		crew->next_read - crew->next_write < crew->plan->slot_count;
}

static bool
can_write(const struct crew *crew)
{
	return !crew->writing && crew->next_write < write_limit(crew) &&
		crew->worked[crew->next_write % crew->plan->slot_count];
}

static bool
is_over(const struct crew *crew)
{
	return !crew->reading && !crew->writing &&
		(crew->done || crew->failed != UINT64_MAX) &&
		crew->next_write >= write_limit(crew);
}

static void
note_failure(struct crew *crew, uint64_t item, enum tcs_status status,
	const struct tcs_fault *fault)
{
	if (item >= crew->failed)
		return;
	crew->failed = item;
	crew->status = status;
	crew->fault = *fault;
}

/* Called and returns with the lock held, like the two below. */
static enum tcs_status
read_item(struct crew *crew, uint64_t item, bool *done)
{
	struct tcs_fault fault = {0};
	enum tcs_status status;

	crew->reading = true;
	pthread_mutex_unlock(&crew->lock);
	status = crew->plan->read(
		crew->plan->context, slot_of(crew, item), done, &fault);
	pthread_mutex_lock(&crew->lock);
	crew->reading = false;
	if (status)
		note_failure(crew, item, status, &fault);
	else if (*done)
		crew->done = true;
	else
		crew->next_read++;
	pthread_cond_broadcast(&crew->changed);
	return status;
}

static void
read_and_work(struct crew *crew, size_t worker)
{
	const struct crew_plan *plan = crew->plan;
	uint64_t item = crew->next_read;
	struct tcs_fault fault = {0};
	enum tcs_status status = TCS_OK;
	bool done = false;

	crew->worked[item % plan->slot_count] = false;
	if (read_item(crew, item, &done) || done)
		return;
	if (plan->work) {
		pthread_mutex_unlock(&crew->lock);
		status = plan->work(
			plan->context, slot_of(crew, item), worker, &fault);
		pthread_mutex_lock(&crew->lock);
	}
	if (status)
		note_failure(crew, item, status, &fault);
	else
		crew->worked[item % plan->slot_count] = true;
	pthread_cond_broadcast(&crew->changed);
}

static void
write_item(struct crew *crew)
{
	uint64_t item = crew->next_write;
	struct tcs_fault fault = {0};
	enum tcs_status status;

	crew->writing = true;
	pthread_mutex_unlock(&crew->lock);
	status = crew->plan->write(
		crew->plan->context, slot_of(crew, item), &fault);
	pthread_mutex_lock(&crew->lock);
	crew->writing = false;
	if (status)
		note_failure(crew, item, status, &fault);
	else
		crew->next_write++;
	pthread_cond_broadcast(&crew->changed);
}

static void *
worker_run(void *argument)
{
	struct worker *worker = argument;
	struct crew *crew = worker->crew;

	pthread_mutex_lock(&crew->lock);
	while (!is_over(crew)) {
		if (can_write(crew))
			write_item(crew);
		else if (can_read(crew))
			read_and_work(crew, worker->number);
		else
			pthread_cond_wait(&crew->changed, &crew->lock);
	}
	pthread_mutex_unlock(&crew->lock);
	return NULL;
}

/* The calling thread is worker 0; a crew short of threads is still a crew. */
static enum tcs_status
run_workers(struct crew *crew, struct worker *workers, unsigned jobs,
	struct tcs_fault *fault)
{
	unsigned started = 1;

	for (unsigned i = 0; i < jobs; i++)
		workers[i] = (struct worker){.crew = crew, .number = i};
	while (started < jobs) {
		int error = pthread_create(&workers[started].thread, NULL,
			worker_run, &workers[started]);

		if (error && started == 1) {
			errno = error;
			return fault_system(fault, "cannot start", "a thread");
		}
		if (error)
			break;
		started++;
	}
	worker_run(&workers[0]);
	while (started-- > 1)
		pthread_join(workers[started].thread, NULL);
	if (crew->status)
		*fault = crew->fault;
	return crew->status;
}

enum tcs_status
crew_run(const struct crew_plan *plan, unsigned jobs, struct tcs_fault *fault)
{
	struct crew crew = {
		.plan = plan,
		.lock = PTHREAD_MUTEX_INITIALIZER,
		.changed = PTHREAD_COND_INITIALIZER,
		.failed = UINT64_MAX,
	};
	struct worker *workers = calloc(jobs, sizeof *workers);
	enum tcs_status status;

	crew.worked = calloc(plan->slot_count, sizeof *crew.worked);
	if (!workers || !crew.worked) {
		free(workers);
		free(crew.worked);
		return fault_memory(fault);
	}
	status = run_workers(&crew, workers, jobs, fault);
	pthread_cond_destroy(&crew.changed);
	pthread_mutex_destroy(&crew.lock);
	free(workers);
	free(crew.worked);
	return status;
}
