#pragma once

#include "Mentions.h"
#include "features/color_edges/FlatPicture.h"

#include <algorithm>
#include <functional>
#include <gtest/gtest.h>
#include <limn/core/RecordingDevice.h>

namespace limn::test
{

/// Frames of a technique that nobody draws, and what is said about them.
/// @tparam Content  has `scene` and `camera`
template <typename Feature, typename Settings, typename Component, typename Content>
class TechniqueFrame : public testing::Test
{
protected:
    using Set = std::function<void(Component&)>;

    /// A frame in which the technique has nothing to draw.
    struct NothingDrawn
    {
        std::vector<std::string> why; ///< what the note mentions, in this order
        Set set;
        std::function<void(Content&)> change = nullptr; ///< of the scene
    };

    explicit TechniqueFrame(std::string name) : m_Name(std::move(name)) {}

    /// @param set  the component's values; none: no volume has it
    RenderResult Render(const Set& set)
    {
        UniversalRenderPipeline pipeline(m_Device);
        UniversalRenderer renderer(Compiler());
        auto feature = std::make_unique<Feature>(m_Settings);
        feature->name = m_Name;
        renderer.AddFeature(std::move(feature));
        RenderRequest request;
        request.scene = &m_Content.scene;
        request.camera = &m_Content.camera;
        request.width = m_Size.x;
        request.height = m_Size.y;
        request.volumeStack = set ? &m_Volumes.With(set) : nullptr;
        request.compile.leavesOut = m_LeavesOut;
        return pipeline.RenderSingleCamera(renderer, request);
    }

    /// The first note of a frame, in which the technique has a pass only if there is none.
    std::string NoteOf(const Set& set)
    {
        const RenderResult result = Render(set);
        const std::vector<std::string>& notes = result.report.notes;
        EXPECT_EQ(std::ranges::count(PassesOf(result), m_Name), notes.empty() ? 1 : 0);
        return notes.empty() ? "" : notes.front();
    }

    static std::vector<std::string> PassesOf(const RenderResult& result)
    {
        std::vector<std::string> names;
        for (const ExecutedPassReport& pass : result.report.passes)
        {
            names.push_back(pass.name.name());
        }
        return names;
    }

    void ExpectNothingDrawn(const std::vector<NothingDrawn>& cases)
    {
        for (const NothingDrawn& c : cases)
        {
            m_Content = Content();
            if (c.change)
            {
                c.change(m_Content);
            }
            const RenderResult result = Render(c.set);
            EXPECT_THAT(TargetsOf(result),
                        testing::ElementsAre("_CameraColorAttachmentA", "limn_Output"))
                << testing::PrintToString(c.why);
            EXPECT_THAT(result.report.notes,
                        testing::ElementsAre(
                            testing::AllOf(Mentions(m_Name, "not drawn"), MentionsInOrder(c.why))));
        }
    }
    static void MoveObjectsAway(Content& content)
    {
        for (const auto& object : content.scene.objects())
        {
            object->transform.localPosition.x += 1000.0f;
        }
    }

    /// The first colour of each pass that the device runs.
    static std::vector<std::string> TargetsOf(const RenderResult& result)
    {
        std::vector<std::string> names;
        for (const CompiledRenderPass& pass : result.frame->passes)
        {
            names.push_back(pass.colors.front().texture->name());
        }
        return names;
    }

    std::string m_Name;
    glm::ivec2 m_Size{64, 48};
    bool m_LeavesOut = true;
    Settings m_Settings;
    Content m_Content;
    RecordingDevice m_Device;
    BlendedComponent<Component> m_Volumes;
};

} // namespace limn::test
