#include <algorithm>
#include <cstdio>
#include <exception>
#include <map>
#include <memory>
#include <new>
#include <ostream>
#include <string>
#include <vector>

#include <tiny_gltf.h>

extern "C" {
#include "fault.h"
#include "gltf_column.h"
#include "gltf_material.h"
#include "gltf_spool.h"
}

#include "gltf_assembly.h"
#include "gltf_splitter.h"

namespace
{

/* Objects that one call of tinygltf turns into JSON. */
constexpr std::size_t batch_size = 64;

constexpr char feature_extension[] = "EXT_mesh_features";
constexpr char metadata_extension[] = "EXT_structural_metadata";
constexpr char webp_extension[] = "EXT_texture_webp";
constexpr char instance_extension[] = "EXT_mesh_gpu_instancing";
constexpr char instance_ids_extension[] = "EXT_instance_features";

/* The only place where exceptions end. */
template <typename Work>
enum tcs_status
guarded(struct tcs_fault *fault, Work work) noexcept
{
	try {
		return work();
	} catch (const std::bad_alloc &) {
		return fault_memory(fault);
	} catch (const std::exception &problem) {
		return fault_set(fault, TCS_BAD_INPUT, TCS_NOWHERE,
			"cannot assemble the glTF: %s", problem.what());
	} catch (...) {
		return fault_set(fault, TCS_BAD_INPUT, TCS_NOWHERE,
			"cannot assemble the glTF");
	}
}

tinygltf::Value
value_of(const char *text)
{
	return tinygltf::Value(std::string(text));
}

tinygltf::Value
value_of(uint32_t number)
{
	return tinygltf::Value(static_cast<int>(number));
}

} // namespace

struct gltf_assembly {
	struct spool spools[MEMBERS] = {};
	tinygltf::Model batch; /* objects not yet written */
	tinygltf::Model rest; /* what is written once, at the end */
	tinygltf::Value::Object classes; /* of the schema */
	tinygltf::Value::Array tables;
	int sampler_of[TEXTURE_WRAPS] = {-1, -1, -1};
	bool has_webp = false;
	bool has_features = false;
	bool has_instances = false;
	std::vector<int> top; /* nodes under the root */
	int accessor_count = 0;
	int mesh_count = 0;
	int node_count = 0;

	~gltf_assembly()
	{
		for (struct spool &spool : spools)
			spool_close(&spool);
	}
};

static enum tcs_status
write_model(struct gltf_assembly *assembly, const tinygltf::Model &model,
	bool keep_rest, struct tcs_fault *fault)
{
	splitter sink(assembly->spools, keep_rest);
	std::ostream stream(&sink);
	tinygltf::TinyGLTF writer;
	bool done = writer.WriteGltfSceneToStream(&model, stream, false, false);

	if (sink.status) {
		*fault = sink.fault;
		return sink.status;
	}
	if (!done || !stream)
		return fault_set(fault, TCS_BAD_INPUT, TCS_NOWHERE,
			"cannot write the glTF's JSON");
	return TCS_OK;
}

static enum tcs_status
flush_batch(struct gltf_assembly *assembly, struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	if (!assembly->batch.nodes.empty() || !assembly->batch.meshes.empty())
		status = write_model(assembly, assembly->batch, false, fault);
	assembly->batch.accessors.clear();
	assembly->batch.meshes.clear();
	assembly->batch.nodes.clear();
	return status;
}

struct gltf_assembly *
assembly_new(const char *beside, struct tcs_fault *fault) noexcept
{
	std::unique_ptr<struct gltf_assembly> made;
	enum tcs_status status = guarded(fault, [&] {
		made = std::make_unique<struct gltf_assembly>();
		for (struct spool &spool : made->spools)
			spool_open(&spool, beside);
		return TCS_OK;
	});

	return status ? nullptr : made.release();
}

void
assembly_free(struct gltf_assembly *assembly) noexcept
{
	delete assembly;
}

/* ---- objects --------------------------------------------------------- */

static int
push_accessor(struct gltf_assembly *assembly,
	const struct assembly_accessor &from, int type)
{
	std::vector<tinygltf::Accessor> &all = assembly->batch.accessors;

	all.emplace_back();
	all.back().bufferView = static_cast<int>(from.view);
	all.back().byteOffset = static_cast<std::size_t>(from.offset);
	all.back().componentType = from.component;
	all.back().count = from.count;
	all.back().type = type;
	return assembly->accessor_count++;
}

static tinygltf::Value
feature_sets(const uint32_t counts[ASSEMBLY_SETS])
{
	static const char *const labels[ASSEMBLY_SETS] = {"object", "surface"};
	tinygltf::Value::Array sets;

	for (uint32_t i = 0; i < ASSEMBLY_SETS; i++)
		sets.emplace_back(
			tinygltf::Value::Object{{"attribute", value_of(i)},
				{"featureCount", value_of(counts[i])},
				{"label", value_of(labels[i])},
				{"propertyTable", value_of(i)}});
	return tinygltf::Value(tinygltf::Value::Object{
		{"featureIds", tinygltf::Value(std::move(sets))}});
}

static std::map<std::string, int>
push_vertices(struct gltf_assembly *assembly, const struct assembly_mesh &mesh)
{
	std::map<std::string, int> attributes;

	attributes["POSITION"] =
		push_accessor(assembly, mesh.positions, TINYGLTF_TYPE_VEC3);
	assembly->batch.accessors.back().minValues.assign(
		mesh.lower, mesh.lower + 3);
	assembly->batch.accessors.back().maxValues.assign(
		mesh.upper, mesh.upper + 3);
	if (mesh.normals.count)
		attributes["NORMAL"] = push_accessor(
			assembly, mesh.normals, TINYGLTF_TYPE_VEC3);
	for (int i = 0; i < ASSEMBLY_SETS && mesh.sets[0].count; i++)
		attributes["_FEATURE_ID_" + std::to_string(i)] = push_accessor(
			assembly, mesh.sets[i], TINYGLTF_TYPE_SCALAR);
	return attributes;
}

static void
push_mesh(struct gltf_assembly *assembly, const char *name,
	const struct assembly_mesh &mesh)
{
	std::map<std::string, int> attributes = push_vertices(assembly, mesh);
	int texcoords = mesh.texcoords.count
		? push_accessor(assembly, mesh.texcoords, TINYGLTF_TYPE_VEC2)
		: -1;
	tinygltf::Value sets = feature_sets(mesh.feature_counts);

	assembly->has_features |= mesh.sets[0].count > 0;
	assembly->batch.meshes.emplace_back();
	tinygltf::Mesh &made = assembly->batch.meshes.back();
	made.name = name;
	made.primitives.reserve(mesh.primitive_count);
	for (std::size_t i = 0; i < mesh.primitive_count; i++) {
		const struct assembly_primitive &from = mesh.primitives[i];

		made.primitives.emplace_back();
		tinygltf::Primitive &primitive = made.primitives.back();
		primitive.attributes = attributes;
		if (from.is_textured)
			primitive.attributes["TEXCOORD_0"] = texcoords;
		primitive.indices = push_accessor(
			assembly, from.indices, TINYGLTF_TYPE_SCALAR);
		primitive.material = static_cast<int>(from.material);
		primitive.mode = TINYGLTF_MODE_TRIANGLES;
		if (mesh.sets[0].count)
			primitive.extensions[feature_extension] = sets;
	}
}

enum tcs_status
assembly_add_mesh(struct gltf_assembly *assembly, const char *name,
	const struct assembly_mesh *mesh, uint32_t *mesh_number,
	struct tcs_fault *fault) noexcept
{
	return guarded(fault, [&] {
		push_mesh(assembly, name, *mesh);
		*mesh_number = static_cast<uint32_t>(assembly->mesh_count++);
		if (assembly->batch.meshes.size() < batch_size)
			return TCS_OK;
		return flush_batch(assembly, fault);
	});
}

constexpr double identity[16] = {
	1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

/* Number and keep a node. */
static int
push_node(struct gltf_assembly *assembly, tinygltf::Node &&node)
{
	assembly->batch.nodes.push_back(std::move(node));
	return assembly->node_count++;
}

static int
push_child(struct gltf_assembly *assembly, const struct assembly_child &child)
{
	tinygltf::Node node;

	node.name = child.name;
	node.mesh = static_cast<int>(child.mesh);
	if (!std::equal(child.matrix, child.matrix + 16, identity))
		node.matrix.assign(child.matrix, child.matrix + 16);
	node.extras = tinygltf::Value(
		tinygltf::Value::Object{{"object", value_of(child.rows[0])},
			{"surface", value_of(child.rows[1])}});
	return push_node(assembly, std::move(node));
}

enum tcs_status
assembly_add_node(struct gltf_assembly *assembly, const char *name,
	const struct assembly_mesh *mesh, const struct assembly_child *children,
	size_t child_count, struct tcs_fault *fault) noexcept
{
	return guarded(fault, [&] {
		tinygltf::Node node;

		node.name = name;
		if (mesh) {
			push_mesh(assembly, name, *mesh);
			node.mesh = assembly->mesh_count++;
		}
		for (std::size_t i = 0; i < child_count; i++)
			node.children.push_back(
				push_child(assembly, children[i]));
		assembly->top.push_back(push_node(assembly, std::move(node)));
		if (assembly->batch.nodes.size() < batch_size)
			return TCS_OK;
		return flush_batch(assembly, fault);
	});
}

static tinygltf::Value
push_places(
	struct gltf_assembly *assembly, const struct assembly_instances &from)
{
	tinygltf::Value::Object out;
	const auto add = [&](const std::string &name,
				 const struct assembly_accessor &accessor,
				 int type) {
		out[name] = tinygltf::Value(
			push_accessor(assembly, accessor, type));
	};

	add("TRANSLATION", from.translations, TINYGLTF_TYPE_VEC3);
	add("ROTATION", from.rotations, TINYGLTF_TYPE_VEC4);
	add("SCALE", from.scales, TINYGLTF_TYPE_VEC3);
	for (int i = 0; i < ASSEMBLY_SETS; i++)
		add("_FEATURE_ID_" + std::to_string(i), from.sets[i],
			TINYGLTF_TYPE_SCALAR);
	return tinygltf::Value(tinygltf::Value::Object{
		{"attributes", tinygltf::Value(std::move(out))}});
}

enum tcs_status
assembly_add_instances(struct gltf_assembly *assembly, const char *name,
	const struct assembly_instances *instances,
	struct tcs_fault *fault) noexcept
{
	return guarded(fault, [&] {
		tinygltf::Node node;

		node.name = name;
		node.mesh = static_cast<int>(instances->mesh);
		node.extensions[instance_extension] =
			push_places(assembly, *instances);
		node.extensions[instance_ids_extension] =
			feature_sets(instances->feature_counts);
		assembly->has_instances = true;
		assembly->top.push_back(push_node(assembly, std::move(node)));
		return TCS_OK;
	});
}

/* ---- what is written once ---------------------------------------------- */

enum tcs_status
assembly_add_view(struct gltf_assembly *assembly,
	const struct assembly_view *view, struct tcs_fault *fault) noexcept
{
	return guarded(fault, [&] {
		tinygltf::BufferView made;

		made.buffer = 0;
		made.byteOffset = static_cast<std::size_t>(view->offset);
		made.byteLength = static_cast<std::size_t>(view->length);
		made.byteStride = view->stride;
		made.target = view->target;
		assembly->rest.bufferViews.push_back(std::move(made));
		return TCS_OK;
	});
}

enum tcs_status
assembly_add_material(struct gltf_assembly *assembly,
	const struct material_look *look, struct tcs_fault *fault) noexcept
{
	return guarded(fault, [&] {
		tinygltf::Material made;

		made.name = look->name;
		made.pbrMetallicRoughness.baseColorFactor.assign(
			look->colour, look->colour + 4);
		made.pbrMetallicRoughness.metallicFactor = 0;
		made.pbrMetallicRoughness.roughnessFactor = look->roughness;
		made.emissiveFactor.assign(look->emissive, look->emissive + 3);
		made.doubleSided = look->double_sided;
		if (look->colour[3] < 1)
			made.alphaMode = "BLEND";
		else if (look->has_holes)
			made.alphaMode = "MASK";
		if (look->texture != MATERIAL_PLAIN)
			made.pbrMetallicRoughness.baseColorTexture.index =
				static_cast<int>(look->texture);
		assembly->rest.materials.push_back(std::move(made));
		return TCS_OK;
	});
}

enum tcs_status
assembly_add_image(struct gltf_assembly *assembly, uint32_t view,
	const char *mime, const char *name, struct tcs_fault *fault) noexcept
{
	return guarded(fault, [&] {
		tinygltf::Image made;

		made.bufferView = static_cast<int>(view);
		made.mimeType = mime;
		made.name = name;
		assembly->rest.images.push_back(std::move(made));
		return TCS_OK;
	});
}

static int
find_sampler(struct gltf_assembly *assembly, enum texture_wrap wrap)
{
	static const int modes[TEXTURE_WRAPS] = {TINYGLTF_TEXTURE_WRAP_REPEAT,
		TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT,
		TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE};
	std::vector<tinygltf::Sampler> &samplers = assembly->rest.samplers;
	int &number = assembly->sampler_of[wrap];

	if (number < 0) {
		tinygltf::Sampler made;

		made.magFilter = TINYGLTF_TEXTURE_FILTER_LINEAR;
		made.minFilter = TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_LINEAR;
		made.wrapS = made.wrapT = modes[wrap];
		number = static_cast<int>(samplers.size());
		samplers.push_back(std::move(made));
	}
	return number;
}

enum tcs_status
assembly_add_texture(struct gltf_assembly *assembly, uint32_t image,
	enum texture_wrap wrap, bool is_webp, struct tcs_fault *fault) noexcept
{
	return guarded(fault, [&] {
		tinygltf::Texture made;

		made.sampler = find_sampler(assembly, wrap);
		if (is_webp) {
			made.extensions[webp_extension] =
				tinygltf::Value(tinygltf::Value::Object{
					{"source", value_of(image)}});
			assembly->has_webp = true;
		} else {
			made.source = static_cast<int>(image);
		}
		assembly->rest.textures.push_back(std::move(made));
		return TCS_OK;
	});
}

/* How the extension spells a column type, and its value for "none". */
static void
describe_type(
	const struct assembly_property &property, tinygltf::Value::Object &out)
{
	const char *component = nullptr;
	tinygltf::Value none;

	switch (property.type) {
	case COLUMN_STRING:
		none = value_of("");
		break;
	case COLUMN_FLOAT64:
		component = "FLOAT64";
		none = tinygltf::Value(COLUMN_NO_NUMBER);
		break;
	case COLUMN_INT32:
		component = "INT32";
		none = tinygltf::Value(static_cast<int>(COLUMN_NO_INTEGER));
		break;
	case COLUMN_UINT8:
		component = "UINT8";
		none = tinygltf::Value(COLUMN_NO_TRUTH);
		break;
	case COLUMN_BOOLEAN:
		break;
	}
	out["type"] = value_of(property.type == COLUMN_STRING ? "STRING"
			: property.type == COLUMN_BOOLEAN     ? "BOOLEAN"
							      : "SCALAR");
	if (component)
		out["componentType"] = value_of(component);
	if (property.has_gaps && !property.required)
		out["noData"] = none;
}

static tinygltf::Value
describe_property(const struct assembly_property &property)
{
	tinygltf::Value::Object out;

	describe_type(property, out);
	out["name"] = value_of(property.name);
	if (property.description)
		out["description"] = value_of(property.description);
	if (property.semantic)
		out["semantic"] = value_of(property.semantic);
	if (property.required)
		out["required"] = tinygltf::Value(true);
	return tinygltf::Value(std::move(out));
}

static tinygltf::Value
place_property(const struct assembly_property &property)
{
	tinygltf::Value::Object out;

	out["values"] = value_of(property.values_view);
	if (property.type == COLUMN_STRING) {
		out["stringOffsets"] = value_of(property.offsets_view);
		out["stringOffsetType"] =
			value_of(property.wide_offsets ? "UINT64" : "UINT32");
	}
	return tinygltf::Value(std::move(out));
}

enum tcs_status
assembly_add_table(struct gltf_assembly *assembly, const char *class_name,
	uint32_t row_count, const struct assembly_property *properties,
	size_t property_count, struct tcs_fault *fault) noexcept
{
	return guarded(fault, [&] {
		tinygltf::Value::Object described, placed;

		for (std::size_t i = 0; i < property_count; i++) {
			described[properties[i].id] =
				describe_property(properties[i]);
			placed[properties[i].id] =
				place_property(properties[i]);
		}
		assembly->classes[class_name] =
			tinygltf::Value(tinygltf::Value::Object{
				{"properties", tinygltf::Value(described)}});
		assembly->tables.emplace_back(
			tinygltf::Value::Object{{"class", value_of(class_name)},
				{"count", value_of(row_count)},
				{"name", value_of(class_name)},
				{"properties", tinygltf::Value(placed)}});
		return TCS_OK;
	});
}

/* ---- the end ------------------------------------------------------------ */

static tinygltf::Value
describe_place(const struct assembly_root &root)
{
	tinygltf::Value::Object out;

	if (*root.crs)
		out["crs"] = value_of(root.crs);
	if (root.epsg)
		out["epsg"] = tinygltf::Value(root.epsg);
	if (root.epsg_up)
		out["epsgUp"] = tinygltf::Value(root.epsg_up);
	out["origin"] = tinygltf::Value(
		tinygltf::Value::Array{tinygltf::Value(root.origin[0]),
			tinygltf::Value(root.origin[1]),
			tinygltf::Value(root.origin[2])});
	out["originInTranslation"] =
		tinygltf::Value(root.origin_is_translation);
	return tinygltf::Value(std::move(out));
}

static void
add_metadata(struct gltf_assembly *assembly)
{
	tinygltf::Value::Object schema{{"id", value_of("tessera")},
		{"classes", tinygltf::Value(assembly->classes)}};

	if (assembly->tables.empty())
		return;
	assembly->rest.extensions[metadata_extension] = tinygltf::Value(
		tinygltf::Value::Object{{"schema", tinygltf::Value(schema)},
			{"propertyTables", tinygltf::Value(assembly->tables)}});
	assembly->rest.extensionsUsed.emplace_back(metadata_extension);
	if (assembly->has_features)
		assembly->rest.extensionsUsed.emplace_back(feature_extension);
}

static void
add_scene(struct gltf_assembly *assembly, const struct assembly_root &root)
{
	tinygltf::Node node;
	tinygltf::Scene scene;

	/* tinygltf turns a scene without any member into null. */
	scene.name = root.name;
	if (assembly->node_count) {
		node.name = root.name;
		node.matrix.assign(root.matrix, root.matrix + 16);
		node.extras = describe_place(root);
		node.children = assembly->top;
		scene.nodes.push_back(assembly->node_count);
		assembly->rest.nodes.push_back(std::move(node));
	}
	assembly->rest.scenes.push_back(std::move(scene));
	assembly->rest.defaultScene = 0;
}

/*
 * tinygltf names the size of a buffer only when it holds the bytes, so this
 * one member is spelled here.
 */
static enum tcs_status
add_buffer(struct gltf_assembly *assembly, const struct assembly_root &root,
	struct tcs_fault *fault)
{
	std::string text = "\"buffers\":[{\"byteLength\":" +
		std::to_string(root.buffer_size);

	if (!root.buffer_size)
		return TCS_OK;
	if (root.buffer_uri)
		text += ",\"uri\":\"" + std::string(root.buffer_uri) + '"';
	text += "}]";
	return spool_write(
		assembly->spools + REST, text.data(), text.size(), fault);
}

static enum tcs_status
write_rest(struct gltf_assembly *assembly, const struct assembly_root &root,
	struct tcs_fault *fault)
{
	enum tcs_status status = add_buffer(assembly, root, fault);

	if (status)
		return status;
	if (assembly->has_instances) {
		assembly->rest.extensionsUsed.emplace_back(instance_extension);
		assembly->rest.extensionsUsed.emplace_back(
			instance_ids_extension);
		assembly->rest.extensionsRequired.emplace_back(
			instance_extension);
	}
	if (assembly->has_webp) {
		assembly->rest.extensionsUsed.emplace_back(webp_extension);
		assembly->rest.extensionsRequired.emplace_back(webp_extension);
	}
	assembly->rest.asset.version = "2.0";
	assembly->rest.asset.generator = root.generator;
	assembly->rest.asset.extras = describe_place(root);
	add_metadata(assembly);
	add_scene(assembly, root);
	return write_model(assembly, assembly->rest, true, fault);
}

/* `{`, `"name":[…],` for what is not empty, the rest, `}`. */
static enum tcs_status
pour_members(struct gltf_assembly *assembly, FILE *to, uint64_t *size,
	const char *name, struct tcs_fault *fault)
{
	std::string text = "{";
	enum tcs_status status = TCS_OK;

	*size = 0;
	for (int i = 0; i < MEMBERS && !status; i++) {
		struct spool *spool = assembly->spools + i;

		if (!spool->size)
			continue;
		if (i < REST)
			text += '"' + std::string(member_names[i]) + "\":[";
		*size += text.size() + spool->size;
		if (to &&
			std::fwrite(text.data(), 1, text.size(), to) !=
				text.size())
			return fault_system(fault, "cannot write", name);
		if (to)
			status = spool_pour(spool, to, name, fault);
		text = i < REST ? "]," : "}";
	}
	*size += text.size();
	if (!status && to &&
		std::fwrite(text.data(), 1, text.size(), to) != text.size())
		status = fault_system(fault, "cannot write", name);
	return status;
}

enum tcs_status
assembly_finish(struct gltf_assembly *assembly,
	const struct assembly_root *root, uint64_t *json_size,
	struct tcs_fault *fault) noexcept
{
	return guarded(fault, [&] {
		enum tcs_status status = flush_batch(assembly, fault);

		if (!status)
			status = write_rest(assembly, *root, fault);
		return status
			? status
			: pour_members(assembly, nullptr, json_size, "", fault);
	});
}

enum tcs_status
assembly_pour(struct gltf_assembly *assembly, FILE *to, const char *name,
	struct tcs_fault *fault) noexcept
{
	return guarded(fault, [&] {
		uint64_t size;

		return pour_members(assembly, to, &size, name, fault);
	});
}
