#include "models/ModelFile.h"

#include "models/AssimpModel.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limn/base/ByteStream.h>
#include <limn/base/Case.h>
#include <limn/base/ReadFile.h>
#define XXH_INLINE_ALL
#include <xxhash.h>

namespace limn
{

namespace
{

template <typename Names>
std::string NameOf(const Names& names, std::int64_t fileID)
{
    const auto found = names.find(fileID);
    return found == names.end() ? std::string() : found->second;
}

void ReadNames(const UnityNode& importer, ModelImport& import)
{
    const auto number = [](std::string_view text)
    {
        std::int64_t value = 0;
        std::from_chars(text.data(), text.data() + text.size(), value);
        return value;
    };
    for (const UnityNode entry : importer["fileIDToRecycleName"])
    {
        import.names[number(entry.key())] = entry.text();
    }
    for (const UnityNode entry : importer["internalIDToNameTable"])
    {
        const UnityNode first = entry["first"];
        if (first.begin() != first.end())
        {
            import.names[number((*first.begin()).text())] = entry["second"].text();
        }
    }
}

} // namespace

ModelImport ReadModelImport(const UnityNode& meta)
{
    ModelImport import;
    const UnityNode importer = meta["ModelImporter"];
    const auto number = [](const UnityNode& node, auto& value)
    {
        const std::string_view text = node.text();
        std::from_chars(text.data(), text.data() + text.size(), value);
    };
    const UnityNode meshes = importer["meshes"];
    int useFileScale = 1;
    int preserves = 0;
    int normals = 0;
    int tangents = static_cast<int>(ModelTangents::CalculateMikk);
    int swaps = 0;
    number(meshes["globalScale"], import.globalScale);
    number(meshes["useFileScale"], useFileScale);
    number(meshes["preserveHierarchy"], preserves);
    number(meshes["fileIdsGeneration"], import.fileIdsGeneration);
    number(importer["tangentSpace"]["normalImportMode"], normals);
    number(importer["tangentSpace"]["normalSmoothAngle"], import.normalSmoothAngle);
    number(importer["tangentSpace"]["tangentImportMode"], tangents);
    number(meshes["swapUVChannels"], swaps);
    const bool isTangents =
        tangents >= 0 &&
        tangents <= static_cast<int>(ModelTangents::CalculateLegacyWithSplitTangents);
    import.tangents =
        isTangents ? static_cast<ModelTangents>(tangents) : ModelTangents::CalculateMikk;
    import.swapUVChannels = swaps != 0;
    import.globalScale = std::isfinite(import.globalScale) ? import.globalScale : 1.0f;
    const bool isAngle = import.normalSmoothAngle >= 0.0f && import.normalSmoothAngle <= 180.0f;
    import.normalSmoothAngle = isAngle ? import.normalSmoothAngle : 60.0f;
    import.useFileScale = useFileScale != 0;
    import.preserveHierarchy = preserves != 0;
    import.calculatesNormals = normals == 1;
    ReadNames(importer, import);
    for (const UnityNode entry : importer["externalObjects"])
    {
        import.materials[std::string(entry["first"]["name"].text())] =
            ReadUnityReference(entry["second"]);
    }
    return import;
}

namespace
{

void TransferModelSettings(auto& stream, auto& name, auto& import)
{
    stream.Values(name, import.globalScale, import.useFileScale, import.preserveHierarchy,
                  import.calculatesNormals, import.normalSmoothAngle, import.tangents,
                  import.swapUVChannels);
}

void TransferMesh(auto& stream, auto& mesh)
{
    stream.Value(mesh.name);
    auto& data = mesh.data;
    stream.Array(data.vertices);
    stream.Array(data.normals);
    stream.Array(data.tangents);
    stream.Array(data.colors);
    stream.Array(data.uv);
    stream.Array(data.uv2);
    stream.Array(data.uv3);
    stream.Array(data.uv4);
    stream.Array(data.uv5);
    stream.Array(data.uv6);
    stream.Array(data.uv7);
    stream.Array(data.triangles);
    stream.Array(data.subMeshes);
    auto& skin = mesh.skin;
    stream.List(skin.bones, [&](auto& bone) { stream.Value(bone); });
    stream.Array(skin.bindPoses);
    stream.Array(skin.weights);
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
                    stream.Values(material.name, color.r, color.g, color.b, color.a);
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

constexpr ImportKind k_Model{"model", "model 2", ImportInWorker<ImportModel>};

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

} // namespace

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
    std::map<std::string, int> counts;
    for (const auto& mesh : meshes)
    {
        const std::string text =
            "Type:Mesh->" + mesh->name() + std::to_string(counts[mesh->name()]++);
        if (name.empty() ? HashedFileID(text) == fileID : mesh->name() == name)
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
