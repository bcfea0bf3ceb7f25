#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Mentions.h"
#include "pipeline/PipelineTest.h"

namespace limn
{
namespace
{

using testing::ElementsAre;
using testing::IsEmpty;

/// Cubes in front of a camera, with materials on which something is set.
class UndeclaredProperty : public test::PipelineTest<>
{
protected:
    UndeclaredProperty() : PipelineTest(16, 16) {}

    std::shared_ptr<Material> AddCube(const std::shared_ptr<const Shader>& shader,
                                      const std::string& name)
    {
        const auto material = std::make_shared<Material>(shader, name);
        test::AddCube(m_Scene, name, {0, 0, 10}, {material});
        return material;
    }

    std::vector<std::string> Notes() { return Render().report.notes; }
};

TEST_F(UndeclaredProperty, IsNotedWithTheNearestName)
{
    const auto material = AddCube(test::ShaderWithProgram("_BaseColor(\"\", Color) = (1, 1, 1, 1)",
                                                          "float4 _BaseColor;", "_BaseColor"),
                                  "Paint");
    EXPECT_THAT(Notes(), IsEmpty());
    material->SetColor("_BaseColour", Color(1.0f, 0.0f, 0.0f));
    const auto note = ElementsAre(test::Mentions("'Paint'", "'_BaseColour'", "'Test/Program'",
                                                 "no such property", "'_BaseColor'"));
    EXPECT_THAT(Notes(), note);
    EXPECT_THAT(Notes(), note) << "also in the next frame";
}

TEST_F(UndeclaredProperty, IsNotedOnceForAllMaterialsOfAShader)
{
    const auto shader = test::ShaderWithProgram("_Width(\"\", Float) = 1");
    AddCube(shader, "First")->SetFloat("_Elephant", 1.0f);
    AddCube(shader, "Second")->SetFloat("_Elephant", 2.0f);
    EXPECT_THAT(Notes(), ElementsAre(testing::AllOf(
                             test::Mentions("'_Elephant'", "'Test/Program'", "no such property"),
                             testing::Not(testing::HasSubstr("did you mean")))));
}

TEST_F(UndeclaredProperty, IsNotNotedWhereAProgramReadsIt)
{
    const auto material = AddCube(
        test::ShaderWithProgram("", "float4 _Tint; Texture2D _Paint;", "_Tint + _Paint.Load(0)"),
        "Paint");
    material->SetVector("_Tint", {1.0f, 0.0f, 0.0f, 1.0f});
    material->SetTexture("_Paint", test::Target("Red"));
    EXPECT_THAT(Notes(), IsEmpty());
}

TEST_F(UndeclaredProperty, IsNotNotedWhereAnotherPassReadsIt)
{
    const auto pass = [](const std::string& tags, const std::string& program)
    {
        return "Pass { Tags { " + tags + " }\n" + program + "}\n";
    };
    const auto material =
        AddCube(test::ShaderOf("Shader \"Test/Two\" { SubShader {\n" +
                               pass("\"LightMode\" = \"SRPDefaultUnlit\"", test::Program()) +
                               pass("\"LightMode\" = \"UniversalForward\"",
                                    test::Program("float4 _Tint;", "_Tint")) +
                               "} }"),
                "Paint");
    material->SetVector("_Tint", {1.0f, 0.0f, 0.0f, 1.0f});
    EXPECT_THAT(Notes(), IsEmpty());
}

TEST_F(UndeclaredProperty, IsNotNotedWhereAnotherVariantReadsIt)
{
    const auto material = AddCube(test::ShaderWithProgram("",
                                                          "#pragma shader_feature TINTED\n"
                                                          "#if TINTED\nfloat4 _Tint;\n"
                                                          "#else\nstatic float4 _Tint = 1;\n"
                                                          "#endif\n",
                                                          "_Tint"),
                                  "Paint");
    material->SetVector("_Tint", {1.0f, 0.0f, 0.0f, 1.0f});
    EXPECT_THAT(Notes(), IsEmpty());
}

TEST_F(UndeclaredProperty, IsNotNotedWhereACommandOfThePassReadsIt)
{
    const auto material =
        AddCube(test::ShaderWithProgram("", "", "1", "ZWrite [_WritesDepth]"), "Paint");
    material->SetFloat("_WritesDepth", 1.0f);
    EXPECT_THAT(Notes(), IsEmpty());
}

TEST_F(UndeclaredProperty, IsNotNotedWhereATagOfThePassReadsIt)
{
    const auto material = AddCube(
        test::ShaderWithProgram("", "Texture2D _Mask;", "_Mask.Load(0)",
                                "Tags { \"LimnFullScreen\" = \"0 0 0 0 where _Mask is 0 within "
                                "_Reach texels\" }"),
        "Paint");
    material->SetTexture("_Mask", test::Target("Mask"));
    material->SetFloat("_Reach", 2.0f);
    EXPECT_THAT(Notes(), IsEmpty());
}

TEST_F(UndeclaredProperty, IsNoneThatGoesWithATexture)
{
    const auto material =
        AddCube(test::ShaderWithProgram("_Paint(\"\", 2D) = \"white\" {}"), "Paint");
    material->SetTextureScale("_Paint", {2.0f, 2.0f});
    EXPECT_THAT(Notes(), IsEmpty());
}

TEST_F(UndeclaredProperty, OfTheShaderBeforeIsKeptInSilence)
{
    Material before(test::ShaderWithProgram("_Old(\"\", Float) = 1"));
    before.SetFloat("_Old", 2.0f);
    const auto material =
        std::make_shared<Material>(before, test::ShaderWithProgram("_New(\"\", Float) = 1"));
    test::AddCube(m_Scene, "Cube", {0, 0, 10}, {material});
    EXPECT_THAT(Notes(), IsEmpty());
    EXPECT_EQ(2.0f, material->GetFloat("_Old"));
}

} // namespace
} // namespace limn
