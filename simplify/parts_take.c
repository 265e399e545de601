/* Parts that go, and what they carried: see parts.h. */
#include "parts.h"

enum { MOST_CARRIED = 4096 };

/* ---- who else carries -------------------------------------------------- */

/* Those that a part carries, directly or through others, behind it in the
   queue, all marked; false when they are too many. */
static bool
list_carried(struct parts *parts, uint32_t part)
{
	parts->mark++;
	parts->queue.count = 0;
	parts->queue.at[parts->queue.count++] = part;
	parts->marks.at[part] = parts->mark;
	for (size_t next = 0; next < parts->queue.count; next++) {
		uint32_t carrier = parts->queue.at[next];
		const struct part *own = &parts->at.at[carrier];

		for (uint32_t i = 0; own->children > 0 && i < own->link_count;
			i++) {
			uint32_t other = parts->links.at[own->first_link + i];

			if (parts->at.at[other].parent != carrier ||
				parts->marks.at[other] == parts->mark)
				continue;
			if (parts->queue.count > MOST_CARRIED)
				return false;
			parts->marks.at[other] = parts->mark;
			parts->queue.at[parts->queue.count++] = other;
		}
	}
	return true;
}

/* A part beside this one that stands, and not because of the one that goes. */
static uint32_t
other_carrier(const struct parts *parts, uint32_t part)
{
	const struct part *own = &parts->at.at[part];

	for (uint32_t i = 0; i < own->link_count; i++) {
		uint32_t other = parts->links.at[own->first_link + i];

		if (!parts->at.at[other].gone &&
			parts->marks.at[other] != parts->mark)
			return other;
	}
	return TCS_NONE;
}

static void
put_on_another(struct parts *parts, uint32_t part, uint32_t carrier)
{
	parts->marks.at[part] = 0;
	parts->carriers.at[parts->carriers.count++] =
		(struct part_carrier){part, carrier};
}

/* Find another carrier for all that a part carries, each after its own one. What
   there is none for stays marked, and so does the part. */
static void
find_carriers(struct parts *parts)
{
	size_t carried = parts->queue.count;

	parts->carriers.count = 0;
	for (size_t i = 1; i < carried; i++) {
		uint32_t part = parts->queue.at[i];
		uint32_t carrier = other_carrier(parts, part);

		if (carrier != TCS_NONE)
			put_on_another(parts, part, carrier);
	}
	for (size_t next = 0; next < parts->carriers.count; next++) {
		uint32_t carrier = parts->carriers.at[next].part;
		const struct part *own = &parts->at.at[carrier];

		for (uint32_t i = 0; i < own->link_count; i++) {
			uint32_t other = parts->links.at[own->first_link + i];

			if (parts->marks.at[other] == parts->mark &&
				other != parts->queue.at[0])
				put_on_another(parts, other, carrier);
		}
	}
}

/* List what a part carries, and find others that can; false when there is too
   much. Fails with TCS_NO_MEMORY. */
static enum tcs_status
look_for_carriers(
	struct parts *parts, uint32_t part, bool *fine, struct tcs_fault *fault)
{
	*fine = list_carried(parts, part);
	if (!*fine)
		return TCS_OK;
	if (array_grow(&parts->carriers, parts->queue.count))
		return fault_memory(fault);
	find_carriers(parts);
	return TCS_OK;
}

/* ---- taking away --------------------------------------------------------- */

static void
take_off(struct parts *parts, uint32_t part)
{
	uint32_t parent = parts->at.at[part].parent;

	if (parent != part)
		parts->at.at[parent].children--;
}

static void
put_on_others(struct parts *parts)
{
	for (size_t i = 0; i < parts->carriers.count; i++) {
		struct part_carrier moved = parts->carriers.at[i];

		take_off(parts, moved.part);
		parts->at.at[moved.part].parent = moved.carrier;
		parts->at.at[moved.carrier].children++;
	}
}

enum tcs_status
parts_take_away(
	struct parts *parts, uint32_t part, bool *gone, struct tcs_fault *fault)
{
	struct part *own = &parts->at.at[part];
	bool fine;
	enum tcs_status status = look_for_carriers(parts, part, &fine, fault);

	*gone = !status && fine &&
		parts->carriers.count == parts->queue.count - 1;
	if (!*gone)
		return status;
	put_on_others(parts);
	take_off(parts, part);
	own->parent = part;
	own->gone = true;
	parts->left.at[own->component]--;
	return TCS_OK;
}

enum tcs_status
parts_find_hanging(struct parts *parts, uint32_t part, struct tcs_fault *fault)
{
	bool fine;
	enum tcs_status status = look_for_carriers(parts, part, &fine, fault);

	parts->hanging.count = 0;
	if (status || !fine)
		return status;
	if (array_grow(&parts->hanging, parts->queue.count))
		return fault_memory(fault);
	for (size_t i = 0; i < parts->queue.count; i++)
		if (parts->marks.at[parts->queue.at[i]] == parts->mark)
			parts->hanging.at[parts->hanging.count++] =
				parts->queue.at[i];
	return TCS_OK;
}
