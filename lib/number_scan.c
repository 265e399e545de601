#include <math.h>
#include <string.h>

#include "number.h"

static bool
is_space(char c)
{
	return c == ' ' || c == '\n' || c == '\t' || c == '\r';
}

static enum tcs_status
append(struct number_list *out, double value, struct tcs_fault *fault)
{
	if (out->count >= out->room && array_grow(out, 1))
		return fault_memory(fault);
	out->at[out->count++] = value;
	return TCS_OK;
}

static enum tcs_status
append_bad(struct number_scan *scan, uint64_t at, struct number_list *out,
	struct tcs_fault *fault)
{
	if (!scan->bad++)
		scan->bad_at = at;
	return append(out, NAN, fault);
}

/* A whole token that begins at `at` of the run. */
static enum tcs_status
append_token(struct number_scan *scan, const char *token, size_t length,
	uint64_t at, struct number_list *out, struct tcs_fault *fault)
{
	const char *end = token + length;
	double value;

	if (length > NUMBER_MAX_TOKEN ||
		number_parse(token, end, &value) != end || !isfinite(value))
		return append_bad(scan, at, out, fault);
	return append(out, value, fault);
}

/*
 * A token that outgrows NUMBER_MAX_TOKEN is noted at once. The one byte too
 * many that stays held says so until the token ends.
 */
static enum tcs_status
hold(struct number_scan *scan, const char *bytes, size_t length, uint64_t at,
	struct number_list *out, struct tcs_fault *fault)
{
	size_t room = NUMBER_MAX_TOKEN + 1 - scan->held.count;

	if (!room || !length)
		return TCS_OK;
	if (length > room)
		length = room;
	if (array_grow(&scan->held, length))
		return fault_memory(fault);
	memcpy(scan->held.at + scan->held.count, bytes, length);
	scan->held.count += length;
	return length == room ? append_bad(scan, at, out, fault) : TCS_OK;
}

static enum tcs_status
take_held(struct number_scan *scan, uint64_t at, struct number_list *out,
	struct tcs_fault *fault)
{
	size_t length = scan->held.count;

	scan->held.count = 0;
	if (!length || length > NUMBER_MAX_TOKEN)
		return TCS_OK;
	return append_token(scan, scan->held.at, length, at, out, fault);
}

static const char *
token_end(const char *at, const char *end)
{
	while (at < end && !is_space(*at))
		at++;
	return at;
}

/* The rest of the token that an earlier piece began. */
static enum tcs_status
feed_held(struct number_scan *scan, const char **at, const char *end,
	struct number_list *out, struct tcs_fault *fault)
{
	const char *behind = token_end(*at, end);
	uint64_t begin = scan->seen - scan->held.count;
	enum tcs_status status =
		hold(scan, *at, (size_t)(behind - *at), begin, out, fault);

	*at = behind;
	if (status || behind == end)
		return status;
	return take_held(scan, begin, out, fault);
}

static enum tcs_status
feed_token(struct number_scan *scan, const char *bytes, const char **at,
	const char *end, struct number_list *out, struct tcs_fault *fault)
{
	uint64_t begin = scan->seen + (uint64_t)(*at - bytes);
	double value;
	const char *token = *at;
	const char *behind = number_parse(token, end, &value);

	if (behind && behind < end && is_space(*behind) && isfinite(value) &&
		behind - token <= NUMBER_MAX_TOKEN) {
		*at = behind;
		return append(out, value, fault);
	}
	*at = behind = token_end(token, end);
	if (behind == end)
		return hold(
			scan, token, (size_t)(end - token), begin, out, fault);
	return append_token(
		scan, token, (size_t)(behind - token), begin, out, fault);
}

enum tcs_status
number_scan_feed(struct number_scan *scan, const char *bytes, size_t length,
	struct number_list *out, struct tcs_fault *fault)
{
	const char *at = bytes, *end = bytes + length;
	enum tcs_status status = TCS_OK;

	if (scan->held.count)
		status = feed_held(scan, &at, end, out, fault);
	while (!status) {
		while (at < end && is_space(*at))
			at++;
		if (at == end)
			break;
		status = feed_token(scan, bytes, &at, end, out, fault);
	}
	scan->seen += length;
	return status;
}

enum tcs_status
number_scan_finish(struct number_scan *scan, struct number_list *out,
	struct tcs_fault *fault)
{
	enum tcs_status status =
		take_held(scan, scan->seen - scan->held.count, out, fault);

	scan->seen = 0;
	return status;
}

void
number_scan_release(struct number_scan *scan)
{
	array_release(&scan->held);
	*scan = (struct number_scan){0};
}
