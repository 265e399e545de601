#include "arena.h"

#include <stdint.h>
#include <string.h>

#include "check.h"

static void
pieces_are_aligned_and_apart(void)
{
	struct arena arena = {0};
	unsigned char *before = NULL;

	for (size_t size = 0; size < 200; size++) {
		unsigned char *piece = arena_get(&arena, size);

		CHECK(piece != NULL);
		CHECK((uintptr_t)piece % _Alignof(max_align_t) == 0);
		memset(piece, (int)size, size);
		if (before)
			for (size_t i = 0; i + 1 < size; i++)
				CHECK(before[i] == size - 1);
		before = piece;
	}
	arena_release(&arena);
}

static void
a_copy_is_terminated(void)
{
	struct arena arena = {0};
	char *copy = arena_copy(&arena, "wall and roof", 4);

	CHECK(copy && !strcmp(copy, "wall"));
	copy = arena_copy(&arena, NULL, 0);
	CHECK(copy && !*copy);
	arena_release(&arena);
}

static void
a_piece_larger_than_any_block_fits(void)
{
	struct arena arena = {0};
	char *large = arena_get(&arena, 1 << 20);
	char *small = arena_get(&arena, 16);

	CHECK(large && small);
	memset(large, 1, 1 << 20);
	memset(small, 2, 16);
	CHECK(large[(1 << 20) - 1] == 1);
	arena_release(&arena);
}

/* A run of equal objects allocates for the first few only. */
static void
memory_settles_at_the_largest_object(void)
{
	struct arena arena = {0};
	const struct arena_block *settled = NULL;

	for (int object = 0; object < 10; object++) {
		for (int i = 0; i < 1000; i++)
			CHECK(arena_get(&arena, 333) != NULL);
		arena_reset(&arena);
		if (object == 2)
			settled = arena.blocks;
	}
	CHECK(settled != NULL && arena.blocks == settled);
	arena_release(&arena);
	CHECK(arena.blocks == NULL);
}

static void
an_impossible_size_is_refused(void)
{
	struct arena arena = {0};

	CHECK(arena_get(&arena, SIZE_MAX) == NULL);
	CHECK(arena_get(&arena, PTRDIFF_MAX) == NULL);
	CHECK(arena_copy(&arena, "", SIZE_MAX) == NULL);
	CHECK(arena_get(&arena, 8) != NULL);
	arena_release(&arena);
}

static const struct check_test tests[] = {
	CHECK_TEST(pieces_are_aligned_and_apart),
	CHECK_TEST(a_copy_is_terminated),
	CHECK_TEST(a_piece_larger_than_any_block_fits),
	CHECK_TEST(memory_settles_at_the_largest_object),
	CHECK_TEST(an_impossible_size_is_refused),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
