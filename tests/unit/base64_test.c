#include "base64.h"

#include <string.h>

#include "check.h"

static void
the_examples_of_the_rfc_come_out(void)
{
	static const char *const pairs[][2] = {{"", ""}, {"f", "Zg=="},
		{"fo", "Zm8="}, {"foo", "Zm9v"}, {"foob", "Zm9vYg=="},
		{"fooba", "Zm9vYmE="}, {"foobar", "Zm9vYmFy"}};

	for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++) {
		size_t length = strlen(pairs[i][0]), count;
		unsigned char bytes[8];
		char text[8];

		base64_encode(text, (const void *)pairs[i][0], length);
		CHECK(!memcmp(text, pairs[i][1], BASE64_LENGTH(length)));
		CHECK(!base64_decode(
			bytes, &count, pairs[i][1], strlen(pairs[i][1])));
		CHECK(count == length && !memcmp(bytes, pairs[i][0], count));
	}
}

static void
every_byte_comes_back(void)
{
	unsigned char in[256], out[258];
	char text[BASE64_LENGTH(256)];
	size_t count;

	for (int i = 0; i < 256; i++)
		in[i] = (unsigned char)i;
	for (size_t length = 250; length <= 256; length++) {
		base64_encode(text, in, length);
		CHECK(!base64_decode(out, &count, text, BASE64_LENGTH(length)));
		CHECK(count == length && !memcmp(in, out, length));
	}
}

static void
what_is_no_base64_is_refused(void)
{
	static const char *const bad[] = {"Z", "Zg", "Zg=", "Zg=a",
		"====", "Zh==", "Zm9=", "Zm9v====", "Z\xc3\xa4=", "Zm9v\n",
		"Zm-v"};
	unsigned char out[16];
	size_t count;

	for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
		CHECK(base64_decode(out, &count, bad[i], strlen(bad[i])) == -1);
}

static const struct check_test tests[] = {
	CHECK_TEST(the_examples_of_the_rfc_come_out),
	CHECK_TEST(every_byte_comes_back),
	CHECK_TEST(what_is_no_base64_is_refused),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
