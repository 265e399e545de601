/* Names of the files of a glTF that comes as .gltf and .bin. */
#ifndef TESSERA_GLTF_NAME_H
#define TESSERA_GLTF_NAME_H

#include <stdbool.h>

/* Whether the name ends in ".gltf", in any case of letters. */
bool name_is_gltf(const char *name);

/*
 * The .bin beside a .gltf: "a/b.gltf" becomes "a/b.bin", "a/b" "a/b.bin".
 * Owned by the caller; NULL without memory.
 */
char *name_of_bin(const char *name);

/*
 * The relative URI of a file in the same folder: the name without its folders,
 * percent-encoded (RFC 3986, 2.1). Owned by the caller; NULL without memory.
 */
char *name_as_uri(const char *name);

#endif
