#include "selection/SelectionScene.h"

#include <gtest/gtest.h>
#include <limn/editor_stub/Raycast.h>
#include <random>

namespace limn::test
{

namespace
{

using Random = std::mt19937;

double Uniform(Random& random, double from, double to)
{
    return std::uniform_real_distribution<double>(from, to)(random);
}

glm::dvec3 Direction(Random& random)
{
    std::normal_distribution<double> normal;
    return glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
}

/// Triangles anywhere in a ball around `center`, in two sub-meshes.
std::shared_ptr<const Mesh> RandomMesh(Random& random, int triangles, double radius,
                                       const glm::dvec3& center)
{
    MeshData data;
    for (int i = 0; i < triangles; ++i)
    {
        const glm::dvec3 place = Direction(random) * Uniform(random, 0.0, 1.0);
        for (int corner = 0; corner < 3; ++corner)
        {
            const glm::dvec3 offset = Direction(random) * Uniform(random, 0.05, 0.6);
            data.vertices.emplace_back(center + (place + offset) * radius);
            data.triangles.push_back(static_cast<std::uint32_t>(3 * i + corner));
        }
    }
    const auto count = static_cast<std::uint32_t>(3 * triangles);
    const std::uint32_t half = 3 * (static_cast<std::uint32_t>(triangles) / 2);
    data.subMeshes = {{0, half}, {half, count - half}};
    return std::make_shared<const Mesh>("Random", std::move(data));
}

/// What the slow way gives.
struct Slow
{
    const GameObject* object = nullptr;
    int triangle = -1;
    double distance = std::numeric_limits<double>::infinity();
};

/// How far inside the triangle's edges a ray from 0 passes, as a part of its size; negative
/// outside.
double Inside(const glm::dvec3 (&corners)[3], const glm::dvec3& direction)
{
    // Signs of the volumes that the ray spans with each edge.
    double volumes[3];
    for (int i = 0; i < 3; ++i)
    {
        volumes[i] = glm::dot(direction, glm::cross(corners[i], corners[(i + 1) % 3]));
    }
    const double sum = volumes[0] + volumes[1] + volumes[2];
    return std::min({volumes[0] / sum, volumes[1] / sum, volumes[2] / sum});
}

/// The nearest front face of all triangles of a scene whose edges the ray passes at `margin`.
Slow BruteForce(const Scene& scene, const Ray& ray, double margin)
{
    Slow nearest;
    for (const auto& object : scene.objects())
    {
        glm::dmat4 world = object->transform.worldMatrix();
        world[3] -= glm::dvec4(ray.origin, 0.0);
        const double mirror = glm::determinant(glm::dmat3(world)) < 0.0 ? -1.0 : 1.0;
        const MeshData& data = object->renderer->mesh->data();
        for (std::size_t i = 0; i < data.triangles.size(); i += 3)
        {
            glm::dvec3 corners[3];
            for (std::size_t j = 0; j < 3; ++j)
            {
                corners[j] = glm::dvec3(
                    world * glm::dvec4(glm::dvec3(data.vertices[data.triangles[i + j]]), 1.0));
            }
            const glm::dvec3 normal =
                mirror * glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
            const double facing = glm::dot(normal, ray.direction);
            const double distance = glm::dot(normal, corners[0]) / facing;
            if (facing < 0.0 && distance >= 0.0 && distance < nearest.distance &&
                Inside(corners, ray.direction) >= margin)
            {
                nearest = {object.get(), static_cast<int>(i / 3), distance};
            }
        }
    }
    return nearest;
}

struct World
{
    const char* name;
    double meshRadius;    ///< in its own space
    double meshCenter;    ///< how far from its own origin, in radii
    double scale;         ///< of objects
    double place;         ///< of the world's middle, metres
    double margin = 1e-5; ///< at which rays are not asked about
};

void PrintTo(const World& world, std::ostream* stream)
{
    *stream << world.name;
}

class RandomWorlds : public testing::TestWithParam<World>
{
};

} // namespace

// Rays that pass an edge at less than the margin are left out: there floats may see either side.
TEST_P(RandomWorlds, GiveWhatTheSlowWayGives)
{
    const World& world = GetParam();
    Random random(7);
    SelectionScene content;
    const double size = world.meshRadius * world.scale;
    for (int i = 0; i < 12; ++i)
    {
        const glm::dvec3 center = Direction(random) * world.meshCenter * world.meshRadius;
        GameObject& object =
            content.Add("Mesh " + std::to_string(i),
                        RandomMesh(random, 40, world.meshRadius, center), glm::vec3(0.0f));
        object.renderer->sharedMaterials.push_back(content.material);
        Transform& transform = object.transform;
        transform.localRotation = EulerToRotation(glm::vec3(Direction(random) * 180.0));
        transform.localScale =
            glm::vec3(glm::dvec3(Uniform(random, 0.3, 1.5), Uniform(random, 0.3, 1.5),
                                 Uniform(random, 0.3, 1.5) * (i % 3 == 0 ? -1.0 : 1.0)) *
                      world.scale);
        const glm::dvec3 middle = glm::dvec3(world.place) +
                                  Direction(random) * Uniform(random, 0.0, 4.0) * size -
                                  glm::dmat3(transform.worldMatrix()) * center;
        transform.localPosition = glm::vec3(middle);
    }
    Raycaster raycaster;
    int hits = 0;
    int asked = 0;
    for (int i = 0; i < 600; ++i)
    {
        Ray ray;
        ray.origin =
            glm::dvec3(world.place) + Direction(random) * Uniform(random, 1.0, 30.0) * size;
        const glm::dvec3 aim =
            glm::dvec3(world.place) + Direction(random) * Uniform(random, 0.0, 4.0) * size;
        ray.direction = glm::normalize(aim - ray.origin);
        const Slow strict = BruteForce(content.scene, ray, world.margin);
        const Slow loose = BruteForce(content.scene, ray, -world.margin);
        if (strict.object != loose.object || strict.triangle != loose.triangle)
        {
            continue;
        }
        ++asked;
        const std::optional<RaycastHit> hit = raycaster.Raycast(content.scene, ray);
        ASSERT_EQ(strict.object != nullptr, hit.has_value()) << "ray " << i;
        if (hit)
        {
            ++hits;
            EXPECT_EQ(strict.object, hit->gameObject) << "ray " << i;
            EXPECT_EQ(strict.triangle, hit->triangleIndex) << "ray " << i;
            EXPECT_EQ(strict.triangle / 20, hit->subMesh) << "ray " << i;
            EXPECT_NEAR(strict.distance, hit->distance, 1e-9 * std::max(size, strict.distance));
            const glm::dvec3 point = ray.origin + strict.distance * ray.direction;
            EXPECT_LE(glm::length(point - hit->point), 1e-9 * (size + glm::length(point)));
        }
    }
    EXPECT_GT(asked, 550);
    EXPECT_GT(hits, 60);
    EXPECT_LT(hits, asked - 60);
}

INSTANTIATE_TEST_SUITE_P(Raycaster, RandomWorlds,
                         testing::Values(World{"Plain", 1.0, 0.0, 1.0, 0.0},
                                         World{"Tiny", 1e-20, 0.0, 1e-3, 0.0},
                                         World{"Huge", 1e15, 0.0, 1e3, 0.0},
                                         World{"FarAway", 1.0, 0.0, 1.0, 3e6},
                                         World{"FarFromItsOwnOrigin", 1.0, 1e5, 1.0, 0.0},
                                         World{"SmallMeshBigScale", 1e-6, 0.0, 1e6, 1e3}));

namespace
{

/// What a ray along +z from the origin hits; "" for nothing.
std::string NameAhead(const SelectionScene& content, const RaycastSettings& settings = {})
{
    const auto hit = Raycaster().Raycast(content.scene, Ray{}, settings);
    return hit ? hit->gameObject->name : "";
}

} // namespace

TEST(Raycaster, HitsWhatIsNearest)
{
    SelectionScene content;
    content.AddCube("Far", {0.0f, 0.0f, 9.0f});
    content.AddCube("Near", {0.0f, 0.0f, 5.0f});
    content.AddCube("Middle", {0.0f, 0.0f, 7.0f});
    content.AddCube("Aside", {3.0f, 0.0f, 3.0f});
    content.AddCube("Behind", {0.0f, 0.0f, -3.0f});
    const auto hit = Raycaster().Raycast(content.scene, Ray{});
    ASSERT_TRUE(hit);
    EXPECT_EQ("Near", hit->gameObject->name);
    EXPECT_EQ(4.5, hit->distance);
    EXPECT_EQ(glm::dvec3(0.0, 0.0, 4.5), hit->point);
}

TEST(Raycaster, OfEquallyNearObjectsHitsTheFirst)
{
    SelectionScene content;
    content.AddCube("First", {0.1f, 0.1f, 5.0f});
    content.AddCube("Second", {0.1f, 0.1f, 5.0f});
    EXPECT_EQ("First", NameAhead(content));
}

TEST(Raycaster, PassesThroughWhatIsNotDrawn)
{
    SelectionScene content;
    content.AddCube("Inactive", {0.1f, 0.1f, 2.0f}).activeSelf = false;
    content.AddCube("Disabled", {0.1f, 0.1f, 3.0f}).renderer->enabled = false;
    content.AddCube("No material", {0.1f, 0.1f, 4.0f}).renderer->sharedMaterials = {};
    content.AddCube("Null material", {0.1f, 0.1f, 5.0f}).renderer->sharedMaterials = {nullptr};
    content.AddCube("No mesh", {0.1f, 0.1f, 6.0f}).renderer->mesh = nullptr;
    content.Add("No renderer", nullptr, {0.1f, 0.1f, 7.0f});
    content.AddCube("Drawn", {0.1f, 0.1f, 8.0f});
    EXPECT_EQ("Drawn", NameAhead(content));
}

TEST(Raycaster, PassesThroughOtherLayersAndQueues)
{
    SelectionScene content;
    content.AddCube("Glass", {0.1f, 0.1f, 3.0f}).layer = 4;
    GameObject& smoke = content.AddCube("Smoke", {0.1f, 0.1f, 5.0f});
    const auto translucent = SelectionScene::NewMaterial();
    translucent->SetRenderQueue(3000);
    smoke.renderer->sharedMaterials = {translucent};
    content.AddCube("Wall", {0.1f, 0.1f, 7.0f});
    RaycastSettings settings;
    EXPECT_EQ("Glass", NameAhead(content, settings));
    settings.layerMask = ~LayerMask::FromIndex(4);
    EXPECT_EQ("Smoke", NameAhead(content, settings));
    settings.renderQueueRange = RenderQueueRange::opaque;
    EXPECT_EQ("Wall", NameAhead(content, settings));
    settings.maxDistance = 6.4;
    EXPECT_EQ("", NameAhead(content, settings));
    settings.maxDistance = 6.5;
    EXPECT_EQ("Wall", NameAhead(content, settings));
}

TEST(Raycaster, HitsTheSidesItIsToldTo)
{
    const auto quad = SelectionScene::Assets().Primitive(PrimitiveType::Quad); // faces -z
    for (const float mirror : {1.0f, -1.0f})
    {
        SelectionScene content;
        content.Add("Front", quad, {0.1f, 0.1f, 4.0f}, {1.0f, 1.0f, 1.0f});
        GameObject& back = content.Add("Back", quad, {0.1f, 0.1f, 3.0f}, {mirror, 1.0f, 1.0f});
        back.transform.localRotation = EulerToRotation({0.0f, 180.0f, 0.0f});
        EXPECT_EQ("Front", NameAhead(content));
        EXPECT_EQ("Back", NameAhead(content, {.faces = RaycastFaces::Back}));
        EXPECT_EQ("Back", NameAhead(content, {.faces = RaycastFaces::Both}));
    }
}

TEST(Raycaster, HitsFlattenedObjects)
{
    SelectionScene content;
    GameObject& disc =
        content.Add("Disc", SelectionScene::Assets().Primitive(PrimitiveType::Sphere),
                    {0.1f, 0.1f, 4.0f}, {2.0f, 2.0f, 0.0f});
    const auto hit = Raycaster().Raycast(content.scene, Ray{});
    ASSERT_TRUE(hit);
    EXPECT_EQ(&disc, hit->gameObject);
    EXPECT_DOUBLE_EQ(4.0, hit->distance);
    disc.transform.localScale = {0.0f, 0.0f, 0.0f};
    EXPECT_EQ("", NameAhead(content));
}

TEST(Raycaster, FollowsObjectsThatMoveAndMeshesThatGo)
{
    SelectionScene content;
    Raycaster raycaster;
    GameObject& cube = content.AddCube("Cube", {0.1f, 0.1f, 4.0f});
    EXPECT_TRUE(raycaster.Raycast(content.scene, Ray{}));
    cube.transform.localPosition.x = 2.0f;
    EXPECT_FALSE(raycaster.Raycast(content.scene, Ray{}));
    for (int i = 0; i < 3; ++i)
    {
        cube.renderer->mesh = CreatePrimitive(PrimitiveType::Quad);
        cube.transform.localPosition.x = 0.1f;
        const auto hit = raycaster.Raycast(content.scene, Ray{});
        ASSERT_TRUE(hit);
        EXPECT_DOUBLE_EQ(4.0, hit->distance);
    }
}

TEST(Raycaster, RefusesBrokenRays)
{
    SelectionScene content;
    Raycaster raycaster;
    EXPECT_THROW(raycaster.Raycast(content.scene, {glm::dvec3(0.0), glm::dvec3(0.0)}),
                 ContractError);
    EXPECT_THROW(raycaster.Raycast(content.scene, {glm::dvec3(0.0), {0.0, 0.0, 2.0}}),
                 ContractError);
    EXPECT_THROW(raycaster.Raycast(content.scene, {glm::dvec3(std::nan("")), {0.0, 0.0, 1.0}}),
                 ContractError);
}

} // namespace limn::test
