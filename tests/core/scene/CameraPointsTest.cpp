#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>
#include <limn/base/Diagnostic.h>
#include <limn/core/Camera.h>

namespace limn::test
{
namespace
{

constexpr float k_Aspect = 1.5f;

Camera Somewhere()
{
    Camera camera;
    camera.transform.localPosition = {3.0f, -2.0f, 7.0f};
    camera.transform.localRotation = EulerToRotation({20.0f, -50.0f, 10.0f});
    return camera;
}

/// `ahead` metres in front of the camera, beside and above its axis by shares of what it sees.
glm::vec3 PlaceSeen(const Camera& camera, float right, float up, float ahead)
{
    const float halfHeight = camera.orthographic
                                 ? camera.orthographicSize
                                 : ahead * std::tan(camera.fieldOfView * 0.00872664626f);
    const glm::quat rotation = camera.transform.localRotation;
    return camera.transform.localPosition +
           rotation * glm::vec3(right * halfHeight * k_Aspect, up * halfHeight, ahead);
}

void ExpectNear(const glm::vec3& a, const glm::vec3& b, float tolerance)
{
    EXPECT_NEAR(a.x, b.x, tolerance);
    EXPECT_NEAR(a.y, b.y, tolerance);
    EXPECT_NEAR(a.z, b.z, tolerance);
}

TEST(CameraPoints, LieInThePictureWhereTheLensPutsThem)
{
    for (const bool orthographic : {false, true})
    {
        SCOPED_TRACE(orthographic);
        Camera camera = Somewhere();
        camera.orthographic = orthographic;
        const glm::vec3 place = PlaceSeen(camera, 0.5f, -0.25f, 12.0f);
        const glm::vec3 expected(0.75f, 0.375f, 12.0f); // -1 ... 1 becomes 0 ... 1
        ExpectNear(camera.WorldToViewportPoint(place, k_Aspect), expected, 1e-5f);
        ExpectNear(camera.ViewportToWorldPoint(expected, k_Aspect), place, 1e-4f);
        const glm::ivec2 size(600, 400);
        const glm::vec3 onScreen(450.0f, 150.0f, 12.0f);
        ExpectNear(camera.WorldToScreenPoint(place, size), onScreen, 1e-2f);
        ExpectNear(camera.ScreenToWorldPoint(onScreen, size), place, 1e-4f);
        ExpectNear(Camera::ScreenToViewportPoint(onScreen, size), expected, 1e-6f);
        ExpectNear(Camera::ViewportToScreenPoint(expected, size), onScreen, 1e-4f);
    }
}

TEST(CameraPoints, RaysBeginAtTheNearPlaneAndGoThroughWhatIsThere)
{
    for (const bool orthographic : {false, true})
    {
        SCOPED_TRACE(orthographic);
        Camera camera = Somewhere();
        camera.orthographic = orthographic;
        camera.nearClipPlane = 2.0f;
        const glm::vec3 nearest = PlaceSeen(camera, -0.5f, 0.5f, 2.0f);
        const glm::vec3 place = PlaceSeen(camera, -0.5f, 0.5f, 30.0f);
        for (const Ray& ray : {camera.ViewportPointToRay({0.25f, 0.75f}, k_Aspect),
                               camera.ScreenPointToRay({150.0f, 300.0f}, {600, 400})})
        {
            ExpectNear(glm::vec3(ray.origin), nearest, 1e-4f);
            EXPECT_NEAR(glm::length(ray.direction), 1.0, 1e-9);
            ExpectNear(glm::vec3(ray.GetPoint(static_cast<double>(glm::distance(nearest, place)))),
                       place, 1e-3f);
        }
    }
}

TEST(CameraPoints, TheFrustumsCornersBeginAtTheBottomLeftAndGoRoundClockwise)
{
    Camera camera = Somewhere();
    camera.fieldOfView = 90.0f; // as high at 10 m as 20 m
    const auto corners = camera.CalculateFrustumCorners({0, 0, 1, 1}, 10.0f, k_Aspect);
    ExpectNear(corners[0], {-15, -10, 10}, 1e-4f);
    ExpectNear(corners[1], {-15, 10, 10}, 1e-4f);
    ExpectNear(corners[2], {15, 10, 10}, 1e-4f);
    ExpectNear(corners[3], {15, -10, 10}, 1e-4f);
    const auto part = camera.CalculateFrustumCorners({0.5f, 0.25f, 0.5f, 0.25f}, 10.0f, k_Aspect);
    ExpectNear(part[0], {0, -5, 10}, 1e-4f);
    ExpectNear(part[2], {15, 0, 10}, 1e-4f);
}

TEST(CameraPoints, FollowAProjectionThatIsNotSymmetric)
{
    Camera camera;
    glm::dmat4 projection = camera.projectionMatrixFor(k_Aspect);
    projection[2][0] = 0.4; // the middle of what it sees is beside its axis
    camera.projectionMatrix = projection;
    const glm::vec3 ahead(0.0f, 0.0f, 5.0f);
    const glm::vec3 seen = camera.WorldToViewportPoint(ahead, k_Aspect);
    ExpectNear(seen, {0.5f - 0.2f, 0.5f, 5.0f}, 1e-5f); // clip x = 0.4 * -5, w = 5
    ExpectNear(camera.ViewportToWorldPoint(seen, k_Aspect), ahead, 1e-4f);
    const glm::dvec4 clip = camera.cullingMatrix(k_Aspect) * glm::dvec4(ahead, 1.0);
    EXPECT_NEAR(clip.x / clip.w, -0.4, 1e-6);
}

TEST(CameraPoints, AskForAScreen)
{
    EXPECT_THROW(Camera().WorldToScreenPoint({0, 0, 1}, {0, 400}), ContractError);
    EXPECT_THROW(Camera().ScreenPointToRay({0, 0}, {600, 0}), ContractError);
    for (const glm::ivec2 size : {glm::ivec2(0, 400), glm::ivec2(600, 0)})
    {
        EXPECT_THROW(Camera::ScreenToViewportPoint({0, 0, 1}, size), ContractError);
        EXPECT_THROW(Camera::ViewportToScreenPoint({0, 0, 1}, size), ContractError);
    }
    EXPECT_EQ(Camera::ViewportToScreenPoint({0.5f, 0.25f, 1}, {1, 1}), glm::vec3(0.5f, 0.25f, 1));
}

} // namespace
} // namespace limn::test
