#include "blending/VolumeScene.h"

#include <algorithm>
#include <functional>
#include <gtest/gtest.h>
#include <optional>
#include <utility>

namespace limn
{

namespace
{

using test::VolumeScene;

/// 100 registered volumes with priorities by index.
struct ManyVolumes : VolumeScene
{
    explicit ManyVolumes(const std::function<float(int)>& priority)
    {
        for (int i = 0; i < 100; ++i)
        {
            volumes[static_cast<std::size_t>(i)].priority = priority(i);
            manager.Register(&volumes[static_cast<std::size_t>(i)]);
        }
    }

    bool IsSorted()
    {
        const std::span<const Volume* const> sorted = manager.GetVolumes(test::k_DefaultLayer);
        return sorted.size() == volumes.size() &&
               std::is_sorted(sorted.begin(), sorted.end(),
                              [](const Volume* a, const Volume* b)
                              { return a->priority < b->priority; });
    }

    std::vector<Volume> volumes = std::vector<Volume>(100);
};

float At(int i)
{
    return static_cast<float>(i);
}

const std::vector<std::function<float(int)>>& Priorities()
{
    static const std::vector<std::function<float(int)>> priorities{
        [](int) { return 5.0f; },
        [](int i) { return At(i); },
        [](int i) { return -At(i); },
        [](int i) { return At(i % 5); },
        [](int i) { return At(i % 2); },
        [](int i) { return At(i % 3); },
        [](int i) { return At(i) - 5.0f; },
        [](int i) { return At(i) / 3.0f; },
        [](int i)
        {
            return At(i * 1000);
        }};
    return priorities;
}

TEST(VolumeCollection, CountsAVolumeOnceHoweverOftenItIsRegistered)
{
    VolumeScene scene;
    const Volume volume;
    EXPECT_TRUE(scene.manager.Register(&volume));
    EXPECT_FALSE(scene.manager.Register(&volume));
    EXPECT_EQ(scene.manager.GetVolumes(test::k_DefaultLayer).size(), 1u);
    scene.manager.Unregister(&volume);
    EXPECT_EQ(scene.manager.GetVolumes(test::k_DefaultLayer).size(), 0u);
    scene.manager.Unregister(&volume);
    EXPECT_TRUE(scene.manager.Register(&volume));
}

TEST(VolumeCollection, GivesTheVolumesWhoseLayerIsInTheMask)
{
    VolumeScene scene;
    Volume five;
    five.layer = 5;
    Volume seven;
    seven.layer = 7;
    scene.manager.Register(&five);
    const auto count = [&scene](std::uint32_t bits)
    {
        return scene.manager.GetVolumes(LayerMask(bits)).size();
    };
    EXPECT_EQ(count(1u), 0u);
    EXPECT_EQ(count(1u << 5), 1u);
    EXPECT_EQ(count(0xFFFFFFFFu), 1u);

    scene.manager.Register(&seven); // every list exists by now
    EXPECT_EQ(count(1u), 0u);
    EXPECT_EQ(count(1u << 5), 1u);
    EXPECT_EQ(count((1u << 5) | (1u << 7)), 2u);
    EXPECT_EQ(count(0xFFFFFFFFu), 2u);
}

TEST(VolumeCollection, SortsByPriority)
{
    for (std::size_t i = 0; i < Priorities().size(); ++i)
    {
        ManyVolumes many(Priorities()[i]);
        EXPECT_TRUE(many.IsSorted()) << "priorities " << i;
    }
}

TEST(VolumeCollection, SortsAgainAfterAChangeOfPriority)
{
    for (std::size_t i = 0; i < Priorities().size(); ++i)
    {
        ManyVolumes many(Priorities()[i]);
        EXPECT_TRUE(many.IsSorted()) << "priorities " << i;
        std::swap(many.volumes[1].priority, many.volumes[8].priority);
        EXPECT_TRUE(many.IsSorted()) << "priorities " << i;
    }
}

TEST(VolumeCollection, KeepsTheOrderOfRegistrationAmongEqualPriorities)
{
    ManyVolumes many([](int i) { return At(i % 5); });
    const std::span<const Volume* const> sorted = many.manager.GetVolumes(test::k_DefaultLayer);
    ASSERT_EQ(sorted.size(), 100u);
    for (std::size_t i = 1; i < sorted.size(); ++i)
    {
        if (sorted[i - 1]->priority == sorted[i]->priority)
        {
            EXPECT_LT(sorted[i - 1], sorted[i]); // one array, so addresses follow registration
        }
    }
}

TEST(VolumeCollection, MovesAVolumeWithItsLayer)
{
    VolumeScene scene;
    Volume volume;
    scene.manager.Register(&volume);
    for (int layer = 0; layer < 32; ++layer)
    {
        volume.layer = layer;
        for (int asked = 0; asked < 32; ++asked)
        {
            EXPECT_EQ(scene.manager.GetVolumes(LayerMask::FromIndex(asked)).size(),
                      asked == layer ? 1u : 0u);
        }
    }
}

TEST(VolumeCollection, MovesManyVolumesAtOnce)
{
    ManyVolumes many(At);
    const LayerMask one = LayerMask::FromIndex(1);
    const LayerMask five = LayerMask::FromIndex(5);
    for (std::size_t i = 0; i < many.volumes.size(); i += 2)
    {
        many.volumes[i].layer = 1;
    }
    EXPECT_EQ(many.manager.GetVolumes(test::k_DefaultLayer).size(), 50u);
    EXPECT_EQ(many.manager.GetVolumes(one).size(), 50u);
    for (Volume& volume : many.volumes)
    {
        volume.layer = 5;
    }
    EXPECT_EQ(many.manager.GetVolumes(five).size(), 100u);
    EXPECT_EQ(many.manager.GetVolumes(one).size(), 0u);
    EXPECT_EQ(many.manager.GetVolumes(test::k_DefaultLayer | one).size(), 0u);
}

TEST(VolumeCollection, PutsAVolumeLastWhenItComesBackToItsLayer)
{
    VolumeScene scene;
    Volume first;
    const Volume second;
    scene.manager.Register(&first);
    scene.manager.Register(&second);
    EXPECT_EQ(scene.manager.GetVolumes(test::k_DefaultLayer).front(), &first);
    first.layer = 3;
    EXPECT_EQ(scene.manager.GetVolumes(LayerMask::FromIndex(3)).size(), 1u);
    first.layer = 0;
    EXPECT_EQ(scene.manager.GetVolumes(test::k_DefaultLayer).back(), &first);
}

TEST(VolumeCollection, ForgetsAVolumeWhoseLayerChangedJustBeforeItWasUnregistered)
{
    VolumeScene scene;
    Volume volume;
    scene.manager.Register(&volume);
    EXPECT_EQ(scene.manager.GetVolumes(test::k_DefaultLayer).size(), 1u);
    volume.layer = 4;
    scene.manager.Unregister(&volume); // Unity leaves it in the old layer's list
    EXPECT_EQ(scene.manager.GetVolumes(test::k_DefaultLayer).size(), 0u);
}

TEST(VolumeCollection, FollowsVolumesWhoseVectorGrowsAndForgetsThoseErased)
{
    VolumeScene scene;
    std::vector<Volume> volumes;
    volumes.reserve(1);
    for (int i = 0; i < 10; ++i)
    {
        volumes.emplace_back().priority = At(i);
        EXPECT_TRUE(scene.manager.Register(&volumes.back()));
        EXPECT_EQ(scene.manager.GetVolumes(test::k_DefaultLayer).size(), volumes.size());
    }
    const auto expectAll = [&]
    {
        const auto known = scene.manager.GetVolumes(test::k_DefaultLayer);
        ASSERT_EQ(known.size(), volumes.size());
        for (std::size_t i = 0; i < known.size(); ++i)
        {
            EXPECT_EQ(known[i], &volumes[i]);
        }
    };
    volumes.reserve(volumes.capacity() + 1);
    expectAll();
    volumes.erase(volumes.begin() + 3); // each behind it moves to where another was
    expectAll();
    volumes.insert(volumes.begin(), Volume());
    EXPECT_TRUE(scene.manager.Register(&volumes.front()));
    EXPECT_FALSE(scene.manager.Register(&volumes.back())) << "still registered";
    volumes.front().priority = -1.0f;
    expectAll();
    volumes.clear();
    expectAll();
}

TEST(VolumeCollection, KnowsNoCopyOfAVolumeAndNoVolumeAtTheAddressOfOneThatIsGone)
{
    VolumeScene scene;
    std::optional<Volume> volume(std::in_place);
    EXPECT_TRUE(scene.manager.Register(&*volume));
    const Volume copy = *volume;
    EXPECT_EQ(scene.manager.GetVolumes(test::k_DefaultLayer).size(), 1u);
    volume.emplace(test::GlobalVolume(test::ParamProfile(1.0f)));
    EXPECT_EQ(scene.manager.GetVolumes(test::k_DefaultLayer).size(), 0u);
    EXPECT_TRUE(scene.manager.Register(&*volume));
    EXPECT_TRUE(scene.manager.IsComponentActiveInMask<test::TestVolume>(test::k_DefaultLayer));
    volume.reset();
    EXPECT_FALSE(scene.manager.IsComponentActiveInMask<test::TestVolume>(test::k_DefaultLayer));
}

TEST(VolumeCollection, MayBeGoneBeforeItsVolumes)
{
    Volume volume;
    {
        VolumeScene first;
        VolumeScene second;
        EXPECT_TRUE(first.manager.Register(&volume));
        EXPECT_TRUE(second.manager.Register(&volume));
        const Volume moved = std::move(volume);
        EXPECT_EQ(first.manager.GetVolumes(test::k_DefaultLayer).front(), &moved);
        EXPECT_EQ(second.manager.GetVolumes(test::k_DefaultLayer).front(), &moved);
        EXPECT_EQ(first.manager.GetVolumes(LayerMask::FromIndex(1)).size(), 0u);
    }
    volume = Volume();
    VolumeScene third;
    EXPECT_TRUE(third.manager.Register(&volume));
}

} // namespace

} // namespace limn
