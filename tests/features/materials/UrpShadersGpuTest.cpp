#include "features/materials/PanelWall.h"

#include <glm/trigonometric.hpp>
#include <gmock/gmock.h>

namespace limn::test
{
namespace
{

glm::quat TurnedAside(double degrees)
{
    return glm::angleAxis(static_cast<float>(glm::radians(degrees)), glm::vec3(0.0f, 1.0f, 0.0f));
}

/// Simple Lit, Baked Lit, Unlit and the shaders of particles.
class UrpShadersGpu : public GpuTest
{
protected:
    UrpShadersGpu()
    {
        m_Wall.sun.direction = -glm::vec3(m_ToLight);
        m_Surface.albedo = {0.5, 0.25, 0.75};
        m_Surface.smoothness = 0.5;
    }

    /// Draws a material at several tilts.
    template <typename Formula>
    void ExpectByFormula(const std::shared_ptr<Material>& material, const Formula& formula)
    {
        Set(*material, "_BaseColor", glm::vec4(0.5f, 0.25f, 0.75f, 1.0f));
        PanelWall wall = m_Wall;
        const double tilts[] = {0.0, 30.0, -40.0, 75.0};
        for (const double tilt : tilts)
        {
            wall.Add(material, TurnedAside(tilt));
        }
        const std::vector<glm::dvec4> colors = wall.Draw();
        for (std::size_t i = 0; i < colors.size(); ++i)
        {
            SCOPED_TRACE(material->shader()->name() + ", panel " + std::to_string(i));
            LitSurface surface = m_Surface;
            surface.normal = glm::dquat(TurnedAside(tilts[i])) * glm::dvec3(0, 0, -1);
            ExpectWithin(colors[i],
                         SumOfLights(formula, surface, {{m_ToLight, glm::dvec3(1.0)}}, k_ToCamera));
        }
    }
    static void ExpectColor(const glm::dvec4& color, const glm::dvec3& wanted)
    {
        for (int channel = 0; channel < 3; ++channel)
        {
            EXPECT_NEAR(color[channel], wanted[channel], 2e-3 * wanted[channel] + 1e-6) << channel;
        }
    }

    const glm::dvec3 m_ToLight = glm::normalize(glm::dvec3(-0.5, 0.25, -0.75));
    PanelWall m_Wall;
    LitSurface m_Surface;
};

TEST_F(UrpShadersGpu, SimpleLitIsLambertAndBlinnPhong)
{
    for (const char* name : {"Simple Lit", "Particles/Simple Lit"})
    {
        m_Surface.specular = glm::dvec3(0.0);
        ExpectByFormula(UrpMaterial(name), SimpleLitByFormula);
        for (const float smoothness : {0.0f, 0.5f, 1.0f})
        {
            const auto material = UrpMaterial(name, {"_SPECULAR_COLOR"});
            Set(*material, "_SpecColor", glm::vec4(0.5f, 0.75f, 0.25f, smoothness));
            m_Surface.specular = {0.5, 0.75, 0.25};
            m_Surface.smoothness = static_cast<double>(smoothness);
            ExpectByFormula(material, SimpleLitByFormula);
        }
        const auto mapped = UrpMaterial(name, {"_SPECGLOSSMAP"});
        Set(*mapped, "_SpecColor", glm::vec4(1, 1, 1, 1));
        Set(*mapped, "_SpecGlossMap", glm::ivec4(51, 153, 204, 102));
        m_Surface.specular = {0.2, 0.6, 0.8};
        m_Surface.smoothness = 0.4;
        ExpectByFormula(mapped, SimpleLitByFormula);
    }
}

TEST_F(UrpShadersGpu, ParticlesLitIsLit)
{
    const auto material = UrpMaterial("Particles/Lit");
    Set(*material, "_Metallic", 0.75f);
    Set(*material, "_Smoothness", 0.5f);
    m_Surface.metallic = 0.75;
    ExpectByFormula(material, LitByFormula);
    const auto mapped = UrpMaterial("Particles/Lit", {"_METALLICSPECGLOSSMAP"});
    Set(*mapped, "_Smoothness", 0.5f);
    Set(*mapped, "_MetallicGlossMap", glm::ivec4(102, 0, 0, 153));
    m_Surface.metallic = 0.4;
    m_Surface.smoothness = 0.3;
    ExpectByFormula(mapped, LitByFormula);
}

TEST_F(UrpShadersGpu, BakedLitIsLitByTheSurroundingsAlone)
{
    const auto material = UrpMaterial("Baked Lit");
    Set(*material, "_BaseColor", glm::vec4(0.5f, 0.25f, 0.75f, 1.0f));
    m_Wall.Add(material);
    m_Wall.ambient = {0.5f, 0.5f, 0.5f, 1.0f};
    const double ambient = std::pow((0.5 + 0.055) / 1.055, 2.4);
    ExpectColor(m_Wall.Draw()[0], m_Surface.albedo * ambient);
}

TEST_F(UrpShadersGpu, UnlitIsAsBrightAsItIs)
{
    for (const char* name : {"Unlit", "Particles/Unlit"})
    {
        PanelWall wall = m_Wall;
        const auto add = [&](const std::vector<std::string>& keywords, float alpha)
        {
            const auto material = UrpMaterial(name, keywords);
            Set(*material, "_BaseMap", glm::ivec4(51, 102, 204, 255));
            Set(*material, "_BaseColor", glm::vec4(0.5f, 3.0f, 1.0f, alpha));
            Set(*material, "_Cutoff", 0.5f);
            wall.Add(material);
        };
        add({}, 0.25f);
        add({"_ALPHATEST_ON"}, 0.25f);
        add({"_ALPHATEST_ON"}, 0.75f);
        const std::vector<glm::dvec4> colors = wall.Draw();
        const glm::dvec3 wanted(0.1, 1.2, 0.8);
        ExpectColor(colors[0], wanted);
        EXPECT_EQ(colors[0].a, 1.0);
        ExpectColor(colors[1], glm::dvec3(0.0));
        ExpectColor(colors[2], wanted);
    }
}

TEST_F(UrpShadersGpu, ParticlesHaveTheirOwnColour)
{
    MeshData data = CreatePrimitive(PrimitiveType::Quad)->data();
    data.colors.assign(data.vertices.size(), glm::vec4(0.25f, 0.5f, 1.0f, 1.0f));
    const auto mesh = std::make_shared<const Mesh>("colored", data);
    const auto add = [&](const std::vector<std::string>& keywords, const glm::vec4& addSubDiff)
    {
        const auto material = UrpMaterial("Particles/Unlit", keywords);
        Set(*material, "_BaseColor", glm::vec4(0.5f, 0.75f, 0.125f, 1.0f));
        Set(*material, "_BaseColorAddSubDiff", addSubDiff);
        m_Wall.Add(material, glm::quat(1, 0, 0, 0), mesh);
    };
    add({}, glm::vec4(0));
    add({"_COLORADDSUBDIFF_ON"}, {1, 0, 0, 0});
    add({"_COLORADDSUBDIFF_ON"}, {-1, 1, 0, 0});
    const std::vector<glm::dvec4> colors = m_Wall.Draw();
    ExpectColor(colors[0], {0.125, 0.375, 0.125});
    ExpectColor(colors[1], {0.75, 1.25, 1.125});
    ExpectColor(colors[2], {0.25, 0.25, 0.875});
}

} // namespace
} // namespace limn::test
