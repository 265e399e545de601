// How many different polygons libcitygml finds in a file.
#include <citygml/citygml.h>
#include <citygml/citymodel.h>
#include <citygml/cityobject.h>
#include <citygml/geometry.h>
#include <citygml/implictgeometry.h>
#include <citygml/polygon.h>

#include <cstdio>
#include <set>

using Polygons = std::set<const void *>;

static void
add_geometry(const citygml::Geometry &geometry, Polygons &found)
{
	for (unsigned i = 0; i < geometry.getPolygonsCount(); i++)
		found.insert(geometry.getPolygon(i).get());
	for (unsigned i = 0; i < geometry.getGeometriesCount(); i++)
		add_geometry(geometry.getGeometry(i), found);
}

static void
add_object(const citygml::CityObject &object, Polygons &found)
{
	for (unsigned i = 0; i < object.getGeometriesCount(); i++)
		add_geometry(object.getGeometry(i), found);
	for (unsigned i = 0; i < object.getImplicitGeometryCount(); i++) {
		const auto &implicit = object.getImplicitGeometry(i);

		for (unsigned j = 0; j < implicit.getGeometriesCount(); j++)
			add_geometry(implicit.getGeometry(j), found);
	}
	for (unsigned i = 0; i < object.getChildCityObjectsCount(); i++)
		add_object(object.getChildCityObject(i), found);
}

int
main(int argc, char **argv)
{
	citygml::ParserParams params;
	Polygons found;

	params.tesselate = false;
	params.optimize = false;
	params.keepVertices = true;
	if (argc != 2)
		return 2;
	auto model = citygml::load(argv[1], params);
	if (!model)
		return 1;
	for (unsigned i = 0; i < model->getNumRootCityObjects(); i++)
		add_object(model->getRootCityObject(i), found);
	std::printf("%zu\n", found.size());
	return 0;
}
