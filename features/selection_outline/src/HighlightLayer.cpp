#include "HighlightLayer.h"

#include <algorithm>
#include <limn/core/ScriptableRenderer.h>

namespace limn
{

namespace
{

/// Objects in another layer until the scope ends.
class InAnotherLayer
{
public:
    InAnotherLayer(const Scene& scene, const std::vector<const GameObject*>& objects, int layer)
    {
        m_Layers.reserve(objects.size());
        for (const auto& object : scene.objects())
        {
            if (std::ranges::binary_search(objects, object.get()))
            {
                m_Layers.emplace_back(object.get(), object->layer);
                object->layer = layer;
            }
        }
    }
    ~InAnotherLayer()
    {
        for (const auto& [object, layer] : m_Layers)
        {
            object->layer = layer;
        }
    }
    InAnotherLayer(const InAnotherLayer&) = delete;
    InAnotherLayer& operator=(const InAnotherLayer&) = delete;

private:
    std::vector<std::pair<GameObject*, int>> m_Layers;
};

} // namespace

HighlightLayer::HighlightLayer(const RenderingData& renderingData,
                               std::span<const OutlinedObject> objects, int layer)
{
    if (renderingData.scene == nullptr)
    {
        throw ContractError("HighlightLayer: there is no scene that a second camera could cull");
    }
    for (const OutlinedObject& object : objects)
    {
        m_Moved.push_back(object.item.object);
    }
    std::ranges::sort(m_Moved);
    const auto& target = renderingData.cameraData.cameraTargetDescriptor;
    const float aspect = static_cast<float>(target.width) / static_cast<float>(target.height);
    Camera camera = *renderingData.cameraData.camera;
    camera.cullingMask = LayerMask::FromIndex(layer);
    {
        const InAnotherLayer moved(*renderingData.scene, m_Moved, layer);
        m_Seen = Cull(*renderingData.scene, camera, aspect);
    }
    // The first camera culls by the layers as they are now.
    Cull(*renderingData.scene, *renderingData.cameraData.camera, aspect);
}

bool HighlightLayer::wasMoved(const GameObject& object) const
{
    return std::ranges::binary_search(m_Moved, &object);
}

} // namespace limn
