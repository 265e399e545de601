/*
 * Records of a stream as lines of JSON; tcs2json(1) says what they hold.
 */
#ifndef TESSERA_JSON_RECORD_H
#define TESSERA_JSON_RECORD_H

#include "json_print.h"
#include "tcs.h"

/* What decoding needs; one per thread, reused. All zero is empty. */
struct json_decoder {
	struct tcs_head head;
	struct tcs_palette palette;
	struct tcs_object object;
};

void json_decoder_release(struct json_decoder *decoder);

/*
 * Append the record as one line with its line end. A record of an unknown
 * type, or with sections that are unknown, is told by its bytes. For TCS_END
 * the counts are those of record->before. Fails as decoding does, and with
 * TCS_NO_MEMORY.
 */
enum tcs_status print_record(struct json_text *json,
	struct json_decoder *decoder, const struct tcs_record *record,
	struct tcs_fault *fault) TCS_CHECKED;

#endif
