#include "study/StudyScene.h"

#include "plugins/DescribeFeature.h"
#include "study/Techniques.h"

#include <limn/core/Judge.h>

namespace limn::study
{

namespace
{

constexpr RenderingLayerMask k_Outlined = RenderingLayerMask::FromIndex(k_OutlinedLayer);

std::shared_ptr<const Material> BlackMaterial(AssetContext& assets)
{
    auto material =
        std::make_shared<Material>(assets.FindShader("Universal Render Pipeline/Unlit"));
    material->SetColor(ShaderPropertyId("_BaseColor"), Color::black);
    return material;
}

/// What an outline feature filters by, by the names that all of them share.
class FilterFinder final : public Inspector
{
public:
    void Field(const FieldInfo& field, FieldValue value) override
    {
        // A ported feature may have settings of these names and other types.
        LayerMask** layers = std::get_if<LayerMask*>(&value);
        const auto* layer = std::get_if<RenderingLayerValue>(&value);
        RenderingLayerMask** renderingLayers = std::get_if<RenderingLayerMask*>(&value);
        const auto* choice = std::get_if<EnumValue>(&value);
        if (layers && field.name == "m_LayerMask")
        {
            m_Filter.layerMask = **layers;
        }
        else if ((layer || renderingLayers) && field.name == "m_RenderingLayerMask")
        {
            m_Filter.renderingLayerMask =
                layer ? RenderingLayerMask::FromIndex(layer->value) : **renderingLayers;
            m_IsOutline = true;
        }
        else if (choice && field.name == "m_RenderQueueRange" && choice->value >= 0 &&
                 choice->value < 3)
        {
            constexpr RenderQueueRange k_Ranges[] = {
                RenderQueueRange::all, RenderQueueRange::opaque, RenderQueueRange::transparent};
            m_Filter.renderQueueRange = k_Ranges[static_cast<std::size_t>(choice->value)];
        }
    }
    bool isOutline() const { return m_IsOutline; }
    const FilteringSettings& filter() const { return m_Filter; }

private:
    bool m_IsOutline = false;
    FilteringSettings m_Filter;
};

FilteringSettings FilterOf(SceneAsset& asset)
{
    for (const auto& feature : asset.renderer.features)
    {
        FilterFinder finder;
        DescribeFeature(*feature, finder);
        if (feature->isActive() && finder.isOutline())
        {
            return finder.filter();
        }
    }
    throw AssetError(asset.path.string(), {},
                     "no active feature outlines anything, so it is unknown which objects a report "
                     "is about; one like {type: ScreenSpaceOutlineRenderFeature, ...} with its "
                     "m_LayerMask and m_RenderingLayerMask says so");
}

/// Returns whether the camera would draw the object if it were in front of it.
bool IsDrawn(const GameObject& object, const Camera& camera)
{
    return object.activeSelf && object.renderer && object.renderer->enabled &&
           LayerMask::FromIndex(object.layer).Intersects(camera.cullingMask);
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

} // namespace

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
                     AssetContext& assets, const glm::dvec2& offset)
{
    MeshData data;
    for (const auto& triangle : triangles)
    {
        for (const glm::dvec2& p : triangle)
        {
            data.triangles.push_back(static_cast<std::uint32_t>(data.vertices.size()));
            data.vertices.emplace_back(p.x + offset.x - 0.5 * picture.width,
                                       0.5 * picture.height - p.y - offset.y, 0.0);
        }
    }
    return AddOutlined(picture, name, std::make_shared<const Mesh>(name, std::move(data)), assets);
}

std::vector<GameObject*> MarkOutlined(SceneAsset& asset)
{
    const FilteringSettings filter = FilterOf(asset);
    std::vector<GameObject*> outlined;
    for (const auto& object : asset.scene.objects())
    {
        if (!object->renderer)
        {
            continue;
        }
        RenderingLayerMask& mask = object->renderer->renderingLayerMask;
        const bool isOutlined = IsDrawn(*object, asset.camera) && IsTaken(*object, filter);
        mask.bits = (mask.bits & ~k_Outlined.bits) | (isOutlined ? k_Outlined.bits : 0u);
        if (isOutlined)
        {
            outlined.push_back(object.get());
        }
    }
    if (outlined.empty())
    {
        throw AssetError(asset.path.string(), {},
                         "its outline feature takes none of its " +
                             std::to_string(asset.scene.objects().size()) +
                             " objects that its camera draws; 'limn explain' says by which rule");
    }
    return outlined;
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
    const std::shared_ptr<const Material> black = BlackMaterial(assets);
    for (const auto& object : asset.scene.objects())
    {
        if (object->renderer)
        {
            for (auto& material : object->renderer->sharedMaterials)
            {
                material = black;
            }
        }
    }
}

namespace
{

ScreenTriangles OutlinedTriangles(const SceneAsset& asset)
{
    ScreenTriangles triangles;
    for (const auto& object : asset.scene.objects())
    {
        if (object->renderer && object->renderer->renderingLayerMask.Intersects(k_Outlined))
        {
            const ScreenTriangles part = MeshTriangles(*object->renderer->mesh, object->transform,
                                                       asset.camera, asset.width, asset.height);
            triangles.insert(triangles.end(), part.begin(), part.end());
        }
    }
    return triangles;
}

} // namespace

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

} // namespace limn::study
