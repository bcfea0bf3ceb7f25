#include "report/measure/StudyScene.h"

#include "selection/SceneSelection.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limn/core/Judge.h>
#include <limn/editor_stub/Overrides.h>
#include <limn/volume/YamlRead.h>
#include <map>

namespace limn::study
{

namespace
{

constexpr RenderingLayerMask k_Outlined = RenderingLayerMask::FromIndex(k_OutlinedLayer);

const ShaderPropertyId _BaseColor = Shader::PropertyToID("_BaseColor");
const ShaderPropertyId _Cull = Shader::PropertyToID("_Cull"); // of the Unlit shader

std::shared_ptr<const Material> BlackMaterial(AssetContext& assets, CullMode cull = CullMode::Back)
{
    auto material =
        std::make_shared<Material>(assets.FindShader("Universal Render Pipeline/Unlit"));
    material->SetColor(_BaseColor, Color::black);
    material->SetFloat(_Cull, static_cast<float>(cull));
    return material;
}

/// Returns the faces that the material's first program leaves out.
CullMode CullOf(const Material& material)
{
    if (material.passCount() == 0)
    {
        return CullMode::Back;
    }
    const auto& cull = material.shader()->passState(0).cull;
    if (cull.property.empty())
    {
        return cull.value;
    }
    const ShaderPropertyId id = Shader::PropertyToID(cull.property);
    return material.HasProperty(id) ? static_cast<CullMode>(material.GetFloat(id)) : CullMode::Back;
}

/// Returns whether what the material draws hides what is behind it.
bool IsOpaque(const Material& material)
{
    return material.renderQueue() <= RenderQueueRange::opaque.upperBound();
}

FilteringSettings FilterOf(SceneAsset& asset)
{
    for (const auto& feature : asset.renderer.features)
    {
        const FilterFinder found(*feature, true);
        if (feature->isActive() && found.hasRenderingLayers)
        {
            return found.filter;
        }
    }
    throw AssetError(asset.path.string(), {},
                     "no active feature outlines anything, so a report has no objects; add one "
                     "such as {type: ScreenSpaceOutlineRenderFeature, ...} whose m_LayerMask and "
                     "m_RenderingLayerMask select them");
}

/// Returns whether the camera would draw the object if it were in front of it.
bool IsDrawn(const GameObject& object, const Camera& camera)
{
    return object.activeSelf && object.renderer && object.renderer->enabled &&
           object.renderer->shadowCastingMode != ShadowCastingMode::ShadowsOnly &&
           LayerMask::FromIndex(object.layer).Intersects(camera.cullingMask);
}

/// Returns whether MarkOutlined has found the object.
bool IsOutlined(const GameObject& object)
{
    return object.renderer && object.renderer->renderingLayerMask.Intersects(k_Outlined);
}

bool IsTaken(const GameObject& object, const FilteringSettings& filter)
{
    const MeshRenderer& renderer = *object.renderer;
    return std::ranges::any_of(
        renderer.sharedMaterials,
        [&](const auto& material)
        {
            return material && JudgeMasks({material->renderQueue(), object.layer,
                                           renderer.renderingLayerMask, material->shader().get()},
                                          filter) == FilterVerdict::Drawn;
        });
}

/// Balls side by side, with gaps as wide as they are.
SceneAsset Balls(const CellId& id, AssetContext& assets)
{
    int count = 0;
    std::from_chars(id.variant.data(), id.variant.data() + id.variant.size(), count);
    SceneAsset asset = EmptyPicture(id.pictureWidth, id.pictureHeight);
    const double aspect = static_cast<double>(id.pictureWidth) / id.pictureHeight;
    const int columns = std::max(1, static_cast<int>(std::ceil(std::sqrt(count * aspect))));
    const int rows = (count + columns - 1) / columns;
    const glm::dvec2 pitch(static_cast<double>(id.pictureWidth) / columns,
                           static_cast<double>(id.pictureHeight) / std::max(1, rows));
    const auto diameter = static_cast<float>(0.5 * std::min(pitch.x, pitch.y));
    const auto mesh = assets.Primitive(PrimitiveType::Sphere);
    for (int i = 0; i < count; ++i)
    {
        Transform& place = AddOutlined(asset, "ball " + std::to_string(i), mesh, assets).transform;
        place.localPosition = {(i % columns + 0.5) * pitch.x - 0.5 * id.pictureWidth,
                               0.5 * id.pictureHeight - (i / columns + 0.5) * pitch.y, 0.0};
        // Flat enough to lie in front of the camera.
        place.localScale = {diameter, diameter, std::min(diameter, 100.0f)};
    }
    return asset;
}

ScreenTriangles OutlinedTriangles(const SceneAsset& asset)
{
    ScreenTriangles triangles;
    for (const auto& object : asset.scene.objects())
    {
        if (IsOutlined(*object))
        {
            const ScreenTriangles part = MeshTriangles(*object->renderer->mesh, object->transform,
                                                       asset.camera, asset.width, asset.height);
            triangles.insert(triangles.end(), part.begin(), part.end());
        }
    }
    return triangles;
}

} // namespace

const Technique& RequireTechnique(const AssetContext& assets, const std::string& name)
{
    const Technique* technique = FindTechnique(assets.features().techniques(), name);
    if (technique == nullptr)
    {
        throw ContractError("there is no technique '" + name + "'");
    }
    return *technique;
}

void UseTechnique(SceneAsset& asset, const Technique& technique, double width, AssetContext& assets)
{
    std::unique_ptr<ScriptableRendererFeature> feature =
        assets.features().Create(technique.feature);
    if (!feature)
    {
        throw ContractError("there is no feature " + technique.feature);
    }
    feature->name = "Outline";
    asset.renderer.features.clear();
    asset.renderer.features.push_back(std::move(feature));
    asset.renderer.featureTypes = {technique.feature};
    asset.volumes.clear();

    std::vector<std::string> changes = {
        "Outline.m_RenderQueueRange=All",
        "Outline.m_RenderingLayerMask=" + std::to_string(k_OutlinedLayer),
        technique.component + ".m_Enable=true",
        technique.component + ".m_OutlineColor=[1, 1, 1, 1]",
        technique.component + ".m_OutlineWidth=" + NumberText(width)};
    changes.insert(changes.end(), technique.settings.begin(), technique.settings.end());
    ApplyOverrides(asset, changes, assets);
}

SceneAsset EmptyPicture(int width, int height)
{
    SceneAsset asset;
    asset.width = width;
    asset.height = height;
    asset.camera.orthographic = true;
    asset.camera.orthographicSize = static_cast<float>(height) / 2.0f;
    asset.camera.nearClipPlane = 1.0f;
    asset.camera.farClipPlane = 1000.0f;
    asset.camera.transform.localPosition = {0.0f, 0.0f, -100.0f};
    asset.camera.backgroundColor = Color::black;
    return asset;
}

GameObject& AddOutlined(SceneAsset& picture, const std::string& name,
                        std::shared_ptr<const Mesh> mesh, AssetContext& assets)
{
    GameObject& object = picture.scene.Add(name);
    object.renderer = MeshRenderer{std::move(mesh), {BlackMaterial(assets)}, k_Outlined};
    return object;
}

GameObject& AddShape(SceneAsset& picture, const std::string& name, const ScreenTriangles& triangles,
                     AssetContext& assets)
{
    MeshData data;
    for (const auto& triangle : triangles)
    {
        for (const glm::dvec2& p : triangle)
        {
            data.triangles.push_back(static_cast<std::uint32_t>(data.vertices.size()));
            data.vertices.emplace_back(p.x - 0.5 * picture.width, 0.5 * picture.height - p.y, 0.0);
        }
    }
    return AddOutlined(picture, name, std::make_shared<const Mesh>(name, std::move(data)), assets);
}

void MarkOutlined(SceneAsset& asset)
{
    const FilteringSettings filter = FilterOf(asset);
    bool isAny = false;
    for (const auto& object : asset.scene.objects())
    {
        if (!object->renderer)
        {
            continue;
        }
        RenderingLayerMask& mask = object->renderer->renderingLayerMask;
        const bool isOutlined = IsDrawn(*object, asset.camera) && IsTaken(*object, filter);
        mask.bits = (mask.bits & ~k_Outlined.bits) | (isOutlined ? k_Outlined.bits : 0u);
        isAny = isAny || isOutlined;
    }
    if (!isAny)
    {
        throw AssetError(asset.path.string(), {},
                         "its outline feature takes none of its " +
                             std::to_string(asset.scene.objects().size()) +
                             " objects that its camera draws" +
                             (asset.camera.cameraStack.empty()
                                  ? ""
                                  : ", and the cameras of its cameraStack are not measured") +
                             "; 'limn explain' prints the rule");
    }
}

void MakeBlack(SceneAsset& asset, AssetContext& assets)
{
    asset.camera.clearFlags = CameraClearFlags::SolidColor; // not a sky
    asset.camera.backgroundColor = Color::black;
    asset.camera.cameraStack.clear();
    const auto scaled = [&](int side)
    {
        return std::max(1, static_cast<int>(static_cast<float>(side) * asset.renderScale));
    };
    asset.width = scaled(asset.width);
    asset.height = scaled(asset.height);
    asset.renderScale = 1.0f;
    std::map<CullMode, std::shared_ptr<const Material>> blacks;
    for (const auto& object : asset.scene.objects())
    {
        if (!object->renderer)
        {
            continue;
        }
        for (auto& material : object->renderer->sharedMaterials)
        {
            if (!IsOutlined(*object) && (!material || !IsOpaque(*material)))
            {
                material = nullptr;
                continue;
            }
            const CullMode cull = material ? CullOf(*material) : CullMode::Back;
            const auto [black, isNew] = blacks.try_emplace(cull);
            black->second = isNew ? BlackMaterial(assets, cull) : black->second;
            material = black->second;
        }
    }
}

void RequireOutlineInPicture(const SceneAsset& asset)
{
    const glm::dvec2 picture(asset.width, asset.height);
    for (const auto& [a, b, c] : OutlinedTriangles(asset))
    {
        const glm::dvec2 low = glm::min(glm::min(a, b), c);
        const glm::dvec2 high = glm::max(glm::max(a, b), c);
        if (high.x > 0.0 && high.y > 0.0 && low.x < picture.x && low.y < picture.y)
        {
            return;
        }
    }
    throw AssetError(asset.path.string(), {},
                     "none of the objects that it outlines is in the camera's view; move the "
                     "camera or the objects");
}

Silhouette OutlinedSilhouette(const SceneAsset& asset)
{
    return Silhouette(OutlinedTriangles(asset));
}

SceneSurfaces SurfacesOf(const SceneAsset& asset)
{
    SceneSurfaces result;
    const LayerMask drawn(asset.camera.cullingMask.bits & asset.renderer.opaqueLayerMask.bits);
    for (const auto& object : asset.scene.objects())
    {
        const bool isOutlined = IsOutlined(*object);
        if (!isOutlined && !(IsDrawn(*object, asset.camera) &&
                             LayerMask::FromIndex(object->layer).Intersects(drawn)))
        {
            continue;
        }
        const MeshRenderer& renderer = *object->renderer;
        const int last = renderer.mesh->subMeshCount() - 1;
        for (std::size_t i = 0; i < renderer.sharedMaterials.size(); ++i)
        {
            const std::shared_ptr<const Material>& material = renderer.sharedMaterials[i];
            if (!isOutlined && (!material || !IsOpaque(*material)))
            {
                continue;
            }
            const CullMode cull = isOutlined ? CullMode::Off : CullOf(*material);
            const std::vector<DepthTriangle> triangles =
                MeshDepths(*renderer.mesh, std::min(static_cast<int>(i), last), object->transform,
                           asset.camera, asset.width, asset.height, cull);
            (isOutlined ? result.outlined : result.others).Add(triangles, result.names.size());
        }
        result.names.push_back(object->name);
    }
    result.outlined.Finish();
    result.others.Finish();
    return result;
}

bool IsPartlyHidden(const SceneAsset& asset)
{
    const Silhouette silhouette = OutlinedSilhouette(asset);
    // A line around the border, a pixel wide, is hidden where the border is.
    const Coverage line = ExactOutlineCoverage(silhouette, {1.0}, asset.width, asset.height, 1);
    const SceneSurfaces surfaces = SurfacesOf(asset);
    return !SeenOutlineCoverage(line, silhouette, 1.0, surfaces.outlined, surfaces.others,
                                HiddenAt::Border)
                .hiding.empty();
}

bool IsShape(const std::string& subject)
{
    return std::ranges::count(k_ShapeNames, subject) > 0;
}

ScreenTriangles ShapeTriangles(const std::string& name, int width, int height)
{
    // Off the pixels' raster, so that no technique is lucky.
    const glm::dvec2 middle = 0.5 * glm::dvec2(width, height) + glm::dvec2(0.3, 0.6);
    const double radius = 0.3 * std::min(width, height);
    if (name == "disc")
    {
        return DiscTriangles(middle, radius);
    }
    if (name == "ring")
    {
        return RingTriangles(middle, 0.6 * radius, radius);
    }
    if (name == "star")
    {
        return StarTriangles(middle, 5, 0.4 * radius, radius, 0.3);
    }
    if (name == "needle")
    {
        const glm::dvec2 half = glm::dvec2(0.9, 0.3) * radius;
        return NeedleTriangles(middle - half, middle + half, 0.3);
    }
    if (name == "two")
    {
        return Together(
            {DiscTriangles(middle - glm::dvec2(0.5, 0.2) * radius, 0.6 * radius),
             StarTriangles(middle + glm::dvec2(0.4, 0.3) * radius, 7, 0.3 * radius, 0.6 * radius)});
    }
    throw ContractError("there is no shape '" + name + "'");
}

SceneAsset MakeSubject(const CellId& id, bool isBlack, const std::filesystem::path& scene,
                       AssetContext& assets)
{
    if (id.subject == k_BallsSubject)
    {
        return Balls(id, assets);
    }
    if (IsShape(id.subject))
    {
        SceneAsset asset = EmptyPicture(id.pictureWidth, id.pictureHeight);
        AddShape(asset, id.subject, ShapeTriangles(id.subject, id.pictureWidth, id.pictureHeight),
                 assets);
        return asset;
    }
    SceneAsset asset = LoadScene(scene, assets, InactiveObjects::Check);
    asset.width = id.pictureWidth;
    asset.height = id.pictureHeight;
    MarkOutlined(asset);
    if (isBlack)
    {
        MakeBlack(asset, assets);
    }
    return asset;
}

} // namespace limn::study
