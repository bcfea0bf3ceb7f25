#include "blending/VolumeScene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <iostream>
#include <precision/RandomFloats.h>
#include <sstream>
#include <vector>

namespace limn
{

namespace
{

using test::RandomFloats;

/// A value worked out with 64 bits of mantissa, and how far floats may be off it.
struct Bounded
{
    long double value;
    long double bound = 0;

    /// The next volume of a chain: factors are floats, and so is what is kept.
    void Blend(long double target, long double factor, long double factorError)
    {
        const long double way = std::abs(target - value) + bound;
        const long double larger = std::max(std::abs(target), std::abs(value)) + bound;
        value += (target - value) * factor;
        bound = bound * (1 - factor) + way * factorError +
                0.5L * static_cast<long double>(test::Ulp(static_cast<float>(larger))) +
                0x1p-50L * larger;
    }
};

/// Eight volumes that change from frame to frame, and the same once more from the rules.
class RandomChains
{
public:
    RandomChains()
    {
        for (std::size_t i = 0; i < m_Volumes.size(); ++i)
        {
            m_Profiles[i] = test::ParamProfile(0.0f);
            m_Volumes[i] = test::GlobalVolume(m_Profiles[i]);
            m_Scene.manager.Register(&m_Volumes[i]);
            m_Order.push_back(&m_Volumes[i]);
        }
    }

    void Change()
    {
        constexpr std::array<float, 8> k_Priorities{0.0f,   -0.0f, 1.0f,      -1.0f,
                                                    1e-45f, 1e30f, -INFINITY, INFINITY};
        for (std::size_t i = 0; i < m_Volumes.size(); ++i)
        {
            Volume& volume = m_Volumes[i];
            volume.enabled = m_Random.Below(2) == 0;
            volume.isGlobal = m_Random.Below(3) == 0;
            volume.priority = k_Priorities[static_cast<std::size_t>(m_Random.Below(8))];
            volume.weight = m_Random.Share();
            volume.blendDistance = BlendDistance();
            volume.position = Eighths();
            volume.scale = Eighths();
            volume.colliders.clear();
            if (m_Random.Below(2) == 0)
            {
                volume.colliders.push_back(SphereCollider{true, {}, 1.0f});
            }
            if (m_Random.Below(3) != 0)
            {
                volume.colliders.push_back(BoxCollider{true, {}, glm::vec3(2.0f)});
            }
            Target(i).Override(m_Random.Any() * 0.25f); // sums stay finite
        }
        m_Trigger = Eighths();
    }

    float Blended()
    {
        m_Scene.Update(m_Trigger);
        return m_Scene.Param();
    }

    Bounded Exact()
    {
        // Volumes of one priority keep the order that they had.
        std::ranges::stable_sort(m_Order, {}, [](const Volume* v) { return v->priority; });
        Bounded result{123.0L};
        for (const Volume* volume : m_Order)
        {
            const long double weight = std::min(volume->weight, 1.0f);
            const long double fade = volume->isGlobal ? 1.0L : Fade(*volume);
            if (volume->enabled && weight > 0 && fade >= 0)
            {
                // A fade is a double near 1 or 0, a factor is rounded to a float.
                result.Blend(
                    static_cast<long double>(
                        Target(static_cast<std::size_t>(volume - m_Volumes.data())).value()),
                    fade * weight, 0x1p-24L * fade * weight + 0x1p-51L * weight + 0x1p-149L);
                ++m_Steps;
            }
        }
        return result;
    }

    int steps() const { return m_Steps; }

private:
    /// Multiples of an eighth within 16 m: where distances are exact, and often 0 or equal to the
    /// blend distance.
    glm::vec3 Eighths()
    {
        const auto next = [this]
        {
            return static_cast<float>(m_Random.Below(257) - 128) / 8.0f;
        };
        return {next(), next(), next()};
    }

    float BlendDistance()
    {
        constexpr std::array<float, 6> k_Distances{0.0f, 1e-6f, 4.0f, 1e4f, 1e-45f, INFINITY};
        const int kind = m_Random.Below(12);
        return kind < 6 ? k_Distances[static_cast<std::size_t>(kind)]
                        : static_cast<float>(m_Random.Below(200)) / 8.0f;
    }

    FloatParameter& Target(std::size_t index)
    {
        return m_Profiles[index]->TryGet<test::TestVolume>()->param;
    }

    /// Below 0 where the volume takes no part.
    long double Fade(const Volume& volume) const
    {
        long double square = INFINITY;
        for (const Collider& collider : volume.colliders)
        {
            const auto* sphere = std::get_if<SphereCollider>(&collider);
            square = std::min(square, sphere ? SphereSquare(volume) : BoxSquare(volume));
        }
        const auto reach = static_cast<long double>(volume.blendDistance);
        if (square > reach * reach || std::isinf(square))
        {
            return -1;
        }
        return reach > 0 ? 1 - square / (reach * reach) : 1.0L;
    }

    /// From a ball of the largest scale's radius.
    long double SphereSquare(const Volume& volume) const
    {
        const auto p = m_Trigger - volume.position; // eighths
        const long double radius = std::max(
            {std::abs(volume.scale.x), std::abs(volume.scale.y), std::abs(volume.scale.z)});
        const long double middle =
            std::sqrt(static_cast<long double>(p.x * p.x + p.y * p.y + p.z * p.z));
        const long double outside = std::max(middle - radius, 0.0L);
        return outside * outside;
    }

    long double BoxSquare(const Volume& volume) const
    {
        long double square = 0;
        for (int i = 0; i < 3; ++i)
        {
            const float outside = std::max(
                std::abs(m_Trigger[i] - volume.position[i]) - std::abs(volume.scale[i]), 0.0f);
            square += static_cast<long double>(outside) * static_cast<long double>(outside);
        }
        return square;
    }

    RandomFloats m_Random{21};
    test::VolumeScene m_Scene;
    std::array<std::shared_ptr<VolumeProfile>, 8> m_Profiles;
    std::array<Volume, 8> m_Volumes;
    std::vector<const Volume*> m_Order;
    glm::vec3 m_Trigger{0.0f};
    int m_Steps = 0;
};

TEST(BlendPrecision, ChainsOfVolumesAreTheExactChainButForARoundingAStep)
{
    constexpr int k_Chains = 12'000;
    RandomChains chains;
    long double largest = 0;
    for (int i = 0; i < k_Chains; ++i)
    {
        chains.Change();
        const Bounded exact = chains.Exact();
        const auto blended = static_cast<long double>(chains.Blended());
        const long double error = std::abs(blended - exact.value);
        ASSERT_LE(error, exact.bound) << "chain " << i << ": " << blended << " for " << exact.value;
        largest = std::max(largest, exact.bound > 0 ? error / exact.bound : 0);
    }
    std::cout << chains.steps() << " steps of " << k_Chains << " chains: up to " << largest
              << " of what roundings explain\n";
}

} // namespace

} // namespace limn
