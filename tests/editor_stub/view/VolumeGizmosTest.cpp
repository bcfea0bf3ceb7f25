#include "view/VolumeGizmos.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace limn::test
{

namespace
{

constexpr int k_Size = 200;

Image BlackPicture()
{
    Image picture{k_Size, k_Size, GraphicsFormat::R8G8B8A8_SRGB, {}};
    picture.texels.resize(4 * k_Size * k_Size);
    return picture;
}

/// Returns a camera of 20 x 20 m that looks along z from 50 m in front of the origin, so that a
/// metre is 10 pixels and the origin lies in the middle.
Camera FlatCamera()
{
    Camera camera;
    camera.orthographic = true;
    camera.orthographicSize = 10.0f;
    camera.transform.localPosition = {0, 0, -50};
    return camera;
}

Volume LocalVolume(Collider collider, float blendDistance)
{
    Volume volume;
    volume.isGlobal = false;
    volume.blendDistance = blendDistance;
    volume.colliders = {std::move(collider)};
    return volume;
}

bool isDrawn(const Image& picture, int x, int y)
{
    return picture.texels[4 * static_cast<std::size_t>(y * k_Size + x) + 1] != std::byte{0};
}

/// Returns whether something is drawn within a pixel of a place.
bool isDrawnNear(const Image& picture, double x, double y)
{
    for (int dy = -1; dy <= 1; ++dy)
    {
        for (int dx = -1; dx <= 1; ++dx)
        {
            if (isDrawn(picture, static_cast<int>(x) + dx, static_cast<int>(y) + dy))
            {
                return true;
            }
        }
    }
    return false;
}

int CountDrawn(const Image& picture)
{
    int count = 0;
    for (int i = 0; i < k_Size * k_Size; ++i)
    {
        count += isDrawn(picture, i % k_Size, i / k_Size) ? 1 : 0;
    }
    return count;
}

} // namespace

// 4 x 2 m around (3, 1, 0): from 110 to 150 pixels across and, as rows count from the top, from 80
// to 100.
TEST(VolumeGizmos, ShowTheEdgesOfABox)
{
    Image picture = BlackPicture();
    Volume volume = LocalVolume(BoxCollider{true, {1, 0, 0}, {4, 2, 2}}, 0.0f);
    volume.position = {2, 1, 0};
    DrawVolumes(picture, FlatCamera(), {&volume, 1});
    for (const double x : {110.0, 120.0, 150.0})
    {
        EXPECT_TRUE(isDrawnNear(picture, x, 80.0)) << x;
        EXPECT_TRUE(isDrawnNear(picture, x, 100.0)) << x;
    }
    EXPECT_TRUE(isDrawnNear(picture, 110.0, 90.0));
    EXPECT_TRUE(isDrawnNear(picture, 150.0, 90.0));
    EXPECT_FALSE(isDrawnNear(picture, 130.0, 90.0));
    EXPECT_LE(CountDrawn(picture), 2 * (2 * 40 + 2 * 20) + 16);
}

// The half diagonal of a box is no distance to it: beside a corner the fade ends on a circle.
TEST(VolumeGizmos, ShowWhereAVolumeHasFadedOut)
{
    Image picture = BlackPicture();
    const Volume volume = LocalVolume(BoxCollider{true, {0, 0, 0}, {8, 8, 8}}, 3.0f);
    DrawVolumes(picture, FlatCamera(), {&volume, 1});
    int onTheCircle = 0;
    for (int degrees = 0; degrees <= 90; ++degrees)
    {
        const double angle = degrees * 3.14159265358979 / 180.0;
        onTheCircle +=
            isDrawnNear(picture, 140.0 + 30.0 * std::cos(angle), 60.0 - 30.0 * std::sin(angle)) ? 1
                                                                                                : 0;
    }
    EXPECT_GE(onTheCircle, 91 * 4 / 10); // it is dashed
    EXPECT_LE(onTheCircle, 91 * 9 / 10);
    EXPECT_FALSE(isDrawnNear(picture, 169.0, 31.0)) << "the corner of a box of 14 m";
}

TEST(VolumeGizmos, ShowASphereScaledByItsLongestAxis)
{
    Image picture = BlackPicture();
    Volume volume = LocalVolume(SphereCollider{true, {0, 0, 0}, 2.0f}, 0.0f);
    volume.scale = {1, 3, 2};
    DrawVolumes(picture, FlatCamera(), {&volume, 1});
    for (int degrees = 0; degrees < 360; degrees += 15)
    {
        const double angle = degrees * 3.14159265358979 / 180.0;
        EXPECT_TRUE(
            isDrawnNear(picture, 100.0 + 60.0 * std::cos(angle), 100.0 - 60.0 * std::sin(angle)))
            << degrees;
    }
}

TEST(VolumeGizmos, LeaveOutGlobalVolumesAndWhatIsOff)
{
    Image picture = BlackPicture();
    Volume volumes[3];
    for (Volume& volume : volumes)
    {
        volume = LocalVolume(SphereCollider{}, 1.0f);
    }
    volumes[0].isGlobal = true;
    volumes[1].enabled = false;
    std::get<SphereCollider>(volumes[2].colliders[0]).enabled = false;
    EXPECT_EQ(0, DrawVolumes(picture, FlatCamera(), volumes));
    EXPECT_EQ(0, CountDrawn(picture));
    volumes[1].enabled = true;
    EXPECT_EQ(1, DrawVolumes(picture, FlatCamera(), volumes));
    EXPECT_GT(CountDrawn(picture), 0);
}

TEST(VolumeGizmos, ShowTheTrigger)
{
    Image picture = BlackPicture();
    Camera camera = FlatCamera();
    camera.volumeTrigger = glm::vec3(-5, 0, 0);
    DrawVolumes(picture, camera, {});
    EXPECT_TRUE(isDrawnNear(picture, 48.0, 100.0));
    EXPECT_TRUE(isDrawnNear(picture, 50.0, 98.0));
    EXPECT_FALSE(isDrawnNear(picture, 45.0, 100.0));
}

// From inside, most of the box lies behind the camera, where a perspective turns it over.
TEST(VolumeGizmos, AreCutAtTheNearPlane)
{
    Image picture = BlackPicture();
    Camera camera;
    camera.fieldOfView = 90.0f;
    const Volume volume = LocalVolume(BoxCollider{true, {0, 0, 0}, {8, 8, 16}}, 0.0f);
    DrawVolumes(picture, camera, {&volume, 1});
    // The far face is 8 m wide at 8 m, where the picture is 16 m wide.
    EXPECT_TRUE(isDrawnNear(picture, 50.0, 50.0));
    EXPECT_TRUE(isDrawnNear(picture, 150.0, 100.0));
    EXPECT_FALSE(isDrawnNear(picture, 100.0, 100.0));
    // Four edges go on from its corners to those of the picture.
    EXPECT_TRUE(isDrawnNear(picture, 20.0, 20.0));
    EXPECT_FALSE(isDrawnNear(picture, 20.0, 100.0));
}

TEST(VolumeGizmos, OfHugeAndOfNoSizeEnd)
{
    Image picture = BlackPicture();
    Camera camera;
    camera.transform.localPosition = {0, 0, -5};
    const float infinity = std::numeric_limits<float>::infinity();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const float size : {0.0f, 1e-30f, 1e30f, infinity, nan})
    {
        const Volume volumes[] = {
            LocalVolume(BoxCollider{true, {0, 0, 0}, {size, 1, 1}}, 1.0f),
            LocalVolume(SphereCollider{true, {0, 0, 0}, size}, size),
            LocalVolume(CapsuleCollider{true, {0, 0, 0}, size, 1.0f, 1}, 2.0f)};
        DrawVolumes(picture, camera, volumes);
    }
    EXPECT_GT(CountDrawn(picture), 0); // those of size 0 have a blend distance
}

} // namespace limn::test
