// Rays against a mesh of many triangles and against many objects: building the tree, one ray, and
// the same ray against each triangle. Prints; `pick_benchmark --quick` for a smoke run.

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limn/core/Camera.h>
#include <limn/core/PrimitiveMesh.h>
#include <limn/editor_stub/AssetContext.h>
#include <limn/editor_stub/Raycast.h>
#include <random>

namespace limn::benchmarks
{

namespace
{

using Clock = std::chrono::steady_clock;

double MillisecondsSince(Clock::time_point begin)
{
    return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

/// A ball with hills, of 2 * count * count triangles.
std::shared_ptr<const Mesh> MakeBall(std::uint32_t count)
{
    MeshData data;
    for (std::uint32_t row = 0; row <= count; ++row)
    {
        for (std::uint32_t column = 0; column <= count; ++column)
        {
            const double turn = 6.283185307179586 * column / count;
            const double tilt = 3.141592653589793 * row / count;
            const double radius = 1.0 + 0.05 * std::sin(20.0 * turn) * std::sin(17.0 * tilt);
            data.vertices.emplace_back(radius * std::sin(tilt) * std::cos(turn),
                                       radius * std::cos(tilt),
                                       radius * std::sin(tilt) * std::sin(turn));
        }
    }
    for (std::uint32_t row = 0; row < count; ++row)
    {
        for (std::uint32_t column = 0; column < count; ++column)
        {
            const std::uint32_t a = row * (count + 1) + column;
            const std::uint32_t b = a + count + 1;
            data.triangles.insert(data.triangles.end(), {a, a + 1, b, b, a + 1, b + 1});
        }
    }
    return std::make_shared<const Mesh>("Ball", std::move(data));
}

/// The nearest front face, triangle by triangle.
double BruteForce(const Mesh& mesh, const Ray& ray)
{
    double nearest = std::numeric_limits<double>::infinity();
    const MeshData& data = mesh.data();
    for (std::size_t i = 0; i < data.triangles.size(); i += 3)
    {
        const glm::dvec3 a(data.vertices[data.triangles[i]]);
        const glm::dvec3 ab = glm::dvec3(data.vertices[data.triangles[i + 1]]) - a;
        const glm::dvec3 ac = glm::dvec3(data.vertices[data.triangles[i + 2]]) - a;
        const glm::dvec3 p = glm::cross(ray.direction, ac);
        const double determinant = glm::dot(ab, p);
        const glm::dvec3 from = ray.origin - a;
        const glm::dvec3 q = glm::cross(from, ab);
        const double u = glm::dot(from, p) / determinant;
        const double v = glm::dot(ray.direction, q) / determinant;
        const double t = glm::dot(ac, q) / determinant;
        // The determinant is -dot(direction, normal): more than 0 on the front.
        if (determinant > 0.0 && u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t >= 0.0)
        {
            nearest = std::min(nearest, t);
        }
    }
    return nearest;
}

std::vector<Ray> RaysOfPicture(int count)
{
    Camera camera;
    camera.transform.localPosition = {0.0f, 0.0f, -3.0f};
    std::mt19937 random(1);
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i)
    {
        rays.push_back(PixelToRay(camera, 1920, 1080, static_cast<int>(random() % 1920),
                                  static_cast<int>(random() % 1080)));
    }
    return rays;
}

void MeasureMesh(std::uint32_t side, int picks, int slowPicks)
{
    Scene scene;
    AssetContext assets;
    GameObject& object = scene.Add("Ball");
    const auto mesh = MakeBall(side);
    object.renderer = MeshRenderer{
        mesh, {std::make_shared<Material>(assets.FindShader("Universal Render Pipeline/Unlit"))}};
    Raycaster raycaster;
    Clock::time_point begin = Clock::now();
    raycaster.Raycast(scene, Ray{{0.0, 0.0, -3.0}, {0.0, 0.0, 1.0}});
    const double build = MillisecondsSince(begin);

    const std::vector<Ray> rays = RaysOfPicture(picks);
    int hits = 0;
    begin = Clock::now();
    for (const Ray& ray : rays)
    {
        hits += raycaster.Raycast(scene, ray).has_value();
    }
    const double pick = MillisecondsSince(begin) / picks;

    int different = 0;
    double slow = 0.0;
    for (int i = 0; i < slowPicks; ++i)
    {
        const Ray& ray = rays[static_cast<std::size_t>(i)];
        begin = Clock::now();
        const double expected = BruteForce(*mesh, ray);
        slow += MillisecondsSince(begin) / slowPicks;
        const auto hit = raycaster.Raycast(scene, ray);
        const double distance = hit ? hit->distance : std::numeric_limits<double>::infinity();
        different += !(distance == expected || std::abs(distance - expected) < 1e-6);
    }
    std::printf("one object of %zu triangles\n", mesh->data().triangles.size() / 3);
    std::printf("  tree and first ray  %10.1f ms\n", build);
    std::printf("  a ray               %10.4f ms  (%d rays, %d hit)\n", pick, picks, hits);
    std::printf("  each triangle       %10.3f ms  (%d rays, %d differ), %.0f times as long\n", slow,
                slowPicks, different, slow / pick);
}

void MeasureObjects(int count, int picks)
{
    Scene scene;
    AssetContext assets;
    const auto material =
        std::make_shared<Material>(assets.FindShader("Universal Render Pipeline/Unlit"));
    const auto cube = CreatePrimitive(PrimitiveType::Cube);
    std::mt19937 random(2);
    std::uniform_real_distribution<float> place(-100.0f, 100.0f);
    for (int i = 0; i < count; ++i)
    {
        GameObject& object = scene.Add("Cube");
        object.transform.localPosition = {place(random), place(random), 100.0f + place(random)};
        object.renderer = MeshRenderer{cube, {material}};
    }
    Raycaster raycaster;
    int hits = 0;
    const Clock::time_point begin = Clock::now();
    for (const Ray& ray : RaysOfPicture(picks))
    {
        hits += raycaster.Raycast(scene, ray).has_value();
    }
    std::printf("%d objects\n  a ray               %10.3f ms  (%d rays, %d hit)\n", count,
                MillisecondsSince(begin) / picks, picks, hits);
}

} // namespace

} // namespace limn::benchmarks

int main(int argc, char** argv)
{
    const bool isQuick = argc > 1 && std::strcmp(argv[1], "--quick") == 0;
    limn::benchmarks::MeasureMesh(isQuick ? 32 : 708, isQuick ? 100 : 100000, isQuick ? 10 : 50);
    limn::benchmarks::MeasureObjects(isQuick ? 100 : 100000, isQuick ? 10 : 50);
    return 0;
}
