#include "cull/ObjectLights.h"

#include "renderers/DrawHarness.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <gmock/gmock.h>
#include <limn/core/BuiltinShaders.h>
#include <limn/core/Camera.h>
#include <limn/core/PrimitiveMesh.h>
#include <map>
#include <random>

namespace limn::test
{
namespace
{

struct Box
{
    glm::dvec3 center;
    glm::dvec3 extent;
};

/// What a light gives the nearest point of a box, written down from URP's formulas once more.
double BrightnessAt(const Light& light, const Box& box)
{
    const Color color = light.color.linear();
    const double intensity = static_cast<double>(light.intensity) *
                             static_cast<double>(std::max(color.r, std::max(color.g, color.b)));
    if (light.type == LightType::Directional)
    {
        return intensity;
    }
    const glm::dvec3 place(light.transform.localPosition);
    const glm::dvec3 nearest = glm::clamp(place, box.center - box.extent, box.center + box.extent);
    const double distance = std::max(glm::distance(place, nearest), std::sqrt(std::exp2(-14)));
    const double range = static_cast<double>(light.range);
    if (distance >= range)
    {
        return 0.0;
    }
    if (light.type == LightType::Spot)
    {
        // By angles: how far the ball's middle is outside of the cone, against what the ball spans.
        const glm::dvec3 toBall = box.center - place;
        const double away = glm::length(toBall);
        const double radius = glm::length(box.extent);
        const glm::dvec3 forward(light.transform.forward());
        const double angle = std::acos(glm::dot(forward, toBall) / away) -
                             glm::radians(static_cast<double>(light.spotAngle)) / 2;
        if (away > radius && angle > std::asin(radius / away))
        {
            return 0.0;
        }
    }
    return intensity * std::pow(1.0 - std::pow(distance / range, 4), 2) / (distance * distance);
}

/// By choosing the best one again and again.
ObjectLights::Set BrightestOf(const std::vector<Light>& lights, const Box& box, int limit)
{
    ObjectLights::Set set = 0;
    for (int n = 0; n < limit; ++n)
    {
        int best = -1;
        for (int i = 0; i < static_cast<int>(lights.size()); ++i)
        {
            const double own = BrightnessAt(lights[static_cast<std::size_t>(i)], box);
            const bool isTaken = (set >> i & 1u) != 0;
            if (!isTaken && own > 0.0 &&
                (best < 0 || own > BrightnessAt(lights[static_cast<std::size_t>(best)], box)))
            {
                best = i;
            }
        }
        set |= best < 0 ? 0 : ObjectLights::Set{1} << best;
    }
    return set;
}

class LightsOfObjects : public testing::Test
{
protected:
    float Random(float low, float high)
    {
        return std::uniform_real_distribution<float>(low, high)(m_Random);
    }
    glm::vec3 Place() { return {Random(-20, 20), Random(-20, 20), Random(-20, 20)}; }
    Light AnyLight()
    {
        Light light;
        const int kind = std::uniform_int_distribution<int>(0, 7)(m_Random);
        light.type = kind == 0  ? LightType::Directional
                     : kind < 4 ? LightType::Spot
                                : LightType::Point;
        light.transform.localPosition = Place();
        light.transform.localRotation =
            EulerToRotation({Random(-180, 180), Random(-180, 180), 0.0f});
        light.color = {Random(0, 1), Random(0, 1), Random(0, 1), 1.0f};
        light.intensity = light.type == LightType::Directional ? Random(0, 0.1f) : Random(0, 9);
        light.range = Random(5, 40);
        light.spotAngle = Random(5, 170);
        return light;
    }
    static std::vector<const Light*> PointersTo(const std::vector<Light>& lights)
    {
        std::vector<const Light*> pointers;
        for (const Light& light : lights)
        {
            pointers.push_back(&light);
        }
        return pointers;
    }

    std::mt19937 m_Random{7};
};

TEST_F(LightsOfObjects, AreTheBrightestOfThoseThatReachThem)
{
    ObjectLights chosen;
    int full = 0;
    int fewer = 0;
    for (int round = 0; round < 300; ++round)
    {
        std::vector<Light> lights(static_cast<std::size_t>(9 + round % 24));
        for (Light& light : lights)
        {
            light = AnyLight();
        }
        const int limit = 1 + round % 8;
        chosen.Begin(PointersTo(lights), limit);
        ASSERT_TRUE(chosen.isNeeded());
        for (int i = 0; i < 30; ++i)
        {
            const Box box{glm::dvec3(Place()), {Random(0, 4), Random(0, 4), Random(0, 4)}};
            const ObjectLights::Set set = chosen.Find(box.center, box.extent);
            ASSERT_EQ(set, BrightestOf(lights, box, limit)) << "round " << round << ", box " << i;
            (std::popcount(set) == limit ? full : fewer) += 1;
        }
    }
    EXPECT_GT(full, 1000);
    EXPECT_GT(fewer, 500);
}

TEST_F(LightsOfObjects, AreTheFirstOfEqualOnes)
{
    std::vector<Light> lights(9);
    lights[6].intensity = 2.0f;
    ObjectLights chosen;
    chosen.Begin(PointersTo(lights), 3);
    EXPECT_EQ(chosen.Find({0, 0, 3}, glm::dvec3(1.0)), 0b1000011u);
}

TEST_F(LightsOfObjects, AreAllWhereThereAreNoMoreThanTheLimit)
{
    const std::vector<Light> lights(4);
    ObjectLights chosen;
    chosen.Begin(PointersTo(lights), 4);
    EXPECT_FALSE(chosen.isNeeded());
    chosen.Begin(PointersTo(lights), 3);
    EXPECT_TRUE(chosen.isNeeded());
    chosen.Begin({}, 0);
    EXPECT_FALSE(chosen.isNeeded());
}

/// A field of cubes of one material under a row of bulbs.
class LitDraws : public LightsOfObjects
{
protected:
    LitDraws()
    {
        const auto material =
            std::make_shared<Material>(FindBuiltinShader("Limn/Half Lambert", Compiler()));
        const std::shared_ptr<const Mesh> cube = CreatePrimitive(PrimitiveType::Cube);
        m_Camera.transform.localPosition = {0, 0, -60};
        for (int i = 0; i < k_Cubes; ++i)
        {
            GameObject& object = m_Scene.Add("cube");
            object.transform.localPosition = {2.0f * static_cast<float>(i) - k_Cubes, 0, 0};
            object.renderer = MeshRenderer{cube, {material}};
        }
        for (int i = 0; i < 20; ++i)
        {
            Light& light = m_Lights.emplace_back();
            light.transform.localPosition = {4.0f * static_cast<float>(i) - 40.0f, 2.0f, 0.0f};
            light.range = 9.0f;
        }
    }

    static RTHandle Target(const char* name, GraphicsFormat format)
    {
        return RTHandle(std::make_shared<const RenderTexture>(
            name, RenderTextureDescriptor(4, 4, format), SamplerState(), true));
    }
    FrameCommands Draw(int limit, const char* pass)
    {
        RenderReport report;
        ScriptableRenderContext context(report);
        const CullingResults results = Cull(m_Scene, m_Camera, 4.0f);
        context.SetObjectLights(PointersTo(m_Lights), limit);
        CommandBuffer cmd;
        cmd.SetRenderTarget(Target("color", GraphicsFormat::R8G8B8A8_UNorm),
                            Target("depth", GraphicsFormat::D32_SFloat)); // so order is free
        cmd.EnableKeyword(GlobalKeyword("_ADDITIONAL_LIGHTS"));
        context.ExecuteCommandBuffer(cmd);
        DrawingSettings drawing;
        drawing.shaderTagIds = {ShaderTagId(pass)};
        drawing.sortingSettings.criteria = SortingCriteria::CommonOpaque;
        context.DrawRenderers(results, drawing, FilteringSettings(RenderQueueRange::all));
        return context.TakeCommands();
    }

    static constexpr int k_Cubes = 30;
    Scene m_Scene;
    Camera m_Camera;
    std::vector<Light> m_Lights;
};

TEST_F(LitDraws, AreMergedWhereTheirLightsAreTheSame)
{
    constexpr int k_Limit = 2;
    const FrameCommands frame = Draw(k_Limit, "UniversalForward");
    std::map<ObjectLights::Set, int> expected; // cubes by their lights
    for (const auto& object : m_Scene.objects())
    {
        const Box box{glm::dvec3(object->transform.localPosition), glm::dvec3(0.5)};
        ++expected[BrightestOf(m_Lights, box, k_Limit)];
    }
    ASSERT_GT(expected.size(), 3u);
    ASSERT_LT(expected.size(), std::size_t{k_Cubes});
    std::map<ObjectLights::Set, int> drawn;
    for (const SeenDraw& draw : DrawsOf(frame))
    {
        const auto count = ReadUniform<float>(frame, draw, "limn_LightCount", 1).at(0);
        const auto indices = ReadUniform<float>(frame, draw, "unity_LightIndices", 8);
        ObjectLights::Set set = 0;
        for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
        {
            set |= ObjectLights::Set{1} << static_cast<int>(indices[i]);
        }
        EXPECT_EQ(drawn.count(set), 0u) << "two draws of the same lights";
        drawn[set] = static_cast<int>(draw.instanceCount);
        for (std::uint32_t i = 0; i < draw.instanceCount; ++i)
        {
            const auto x = static_cast<double>(frame.PerDraw(draw, i).objectToWorld[12]);
            EXPECT_EQ(set, BrightestOf(m_Lights, {{x, 0, 0}, glm::dvec3(0.5)}, k_Limit)) << x;
        }
    }
    EXPECT_EQ(drawn, expected);
}

TEST_F(LitDraws, AreOneWhereNobodyLooksAtTheLights)
{
    EXPECT_EQ(DrawsOf(Draw(2, "DepthOnly")).size(), 1u);
    m_Lights.resize(2);
    EXPECT_EQ(DrawsOf(Draw(2, "UniversalForward")).size(), 1u) << "all have both";
}

} // namespace
} // namespace limn::test
