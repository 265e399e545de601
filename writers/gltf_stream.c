#include "gltf_stream.h"

#include <math.h>

#include "crew.h"
#include "gltf_shared.h"
#include "prototypes.h"

/* A record on its way through the crew. */
struct item {
	struct tcs_record record;
	struct tcs_object object; /* lent by the record */
	struct mesh mesh;
	struct report report;
	bool decoded;
};

struct passage {
	struct stream_settings settings;
	struct tcs_reader reader;
	struct prototypes prototypes;
	struct stream_head *head;
	struct city *city;
	struct report *report;
	struct progress *progress;
	struct converter sharing; /* of prototypes, as they are written */
	struct mesh shared; /* scratch: a prototype */
	bool has_origin;
	uint64_t objects; /* added */
};

/* ---- reading --------------------------------------------------------- */

static void
set_origin(struct passage *passage, struct tcs_point origin)
{
	const struct tcs_crs *crs = passage->head->head.crs.at;

	passage->head->origin = origin;
	passage->has_origin = true;
	frame_init(&passage->settings.convert.frame, crs, &origin);
}

static enum tcs_status
take_head(struct passage *passage, struct item *item, struct tcs_fault *fault)
{
	struct stream_head *head = passage->head;
	struct tcs_record empty = head->record;
	const struct tcs_crs *crs;
	enum tcs_status status;

	head->record = item->record;
	item->record = empty;
	status = head_decode(&head->head, &head->record, fault);
	if (status)
		return status;
	crs = head->head.crs.at;
	if (crs->flags & TCS_HAS_ORIGIN)
		set_origin(passage, crs->origin);
	return TCS_OK;
}

static enum tcs_status
decode_item(struct item *item, struct tcs_fault *fault)
{
	enum tcs_status status;

	if (item->decoded)
		return TCS_OK;
	status = object_decode(&item->object, &item->record, fault);
	item->decoded = !status;
	return status;
}

static enum tcs_status
find_origin(struct passage *passage, struct item *item, struct tcs_fault *fault)
{
	enum tcs_status status = decode_item(item, fault);
	const struct tcs_object *object = &item->object;
	struct tcs_point at;

	if (status)
		return status;
	if (object->vertices.count)
		at = object->vertices.at[0];
	else if (object->instances.count)
		at = object->instances.at[0].anchor;
	else
		return TCS_OK;
	set_origin(passage,
		(struct tcs_point){floor(at.x), floor(at.y), floor(at.z)});
	return TCS_OK;
}

static enum tcs_status
read_item(void *context, void *slot, bool *done, struct tcs_fault *fault)
{
	struct passage *passage = context;
	struct item *item = slot;
	enum tcs_status status =
		reader_next(&passage->reader, &item->record, fault);

	item->decoded = false;
	if (status)
		return status;
	switch (item->record.type) {
	case TCS_HEAD:
		return take_head(passage, item, fault);
	case TCS_PROTOTYPE:
		return prototypes_add(
			&passage->prototypes, &item->record, fault);
	case TCS_OBJECT:
		return passage->has_origin ? TCS_OK
					   : find_origin(passage, item, fault);
	case TCS_END:
		*done = true;
		return TCS_OK;
	default:
		return TCS_OK;
	}
}

/* ---- working --------------------------------------------------------- */

static const struct tcs_object *
get_prototype(const void *context, uint32_t number)
{
	return prototypes_get(context, number);
}

static enum tcs_status
work_item(void *context, void *slot, void *worker, struct tcs_fault *fault)
{
	struct passage *passage = context;
	struct item *item = slot;
	const struct prototype_source source = {
		get_prototype, &passage->prototypes};
	enum tcs_status status;

	report_clear(&item->report);
	if (item->record.type != TCS_OBJECT)
		return TCS_OK;
	status = decode_item(item, fault);
	return status
		? status
		: convert_object(worker, &passage->settings.convert, &source,
			  &item->object, &item->mesh, &item->report, fault);
}

/* ---- writing --------------------------------------------------------- */

static enum tcs_status
write_palette(
	struct passage *passage, struct item *item, struct tcs_fault *fault)
{
	struct tcs_palette palette = {.text = {NULL, 0, 0}};
	enum tcs_status status = palette_decode(&palette, &item->record, fault);

	if (!status)
		status = city_add_palette(
			passage->city, &palette, passage->report, fault);
	if (!status && passage->settings.strict)
		status = report_strict(passage->report, fault);
	palette_release(&palette);
	return status;
}

/* The mesh of an instance's prototype, where it is the first to show it. */
static enum tcs_status
share_prototype(struct passage *passage, const struct mesh_instance *instance,
	struct report *report, struct tcs_fault *fault)
{
	const struct tcs_object *prototype =
		prototypes_get(&passage->prototypes, instance->prototype);
	const char *name = object_text(prototype, prototype->features.at->id);
	char room[32];
	enum tcs_status status;

	if (shared_is_there(passage->city, instance))
		return TCS_OK;
	status = convert_prototype(&passage->sharing,
		&passage->settings.convert, prototype, instance->class,
		&passage->shared, report, fault);
	snprintf(room, sizeof room, "prototype#%u", instance->prototype);
	return status ? status
		      : shared_add(passage->city, instance, *name ? name : room,
				&passage->shared, report, fault);
}

static enum tcs_status
share_prototypes(
	struct passage *passage, struct item *item, struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	for (size_t i = 0; i < item->mesh.instances.count && !status; i++)
		status = share_prototype(passage, item->mesh.instances.at + i,
			&item->report, fault);
	return status;
}

static enum tcs_status
write_object(
	struct passage *passage, struct item *item, struct tcs_fault *fault)
{
	enum tcs_status status = share_prototypes(passage, item, fault);

	if (!status)
		status = city_add_object(passage->city, &item->object,
			&item->mesh, &item->report, fault);
	if (!status)
		status = report_add(&item->report, "objects", 1, fault);
	if (!status)
		status = report_merge(passage->report, &item->report, fault);
	if (!status && passage->settings.strict)
		status = report_strict(passage->report, fault);
	progress_show(passage->progress, ++passage->objects, 0, 0);
	return status;
}

static enum tcs_status
write_item(void *context, void *slot, struct tcs_fault *fault)
{
	struct passage *passage = context;
	struct item *item = slot;

	switch (item->record.type) {
	case TCS_PALETTE:
		return write_palette(passage, item, fault);
	case TCS_OBJECT:
		return write_object(passage, item, fault);
	default:
		return TCS_OK;
	}
}

/* ---- the whole ------------------------------------------------------- */

static void
release_item(void *slot)
{
	struct item *item = slot;

	object_release(&item->object);
	record_release(&item->record);
	mesh_release(&item->mesh);
	report_release(&item->report);
}

static void
release_converter(void *worker)
{
	converter_release(worker);
}

enum tcs_status
stream_to_city(const char *name, const struct stream_settings *settings,
	struct city *city, struct stream_head *head, struct report *report,
	struct progress *progress, struct tcs_fault *fault)
{
	struct passage passage = {
		.settings = *settings,
		.head = head,
		.city = city,
		.report = report,
		.progress = progress,
	};
	const struct crew_plan plan = {
		.context = &passage,
		.slot_size = sizeof(struct item),
		.worker_size = sizeof(struct converter),
		.read = read_item,
		.work = work_item,
		.write = write_item,
		.worker_release = release_converter,
		.slot_release = release_item,
	};
	enum tcs_status status =
		reader_open(&passage.reader, name, settings->max_record, fault);

	if (!status)
		status = crew_run(&plan, settings->jobs, fault);
	converter_release(&passage.sharing);
	mesh_release(&passage.shared);
	prototypes_release(&passage.prototypes);
	reader_close(&passage.reader);
	return status;
}

void
stream_head_release(struct stream_head *head)
{
	head_release(&head->head);
	record_release(&head->record);
}
