#pragma once

#include <limn/core/Light.h>
#include <limn/core/MaterialPropertyBlock.h>
#include <span>
#include <unordered_map>
#include <vector>

namespace limn
{

class CommandBuffer;

/// Chooses the additional lights of a frame that shaders get for one object, if there are more than
/// each may have. It is kept from frame to frame for its memory.
class ObjectLights
{
public:
    /// A set of lights with one bit for each, by its index.
    using Set = std::uint32_t;
    static_assert(k_MaxVisibleAdditionalLights <= 32);

    /// Begins a camera.
    /// @param lights  the lights that shaders get
    /// @param limit   the number of them that an object may have, 0...8
    void Begin(std::span<const Light* const> lights, int limit);

    /// Returns whether lights must be chosen; else all objects have all lights.
    bool isNeeded() const { return m_IsNeeded; }

    /// Returns the brightest of the lights that reach into a box. The brightness is the largest
    /// channel of a light's linear colour times its intensity and its attenuation at the nearest
    /// point of the box; of equal ones the first is chosen. A spot light that misses the ball
    /// around the box does not reach it. Unity's rule is not public.
    /// @param center, extent  of the box: world, metres
    Set Find(const glm::dvec3& center, const glm::dvec3& extent);

    /// Returns their number and unity_LightIndices, in the order of the lights. The block stays in
    /// its place until the next Begin.
    const MaterialPropertyBlock& ValuesOf(Set lights);

    static Set FirstOf(int count) { return count <= 0 ? 0 : ~Set{0} >> (32 - count); }

private:
    struct Place
    {
        glm::dvec3 position;
        glm::dvec3 direction; ///< of a spot light
        double intensity;     ///< of the brightest channel
        double range;         ///< metres; negative = without end
        double sine;          ///< of a spot light's outer angle
        double cosine;        ///< -1 = no spot
    };
    static Place PlaceOf(const Light& light);
    static double Brightness(const Place& light, const glm::dvec3& center,
                             const glm::dvec3& extent);

    std::vector<Place> m_Lights;
    std::vector<std::pair<double, int>> m_Found; ///< negative brightness, and index
    int m_Limit = 0;
    bool m_IsNeeded = false;
    std::unordered_map<Set, MaterialPropertyBlock> m_Values;
};

/// Returns whether draws of the program get their object's lights.
bool ReadsObjectLights(const ShaderProgram& program);

/// Sets the lights of objects for which ObjectLights is not asked.
void SetObjectLights(CommandBuffer& cmd, ObjectLights::Set lights);

} // namespace limn
