#pragma once

#include "report/measure/Study.h"
#include "report/truth/OutlineReference.h"

#include <limn/editor_stub/AssetContext.h>
#include <limn/vulkan/VulkanDevice.h>
#include <map>

namespace limn::study
{

/// What a cell of kind Numerical may have as its variant: "" is against the technique's twin in
/// double precision (reference/twins), the others compare two pictures of the device: half of 16
/// bits, depth that is not reversed, a camera of 8 bits (what is brighter than 1 counts as 1).
const std::vector<std::string>& NumericalVariants();

/// Measures how far rounding takes techniques.
class NumericalBench
{
public:
    /// @param assets, device  must outlive this
    NumericalBench(AssetContext& assets, VulkanDevice& device) : m_Assets(assets), m_Device(device)
    {
    }

    /// A cell of kind Numerical of a shape.
    /// @throws ContractError for an unknown technique, subject or variant
    CellResult Measure(const CellId& id);

private:
    AssetContext& AssetsFor(const std::string& variant);
    Coverage Draw(const CellId& id, AssetContext& assets, bool allowHDR);

    AssetContext& m_Assets;
    VulkanDevice& m_Device;
    std::map<std::string, std::unique_ptr<AssetContext>> m_Others; ///< by variant
};

} // namespace limn::study
