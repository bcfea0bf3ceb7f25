#include "features/wide_outline/WideOutlineScene.h"
#include "vulkan/GpuTestDevice.h"

#include <cmath>
#include <limn/core/PrimitiveMesh.h>

namespace limn::test
{
namespace
{

constexpr int k_Picture = 96;

struct NamedShape
{
    const char* name;
    ScreenTriangles triangles;
};

std::vector<NamedShape> Shapes()
{
    return {{"disc", DiscTriangles({47.3, 48.6}, 20.0)},
            {"ring", RingTriangles({48.2, 47.4}, 9.5, 22.0)},
            {"star", StarTriangles({47.7, 48.3}, 5, 11.0, 25.0, 0.3)},
            {"needle", NeedleTriangles({25.3, 40.1}, {70.2, 57.7}, 0.3)},
            {"pair", Together({DiscTriangles({40.3, 44.6}, 12.0),
                               NeedleTriangles({38.0, 52.0}, {66.0, 49.0}, 9.0)})}};
}

class WideOutlineGpu : public GpuTest
{
};

TEST_F(WideOutlineGpu, Figures)
{
    for (const WideOutlineMethod method :
         {WideOutlineMethod::JumpFlood, WideOutlineMethod::Separable})
    {
        for (const NamedShape& shape : Shapes())
        {
            WideOutlineSettings settings;
            settings.m_Method = method;
            WideOutlineScene scene(SharedDevice(), k_Picture, k_Picture, settings);
            scene.Add(shape.triangles);
            const Silhouette silhouette(shape.triangles);
            for (const double width : {1.0, 2.0, 8.0, 16.0})
            {
                scene.outline->m_OutlineWidth.Override(static_cast<float>(width));
                const Coverage measured = scene.DrawAlpha();
                const Coverage exact =
                    ExactOutlineCoverage(silhouette, {width}, k_Picture, k_Picture);
                const OutlineScore score = ScoreOutline(measured, exact, silhouette.Perimeter());
                const ContourScores ends = ScoreContours(measured, silhouette, {width});
                std::printf("%d %-7s w %4g: MAE %.4f RMS %.4f max %.3f IoU %.3f bias %+.4f outer "
                            "%+.3f (%.2f) inner %+.3f\n",
                            static_cast<int>(method), shape.name, width, score.meanAbsoluteError,
                            score.rootMeanSquare, score.largest, score.intersectionOverUnion,
                            score.widthBias, ends.high.mean, ends.high.largest, ends.low.mean);
            }
        }
    }
    ExpectNoValidationMessages();
}

} // namespace
} // namespace limn::test
