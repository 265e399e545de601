/*
 * A fuzz target without a fuzzer: each file named goes through it once. So the
 * seeds, and inputs that once broke a reader, are tests of every build.
 */
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size);

static int
replay(const char *name)
{
	FILE *file = fopen(name, "rb");
	uint8_t *bytes = NULL;
	long size;

	if (!file || fseek(file, 0, SEEK_END) || (size = ftell(file)) < 0)
		goto failed;
	rewind(file);
	/* No byte more, so that a sanitizer sees a read behind the end. */
	bytes = malloc(size ? (size_t)size : 1);
	if (!bytes || fread(bytes, 1, (size_t)size, file) != (size_t)size)
		goto failed;
	fclose(file);
	LLVMFuzzerTestOneInput(bytes, (size_t)size);
	free(bytes);
	return 0;
failed:
	fprintf(stderr, "cannot read %s\n", name);
	if (file)
		fclose(file);
	free(bytes);
	return -1;
}

int
main(int argc, char **argv)
{
	int passed = 0, failed = 0;

	for (int i = 1; i < argc; i++) {
		if (replay(argv[i]))
			failed++;
		else
			passed++;
	}
	printf("%d passed, %d failed\n", passed, failed);
	return failed ? 1 : 0;
}
