#include "Mentions.h"
#include "TestComponents.h"

#include <core/ThrownMessage.h>
#include <fstream>
#include <gmock/gmock.h>
#include <limn/volume/AssetParameters.h>
#include <limn/volume/CurveParameters.h>
#include <limn/volume/UnityAsset.h>
#include <limn/volume/ValueParameters.h>
#include <limn/volume/VolumeProfileLoader.h>

namespace limn::test
{

namespace
{

enum class Mode
{
    Off = 0,
    Wide = 7
};

/// Parameters whose text is not a plain number.
class Rich : public VolumeComponent
{
public:
    Vector3Parameter offset{this, "m_Offset", glm::vec3(0.0f)};
    EnumParameter<Mode> mode{this, "m_Mode", Mode::Off, {{"Off", Mode::Off}, {"Wide", Mode::Wide}}};
    LayerMaskParameter layers{this, "m_Layers", LayerMask(1)};
    AnimationCurveParameter curve{this, "m_Curve", AnimationCurve()};
};

struct RichRegistry : TestRegistry
{
    RichRegistry() { Register<Rich>("Rich"); }
};

const RichRegistry k_RichRegistry;

VolumeProfile Sample()
{
    VolumeProfile profile;
    profile.name = "Sample: \"one\"";
    auto& outline = profile.Add<ScreenSpaceOutline>();
    outline.m_OutlineWidth.Override(4.1f);
    outline.m_OutlineColor.Override({0.1f, 1e-7f, 0.0f, 0.5f});
    auto& mixed = profile.Add<Mixed>();
    mixed.active = false;
    mixed.number.SetValue(2.5f); // a value that is not overridden
    auto& rich = profile.Add<Rich>(true);
    rich.offset.SetValue(glm::vec3(1.0f, -2.0f, 0.3f));
    rich.mode.SetValue(Mode::Wide);
    rich.layers.SetValue(LayerMask(0x80000040u));
    rich.curve.SetValue(AnimationCurve({{0.0f, 1.0f, 0.5f, -0.5f}, {2.0f, 3.0f, 0.0f, 1.0f}}));
    return profile;
}

/// Everything a form holds, told from the parameters rather than from the writer's text.
std::vector<std::string> StateOf(const VolumeProfile& profile, bool onlyOverrides)
{
    std::vector<std::string> state;
    for (const auto& component : profile.components())
    {
        const VolumeComponent& which = *component;
        const std::string name = k_RichRegistry.Find(typeid(which))->name;
        state.push_back(name + (component->active ? " on" : " off"));
        for (const VolumeParameter* p : std::as_const(*component).parameters())
        {
            if (p->overrideState() || !onlyOverrides)
            {
                state.push_back(p->name() + (p->overrideState() ? "!" : "?") + p->ValueText());
            }
        }
    }
    return state;
}

VolumeProfile ReadBack(const std::string& text)
{
    return std::move(*ParseVolumeProfile(text, "x.profile.yaml", k_RichRegistry).profile);
}

TEST(WriteVolumeProfile, InLimnsFormHoldsTheOverridesAndNothingElse)
{
    VolumeProfile profile;
    auto& outline = profile.Add<ScreenSpaceOutline>();
    outline.m_Enable.Override(true);
    outline.m_OutlineWidth.Override(4.5f);
    profile.Add<TestVolume>();
    profile.Add<Mixed>().active = false;
    EXPECT_EQ("ScreenSpaceOutline:\n"
              "  m_Enable: true\n"
              "  m_OutlineWidth: 4.5\n"
              "TestVolume: {}\n"
              "Mixed:\n"
              "  active: false\n",
              WriteVolumeProfile(profile, k_RichRegistry, YamlForm::Limn));
}

TEST(WriteVolumeProfile, InUnitysFormHoldsEveryParameterWithItsState)
{
    VolumeProfile profile;
    profile.name = "P";
    profile.Add<ScreenSpaceOutline>().m_Enable.Override(true);
    const std::string text = WriteVolumeProfile(profile, k_RichRegistry, YamlForm::Unity);
    EXPECT_THAT(text,
                testing::StartsWith("%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n--- !u!114 &"));
    EXPECT_THAT(text, testing::HasSubstr("  m_Name: ScreenSpaceOutline\n"
                                         "  m_EditorClassIdentifier: \n"
                                         "  active: 1\n"
                                         "  m_Enable:\n"
                                         "    m_OverrideState: 1\n"
                                         "    m_Value: 1\n"
                                         "  m_OutlineColor:\n"
                                         "    m_OverrideState: 0\n"
                                         "    m_Value: {r: 1, g: 1, b: 1, a: 1}\n"
                                         "  m_OutlineWidth:\n"
                                         "    m_OverrideState: 0\n"
                                         "    m_Value: 3\n"
                                         "--- !u!114 &11400000\n"));
}

TEST(WriteVolumeProfile, ReadsBackTheSameInBothForms)
{
    const VolumeProfile sample = Sample();
    const VolumeProfile limns =
        ReadBack(WriteVolumeProfile(sample, k_RichRegistry, YamlForm::Limn));
    EXPECT_EQ(StateOf(sample, true), StateOf(limns, true));
    const VolumeProfile unitys =
        ReadBack(WriteVolumeProfile(sample, k_RichRegistry, YamlForm::Unity));
    EXPECT_EQ(StateOf(sample, false), StateOf(unitys, false));
    EXPECT_EQ("Sample: \"one\"", unitys.name);
}

TEST(WriteVolumeProfile, OfWhatWasReadGivesTheSameTextAgain)
{
    for (const YamlForm form : {YamlForm::Limn, YamlForm::Unity})
    {
        const std::string text = WriteVolumeProfile(Sample(), k_RichRegistry, form);
        EXPECT_EQ(text, WriteVolumeProfile(ReadBack(text), k_RichRegistry, form));
    }
}

TEST(WriteVolumeProfile, OfAnEmptyProfileCanBeRead)
{
    for (const YamlForm form : {YamlForm::Limn, YamlForm::Unity})
    {
        const std::string text = WriteVolumeProfile(VolumeProfile(), k_RichRegistry, form);
        EXPECT_EQ(0u, ReadBack(text).components().size()) << text;
    }
}

TEST(WriteVolumeProfile, GivesAComponentTheSameFileIDWhateverElseIsThere)
{
    const auto fileID = [](const VolumeProfile& profile)
    {
        const std::string text = WriteVolumeProfile(profile, k_RichRegistry, YamlForm::Unity);
        const UnityAsset asset(text, "x.asset");
        return asset.FindWithField("m_OutlineWidth")->fileID;
    };
    VolumeProfile alone;
    alone.Add<ScreenSpaceOutline>();
    EXPECT_EQ(fileID(alone), fileID(Sample()));
}

TEST(WriteVolumeProfile, RefusesAComponentThatIsNotRegistered)
{
    VolumeProfile profile;
    profile.Add<Rich>();
    const TestRegistry registry;
    EXPECT_THAT(ThrownMessage<ContractError>(
                    [&] { WriteVolumeProfile(profile, registry, YamlForm::Limn); }),
                Mentions("profile", "not registered", "written"));
}

} // namespace

} // namespace limn::test
