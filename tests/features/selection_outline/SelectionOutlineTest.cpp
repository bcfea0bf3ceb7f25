#include "Mentions.h"
#include "core/scene/TestScene.h"

#include <gmock/gmock.h>
#include <limn/core/BuiltinShaders.h>
#include <limn/core/RecordingDevice.h>
#include <limn/core/UniversalRenderPipeline.h>
#include <limn/features/FeatureRegistry.h>
#include <limn/features/Features.h>
#include <limn/features/SelectionOutlineRendererFeature.h>
#include <limn/volume/VolumeManager.h>

namespace limn
{
namespace
{

using testing::ElementsAre;
using testing::IsEmpty;

/// Cubes before a camera, some of them selected, without a device.
class SelectionOutlines : public testing::Test
{
protected:
    SelectionOutlines()
    {
        RegisterVolumeComponents(m_Registry);
        m_Manager = std::make_unique<VolumeManager>(m_Registry);
        m_Stack = std::make_unique<VolumeStack>(m_Manager->CreateStack());
        m_Component = &m_Profile->Add<SelectionOutline>();
        m_Component->m_Enable.Override(true);
        m_Volume.sharedProfile = m_Profile;
        m_Manager->Register(&m_Volume);
        m_Request.scene = &m_Scene;
        m_Request.camera = &m_Camera;
        m_Request.width = 64;
        m_Request.height = 32;
        m_Request.volumeStack = m_Stack.get();
    }

    void AddFeature(OutlineGrouping grouping = OutlineGrouping::Together)
    {
        SelectionOutlineSettings settings;
        settings.m_RenderingLayerMask = 8;
        settings.m_Grouping = grouping;
        m_Feature = static_cast<SelectionOutlineRendererFeature*>(&m_Renderer.AddFeature(
            std::make_unique<SelectionOutlineRendererFeature>(std::move(settings))));
        m_Feature->name = "Selection";
    }
    GameObject& Add(const char* name, float x, bool isSelected)
    {
        GameObject& cube = test::AddCube(m_Scene, name, {x, 0.0f, 5.0f}, {m_Material});
        cube.renderer->renderingLayerMask = RenderingLayerMask(isSelected ? 0x101 : 1);
        return cube;
    }
    const RenderResult& Render()
    {
        m_Manager->Update(*m_Stack, glm::vec3(0.0f), LayerMask::FromIndex(0));
        m_Pipeline.RenderSingleCamera(m_Renderer, m_Request, m_Result);
        return m_Result;
    }
    bool IsDrawn()
    {
        const auto& passes = Render().report.passes;
        return std::ranges::any_of(passes, [](const ExecutedPassReport& pass)
                                   { return pass.name == "Selection"; });
    }

    const std::shared_ptr<const Material> m_Material = std::make_shared<Material>(
        FindBuiltinShader("Universal Render Pipeline/Unlit", test::Compiler()));
    VolumeComponentRegistry m_Registry;
    std::unique_ptr<VolumeManager> m_Manager;
    std::unique_ptr<VolumeStack> m_Stack;
    std::shared_ptr<VolumeProfile> m_Profile = std::make_shared<VolumeProfile>();
    SelectionOutline* m_Component = nullptr;
    Volume m_Volume;
    Scene m_Scene;
    Camera m_Camera;
    RecordingDevice m_Device;
    UniversalRenderPipeline m_Pipeline{m_Device};
    UniversalRenderer m_Renderer{test::Compiler()};
    SelectionOutlineRendererFeature* m_Feature = nullptr;
    RenderRequest m_Request;
    RenderResult m_Result;
};

} // namespace

TEST_F(SelectionOutlines, AreTheArticlesByDefault)
{
    const SelectionOutline component;
    EXPECT_EQ(component.tapOffset(), 2.0f);
    EXPECT_EQ(component.iterate.value(), 3);
    EXPECT_EQ(component.blurCount(), 7);
    EXPECT_EQ(component.outlineStrength.value(), 3.0f);
    EXPECT_TRUE(component.m_VaryingColor.value());
    EXPECT_EQ(component.reach(), 14.0f);
    EXPECT_EQ(SelectionOutlineSettings().m_RenderPassEvent,
              RenderPassEvent::BeforeRenderingPostProcessing);
}

TEST_F(SelectionOutlines, ReachAsFarAsTheWidthUnlessTheOffsetIsGiven)
{
    m_Component->m_OutlineWidth.Override(21.0f);
    EXPECT_EQ(m_Component->tapOffset(), 3.0f);
    m_Component->iterate.Override(1);
    EXPECT_EQ(m_Component->tapOffset(), 7.0f);
    EXPECT_EQ(m_Component->reach(), 21.0f);
    m_Component->offsetScale.Override(1.5f);
    EXPECT_EQ(m_Component->reach(), 4.5f);
}

TEST_F(SelectionOutlines, AreNoPassWhereNothingIsSelectedOrSeen)
{
    AddFeature();
    GameObject& cube = Add("cube", 0.0f, false);
    EXPECT_FALSE(IsDrawn());
    EXPECT_THAT(m_Result.report.notes,
                ElementsAre(test::Mentions("Selection", "not drawn", "0 of 1",
                                           "rendering layer mask leaves out 1")));
    EXPECT_EQ(m_Result.frame->passes.size(), 1u) << "the camera's";
    cube.renderer->renderingLayerMask = RenderingLayerMask(0x101);
    EXPECT_TRUE(IsDrawn());
    EXPECT_THAT(m_Result.report.notes, IsEmpty());
    cube.transform.localPosition.x = 100.0f;
    EXPECT_FALSE(IsDrawn()) << "outside of the picture";
    cube.transform.localPosition.x = 0.0f;
    m_Component->m_OutlineWidth.Override(0.0f);
    EXPECT_FALSE(IsDrawn());
    EXPECT_THAT(m_Result.report.notes,
                ElementsAre(test::Mentions("Selection", "not drawn",
                                           "SelectionOutline.m_OutlineWidth is 0")));
}

TEST_F(SelectionOutlines, MakeFramesOfOneStructureWhileTimePasses)
{
    for (const OutlineGrouping grouping : {OutlineGrouping::Together, OutlineGrouping::PerObject})
    {
        AddFeature(grouping);
        Add("cube", 0.0f, true);
        Add("another", 0.5f, true);
        for (int i = 0; i < 4; ++i)
        {
            Render();
        }
        const std::uint64_t structure = m_Result.frame->structure;
        m_Request.time += 1e6;
        EXPECT_EQ(Render().frame->structure, structure);
    }
}

TEST_F(SelectionOutlines, RefuseATimeThatIsNone)
{
    AddFeature();
    const GameObject& cube = Add("cube", 0.0f, true);
    EXPECT_THROW(m_Feature->SetStartTime(cube, std::nan("")), ContractError);
    EXPECT_NO_THROW(m_Feature->SetStartTime(cube, 1e300));
    EXPECT_TRUE(IsDrawn());
}

TEST_F(SelectionOutlines, TakePhasesOfAWholeTurn)
{
    EXPECT_EQ(OutlineEffect::Phase(0.0), 0.0);
    EXPECT_NEAR(std::sin(OutlineEffect::Phase(1e7)), std::sin(2e7), 1e-8);
    EXPECT_NEAR(std::cos(OutlineEffect::Phase(-1e7)), std::cos(-2e7), 1e-8);
    EXPECT_LT(std::abs(OutlineEffect::Phase(-1e7)), 6.2831854);
}

TEST_F(SelectionOutlines, NeedALayerOfTheSecondCameraThatExists)
{
    SelectionOutlineSettings settings;
    settings.m_RenderingLayerMask = 8;
    settings.m_HighlightingLayer = 32;
    m_Renderer.AddFeature(std::make_unique<SelectionOutlineRendererFeature>(std::move(settings)));
    Add("cube", 0.0f, true);
    EXPECT_THROW(Render(), ContractError);
}

} // namespace limn
