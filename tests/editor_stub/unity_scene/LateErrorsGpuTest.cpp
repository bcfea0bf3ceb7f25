// Shaders of a Unity scene that compile for the pass that is looked at first and not for another.

#include "Mentions.h"
#include "unity_scene/GpuTestOfAProject.h"

namespace limn::test
{
namespace
{

using testing::HasSubstr;
using testing::Not;

constexpr const char* k_WholeMaterial = "aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa";  ///< a material
constexpr const char* k_BrokenMaterial = "cccccccccccccccccccccccccccccccc"; ///< another
constexpr const char* k_GreenUnlessBroken = R"(Shader "Test/Green" { SubShader {
Pass {
HLSLPROGRAM
#pragma vertex V
#pragma fragment F
#pragma shader_feature _ BROKEN
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
float4 V(float4 p : POSITION) : SV_POSITION { return TransformObjectToHClip(p.xyz); }
float4 F() : SV_Target
{
#ifdef BROKEN
    return missing;
#endif
    return float4(0, 1, 0, 1);
}
ENDHLSL } } })";

class LateErrors : public GpuTestOfAProject
{
protected:
    void SetUp() override
    {
        GpuTestOfAProject::SetUp();
        Write("Assets/Green.shader", k_GreenUnlessBroken, "dddddddddddddddddddddddddddddddd");
        WriteMaterial("Assets/Whole.mat", k_WholeMaterial, "");
        WriteMaterial("Assets/Broken.mat", k_BrokenMaterial, "  m_ValidKeywords:\n  - BROKEN\n");
    }
    void WriteMaterial(const std::string& name, const std::string& guid, const std::string& more)
    {
        WriteAsset(name,
                   "--- !u!21 &2100000\nMaterial:\n  m_Shader: {fileID: 4800000, guid: "
                   "dddddddddddddddddddddddddddddddd, type: 3}\n" +
                       more,
                   guid);
    }
};

// The keyword of the material is looked at by the first draw alone.
TEST_F(LateErrors, MakeObjectsMagentaAndLeaveThePicture)
{
    const std::string said = Draw(CameraAt("1", "Main", 0, "r: 0, g: 0, b: 1, a: 1", "") +
                                  QuadAt("3", -0.5f, -0.5f, 1, k_WholeMaterial) +
                                  QuadAt("4", 0.5f, 0.5f, 1, k_BrokenMaterial));
    EXPECT_EQ("255 0 255", Quarter(1, 1));
    EXPECT_EQ("0 0 255", Quarter(0, 1));
    EXPECT_THAT(said, Mentions("Green.shader:12", "missing"));
    EXPECT_THAT(said, Mentions("'Test/Green' cannot be drawn", "magenta"));
}

TEST_F(LateErrors, AreNotMentionedWhereNothingIsBroken)
{
    const std::string said = Draw(CameraAt("1", "Main", 0, "r: 0, g: 0, b: 1, a: 1", "") +
                                  QuadAt("3", -0.5f, -0.5f, 1, k_WholeMaterial));
    EXPECT_EQ("0 255 0", Quarter(0, 0));
    EXPECT_EQ("0 0 255", Quarter(1, 1));
    EXPECT_THAT(said, Not(HasSubstr("Green.shader")));
}

} // namespace
} // namespace limn::test
