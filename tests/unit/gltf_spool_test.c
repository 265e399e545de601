#include "check.h"
#include "writers/gltf_spool.h"

#include <stdlib.h>
#include <string.h>

enum { BLOCK = 1 << 20 };

static struct tcs_fault fault;
static unsigned char block[BLOCK];

static enum tcs_status
write_blocks(struct spool *spool, int count)
{
	enum tcs_status status = TCS_OK;

	for (int i = 0; i < count && !status; i++) {
		memset(block, i, sizeof block);
		status = spool_write(spool, block, sizeof block, &fault);
	}
	return status;
}

/* What comes out is what went in. */
static void
check_poured(struct spool *spool, int count)
{
	FILE *to = tmpfile();

	CHECK(!spool_pour(spool, to, "test", &fault));
	CHECK(ftell(to) == (long)count * BLOCK);
	rewind(to);
	for (int i = 0; i < count; i++) {
		CHECK(fread(block, 1, BLOCK, to) == BLOCK);
		CHECK(block[0] == i && block[BLOCK - 1] == i);
	}
	fclose(to);
}

static void
a_few_bytes_need_no_file(void)
{
	struct spool spool;

	spool_open(&spool, "/nowhere/at/all");
	CHECK(!write_blocks(&spool, 64));
	CHECK(!spool.file && spool.size == SPOOL_HELD);
	check_poured(&spool, 64);
	spool_close(&spool);
}

static void
many_bytes_go_to_a_file(void)
{
	struct spool spool;

	spool_open(&spool, NULL);
	CHECK(!write_blocks(&spool, 70));
	CHECK(spool.file && !spool.held.count);
	CHECK(spool.size == UINT64_C(70) * BLOCK);
	check_poured(&spool, 70);
	check_poured(&spool, 70);
	spool_close(&spool);
}

static void
a_folder_that_is_not_there_is_told(void)
{
	struct spool spool;

	spool_open(&spool, "/nowhere/at/all");
	CHECK(write_blocks(&spool, 65) == TCS_SYSTEM);
	CHECK(strstr(fault.text, "/nowhere/at:"));
	spool_close(&spool);
}

static void
alignment_is_by_zeros(void)
{
	struct spool spool;

	spool_open(&spool, NULL);
	CHECK(!spool_write(&spool, "abc", 3, &fault));
	CHECK(!spool_align(&spool, 8, &fault));
	CHECK(spool.size == 8 && !memcmp(spool.held.at, "abc\0\0\0\0", 8));
	CHECK(!spool_align(&spool, 8, &fault) && spool.size == 8);
	spool_close(&spool);
}

int
main(void)
{
	static const struct check_test tests[] = {
		CHECK_TEST(a_few_bytes_need_no_file),
		CHECK_TEST(many_bytes_go_to_a_file),
		CHECK_TEST(a_folder_that_is_not_there_is_told),
		CHECK_TEST(alignment_is_by_zeros),
		{0},
	};

	return check_run(tests);
}
