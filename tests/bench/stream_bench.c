/*
 * What the stream costs: megabytes of payload per second of CPU time, for
 * encoding and writing, for reading, decoding and checking, and for both.
 *
 *     stream_bench [FILE]        FILE on a memory file system, /dev/shm/…
 */
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "tcs.h"

#define ROUNDS 5
#define OBJECTS 4000
#define POLYGONS 200 /* of four corners, each with an id, as in a LOD2 city */

static double
cpu_seconds(void)
{
	struct timespec now;

	clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
	return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static void
must(enum tcs_status status, const struct tcs_fault *fault)
{
	if (!status)
		return;
	fprintf(stderr, "stream_bench: %s\n", fault->text);
	exit(1);
}

static void
add_polygon(struct tcs_object *o, uint32_t number, struct tcs_fault *fault)
{
	char id[64];
	int length = snprintf(id, sizeof id,
		"UUID_%08x-35ed-4fe5-b9f0-a0d6d9d6a123", number * 2654435761u);
	uint32_t first = (uint32_t)o->vertices.count;
	struct tcs_polygon polygon = {
		.first_vertex = first,
		.vertex_count = 4,
		.first_ring = (uint32_t)o->rings.count,
		.ring_count = 1,
		.first_triangle = (uint32_t)o->triangles.count,
		.triangle_count = 2,
	};

	if (array_grow(&o->polygons, 1) || array_grow(&o->rings, 1) ||
		array_grow(&o->vertices, 4) || array_grow(&o->triangles, 2))
		must(fault_memory(fault), fault);
	must(text_append(o, id, (size_t)length, &polygon.id, fault), fault);
	o->polygons.at[o->polygons.count++] = polygon;
	o->rings.at[o->rings.count++] = (struct tcs_ring){0, first, 4};
	for (uint32_t i = 0; i < 4; i++)
		o->vertices.at[o->vertices.count++] = (struct tcs_point){
			500000 + number, 5333770.3 + i, 0.25 * number};
	for (uint32_t i = 1; i < 3; i++)
		o->triangles.at[o->triangles.count++] = (struct tcs_triangle){
			{first, first + i, first + i + 1}};
}

static void
make_object(struct tcs_object *o, struct tcs_fault *fault)
{
	if (array_grow(&o->features, 1) || array_grow(&o->geometries, 1))
		must(fault_memory(fault), fault);
	o->features.at[o->features.count++] =
		(struct tcs_feature){.parent = TCS_NONE, .class = 1};
	o->geometries.at[o->geometries.count++] = (struct tcs_geometry){
		.polygon_count = POLYGONS, .kind = TCS_MULTI_SURFACE};
	for (uint32_t i = 0; i < POLYGONS; i++)
		add_polygon(o, i, fault);
}

static uint64_t
write_all(FILE *file, struct tcs_fault *fault)
{
	struct tcs_writer writer;
	struct tcs_record record = {0};
	struct tcs_head head = {0};
	struct tcs_object object = {0};
	uint64_t length;

	if (array_grow(&head.crs, 1))
		must(fault_memory(fault), fault);
	head.crs.at[head.crs.count++] =
		(struct tcs_crs){.metres_per_unit = 1, .metres_per_unit_up = 1};
	make_object(&object, fault);
	writer_init(&writer, file, 0);
	must(head_encode(&head, &record, fault), fault);
	must(writer_put(&writer, &record, fault), fault);
	for (int i = 0; i < OBJECTS; i++) {
		must(object_encode(&object, TCS_OBJECT, &record, fault), fault);
		must(writer_put(&writer, &record, fault), fault);
	}
	must(writer_end(&writer, fault), fault);
	length = writer.at;
	writer_release(&writer);
	record_release(&record);
	head_release(&head);
	object_release(&object);
	return length;
}

static void
read_all(FILE *file, struct tcs_fault *fault)
{
	struct tcs_reader reader;
	struct tcs_record record = {0};
	struct tcs_object object = {0};

	reader_init(&reader, file);
	for (;;) {
		must(reader_next(&reader, &record, fault), fault);
		if (reader.ended)
			break;
		if (record.type == TCS_OBJECT)
			must(object_decode(&object, &record, fault), fault);
	}
	reader_release(&reader);
	record_release(&record);
	object_release(&object);
}

int
main(int argc, char **argv)
{
	const char *name = argc > 1 ? argv[1] : "/dev/shm/stream_bench.tcs";
	FILE *file = fopen(name, "w+b");
	struct tcs_fault fault;
	double best_write = 1e9, best_read = 1e9, megabytes = 0;

	if (!file) {
		perror(name);
		return 1;
	}
	for (int round = 0; round < ROUNDS; round++) {
		double begin = cpu_seconds(), middle, end;

		rewind(file);
		megabytes = 1e-6 * (double)write_all(file, &fault);
		middle = cpu_seconds();
		rewind(file);
		read_all(file, &fault);
		end = cpu_seconds();
		if (middle - begin < best_write)
			best_write = middle - begin;
		if (end - middle < best_read)
			best_read = end - middle;
	}
	fclose(file);
	unlink(name);
	printf("stream: %.0f MB; write %.0f MB/s, read %.0f MB/s, write and "
	       "read %.0f MB/s of CPU time, best of %d\n",
		megabytes, megabytes / best_write, megabytes / best_read,
		megabytes / (best_write + best_read), ROUNDS);
	return 0;
}
