#include "citygml_sink.h"

#include <stdlib.h>
#include <zlib.h>

#define GZIP_WINDOW (15 + 16) /* zlib's way to ask for a gzip header */

struct sink_gzip {
	z_stream stream;
	unsigned char packed[1 << 16];
};

enum tcs_status
sink_open(struct sink *sink, FILE *file, int level, struct tcs_fault *fault)
{
	struct sink_gzip *gzip;

	*sink = (struct sink){.file = file};
	if (!level)
		return TCS_OK;
	gzip = calloc(1, sizeof *gzip);
	if (!gzip ||
		deflateInit2(&gzip->stream, level, Z_DEFLATED, GZIP_WINDOW, 8,
			Z_DEFAULT_STRATEGY) != Z_OK) {
		free(gzip);
		return fault_memory(fault);
	}
	sink->gzip = gzip;
	return TCS_OK;
}

static enum tcs_status
put_plain(struct sink *sink, const void *bytes, size_t length,
	struct tcs_fault *fault)
{
	if (fwrite(bytes, 1, length, sink->file) != length)
		return fault_system(fault, "cannot write", "the document");
	return TCS_OK;
}

/* Pack what the stream has been given. */
static enum tcs_status
pack(struct sink *sink, int flush, struct tcs_fault *fault)
{
	struct sink_gzip *gzip = sink->gzip;
	enum tcs_status status = TCS_OK;
	int result = Z_OK;

	do {
		gzip->stream.next_out = gzip->packed;
		gzip->stream.avail_out = sizeof gzip->packed;
		result = deflate(&gzip->stream, flush);
		status = put_plain(sink, gzip->packed,
			sizeof gzip->packed - gzip->stream.avail_out, fault);
	} while (!status && !gzip->stream.avail_out);
	if (!status && flush == Z_FINISH && result != Z_STREAM_END)
		return fault_set(fault, TCS_SYSTEM, TCS_NOWHERE,
			"cannot compress the document");
	return status;
}

enum tcs_status
sink_put(struct sink *sink, const void *bytes, size_t length,
	struct tcs_fault *fault)
{
	struct sink_gzip *gzip = sink->gzip;
	const unsigned char *at = bytes;
	enum tcs_status status = TCS_OK;

	sink->bytes += length;
	if (!gzip)
		return put_plain(sink, bytes, length, fault);
	while (length > 0 && !status) {
		size_t part = length < 1u << 30 ? length : 1u << 30;

		gzip->stream.next_in = (unsigned char *)at;
		gzip->stream.avail_in = (unsigned)part;
		status = pack(sink, Z_NO_FLUSH, fault);
		at += part;
		length -= part;
	}
	return status;
}

enum tcs_status
sink_finish(struct sink *sink, struct tcs_fault *fault)
{
	return sink->gzip ? pack(sink, Z_FINISH, fault) : TCS_OK;
}

void
sink_release(struct sink *sink)
{
	struct sink_gzip *gzip = sink->gzip;

	if (gzip)
		deflateEnd(&gzip->stream);
	free(gzip);
	*sink = (struct sink){0};
}
