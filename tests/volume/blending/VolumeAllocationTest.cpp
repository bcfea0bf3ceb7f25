#include "blending/VolumeScene.h"

#include <cstdlib>
#include <gtest/gtest.h>
#include <limn/core/PrimitiveMesh.h>
#include <limn/volume/CurveParameters.h>
#include <new>

namespace
{

std::size_t g_Allocations = 0;

} // namespace

void* operator new(std::size_t size)
{
    ++g_Allocations;
    if (void* memory = std::malloc(size == 0 ? 1 : size))
    {
        return memory;
    }
    throw std::bad_alloc();
}

// Replaced as well, or a sanitizer's own version would meet the operator delete below.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept
{
    ++g_Allocations;
    return std::malloc(size == 0 ? 1 : size);
}

void operator delete(void* memory) noexcept
{
    std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept
{
    std::free(memory);
}

namespace limn
{

namespace
{

TEST(VolumeManager, AllocatesNothingInASteadyUpdate)
{
    test::VolumeScene scene;
    std::vector<Volume> volumes(50, test::GlobalVolume(test::ParamProfile(456.0f)));
    for (std::size_t i = 0; i < volumes.size(); ++i)
    {
        volumes[i].isGlobal = i % 2 == 0;
        volumes[i].colliders = {BoxCollider{}, SphereCollider{}, CapsuleCollider{},
                                MeshCollider(CreatePrimitive(PrimitiveType::Cube))};
        scene.manager.Register(&volumes[i]);
    }
    scene.manager.SetGlobalDefaultProfile(test::ParamProfile(1.0f));
    scene.Update();

    const std::size_t before = g_Allocations;
    volumes[3].priority = 8.0f;
    scene.Update();
    scene.Update(glm::vec3(0.25f, 0.0f, 0.0f));
    EXPECT_EQ(g_Allocations - before, 0u);
    EXPECT_EQ(scene.Param(), 456.0f);
    EXPECT_GT(before, 0u); // the counter counts
}

class Curved : public VolumeComponent
{
public:
    AnimationCurveParameter curve{this, "curve", AnimationCurve({{0, 1}})};
};

TEST(VolumeManager, AllocatesNothingWhereASteadyUpdateBlendsCurves)
{
    VolumeComponentRegistry registry;
    registry.Register<Curved>("Curved");
    VolumeManager manager(registry);
    VolumeStack stack = manager.CreateStack();
    std::vector<Volume> volumes;
    for (int i = 0; i < 10; ++i)
    {
        auto profile = std::make_shared<VolumeProfile>();
        const auto time = static_cast<float>(i);
        profile->Add<Curved>().curve.Override(AnimationCurve({{time, 1}, {time + 0.5f, 2}}));
        volumes.push_back(test::GlobalVolume(profile, time));
        volumes.back().weight = 0.5f;
    }
    for (const Volume& volume : volumes)
    {
        manager.Register(&volume);
    }
    manager.Update(stack, std::nullopt, test::k_DefaultLayer);
    const std::size_t before = g_Allocations;
    manager.Update(stack, std::nullopt, test::k_DefaultLayer);
    EXPECT_EQ(g_Allocations - before, 0u);
    EXPECT_EQ(20, stack.GetComponent<Curved>()->curve.value().length()); // it does blend
}

} // namespace

} // namespace limn
