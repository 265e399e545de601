#include <string.h>

#include "check.h"
#include "utf8.h"

static void
characters_of_every_length_are_valid(void)
{
	static const struct {
		const char *bytes;
		size_t length;
	} good[] = {
		{"a", 1},
		{"\x7f", 1},
		{"\xc2\x80", 2},
		{"\xdf\xbf", 2},
		{"\xe0\xa0\x80", 3},
		{"\xed\x9f\xbf", 3},
		{"\xee\x80\x80", 3},
		{"\xef\xbf\xbf", 3},
		{"\xf0\x90\x80\x80", 4},
		{"\xf4\x8f\xbf\xbf", 4},
	};

	for (size_t i = 0; i < sizeof good / sizeof *good; i++) {
		CHECK(utf8_length(good[i].bytes, good[i].length) ==
			good[i].length);
		CHECK(utf8_valid(good[i].bytes, good[i].length));
		for (size_t cut = 1; cut < good[i].length; cut++)
			CHECK(!utf8_length(good[i].bytes, cut));
	}
}

static void
what_is_no_character_has_no_length(void)
{
	static const char *const bad[] = {
		"\x80",
		"\xbf",
		"\xc0\x80",
		"\xc1\xbf",
		"\xc2\x41",
		"\xe0\x9f\xbf",
		"\xed\xa0\x80",
		"\xed\xbf\xbf",
		"\xe1\x80\x41",
		"\xe1\x41\x80",
		"\xf0\x8f\xbf\xbf",
		"\xf4\x90\x80\x80",
		"\xf5\x80\x80\x80",
		"\xf1\x80\x80\x41",
		"\xf1\x80\x41\x80",
		"\xf8\x88\x80\x80\x80",
		"\xfe",
		"\xff",
	};

	for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
		CHECK(!utf8_length(bad[i], strlen(bad[i])));
		CHECK(!utf8_valid(bad[i], strlen(bad[i])));
	}
}

static void
a_bad_byte_is_found_at_any_place(void)
{
	char text[40];

	for (size_t at = 0; at < sizeof text; at++) {
		memset(text, 'x', sizeof text);
		CHECK(utf8_valid(text, sizeof text));
		text[at] = '\xe4';
		CHECK(!utf8_valid(text, sizeof text));
		if (at + 1 == sizeof text)
			continue;
		memcpy(text + at, "\xc3\xa4", 2);
		CHECK(utf8_valid(text, sizeof text));
		CHECK(!utf8_valid(text, at + 1));
	}
	CHECK(utf8_valid("", 0));
	CHECK(utf8_valid("a\0b", 3));
}

static const struct check_test tests[] = {
	CHECK_TEST(characters_of_every_length_are_valid),
	CHECK_TEST(what_is_no_character_has_no_length),
	CHECK_TEST(a_bad_byte_is_found_at_any_place),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
