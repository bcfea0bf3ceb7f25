#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <limn/core/Camera.h>
#include <limn/shaderlab/Diagnostic.h>

#include "ThrownMessage.h"

namespace limn
{
namespace
{

constexpr double k_Pi = 3.14159265358979323846;

/// Where a view-space point `depth` in front of the camera ends up, after the division by w.
glm::dvec3 Project(const Camera& camera, float aspect, const glm::dvec3& view)
{
    const glm::dvec4 clip = glm::dmat4(camera.gpuProjectionMatrix(aspect)) * glm::dvec4(view, 1.0);
    return glm::dvec3(clip) / clip.w;
}

Camera Perspective(float fieldOfView, float near, float far)
{
    Camera camera;
    camera.fieldOfView = fieldOfView;
    camera.nearClipPlane = near;
    camera.farClipPlane = far;
    return camera;
}

TEST(Camera, MapsNearToOneAndFarToZero)
{
    struct Planes
    {
        float near;
        float far;
    };
    for (const Planes& p : {Planes{0.3f, 1000.0f}, Planes{0.01f, 1e6f}, Planes{1e-3f, 1e5f}})
    {
        const Camera camera = Perspective(60.0f, p.near, p.far);
        EXPECT_NEAR(Project(camera, 1.0f, {0, 0, -static_cast<double>(p.near)}).z, 1.0, 1e-6);
        // To what a float matrix can hold beside near / far, the depth's scale out there.
        EXPECT_NEAR(Project(camera, 1.0f, {0, 0, -static_cast<double>(p.far)}).z, 0.0,
                    1e-6 * static_cast<double>(p.near / p.far));
    }
}

TEST(Camera, SpreadsDepthAsTheReversedFormulaSays)
{
    const double n = 0.01f;
    const double f = 1e6f;
    const Camera camera = Perspective(60.0f, 0.01f, 1e6f);
    for (const double distance : {0.02, 0.5, 1.0, 10.0, 1000.0, 100000.0, 900000.0})
    {
        const double expected = n * (f - distance) / (distance * (f - n));
        EXPECT_NEAR(Project(camera, 1.0f, {0, 0, -distance}).z, expected, expected * 2e-6 + 1e-14)
            << "distance " << distance;
    }
}

/// Depth 0 near ... 1 far is 1 less the reversed one, perspective or not, and the picture the same.
TEST(Camera, TurnsDepthForStandardZ)
{
    for (const bool isOrthographic : {false, true})
    {
        Camera camera = Perspective(60.0f, 0.25f, 64.0f);
        camera.orthographic = isOrthographic;
        const glm::mat4 reversed = camera.gpuProjectionMatrix(1.5f);
        const glm::mat4 standard = camera.gpuProjectionMatrix(1.5f, false);
        for (const double distance : {0.25, 1.0, 7.0, 64.0})
        {
            const glm::dvec4 view(0.3, -0.2, -distance, 1.0);
            const glm::dvec4 a = glm::dmat4(reversed) * view;
            const glm::dvec4 b = glm::dmat4(standard) * view;
            EXPECT_NEAR(b.z / b.w, 1.0 - a.z / a.w, 1e-6);
            EXPECT_EQ(glm::dvec3(b.x, b.y, b.w), glm::dvec3(a.x, a.y, a.w));
        }
    }
}

TEST(Camera, ShowsTheVerticalFieldOfView)
{
    for (const float degrees : {1.0f, 60.0f, 90.0f, 179.0f})
    {
        const Camera camera = Perspective(degrees, 0.3f, 1000.0f);
        const double top = 10.0 * std::tan(static_cast<double>(degrees) * k_Pi / 360.0);
        const glm::dvec3 corner = Project(camera, 2.0f, {2.0 * top, top, -10.0});
        EXPECT_NEAR(corner.x, 1.0, 1e-6) << degrees << " degrees";
        EXPECT_NEAR(corner.y, 1.0, 1e-6) << degrees << " degrees";
    }
}

TEST(Camera, MapsAnOrthographicBoxToTheClipCube)
{
    Camera camera;
    camera.orthographic = true;
    camera.orthographicSize = 5.0f;
    camera.nearClipPlane = -2.0f;
    camera.farClipPlane = 18.0f;
    const glm::dvec3 nearCorner = Project(camera, 2.0f, {10, 5, 2});
    EXPECT_NEAR(nearCorner.x, 1.0, 1e-6);
    EXPECT_NEAR(nearCorner.y, 1.0, 1e-6);
    EXPECT_NEAR(nearCorner.z, 1.0, 1e-6);
    EXPECT_NEAR(Project(camera, 2.0f, {0, 0, -8}).z, 0.5, 1e-6);
    EXPECT_NEAR(Project(camera, 2.0f, {0, 0, -18}).z, 0.0, 1e-6);
}

std::string ErrorOf(const Camera& camera, float aspect = 1.0f)
{
    return test::ThrownMessage<ContractError>(
        [&] { static_cast<void>(camera.gpuProjectionMatrix(aspect)); });
}

TEST(Camera, NamesTheFieldThatIsOutOfRange)
{
    EXPECT_EQ(ErrorOf(Perspective(0.0f, 0.3f, 1000.0f)),
              "camera: fieldOfView is 0.000000, it must be between 0 and 180 degrees");
    EXPECT_EQ(ErrorOf(Perspective(180.0f, 0.3f, 1000.0f)),
              "camera: fieldOfView is 180.000000, it must be between 0 and 180 degrees");
    EXPECT_EQ(ErrorOf(Perspective(60.0f, 0.0f, 1000.0f)),
              "camera: nearClipPlane is 0.000000, it must be greater than 0");
    EXPECT_EQ(ErrorOf(Perspective(60.0f, 5.0f, 5.0f)),
              "camera: farClipPlane is 5.000000, it must be greater than nearClipPlane");
    EXPECT_EQ(ErrorOf(Camera(), 0.0f), "camera: aspect is 0.000000, it must be greater than 0");
    Camera flat;
    flat.orthographic = true;
    flat.orthographicSize = -1.0f;
    EXPECT_EQ(ErrorOf(flat), "camera: orthographicSize is -1.000000, it must be greater than 0");
}

TEST(Camera, NamesTheFieldThatIsNotFinite)
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    EXPECT_EQ(ErrorOf(Perspective(nan, 0.3f, 1000.0f)),
              "camera: fieldOfView is nan, it must be between 0 and 180 degrees");
    EXPECT_EQ(ErrorOf(Perspective(60.0f, nan, 1000.0f)),
              "camera: nearClipPlane is nan, it must be greater than 0");
    EXPECT_EQ(ErrorOf(Perspective(60.0f, 0.3f, infinity)),
              "camera: farClipPlane is inf, it must be greater than nearClipPlane");
    EXPECT_EQ(ErrorOf(Camera(), infinity), "camera: aspect is inf, it must be greater than 0");
    Camera flat;
    flat.orthographic = true;
    flat.nearClipPlane = nan;
    EXPECT_EQ(ErrorOf(flat), "camera: nearClipPlane is nan, it must be finite");
}

void ExpectView(const Camera& camera, const glm::vec3& world, const glm::vec3& expected)
{
    const glm::vec3 view(camera.worldToCameraMatrix() * glm::vec4(world, 1.0f));
    for (int i = 0; i < 3; ++i)
    {
        EXPECT_NEAR(view[i], expected[i], 1e-5f) << "component " << i;
    }
}

TEST(Camera, LooksAlongPositiveZWithViewSpaceDownNegativeZ)
{
    Camera camera;
    camera.transform.localPosition = {1, 2, 3};
    ExpectView(camera, {1, 2, 13}, {0, 0, -10});
    ExpectView(camera, {2, 2, 13}, {1, 0, -10});
    ExpectView(camera, {1, 3, 13}, {0, 1, -10});
}

TEST(Camera, SeesPositiveXAfterAYawOfNinetyDegrees)
{
    Camera camera;
    camera.transform.localRotation = EulerToRotation({0, 90, 0});
    ExpectView(camera, {10, 0, 0}, {0, 0, -10});
    ExpectView(camera, {10, 0, -1}, {1, 0, -10});
}

TEST(Camera, DoesNotCareAboutScale)
{
    Camera plain;
    plain.transform.localPosition = {1, 2, 3};
    plain.transform.localRotation = EulerToRotation({20, 30, 40});
    const glm::mat4 expected = plain.worldToCameraMatrix();
    for (const glm::vec3& scale : {glm::vec3(0.0f), glm::vec3(1, -1, 1), glm::vec3(3, 0.5f, -2)})
    {
        Camera scaled = plain;
        scaled.transform.localScale = scale;
        EXPECT_EQ(scaled.worldToCameraMatrix(), expected);
    }
}

TEST(RenderOrigin, IsTheWorldsOriginUpToAKilometreAndAPointNearTheCameraBeyond)
{
    Camera camera;
    camera.transform.localPosition = {1, 2, -1024};
    EXPECT_EQ(camera.renderOrigin(), glm::dvec3(0.0));
    camera.transform.localPosition = {1, 2, -1025};
    EXPECT_EQ(camera.renderOrigin(), glm::dvec3(0, 0, -1024)); // multiples of 8 m
    Transform away;
    away.localPosition = {1e9f, 0, 0};
    camera.transform.localPosition = {5, 0, 0};
    camera.transform.parent = &away;
    EXPECT_EQ(camera.renderOrigin(), glm::dvec3(1'000'000'008.0, 0, 0));
}

} // namespace
} // namespace limn
