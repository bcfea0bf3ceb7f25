#include <gtest/gtest.h>

#include "Mentions.h"
#include "ThrownMessage.h"
#include "scene/TestScene.h"

namespace limn
{
namespace
{

/// A material of a shader with these properties and a single pass.
Material MaterialWith(const std::string& properties)
{
    return Material(test::ShaderOf("Shader \"Test/Properties\" { Properties { " + properties +
                                   " } SubShader { Pass { } } }"));
}

template <typename T>
T ValueOf(const Material& material, const char* name)
{
    const ShaderPropertyValue* value = material.Find(ShaderPropertyId(name));
    if (value == nullptr || !std::holds_alternative<T>(*value))
    {
        ADD_FAILURE() << name << " has no value of this kind";
        return T{};
    }
    return std::get<T>(*value);
}

TEST(Material, BeginsWithTheDefaultsOfItsShader)
{
    const Material material =
        MaterialWith("_Width (\"Width\", Float) = 1.5\n_Cut (\"Cut\", Range(0, 1)) = 0.25\n"
                     "_Old (\"Old\", Int) = 3\n_Count (\"Count\", Integer) = 4\n"
                     "_Tint (\"Tint\", Color) = (0.1, 0.2, 0.3, 0.4)\n"
                     "_Offset (\"Offset\", Vector) = (1, 2, 3, 4)\n"
                     "[HDR] _Glow (\"Glow\", Color) = (2, 3, 4, 1)");
    EXPECT_EQ(ValueOf<float>(material, "_Width"), 1.5f);
    EXPECT_EQ(ValueOf<float>(material, "_Cut"), 0.25f);
    EXPECT_EQ(ValueOf<float>(material, "_Old"), 3.0f);
    EXPECT_EQ(ValueOf<int>(material, "_Count"), 4);
    EXPECT_EQ(ValueOf<Color>(material, "_Tint"), (Color{0.1f, 0.2f, 0.3f, 0.4f}));
    EXPECT_EQ(ValueOf<glm::vec4>(material, "_Offset"), glm::vec4(1, 2, 3, 4));
    EXPECT_EQ(ValueOf<glm::vec4>(material, "_Glow"), glm::vec4(2, 3, 4, 1));
}

TEST(Material, KeepsValuesOfNamesThatTheShaderLacks)
{
    Material material = MaterialWith("");
    EXPECT_EQ(material.Find(ShaderPropertyId("_Later")), nullptr);
    material.SetFloat(ShaderPropertyId("_Later"), 5.0f);
    EXPECT_EQ(ValueOf<float>(material, "_Later"), 5.0f);
}

TEST(Material, IsCalledAfterItsShaderUnlessNamed)
{
    const auto shader = test::ShaderWithModes({"A"});
    EXPECT_EQ(Material(shader).name(), "Test/Modes");
    EXPECT_EQ(Material(shader, "Glass").name(), "Glass");
    EXPECT_NE(Material(shader).id(), Material(shader).id());
}

TEST(Material, NeedsAShader)
{
    EXPECT_THAT(test::ThrownMessage<ContractError>([] { Material(nullptr); }),
                test::Mentions("material", "shader", "null"));
}

TEST(Material, HasItsShadersQueueUntilItGetsItsOwn)
{
    Material material(test::ShaderWithModes({"A"}, "Transparent"), "Glass");
    EXPECT_EQ(material.renderQueue(), 3000);
    material.SetRenderQueue(0);
    EXPECT_EQ(material.renderQueue(), 0);
    material.SetRenderQueue(5000);
    EXPECT_EQ(material.renderQueue(), 5000);
    material.SetRenderQueue(-1);
    EXPECT_EQ(material.renderQueue(), 3000);
}

TEST(Material, RefusesAQueueThatIsNone)
{
    Material material(test::ShaderWithModes({"A"}), "Glass");
    EXPECT_EQ(test::ThrownMessage<ContractError>([&] { material.SetRenderQueue(5001); }),
              "material 'Glass': render queue 5001 is outside 0...5000");
    EXPECT_EQ(test::ThrownMessage<ContractError>([&] { material.SetRenderQueue(-2); }),
              "material 'Glass': render queue -2 is outside 0...5000");
    EXPECT_EQ(material.renderQueue(), 2000);
}

TEST(Material, GrowsItsVersionWithEveryChange)
{
    Material material(test::ShaderWithModes({"A"}));
    std::uint64_t before = material.version();
    const auto expectGrowth = [&](const char* what)
    {
        EXPECT_GT(material.version(), before) << what;
        before = material.version();
    };
    material.SetFloat(ShaderPropertyId("_A"), 1);
    expectGrowth("SetFloat");
    material.SetColor(ShaderPropertyId("_B"), Color::red);
    expectGrowth("SetColor");
    material.SetTexture(ShaderPropertyId("_C"), nullptr);
    expectGrowth("SetTexture");
    material.SetRenderQueue(3000);
    expectGrowth("SetRenderQueue");
}

TEST(MaterialPropertyBlock, IsEmptyUntilSomethingIsSet)
{
    MaterialPropertyBlock block;
    EXPECT_TRUE(block.isEmpty());
    block.SetFloat(ShaderPropertyId("_A"), 1.0f);
    EXPECT_FALSE(block.isEmpty());
    block.Clear();
    EXPECT_TRUE(block.isEmpty());
    EXPECT_EQ(block.Find(ShaderPropertyId("_A")), nullptr);
}

TEST(ShaderPropertyId, IsEqualForEqualNamesOnly)
{
    EXPECT_EQ(ShaderPropertyId("_MainTex"), ShaderPropertyId(std::string("_Main") + "Tex"));
    EXPECT_NE(ShaderPropertyId("_MainTex"), ShaderPropertyId("_maintex"));
    EXPECT_EQ(ShaderPropertyId("_MainTex").name(), "_MainTex");
    EXPECT_EQ(ShaderPropertyId().name(), "");
    EXPECT_EQ(ShaderPropertyId(""), ShaderPropertyId());
    EXPECT_EQ(Shader::PropertyToID("_MainTex"), ShaderPropertyId("_MainTex"));
}

TEST(Vectors, AreMadeOfShorterOnesAsInUnity)
{
    MaterialPropertyBlock block;
    block.SetVector("_V", Vector2(1, 2));
    EXPECT_EQ(block.GetVector("_V"), Vector4(1, 2, 0, 0));
    block.SetVector("_V", Vector3(1, 2, 3));
    EXPECT_EQ(block.GetVector("_V"), Vector4(1, 2, 3, 0));
    block.SetVector("_V", Color(0.5f, 0.25f, 1.0f, 0.75f));
    EXPECT_EQ(block.GetVector("_V"), Vector4(0.5f, 0.25f, 1.0f, 0.75f)) << "as it is";
    block.SetVector("_V", {1, 2, 3, 4});
    EXPECT_EQ(block.GetVector("_V"), Vector4(1, 2, 3, 4));
    Shader::SetGlobalVector("_TestShorterVector", Vector2(3, 4));
    EXPECT_EQ(Shader::GetGlobalVector("_TestShorterVector"), Vector4(3, 4, 0, 0));
}

} // namespace
} // namespace limn
