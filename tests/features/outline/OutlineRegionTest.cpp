#include "core/scene/TestScene.h"

#include <gmock/gmock.h>
#include <limits>
#include <limn/core/BuiltinShaders.h>
#include <limn/core/PrimitiveMesh.h>
#include <limn/features/OutlineRegion.h>

namespace limn::test
{
namespace
{

/// A cube of 1 m seen from the front, 1 m = 20 pixels of a picture of 200 x 100.
class OutlineRegions : public testing::Test
{
protected:
    OutlineRegions()
    {
        camera.orthographic = true;
        camera.orthographicSize = 2.5f;
        camera.nearClipPlane = 1.0f;
        camera.transform.localPosition = {0.0f, 0.0f, -10.0f};
    }

    OutlinedObject Cube(const glm::vec3& position)
    {
        GameObject& object = scene.Add("Cube");
        object.transform.localPosition = position;
        object.renderer = MeshRenderer{
            CreatePrimitive(PrimitiveType::Cube),
            {std::make_shared<Material>(FindBuiltinShader("Limn/Half Lambert", Compiler()))}};
        OutlinedObject outlined;
        outlined.item.object = &object;
        return outlined;
    }

    std::optional<OutlineRegion> Find(const std::vector<OutlinedObject>& objects, float reach)
    {
        CameraData data;
        data.camera = &camera;
        data.cameraTargetDescriptor =
            RenderTextureDescriptor(200, 100, GraphicsFormat::R8G8B8A8_UNorm);
        data.viewMatrix = camera.viewMatrix();
        data.gpuProjectionMatrix = camera.gpuProjectionMatrix(2.0f);
        return FindOutlineRegion(objects, data, reach);
    }

    Scene scene;
    Camera camera;
};

TEST_F(OutlineRegions, HoldTheObjectAndItsOutline)
{
    const auto region = Find({Cube({0.01f, -0.01f, 0.0f})}, 4.0f);
    ASSERT_TRUE(region);
    // The cube covers 90.2...110.2 by 40.2...60.2; 4 pixels of outline and one to smooth it.
    EXPECT_EQ(region->corner, glm::ivec2(85, 35));
    EXPECT_EQ(region->size, glm::ivec2(64, 64));
    EXPECT_EQ(region->InPicture(), (ViewportRect{85, 35, 64, 64}));
}

TEST_F(OutlineRegions, ReachOverTheBorderAsFarAsAnOutlineComesFrom)
{
    // The cube ends 1.8 pixels left of the picture.
    const auto region = Find({Cube({-5.59f, -0.01f, 0.0f})}, 4.0f);
    ASSERT_TRUE(region);
    EXPECT_EQ(region->corner, glm::ivec2(-5, 35));
    EXPECT_EQ(region->InPicture(), (ViewportRect{0, 35, 59, 64}));
    const glm::vec4 scaleBias = region->ScaleBias();
    EXPECT_FLOAT_EQ(scaleBias.x, 59.0f / 64.0f);
    EXPECT_FLOAT_EQ(scaleBias.z, 5.0f / 64.0f);
}

TEST_F(OutlineRegions, KnowWhereInThemObjectsCanBe)
{
    const auto inside = Find({Cube({0.01f, -0.01f, 0.0f})}, 4.0f);
    ASSERT_TRUE(inside);
    // 90.2...110.2 by 40.2...60.2 and a texel around it, from the corner at 85, 35.
    EXPECT_EQ(inside->objectsBegin, glm::ivec2(4, 4));
    EXPECT_EQ(inside->objectsEnd, glm::ivec2(27, 27));
    const auto leftOfIt = Find({Cube({-5.59f, -0.01f, 0.0f})}, 4.0f);
    ASSERT_TRUE(leftOfIt);
    EXPECT_EQ(leftOfIt->objectsBegin, glm::ivec2(0, 4)) << "from the texture's border";
    EXPECT_EQ(leftOfIt->objectsEnd, glm::ivec2(5, 27)) << "-1.8 and a texel more, from -5";
    const auto behind = Find({Cube({0.0f, 0.0f, -10.0f})}, 4.0f);
    ASSERT_TRUE(behind) << "the camera is in the cube, which may be anywhere";
    EXPECT_EQ(behind->objectsBegin, glm::ivec2(0));
    EXPECT_EQ(behind->objectsEnd, glm::ivec2(200 + 2 * 5, 100 + 2 * 5));
}

TEST_F(OutlineRegions, AreNoneWhereNoOutlineTouchesThePicture)
{
    EXPECT_FALSE(Find({Cube({-5.6f - 0.25f, 0.0f, 0.0f})}, 4.0f));
    EXPECT_FALSE(Find({Cube({0.0f, 3.5f, 0.0f})}, 4.0f));
    EXPECT_FALSE(Find({}, 4.0f));
    EXPECT_TRUE(Find({Cube({-5.6f - 0.25f, 0.0f, 0.0f})}, 8.0f));
}

TEST_F(OutlineRegions, EndAtThePictureForAnyReach)
{
    for (const float reach : {1e4f, 1e30f, std::numeric_limits<float>::infinity()})
    {
        const auto region = Find({Cube({0.0f, 0.0f, 0.0f})}, reach);
        ASSERT_TRUE(region);
        EXPECT_EQ(region->InPicture(), (ViewportRect{0, 0, 200, 100}));
        EXPECT_LE(region->size.x, 1024);
    }
}

TEST_F(OutlineRegions, HoldThePictureWhereAnObjectReachesBehindTheNearPlane)
{
    camera.orthographic = false;
    camera.nearClipPlane = 0.3f;
    const auto region = Find({Cube({0.0f, 0.0f, -10.0f})}, 4.0f);
    ASSERT_TRUE(region);
    EXPECT_EQ(region->InPicture(), (ViewportRect{0, 0, 200, 100}));
}

TEST_F(OutlineRegions, ProjectWhatThePictureHasThereOntoTheirTexture)
{
    const auto region = Find({Cube({1.0f, 0.7f, 0.0f})}, 4.0f);
    ASSERT_TRUE(region);
    const glm::mat4 gpu = camera.gpuProjectionMatrix(2.0f);
    const glm::vec4 view(1.3f, 0.4f, -7.0f, 1.0f);
    const glm::vec4 inPicture = gpu * view;
    const glm::vec4 inRegion = region->Projection(gpu) * view;
    const glm::vec2 pixel((1.0f + inPicture.x) * 100.0f, (1.0f - inPicture.y) * 50.0f);
    const glm::vec2 texel((1.0f + inRegion.x) * 0.5f * static_cast<float>(region->size.x),
                          (1.0f - inRegion.y) * 0.5f * static_cast<float>(region->size.y));
    EXPECT_NEAR(texel.x, pixel.x - static_cast<float>(region->corner.x), 1e-3f);
    EXPECT_NEAR(texel.y, pixel.y - static_cast<float>(region->corner.y), 1e-3f);
    EXPECT_EQ(inRegion.z, inPicture.z);
}

} // namespace
} // namespace limn::test
