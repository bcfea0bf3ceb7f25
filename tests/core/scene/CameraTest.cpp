#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <limits>
#include <limn/base/Diagnostic.h>
#include <limn/core/Camera.h>

#include "Mentions.h"
#include "ThrownMessage.h"

namespace limn
{
namespace
{

using test::Mentions;

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
    EXPECT_THAT(ErrorOf(Perspective(0.0f, 0.3f, 1000.0f)),
                Mentions("camera", "fieldOfView is 0;", "180 degrees"));
    EXPECT_THAT(ErrorOf(Perspective(180.0f, 0.3f, 1000.0f)),
                Mentions("camera", "fieldOfView is 180;", "180 degrees"));
    EXPECT_THAT(ErrorOf(Perspective(60.0f, 0.0f, 1000.0f)),
                Mentions("camera", "nearClipPlane is 0", "greater than 0"));
    EXPECT_THAT(ErrorOf(Perspective(60.0f, 5.0f, 5.0f)),
                Mentions("camera", "farClipPlane is 5", "nearClipPlane"));
    EXPECT_THAT(ErrorOf(Camera(), 0.0f), Mentions("camera", "aspect is 0", "greater than 0"));
    Camera flat;
    flat.orthographic = true;
    flat.orthographicSize = -1.0f;
    EXPECT_THAT(ErrorOf(flat), Mentions("camera", "orthographicSize is -1", "greater than 0"));
}

TEST(Camera, NamesTheFieldThatIsNotFinite)
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    EXPECT_THAT(ErrorOf(Perspective(nan, 0.3f, 1000.0f)),
                Mentions("camera", "fieldOfView is nan", "180 degrees"));
    EXPECT_THAT(ErrorOf(Perspective(60.0f, nan, 1000.0f)),
                Mentions("camera", "nearClipPlane is nan", "greater than 0"));
    EXPECT_THAT(ErrorOf(Perspective(60.0f, 0.3f, infinity)),
                Mentions("camera", "farClipPlane is inf", "nearClipPlane"));
    EXPECT_THAT(ErrorOf(Camera(), infinity), Mentions("camera", "aspect is inf", "greater than 0"));
    Camera flat;
    flat.orthographic = true;
    flat.nearClipPlane = nan;
    EXPECT_THAT(ErrorOf(flat), Mentions("camera", "nearClipPlane is nan", "finite"));
}

/// The frustum from (-1, -2) to (3, 1) at 2 m, 10 m deep: worked out by hand from its six numbers.
glm::dmat4 OffCentre()
{
    glm::dmat4 matrix(0.0);
    matrix[0][0] = 1.0;
    matrix[1][1] = 4.0 / 3.0;
    matrix[2] = {0.5, -1.0 / 3.0, -1.5, -1.0};
    matrix[3][2] = -5.0;
    return matrix;
}

TEST(ProjectionMatrix, IsOpenGLsWithItsDepthTurned)
{
    Camera camera = Perspective(60.0f, 2.0f, 10.0f);
    camera.projectionMatrix = OffCentre();
    for (const float aspect : {1.0f, 2.0f}) // has a shape of its own
    {
        EXPECT_LT(glm::length(Project(camera, aspect, {3, 1, -2}) - glm::dvec3(1, 1, 1)), 1e-6);
        EXPECT_LT(glm::length(Project(camera, aspect, {-1, -2, -2}) - glm::dvec3(-1, -1, 1)), 1e-6);
        EXPECT_LT(glm::length(Project(camera, aspect, {15, -10, -10}) - glm::dvec3(1, -1, 0)),
                  1e-6);
    }
    EXPECT_EQ(camera.projectionMatrixFor(1.0f), OffCentre());
}

TEST(ProjectionMatrix, OfTheCameraItselfChangesNothing)
{
    for (const float far : {30.0f, 1e5f, 3e8f})
    {
        for (const bool orthographic : {false, true})
        {
            Camera camera = Perspective(37.0f, 0.3f, far);
            camera.orthographic = orthographic;
            const glm::mat4 before = camera.gpuProjectionMatrix(1.7f);
            camera.projectionMatrix = camera.projectionMatrixFor(1.7f);
            const glm::mat4 after = camera.gpuProjectionMatrix(1.7f);
            for (int i = 0; i < 16; ++i)
            {
                const float value = before[i / 4][i % 4];
                EXPECT_NEAR(after[i / 4][i % 4], value, 4e-7f * std::abs(value))
                    << far << ", " << i;
            }
        }
    }
}

TEST(ProjectionMatrix, ShiftsByPartsOfAPixelAsAskedTo)
{
    // What is 10 pixels wide moves right by 1/16 of a pixel.
    Camera camera = Perspective(90.0f, 0.3f, 1000.0f);
    glm::dmat4 matrix = camera.projectionMatrixFor(1.0f);
    matrix = glm::translate(glm::dmat4(1.0), glm::dvec3(2.0 / 10.0 / 16.0, 0.0, 0.0)) * matrix;
    camera.projectionMatrix = matrix;
    EXPECT_NEAR(Project(camera, 1.0f, {-5, 0, -5}).x, -1.0 + 0.0125, 1e-7);
    EXPECT_NEAR(Project(camera, 1.0f, {0, 3, -300}).x, 0.0125, 1e-7);
}

TEST(ProjectionMatrix, CutsWithAnObliquePlane)
{
    // Kept is what is farther than the plane through (0, 0, -2) that rises to the right.
    const glm::dvec4 plane(-1.0, 0.0, -1.0, -2.0);
    for (const bool orthographic : {false, true})
    {
        Camera camera = Perspective(90.0f, 0.1f, 50.0f);
        camera.orthographic = orthographic;
        camera.orthographicSize = 20.0f;
        const Camera plain = camera;
        camera.projectionMatrix = camera.CalculateObliqueMatrix(plane, 1.0f);
        for (const glm::dvec3& point : {glm::dvec3(0, 0, -2), {1, 1, -3}, {-1, 0, -1}})
        {
            EXPECT_NEAR(Project(camera, 1.0f, point).z, 1.0, 1e-6);
        }
        EXPECT_GT(Project(camera, 1.0f, {1, 0, -2.9}).z, 1.0) << "cut away";
        EXPECT_LT(Project(camera, 1.0f, {1, 0, -3.1}).z, 1.0) << "kept";
        const glm::dvec3 farCorner(orthographic ? -20 : -50, 0, -50);
        EXPECT_GE(Project(camera, 1.0f, farCorner).z, -1e-6) << "before the far plane";
        for (const glm::dvec3& point : {glm::dvec3(3, 2, -9), {-1, 7, -40}})
        {
            const glm::dvec3 there = Project(camera, 1.0f, point);
            const glm::dvec3 before = Project(plain, 1.0f, point);
            EXPECT_LT(glm::length(glm::dvec2(there) - glm::dvec2(before)), 1e-7) << "same place";
        }
    }
}

TEST(ProjectionMatrix, IsRefusedWhereItIsNone)
{
    Camera camera = Perspective(60.0f, 2.0f, 10.0f);
    camera.projectionMatrix = OffCentre();
    (*camera.projectionMatrix)[1][0] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THAT(ErrorOf(camera),
                Mentions("projectionMatrix", "nan", "row 0", "column 1", "finite"));
    (*camera.projectionMatrix)[1][0] = 1e39;
    EXPECT_NE(ErrorOf(camera).find("in row 0, column 1; it must be a finite float"),
              std::string::npos);
    camera.projectionMatrix = glm::dmat4(1.0);
    EXPECT_THAT(ErrorOf(camera),
                Mentions("projectionMatrix", "last row", "(0, 0, -1, 0)", "has perspective"));
    camera.orthographic = true;
    EXPECT_EQ(camera.gpuProjectionMatrix(1.0f)[1][1], 1.0f);
    camera.projectionMatrix = OffCentre();
    EXPECT_THAT(ErrorOf(camera),
                Mentions("projectionMatrix", "last row", "(0, 0, 0, 1)", "no perspective"));
    camera.projectionMatrix = glm::dmat4(1.0);
    (*camera.projectionMatrix)[1][1] = 0.0;
    EXPECT_THAT(ErrorOf(camera), Mentions("projectionMatrix", "singular"));
    EXPECT_THAT(test::ThrownMessage<ContractError>(
                    [] {
                        static_cast<void>(Camera().CalculateObliqueMatrix({0, 0, -1, 2}, 1.0f));
                    }),
                Mentions("oblique", "camera", "visible side"));
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

TEST(CameraType, IsAskedForByItsBits)
{
    const CameraType both = CameraType::Game | CameraType::SceneView;
    EXPECT_TRUE((CameraType::Game & both) != 0);
    EXPECT_TRUE((CameraType::Preview & both) == 0);
    EXPECT_TRUE((both & CameraType::SceneView) == CameraType::SceneView);
}

} // namespace limn
