#pragma once

#include "features/color_edges/PictureRun.h"
#include "features/materials/UrpReference.h"

#include <glm/gtc/quaternion.hpp>
#include <glm/vec4.hpp>

namespace limn::test
{

inline const glm::dvec3 k_ToCamera{0.0, 0.0, -1.0};

/// A material of one of limn's own shaders.
inline std::shared_ptr<Material> UrpMaterial(const std::string& name,
                                             const std::vector<std::string>& keywords = {})
{
    const auto shader = FindBuiltinShader("Universal Render Pipeline/" + name, Compiler());
    auto material = std::make_shared<Material>(shader);
    for (const std::string& keyword : shader->initialKeywords())
    {
        material->DisableKeyword(keyword);
    }
    for (const std::string& keyword : keywords)
    {
        material->EnableKeyword(keyword);
    }
    return material;
}

/// A texture of one texel, linear.
inline std::shared_ptr<const Texture> Texel(const glm::ivec4& rgba)
{
    std::vector<std::byte> bytes;
    for (int i = 0; i < 4; ++i)
    {
        bytes.push_back(static_cast<std::byte>(rgba[i]));
    }
    return std::make_shared<const Texture2D>("texel", 1, 1, GraphicsFormat::R8G8B8A8_UNorm,
                                             std::move(bytes));
}

inline void Set(Material& material, const std::string& name, float value)
{
    material.SetFloat(ShaderPropertyId(name), value);
}
/// @param linear  as the shader finds it
inline void Set(Material& material, const std::string& name, const glm::vec4& linear)
{
    material.SetVector(ShaderPropertyId(name), linear);
}
inline void Set(Material& material, const std::string& name, const glm::ivec4& texel)
{
    material.SetTexture(ShaderPropertyId(name), Texel(texel));
}

/// Panels side by side, seen from in front without perspective, each tilted about its middle.
class PanelWall
{
public:
    static constexpr int k_Panel = 9; ///< pixels across: the middle is one
    static constexpr int k_Columns = 16;

    DirectionalLight sun{{0.0f, 0.0f, 1.0f}, Color::white, 1.0f};
    std::vector<Light> lights;
    Color ambient = Color::black;
    Color background = Color::black;

    /// @return the index in what Draw gives
    std::size_t Add(std::shared_ptr<const Material> material,
                    const glm::quat& rotation = glm::quat(1, 0, 0, 0),
                    std::shared_ptr<const Mesh> mesh = CreatePrimitive(PrimitiveType::Quad))
    {
        m_Panels.push_back({std::move(material), rotation, std::move(mesh)});
        return m_Panels.size() - 1;
    }

    /// The middle of each panel: linear, with alpha.
    std::vector<glm::dvec4> Draw()
    {
        const int rows = static_cast<int>(m_Panels.size() + k_Columns - 1) / k_Columns;
        const int width = k_Columns * k_Panel;
        FlatScene wall(width, rows * k_Panel);
        wall.camera.backgroundColor = background;
        wall.scene.mainLight = sun;
        wall.scene.additionalLights = lights;
        wall.scene.ambientLight = ambient;
        for (std::size_t i = 0; i < m_Panels.size(); ++i)
        {
            const glm::vec2 low = glm::vec2(PlaceOf(i)) * static_cast<float>(k_Panel);
            GameObject& object =
                wall.Add(low, low + static_cast<float>(k_Panel), 6, m_Panels[i].material);
            object.transform.localRotation = m_Panels[i].rotation;
            object.renderer->mesh = m_Panels[i].mesh;
        }
        PictureRun run(wall.scene, wall.camera, width, rows * k_Panel);
        const Field picture = run.Color(nullptr);
        std::vector<glm::dvec4> colors;
        for (std::size_t i = 0; i < m_Panels.size(); ++i)
        {
            const glm::ivec2 middle = PlaceOf(i) * k_Panel + k_Panel / 2;
            for (int channel = 0; channel < 4; ++channel)
            {
                colors.resize(i + 1);
                colors[i][channel] = picture.At(middle.x, middle.y, channel);
            }
        }
        return colors;
    }

    /// Where the middle of a panel is in the world.
    glm::dvec3 MiddleOf(std::size_t index) const
    {
        const int rows = static_cast<int>(m_Panels.size() + k_Columns - 1) / k_Columns;
        const glm::dvec2 place = (glm::dvec2(PlaceOf(index)) + 0.5) * static_cast<double>(k_Panel);
        return {place.x - k_Columns * k_Panel / 2.0, rows * k_Panel / 2.0 - place.y, 6.0};
    }

private:
    struct Panel
    {
        std::shared_ptr<const Material> material;
        glm::quat rotation;
        std::shared_ptr<const Mesh> mesh;
    };
    static glm::ivec2 PlaceOf(std::size_t index)
    {
        return {static_cast<int>(index) % k_Columns, static_cast<int>(index) / k_Columns};
    }

    std::vector<Panel> m_Panels;
};

/// A colour within what floats may give, and what its half rounds away.
inline void ExpectWithin(const glm::dvec4& color, const ValueRange3& range)
{
    for (int channel = 0; channel < 3; ++channel)
    {
        const double half = 1e-3; // two roundings of 2^-11 each
        ASSERT_GE(color[channel], range.low[channel] * (1.0 - half) - 2e-6) << channel;
        ASSERT_LE(color[channel], range.high[channel] * (1.0 + half) + 2e-6) << channel;
    }
}

} // namespace limn::test
