#pragma once

namespace limn
{

/// Metres; lengths in scene files are refused beyond it.
inline constexpr double k_MaxDistance = 1e9;

} // namespace limn
