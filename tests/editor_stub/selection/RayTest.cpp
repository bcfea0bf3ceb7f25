#include <gtest/gtest.h>
#include <limits>
#include <limn/core/Camera.h>
#include <limn/editor_stub/Raycast.h>
#include <random>

namespace limn::test
{

namespace
{

/// Where the device would draw a point, in pixels from the bottom left, and its depth.
glm::dvec3 Project(const Camera& camera, int width, int height, const glm::dvec3& point)
{
    const glm::dmat4 projection(
        camera.gpuProjectionMatrix(static_cast<float>(width) / static_cast<float>(height)));
    const glm::dvec4 clip = projection * camera.viewMatrix() * glm::dvec4(point, 1.0);
    const glm::dvec2 inPicture =
        (glm::dvec2(clip) / clip.w * 0.5 + 0.5) * glm::dvec2(width, height);
    return {inPicture, clip.z / clip.w};
}

void ExpectNear(const glm::dvec2& expected, const glm::dvec3& actual, double tolerance)
{
    EXPECT_NEAR(expected.x, actual.x, tolerance);
    EXPECT_NEAR(expected.y, actual.y, tolerance);
}

} // namespace

TEST(Ray, AllOfItIsDrawnAtThePointItIsOf)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<float> any(-1.0f, 1.0f);
    for (int i = 0; i < 200; ++i)
    {
        Camera camera;
        camera.orthographic = i % 2 == 1;
        camera.transform.localPosition = {any(random) * 1e6f, any(random), any(random) * 1e3f};
        camera.transform.localRotation =
            EulerToRotation({any(random) * 80.0f, any(random) * 180.0f, any(random) * 90.0f});
        camera.transform.localScale = {2.0f, 0.5f, -1.0f}; // does not matter
        camera.fieldOfView = 60.0f + any(random) * 50.0f;
        camera.orthographicSize = 5.0f + any(random) * 4.0f;
        camera.nearClipPlane = 0.3f;
        camera.farClipPlane = 300.0f;
        const int width = 37 + i;
        const int height = 251 - i;
        if (i % 4 > 1) // a frustum that is not centred
        {
            camera.projectionMatrix =
                camera.projectionMatrixFor(static_cast<float>(width) / static_cast<float>(height));
            (*camera.projectionMatrix)[camera.orthographic ? 3 : 2] +=
                glm::dvec4(any(random), any(random), 0.0, 0.0);
        }
        const glm::dvec2 point{(any(random) * 0.5 + 0.5) * width,
                               (any(random) * 0.5 + 0.5) * height};
        const Ray ray = ScreenPointToRay(camera, width, height, point);
        EXPECT_NEAR(1.0, glm::length(ray.direction), 1e-12);

        const glm::dvec3 near = Project(camera, width, height, ray.origin);
        ExpectNear(point, near, 1e-6);
        EXPECT_NEAR(1.0, near.z, 1e-6);
        const double end = DistanceToFarPlane(camera, ray);
        const glm::dvec3 far = Project(camera, width, height, ray.origin + end * ray.direction);
        ExpectNear(point, far, 1e-6);
        EXPECT_NEAR(0.0, far.z, 1e-6);
        ExpectNear(point, Project(camera, width, height, ray.origin + 7.5 * ray.direction), 1e-6);
    }
}

TEST(Ray, BeginsOnAnObliqueNearPlane)
{
    Camera camera;
    camera.projectionMatrix = camera.CalculateObliqueMatrix({-1.0, 0.0, -1.0, -2.0}, 1.0f);
    const Ray ray = ScreenPointToRay(camera, 64, 64, {8.0, 20.0});
    EXPECT_NEAR(ray.origin.z, 2.0 + ray.origin.x, 1e-6); // view space looks along -z
    ExpectNear({8.0, 20.0}, Project(camera, 64, 64, ray.origin + 5.0 * ray.direction), 1e-5);
    // The far plane comes nearer where the frustum reaches farthest behind the near one.
    EXPECT_EQ(DistanceToFarPlane(camera, ray), std::numeric_limits<double>::infinity());
    const Ray left = ScreenPointToRay(camera, 64, 64, {0.0, 32.0});
    const glm::dvec3 end = left.origin + DistanceToFarPlane(camera, left) * left.direction;
    EXPECT_NEAR(end.z, 1000.0, 0.1);
}

TEST(Ray, OfTheBottomLeftCornerLooksDownAndLeft)
{
    Camera camera;
    camera.fieldOfView = 90.0f;
    const Ray ray = ScreenPointToRay(camera, 200, 100, {0.0, 0.0});
    const double down = -1.0 / std::sqrt(6.0); // (-2, -1, 1)
    EXPECT_NEAR(2.0 * down, ray.direction.x, 1e-7);
    EXPECT_NEAR(down, ray.direction.y, 1e-7);
    EXPECT_NEAR(-down, ray.direction.z, 1e-7);
    EXPECT_NEAR(0.3, ray.origin.z, 1e-7); // the near plane
}

TEST(Ray, OfAPixelGoesThroughItsCenterCountedFromTheTop)
{
    const Camera camera;
    const Ray ray = PixelToRay(camera, 200, 100, 3, 10);
    const Ray same = ScreenPointToRay(camera, 200, 100, {3.5, 89.5});
    EXPECT_EQ(same.origin, ray.origin);
    EXPECT_EQ(same.direction, ray.direction);
}

TEST(Ray, IsRefusedOutsideOfThePicture)
{
    const Camera camera;
    EXPECT_NO_THROW(PixelToRay(camera, 200, 100, 199, 99));
    EXPECT_THROW(PixelToRay(camera, 200, 100, 200, 0), ContractError);
    EXPECT_THROW(PixelToRay(camera, 200, 100, 0, 100), ContractError);
    EXPECT_THROW(PixelToRay(camera, 200, 100, -1, 0), ContractError);
    EXPECT_THROW(ScreenPointToRay(camera, 0, 100, {0.0, 0.0}), ContractError);
    EXPECT_THROW(ScreenPointToRay(camera, 9, 9, {std::nan(""), 0.0}), ContractError);
    Camera flat;
    flat.fieldOfView = 180.0f;
    EXPECT_THROW(PixelToRay(flat, 200, 100, 0, 0), ContractError);
}

} // namespace limn::test
