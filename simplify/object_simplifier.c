#include "object_simplifier.h"

#include <float.h>
#include <math.h>

#include "level_report.h"
#include "lod_home.h"

/* Triangles of an object that uses several threads, and whose memory is given
   back as soon as may be. */
#define LARGE 100000

/* In so many steps openings are dissolved. */
#define OPENING_BATCHES 16

/* Shares of the diagonal, see most_costs. */
#define WIDEST 0.2
#define FARTHEST_OFF 0.1

/* Give back what only looking at the mesh as it came takes. */
static void
release_what_prepares(struct object_simplifier *simplifier,
	const struct simplify_settings *settings)
{
	for (size_t i = 0; i < settings->level_count; i++)
		if (settings->levels[i].budget.kind == BUDGET_STRUCTURE)
			return;
	array_trim(&simplifier->sheets.opposites);
}

static enum tcs_status
prepare(struct object_simplifier *simplifier,
	const struct simplify_settings *settings, const struct tcs_object *in,
	struct tcs_fault *fault)
{
	struct component_set *set = &simplifier->source.set;
	struct collapse_settings first = {.base_ratio = settings->base_ratio,
		.contact_cost = INFINITY,
		.optimal = settings->placement == PLACE_OPTIMAL,
		.max_error = settings->max_error};
	struct collapse_regions regions;
	enum tcs_status status;
	double reach;

	status = lod_source_load(&simplifier->source, in, settings->source,
		&settings->crs, fault);

	if (!status)
		status = openings_find(&simplifier->openings, in, set, fault);
	if (!status)
		status = sheets_build(&simplifier->sheets, set, fault);
	if (!status)
		status = paint_charts_find(&simplifier->charts, in,
			&simplifier->source, &simplifier->sheets, fault);
	if (status)
		return status;
	set->jobs = set->triangles.count > LARGE ? settings->jobs : 1;
	array_trim(&set->edges.uses);
	reach = contact_reach(set);
	regions = (struct collapse_regions){simplifier->openings.are.at,
		simplifier->charts.numbers.count ? simplifier->charts.numbers.at
						 : NULL};
	status = seams_find(&simplifier->seams, set, &simplifier->sheets, reach,
		&simplifier->contacts, fault);
	if (!status)
		status = collapses_begin(&simplifier->collapses, set,
			&simplifier->sheets, &simplifier->seams, &regions,
			&first, fault);
	if (!status)
		status = removals_begin(&simplifier->removals,
			&simplifier->collapses, &simplifier->contacts, reach,
			settings->keep_interior, fault);
	if (!status)
		status = handles_find(&simplifier->handles, set,
			&simplifier->collapses, &simplifier->removals, fault);
	if (!status)
		status = merges_find(&simplifier->merges, set,
			&simplifier->collapses, &simplifier->removals, fault);
	if (!status)
		release_what_prepares(simplifier, settings);
	return status;
}

/* ---- down to a level ----------------------------------------------------- */

/* Doors and windows become part of their walls; false when none is left. */
static enum tcs_status
dissolve_openings(struct object_simplifier *simplifier, size_t count, bool *any,
	struct tcs_fault *fault)
{
	struct collapses *work = &simplifier->collapses;

	*any = openings_dissolve(&simplifier->openings, count);
	if (!*any)
		return TCS_OK;
	collapses_resume(work, &work->settings);
	return collapses_dissolve(work, simplifier->openings.homes.at, fault);
}

/* What nothing may cost: the shape of a square as wide as a fifth of the
   object's diagonal, off by half of that. What takes whole parts away or
   replaces them counts that steeply. */
struct most_costs {
	double collapse, other;
};

static struct most_costs
most_costs(const struct object_simplifier *simplifier)
{
	double diagonal = box_diagonal(&simplifier->source.set.bounds);
	double side = WIDEST * diagonal, off = FARTHEST_OFF * diagonal;
	double steep = removals_steep(&simplifier->removals, off);

	return (struct most_costs){fmax(side * side * off * off, DBL_MIN),
		fmax(side * side * steep, DBL_MIN)};
}

/* Collapse; dissolve openings, close handles, make parts one and take them away
   as soon as that is cheaper. */
static enum tcs_status
reach_target(struct object_simplifier *simplifier, size_t target,
	struct tcs_fault *fault)
{
	struct collapses *work = &simplifier->collapses;
	struct openings *openings = &simplifier->openings;
	struct removals *removals = &simplifier->removals;
	struct handles *handles = &simplifier->handles;
	struct merges *merges = &simplifier->merges;
	size_t batch = openings->by_area.count / OPENING_BATCHES + 1;
	enum tcs_status status = merges_aim(merges, target, fault);
	struct most_costs most = most_costs(simplifier);
	bool any;

	while (!status && work->face_count > target) {
		double opening = openings_next_cost(openings);
		double removal = removals_next_cost(removals);
		double handle = handles_next_cost(handles);
		double merge = merges_next_cost(merges);
		double other =
			fmin(fmin(opening, removal), fmin(handle, merge));

		status = collapses_run(
			work, target, fmin(other, most.collapse), fault);
		if (!status && work->wants_worths) {
			status = removals_look(removals, fault);
			continue;
		}
		if (status || work->face_count <= target || other >= most.other)
			break;
		if (handle <= other)
			status = handles_try(handles, fault);
		else if (merge <= other)
			status = merges_try(merges, fault);
		else if (removal < opening)
			status = removals_try(removals, fault);
		else
			status = dissolve_openings(
				simplifier, batch, &any, fault);
	}
	return status;
}

/* Whether contacts may break, at a price, from now on. */
static void
let_break(struct object_simplifier *simplifier, bool may)
{
	struct collapses *work = &simplifier->collapses;
	struct collapse_settings settings = work->settings;

	settings.contact_cost =
		may ? contact_cost(&simplifier->source.set) : INFINITY;
	if ((settings.contact_cost < INFINITY) !=
		(work->settings.contact_cost < INFINITY))
		collapses_resume(work, &settings);
}

/* Collapse down to a level: so that all holds, or, if a number of triangles is
   wanted, as well as may be. */
static enum tcs_status
reach_level(struct object_simplifier *simplifier,
	const struct simplify_level *level, size_t target,
	struct tcs_fault *fault)
{
	struct collapses *work = &simplifier->collapses;
	enum tcs_status status = TCS_OK;
	bool any;

	if (level->lod != LOD_IN_PLACE && level->lod <= 2)
		status = dissolve_openings(simplifier, SIZE_MAX, &any, fault);
	if (status)
		return status;
	let_break(simplifier, level->budget.kind != BUDGET_ERROR);
	if (level->budget.kind == BUDGET_ERROR)
		return collapses_run(work, 0, INFINITY, fault);
	return reach_target(simplifier, target, fault);
}

/* Per feature whether it hosts something that is simplified. */
static enum tcs_status
find_simplified_hosts(struct object_simplifier *simplifier,
	const struct tcs_object *in, struct tcs_fault *fault)
{
	const struct selection *selection = &simplifier->source.selection;

	array_clear(&simplifier->hosts);
	if (array_grow(&simplifier->hosts, in->features.count))
		return fault_memory(fault);
	simplifier->hosts.count = in->features.count;
	for (size_t i = 0; i < in->features.count; i++)
		simplifier->hosts.at[i] = false;
	for (size_t i = 0; i < in->geometries.count; i++)
		if (selection->geometries.at[i])
			simplifier->hosts
				.at[selection->hosts.at[in->geometries.at[i]
								.feature]] =
				true;
	return TCS_OK;
}

/* What is replaced is left out: by the level that takes its place. */
static bool
is_replaced(const struct object_simplifier *simplifier,
	const struct simplify_settings *settings, const struct tcs_object *in,
	uint32_t geometry)
{
	const struct tcs_geometry *own = &in->geometries.at[geometry];
	const struct selection *selection = &simplifier->source.selection;
	bool host = simplifier->hosts.at[selection->hosts.at[own->feature]];

	for (size_t i = 0; i < settings->level_count; i++)
		if (settings->levels[i].lod == LOD_IN_PLACE
				? selection->geometries.at[geometry]
				: settings->levels[i].lod == own->lod &&
					geometry_has_area(own) && host)
			return true;
	return false;
}

/* Which feature has what of another one at a level, as far as openings are
   concerned, too. */
static enum tcs_status
find_homes(struct object_simplifier *simplifier, const struct tcs_object *in,
	int lod, struct tcs_fault *fault)
{
	const struct openings *openings = &simplifier->openings;

	array_clear(&simplifier->homes);
	if (array_grow(&simplifier->homes, in->features.count))
		return fault_memory(fault);
	simplifier->homes.count = in->features.count;
	lod_homes_find(in, lod == LOD_IN_PLACE ? TCS_LOD_NONE : (unsigned)lod,
		simplifier->homes.at);
	for (size_t i = 0; i < in->features.count; i++)
		if (simplifier->homes.at[i] == i)
			simplifier->homes.at[i] = openings->homes.at[i];
	return TCS_OK;
}

/* What nothing could be taken from stays as it is, rings and all. */
static enum tcs_status
write_unchanged(struct object_simplifier *simplifier,
	const struct tcs_object *in, struct tcs_fault *fault)
{
	const struct selection *selection = &simplifier->source.selection;
	enum tcs_status status = TCS_OK;

	for (uint32_t i = 0; !status && i < in->geometries.count; i++)
		if (selection->geometries.at[i])
			status = lod_write_copy(&simplifier->writer, i, fault);
	return status;
}

/* The faces that are left are taken: the mesh is not asked any more. */
static void
release_mesh(struct object_simplifier *simplifier)
{
	struct component_set *set = &simplifier->source.set;
	struct sheets *sheets = &simplifier->sheets;

	collapses_release_mesh(&simplifier->collapses);
	array_release(&set->points);
	array_release(&set->numbers);
	array_release(&set->order);
	array_release(&sheets->nodes);
	array_release(&sheets->vertex_nodes);
	array_release(&sheets->triangle_faces);
	array_release(&sheets->corners);
}

static enum tcs_status
write_level(struct object_simplifier *simplifier, const struct tcs_object *in,
	const struct simplify_level *level, bool done, struct tcs_fault *fault)
{
	enum tcs_status status;

	if (level->lod == LOD_IN_PLACE && level_is_unchanged(simplifier))
		return write_unchanged(simplifier, in, fault);
	status = lod_faces_take(&simplifier->writer.faces, in,
		&simplifier->source, &simplifier->collapses, fault);
	if (done)
		release_mesh(simplifier);
	if (!status)
		status = find_homes(simplifier, in, level->lod, fault);
	if (!status)
		status = lod_write_level(&simplifier->writer,
			&simplifier->source, simplifier->homes.at, level->lod,
			fault);
	return status;
}

static enum tcs_status
write_kept(struct object_simplifier *simplifier,
	const struct simplify_settings *settings, const struct tcs_object *in,
	struct tcs_fault *fault)
{
	enum tcs_status status = find_simplified_hosts(simplifier, in, fault);

	lod_write_begin(&simplifier->writer, in, &simplifier->charts);
	for (uint32_t i = 0; !status && i < in->geometries.count; i++)
		if (!is_replaced(simplifier, settings, in, i))
			status = lod_write_copy(&simplifier->writer, i, fault);
	return status;
}

/* Nothing will be collapsed any more. */
static void
release_what_collapses(struct object_simplifier *simplifier)
{
	seams_release(&simplifier->seams);
	removals_release(&simplifier->removals);
	handles_release(&simplifier->handles);
	merges_end(&simplifier->merges);
	collapses_end(&simplifier->collapses);
	array_release(&simplifier->sheets.normals);
	array_release(&simplifier->sheets.opposites);
}

static enum tcs_status
make_level(struct object_simplifier *simplifier, const struct tcs_object *in,
	const struct simplify_level *level, bool last, struct report *report,
	struct tcs_fault *fault)
{
	struct collapses *work = &simplifier->collapses;
	bool done = last && simplifier->source.set.triangles.count > LARGE;
	size_t target;
	enum tcs_status status =
		face_budget_find(&level->budget, work, &target, fault);

	if (!status)
		status = reach_level(simplifier, level, target, fault);
	if (done)
		release_what_collapses(simplifier);
	if (!status)
		status = overlaps_part(&simplifier->overlaps, work, fault);
	if (!status)
		status = level_report_work(simplifier, in, report, fault);
	if (done)
		overlaps_release(&simplifier->overlaps);
	if (!status)
		status = write_level(simplifier, in, level, done, fault);
	if (!status)
		status = level_report(
			simplifier, in, level, target, report, fault);
	return status;
}

static void
release_all_but_writer(struct object_simplifier *simplifier)
{
	lod_source_release(&simplifier->source);
	sheets_release(&simplifier->sheets);
	paint_charts_release(&simplifier->charts);
	array_release(&simplifier->contacts);
	seams_release(&simplifier->seams);
	collapses_release(&simplifier->collapses);
	openings_release(&simplifier->openings);
	overlaps_release(&simplifier->overlaps);
	removals_release(&simplifier->removals);
	handles_release(&simplifier->handles);
	merges_release(&simplifier->merges);
	array_release(&simplifier->homes);
	array_release(&simplifier->hosts);
}

enum tcs_status
simplify_object(struct object_simplifier *simplifier,
	const struct simplify_settings *settings, const struct tcs_object *in,
	const struct tcs_object **out, struct report *report,
	struct tcs_fault *fault)
{
	enum tcs_status status = prepare(simplifier, settings, in, fault);

	*out = &simplifier->writer.to;
	if (!status)
		status = report_add(report, "triangles before",
			simplifier->source.set.triangles.count, fault);
	if (!status)
		status = write_kept(simplifier, settings, in, fault);
	for (size_t i = 0; !status && i < settings->level_count; i++)
		status = make_level(simplifier, in, &settings->levels[i],
			i + 1 == settings->level_count, report, fault);
	if (simplifier->source.set.triangles.count > LARGE)
		release_all_but_writer(simplifier);
	return status;
}

void
object_simplifier_release(struct object_simplifier *simplifier)
{
	release_all_but_writer(simplifier);
	lod_write_release(&simplifier->writer);
}
