/* An object or a prototype as JSON. */
#ifndef TESSERA_JSON_OBJECT_H
#define TESSERA_JSON_OBJECT_H

#include "json_print.h"
#include "tcs.h"

/*
 * Append the keys and values of an object that keeps the rules; no braces.
 * Runs become nesting: a feature holds its attributes, a geometry its shells
 * and polygons, a polygon its rings, vertices and triangles.
 */
void print_object(struct json_text *json, const struct tcs_object *object);

#endif
