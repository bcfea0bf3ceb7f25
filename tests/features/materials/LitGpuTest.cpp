#include "features/materials/PanelWall.h"

#include <glm/trigonometric.hpp>
#include <gmock/gmock.h>
#include <numbers>

namespace limn::test
{
namespace
{

constexpr double k_Tilts[] = {0.0, 35.0, 60.0, 80.0, 89.0, -50.0};

/// Turns a panel about an axis that is neither of the picture's.
glm::quat Tilted(double degrees)
{
    return glm::angleAxis(static_cast<float>(glm::radians(degrees)),
                          glm::normalize(glm::vec3(0.6f, 0.8f, 0.0f)));
}
glm::dvec3 NormalOf(const glm::quat& rotation)
{
    return glm::dquat(rotation) * glm::dvec3(0, 0, -1);
}
/// The direction to a light that far from the camera's.
glm::vec3 ToLight(double degrees)
{
    const double angle = glm::radians(degrees);
    return glm::normalize(
        glm::vec3(0.8 * std::sin(angle), 0.6 * std::sin(angle), -std::cos(angle)));
}

double Byte(int value)
{
    return value / 255.0;
}

/// The tangent-space normal of a texel of a normal map, unpacked.
glm::dvec3 NormalTS(const glm::ivec4& texel, double scale)
{
    const glm::dvec2 xy(Byte(texel.r) * 2.0 - 1.0, Byte(texel.g) * 2.0 - 1.0);
    const double z = std::sqrt(std::max(1.0 - std::min(glm::dot(xy, xy), 1.0), 1e-16));
    return {xy * scale, z};
}
/// On a panel: its tangent is to the right, its bitangent up.
glm::dvec3 BentNormal(const glm::ivec4& texel, double scale, const glm::quat& rotation)
{
    const glm::dvec3 n = NormalTS(texel, scale);
    return glm::normalize(glm::dquat(rotation) * glm::dvec3(n.x, n.y, -n.z));
}

class LitGpu : public GpuTest
{
protected:
    void Shine(const glm::vec3& toLight, float intensity = 1.0f)
    {
        m_Wall.sun.direction = -toLight;
        m_Wall.sun.intensity = intensity;
    }
    void Add(std::shared_ptr<Material> material, LitSurface surface,
             const glm::quat& rotation = glm::quat(1, 0, 0, 0))
    {
        m_Wall.Add(std::move(material), rotation);
        m_Surfaces.push_back(surface);
    }
    template <typename Formula>
    void ExpectByFormula(const Formula& formula)
    {
        const std::vector<ArrivingLight> sun = {
            {-glm::normalize(glm::dvec3(m_Wall.sun.direction)),
             glm::dvec3(static_cast<double>(m_Wall.sun.intensity))}};
        const std::vector<glm::dvec4> colors = m_Wall.Draw();
        for (std::size_t i = 0; i < colors.size(); ++i)
        {
            SCOPED_TRACE("panel " + std::to_string(i));
            ExpectWithin(colors[i], SumOfLights(formula, m_Surfaces[i], sun, k_ToCamera));
        }
    }

    PanelWall m_Wall;
    std::vector<LitSurface> m_Surfaces;
};

TEST_F(LitGpu, IsTheMicrofacetFormulaForAnyMetalSmoothnessAndAngle)
{
    for (const double metallic : {0.0, 0.5, 1.0})
    {
        for (const double smoothness : {0.0, 0.3, 0.5, 0.9, 1.0})
        {
            const auto material = UrpMaterial("Lit");
            Set(*material, "_BaseColor", glm::vec4(0.8f, 0.5f, 0.1f, 1.0f));
            Set(*material, "_Metallic", static_cast<float>(metallic));
            Set(*material, "_Smoothness", static_cast<float>(smoothness));
            for (const double tilt : k_Tilts)
            {
                LitSurface surface;
                surface.albedo = {0.8f, 0.5f, 0.1f};
                surface.metallic = metallic;
                surface.smoothness = static_cast<double>(static_cast<float>(smoothness));
                surface.normal = NormalOf(Tilted(tilt));
                Add(material, surface, Tilted(tilt));
            }
        }
    }
    for (const double degrees : {0.0, 40.0, 85.0, 120.0, 179.0})
    {
        SCOPED_TRACE("light from " + std::to_string(degrees));
        Shine(ToLight(degrees), 2.0f);
        ExpectByFormula(LitByFormula);
    }
    // A mirror's brightest highlight, where the half vector is the normal.
    Shine(glm::normalize(glm::vec3(0, 0, -1)));
    EXPECT_GT(m_Wall.Draw()[84].r, 1000.0) << "smoothness 1 of a metal seen along light and normal";
}

TEST_F(LitGpu, HasASpecularColourInPlaceOfAMetal)
{
    for (const double smoothness : {0.0, 0.5, 1.0})
    {
        const auto material = UrpMaterial("Lit", {"_SPECULAR_SETUP"});
        Set(*material, "_BaseColor", glm::vec4(0.25f, 0.5f, 0.75f, 1.0f));
        Set(*material, "_SpecColor", glm::vec4(0.5f, 0.125f, 0.25f, 1.0f));
        Set(*material, "_Metallic", 1.0f); // does not count
        Set(*material, "_Smoothness", static_cast<float>(smoothness));
        LitSurface surface;
        surface.albedo = {0.25, 0.5, 0.75};
        surface.specular = {0.5, 0.125, 0.25};
        surface.isSpecular = true;
        surface.smoothness = smoothness;
        for (const double tilt : k_Tilts)
        {
            surface.normal = NormalOf(Tilted(tilt));
            Add(material, surface, Tilted(tilt));
        }
    }
    Shine(ToLight(50.0));
    ExpectByFormula(LitByFormula);
}

TEST_F(LitGpu, ReadsItsMaps)
{
    LitSurface surface;
    surface.albedo = glm::dvec3(Byte(200), Byte(100), Byte(50)) * glm::dvec3(0.5, 0.75, 1.0);
    const auto textured = [](const std::vector<std::string>& keywords)
    {
        auto material = UrpMaterial("Lit", keywords);
        Set(*material, "_BaseMap", glm::ivec4(200, 100, 50, 64));
        Set(*material, "_BaseColor", glm::vec4(0.5f, 0.75f, 1.0f, 1.0f));
        Set(*material, "_MetallicGlossMap", glm::ivec4(150, 7, 9, 204));
        Set(*material, "_SpecGlossMap", glm::ivec4(51, 102, 20, 153));
        Set(*material, "_Metallic", 0.25f);
        Set(*material, "_SpecColor", glm::vec4(0.125f, 0.25f, 0.5f, 1.0f));
        Set(*material, "_Smoothness", 0.75f);
        return material;
    };
    surface.metallic = 0.25;
    surface.smoothness = 0.75;
    Add(textured({}), surface);
    surface.smoothness = 0.75 * Byte(64);
    Add(textured({"_SMOOTHNESS_TEXTURE_ALBEDO_CHANNEL_A"}), surface);
    surface.metallic = Byte(150);
    Add(textured({"_METALLICSPECGLOSSMAP", "_SMOOTHNESS_TEXTURE_ALBEDO_CHANNEL_A"}), surface);
    surface.smoothness = 0.75 * Byte(204);
    Add(textured({"_METALLICSPECGLOSSMAP"}), surface);
    surface.isSpecular = true;
    surface.specular = {0.125, 0.25, 0.5};
    surface.smoothness = 0.75;
    Add(textured({"_SPECULAR_SETUP"}), surface);
    surface.specular = {Byte(51), Byte(102), Byte(20)};
    surface.smoothness = 0.75 * Byte(153);
    Add(textured({"_SPECULAR_SETUP", "_METALLICSPECGLOSSMAP"}), surface);
    Shine(ToLight(30.0));
    ExpectByFormula(LitByFormula);
}

TEST_F(LitGpu, BendsNormalsByItsNormalMap)
{
    const glm::ivec4 texels[] = {{128, 128, 255, 255}, {200, 100, 220, 255}, {60, 180, 230, 255},
                                 {255, 128, 128, 255}, {128, 255, 128, 255}, {230, 230, 128, 255}};
    for (const glm::ivec4& texel : texels)
    {
        for (const double scale : {0.5, 1.0, 2.0})
        {
            const auto material = UrpMaterial("Lit", {"_NORMALMAP"});
            Set(*material, "_BumpMap", texel);
            Set(*material, "_BumpScale", static_cast<float>(scale));
            Set(*material, "_Smoothness", 0.25f);
            for (const double tilt : {0.0, 40.0})
            {
                LitSurface surface;
                surface.smoothness = 0.25;
                surface.normal = BentNormal(texel, scale, Tilted(tilt));
                Add(material, surface, Tilted(tilt));
            }
        }
    }
    Shine(ToLight(55.0));
    ExpectByFormula(LitByFormula);
}

TEST_F(LitGpu, HasDetailsWhereItsMaskIs)
{
    const auto detailed = [](const std::string& keyword, int mask)
    {
        auto material = UrpMaterial("Lit", {keyword});
        Set(*material, "_BaseColor", glm::vec4(0.5f, 0.25f, 0.75f, 1.0f));
        Set(*material, "_Smoothness", 0.0f);
        Set(*material, "_DetailAlbedoMap", glm::ivec4(51, 204, 102, 255));
        Set(*material, "_DetailAlbedoMapScale", 0.5f);
        Set(*material, "_DetailMask", glm::ivec4(0, 0, 0, mask));
        Set(*material, "_DetailNormalMap", glm::ivec4(200, 80, 230, 255));
        return material;
    };
    const glm::dvec3 base(0.5, 0.25, 0.75);
    const glm::dvec3 detail(0.2, 0.8, 0.4);
    // On a flat surface the reoriented detail normal is the detail's own.
    const glm::dvec3 bent = NormalTS({200, 80, 230, 255}, 1.0);
    LitSurface surface;
    surface.smoothness = 0.0;
    const auto add = [&](const std::string& keyword, const glm::dvec3& factor, int mask)
    {
        const double part = Byte(mask);
        surface.albedo = base * glm::mix(glm::dvec3(1.0), factor, part);
        const glm::dvec3 normal = glm::normalize(glm::mix(glm::dvec3(0, 0, 1), bent, part));
        surface.normal = {normal.x, normal.y, -normal.z};
        Add(detailed(keyword, mask), surface);
    };
    for (const int mask : {0, 102, 255})
    {
        add("_DETAIL_MULX2", 2.0 * detail, mask);
        add("_DETAIL_SCALED", 2.0 * 0.5 * detail - 0.5 + 1.0, mask);
    }
    Shine(ToLight(40.0));
    ExpectByFormula(LitByFormula);
}

TEST_F(LitGpu, IsFlatWithoutANormalMapOfItsOwn)
{
    const auto flat = UrpMaterial("Lit");
    const auto mapped = UrpMaterial("Lit", {"_NORMALMAP"});
    Set(*flat, "_Smoothness", 0.0f);
    Set(*mapped, "_Smoothness", 0.0f);
    m_Wall.Add(flat);
    m_Wall.Add(mapped);
    Shine(ToLight(60.0));
    const std::vector<glm::dvec4> colors = m_Wall.Draw();
    // A byte has no exact middle: 128 is a slope of 1/255.
    EXPECT_NEAR(colors[1].r, colors[0].r, 0.01);
    EXPECT_GT(colors[0].r, 0.4);
}

TEST_F(LitGpu, IsCutByItsAlpha)
{
    for (const bool clips : {false, true})
    {
        for (const float alpha : {0.25f, 0.75f})
        {
            const auto material =
                UrpMaterial("Lit", clips ? std::vector<std::string>{"_ALPHATEST_ON"}
                                         : std::vector<std::string>{});
            Set(*material, "_BaseColor", glm::vec4(1, 1, 1, alpha));
            Set(*material, "_Cutoff", 0.5f);
            m_Wall.Add(material);
        }
    }
    const std::vector<glm::dvec4> colors = m_Wall.Draw();
    EXPECT_GT(colors[0].g, 0.5);
    EXPECT_EQ(colors[0].a, 1.0) << "an opaque surface covers all, whatever its alpha";
    EXPECT_GT(colors[1].g, 0.5);
    EXPECT_EQ(colors[2].g, 0.0);
    EXPECT_GT(colors[3].g, 0.5);
}

/// A mode of blending as Unity's inspector sets it.
struct BlendMode
{
    const char* name;
    std::vector<std::string> keywords;
    float source;
    float destination;
};

TEST_F(LitGpu, BlendsAsItsModeSays)
{
    const double alpha = 0.25;
    const BlendMode modes[] = {
        {"alpha", {}, 5, 10},
        {"alpha with full highlights", {"_ALPHAPREMULTIPLY_ON"}, 1, 10},
        {"additive", {}, 5, 1},
        {"multiply", {"_ALPHAMODULATE_ON"}, 2, 0},
    };
    for (const BlendMode& mode : modes)
    {
        std::vector<std::string> keywords = mode.keywords;
        keywords.emplace_back("_SURFACE_TYPE_TRANSPARENT");
        const auto material = UrpMaterial("Lit", keywords);
        Set(*material, "_BaseColor", glm::vec4(0.5f, 0.25f, 0.75f, static_cast<float>(alpha)));
        Set(*material, "_Smoothness", 0.75f);
        Set(*material, "_Surface", 1.0f);
        Set(*material, "_SrcBlend", mode.source);
        Set(*material, "_DstBlend", mode.destination);
        Set(*material, "_DstBlendAlpha", 10.0f);
        Set(*material, "_ZWrite", 0.0f);
        material->SetRenderQueue(3000);
        m_Wall.Add(material);
    }
    m_Wall.background = {0.5f, 0.5f, 0.5f, 1.0f}; // sRGB
    Shine(ToLight(20.0));
    const std::vector<glm::dvec4> colors = m_Wall.Draw();

    LitSurface surface;
    surface.albedo = {0.5, 0.25, 0.75};
    surface.alpha = alpha;
    surface.smoothness = 0.75;
    const glm::dvec3 behind(std::pow((0.5 + 0.055) / 1.055, 2.4));
    const auto lit = [&]
    {
        return LitByFormula(surface, {glm::dvec3(ToLight(20.0)), glm::dvec3(1.0)}, k_ToCamera, 0.0);
    };
    const auto expect = [&](std::size_t panel, const glm::dvec3& wanted)
    {
        for (int channel = 0; channel < 3; ++channel)
        {
            EXPECT_NEAR(colors[panel][channel], wanted[channel], 2e-3 * wanted[channel])
                << modes[panel].name << ", channel " << channel;
        }
    };
    expect(0, lit() * alpha + behind * (1.0 - alpha));
    EXPECT_NEAR(colors[0].a, alpha + 1.0 - alpha, 1e-3);
    expect(2, lit() * alpha + behind);
    surface.isPremultiplied = true;
    expect(1, lit() + behind * (1.0 - alpha));
    surface.isPremultiplied = false;
    surface.albedo = glm::mix(glm::dvec3(1.0), surface.albedo, alpha);
    expect(3, lit() * behind);
}

TEST_F(LitGpu, EmitsWhatItsEmissionSaysAlsoInTheDark)
{
    const auto silent = UrpMaterial("Lit");
    const auto plain = UrpMaterial("Lit", {"_EMISSION"});
    const auto mapped = UrpMaterial("Lit", {"_EMISSION"});
    for (const auto& material : {silent, plain, mapped})
    {
        Set(*material, "_EmissionColor", glm::vec4(3.0f, 0.5f, 40.0f, 1.0f));
        m_Wall.Add(material);
    }
    Set(*mapped, "_EmissionMap", glm::ivec4(51, 255, 102, 255));
    m_Wall.sun.intensity = 0.0f;
    const std::vector<glm::dvec4> colors = m_Wall.Draw();
    const glm::dvec3 wanted[] = {{0, 0, 0}, {3, 0.5, 40}, {0.6, 0.5, 16}};
    for (std::size_t panel = 0; panel < 3; ++panel)
    {
        for (int channel = 0; channel < 3; ++channel)
        {
            EXPECT_NEAR(colors[panel][channel], wanted[panel][channel],
                        1e-3 * wanted[panel][channel]);
        }
    }
}

TEST_F(LitGpu, OccludesOnlyWhatDoesNotComeFromALamp)
{
    const auto material = [](int occlusion, float strength)
    {
        auto made = UrpMaterial("Lit", {"_OCCLUSIONMAP", "_SPECULAR_SETUP"});
        Set(*made, "_BaseColor", glm::vec4(0.5f, 0.25f, 0.75f, 1.0f));
        Set(*made, "_SpecColor", glm::vec4(0, 0, 0, 1)); // and rough: reflects nothing around it
        Set(*made, "_Smoothness", 0.0f);
        Set(*made, "_OcclusionMap", glm::ivec4(9, occlusion, 7, 255));
        Set(*made, "_OcclusionStrength", strength);
        return made;
    };
    m_Wall.Add(material(255, 1.0f));
    m_Wall.Add(material(0, 1.0f));
    m_Wall.Add(material(102, 1.0f));
    m_Wall.Add(material(102, 0.5f));
    m_Wall.ambient = {0.6f, 0.4f, 0.5f, 1.0f};
    Shine(ToLight(45.0));
    const std::vector<glm::dvec4> colors = m_Wall.Draw();
    const glm::dvec3 albedo(0.5, 0.25, 0.75);
    const auto linear = [](double srgb)
    {
        return std::pow((srgb + 0.055) / 1.055, 2.4);
    };
    const glm::dvec3 ambient(linear(0.6), linear(0.4), linear(0.5));
    const double open[] = {1.0, 0.0, 0.4, 0.7};
    for (std::size_t panel = 0; panel < 4; ++panel)
    {
        for (int channel = 0; channel < 3; ++channel)
        {
            const double wanted =
                albedo[channel] * (std::cos(glm::radians(45.0)) + open[panel] * ambient[channel]);
            EXPECT_NEAR(colors[panel][channel], wanted, 2e-3 * wanted) << panel;
        }
    }
}

TEST_F(LitGpu, IsLitByLampsAsByTheSun)
{
    for (const float smoothness : {0.2f, 0.8f})
    {
        for (const double tilt : {0.0, 30.0, -45.0})
        {
            const auto material = UrpMaterial("Lit");
            Set(*material, "_BaseColor", glm::vec4(0.5f, 0.25f, 0.75f, 1.0f));
            Set(*material, "_Smoothness", smoothness);
            LitSurface surface;
            surface.albedo = {0.5, 0.25, 0.75};
            surface.smoothness = static_cast<double>(smoothness);
            surface.normal = NormalOf(Tilted(tilt));
            Add(material, surface, Tilted(tilt));
        }
    }
    m_Wall.sun.intensity = 0.0f;
    for (const glm::vec3 place : {glm::vec3(-50, 12, -14), glm::vec3(-30, -20, 0)})
    {
        Light& light = m_Wall.lights.emplace_back();
        light.transform.localPosition = place;
        light.range = 100.0f;
        light.intensity = 900.0f;
    }
    const std::vector<glm::dvec4> colors = m_Wall.Draw();
    for (std::size_t i = 0; i < colors.size(); ++i)
    {
        std::vector<ArrivingLight> arriving;
        for (const Light& light : m_Wall.lights)
        {
            const glm::dvec3 away = glm::dvec3(light.transform.localPosition) - m_Wall.MiddleOf(i);
            const double distance = glm::length(away);
            const double window = std::max(1.0 - std::pow(distance / 100.0, 4), 0.0);
            arriving.push_back(
                {away / distance, glm::dvec3(900.0 * window * window / (distance * distance))});
        }
        SCOPED_TRACE("panel " + std::to_string(i));
        ExpectWithin(colors[i], SumOfLights(LitByFormula, m_Surfaces[i], arriving, k_ToCamera));
        EXPECT_GT(colors[i].g, 0.02);
    }
}

TEST_F(LitGpu, GivesNumbersWhateverItIsGiven)
{
    // Without normals and tangents there is no frame; a mesh may have them as zeros too.
    MeshData flat = CreatePrimitive(PrimitiveType::Quad)->data();
    flat.normals.assign(flat.vertices.size(), glm::vec3(0.0f));
    flat.tangents.assign(flat.vertices.size(), glm::vec4(0.0f));
    const auto degenerate = std::make_shared<const Mesh>("degenerate", flat);
    const auto quad = CreatePrimitive(PrimitiveType::Quad);
    for (const char* shader : {"Lit", "Simple Lit", "Particles/Lit", "Particles/Simple Lit"})
    {
        for (const glm::ivec4 texel : {glm::ivec4(128, 128, 255, 255), glm::ivec4(0, 0, 0, 0),
                                       glm::ivec4(128, 128, 128, 128), glm::ivec4(255, 128, 0, 255),
                                       glm::ivec4(0, 128, 255, 255)})
        {
            const auto material =
                UrpMaterial(shader, {"_NORMALMAP", "_SPECULAR_COLOR", "_EMISSION"});
            Set(*material, "_BumpMap", texel);
            Set(*material, "_BaseColor", glm::vec4(1e4f, 1, 0, 1));
            Set(*material, "_EmissionColor", glm::vec4(0, 1e6f, 0, 1));
            Set(*material, "_Metallic", 1.0f);
            Set(*material, "_Smoothness", 1.0f);
            Set(*material, "_SpecColor", glm::vec4(1));
            m_Wall.Add(material, glm::quat(1, 0, 0, 0), quad);
            m_Wall.Add(material, Tilted(89.9), quad);
            m_Wall.Add(material, glm::quat(1, 0, 0, 0), degenerate);
        }
    }
    Light& light = m_Wall.lights.emplace_back();
    light.transform.localPosition = m_Wall.MiddleOf(0); // on the surface
    light.range = 1000.0f;
    for (const glm::vec3& toLight : {glm::vec3(0, 0, -1), glm::vec3(0, 0, 1), glm::vec3(1, 0, 0)})
    {
        for (const float intensity : {0.0f, 1.0f, 1e6f, 1e12f})
        {
            Shine(toLight, intensity);
            light.intensity = intensity;
            for (const glm::dvec4& color : m_Wall.Draw())
            {
                for (int channel = 0; channel < 4; ++channel)
                {
                    ASSERT_TRUE(std::isfinite(color[channel]))
                        << color.r << ", " << color.g << ", " << color.b << ", " << color.a;
                }
            }
        }
    }
}

} // namespace
} // namespace limn::test
