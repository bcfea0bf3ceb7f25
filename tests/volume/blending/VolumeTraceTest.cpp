#include "blending/VolumeScene.h"

#include <cstring>
#include <gtest/gtest.h>
#include <limn/volume/AssetParameters.h>
#include <random>

namespace limn
{

namespace
{

using test::Mixed;
using test::TestVolume;
using test::VolumeScene;

TEST(VolumeTrace, TellsEveryStepOfAParameter)
{
    VolumeScene scene;
    Volume everywhere = test::GlobalVolume(test::ParamProfile(100.0f));
    everywhere.name = "Everywhere";
    Volume corner = test::GlobalVolume(test::ParamProfile(200.0f), 1.0f);
    corner.name = "Corner";
    corner.isGlobal = false;
    corner.blendDistance = 4.0f;
    corner.weight = 0.5f;
    corner.colliders = {SphereCollider{true, {}, 1.0f}};
    scene.manager.Register(&corner);
    scene.manager.Register(&everywhere);

    const VolumeTrace trace = scene.manager.Trace(glm::vec3(3, 0, 0), test::k_DefaultLayer);
    ASSERT_EQ(1u, trace.parameters.size());
    const VolumeParameterTrace* param = trace.Find("TestVolume", "param");
    ASSERT_EQ(&trace.parameters[0], param);
    EXPECT_EQ("123", param->startText);
    ASSERT_EQ(2u, param->steps.size());
    EXPECT_EQ("Everywhere", param->steps[0].volume);
    EXPECT_EQ(1.0f, param->steps[0].factor);
    EXPECT_EQ(std::nullopt, param->steps[0].distance);
    EXPECT_EQ("100", param->steps[0].valueText);
    EXPECT_EQ("Corner", param->steps[1].volume);
    EXPECT_EQ(0.375f, param->steps[1].factor); // 0.75 * 0.5
    EXPECT_EQ(0.5f, param->steps[1].weight);
    EXPECT_EQ(2.0f, param->steps[1].distance);
    EXPECT_EQ("200", param->steps[1].targetText);
    EXPECT_EQ("137.5", param->valueText());
    EXPECT_EQ(nullptr, trace.Find("Mixed", "number"));
}

TEST(VolumeTrace, StartsFromTheDefaultProfiles)
{
    VolumeScene scene;
    scene.manager.SetGlobalDefaultProfile(test::ParamProfile(7.0f));
    const Volume volume = test::GlobalVolume(test::ParamProfile(8.0f));
    scene.manager.Register(&volume);
    const VolumeTrace trace = scene.manager.Trace(std::nullopt, test::k_DefaultLayer);
    ASSERT_EQ(1u, trace.parameters.size());
    EXPECT_EQ("7", trace.parameters[0].startText);
}

Volume RandomVolume(std::mt19937& random)
{
    std::uniform_real_distribution<float> number(-5.0f, 5.0f);
    std::bernoulli_distribution coin;
    auto profile = std::make_shared<VolumeProfile>();
    Mixed& mixed = profile->Add<Mixed>();
    mixed.number.Override(number(random));
    mixed.number.SetOverrideState(coin(random));
    mixed.whole.Override(static_cast<int>(number(random) * 100.0f));
    mixed.flag.Override(coin(random));
    mixed.flag.SetOverrideState(coin(random));
    mixed.tint.Override({number(random), number(random), number(random), number(random)});
    profile->Add<TestVolume>().param.Override(number(random));
    Volume volume = test::GlobalVolume(profile, number(random));
    volume.isGlobal = coin(random);
    volume.enabled = coin(random) || coin(random);
    volume.weight = number(random) + 4.0f;
    volume.blendDistance = number(random) + 5.0f;
    volume.position = {number(random), number(random), number(random)};
    volume.colliders = {SphereCollider{coin(random), {}, 0.5f}, BoxCollider{}};
    return volume;
}

/// The bits of every float of Mixed and TestVolume, as text.
std::string BitsOf(const Mixed& mixed, const TestVolume& other)
{
    const Color& tint = mixed.tint.value();
    std::string bits;
    for (const float value :
         {mixed.number.value(), tint.r, tint.g, tint.b, tint.a, other.param.value()})
    {
        std::uint32_t raw = 0;
        std::memcpy(&raw, &value, sizeof raw);
        bits += std::to_string(raw) + " ";
    }
    return bits + mixed.whole.ValueText() + " " + mixed.flag.ValueText();
}

TEST(VolumeTrace, ReplayedGivesTheValuesOfUpdateBitForBit)
{
    const unsigned seed = std::random_device{}();
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    std::size_t stepCount = 0;
    for (int run = 0; run < 200; ++run)
    {
        VolumeScene scene;
        std::vector<Volume> volumes;
        for (int i = 0; i < 8; ++i)
        {
            volumes.push_back(RandomVolume(random));
        }
        for (const Volume& volume : volumes)
        {
            scene.manager.Register(&volume);
        }
        scene.Update();
        Mixed mixed;
        TestVolume other;
        const VolumeTrace trace = scene.manager.Trace(glm::vec3(0.0f), test::k_DefaultLayer);
        for (const VolumeParameterTrace& parameter : trace.parameters)
        {
            VolumeComponent& owner = parameter.component == "Mixed"
                                         ? static_cast<VolumeComponent&>(mixed)
                                         : static_cast<VolumeComponent&>(other);
            parameter.Replay(*owner.FindParameter(parameter.parameter));
            stepCount += parameter.steps.size();
        }
        EXPECT_EQ(BitsOf(scene.Get<Mixed>(), scene.Get<TestVolume>()), BitsOf(mixed, other));
    }
    EXPECT_GT(stepCount, 1000u); // the volumes do count
}

/// Blends in a way of its own and touches more than what is overridden.
class Wilful : public VolumeComponent
{
public:
    FloatParameter number{this, "number", 1.0f};
    FloatParameter echo{this, "echo", 0.0f};

    void Override(VolumeComponent& state, float interpFactor) const override
    {
        auto& to = static_cast<Wilful&>(state);
        to.number.Override(to.number.value() * 3.0f + number.value() * interpFactor);
        to.echo.SetValue(to.echo.value() + to.number.value());
    }
};

class Grouped : public VolumeComponent
{
public:
    ObjectParameter<Mixed> object{this, "object", std::make_unique<Mixed>()};
};

TEST(VolumeTrace, ReplaysAComponentThatBlendsInItsOwnWay)
{
    VolumeComponentRegistry registry;
    registry.Register<Wilful>("Wilful");
    VolumeManager manager(registry);
    VolumeStack stack = manager.CreateStack();
    std::vector<Volume> volumes;
    for (const float value : {0.1f, 0.7f, 5.0f})
    {
        auto profile = std::make_shared<VolumeProfile>();
        profile->Add<Wilful>().number.Override(value);
        volumes.push_back(test::GlobalVolume(profile));
        volumes.back().weight = 0.3f;
    }
    for (const Volume& volume : volumes)
    {
        manager.Register(&volume);
    }
    manager.Update(stack, std::nullopt, test::k_DefaultLayer);
    const VolumeTrace trace = manager.Trace(std::nullopt, test::k_DefaultLayer);
    const auto* expected = stack.GetComponent<Wilful>();
    Wilful replayed;
    ASSERT_NE(nullptr, trace.Find("Wilful", "echo")); // changed, though nobody overrides it
    EXPECT_EQ(3u, trace.Find("Wilful", "echo")->steps.size());
    trace.Find("Wilful", "echo")->Replay(replayed.echo);
    trace.Find("Wilful", "number")->Replay(replayed.number);
    EXPECT_EQ(expected->echo.value(), replayed.echo.value());
    EXPECT_EQ(expected->number.value(), replayed.number.value());
    EXPECT_NE(1.0f, replayed.number.value());
}

TEST(VolumeTrace, ReplaysAnObjectParameter)
{
    VolumeComponentRegistry registry;
    registry.Register<Grouped>("Grouped");
    VolumeManager manager(registry);
    VolumeStack stack = manager.CreateStack();
    std::vector<Volume> volumes;
    for (const float value : {0.1f, 0.7f, 5.0f})
    {
        auto profile = std::make_shared<VolumeProfile>();
        Mixed& mixed = *profile->Add<Grouped>().object.value();
        mixed.number.Override(value);
        mixed.tint.Override({value, 0.3f, 0.1f, value});
        mixed.tint.SetOverrideState(value < 1.0f);
        volumes.push_back(test::GlobalVolume(profile));
        volumes.back().weight = 0.3f;
    }
    for (const Volume& volume : volumes)
    {
        manager.Register(&volume);
    }
    manager.Update(stack, std::nullopt, test::k_DefaultLayer);
    const VolumeTrace trace = manager.Trace(std::nullopt, test::k_DefaultLayer);
    Grouped replayed;
    trace.Find("Grouped", "object")->Replay(replayed.object);
    const TestVolume unused;
    EXPECT_EQ(BitsOf(*stack.GetComponent<Grouped>()->object.value(), unused),
              BitsOf(*replayed.object.value(), unused));
    EXPECT_EQ(stack.GetComponent<Grouped>()->object.UnityText(), replayed.object.UnityText());
}

} // namespace

} // namespace limn
