/*
 * How library functions fail.
 *
 * A function that can fail returns an enum tcs_status and takes a
 * struct tcs_fault as its last argument. Zero is success, and success leaves
 * the fault untouched. Any other status has filled the fault with one line of
 * text, and with the place in the input where one is known. Nothing in lib/
 * prints or exits; only a program's main does.
 */
#ifndef TESSERA_FAULT_H
#define TESSERA_FAULT_H

#include <stdarg.h>
#include <stdint.h>

enum tcs_status {
	TCS_OK = 0,
	TCS_BAD_INPUT, /* what arrived breaks its format */
	TCS_TRUNCATED, /* what arrived ends too early */
	TCS_LIMIT, /* what arrived exceeds a --max-… limit */
	TCS_NO_MEMORY,
	TCS_SYSTEM, /* the operating system refused: a read, write, open */
};

#define TCS_NOWHERE UINT64_MAX

/*
 * One failure. `at` is the byte offset in the input, or TCS_NOWHERE. `text`
 * is one line without a final newline, always terminated, cut to fit.
 */
struct tcs_fault {
	enum tcs_status status;
	uint64_t at;
	char text[256];
};

#if defined(__GNUC__)
#define TCS_CHECKED __attribute__((warn_unused_result))
#define TCS_PRINTF(text, first) __attribute__((format(printf, text, first)))
#define TCS_NORETURN __attribute__((noreturn))
#else
#define TCS_CHECKED
#define TCS_PRINTF(text, first)
#define TCS_NORETURN
#endif

/*
 * Fill `fault` and return `status`, so that a failing function ends in
 * `return fault_set(fault, TCS_LIMIT, at, "…", …);`.
 */
enum tcs_status fault_set(struct tcs_fault *fault, enum tcs_status status,
	uint64_t at, const char *format, ...) TCS_PRINTF(4, 5);

/* TCS_NO_MEMORY with a fixed text. */
enum tcs_status fault_memory(struct tcs_fault *fault);

/*
 * TCS_SYSTEM: "`what` `name`: `strerror(errno)`", as in
 * "cannot write out.glb: No space left on device".
 */
enum tcs_status fault_system(
	struct tcs_fault *fault, const char *what, const char *name);

#endif
