#include "VolumeScene.h"

#include <cstdlib>
#include <gtest/gtest.h>
#include <limn/core/PrimitiveMesh.h>
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

} // namespace

} // namespace limn
