#pragma once

#include <array>
#include <limn/core/Inspector.h>

namespace limn
{

// What scene files may say, for the reader and for the schema.

/// Metres.
inline constexpr double k_MaxDistance = 1e9;
inline constexpr ValueRange k_Lengths{0.0, k_MaxDistance};
inline constexpr ValueRange k_Places{-k_MaxDistance, k_MaxDistance}; ///< of the camera
inline constexpr ValueRange k_ClipPlanes{-k_MaxDistance, k_MaxDistance};
inline constexpr ValueRange k_OrthographicSizes{1e-4, k_MaxDistance};
/// Unity's inspector offers up to 179 degrees; 0 would make a picture of nothing.
inline constexpr ValueRange k_FieldsOfView{0.01, 179.0};
inline constexpr ValueRange k_Intensities{0.0, 1e6};
inline constexpr ValueRange k_Weights{0.0, 1.0};
inline constexpr ValueRange k_PictureSizes{1.0, 16384.0}; ///< pixels, of a side

inline constexpr EnumEntry k_ClearFlags[] = {
    {"Skybox", 1}, {"SolidColor", 2}, {"Depth", 3}, {"Nothing", 4}};
inline constexpr std::array<std::string_view, 4> k_ColliderTypes{"box", "sphere", "capsule",
                                                                 "mesh"};

} // namespace limn
