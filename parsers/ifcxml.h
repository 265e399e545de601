/*
 * ifcXML as the text of a STEP file, so that whatever reads the one reads the
 * other.
 *
 * Both spellings are taken: that of IFC2X3, where each attribute is an element
 * and an instance stands within it, and that of IFC4 and later, where simple
 * values are XML attributes, an element that is called like an attribute may be
 * the instance itself, and relations stand as inverse attributes within what
 * they relate. Which schema it is, the namespace says.
 *
 * Instances get new numbers, in the order in which they, or links to them, first
 * appear. Attributes that are not in the schemas of ifc_schema.h are counted
 * and left out, and so are instances of entities that are not there.
 *
 * source: ISO 10303-28 (2007), "ifcXML4 Specification Methodology" of
 * buildingSMART.
 */
#ifndef TESSERA_IFCXML_H
#define TESSERA_IFCXML_H

#include <stdbool.h>

#include "report.h"
#include "step_load.h"

enum { IFCXML_MOST_DEPTH = 1000 }; /* of elements */

/* Whether the bytes begin as XML does, in UTF-8 or UTF-16. */
bool ifcxml_is(const char *bytes, size_t length);

/*
 * Append the text of a STEP file to `out`. Memory grows with what is read.
 * Fails with TCS_BAD_INPUT for what is not well-formed, declares entities or is
 * in no namespace of IFC, with TCS_LIMIT for elements that nest too deep, with
 * TCS_NO_MEMORY.
 */
enum tcs_status ifcxml_decode(const char *bytes, size_t length,
	struct step_bytes *out, struct report *report,
	struct tcs_fault *fault) TCS_CHECKED;

#endif
