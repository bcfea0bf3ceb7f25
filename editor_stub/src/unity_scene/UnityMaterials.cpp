#include "unity_scene/UnityMaterials.h"

#include "assets/PictureFile.h"
#include "models/TextMesh.h"
#include "shaders/KeywordsOfValues.h"
#include "shaders/UsedShaders.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limn/base/Case.h>
#include <limn/base/ReadFile.h>
#include <limn/features/Features.h>

namespace limn
{

namespace
{

bool IsModelFile(const std::filesystem::path& path)
{
    const std::string ending = ToLower(path.extension().string());
    return ending == ".fbx" || ending == ".obj" || ending == ".dae" || ending == ".3ds" ||
           ending == ".ply" || ending == ".stl";
}

/// Reads the numbers of a file's values. One that is not finite is 0, with a note.
class NumberReader
{
public:
    NumberReader(const std::string& file, UnityNotes& notes) : m_File(file), m_Notes(notes) {}

    float Number(const UnityNode& node) const
    {
        float value = 0.0f;
        const std::string_view text = node.text();
        std::from_chars(text.data(), text.data() + text.size(), value);
        if (!std::isfinite(value))
        {
            m_Notes.Add(m_File, node.line(), "'" + std::string(text) + "' is not finite; it is 0");
            value = 0.0f;
        }
        return value;
    }
    glm::vec4 Vector(const UnityNode& node) const
    {
        return {Number(node["r"]), Number(node["g"]), Number(node["b"]), Number(node["a"])};
    }

private:
    const std::string& m_File;
    UnityNotes& m_Notes;
};

constexpr std::uintmax_t k_MaxGraphBytes = std::uintmax_t{1} << 26;

/// The saved keywords decide; those that attributes of the shader would turn on are not saved where
/// they are off.
void SetSavedKeywords(const UnityNode& fields, Material& material)
{
    const std::vector<std::string> initial = material.shader()->initialKeywords();
    for (const std::string& keyword : initial)
    {
        material.DisableKeyword(keyword);
    }
    for (const char* list : {"m_ValidKeywords", "m_InvalidKeywords"})
    {
        for (const UnityNode keyword : fields[list])
        {
            material.EnableKeyword(std::string(keyword.text()));
        }
    }
    std::string_view words = fields["m_ShaderKeywords"].text();
    while (!words.empty())
    {
        const std::size_t end = std::min(words.find(' '), words.size());
        if (end > 0)
        {
            material.EnableKeyword(std::string(words.substr(0, end)));
        }
        words.remove_prefix(std::min(end + 1, words.size()));
    }
}

void SetKeywordsOf(const MaterialStandIn& standIn, Material& material)
{
    for (const auto& [name, value] : standIn.values)
    {
        const ShaderPropertyId id{std::string(name)};
        if (material.HasFloat(id))
        {
            material.SetFloat(id, value);
        }
    }
    SetKeywordsOfValues(material);
    if (standIn.isPremultiplied)
    {
        material.EnableKeyword("_ALPHAPREMULTIPLY_ON");
    }
}

/// Returns why there is nothing behind a reference.
/// @param guid  what the reference names: "the texture's guid"
std::string AbsenceOf(const UnityReference& reference, const UnityDatabase& database,
                      std::string_view guid = "its guid")
{
    return FindKnownAsset(reference).kind == UnityPackageAsset::Other
               ? "limn does not have this asset, which is built into Unity (fileID " +
                     std::to_string(reference.fileID) + ")"
               : database.WhyNotFound(reference.guid, guid);
}

} // namespace

const Model* UnityMaterials::LoadModelOf(const std::string& guid)
{
    const auto known = m_Models.find(guid);
    if (known != m_Models.end())
    {
        return known->second ? &*known->second : nullptr;
    }
    std::optional<Model>& model = m_Models[guid];
    const std::filesystem::path* path = m_Database.Find(guid);
    if (path == nullptr || !IsModelFile(*path))
    {
        return nullptr;
    }
    try
    {
        const std::string meta = path->string() + ".meta";
        const std::string text = ::limn::ReadFile(meta);
        const UnityTree tree(text, meta, 1);
        model = LoadModel(*path, ReadModelImport(tree.root()), m_Assets.importer());
    }
    catch (const AssetError& error)
    {
        m_Notes.Add(error.diagnostics());
    }
    return model ? &*model : nullptr;
}

std::shared_ptr<const UnityFile> UnityMaterials::LoadPrefab(const std::string& guid)
{
    const std::filesystem::path* path = m_Database.Find(guid);
    if (path == nullptr)
    {
        return nullptr;
    }
    if (!IsModelFile(*path))
    {
        return m_Database.LoadFile(*path);
    }
    const auto known = m_Prefabs.find(guid);
    if (known != m_Prefabs.end())
    {
        return known->second;
    }
    const Model* model = LoadModelOf(guid);
    return m_Prefabs[guid] = model != nullptr
                                 ? std::make_shared<const UnityFile>(PrefabTextOf(*model, guid),
                                                                     path->generic_string())
                                 : nullptr;
}

std::shared_ptr<const Mesh> UnityMaterials::LoadMesh(const UnityTarget& mesh,
                                                     const UnityReader& user)
{
    if (mesh.object == nullptr)
    {
        return LoadMesh(mesh.asset, user);
    }
    if (mesh.object->classID != UnityClass::Mesh)
    {
        user.Note("m_Mesh", "it refers to an object that is no mesh, so nothing is drawn");
        return nullptr;
    }
    const std::string& file = mesh.object->scope->file->name();
    const auto [known, isNew] = m_TextMeshes.try_emplace({file, mesh.object->fileID});
    if (isNew)
    {
        known->second = ReadMesh([&] { return mesh.object->fields; }, file);
    }
    return known->second.mesh;
}

const MeshSkin* UnityMaterials::FindSkin(const Mesh& mesh) const
{
    for (const auto& [place, known] : m_TextMeshes)
    {
        if (known.mesh.get() == &mesh)
        {
            return known.skin.isEmpty() ? nullptr : &known.skin;
        }
    }
    for (const auto& [guid, model] : m_Models)
    {
        for (std::size_t i = 0; model && i < model->meshes.size(); ++i)
        {
            if (model->meshes[i].get() == &mesh)
            {
                return model->skins[i].isEmpty() ? nullptr : &model->skins[i];
            }
        }
    }
    return nullptr;
}

std::shared_ptr<const Mesh> UnityMaterials::LoadTextMesh(const std::filesystem::path& path,
                                                         std::int64_t fileID,
                                                         const UnityReader& user)
{
    const auto [known, isNew] = m_TextMeshes.try_emplace({path.generic_string(), fileID});
    if (!isNew)
    {
        return known->second.mesh;
    }
    const std::shared_ptr<const UnityFile> file = m_Database.LoadFile(path);
    if (!file)
    {
        NoteUnread(path, user);
        return nullptr;
    }
    const auto header = std::ranges::find_if(
        file->headers(), [&](const UnityHeader& h)
        { return h.fileID == fileID && h.classID == static_cast<int>(UnityClass::Mesh); });
    if (header == file->headers().end())
    {
        user.Note("m_Mesh", path.filename().string() + " has no mesh with the id " +
                                std::to_string(fileID) + ", so nothing is drawn");
        return nullptr;
    }
    known->second = ReadMesh([&] { return file->Fields(*header); }, file->name());
    if (!known->second.mesh)
    {
        NoteUnread(path, user);
    }
    return known->second.mesh;
}

/// Notes at the first who refers to a mesh's file what comes of it that it cannot be read. Another
/// note says what is wrong with the file.
void UnityMaterials::NoteUnread(const std::filesystem::path& path, const UnityReader& user)
{
    if (m_UnreadMeshes.insert(path).second)
    {
        user.Note("m_Mesh", path.filename().string() +
                                " cannot be read, as the note about it explains, so nothing is "
                                "drawn");
    }
}

/// Returns the mesh. Adds a note and returns none if it is broken.
SkinnableMesh UnityMaterials::ReadMesh(const std::function<UnityNode()>& fields,
                                       const std::string& file)
{
    try
    {
        return ReadTextMesh(fields(), file);
    }
    catch (const AssetError& error)
    {
        m_Notes.Add(error.diagnostics());
        return {};
    }
}

std::shared_ptr<const Mesh> UnityMaterials::LoadMesh(const UnityReference& mesh,
                                                     const UnityReader& user)
{
    const UnityKnownAsset known = FindKnownAsset(mesh);
    if (known.kind == UnityPackageAsset::Mesh)
    {
        return m_Assets.Primitive(PrimitiveTypeFromName(known.name).value());
    }
    const std::filesystem::path* path = m_Database.Find(mesh.guid);
    const Model* model = path != nullptr ? LoadModelOf(mesh.guid) : nullptr;
    if (path == nullptr)
    {
        user.Note("m_Mesh", AbsenceOf(mesh, m_Database) + ", so nothing is drawn");
        return nullptr;
    }
    const std::string ending = ToLower(path->extension().string());
    if (ending == ".asset" || ending == ".mesh" || ending == ".prefab")
    {
        return LoadTextMesh(*path, mesh.fileID, user);
    }
    if (!IsModelFile(*path))
    {
        user.Note("m_Mesh",
                  path->filename().string() + " is no model that limn reads, so nothing is drawn");
        return nullptr;
    }
    if (model == nullptr)
    {
        NoteUnread(*path, user);
        return nullptr;
    }
    std::shared_ptr<const Mesh> found = model->FindMesh(mesh.fileID);
    if (!found && !model->isLaterPart(mesh.fileID))
    {
        user.Note("m_Mesh", path->filename().string() + " has no mesh with the id " +
                                std::to_string(mesh.fileID) + ", so nothing is drawn");
    }
    return found;
}

std::shared_ptr<const Material> UnityMaterials::Load(const UnityReference& material,
                                                     const UnityReader& user,
                                                     const std::string& path)
{
    if (material.isNull())
    {
        return Magenta();
    }
    std::shared_ptr<const Material>& known = m_Materials[{material.guid, material.fileID}];
    if (!known)
    {
        known = Read(material, user, path);
    }
    return known;
}

std::shared_ptr<const Material>
UnityMaterials::LoadForFeature(const UnityReference& material,
                               const std::function<void(const std::string& reason)>& note)
{
    const std::filesystem::path* path = m_Database.Find(material.guid);
    if (path == nullptr)
    {
        note(AbsenceOf(material, m_Database, "the material's guid"));
        return nullptr;
    }
    const std::string name = path->filename().string();
    if (const std::string graph = GraphOf(*path); !graph.empty())
    {
        note("the shader of " + name + " is the graph " + graph + ", which limn does not read");
        return nullptr;
    }
    std::shared_ptr<const Material>& known = m_Materials[{material.guid, material.fileID}];
    if (!known)
    {
        known = ReadFile(*path);
    }
    if (known == m_Magenta)
    {
        note(name + " is magenta, as the notes about it explain");
        return nullptr;
    }
    return known;
}

std::string UnityMaterials::GraphOf(const std::filesystem::path& material)
{
    const auto file = m_Database.LoadFile(material);
    const UnityHeader* header = file ? FindClass(*file, UnityClass::Material) : nullptr;
    if (header == nullptr)
    {
        return "";
    }
    try
    {
        const UnityReference shader = ReadUnityReference(file->Fields(*header)["m_Shader"]);
        const std::filesystem::path* path = m_Database.Find(shader.guid);
        const bool isGraph =
            path != nullptr && ToLower(path->extension().string()) == ".shadergraph";
        return isGraph ? path->filename().string() : "";
    }
    catch (const AssetError&) // ReadFile notes what is wrong with the file
    {
        return "";
    }
}

std::shared_ptr<const Material> UnityMaterials::LoadSkybox(const UnityReference& material,
                                                           const UnityReader& user)
{
    const std::string path = "m_SkyboxMaterial";
    if (FindKnownAsset(material).kind != UnityPackageAsset::Material &&
        m_Database.Find(material.guid) == nullptr)
    {
        user.Note(path, AbsenceOf(material, m_Database, "the material's guid") +
                            ", so the background is the camera's colour");
        return nullptr;
    }
    return Load(material, user, path);
}

std::shared_ptr<const Texture> UnityMaterials::LoadReflection(const UnityReference& cube,
                                                              const UnityReader& user)
{
    const std::string path = "m_CustomReflection";
    const std::filesystem::path* file = m_Database.Find(cube.guid);
    if (file == nullptr || !IsPictureFile(*file))
    {
        user.Note(path,
                  (file == nullptr ? AbsenceOf(cube, m_Database, "the cube's guid")
                                   : file->filename().string() + " is no picture that limn reads") +
                      ", so nothing is mirrored");
        return nullptr;
    }
    try
    {
        if (auto texture = m_Assets.LoadCubemap(*file))
        {
            return texture;
        }
        user.Note(path, file->filename().string() + " is no cube, so nothing is mirrored");
    }
    catch (const AssetError& error)
    {
        m_Notes.Add(error.diagnostics());
    }
    return nullptr;
}

std::shared_ptr<const Material> UnityMaterials::Magenta()
{
    if (!m_Magenta)
    {
        m_Magenta = std::make_shared<const Material>(MakeErrorShader(m_Assets.compiler()));
    }
    return m_Magenta;
}

std::shared_ptr<const Material> UnityMaterials::Read(const UnityReference& reference,
                                                     const UnityReader& user,
                                                     const std::string& path)
{
    const UnityKnownAsset known = FindKnownAsset(reference);
    if (known.kind == UnityPackageAsset::Material)
    {
        auto material = std::make_shared<Material>(FindByName(known.name, "a material of Unity's"));
        if (material->HasColor(ShaderPropertyId("_BaseColor")))
        {
            material->SetColor(ShaderPropertyId("_BaseColor"), {0.5f, 0.5f, 0.5f, 1.0f});
        }
        return material;
    }
    const std::filesystem::path* file = m_Database.Find(reference.guid);
    if (file == nullptr)
    {
        user.Note(path,
                  AbsenceOf(reference, m_Database, "the material's guid") + ", so it is magenta");
        return Magenta();
    }
    if (IsModelFile(*file))
    {
        const Model* model = LoadModelOf(reference.guid);
        const ModelMaterial* own =
            model != nullptr ? model->FindMaterial(reference.fileID) : nullptr;
        auto material = std::make_shared<Material>(m_Assets.FindShader(k_Lit));
        material->SetColor(ShaderPropertyId("_BaseColor"),
                           own != nullptr ? own->color : Color::white);
        return material;
    }
    return ReadFile(*file);
}

std::shared_ptr<const Material> UnityMaterials::ReadFile(const std::filesystem::path& path)
{
    if (ToLower(path.extension().string()) == ".shadergraph")
    {
        // Unity imports a graph as a shader and a material of it.
        const UnityShader graph = ReadGraph(path, UnityNode(), path.generic_string());
        return std::make_shared<const Material>(graph.shader);
    }
    const std::shared_ptr<const UnityFile> file = m_Database.LoadFile(path);
    const UnityHeader* header = file ? FindClass(*file, UnityClass::Material) : nullptr;
    if (header == nullptr)
    {
        if (file)
        {
            m_Notes.Add(file->name(), 0,
                        "it holds no material, so the objects that have it are magenta");
        }
        return Magenta();
    }
    try
    {
        const UnityNode fields = file->Fields(*header);
        const UnityShader shader = FindShader(fields, file->name());
        if (!shader.shader)
        {
            return Magenta();
        }
        if (const std::string builtIn = BuiltInPassOf(*shader.shader); !builtIn.empty())
        {
            m_Notes.Add(shader.shader->document().file, 0,
                        builtIn + ", so the objects that have it are magenta");
            return Magenta();
        }
        auto material = std::make_shared<Material>(shader.shader);
        SetValues(fields, file->name(), shader, *material);
        return material;
    }
    catch (const AssetError& error)
    {
        m_Notes.Add(error.diagnostics());
        m_Notes.Add(file->name(), 0,
                    "its shader cannot be used, as the notes about the shader explain, so the "
                    "objects that have it are magenta");
        return Magenta();
    }
}

std::shared_ptr<const Shader> UnityMaterials::FindByName(std::string_view name,
                                                         const std::string& material)
{
    if (auto shader = m_Assets.FindShader(name))
    {
        return shader;
    }
    m_Notes.Add(material, 0,
                "limn has no shader '" + std::string(name) + "'; " + k_Lit + " is used");
    return m_Assets.FindShader(k_Lit);
}

UnityShader UnityMaterials::FindShader(const UnityNode& fields, const std::string& material)
{
    const UnityReference reference = ReadUnityReference(fields["m_Shader"]);
    const UnityNode saved = fields["m_SavedProperties"];
    const UnityKnownAsset known = FindKnownAsset(reference);
    if (known.kind == UnityPackageAsset::Shader)
    {
        std::optional<MaterialStandIn> standIn = StandInFor(known.name, saved);
        return {FindByName(standIn ? standIn->shader : known.name, material), std::move(standIn)};
    }
    const std::filesystem::path* path = m_Database.Find(reference.guid);
    if (path != nullptr && ToLower(path->extension().string()) == ".shader")
    {
        return {m_Assets.LoadShader(*path)};
    }
    if (path != nullptr && ToLower(path->extension().string()) == ".shadergraph")
    {
        return ReadGraph(*path, saved, material);
    }
    const std::filesystem::path* missing = m_Database.project().Find(reference.guid);
    const ShaderLabDocument* shipped =
        missing != nullptr ? ShippedShaders().FindFile(missing->filename().string()) : nullptr;
    if (shipped != nullptr)
    {
        return {m_Assets.FindShader(shipped->name)};
    }
    m_Notes.Add(material, 0,
                AbsenceOf(reference, m_Database, "its shader's guid") +
                    ", so the objects that have it are magenta");
    return {nullptr};
}

UnityShader UnityMaterials::ReadGraph(const std::filesystem::path& path, const UnityNode& saved,
                                      const std::string& material)
{
    const FileContent content = TryReadFile(path, k_MaxGraphBytes);
    const MaterialStandIn standIn = StandInForGraph(content.bytes, saved);
    std::string shown;
    for (const auto& [name, property] : standIn.names)
    {
        shown += (shown.empty() ? " with its " : " and its ") + name + " as " + property;
    }
    m_Notes.Add(material, 0,
                "its shader is the graph " + path.filename().string() +
                    ", which limn does not read; " + standIn.shader + shown + " is used");
    return {m_Assets.FindShader(standIn.shader), standIn};
}

void UnityMaterials::SetValues(const UnityNode& fields, const std::string& file,
                               const UnityShader& shader, Material& material)
{
    const NumberReader read(file, m_Notes);
    const UnityNode saved = fields["m_SavedProperties"];
    const auto idOf = [&](std::string_view name)
    {
        return ShaderPropertyId(shader.standIn ? shader.standIn->NameOf(name) : std::string(name));
    };
    for (const char* list : {"m_Floats", "m_Ints"})
    {
        ForEachProperty(saved[list],
                        [&](std::string_view name, const UnityNode& value)
                        {
                            const ShaderPropertyId id = idOf(name);
                            if (material.HasFloat(id))
                            {
                                material.SetFloat(id, read.Number(value));
                            }
                        });
    }
    ForEachProperty(saved["m_Colors"],
                    [&](std::string_view name, const UnityNode& value)
                    {
                        const ShaderPropertyId id = idOf(name);
                        const glm::vec4 numbers = read.Vector(value);
                        if (material.HasColor(id))
                        {
                            material.SetColor(id, {numbers.r, numbers.g, numbers.b, numbers.a});
                        }
                        else if (material.HasVector(id))
                        {
                            material.SetVector(id, numbers);
                        }
                    });
    SetTextures(saved["m_TexEnvs"], file, shader, material);
    shader.standIn ? SetKeywordsOf(*shader.standIn, material) : SetSavedKeywords(fields, material);
    for (const UnityNode pass : fields["disabledShaderPasses"])
    {
        material.SetShaderPassEnabled(pass.text(), false);
    }
    const auto queue =
        static_cast<int>(std::clamp(read.Number(fields["m_CustomRenderQueue"]), -1.0f, 5000.0f));
    if (fields["m_CustomRenderQueue"] && queue >= 0)
    {
        material.SetRenderQueue(queue);
    }
}

/// Returns the dimension of a texture property; Tex2D if the shader declares no such property.
static TextureDimension DimensionOf(const Shader& shader, const ShaderPropertyId& id)
{
    const int property = shader.FindPropertyIndex(id.name());
    return property < 0
               ? TextureDimension::Tex2D
               : shader.document().properties[static_cast<std::size_t>(property)].dimension;
}

std::shared_ptr<const Texture> UnityMaterials::LoadPicture(const std::filesystem::path& path,
                                                           TextureDimension dimension)
{
    switch (dimension)
    {
    case TextureDimension::Tex2D:
        return m_Assets.LoadTexture(path);
    case TextureDimension::Cube:
        return m_Assets.LoadCubemap(path);
    default:
        return nullptr;
    }
}

void UnityMaterials::SetTextures(const UnityNode& list, const std::string& file,
                                 const UnityShader& shader, Material& material)
{
    ForEachProperty(
        list,
        [&](std::string_view name, const UnityNode& value)
        {
            const ShaderPropertyId id(shader.standIn ? shader.standIn->NameOf(name)
                                                     : std::string(name));
            if (!material.HasTexture(id))
            {
                return;
            }
            const NumberReader read(file, m_Notes);
            const UnityNode scale = value["m_Scale"];
            const UnityNode offset = value["m_Offset"];
            material.SetTextureScale(id, {read.Number(scale["x"]), read.Number(scale["y"])});
            material.SetTextureOffset(id, {read.Number(offset["x"]), read.Number(offset["y"])});
            const UnityReference texture = ReadUnityReference(value["m_Texture"]);
            if (texture.isNull())
            {
                return;
            }
            const std::filesystem::path* path = m_Database.Find(texture.guid);
            if (path == nullptr || !IsPictureFile(*path))
            {
                m_Notes.Add(
                    file, value.line(),
                    std::string(name) + ": " +
                        (path == nullptr
                             ? AbsenceOf(texture, m_Database, "the texture's guid")
                             : path->filename().string() + " is no picture that limn reads") +
                        ", so the shader's own is used");
                return;
            }
            try
            {
                if (auto picture = LoadPicture(*path, DimensionOf(*material.shader(), id)))
                {
                    material.SetTexture(id, std::move(picture));
                    return;
                }
                m_Notes.Add(file, value.line(),
                            std::string(name) + ": " + path->filename().string() +
                                " is no cube, volume or array, which the shader takes, so the "
                                "shader's own is used");
            }
            catch (const AssetError& error)
            {
                m_Notes.Add(error.diagnostics());
            }
        });
}

} // namespace limn
