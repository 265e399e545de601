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
 * are ready for writing. What stands behind `lock` is guarded by it.
 */
struct crew {
	const struct crew_plan *plan;
	unsigned jobs;
	size_t slot_count;
	char *slots;
	char *scratch; /* of the workers, by number */
	struct worker *workers;
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
	void *scratch;
	pthread_t thread;
};

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
	return crew->slots +
		(size_t)(item % crew->slot_count) * crew->plan->slot_size;
}

static void *
scratch_of(const struct crew *crew, unsigned worker)
{
	return crew->scratch ? crew->scratch + worker * crew->plan->worker_size
			     : NULL;
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
		crew->next_read - crew->next_write < crew->slot_count;
}

static bool
can_write(const struct crew *crew)
{
	return !crew->writing && crew->next_write < write_limit(crew) &&
		crew->worked[crew->next_write % crew->slot_count];
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
read_and_work(struct crew *crew, void *scratch)
{
	const struct crew_plan *plan = crew->plan;
	uint64_t item = crew->next_read;
	struct tcs_fault fault = {0};
	enum tcs_status status = TCS_OK;
	bool done = false;

	crew->worked[item % crew->slot_count] = false;
	if (read_item(crew, item, &done) || done)
		return;
	if (plan->work) {
		pthread_mutex_unlock(&crew->lock);
		status = plan->work(
			plan->context, slot_of(crew, item), scratch, &fault);
		pthread_mutex_lock(&crew->lock);
	}
	if (status)
		note_failure(crew, item, status, &fault);
	else
		crew->worked[item % crew->slot_count] = true;
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
			read_and_work(crew, worker->scratch);
		else
			pthread_cond_wait(&crew->changed, &crew->lock);
	}
	pthread_mutex_unlock(&crew->lock);
	return NULL;
}

/* The calling thread is worker 0; a crew short of threads is still a crew. */
static enum tcs_status
run_workers(struct crew *crew, struct tcs_fault *fault)
{
	struct worker *workers = crew->workers;
	unsigned started = 1;

	while (started < crew->jobs) {
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

static enum tcs_status
equip(struct crew *crew, struct tcs_fault *fault)
{
	const struct crew_plan *plan = crew->plan;
	enum tcs_status status = TCS_OK;

	crew->workers = calloc(crew->jobs, sizeof *crew->workers);
	crew->worked = calloc(crew->slot_count, sizeof *crew->worked);
	crew->slots = calloc(crew->slot_count, plan->slot_size);
	if (plan->worker_size)
		crew->scratch = calloc(crew->jobs, plan->worker_size);
	if (!crew->workers || !crew->worked || !crew->slots ||
		(plan->worker_size && !crew->scratch))
		return fault_memory(fault);
	for (unsigned i = 0; i < crew->jobs && !status; i++) {
		crew->workers[i] = (struct worker){
			.crew = crew, .scratch = scratch_of(crew, i)};
		if (plan->worker_begin)
			status = plan->worker_begin(
				plan->context, scratch_of(crew, i), fault);
	}
	return status;
}

static void
dismiss(struct crew *crew)
{
	const struct crew_plan *plan = crew->plan;

	if (plan->slot_release && crew->slots)
		for (size_t i = 0; i < crew->slot_count; i++)
			plan->slot_release(slot_of(crew, i));
	if (plan->worker_release && crew->scratch)
		for (unsigned i = 0; i < crew->jobs; i++)
			plan->worker_release(scratch_of(crew, i));
	free(crew->slots);
	free(crew->scratch);
	free(crew->worked);
	free(crew->workers);
}

/* Enough that an item that takes long does not hold up the others. */
static size_t
slots_for(unsigned jobs)
{
	return jobs > 1 ? (size_t)jobs * 3 : 1;
}

enum tcs_status
crew_run(const struct crew_plan *plan, unsigned jobs, struct tcs_fault *fault)
{
	struct crew crew = {
		.plan = plan,
		.jobs = jobs,
		.slot_count =
			plan->slot_count ? plan->slot_count : slots_for(jobs),
		.lock = PTHREAD_MUTEX_INITIALIZER,
		.changed = PTHREAD_COND_INITIALIZER,
		.failed = UINT64_MAX,
	};
	enum tcs_status status = equip(&crew, fault);

	if (!status)
		status = run_workers(&crew, fault);
	dismiss(&crew);
	pthread_cond_destroy(&crew.changed);
	pthread_mutex_destroy(&crew.lock);
	return status;
}
