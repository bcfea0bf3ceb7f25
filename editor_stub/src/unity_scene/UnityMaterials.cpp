#include "unity_scene/UnityMaterials.h"

#include "console/Texts.h"
#include "models/TextMesh.h"
#include "shaders/KeywordsOfValues.h"
#include "shaders/UsedShaders.h"
#include "unity_scene/ModelMaterials.h"

#include <algorithm>
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
    return IsIn(ToLower(path.extension().string()),
                {".fbx", ".obj", ".dae", ".3ds", ".ply", ".stl"});
}

/// Reads the numbers of a file's values. One that is not finite is 0, with a note.
class NumberReader
{
public:
    NumberReader(const std::string& file, UnityNotes& notes) : m_File(file), m_Notes(notes) {}

    float Number(const UnityNode& node) const
    {
        const float value = NumberOf(node, 0.0f);
        if (std::isfinite(value))
        {
            return value;
        }
        m_Notes.Add(m_File, node.line(),
                    "'" + std::string(node.text()) + "' is not finite; it is 0");
        return 0.0f;
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
    for (const std::string& keyword : material.shader()->initialKeywords())
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
    for (std::string_view word = TakeWord(words); !word.empty(); word = TakeWord(words))
    {
        material.EnableKeyword(std::string(word));
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

/// Notes why there is no mesh.
/// @return null
std::shared_ptr<const Mesh> NoMesh(const UnityReader& user, const std::string& why)
{
    user.Note("m_Mesh", why + ", so nothing is drawn");
    return nullptr;
}
std::shared_ptr<const Mesh> NoMeshIn(const std::filesystem::path& file, std::int64_t fileID,
                                     const UnityReader& user)
{
    return NoMesh(user,
                  file.filename().string() + " has no mesh with the id " + std::to_string(fileID));
}

} // namespace

const Model* UnityMaterials::LoadModelOf(const std::string& guid)
{
    const auto [known, isNew] = m_Models.try_emplace(guid);
    std::optional<Model>& model = known->second;
    const std::filesystem::path* path = isNew ? m_Database.Find(guid) : nullptr;
    if (path != nullptr && IsModelFile(*path))
    {
        try
        {
            const std::string meta = path->string() + ".meta";
            const std::string text = limn::ReadFile(meta);
            const UnityTree tree(text, meta, 1);
            model = LoadModel(*path, ReadModelImport(tree.root()), m_Assets.importer());
            FindModelMaterials(*model, *path, m_Database.project());
        }
        catch (const AssetError& error)
        {
            m_Notes.Add(error.diagnostics());
        }
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
    const auto [known, isNew] = m_Prefabs.try_emplace(guid);
    if (const Model* model = isNew ? LoadModelOf(guid) : nullptr)
    {
        known->second =
            std::make_shared<const UnityFile>(PrefabTextOf(*model, guid), path->generic_string());
    }
    return known->second;
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
        return NoMesh(user, "it refers to an object that is no mesh");
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
        return Unread(path, user);
    }
    const auto header = std::ranges::find(file->headers(), fileID, &UnityHeader::fileID);
    if (header == file->headers().end() || header->classID != static_cast<int>(UnityClass::Mesh))
    {
        return NoMeshIn(path, fileID, user);
    }
    known->second = ReadMesh([&] { return file->Fields(*header); }, file->name());
    return known->second.mesh ? known->second.mesh : Unread(path, user);
}

/// Notes at the first who refers to a mesh's file what comes of it that it cannot be read. Another
/// note says what is wrong with the file.
/// @return null
std::shared_ptr<const Mesh> UnityMaterials::Unread(const std::filesystem::path& path,
                                                   const UnityReader& user)
{
    return m_UnreadMeshes.insert(path).second
               ? NoMesh(user,
                        path.filename().string() + " cannot be read, as the note about it explains")
               : nullptr;
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
        return NoMesh(user, m_Database.WhyNotFound(mesh));
    }
    if (IsIn(ToLower(path->extension().string()), {".asset", ".mesh", ".prefab"}))
    {
        return LoadTextMesh(*path, mesh.fileID, user);
    }
    if (!IsModelFile(*path))
    {
        return NoMesh(user, path->filename().string() + " is no model that limn reads");
    }
    if (model == nullptr)
    {
        return Unread(*path, user);
    }
    std::shared_ptr<const Mesh> found = model->FindMesh(mesh.fileID);
    return found || model->isLaterPart(mesh.fileID) ? found : NoMeshIn(*path, mesh.fileID, user);
}

std::shared_ptr<const Material>
UnityMaterials::Load(const UnityTarget& material, const UnityReader& user, const std::string& path)
{
    const UnityInstance* object = material.object;
    if (material.isNull() || (object != nullptr && object->classID != UnityClass::Material))
    {
        user.Note(path, "it is no material, so the part of the mesh that has it is magenta");
        return Magenta();
    }
    if (object == nullptr)
    {
        return Load(material.asset, user, path);
    }
    const std::string& file = object->scope->file->name();
    std::shared_ptr<const Material>& known = m_OwnMaterials[{file, object->fileID}];
    if (!known)
    {
        known = Make(object->fields, file);
    }
    return known;
}

std::shared_ptr<const Material> UnityMaterials::Load(const UnityReference& material,
                                                     const UnityReader& user,
                                                     const std::string& path)
{
    std::shared_ptr<const Material>& known = m_Materials[material];
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
        note(m_Database.WhyNotFound(material, "the material's guid"));
        return nullptr;
    }
    const std::string name = path->filename().string();
    if (const std::string graph = StrangeGraphOf(*path); !graph.empty())
    {
        note("the shader of " + name + " is the graph " + graph +
             ", which limn cannot translate, as the notes about it explain");
        return nullptr;
    }
    std::shared_ptr<const Material>& known = m_Materials[material];
    if (!known)
    {
        known = ReadFile(*path, material.fileID);
    }
    if (known == m_Magenta)
    {
        note(name + " is magenta, as the notes about it explain");
        return nullptr;
    }
    return known;
}

std::string UnityMaterials::StrangeGraphOf(const std::filesystem::path& material)
{
    try
    {
        const std::filesystem::path* path = &material; // Unity imports a material with a graph
        if (!IsShaderGraph(material))
        {
            const UnityNode fields = m_Database.FieldsOf(material, UnityClass::Material);
            path = m_Database.Find(ReadUnityReference(fields["m_Shader"]).guid);
        }
        return path != nullptr && IsShaderGraph(*path) && !ReadGraph(*path).shader
                   ? path->filename().string()
                   : "";
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
        user.Note(path, m_Database.WhyNotFound(material, "the material's guid") +
                            ", so the background is the camera's colour");
        return nullptr;
    }
    return Load(material, user, path);
}

std::shared_ptr<const Texture> UnityMaterials::LoadReflection(const UnityReference& cube,
                                                              const UnityReader& user)
{
    std::string problem;
    auto texture =
        m_Textures.Load(cube, TextureDimension::Cube, "the cube's guid", "no cube", problem);
    if (!problem.empty())
    {
        user.Note("m_CustomReflection", problem + ", so nothing is mirrored");
    }
    return texture;
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
                  m_Database.WhyNotFound(reference, "the material's guid") + ", so it is magenta");
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
    return ReadFile(*file, reference.fileID);
}

std::shared_ptr<const Material> UnityMaterials::ReadFile(const std::filesystem::path& path,
                                                         std::int64_t fileID)
{
    if (IsShaderGraph(path))
    {
        // Unity imports a graph as a shader and a material of it.
        const UnityShader graph = LoadGraph(path, UnityNode(), path.generic_string());
        auto material = std::make_shared<Material>(graph.shader);
        SetTextures(UnityNode(), path.generic_string(), graph, *material);
        return material;
    }
    const std::string file = path.generic_string();
    try
    {
        if (const UnityNode fields = m_Database.FieldsOf(path, UnityClass::Material, fileID))
        {
            return Make(fields, file);
        }
        if (m_Database.LoadFile(path))
        {
            m_Notes.Add(file, 0, "it holds no material, so the objects that have it are magenta");
        }
    }
    catch (const AssetError& error)
    {
        m_Notes.Add(error.diagnostics());
        m_Notes.Add(file, 0, "it cannot be read, so the objects that have it are magenta");
    }
    return Magenta();
}

std::shared_ptr<const Material> UnityMaterials::Make(const UnityNode& fields,
                                                     const std::string& file)
{
    try
    {
        const UnityShader shader = FindShader(fields, file);
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
        SetValues(fields, file, shader, *material);
        return material;
    }
    catch (const AssetError& error)
    {
        m_Notes.Add(error.diagnostics());
        m_Notes.Add(file, 0,
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
    if (path != nullptr && IsShaderGraph(*path))
    {
        return LoadGraph(*path, saved, material);
    }
    const std::filesystem::path* missing = m_Database.project().Find(reference.guid);
    const ShaderLabDocument* shipped =
        missing != nullptr ? ShippedShaders().FindFile(missing->filename().string()) : nullptr;
    if (shipped != nullptr)
    {
        return {m_Assets.FindShader(shipped->name)};
    }
    m_Notes.Add(material, 0,
                m_Database.WhyNotFound(reference, "its shader's guid") +
                    ", so the objects that have it are magenta");
    return {nullptr};
}

UnityShader UnityMaterials::ReadGraph(const std::filesystem::path& path)
{
    const auto [known, isNew] = m_Graphs.try_emplace(path);
    if (isNew)
    {
        const auto find = [this](const std::string& guid)
        {
            const std::filesystem::path* file = m_Database.Find(guid);
            return file != nullptr ? *file : std::filesystem::path();
        };
        try
        {
            TranslatedGraph graph = TranslateGraph(path, find);
            ShaderLabParseResult parsed = ParseShaderLab(graph.shaderLab, path.generic_string());
            known->second = {
                std::make_shared<const Shader>(parsed.TakeDocument(), m_Assets.compiler()),
                {},
                std::move(graph.textures)};
        }
        catch (const AssetError& error)
        {
            m_Notes.Add(error.diagnostics());
        }
    }
    return known->second;
}

UnityShader UnityMaterials::LoadGraph(const std::filesystem::path& path, const UnityNode& saved,
                                      const std::string& material)
{
    const UnityShader graph = ReadGraph(path);
    if (graph.shader)
    {
        return graph;
    }
    const FileContent content = TryReadFile(path, k_MaxGraphBytes);
    const MaterialStandIn standIn = StandInForGraph(content.bytes, saved);
    std::string shown;
    for (const auto& [name, property] : standIn.names)
    {
        shown += (shown.empty() ? " with its " : " and its ") + name + " as " + property;
    }
    m_Notes.Add(material, 0,
                "its shader is the graph " + path.filename().string() +
                    ", which limn cannot translate; " + standIn.shader + shown + " is used");
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
        for (const auto& [name, value] : PropertiesIn(saved[list]))
        {
            const ShaderPropertyId id = idOf(name);
            if (material.HasFloat(id))
            {
                material.SetFloat(id, read.Number(value));
            }
        }
    }
    for (const auto& [name, value] : PropertiesIn(saved["m_Colors"]))
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
    }
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
    else if (shader.standIn && material.GetFloat(ShaderPropertyId("_Surface")) == 1.0f)
    {
        // The shader that it stands for says so, in its tags or as a graph.
        material.SetRenderQueue(static_cast<int>(RenderQueue::Transparent));
    }
}

/// Returns the dimension of a texture property; Tex2D if the shader declares no such property.
static TextureDimension DimensionOf(const Shader& shader, const ShaderPropertyId& id)
{
    const auto& properties = shader.document().properties;
    const auto property = std::ranges::find(properties, id.name(), &ShaderProperty::name);
    return property == properties.end() ? TextureDimension::Tex2D : property->dimension;
}

std::string UnityMaterials::SetTexture(const UnityReference& texture, const ShaderPropertyId& id,
                                       Material& material)
{
    std::string problem;
    auto picture =
        m_Textures.Load(texture, DimensionOf(*material.shader(), id), "the texture's guid",
                        "no cube, volume or array, which the shader takes", problem);
    if (picture)
    {
        material.SetTexture(id, std::move(picture));
    }
    return problem;
}

void UnityMaterials::SetTextures(const UnityNode& list, const std::string& file,
                                 const UnityShader& shader, Material& material)
{
    const NumberReader read(file, m_Notes);
    std::set<std::string> saved;
    for (const auto& [name, value] : PropertiesIn(list))
    {
        const ShaderPropertyId id(shader.standIn ? shader.standIn->NameOf(name)
                                                 : std::string(name));
        if (!material.HasTexture(id))
        {
            continue;
        }
        const UnityNode scale = value["m_Scale"];
        const UnityNode offset = value["m_Offset"];
        material.SetTextureScale(id, {read.Number(scale["x"]), read.Number(scale["y"])});
        material.SetTextureOffset(id, {read.Number(offset["x"]), read.Number(offset["y"])});
        const UnityReference texture = ReadUnityReference(value["m_Texture"]);
        const std::string problem = texture.isNull() ? "" : SetTexture(texture, id, material);
        saved.insert(texture.isNull() ? "" : id.name());
        if (!problem.empty())
        {
            m_Notes.Add(file, value.line(),
                        std::string(name) + ": " + problem + ", so the shader's own is used");
        }
    }
    for (const GraphTexture& texture : shader.textures)
    {
        const ShaderPropertyId id(texture.property);
        if (!saved.contains(id.name()) && material.HasTexture(id))
        {
            const std::string problem = SetTexture({texture.fileID, texture.guid}, id, material);
            if (!problem.empty())
            {
                m_Notes.Add(shader.shader->document().file, 0,
                            "a texture of the graph: " + problem + ", so its default is used");
            }
        }
    }
}

} // namespace limn
