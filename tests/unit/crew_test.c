#include "crew.h"

#include <inttypes.h>
#include <stdatomic.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "check.h"

enum { ITEMS = 500, MAX_JOBS = 8, NEVER = -1 };

struct run;

struct slot {
	struct run *run; /* that has worked on it */
	int number;
	uint64_t value;
};

/* A run that may fail on chosen items, and what it left. */
struct run {
	int bad_read, bad_work, bad_work_too, bad_write, bad_worker;
	bool slow; /* some items take longer, so that later ones overtake */
	int begun;
	uint64_t written[ITEMS];
	int written_count;
	atomic_int workers; /* begun and not released */
	atomic_int slots; /* worked on and not released */
	atomic_int reading, writing;
	atomic_bool clashed;
};

struct worker {
	struct run *run;
	atomic_int busy;
};

static const struct run good = {.bad_read = NEVER,
	.bad_work = NEVER,
	.bad_work_too = NEVER,
	.bad_write = NEVER,
	.bad_worker = NEVER};

static enum tcs_status
fail(struct tcs_fault *fault, const char *what, int number)
{
	return fault_set(
		fault, TCS_BAD_INPUT, (uint64_t)number, "%s %d", what, number);
}

static enum tcs_status
run_read(void *context, void *at, bool *done, struct tcs_fault *fault)
{
	struct run *run = context;
	struct slot *slot = at;
	enum tcs_status status = TCS_OK;

	if (atomic_fetch_add(&run->reading, 1))
		run->clashed = true;
	if (run->begun == run->bad_read)
		status = fail(fault, "read", run->begun);
	else if (run->begun == ITEMS)
		*done = true;
	else
		slot->number = run->begun++;
	atomic_fetch_sub(&run->reading, 1);
	return status;
}

static enum tcs_status
run_work(void *context, void *at, void *scratch, struct tcs_fault *fault)
{
	struct run *run = context;
	struct slot *slot = at;
	struct worker *worker = scratch;

	if (worker->run != run || atomic_fetch_add(&worker->busy, 1))
		run->clashed = true;
	if (!slot->run)
		atomic_fetch_add(&run->slots, 1);
	slot->run = run;
	if (run->slow && slot->number % 7 == 0)
		nanosleep(&(struct timespec){.tv_nsec = 4000000}, NULL);
	if (run->slow && slot->number % 7 == 6)
		nanosleep(&(struct timespec){.tv_nsec = 1000000}, NULL);
	slot->value = (uint64_t)slot->number * 3 + 1;
	atomic_fetch_sub(&worker->busy, 1);
	if (slot->number == run->bad_work || slot->number == run->bad_work_too)
		return fail(fault, "work", slot->number);
	return TCS_OK;
}

static enum tcs_status
run_write(void *context, void *at, struct tcs_fault *fault)
{
	struct run *run = context;
	struct slot *slot = at;

	if (atomic_fetch_add(&run->writing, 1))
		run->clashed = true;
	atomic_fetch_sub(&run->writing, 1);
	if (slot->number == run->bad_write)
		return fail(fault, "write", slot->number);
	run->written[run->written_count++] = slot->value;
	return TCS_OK;
}

static enum tcs_status
begin_worker(void *context, void *scratch, struct tcs_fault *fault)
{
	struct run *run = context;
	struct worker *worker = scratch;

	if (worker->run || run->begun)
		run->clashed = true;
	if (run->workers == run->bad_worker)
		return fail(fault, "worker", run->bad_worker);
	worker->run = run;
	run->workers++;
	return TCS_OK;
}

static void
release_worker(void *scratch)
{
	struct worker *worker = scratch;

	if (worker->run)
		worker->run->workers--;
}

static void
release_slot(void *at)
{
	struct slot *slot = at;

	if (slot->run)
		slot->run->slots--;
}

static enum tcs_status
crew_try(struct run *run, unsigned jobs, size_t slots, struct tcs_fault *fault)
{
	const struct crew_plan plan = {
		.context = run,
		.slot_size = sizeof(struct slot),
		.slot_count = slots,
		.worker_size = sizeof(struct worker),
		.read = run_read,
		.work = run_work,
		.write = run_write,
		.worker_begin = begin_worker,
		.worker_release = release_worker,
		.slot_release = release_slot,
	};
	enum tcs_status status = crew_run(&plan, jobs, fault);

	CHECK(!run->clashed);
	CHECK(run->workers == 0 && run->slots == 0);
	for (int i = 0; i < run->written_count; i++)
		CHECK(run->written[i] == (uint64_t)i * 3 + 1);
	return status;
}

static void
the_order_of_writes_is_that_of_reads(void)
{
	for (unsigned jobs = 1; jobs <= MAX_JOBS; jobs++) {
		struct run run = good;
		struct tcs_fault fault = {0};

		run.slow = jobs == 4;
		CHECK(!crew_try(&run, jobs, 0, &fault));
		CHECK(run.written_count == ITEMS);
		CHECK(fault.status == TCS_OK && !fault.text[0]);
	}
}

static void
one_slot_is_enough_for_many_threads(void)
{
	struct run run = good;
	struct tcs_fault fault;

	CHECK(!crew_try(&run, MAX_JOBS, 1, &fault));
	CHECK(run.written_count == ITEMS);
}

static enum tcs_status
read_nothing(void *context, void *at, bool *done, struct tcs_fault *fault)
{
	(void)context;
	(void)at;
	(void)fault;
	*done = true;
	return TCS_OK;
}

static void
nothing_to_read_is_no_failure(void)
{
	struct run run = good;
	const struct crew_plan plan = {
		.context = &run,
		.slot_size = sizeof(struct slot),
		.read = read_nothing,
		.write = run_write,
	};
	struct tcs_fault fault;

	CHECK(!crew_run(&plan, 1, &fault));
	CHECK(!crew_run(&plan, 3, &fault));
	CHECK(run.written_count == 0);
}

/* Whatever fails, at any number of jobs: same fault, same writes. */
static void
check_failure(struct run bad, const char *text, int written)
{
	static const unsigned jobs[] = {1, 2, 3, 8};

	for (size_t i = 0; i < sizeof jobs / sizeof *jobs; i++) {
		struct run run = bad;
		struct tcs_fault fault = {0};
		size_t slots = 3 * (size_t)jobs[i];
		int begun_limit = written + 1 + (int)slots;

		CHECK(crew_try(&run, jobs[i], slots, &fault) == TCS_BAD_INPUT);
		CHECK(fault.status == TCS_BAD_INPUT);
		CHECK(!strcmp(fault.text, text));
		CHECK(run.written_count == written);
		CHECK(run.begun <= begun_limit);
	}
}

static void
a_failure_names_its_item_and_stops_behind_it(void)
{
	struct run run = good;

	run.bad_read = 100;
	check_failure(run, "read 100", 100);
	run = good;
	run.bad_work = 33;
	check_failure(run, "work 33", 33);
	run = good;
	run.bad_write = 7;
	check_failure(run, "write 7", 7);
	run = good;
	run.bad_read = 0;
	check_failure(run, "read 0", 0);
}

/* 35 and 42 take long, 41 a little: 36 fails before 35, and 41 before 42. */
static void
the_earliest_item_wins_not_the_first_in_time(void)
{
	struct run run = good;

	run.slow = true;
	run.bad_work = 35;
	run.bad_work_too = 36;
	check_failure(run, "work 35", 35);
	run.bad_work = 41;
	run.bad_work_too = 42;
	check_failure(run, "work 41", 41);
	run.bad_write = 34;
	check_failure(run, "write 34", 34);
}

static void
a_worker_that_cannot_begin_stops_it_all(void)
{
	struct run run = good;
	struct tcs_fault fault = {0};

	run.bad_worker = 2;
	CHECK(crew_try(&run, 4, 0, &fault) == TCS_BAD_INPUT);
	CHECK(!strcmp(fault.text, "worker 2"));
	CHECK(run.begun == 0 && run.written_count == 0);
}

static void
there_is_at_least_one_processor(void)
{
	CHECK(crew_processors() >= 1);
}

static const struct check_test tests[] = {
	CHECK_TEST(the_order_of_writes_is_that_of_reads),
	CHECK_TEST(one_slot_is_enough_for_many_threads),
	CHECK_TEST(nothing_to_read_is_no_failure),
	CHECK_TEST(a_failure_names_its_item_and_stops_behind_it),
	CHECK_TEST(the_earliest_item_wins_not_the_first_in_time),
	CHECK_TEST(a_worker_that_cannot_begin_stops_it_all),
	CHECK_TEST(there_is_at_least_one_processor),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
