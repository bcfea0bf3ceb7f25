#include "features/render_graph/GraphOutline.h"
#include "vulkan/GpuTestDevice.h"

#include <set>

namespace limn::test
{
namespace
{

class GraphOutlineGpu : public GpuTest
{
protected:
    static std::vector<std::byte> Picture(OutlineOfStyle& style, float width)
    {
        const RenderResult result = style.Render(width);
        return SharedDevice().ReadBack(*result.output.rt()).texels;
    }
};

} // namespace

TEST_F(GraphOutlineGpu, DrawsThePictureOfTheOldStyleBitForBit)
{
    OutlineOfStyle oldStyle(SharedDevice(), false);
    OutlineOfStyle newStyle(SharedDevice(), true);
    std::set<std::vector<std::byte>> pictures;
    for (const float width : {1.0f, 4.0f, 9.0f})
    {
        const std::vector<std::byte> expected = Picture(oldStyle, width);
        EXPECT_EQ(Picture(newStyle, width), expected) << width;
        pictures.insert(expected);
    }
    EXPECT_EQ(pictures.size(), 3u) << "the outline is seen, and its width";
}

} // namespace limn::test
