#pragma once

#include "features/OutlineScene.h"
#include "features/color_edges/FlatPicture.h"

#include <limn/core/OutlineNormals.h>
#include <map>

namespace limn::test
{

/// Bodies of plain colours, those with a name that begins with '+' in the selected rendering layer.
struct BodiesScene
{
    Scene scene;
    Camera camera;

    explicit BodiesScene(bool isOrthographic = false)
    {
        camera.orthographic = isOrthographic;
        camera.orthographicSize = 1.6f;
        camera.fieldOfView = 45.0f;
        camera.transform.localPosition = {0.0f, 0.4f, -4.0f};
        camera.transform.localRotation = EulerToRotation({6.0f, 0.0f, 2.0f});
        camera.backgroundColor = Color::black;
        Add("Wall", PrimitiveType::Cube, {0.0f, 0.0f, 3.0f}, {2.0f, 9.0f, 0.2f},
            {0.1f, 0.2f, 0.5f});
        Add("+Ball", PrimitiveType::Sphere, {-1.1f, 0.3f, 0.2f}, glm::vec3(1.1f),
            {0.7f, 0.2f, 0.1f});
        Add("+Box", PrimitiveType::Cube, {0.2f, -0.1f, 0.4f}, {0.9f, 0.7f, 1.2f},
            {0.2f, 0.6f, 0.2f})
            .transform.localRotation = EulerToRotation({20.0f, 35.0f, 5.0f});
        Add("+Ring", PrimitiveType::Torus, {0.9f, 0.5f, -0.3f}, {1.0f, 1.2f, -0.8f},
            {0.6f, 0.6f, 0.1f})
            .transform.localRotation = EulerToRotation({60.0f, 20.0f, 10.0f});
        Add("Post", PrimitiveType::Cube, {-0.7f, 0.0f, -0.9f}, {0.15f, 3.0f, 0.1f},
            {0.4f, 0.4f, 0.4f});
    }

    GameObject& Add(const std::string& name, PrimitiveType type, const glm::vec3& position,
                    const glm::vec3& scale, const glm::vec3& linear)
    {
        GameObject& object = scene.Add(name);
        object.transform.localPosition = position;
        object.transform.localScale = scale;
        object.renderer = MeshRenderer{CreatePrimitive(type), {Plain(linear)}};
        colors[&object] = glm::dvec3(linear);
        if (IsSelected(object))
        {
            object.renderer->renderingLayerMask = RenderingLayerMask::FromIndex(k_SelectedLayer);
        }
        return object;
    }

    void BakeNormals()
    {
        for (const auto& object : scene.objects())
        {
            object->renderer->mesh = WithOutlineNormals(*object->renderer->mesh);
        }
    }

    static bool IsSelected(const GameObject& object) { return object.name.starts_with('+'); }

    /// Linear; of null the background's.
    glm::dvec3 ColorOf(const GameObject* object) const
    {
        return object == nullptr ? glm::dvec3(0.0) : colors.at(object);
    }

    std::map<const GameObject*, glm::dvec3> colors;
};

} // namespace limn::test
