/*
 * What writing a glTF costs: CPU time and memory of tcs2gltf from a stream,
 * beside tinygltf alone writing the same nodes, accessors and bytes.
 *
 *     gltf_bench [MILLION TRIANGLES [CORNERS OF A HOUSE]]
 *
 * BUILD names the build folder, $TMPDIR or /tmp has room for the files.
 */
#define _DEFAULT_SOURCE
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "round_city.h"

struct cost {
	double seconds; /* user and system */
	double megabytes; /* the largest resident set */
};

static struct cost
run(char *const argv[])
{
	struct rusage used;
	int status;
	pid_t child;

	fflush(stdout);
	child = fork();
	if (child == 0) {
		execv(argv[0], argv);
		perror(argv[0]);
		_exit(127);
	}
	if (child < 0 || wait4(child, &status, 0, &used) < 0 || status != 0) {
		fprintf(stderr, "gltf_bench: %s failed\n", argv[0]);
		exit(1);
	}
	return (struct cost){
		(double)(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
			1e-6 *
				(double)(used.ru_utime.tv_usec +
					used.ru_stime.tv_usec),
		(double)used.ru_maxrss / 1024};
}

static double
file_megabytes(const char *name)
{
	struct stat there;

	return stat(name, &there) ? 0 : (double)there.st_size / 1048576;
}

/* "folder/name"; for the process's lifetime. */
static char *
path_of(const char *folder, const char *name)
{
	size_t size = strlen(folder) + strlen(name) + 2;
	char *path = malloc(size);

	if (!path)
		abort();
	snprintf(path, size, "%s/%s", folder, name);
	return path;
}

static void
make_city(const char *name, unsigned houses, unsigned corners)
{
	FILE *to = fopen(name, "wb");

	if (!to) {
		perror(name);
		exit(1);
	}
	city_write(to, houses, corners);
	fclose(to);
}

static void
compare(const char *build, const char *folder, unsigned houses,
	unsigned corners)
{
	char *stream = path_of(folder, "city.tcs");
	char *glb = path_of(folder, "city.glb");
	char *again = path_of(folder, "bare.glb");
	char writer[] = "bin/tcs2gltf", bare[] = "tests/bench/gltf_bare";
	char quiet[] = "-q", one_job[] = "-j1";
	struct cost ours;
	double size;

	make_city(stream, houses, corners);
	ours = run((char *[]){
		path_of(build, writer), quiet, one_job, stream, glb, NULL});
	size = file_megabytes(glb);
	printf("%u houses, %.2f million triangles, %.0f MB of GLB\n", houses,
		1e-6 * houses * (4 * corners - 4), size);
	printf("tcs2gltf:      %.2f s CPU, %.0f MB resident (%.2f x the "
	       "output)\n",
		ours.seconds, ours.megabytes, ours.megabytes / size);
	run((char *[]){path_of(build, bare), glb, again, NULL});
	unlink(stream);
	unlink(glb);
	unlink(again);
}

int
main(int argc, char **argv)
{
	double million = argc > 1 ? atof(argv[1]) : 5;
	unsigned corners = argc > 2 ? (unsigned)atoi(argv[2]) : 13;
	const char *tmp = getenv("TMPDIR"), *build = getenv("BUILD");
	char *folder = path_of(tmp && *tmp ? tmp : "/tmp", "gltf_bench-XXXXXX");

	if (corners < 3 || !mkdtemp(folder)) {
		perror(folder);
		return 1;
	}
	compare(build ? build : "build/release", folder,
		(unsigned)(million * 1e6 / (4 * corners - 4)), corners);
	rmdir(folder);
	return 0;
}
