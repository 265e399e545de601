#include <string.h>

#include "ifc_attributes.h"
#include "number.h"

/* Positions in IfcPostalAddress. */
enum {
	PURPOSE,
	DESCRIPTION,
	OWN_PURPOSE,
	INSIDE,
	LINES,
	BOX,
	TOWN,
	REGION,
	POST_CODE,
	COUNTRY,
	ADDRESS_PARTS
};

static const char *const part_names[ADDRESS_PARTS] = {"Purpose", "Description",
	"UserDefinedPurpose", "InternalLocation", "AddressLines", "PostalBox",
	"Town", "Region", "PostalCode", "Country"};

/* A value of an address; one that says nothing becomes unset. */
static void
part_judge(struct step_value *value)
{
	struct step_value walk = *value, item;
	bool said = value->kind == STEP_ENUMERATION ||
		(value->kind == STEP_STRING && value->length);

	while (walk.kind == STEP_LIST &&
		step_next(&walk.list, &item) > STEP_END)
		said |= item.kind == STEP_STRING && item.length;
	if (!said)
		value->kind = STEP_UNSET;
}

/* The parts of a postal address; false where it says nothing. */
static bool
address_read(const struct ifc_file *file, uint32_t address,
	struct step_value parts[ADDRESS_PARTS])
{
	bool said = false;

	if (ifc_entity_of(file, address) != IFC_POSTALADDRESS)
		return false;
	for (int i = 0; i < ADDRESS_PARTS; i++) {
		parts[i] = ifc_value(file, address, i);
		part_judge(parts + i);
		said |= parts[i].kind != STEP_UNSET;
	}
	return said;
}

/* The first parts, those that are there, by their own names as a set. */
static enum tcs_status
parts_write(struct ifc_saying *saying, const char *name,
	const struct step_value *parts, int count, struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;
	uint32_t set = TCS_NONE;

	for (int i = 0; i < count && !status; i++) {
		if (parts[i].kind == STEP_UNSET)
			continue;
		if (set == TCS_NONE)
			status = ifc_attribute_set(
				saying, TCS_NONE, name, &set, fault);
		if (!status)
			status = ifc_attribute_value(saying, set, part_names[i],
				parts + i, "", fault);
	}
	return status;
}

/* ---- as CityGML has it --------------------------------------------------- */

struct writing {
	struct ifc_saying *saying;
	const struct step_value *parts;
	enum tcs_status status; /* of all so far */
	struct tcs_fault *fault;
};

static uint32_t
element(struct writing *writing, uint32_t parent, const char *name)
{
	uint32_t set = TCS_NONE;

	if (!writing->status)
		writing->status = ifc_attribute_set(
			writing->saying, parent, name, &set, writing->fault);
	return set;
}

static void
leaf(struct writing *writing, uint32_t parent, const char *name, int part)
{
	if (!writing->status)
		writing->status = ifc_attribute_value(writing->saying, parent,
			name, writing->parts + part, "", writing->fault);
}

/* An element of a named type of its kind. */
static uint32_t
typed(struct writing *writing, uint32_t parent, const char *name,
	const char *type)
{
	uint32_t set = element(writing, parent, name);

	if (!writing->status)
		writing->status = ifc_attribute_string(writing->saying, set,
			"@Type", type, strlen(type), writing->fault);
	return set;
}

static bool
has(const struct writing *writing, int part)
{
	return writing->parts[part].kind != STEP_UNSET;
}

static void
locality_write(struct writing *writing, uint32_t parent)
{
	uint32_t at = typed(writing, parent, "Locality", "Town");

	leaf(writing, at, "LocalityName", TOWN);
	if (has(writing, BOX))
		leaf(writing, element(writing, at, "PostBox"), "PostBoxNumber",
			BOX);
	if (has(writing, LINES))
		leaf(writing, typed(writing, at, "Thoroughfare", "Street"),
			"ThoroughfareName", LINES);
	if (has(writing, POST_CODE))
		leaf(writing, element(writing, at, "PostalCode"),
			"PostalCodeNumber", POST_CODE);
}

/* The address property of CityGML, in xAL 2.0. */
static enum tcs_status
property_write(struct ifc_saying *saying, const struct step_value *parts,
	struct tcs_fault *fault)
{
	static const char *const path[] = {"address", "Address", "xalAddress",
		"AddressDetails", "Country"};
	struct writing writing = {saying, parts, TCS_OK, fault};
	size_t before = saying->out->attributes.count;
	uint32_t at = TCS_NONE;

	for (size_t i = 0; i < sizeof path / sizeof *path; i++)
		at = element(&writing, at, path[i]);
	leaf(&writing, at, "CountryName", COUNTRY);
	if (has(&writing, REGION)) {
		at = element(&writing, at, "AdministrativeArea");
		leaf(&writing, at, "AdministrativeAreaName", REGION);
	}
	if (has(&writing, LINES) || has(&writing, BOX) || has(&writing, TOWN) ||
		has(&writing, POST_CODE))
		locality_write(&writing, at);
	for (size_t i = before; i < saying->out->attributes.count; i++)
		saying->out->attributes.at[i].flags = 0;
	return writing.status;
}

/* The property, and what it has no place for. */
static enum tcs_status
building_write(
	struct ifc_saying *saying, uint32_t address, struct tcs_fault *fault)
{
	struct step_value parts[ADDRESS_PARTS];
	enum tcs_status status = TCS_OK;
	bool said = false;

	if (!address_read(&saying->model->file, address, parts))
		return TCS_OK;
	for (int i = LINES; i < ADDRESS_PARTS; i++)
		said |= parts[i].kind != STEP_UNSET;
	if (said)
		status = property_write(saying, parts, fault);
	return status
		? status
		: parts_write(saying, "BuildingAddress", parts, LINES, fault);
}

/* ---- latitude and longitude ---------------------------------------------- */

static enum tcs_status
degrees_write(struct ifc_saying *saying, const char *name, double degrees,
	struct tcs_fault *fault)
{
	char text[NUMBER_LENGTH];
	const struct step_value value = {
		.kind = STEP_REAL,
		.real = degrees,
		.text = text,
		.length = number_print(text, degrees),
	};

	return ifc_attribute_value(
		saying, TCS_NONE, name, &value, "deg", fault);
}

/* Degrees, minutes, seconds and millionths of those, all of one sign. */
static enum tcs_status
angle_write(struct ifc_saying *saying, uint32_t site, const char *name,
	struct tcs_fault *fault)
{
	static const double parts[] = {1, 60, 3600, 3600e6};
	const struct ifc_file *file = &saying->model->file;
	struct step_value list = ifc_value(file, site,
		ifc_attribute(file->version, ifc_entity_of(file, site), name));
	double read[4], degrees = 0;
	size_t count;

	if (list.kind != STEP_LIST)
		return TCS_OK;
	count = step_numbers(&list.list, read, 4);
	if (count < 3)
		return TCS_OK;
	for (size_t i = 0; i < count; i++)
		degrees += read[i] / parts[i];
	return degrees_write(saying, name, degrees, fault);
}

static enum tcs_status
site_write(struct ifc_saying *saying, uint32_t site, uint32_t address,
	struct tcs_fault *fault)
{
	struct step_value parts[ADDRESS_PARTS];
	enum tcs_status status =
		angle_write(saying, site, "RefLatitude", fault);

	if (!status)
		status = angle_write(saying, site, "RefLongitude", fault);
	if (!status && saying->model->has_north)
		status = degrees_write(
			saying, "TrueNorth", saying->model->north, fault);
	if (status || !address_read(&saying->model->file, address, parts))
		return status;
	return parts_write(saying, "SiteAddress", parts, ADDRESS_PARTS, fault);
}

enum tcs_status
ifc_whereabouts_write(
	struct ifc_saying *saying, uint32_t instance, struct tcs_fault *fault)
{
	const struct ifc_file *file = &saying->model->file;
	enum ifc_entity entity = ifc_entity_of(file, instance);
	enum ifc_version version = file->version;

	if (entity == IFC_BUILDING)
		return building_write(saying,
			ifc_target(file, instance,
				ifc_attribute(
					version, entity, "BuildingAddress")),
			fault);
	if (entity == IFC_SITE)
		return site_write(saying, instance,
			ifc_target(file, instance,
				ifc_attribute(version, entity, "SiteAddress")),
			fault);
	return TCS_OK;
}
