#include "gltf_name.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>

static const char json_suffix[] = ".gltf";
static const char bin_suffix[] = ".bin";

bool
name_is_gltf(const char *name)
{
	size_t length = strlen(name), suffix = sizeof json_suffix - 1;

	return length > suffix &&
		!strcasecmp(name + length - suffix, json_suffix);
}

char *
name_of_bin(const char *name)
{
	size_t length = strlen(name);
	char *out;

	if (name_is_gltf(name))
		length -= sizeof json_suffix - 1;
	out = malloc(length + sizeof bin_suffix);
	if (out) {
		memcpy(out, name, length);
		memcpy(out + length, bin_suffix, sizeof bin_suffix);
	}
	return out;
}

static bool
is_unreserved(char c)
{
	return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
		(c >= '0' && c <= '9') || strchr("-._~", c);
}

char *
name_as_uri(const char *name)
{
	static const char digits[] = "0123456789ABCDEF";
	const char *slash = strrchr(name, '/');
	const char *at = slash ? slash + 1 : name;
	char *out = malloc(3 * strlen(at) + 1), *to = out;

	for (; out && *at; at++) {
		unsigned char c = (unsigned char)*at;

		if (is_unreserved(*at)) {
			*to++ = *at;
			continue;
		}
		*to++ = '%';
		*to++ = digits[c >> 4];
		*to++ = digits[c & 15];
	}
	if (out)
		*to = '\0';
	return out;
}
