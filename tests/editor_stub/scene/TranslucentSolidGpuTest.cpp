#include "Paths.h"
#include "golden/GoldenImage.h"
#include "precision/DevicePrecision.h"

#include <gtest/gtest.h>
#include <limn/core/UniversalRenderPipeline.h>
#include <limn/editor_stub/SceneFile.h>

using namespace limn;
using namespace limn::test;

namespace
{

class TranslucentSolidSampleGpu : public GpuTest
{
};

TEST_F(TranslucentSolidSampleGpu, LooksAsItDid)
{
    AssetContext assets;
    SceneAsset asset = LoadScene(
        test::SourcePath("samples/translucent_solid/translucent_solid.scene.yaml"), assets);
    UniversalRenderer renderer(assets.compiler());
    for (auto& feature : asset.renderer.features)
    {
        renderer.AddFeature(std::move(feature));
    }
    UniversalRenderPipeline pipeline(SharedDevice());
    RenderRequest request;
    request.scene = &asset.scene;
    request.camera = &asset.camera;
    request.width = 480;
    request.height = 270;
    const RenderResult result = pipeline.RenderSingleCamera(renderer, request);
    ExpectGolden("translucent_solid", SharedDevice().ReadBack(*result.output.rt()),
                 HasCoarseCorners());
}

} // namespace
