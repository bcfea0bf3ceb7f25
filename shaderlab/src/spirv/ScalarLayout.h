#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace limn
{

/// The name of the missing feature of a device that cannot read such buffers; it extends the names
/// of `#pragma require`.
inline constexpr const char* k_ScalarLayoutFeature = "scalarblocklayout";

/// Returns the names of a program's structured buffers, "_Points, _Lines", whose elements are
/// packed more tightly than a device without scalarBlockLayout can read. Direct3D packs them so,
/// see PackStructuredBuffers.
std::string ScalarBuffers(const std::vector<std::uint32_t>& spirv);

} // namespace limn
