#include "Mentions.h"
#include "TestComponents.h"

#include <core/ThrownMessage.h>
#include <gtest/gtest.h>
#include <limn/volume/VolumeComponent.h>
#include <string>
#include <vector>

namespace limn
{

namespace
{

using test::Mentions;
using test::Mixed;
using test::ScreenSpaceOutline;
using test::ThrownMessage;

TEST(VolumeComponent, ListsItsParametersInTheOrderOfDeclaration)
{
    const ScreenSpaceOutline outline;
    std::vector<std::string> names;
    for (const VolumeParameter* parameter : outline.parameters())
    {
        names.push_back(parameter->name());
    }
    EXPECT_EQ(names, (std::vector<std::string>{"m_Enable", "m_OutlineColor", "m_OutlineWidth"}));
}

TEST(VolumeComponent, ListsTheParametersOfItsBaseClassFirst)
{
    struct Derived : ScreenSpaceOutline
    {
        FloatParameter glow{this, "glow", 1.0f};
    };
    const Derived derived;
    ASSERT_EQ(derived.parameters().size(), 4u);
    EXPECT_EQ(derived.parameters().back(), &derived.glow);
}

TEST(VolumeComponent, FindsAParameterByBothSpellings)
{
    const ScreenSpaceOutline outline;
    EXPECT_EQ(outline.FindParameter("m_OutlineWidth"), &outline.m_OutlineWidth);
    EXPECT_EQ(outline.FindParameter("outlineWidth"), &outline.m_OutlineWidth);
    EXPECT_EQ(outline.FindParameter("OutlineWidth"), nullptr);
}

TEST(VolumeComponent, IsActiveAndOverridesNothingWhenNew)
{
    const ScreenSpaceOutline outline;
    EXPECT_TRUE(outline.active);
    for (const VolumeParameter* parameter : outline.parameters())
    {
        EXPECT_FALSE(parameter->overrideState());
    }
}

TEST(VolumeComponent, SetsAllOverrideStatesAtOnce)
{
    ScreenSpaceOutline outline;
    outline.SetAllOverridesTo(true);
    EXPECT_TRUE(outline.m_Enable.overrideState());
    EXPECT_TRUE(outline.m_OutlineColor.overrideState());
    EXPECT_TRUE(outline.m_OutlineWidth.overrideState());
    outline.SetAllOverridesTo(false);
    EXPECT_FALSE(outline.m_OutlineWidth.overrideState());
}

TEST(VolumeComponent, OverridesOnlyWhatIsOverriddenAndMarksIt)
{
    Mixed state;
    Mixed profile;
    profile.number.Override(8.0f);
    profile.whole.SetValue(8);
    profile.Override(state, 0.5f);
    EXPECT_EQ(state.number.value(), 4.0f);
    EXPECT_TRUE(state.number.overrideState());
    EXPECT_EQ(state.whole.value(), 0);
    EXPECT_FALSE(state.whole.overrideState());
}

TEST(VolumeComponent, BlendsOneOverrideOntoTheResultOfTheOther)
{
    Mixed state;
    Mixed profile;
    profile.number.Override(8.0f);
    profile.Override(state, 0.5f);
    profile.Override(state, 0.5f);
    EXPECT_EQ(state.number.value(), 6.0f);
}

TEST(VolumeComponent, RefusesToOverrideAnotherType)
{
    Mixed state;
    const ScreenSpaceOutline outline;
    EXPECT_THAT(ThrownMessage<ContractError>([&] { outline.Override(state, 1.0f); }),
                Mentions("test::ScreenSpaceOutline", "override", "test::Mixed"));
}

TEST(VolumeComponent, RefusesTwoParametersThatProfilesCouldNotTellApart)
{
    struct Twins : VolumeComponent
    {
        FloatParameter first{this, "m_Width", 0.0f};
        FloatParameter second{this, "width", 0.0f};
    };
    EXPECT_THAT(ThrownMessage<ContractError>([] { Twins(); }),
                Mentions("two parameters", "'width'"));

    struct Shadow : VolumeComponent
    {
        BoolParameter active2{this, "m_Active", false};
    };
    EXPECT_THAT(ThrownMessage<ContractError>([] { Shadow(); }),
                Mentions("'m_Active'", "component's own"));
}

TEST(IPostProcessComponent, AnswersFromTheBlendedValues)
{
    struct Glow : VolumeComponent, IPostProcessComponent
    {
        FloatParameter intensity{this, "intensity", 0.0f};
        bool IsActive() const override { return intensity.value() > 0.0f; }
        bool IsTileCompatible() const override { return false; }
    };
    Glow glow;
    const IPostProcessComponent& question = glow;
    EXPECT_FALSE(question.IsActive());
    glow.intensity.Override(1.0f);
    EXPECT_TRUE(question.IsActive());
    EXPECT_FALSE(question.IsTileCompatible());
}

TEST(VolumeComponentRegistry, CreatesByNameAndByType)
{
    const test::TestRegistry registry;
    const std::unique_ptr<VolumeComponent> byName = registry.Create("Mixed");
    const std::unique_ptr<VolumeComponent> byType = registry.Create(typeid(Mixed));
    EXPECT_NE(dynamic_cast<Mixed*>(byName.get()), nullptr);
    EXPECT_NE(dynamic_cast<Mixed*>(byType.get()), nullptr);
    EXPECT_NE(byName, byType);
}

TEST(VolumeComponentRegistry, ListsNamesInTheOrderOfRegistration)
{
    const test::TestRegistry registry;
    EXPECT_EQ(registry.names(),
              (std::vector<std::string_view>{"ScreenSpaceOutline", "Mixed", "TestVolume"}));
}

TEST(VolumeComponentRegistry, RefusesASecondHomeForANameOrAType)
{
    VolumeComponentRegistry registry;
    registry.Register<Mixed>("Mixed");
    EXPECT_THAT(ThrownMessage<ContractError>([&] { registry.Register<test::TestVolume>("Mixed"); }),
                Mentions("'Mixed'", "already"));
    EXPECT_THAT(ThrownMessage<ContractError>([&] { registry.Register<Mixed>("Other"); }),
                Mentions("type", "'Other'", "already", "'Mixed'"));
    EXPECT_THAT(ThrownMessage<ContractError>([&] { registry.Register<ScreenSpaceOutline>(""); }),
                Mentions("needs a name", "registered"));
}

TEST(VolumeComponentRegistry, RefusesToCreateWhatItDoesNotKnow)
{
    VolumeComponentRegistry registry;
    registry.Register<Mixed>("Mixed");
    EXPECT_THAT(ThrownMessage<ContractError>([&] { registry.Create("Mixd"); }),
                Mentions("unknown", "'Mixd'", "'Mixed'"));
    EXPECT_THROW(registry.Create(typeid(ScreenSpaceOutline)), ContractError);
    EXPECT_EQ(registry.Find("Mixd"), nullptr);
}

} // namespace

} // namespace limn
