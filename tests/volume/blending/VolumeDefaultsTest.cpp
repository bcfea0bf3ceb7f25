#include "blending/VolumeScene.h"

#include <gtest/gtest.h>
#include <limn/core/RenderingData.h>

namespace limn
{

namespace
{

using test::ParamProfile;
using test::TestVolume;
using test::VolumeScene;

TEST(VolumeManager, AppliesGlobalQualityAndCustomDefaultProfilesInThisOrder)
{
    VolumeScene scene;
    const auto paramNow = [&scene]
    {
        scene.Update();
        return scene.Param();
    };
    scene.manager.SetGlobalDefaultProfile(ParamProfile(456.0f));
    EXPECT_TRUE(scene.stack.requiresReset());
    EXPECT_EQ(456.0f, paramNow());
    EXPECT_FALSE(scene.stack.requiresReset());
    scene.manager.SetQualityDefaultProfile(ParamProfile(789.0f));
    EXPECT_EQ(789.0f, paramNow());
    scene.manager.SetCustomDefaultProfiles({nullptr, ParamProfile(999.0f)});
    EXPECT_EQ(999.0f, paramNow());
    scene.manager.SetGlobalDefaultProfile(nullptr);
    EXPECT_EQ(999.0f, paramNow());
    scene.manager.SetQualityDefaultProfile(nullptr);
    EXPECT_EQ(999.0f, paramNow());
    scene.manager.SetCustomDefaultProfiles({});
    EXPECT_EQ(123.0f, paramNow());
}

TEST(VolumeManager, AppliesCustomDefaultProfilesInTheOrderOfTheList)
{
    VolumeScene scene;
    scene.manager.SetCustomDefaultProfiles({ParamProfile(456.0f), ParamProfile(789.0f)});
    EXPECT_EQ(789.0f, scene.manager.CreateStack().GetComponent<TestVolume>()->param.value());
    scene.manager.SetCustomDefaultProfiles({ParamProfile(789.0f), ParamProfile(456.0f)});
    EXPECT_EQ(456.0f, scene.manager.CreateStack().GetComponent<TestVolume>()->param.value());
}

TEST(VolumeManager, ADefaultProfileMarksNothingAsOverridden)
{
    VolumeScene scene;
    scene.manager.SetGlobalDefaultProfile(ParamProfile(456.0f));
    scene.Update();
    EXPECT_FALSE(scene.Get<TestVolume>().param.overrideState());
}

TEST(VolumeManager, FollowsAnEditOfADefaultProfileThatItIsToldOf)
{
    VolumeScene scene;
    const auto profile = ParamProfile(456.0f);
    scene.manager.SetQualityDefaultProfile(profile);
    scene.Update();
    profile->TryGet<TestVolume>()->param.Override(5.0f);
    scene.manager.OnVolumeProfileChanged(*ParamProfile(1.0f));
    scene.Update();
    EXPECT_EQ(456.0f, scene.Param());
    scene.manager.OnVolumeProfileChanged(*profile);
    scene.Update();
    EXPECT_EQ(5.0f, scene.Param());
}

TEST(Volume, ProfileIsAPrivateCopyFromTheFirstCallOn)
{
    VolumeScene scene;
    const auto shared = ParamProfile(456.0f);
    Volume volume = test::GlobalVolume(shared);
    scene.manager.Register(&volume);
    EXPECT_FALSE(volume.HasInstantiatedProfile());
    volume.profile(scene.registry).TryGet<TestVolume>()->param.SetValue(5.0f);
    EXPECT_TRUE(volume.HasInstantiatedProfile());
    EXPECT_EQ(456.0f, shared->TryGet<TestVolume>()->param.value());
    scene.Update();
    EXPECT_EQ(5.0f, scene.Param());
    volume.SetProfile(nullptr);
    scene.Update();
    EXPECT_EQ(456.0f, scene.Param());
}

TEST(Volume, ProfileIsEmptyWithoutASharedOne)
{
    const test::TestRegistry registry;
    Volume volume;
    EXPECT_TRUE(volume.profile(registry).components().empty());
    EXPECT_EQ(&volume.profile(registry), volume.profileRef());
}

class DerivedVolume : public TestVolume
{
};

TEST(VolumeProfile, FindsDerivedComponentsWhereAsked)
{
    VolumeProfile profile;
    const DerivedVolume& derived = profile.Add<DerivedVolume>();
    EXPECT_FALSE(profile.Has<TestVolume>());
    EXPECT_TRUE(profile.HasSubclassOf<TestVolume>());
    EXPECT_FALSE(profile.HasSubclassOf<test::Mixed>());
    const TestVolume& base = profile.Add<TestVolume>();
    EXPECT_EQ(&derived, profile.TryGetSubclassOf<TestVolume>());
    EXPECT_EQ((std::vector<const TestVolume*>{&derived, &base}),
              profile.TryGetAllSubclassOf<TestVolume>());
    EXPECT_EQ(nullptr, profile.TryGetSubclassOf<test::Mixed>());
}

TEST(VolumeStack, OfDefaultsHasEveryComponentAsItIsMade)
{
    struct Unregistered : VolumeComponent
    {
        FloatParameter number{this, "number", 1.5f};
    };
    const auto* component = VolumeStack::Defaults().GetComponent<Unregistered>();
    ASSERT_NE(component, nullptr);
    EXPECT_EQ(component->number.value(), 1.5f);
    EXPECT_FALSE(component->number.overrideState());
    EXPECT_EQ(VolumeStack::Defaults().GetComponent<Unregistered>(), component);
}

TEST(VolumeStack, IsOneOfDefaultsWhereACameraWasGivenNone)
{
    RenderingData data;
    EXPECT_EQ(&*data.volumeStack, &VolumeStack::Defaults());
    EXPECT_EQ(data.volumeStack->GetComponent<TestVolume>()->param.value(),
              TestVolume().param.value());
    VolumeScene scene;
    data.volumeStack = &scene.stack;
    EXPECT_EQ(data.volumeStack->GetComponent<TestVolume>(), scene.stack.GetComponent<TestVolume>());
}

} // namespace

} // namespace limn
