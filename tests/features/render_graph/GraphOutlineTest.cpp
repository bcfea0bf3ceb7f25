#include "features/render_graph/GraphOutline.h"
#include "features/render_graph/CompiledText.h"

#include <gmock/gmock.h>
#include <limn/core/RecordingDevice.h>

namespace limn::test
{

TEST(GraphOutline, IsCompiledToTheSamePassesAsTheOldStyle)
{
    RecordingDevice oldDevice;
    RecordingDevice newDevice;
    OutlineOfStyle oldStyle(oldDevice, false);
    OutlineOfStyle newStyle(newDevice, true);
    for (int frame = 0; frame < 4; ++frame)
    {
        const RenderResult expected = oldStyle.Render();
        const RenderResult actual = newStyle.Render();
        EXPECT_THAT(PassesOf(actual), testing::ElementsAreArray(PassesOf(expected)))
            << "frame " << frame;
        EXPECT_EQ(PassesOf(actual).size(), 4u);
        EXPECT_EQ(TextureCount(actual), TextureCount(expected));
        EXPECT_THAT(actual.report.notes, testing::IsEmpty());
    }
}

TEST(GraphOutline, CostsNoPassAndNoTextureWhereNothingIsSelected)
{
    RecordingDevice device;
    OutlineOfStyle style(device, true);
    for (const auto& object : style.content.scene.objects())
    {
        object->renderer->renderingLayerMask = RenderingLayerMask::FromIndex(0);
    }
    for (int frame = 0; frame < 3; ++frame)
    {
        EXPECT_EQ(style.Render().frame->passes.size(), 1u) << "frame " << frame;
    }
}

} // namespace limn::test
