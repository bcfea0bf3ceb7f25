#include "models/ModelFile.h"

#include "models/AssimpModel.h"

#include <algorithm>
#include <cmath>
#include <limn/base/ByteStream.h>
#include <limn/base/Case.h>
#include <limn/base/ParseWhole.h>
#include <limn/base/ReadFile.h>
#define XXH_INLINE_ALL
#include <xxhash.h>

namespace limn
{

namespace
{

std::string NameOf(const std::map<std::int64_t, std::string>& names, std::int64_t fileID)
{
    const auto found = names.find(fileID);
    return found == names.end() ? std::string() : found->second;
}

void TransferModelSettings(auto& stream, auto& name, auto& import)
{
    stream.Values(name, import.globalScale, import.useFileScale, import.bakesAxisConversion,
                  import.preserveHierarchy, import.calculatesNormals, import.normalSmoothAngle,
                  import.tangents, import.swapUVChannels);
}

void TransferMesh(auto& stream, auto& mesh)
{
    const auto transfer = [&stream](auto&... arrays)
    {
        (stream.Array(arrays), ...);
    };
    stream.Value(mesh.name);
    auto& data = mesh.data;
    transfer(data.vertices, data.normals, data.tangents, data.colors, data.uv, data.uv2, data.uv3,
             data.uv4, data.uv5, data.uv6, data.uv7, data.triangles, data.subMeshes);
    stream.List(mesh.skin.bones, [&](auto& bone) { stream.Value(bone); });
    transfer(mesh.skin.bindPoses, mesh.skin.weights);
}

void TransferNode(auto& stream, auto& node)
{
    // The number of the mesh and one, or 0.
    std::uint64_t mesh = node.mesh ? *node.mesh + 1 : 0;
    std::uint64_t parent = node.parent;
    stream.Values(node.name, parent, mesh, node.position.x, node.position.y, node.position.z,
                  node.rotation.w, node.rotation.x, node.rotation.y, node.rotation.z, node.scale.x,
                  node.scale.y, node.scale.z);
    stream.List(node.materials, [&](auto& material) { stream.Value(material); });
    if constexpr (std::is_same_v<std::decay_t<decltype(stream)>, ByteReader>)
    {
        node.parent = static_cast<std::size_t>(parent);
        node.mesh = mesh > 0 ? std::optional(static_cast<std::size_t>(mesh - 1)) : std::nullopt;
    }
}

void TransferModel(auto& stream, auto& model)
{
    stream.List(model.nodes, [&](auto& node) { TransferNode(stream, node); });
    stream.List(model.meshes, [&](auto& mesh) { TransferMesh(stream, mesh); });
    stream.List(model.materials,
                [&](auto& material)
                {
                    auto& color = material.color;
                    stream.Values(material.name, color.r, color.g, color.b, color.a,
                                  material.texture);
                });
}

std::string ImportModel(const ImportedFile& file)
{
    ModelImport import;
    std::string ending;
    std::string name;
    ByteReader reader(file.settings);
    reader.Value(ending);
    TransferModelSettings(reader, name, import);
    const ModelContent model = ReadByAssimp(file.path, file.bytes, name, import);
    ByteWriter writer;
    TransferModel(writer, model);
    return writer.bytes();
}

constexpr std::string_view k_MeshPart = "_MeshPart"; ///< before a part's number in its name

constexpr ImportKind k_Model{"model", "model 4", ImportInWorker<ImportModel>};

/// The materials of an .obj lie in files beside it, which it names.
std::string MaterialFilesOf(const std::filesystem::path& path, std::string_view bytes)
{
    constexpr std::string_view k_Key = "mtllib ";
    std::string contents;
    for (std::size_t at = bytes.find(k_Key); at != bytes.npos; at = bytes.find(k_Key, at + 1))
    {
        const std::size_t first = at + k_Key.size();
        const std::size_t end = std::min(bytes.find_first_of("\r\n", first), bytes.size());
        const std::string name(bytes.substr(first, end - first));
        contents += TryReadFile(path.parent_path() / name).bytes;
    }
    return contents;
}

/// Materials were always External until Unity 2017.3, which gave them a location.
void ReadMaterialSettings(const UnityNode& settings, ModelImport& import)
{
    const auto isOff = [&settings](const char* key)
    {
        return settings[key].text() == "0";
    };
    if (isOff("importMaterials") || isOff("materialImportMode"))
    {
        import.materialLocation = ModelMaterialLocation::None;
    }
    else if (settings && (!settings["materialLocation"] || isOff("materialLocation")))
    {
        import.materialLocation = ModelMaterialLocation::External;
    }
    import.materialName =
        static_cast<ModelMaterialName>(std::clamp(NumberOf(settings["materialName"], 0), 0, 3));
    import.materialSearch =
        static_cast<ModelMaterialSearch>(std::clamp(NumberOf(settings["materialSearch"], 1), 0, 2));
}

} // namespace

ModelImport ReadModelImport(const UnityNode& meta)
{
    ModelImport import;
    const UnityNode importer = meta["ModelImporter"];
    const UnityNode meshes = importer["meshes"];
    const UnityNode space = importer["tangentSpace"];
    const float scale = NumberOf(meshes["globalScale"], 1.0f);
    import.globalScale = std::isfinite(scale) ? scale : 1.0f;
    import.useFileScale = NumberOf(meshes["useFileScale"], 1) != 0;
    import.bakesAxisConversion = NumberOf(meshes["bakeAxisConversion"], 0) != 0;
    import.preserveHierarchy = NumberOf(meshes["preserveHierarchy"], 0) != 0;
    import.swapUVChannels = NumberOf(meshes["swapUVChannels"], 0) != 0;
    import.calculatesNormals = NumberOf(space["normalImportMode"], 0) == 1;
    const float angle = NumberOf(space["normalSmoothAngle"], 60.0f);
    import.normalSmoothAngle = angle >= 0.0f && angle <= 180.0f ? angle : 60.0f;
    const int tangents = NumberOf(space["tangentImportMode"], -1);
    const int last = static_cast<int>(ModelTangents::CalculateLegacyWithSplitTangents);
    import.tangents = tangents >= 0 && tangents <= last ? static_cast<ModelTangents>(tangents)
                                                        : ModelTangents::CalculateMikk;
    for (const UnityNode entry : importer["fileIDToRecycleName"])
    {
        import.names[ParseWhole<std::int64_t>(entry.key()).value_or(0)] = entry.text();
    }
    for (const UnityNode entry : importer["internalIDToNameTable"])
    {
        for (const UnityNode id : entry["first"])
        {
            import.names[NumberOf(id, std::int64_t{0})] = entry["second"].text();
        }
    }
    for (const UnityNode entry : importer["externalObjects"])
    {
        import.materials[std::string(entry["first"]["name"].text())] =
            ReadUnityReference(entry["second"]);
    }
    ReadMaterialSettings(importer["materials"], import);
    return import;
}

Model LoadModel(const std::filesystem::path& path, const ModelImport& import,
                const Importer& importer)
{
    std::string bytes = ReadForImport(k_Model, path);
    std::string name = path.stem().string();
    const std::string ending = path.extension().string(); // it tells how the bytes are read
    ByteWriter settings;
    settings.Value(ending);
    TransferModelSettings(settings, name, import);
    settings.Value(ToLower(ending) == ".obj" ? MaterialFilesOf(path, bytes) : std::string());
    const FileCache::Entry entry = importer.Import(k_Model, path, settings.bytes(), bytes);
    ModelContent content;
    ByteReader reader(entry.payload());
    TransferModel(reader, content);
    Model model;
    try
    {
        for (ModelContent::NamedMesh& mesh : content.meshes)
        {
            model.meshes.push_back(
                std::make_shared<const Mesh>(std::move(mesh.name), std::move(mesh.data)));
            model.skins.push_back(std::move(mesh.skin));
        }
    }
    catch (const ContractError& error) // numbers of a mesh that are none
    {
        throw AssetError(path.generic_string(), {}, error.what());
    }
    model.nodes = std::move(content.nodes);
    model.materials = std::move(content.materials);
    model.import = import;
    return model;
}

std::int64_t HashedFileID(std::string_view text)
{
    return static_cast<std::int64_t>(XXH64(text.data(), text.size(), 0));
}

bool Model::isLaterPart(std::int64_t fileID) const
{
    const std::string name = NameOf(import.names, fileID);
    const std::size_t part = name.rfind(k_MeshPart);
    return part != name.npos && name.substr(part + k_MeshPart.size()) != "0" &&
           std::ranges::find(meshes, name, &Mesh::name) == meshes.end();
}

std::shared_ptr<const Mesh> Model::FindMesh(std::int64_t fileID) const
{
    const std::string name = NameOf(import.names, fileID);
    // The table names meshes of one name in their order.
    const auto isSame = [&name](const auto& known)
    {
        return known.first / 100'000 == static_cast<int>(UnityClass::Mesh) && known.second == name;
    };
    const auto number =
        std::count_if(import.names.begin(), import.names.lower_bound(fileID), isSame);
    std::map<std::string, int> counts;
    for (const auto& mesh : meshes)
    {
        const int count = counts[mesh->name()]++;
        const std::string text = "Type:Mesh->" + mesh->name() + std::to_string(count);
        if (name.empty() ? HashedFileID(text) == fileID : mesh->name() == name && count == number)
        {
            return mesh;
        }
    }
    if (name.empty() || isLaterPart(fileID))
    {
        return nullptr;
    }
    const std::string whole = name.substr(0, name.rfind(k_MeshPart));
    const auto found = std::ranges::find(meshes, whole, &Mesh::name);
    // A folded node gave its mesh its own name, and the root has the file's.
    const bool isOnly = meshes.size() == 1;
    return isOnly ? meshes.front() : found == meshes.end() ? nullptr : *found;
}

const ModelMaterial* Model::FindMaterial(std::int64_t fileID) const
{
    const std::string name = NameOf(import.names, fileID);
    const auto found = std::ranges::find_if(
        materials,
        [&](const ModelMaterial& material)
        {
            return name.empty() ? HashedFileID("Type:Material->" + material.name + "0") == fileID
                                : material.name == name;
        });
    return found == materials.end() ? nullptr : &*found;
}

} // namespace limn
