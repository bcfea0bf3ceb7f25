#pragma once

#include <bit>
#include <limn/core/Light.h>
#include <limn/core/MaterialPropertyBlock.h>
#include <span>
#include <unordered_map>
#include <vector>

namespace limn
{

class CommandBuffer;

/// Which of a frame's additional lights shaders get for one object, where there are more than each
/// may have. Kept from frame to frame for its memory.
class ObjectLights
{
public:
    /// One bit for each light, by its index.
    using Set = std::uint32_t;
    static_assert(k_MaxVisibleAdditionalLights <= 32);

    /// Begins a camera.
    /// @param lights  those that shaders get
    /// @param limit   how many of them an object may have, 0...8
    void Begin(std::span<const Light* const> lights, int limit);

    /// Else all objects have all lights.
    bool isNeeded() const { return m_IsNeeded; }

    /// Of those that reach into a box, the brightest: by the largest channel of its linear colour
    /// times its intensity and what the distance to the nearest point of the box leaves of it; of
    /// equal ones the first. A spot that misses the ball around the box does not reach it. Unity's
    /// rule is not public.
    /// @param center, extent  of the box: world, metres
    Set Find(const glm::dvec3& center, const glm::dvec3& extent);

    /// How many they are and unity_LightIndices, in the order of the lights. The block stays where
    /// it is until the next Begin.
    const MaterialPropertyBlock& ValuesOf(Set lights);

    static Set FirstOf(int count) { return count <= 0 ? 0 : ~Set{0} >> (32 - count); }

private:
    struct Place
    {
        glm::dvec3 position;
        glm::dvec3 direction; ///< of a spot
        double intensity;     ///< of the brightest channel
        double range;         ///< metres; negative = without end
        double sine;          ///< of a spot's outer angle
        double cosine;        ///< -1 = no spot
    };
    static Place PlaceOf(const Light& light);
    static double Brightness(const Place& light, const glm::dvec3& center,
                             const glm::dvec3& extent);

    std::vector<Place> m_Lights;
    std::vector<std::pair<double, int>> m_Found; ///< brightness, negative, and index
    int m_Limit = 0;
    bool m_IsNeeded = false;
    std::unordered_map<Set, MaterialPropertyBlock> m_Values;
};

/// Whether draws of it are told their object's lights.
bool ReadsObjectLights(const ShaderProgram& program);

/// Sets what objects have that ObjectLights is not asked about.
void SetObjectLights(CommandBuffer& cmd, ObjectLights::Set lights);

} // namespace limn
