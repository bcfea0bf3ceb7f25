#include "Mentions.h"
#include "TestComponents.h"

#include <core/ThrownMessage.h>
#include <gtest/gtest.h>
#include <limn/volume/VolumeProfile.h>

namespace limn
{

namespace
{

using test::Mentions;
using test::Mixed;
using test::ScreenSpaceOutline;

class ThickOutline : public ScreenSpaceOutline
{
};

TEST(VolumeProfile, AddsComponentsWithAllOverridesOffUnlessAsked)
{
    VolumeProfile profile;
    EXPECT_FALSE(profile.Add<Mixed>().number.overrideState());
    EXPECT_TRUE(profile.Add<ScreenSpaceOutline>(true).m_OutlineWidth.overrideState());
    ASSERT_EQ(profile.components().size(), 2u);
    EXPECT_EQ(profile.components()[0].get(), profile.TryGet<Mixed>());
}

TEST(VolumeProfile, RefusesASecondComponentOfOneType)
{
    VolumeProfile profile;
    profile.name = "hero";
    profile.Add<Mixed>();
    EXPECT_THAT(test::ThrownMessage<ContractError>([&] { profile.Add<Mixed>(); }),
                Mentions("'hero'", "test::Mixed", "already"));
    EXPECT_EQ(test::ThrownMessage<ContractError>([&] { profile.Add(nullptr); }),
              "VolumeProfile::Add got no component");
}

TEST(VolumeProfile, TellsADerivedComponentFromItsBase)
{
    VolumeProfile profile;
    profile.Add<ThickOutline>();
    EXPECT_FALSE(profile.Has<ScreenSpaceOutline>());
    EXPECT_EQ(profile.TryGet<ScreenSpaceOutline>(), nullptr);
    EXPECT_TRUE(profile.Has<ThickOutline>());
    profile.Add<ScreenSpaceOutline>();
    EXPECT_TRUE(profile.Has<ScreenSpaceOutline>());
}

TEST(VolumeProfile, FindsInactiveComponents)
{
    VolumeProfile profile;
    profile.Add<Mixed>().active = false;
    const VolumeProfile& constProfile = profile;
    ASSERT_NE(constProfile.TryGet<Mixed>(), nullptr);
    EXPECT_FALSE(constProfile.TryGet<Mixed>()->active);
}

TEST(VolumeProfile, RemovesExactlyTheTypeAndNothingIfItIsAbsent)
{
    VolumeProfile profile;
    profile.Add<ThickOutline>();
    profile.Add<Mixed>();
    profile.Remove<ScreenSpaceOutline>();
    EXPECT_EQ(profile.components().size(), 2u);
    profile.Remove<ThickOutline>();
    EXPECT_FALSE(profile.Has<ThickOutline>());
    EXPECT_TRUE(profile.Has<Mixed>());
}

} // namespace

} // namespace limn
