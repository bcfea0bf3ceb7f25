#pragma once

#include "library/FunctionGrid.h"

#include <glm/geometric.hpp>
#include <vector>

namespace limn::test
{

// A sun and an even sky, as the lighting tests have them.
inline const glm::dvec3 k_Sun = glm::normalize(glm::dvec3(0.3, 0.8, -0.5));
inline const glm::dvec3 k_SunColor(1.5, 1.25, 1.0);
inline const glm::dvec3 k_Sky(0.125, 0.25, 0.5);
inline constexpr double k_Mirrored = 0.375; ///< what the sky's reflection, a white cube, is times

inline std::vector<float> Floats4(const glm::dvec3& v, float w)
{
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z), w};
}

inline void SetLights(FunctionGrid& grid)
{
    grid.SetGlobal("_MainLightPosition", Floats4(k_Sun, 0.0f));
    grid.SetGlobal("_MainLightColor", Floats4(k_SunColor, 1.0f));
    grid.SetGlobal("unity_SHAr", {0, 0, 0, static_cast<float>(k_Sky.x)});
    grid.SetGlobal("unity_SHAg", {0, 0, 0, static_cast<float>(k_Sky.y)});
    grid.SetGlobal("unity_SHAb", {0, 0, 0, static_cast<float>(k_Sky.z)});
    grid.SetGlobal("unity_SpecCube0_HDR", {static_cast<float>(k_Mirrored), 1, 0, 0});
}

} // namespace limn::test
