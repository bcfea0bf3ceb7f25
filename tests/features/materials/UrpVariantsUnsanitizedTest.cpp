#include "core/scene/TestScene.h"

#include <algorithm>
#include <gmock/gmock.h>
#include <limn/core/BuiltinShaders.h>
#include <limn/core/Shader.h>

namespace limn::test
{
namespace
{

/// Unity's keywords (2022.3) of materials, and those that limn sets for a frame.
const std::vector<std::string> k_OfMaterials = {"_NORMALMAP",
                                                "_PARALLAXMAP",
                                                "_DETAIL_MULX2",
                                                "_DETAIL_SCALED",
                                                "_EMISSION",
                                                "_METALLICSPECGLOSSMAP",
                                                "_OCCLUSIONMAP",
                                                "_SMOOTHNESS_TEXTURE_ALBEDO_CHANNEL_A",
                                                "_SPECULAR_SETUP",
                                                "_SPECULARHIGHLIGHTS_OFF",
                                                "_RECEIVE_SHADOWS_OFF",
                                                "_ENVIRONMENTREFLECTIONS_OFF",
                                                "_ALPHATEST_ON",
                                                "_SURFACE_TYPE_TRANSPARENT",
                                                "_ALPHAPREMULTIPLY_ON",
                                                "_ALPHAMODULATE_ON",
                                                "_SPECGLOSSMAP",
                                                "_SPECULAR_COLOR",
                                                "_GLOSSINESS_FROM_BASE_ALPHA",
                                                "_FLIPBOOKBLENDING_ON",
                                                "_SOFTPARTICLES_ON",
                                                "_FADING_ON",
                                                "_DISTORTION_ON",
                                                "_COLOROVERLAY_ON",
                                                "_COLORCOLOR_ON",
                                                "_COLORADDSUBDIFF_ON"};
const std::vector<std::string> k_OfFrames = {"_MAIN_LIGHT_SHADOWS",
                                             "_MAIN_LIGHT_SHADOWS_CASCADE",
                                             "_ADDITIONAL_LIGHTS",
                                             "_ADDITIONAL_LIGHT_SHADOWS",
                                             "_SHADOWS_SOFT",
                                             "_SCREEN_SPACE_OCCLUSION",
                                             "FOG_LINEAR",
                                             "FOG_EXP",
                                             "FOG_EXP2",
                                             "_CASTING_PUNCTUAL_LIGHT_SHADOW"};

class UrpVariants : public testing::TestWithParam<const char*>
{
protected:
    const std::shared_ptr<const Shader> m_Shader =
        FindBuiltinShader("Universal Render Pipeline/" + std::string(GetParam()), Compiler());
};

TEST_P(UrpVariants, CompileWithoutKeywordsWithEachAndWithAll)
{
    ASSERT_NE(m_Shader, nullptr);
    for (int pass = 0; pass < m_Shader->passCount(); ++pass)
    {
        std::vector<std::vector<std::string>> choices = {{}};
        std::vector<std::string> all;
        for (const auto* list : {&k_OfMaterials, &k_OfFrames})
        {
            for (const std::string& keyword : *list)
            {
                if (pass == 0) // the one that is lit
                {
                    choices.push_back({keyword});
                }
                all.push_back(keyword);
            }
        }
        choices.push_back(all);
        for (const std::vector<std::string>& enabled : choices)
        {
            SCOPED_TRACE("pass " + std::to_string(pass) + testing::PrintToString(enabled));
            EXPECT_NO_THROW(m_Shader->Compile(pass, enabled));
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Shaders, UrpVariants,
                         testing::Values("Lit", "Simple Lit", "Baked Lit", "Unlit", "Particles/Lit",
                                         "Particles/Simple Lit", "Particles/Unlit"),
                         [](const auto& shader)
                         {
                             std::string name = shader.param;
                             std::erase_if(name, [](char c) { return c == ' ' || c == '/'; });
                             return name;
                         });

/// Returns the keywords that any pass of a shader has of a list.
std::vector<std::string> HasOf(const Shader& shader, const std::vector<std::string>& keywords)
{
    std::vector<std::string> found;
    std::ranges::copy_if(keywords, std::back_inserter(found),
                         [&](const std::string& keyword) { return shader.HasKeyword(keyword); });
    return found;
}

TEST(UrpShaders, HaveUnitysKeywords)
{
    const auto find = [](const std::string& name)
    {
        return FindBuiltinShader("Universal Render Pipeline/" + name, Compiler());
    };
    const auto first = k_OfMaterials.begin();
    EXPECT_EQ(HasOf(*find("Lit"), k_OfMaterials), std::vector<std::string>(first, first + 16));
    EXPECT_EQ(HasOf(*find("Lit"), k_OfFrames), k_OfFrames);
    EXPECT_THAT(HasOf(*find("Unlit"), k_OfMaterials),
                testing::ElementsAre("_ALPHATEST_ON", "_SURFACE_TYPE_TRANSPARENT",
                                     "_ALPHAPREMULTIPLY_ON", "_ALPHAMODULATE_ON"));
    EXPECT_THAT(HasOf(*find("Simple Lit"), k_OfMaterials),
                testing::ElementsAre("_NORMALMAP", "_EMISSION", "_RECEIVE_SHADOWS_OFF",
                                     "_ALPHATEST_ON", "_SURFACE_TYPE_TRANSPARENT",
                                     "_ALPHAPREMULTIPLY_ON", "_ALPHAMODULATE_ON", "_SPECGLOSSMAP",
                                     "_SPECULAR_COLOR", "_GLOSSINESS_FROM_BASE_ALPHA"));
}

TEST(UrpShaders, HaveUnitysPasses)
{
    const auto modes = [](const std::string& name)
    {
        const auto shader = FindBuiltinShader("Universal Render Pipeline/" + name, Compiler());
        std::vector<std::string> found;
        for (int pass = 0; pass < shader->passCount(); ++pass)
        {
            found.emplace_back(shader->passLightMode(pass));
        }
        return found;
    };
    using testing::ElementsAre;
    for (const char* name : {"Lit", "Simple Lit"})
    {
        EXPECT_THAT(modes(name), ElementsAre("UniversalForward", "ShadowCaster", "DepthOnly",
                                             "DepthNormals", "Meta"));
    }
    for (const char* name : {"Baked Lit", "Unlit"})
    {
        EXPECT_THAT(modes(name),
                    ElementsAre("UniversalForwardOnly", "DepthOnly", "DepthNormalsOnly", "Meta"));
    }
    EXPECT_THAT(modes("Particles/Lit"),
                ElementsAre("UniversalForward", "DepthOnly", "DepthNormals"))
        << "particles throw no shadows";
}

} // namespace
} // namespace limn::test
