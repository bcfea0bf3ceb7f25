#include "scene/Loader.h"
#include "settings/ReadValues.h"

#include <limn/core/OutlineNormals.h>

namespace limn
{

namespace
{

using Materials = std::vector<std::shared_ptr<const Material>>;

/// The values that an object has unless it sets its own.
struct Inherited
{
    const Transform* parent = nullptr;
    bool active = true;
    int layer = 0;
    RenderingLayerMask renderingLayerMask{1};
    Materials materials;
    bool isOneMaterial = true; ///< one for all sub-meshes, from `material`
    bool bakeOutlineNormals = false;
    ShadowCastingMode shadowCastingMode = ShadowCastingMode::On;
};

/// Returns whether an object with these settings is looked at for its errors alone.
bool IsOnlyChecked(const Inherited& settings, const SceneLoader& loader)
{
    return !settings.active && loader.inactive == InactiveObjects::Check;
}

/// Returns a material by name. Returns null if it is only looked for, and as ReadMaterialName.
std::shared_ptr<const Material> MaterialOf(const YamlNode& node, const std::string& subject,
                                           const Inherited& settings, SceneLoader& loader)
{
    if (!IsOnlyChecked(settings, loader))
    {
        return ReadMaterialName(node, subject, loader);
    }
    FindMaterial(node, subject, loader);
    return nullptr;
}

void ReadMaterialNames(SceneMapReader& map, Inherited& settings, SceneLoader& loader)
{
    const YamlNode* one = map.Find("material");
    const YamlNode* many = map.Find("materials");
    if (one && many)
    {
        loader.diagnostics.Error(many->location(), map.SubjectOf("materials") +
                                                       ": there is a material already; keep one "
                                                       "of 'material' and 'materials'");
        return;
    }
    if (one)
    {
        settings.materials = {MaterialOf(*one, map.SubjectOf("material"), settings, loader)};
        settings.isOneMaterial = true;
    }
    if (many)
    {
        settings.materials.clear();
        settings.isOneMaterial = false;
        for (const auto& [item, place] : ReadItems(map, "materials", loader.diagnostics))
        {
            settings.materials.push_back(MaterialOf(item, place, settings, loader));
        }
    }
    if (IsOnlyChecked(settings, loader))
    {
        settings.materials.clear();
    }
}

MeshRenderer MakeRenderer(std::shared_ptr<const Mesh> mesh, const Inherited& settings,
                          SceneLoader& loader)
{
    MeshRenderer renderer;
    renderer.renderingLayerMask = settings.renderingLayerMask;
    renderer.shadowCastingMode = settings.shadowCastingMode;
    renderer.sharedMaterials = settings.materials;
    if (renderer.sharedMaterials.empty() && !IsOnlyChecked(settings, loader))
    {
        if (!loader.defaultMaterial)
        {
            loader.defaultMaterial = std::make_shared<const Material>(
                loader.references.assets().FindShader(k_DefaultShader), "Default-Material");
        }
        renderer.sharedMaterials = {loader.defaultMaterial};
    }
    if (settings.isOneMaterial && mesh)
    {
        renderer.sharedMaterials.resize(static_cast<std::size_t>(mesh->subMeshCount()),
                                        renderer.sharedMaterials.front());
    }
    if (settings.bakeOutlineNormals && mesh)
    {
        std::shared_ptr<const Mesh>& baked = loader.outlineMeshes[mesh->id()];
        baked = baked ? baked : WithOutlineNormals(*mesh);
        mesh = baked;
    }
    renderer.mesh = std::move(mesh);
    return renderer;
}

void ReadLayersOf(SceneMapReader& map, Inherited& settings, SceneLoader& loader)
{
    if (const YamlNode* layer = map.Find("layer"))
    {
        settings.layer =
            ReadLayerIndex(*layer, map.SubjectOf("layer"), loader.layers(), loader.diagnostics)
                .value_or(settings.layer);
    }
    ReadLayerMask(map, "renderingLayerMask", loader.renderingLayers(), loader.diagnostics,
                  settings.renderingLayerMask);
}

bool IsMeshFile(const YamlNode& node)
{
    const std::string extension = std::filesystem::path(node.scalar()).extension().string();
    return extension == ".gltf" || extension == ".glb";
}

/// Returns an object's mesh. Looks for errors alone, and returns null, if the object is only
/// checked; a file that exists is then not read.
std::shared_ptr<const Mesh> MeshOf(const YamlNode& node, const std::string& subject,
                                   const Inherited& settings, SceneLoader& loader)
{
    const bool isChecked = IsOnlyChecked(settings, loader);
    if (!isChecked || !IsMeshFile(node))
    {
        std::shared_ptr<const Mesh> mesh = ReadMesh(node, subject, loader);
        return isChecked ? nullptr : mesh;
    }
    AssetContext& assets = loader.references.assets();
    loader.references.Read(node, subject,
                           [&assets](const std::filesystem::path& path)
                           {
                               assets.Reach(path);
                               std::error_code ignored; // the reader says what is wrong
                               return std::filesystem::is_regular_file(path, ignored)
                                          ? nullptr
                                          : assets.LoadMesh(path);
                           });
    return nullptr;
}

void ReadObject(const YamlNode& node, const std::string& place, Inherited settings,
                SceneLoader& loader)
{
    const YamlNode* name = node.Find("name");
    const bool hasName = name && name->isScalar();
    const std::string subject = hasName ? "object '" + name->scalar() + "'" : place;
    SceneMapReader map(node, subject, scene_keys::k_Object, loader.diagnostics);
    GameObject& object = loader.asset.scene.Add(hasName ? name->scalar() : place);
    map.Read("name", object.name);

    bool active = true;
    map.Read("active", active);
    settings.active = settings.active && active;
    ReadLayersOf(map, settings, loader);
    ReadMaterialNames(map, settings, loader);
    map.Read("bakeOutlineNormals", settings.bakeOutlineNormals);
    map.Read("shadowCastingMode", k_ShadowCastingModes, settings.shadowCastingMode);
    object.activeSelf = settings.active;
    object.layer = settings.layer;
    object.transform.parent = settings.parent;
    ReadTransform(map, object.transform, loader.diagnostics);
    glm::vec3 turn(0.0f);
    if (map.Read("turn", turn))
    {
        loader.asset.turns.push_back({&object, object.transform.localRotation, turn});
    }
    if (const YamlNode* mesh = map.Find("mesh"))
    {
        object.renderer =
            MakeRenderer(MeshOf(*mesh, map.SubjectOf("mesh"), settings, loader), settings, loader);
    }
    settings.parent = &object.transform;
    for (const auto& [child, childPlace] : ReadItems(map, "children", loader.diagnostics))
    {
        ReadObject(child, childPlace, settings, loader);
    }
    map.Finish();
}

} // namespace

std::shared_ptr<const Mesh> ReadMesh(const YamlNode& node, const std::string& subject,
                                     SceneLoader& loader)
{
    AssetContext& assets = loader.references.assets();
    if (IsMeshFile(node))
    {
        return loader.references.Read(node, subject,
                                      [&assets](const std::filesystem::path& path)
                                      { return assets.LoadMesh(path); });
    }
    const std::optional<std::string> name = ReadString(node, subject, loader.diagnostics);
    const std::optional<PrimitiveType> type = name ? PrimitiveTypeFromName(*name) : std::nullopt;
    if (name && !type)
    {
        loader.diagnostics.Error(node.location(), subject + ": unknown mesh " +
                                                      UnknownName(*name, PrimitiveTypeNames()) +
                                                      " (a file's path ends in '.gltf' or '.glb')");
    }
    return type ? assets.Primitive(*type) : nullptr;
}

void ReadObjects(const YamlNode& node, SceneLoader& loader)
{
    for (const auto& [item, place] : ReadItems(node, "objects", loader.diagnostics))
    {
        ReadObject(item, place, {}, loader);
    }
}

} // namespace limn
