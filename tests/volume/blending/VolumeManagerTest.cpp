#include "blending/VolumeScene.h"

#include <core/ThrownMessage.h>
#include <gtest/gtest.h>
#include <limn/core/Camera.h>

namespace limn
{

namespace
{

using test::GlobalVolume;
using test::Mixed;
using test::ParamProfile;
using test::TestVolume;
using test::VolumeScene;

/// URP's own fixture runs every case twice: with global volumes, and with local ones whose box the
/// trigger stands in.
class VolumeManagerOfBothKinds : public ::testing::TestWithParam<bool>
{
protected:
    Volume MakeVolume(float value, float priority = 0.0f) const
    {
        Volume volume = GlobalVolume(ParamProfile(value), priority);
        volume.isGlobal = GetParam();
        volume.colliders.push_back(BoxCollider{});
        return volume;
    }

    VolumeScene m_Scene;
};

INSTANTIATE_TEST_SUITE_P(GlobalAndLocal, VolumeManagerOfBothKinds, ::testing::Bool(),
                         [](const auto& parameter)
                         { return std::string(parameter.param ? "Global" : "Local"); });

TEST_P(VolumeManagerOfBothKinds, ShowsDefaultsBeforeAnyVolume)
{
    EXPECT_TRUE(m_Scene.stack.requiresReset());
    EXPECT_EQ(m_Scene.Param(), 123.0f);
    m_Scene.Update();
    EXPECT_FALSE(m_Scene.stack.requiresReset());
    EXPECT_EQ(m_Scene.Param(), 123.0f);
}

TEST_P(VolumeManagerOfBothKinds, FollowsAVolumeThatIsRegisteredAndUnregistered)
{
    const Volume volume = MakeVolume(456.0f);
    m_Scene.manager.Register(&volume);
    m_Scene.Update();
    EXPECT_TRUE(m_Scene.stack.requiresReset());
    EXPECT_EQ(m_Scene.Param(), 456.0f);

    m_Scene.manager.Unregister(&volume);
    m_Scene.Update();
    EXPECT_FALSE(m_Scene.stack.requiresReset());
    EXPECT_EQ(m_Scene.Param(), 123.0f);

    m_Scene.manager.Register(&volume);
    m_Scene.Update();
    EXPECT_TRUE(m_Scene.stack.requiresReset());
    EXPECT_EQ(m_Scene.Param(), 456.0f);
}

TEST_P(VolumeManagerOfBothKinds, FollowsAVolumeThatIsEnabledAndDisabled)
{
    Volume volume = MakeVolume(456.0f);
    m_Scene.manager.Register(&volume);
    for (const bool enabled : {true, false, true})
    {
        volume.enabled = enabled;
        m_Scene.Update();
        EXPECT_EQ(m_Scene.Param(), enabled ? 456.0f : 123.0f);
    }
}

TEST_P(VolumeManagerOfBothKinds, FollowsTheOverrideStatesOfTheProfile)
{
    const auto profile = ParamProfile(456.0f);
    Volume volume = MakeVolume(0.0f);
    volume.sharedProfile = profile;
    m_Scene.manager.Register(&volume);
    for (const bool overrides : {true, false, true})
    {
        profile->TryGet<TestVolume>()->SetAllOverridesTo(overrides);
        m_Scene.Update();
        EXPECT_EQ(m_Scene.Param(), overrides ? 456.0f : 123.0f);
        EXPECT_EQ(m_Scene.Get<TestVolume>().param.overrideState(), overrides);
    }
}

TEST_P(VolumeManagerOfBothKinds, LetsTheHigherPriorityWinAndNoticesItsChange)
{
    Volume first = MakeVolume(456.0f, 0.0f);
    const Volume second = MakeVolume(999.0f, 1.0f);
    m_Scene.manager.Register(&first);
    m_Scene.Update();
    EXPECT_EQ(m_Scene.Param(), 456.0f);

    m_Scene.manager.Register(&second);
    m_Scene.Update();
    EXPECT_EQ(m_Scene.Param(), 999.0f);

    first.priority = 2.0f;
    m_Scene.Update();
    EXPECT_EQ(m_Scene.Param(), 456.0f);
}

TEST(VolumeManager, SkipsVolumesWithoutWeightProfileOrActiveComponent)
{
    VolumeScene scene;
    Volume weightless = GlobalVolume(ParamProfile(1.0f));
    weightless.weight = 0.0f;
    Volume negative = GlobalVolume(ParamProfile(2.0f));
    negative.weight = -1.0f;
    const Volume empty = GlobalVolume(nullptr);
    const auto profile = ParamProfile(3.0f);
    profile->TryGet<TestVolume>()->active = false;
    const Volume inactive = GlobalVolume(profile);
    for (const Volume* volume :
         std::initializer_list<const Volume*>{&weightless, &negative, &empty, &inactive})
    {
        scene.manager.Register(volume);
    }
    scene.Update();
    EXPECT_EQ(scene.Param(), 123.0f);
    EXPECT_FALSE(scene.Get<TestVolume>().param.overrideState());
}

TEST(VolumeManager, ClampsWeightToOne)
{
    VolumeScene scene;
    Volume volume = GlobalVolume(ParamProfile(223.0f));
    scene.manager.Register(&volume);
    volume.weight = 7.0f;
    scene.Update();
    EXPECT_EQ(scene.Param(), 223.0f);
    volume.weight = 0.25f;
    scene.Update();
    EXPECT_EQ(scene.Param(), 148.0f); // 123 + 0.25 * 100
}

TEST(VolumeManager, BlendsOneVolumeAfterTheOther)
{
    VolumeScene scene;
    Volume low = GlobalVolume(ParamProfile(23.0f), -1.0f);
    Volume high = GlobalVolume(ParamProfile(173.0f), 5.0f);
    low.weight = 0.5f;
    high.weight = 0.5f;
    scene.manager.Register(&high);
    scene.manager.Register(&low);
    scene.Update();
    EXPECT_EQ(scene.Param(), 123.0f); // 123 -> 73 -> 123
}

TEST(VolumeManager, AppliesEqualPrioritiesInTheOrderOfRegistration)
{
    VolumeScene scene;
    const Volume first = GlobalVolume(ParamProfile(1.0f), 3.0f);
    const Volume second = GlobalVolume(ParamProfile(2.0f), 3.0f);
    scene.manager.Register(&second);
    scene.manager.Register(&first);
    scene.Update();
    EXPECT_EQ(scene.Param(), 1.0f);
}

TEST(VolumeManager, KeepsThePlaceOfAVolumeWhosePriorityComesBack)
{
    VolumeScene scene;
    Volume first = GlobalVolume(ParamProfile(1.0f));
    const Volume second = GlobalVolume(ParamProfile(2.0f));
    scene.manager.Register(&first);
    scene.manager.Register(&second);
    scene.Update();
    EXPECT_EQ(scene.Param(), 2.0f);
    first.priority = 1.0f;
    scene.Update();
    EXPECT_EQ(scene.Param(), 1.0f);
    // Unity sorts the list it has in place: equal again, `first` stays behind `second`.
    first.priority = 0.0f;
    scene.Update();
    EXPECT_EQ(scene.Param(), 1.0f);
}

TEST(VolumeManager, SortsTheVolumesOfEachMaskByThemselves)
{
    VolumeScene scene;
    Volume first = GlobalVolume(ParamProfile(1.0f), 2.0f);
    const Volume second = GlobalVolume(ParamProfile(2.0f), 1.0f);
    scene.manager.Register(&first);
    scene.manager.Register(&second);
    const LayerMask one = LayerMask::FromIndex(first.layer);
    const auto last = [&](LayerMask mask)
    {
        return scene.manager.GetVolumes(mask).back();
    };
    EXPECT_EQ(last(one), &first);
    first.priority = 1.0f;
    EXPECT_EQ(last(LayerMask::Everything()), &second) << "in the order of registration";
    EXPECT_EQ(last(one), &first) << "which keeps its place";
}

TEST(VolumeManager, LetsAParameterAloneThatNoVolumeOverrides)
{
    VolumeScene scene;
    auto profile = std::make_shared<VolumeProfile>();
    profile->Add<Mixed>().whole.Override(5);
    const Volume volume = GlobalVolume(profile);
    scene.manager.Register(&volume);
    scene.Update();
    EXPECT_EQ(scene.Get<Mixed>().whole.value(), 5);
    EXPECT_EQ(scene.Get<Mixed>().number.value(), 0.0f);
    EXPECT_FALSE(scene.Get<Mixed>().number.overrideState());
    EXPECT_EQ(scene.Param(), 123.0f);
}

TEST(VolumeManager, BringsTheDefaultsBackThatAConstructorSets)
{
    struct Preset : VolumeComponent
    {
        Preset() { number.Override(7.0f); }
        FloatParameter number{this, "number", 1.0f};
    };
    VolumeComponentRegistry registry;
    registry.Register<Preset>("Preset");
    VolumeManager manager(registry);
    VolumeStack stack = manager.CreateStack();
    manager.Update(stack, std::nullopt, test::k_DefaultLayer);
    EXPECT_EQ(stack.GetComponent<Preset>()->number.value(), 7.0f);
    EXPECT_FALSE(stack.GetComponent<Preset>()->number.overrideState());
}

TEST(VolumeManager, SeesOnlyTheLayersOfTheMask)
{
    VolumeScene scene;
    Volume volume = GlobalVolume(ParamProfile(456.0f));
    volume.layer = 6;
    scene.manager.Register(&volume);
    scene.Update();
    EXPECT_EQ(scene.Param(), 123.0f);
    EXPECT_TRUE(scene.stack.requiresReset()); // a volume exists, though not for this mask
    scene.Update(std::nullopt, LayerMask::FromIndex(6));
    EXPECT_EQ(scene.Param(), 456.0f);
    scene.Update(std::nullopt, LayerMask::Nothing());
    EXPECT_EQ(scene.Param(), 123.0f);
    scene.Update(std::nullopt, LayerMask::Everything());
    EXPECT_EQ(scene.Param(), 456.0f);
}

TEST(VolumeManager, NeverSeesTheVolumesOfAnother)
{
    VolumeScene one;
    VolumeScene other;
    const Volume first = GlobalVolume(ParamProfile(1.0f));
    const Volume second = GlobalVolume(ParamProfile(2.0f));
    one.manager.Register(&first);
    other.manager.Register(&second);
    one.Update();
    other.Update();
    EXPECT_EQ(one.Param(), 1.0f);
    EXPECT_EQ(other.Param(), 2.0f);
}

TEST(VolumeManager, KeepsTwoStacksApart)
{
    VolumeScene scene;
    VolumeStack second = scene.manager.CreateStack();
    const Volume volume = GlobalVolume(ParamProfile(456.0f));
    scene.manager.Register(&volume);
    scene.Update();
    EXPECT_EQ(second.GetComponent<TestVolume>()->param.value(), 123.0f);
    scene.manager.Unregister(&volume);
    scene.manager.Update(second, std::nullopt, test::k_DefaultLayer);
    EXPECT_EQ(scene.Param(), 456.0f); // not updated since
}

TEST(VolumeManager, IgnoresAComponentThatTheStackDoesNotHave)
{
    struct Late : VolumeComponent
    {
        FloatParameter number{this, "number", 1.0f};
    };
    VolumeScene scene;
    scene.registry.Register<Late>("Late");
    const auto profile = ParamProfile(456.0f);
    profile->Add<Late>(true);
    const Volume volume = GlobalVolume(profile);
    scene.manager.Register(&volume);
    scene.Update();
    EXPECT_EQ(scene.Param(), 456.0f);
    EXPECT_EQ(scene.stack.GetComponent<Late>(), nullptr);
}

TEST(VolumeManager, RefusesNoVolumeAndALayerThatDoesNotExist)
{
    VolumeScene scene;
    EXPECT_EQ(test::ThrownMessage<ContractError>([&] { scene.manager.Register(nullptr); }),
              "VolumeManager::Register got no volume");
    Volume volume;
    volume.layer = 32;
    EXPECT_EQ(test::ThrownMessage<ContractError>([&] { scene.manager.Register(&volume); }),
              "layer index 32 is outside 0...31");
    volume.layer = 0;
    EXPECT_TRUE(scene.manager.Register(&volume));
    volume.layer = -1;
    EXPECT_EQ(test::ThrownMessage<ContractError>([&] { scene.Update(); }),
              "layer index -1 is outside 0...31");
}

TEST(VolumeManager, TellsWhetherAComponentIsActiveInAMaskItKnows)
{
    VolumeScene scene;
    const auto profile = ParamProfile(456.0f);
    Volume volume = GlobalVolume(profile);
    volume.weight = 0.0f;
    volume.layer = 3;
    scene.manager.Register(&volume);
    const LayerMask mask = LayerMask::FromIndex(3);
    const auto isActive = [&]
    {
        return scene.manager.IsComponentActiveInMask<test::TestVolume>(mask);
    };
    EXPECT_FALSE(isActive()); // no list for this mask was asked for yet
    scene.Update(std::nullopt, LayerMask::Everything());
    EXPECT_FALSE(isActive());
    scene.Update(std::nullopt, mask);
    EXPECT_TRUE(isActive());
    EXPECT_FALSE(scene.manager.IsComponentActiveInMask<test::Mixed>(mask));
    profile->TryGet<test::TestVolume>()->active = false;
    EXPECT_FALSE(isActive());
    profile->TryGet<test::TestVolume>()->active = true;
    volume.enabled = false;
    EXPECT_FALSE(isActive());
}

TEST(VolumeManager, GivesEveryCameraTheVolumesOfItsMaskAndItsTrigger)
{
    VolumeScene scene;
    Volume usual = GlobalVolume(ParamProfile(1.0f));
    Volume other = GlobalVolume(ParamProfile(2.0f), 1.0f);
    other.layer = 7;
    Volume local = GlobalVolume(ParamProfile(3.0f), 2.0f);
    local.isGlobal = false;
    local.position = glm::vec3(100.0f, 0.0f, 0.0f);
    local.colliders = {BoxCollider{}};
    for (const Volume* volume : {&usual, &other, &local})
    {
        scene.manager.Register(volume);
    }
    Camera camera; // by default the layer "Default" alone, seen from where it is
    const auto param = [&]
    {
        scene.Update(camera.volumeTrigger.value_or(camera.transform.position()),
                     camera.volumeLayerMask);
        return scene.Param();
    };
    EXPECT_EQ(LayerMask(1), camera.volumeLayerMask);
    EXPECT_EQ(1.0f, param());
    camera.volumeLayerMask = LayerMask(1 | 128);
    EXPECT_EQ(2.0f, param());
    camera.volumeTrigger = local.position;
    EXPECT_EQ(3.0f, param());
    camera.volumeLayerMask = LayerMask(128);
    EXPECT_EQ(2.0f, param());
    camera.volumeLayerMask = LayerMask(4);
    EXPECT_EQ(123.0f, param());
}

} // namespace

} // namespace limn
