#include <array>
#include <glm/gtc/type_ptr.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <map>
#include <random>

#include "renderers/DrawHarness.h"

namespace limn
{
namespace
{

using testing::ElementsAre;

using Four = std::array<float, 4>;

Four FourOf(const std::vector<float>& values)
{
    return {values.at(0), values.at(1), values.at(2), values.at(3)};
}

/// One of the places from which a uniform may get its value, as the test keeps it.
struct Layer
{
    std::map<std::string, Four> values;
    std::optional<std::array<int, 2>> map; ///< the size of the texture _Map
};

/// What a uniform is by Unity's rules: the draw's own value, else the material's, else the global
/// one; X_TexelSize that nothing sets describes X, and X_ST is (1, 1, 0, 0).
Four Expected(const std::string& name, const std::vector<Layer>& firstToLast)
{
    for (const Layer& layer : firstToLast)
    {
        if (const auto value = layer.values.find(name); value != layer.values.end())
        {
            return value->second;
        }
    }
    if (name == "_Map_ST")
    {
        return {1, 1, 0, 0};
    }
    if (name != "_Map_TexelSize")
    {
        return {};
    }
    for (const Layer& layer : firstToLast)
    {
        if (layer.map)
        {
            const auto w = static_cast<float>((*layer.map)[0]);
            const auto h = static_cast<float>((*layer.map)[1]);
            return {1.0f / w, 1.0f / h, w, h};
        }
    }
    return {1, 1, 1, 1};
}

// The layers change at random, from frame to frame of one context, and two materials of one shader
// take turns.
TEST(UniformLayers, GiveEachDrawWhatThePlainRuleGives)
{
    const std::vector<std::string> names = {"_A", "_B", "_C", "_Map_TexelSize", "_Map_ST"};
    const auto shader = test::ShaderWithProgram(
        "",
        "cbuffer UnityPerMaterial { float4 _A; float4 _Map_ST; float4 _B; }\n"
        "float4 _C; float4 _Map_TexelSize;",
        "_A + _B + _C + _Map_TexelSize + _Map_ST");
    std::array<std::shared_ptr<Material>, 2> materials;
    for (auto& material : materials)
    {
        material = std::make_shared<Material>(shader, "Paint");
    }
    std::array<Layer, 2> ofMaterials;
    test::OneDraw draw;
    std::minstd_rand random(20261128);
    const auto oneOf = [&](std::size_t count)
    {
        return random() % count;
    };
    int fromDraw = 0;
    for (int frame = 0; frame < 600; ++frame)
    {
        const std::string& name = names[oneOf(names.size())];
        const std::array<int, 2> size = {1 + static_cast<int>(oneOf(64)), 2};
        const auto number = static_cast<float>(frame);
        const Four vector = {number, number + 0.25f, -number, 0.5f};
        const Four single = {number, 0, 0, 0}; // the rest of what was there before is 0
        const std::size_t which = oneOf(2);
        Material& material = *materials[which];
        Layer& ofMaterial = ofMaterials[which];
        Layer own;
        Layer global;
        draw.block.Clear();
        draw.before.Clear();
        const auto map = test::Target("map", size[0], size[1]);
        switch (oneOf(8))
        {
        case 0:
            material.SetVector(ShaderPropertyId(name), glm::make_vec4(vector.data()));
            ofMaterial.values[name] = vector;
            break;
        case 1:
            material.SetFloat(ShaderPropertyId(name), number);
            ofMaterial.values[name] = single;
            break;
        case 2:
            material.SetTexture(ShaderPropertyId("_Map"), map);
            ofMaterial.map = size;
            break;
        case 3:
            draw.block.SetVector(ShaderPropertyId(name), glm::make_vec4(vector.data()));
            own.values[name] = vector;
            ++fromDraw;
            break;
        case 4:
            draw.block.SetTexture(ShaderPropertyId("_Map"), map);
            own.map = size;
            break;
        case 5:
            draw.before.SetGlobalTexture(ShaderPropertyId("_Map"), map);
            global.map = size;
            break;
        default: // nothing but the globals below
            break;
        }
        for (const std::string& each : names)
        {
            if (oneOf(3) == 0)
            {
                draw.before.SetGlobalVector(ShaderPropertyId(each), glm::make_vec4(vector.data()));
                global.values[each] = vector;
            }
        }
        draw.Resolve(materials[which]);
        for (const std::string& each : names)
        {
            ASSERT_EQ(FourOf(draw.Floats(each, 4)), Expected(each, {own, ofMaterial, global}))
                << each << " in frame " << frame;
        }
    }
    EXPECT_GT(fromDraw, 30);
}

// What is global belongs to the moment in which it is drawn: two draws of one frame.
TEST(UniformLayers, TakeTheGlobalOfTheDrawsOwnMoment)
{
    const auto material = std::make_shared<Material>(
        test::ShaderWithProgram("", "float4 _A; float4 _B;", "_A + _B"), "Paint");
    RenderReport report;
    ScriptableRenderContext context(report);
    CommandBuffer cmd;
    for (const float value : {1.0f, 2.0f})
    {
        cmd.SetGlobalVector(ShaderPropertyId("_A"), glm::vec4(value));
        cmd.DrawProcedural(glm::mat4(1.0f), material, 0, 3);
    }
    context.ExecuteCommandBuffer(cmd);
    const FrameCommands frame = context.TakeCommands();
    const auto draws = test::DrawsOf(frame);
    ASSERT_EQ(draws.size(), 2u);
    EXPECT_THAT(test::ReadUniform<float>(frame, draws[0], "_A", 4), ElementsAre(1, 1, 1, 1));
    EXPECT_THAT(test::ReadUniform<float>(frame, draws[1], "_A", 4), ElementsAre(2, 2, 2, 2));
}

// A global that does not fit is no error where a material or a draw has a value that does.
TEST(UniformLayers, PassOverAGlobalOfAnotherKindThatAValueHides)
{
    const auto material = std::make_shared<Material>(
        test::ShaderWithProgram("", "float4 _A; float4 _B;", "_A + _B"), "Paint");
    test::OneDraw draw;
    draw.before.SetGlobalTexture(ShaderPropertyId("_A"), test::Target("map"));
    draw.before.SetGlobalVector(ShaderPropertyId("_B"), {5, 6, 7, 8});
    EXPECT_THROW(draw.Resolve(material), ContractError);
    draw.block.SetVector(ShaderPropertyId("_A"), {1, 2, 3, 4});
    draw.Resolve(material);
    EXPECT_THAT(draw.Floats("_A", 4), ElementsAre(1, 2, 3, 4));
    EXPECT_THAT(draw.Floats("_B", 4), ElementsAre(5, 6, 7, 8));
    draw.block.Clear();
    material->SetVector(ShaderPropertyId("_A"), {4, 3, 2, 1});
    draw.Resolve(material);
    EXPECT_THAT(draw.Floats("_A", 4), ElementsAre(4, 3, 2, 1));
}

} // namespace
} // namespace limn
