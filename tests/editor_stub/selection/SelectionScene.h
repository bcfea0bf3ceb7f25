#pragma once

#include <limn/core/Camera.h>
#include <limn/core/Material.h>
#include <limn/core/PrimitiveMesh.h>
#include <limn/editor_stub/AssetContext.h>

namespace limn::test
{

/// A scene that its code puts together; the camera at the origin looks along +z.
struct SelectionScene
{
    static AssetContext& Assets()
    {
        static AssetContext assets;
        return assets;
    }

    static std::shared_ptr<Material> NewMaterial()
    {
        return std::make_shared<Material>(Assets().FindShader("Universal Render Pipeline/Unlit"));
    }

    GameObject& Add(const std::string& name, std::shared_ptr<const Mesh> mesh,
                    const glm::vec3& position, const glm::vec3& scale = glm::vec3(1.0f))
    {
        GameObject& object = scene.Add(name);
        object.transform.localPosition = position;
        object.transform.localScale = scale;
        if (mesh)
        {
            object.renderer = MeshRenderer{std::move(mesh), {material}};
        }
        return object;
    }

    GameObject& AddCube(const std::string& name, const glm::vec3& position,
                        const glm::vec3& scale = glm::vec3(1.0f))
    {
        return Add(name, Assets().Primitive(PrimitiveType::Cube), position, scale);
    }

    Scene scene;
    Camera camera;
    std::shared_ptr<Material> material = NewMaterial();
};

} // namespace limn::test
