#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <limn/base/Diagnostic.h>
#include <limn/core/Transform.h>
#include <random>
#include <vector>

#include "Mentions.h"
#include "ThrownMessage.h"

namespace limn
{
namespace
{

void ExpectNear(const glm::vec3& actual, const glm::vec3& expected, float tolerance = 1e-6f)
{
    for (int i = 0; i < 3; ++i)
    {
        EXPECT_NEAR(actual[i], expected[i], tolerance) << "component " << i;
    }
}

const glm::vec3 k_X(1, 0, 0);
const glm::vec3 k_Y(0, 1, 0);
const glm::vec3 k_Z(0, 0, 1);

TEST(EulerToRotation, TurnsForwardToTheRightByAPositiveYaw)
{
    ExpectNear(EulerToRotation({0, 90, 0}) * k_Z, k_X);
}

TEST(EulerToRotation, TurnsForwardDownByAPositivePitch)
{
    ExpectNear(EulerToRotation({90, 0, 0}) * k_Z, -k_Y);
}

TEST(EulerToRotation, TurnsRightUpByAPositiveRoll)
{
    ExpectNear(EulerToRotation({0, 0, 90}) * k_X, k_Y);
}

/// Rotates by hand-written matrices: first about z, then x, then y.
glm::dvec3 RotateZxy(const glm::dvec3& degrees, const glm::dvec3& p)
{
    const glm::dvec3 r = degrees * (std::acos(-1.0) / 180.0);
    const glm::dvec3 z(p.x * std::cos(r.z) - p.y * std::sin(r.z),
                       p.x * std::sin(r.z) + p.y * std::cos(r.z), p.z);
    const glm::dvec3 x(z.x, z.y * std::cos(r.x) - z.z * std::sin(r.x),
                       z.y * std::sin(r.x) + z.z * std::cos(r.x));
    return {x.x * std::cos(r.y) + x.z * std::sin(r.y), x.y,
            -x.x * std::sin(r.y) + x.z * std::cos(r.y)};
}

TEST(EulerToRotation, AppliesRollThenPitchThenYaw)
{
    const unsigned seed = std::random_device{}();
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> angle(-180.0f, 180.0f);
    for (int i = 0; i < 100; ++i)
    {
        const glm::vec3 degrees(angle(random), angle(random), angle(random));
        const glm::vec3 point(angle(random), angle(random), angle(random));
        ExpectNear(EulerToRotation(degrees) * point,
                   glm::vec3(RotateZxy(glm::dvec3(degrees), glm::dvec3(point))), 2e-4f);
    }
}

TEST(LookRotation, LooksAlongForwardWithUpUpwards)
{
    const glm::quat rotation = LookRotation({3, 0, 3});
    const float h = std::sqrt(0.5f);
    ExpectNear(rotation * k_Z, {h, 0, h});
    ExpectNear(rotation * k_Y, k_Y);
    ExpectNear(rotation * k_X, {h, 0, -h});
}

TEST(LookRotation, LeansTowardsAnUpThatIsNotPerpendicular)
{
    const glm::quat rotation = LookRotation(k_Z, {0, 1, 5});
    ExpectNear(rotation * k_Y, k_Y);
}

TEST(LookRotation, KeepsRightWhenItLooksStraightUpOrDown)
{
    ExpectNear(LookRotation(k_Y) * k_Z, k_Y);
    ExpectNear(LookRotation(k_Y) * k_X, k_X);
    ExpectNear(LookRotation(-k_Y) * k_Z, -k_Y);
    ExpectNear(LookRotation(-k_Y) * k_X, k_X);
}

TEST(LookRotation, FindsARotationWithoutAUsableUp)
{
    for (const glm::vec3& up : {glm::vec3(0.0f), k_X, -k_X})
    {
        const glm::quat rotation = LookRotation(k_X, up);
        ExpectNear(rotation * k_Z, k_X);
        EXPECT_NEAR(glm::length(rotation), 1.0f, 1e-6f);
    }
}

TEST(LookRotation, DoesNotCareHowLongUpIs)
{
    for (const float length : {1e-44f, 1e-30f, 1e-7f, 1.0f, 1e7f, 1e30f})
    {
        ExpectNear(LookRotation(k_Z, k_X * length) * k_Y, k_X);
    }
}

TEST(LookRotation, DoesNotCareHowLongForwardIs)
{
    for (const float length : {1e-44f, 1e-30f, 1e-7f, 1.0f, 1e7f, 1e30f, 3e38f})
    {
        ExpectNear(LookRotation((k_X + k_Z) * length * 0.5f) * k_X, (k_X - k_Z) * std::sqrt(0.5f));
    }
}

TEST(LookRotation, RefusesAForwardOfZero)
{
    EXPECT_THAT(test::ThrownMessage<ContractError>([] { LookRotation(glm::vec3(0.0f)); }),
                test::Mentions("LookRotation", "forward", "zero"));
}

TEST(Transform, ScalesThenRotatesThenMoves)
{
    Transform transform;
    transform.localPosition = {10, 20, 30};
    transform.localRotation = EulerToRotation({0, 90, 0});
    transform.localScale = {2, 3, 4};
    // (1, 1, 1) scaled is (2, 3, 4); turned to the right (4, 3, -2).
    ExpectNear(glm::vec3(transform.localToWorldMatrix() * glm::vec4(1, 1, 1, 1)), {14, 23, 28},
               1e-5f);
    ExpectNear(transform.forward(), k_X);
}

TEST(Transform, IsSeenThroughItsParents)
{
    Transform grandparent;
    grandparent.localPosition = {0, 0, 100};
    Transform parent;
    parent.parent = &grandparent;
    parent.localRotation = EulerToRotation({0, 90, 0});
    parent.localScale = {2, 2, 2};
    Transform child;
    child.parent = &parent;
    child.localPosition = {0, 0, 5};
    ExpectNear(child.position(), {10, 0, 100}, 1e-5f);
    ExpectNear(child.forward(), k_X);
}

TEST(Transform, PointsForwardWhateverItsParentsScale)
{
    Transform parent;
    parent.localScale = {1, 1, 0};
    Transform child;
    child.parent = &parent;
    child.localRotation = EulerToRotation({0, 45, 0});
    const float h = std::sqrt(0.5f);
    ExpectNear(child.forward(), {h, 0, h});
}

TEST(Transform, LosesNothingToParentsThatAreFarAway)
{
    Transform away;
    away.localPosition = {1e7f, -1e7f, 5e6f};
    Transform aside;
    aside.parent = &away;
    aside.localPosition = {0.1f, 0.2f, 0.3f};
    Transform back;
    back.parent = &aside;
    back.localPosition = -away.localPosition;
    EXPECT_EQ(back.position(), aside.localPosition);
}

using Point = std::array<long double, 3>;

/// The point scaled, turned and moved: v + 2w(q x v) + 2q x (q x v).
Point ToParent(const Transform& t, const Point& point)
{
    const long double w = t.localRotation.w;
    const Point q{t.localRotation.x, t.localRotation.y, t.localRotation.z};
    const auto cross = [](const Point& a, const Point& b)
    {
        return Point{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                     a[0] * b[1] - a[1] * b[0]};
    };
    Point v;
    for (int i = 0; i < 3; ++i)
    {
        v[static_cast<std::size_t>(i)] = point[static_cast<std::size_t>(i)] * t.localScale[i];
    }
    const Point once = cross(q, v);
    const Point twice = cross(q, once);
    for (int i = 0; i < 3; ++i)
    {
        const auto k = static_cast<std::size_t>(i);
        v[k] += 2 * (w * once[k] + twice[k]) + t.localPosition[i];
    }
    return v;
}

TEST(Transform, RoundsTheMatrixOfAChainOnlyOnce)
{
    std::mt19937 random(11);
    std::uniform_real_distribution<float> angle(-180.0f, 180.0f);
    std::uniform_real_distribution<float> scale(0.5f, 2.0f);
    std::uniform_real_distribution<float> place(-1e6f, 1e6f);
    for (int round = 0; round < 100; ++round)
    {
        std::array<Transform, 6> chain;
        Point expected{1, 2, 3};
        for (std::size_t i = 0; i < chain.size(); ++i)
        {
            chain[i].parent = i + 1 < chain.size() ? &chain[i + 1] : nullptr;
            chain[i].localPosition = {place(random), place(random), place(random)};
            chain[i].localRotation = EulerToRotation({angle(random), angle(random), angle(random)});
            chain[i].localScale = glm::vec3(scale(random));
            expected = ToParent(chain[i], expected);
        }
        const glm::vec3 point =
            glm::dmat4(chain[0].localToWorldMatrix()) * glm::dvec4(1.0, 2.0, 3.0, 1.0);
        for (int i = 0; i < 3; ++i)
        {
            const auto right = static_cast<double>(expected[static_cast<std::size_t>(i)]);
            // Two roundings to float, and quaternions that are of unit length to a float only.
            EXPECT_NEAR(point[i], right, 2e-7 * std::abs(right) + 0.5)
                << "seed 11, round " << round;
        }
    }
}

/// What a transform says that has itself among its parents.
std::string CircleError(const Transform& transform)
{
    const std::string message =
        test::ThrownMessage<ContractError>([&] { transform.localToWorldMatrix(); });
    EXPECT_EQ(test::ThrownMessage<ContractError>([&] { transform.rotation(); }), message);
    return message;
}

TEST(Transform, RefusesParentsThatGoRoundInACircle)
{
    const auto expected = test::Mentions("transform", "parents", "circle");
    for (const std::size_t tail : {0u, 1u, 2u, 3u})
    {
        for (const std::size_t circle : {1u, 2u, 3u, 4u})
        {
            std::vector<Transform> chain(tail + circle);
            for (std::size_t i = 0; i < chain.size(); ++i)
            {
                chain[i].parent = i + 1 < chain.size() ? &chain[i + 1] : &chain[tail];
            }
            EXPECT_THAT(CircleError(chain[0]), expected)
                << tail << " before a circle of " << circle;
        }
    }
}

} // namespace
} // namespace limn
