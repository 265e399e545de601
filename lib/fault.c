#include "fault.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

enum tcs_status
fault_set(struct tcs_fault *fault, enum tcs_status status, uint64_t at,
	const char *format, ...)
{
	va_list list;

	fault->status = status;
	fault->at = at;
	va_start(list, format);
	vsnprintf(fault->text, sizeof fault->text, format, list);
	va_end(list);
	return status;
}

enum tcs_status
fault_memory(struct tcs_fault *fault)
{
	return fault_set(fault, TCS_NO_MEMORY, TCS_NOWHERE, "out of memory");
}

enum tcs_status
fault_system(struct tcs_fault *fault, const char *what, const char *name)
{
	return fault_set(fault, TCS_SYSTEM, TCS_NOWHERE, "%s %s: %s", what,
		name, strerror(errno));
}
