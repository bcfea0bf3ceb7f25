#pragma once

#include "report/measure/Study.h"
#include "report/measure/StudyPicture.h"
#include "report/measure/StudyScene.h"
#include "report/truth/OutlineReference.h"

#include <limn/editor_stub/AssetContext.h>
#include <limn/vulkan/VulkanDevice.h>
#include <map>
#include <memory>
#include <span>

namespace limn::study
{

/// Returns the variants that a cell of kind Numerical may have. "" compares with the technique's
/// twin in double precision (reference/twins). The others compare two pictures of the device: half
/// of 16 bits, depth that is not reversed, a camera of 8 bits (a value above 1 counts as 1).
const std::vector<std::string>& NumericalVariants();

/// Measures the errors of techniques by rounding.
class NumericalBench
{
public:
    /// @param assets, device  must outlive this
    NumericalBench(AssetContext& assets, VulkanDevice& device) : m_Assets(assets), m_Device(device)
    {
    }

    /// Measures a cell of kind Numerical of a shape.
    /// @throws ContractError for an unknown technique, subject or variant
    CellResult Measure(const CellId& id);

private:
    AssetContext& AssetsFor(const std::string& variant);
    Coverage Draw(const CellId& id, AssetContext& assets, bool allowHDR);

    AssetContext& m_Assets;
    VulkanDevice& m_Device;
    std::map<std::string, std::unique_ptr<AssetContext>> m_Others; ///< by variant
};

/// Measures cells, one after the other, on one device.
class StudyBench
{
public:
    /// @param scene   the file of the subject "scene"
    /// @param folder  the study's folder, below which pictures are written; "" writes none
    /// @param assets, device  must outlive this
    StudyBench(std::filesystem::path scene, std::filesystem::path folder, AssetContext& assets,
               VulkanDevice& device);
    ~StudyBench();

    /// Measures a cell of any kind but cost.
    CellResult Measure(const CellId& id);
    /// Measures cells of cost that differ only in their techniques. Frames of all of them take
    /// turns, each between two without an outline (TurnsOf).
    /// @param rounds  the least number of frames of each that are measured; more are if they are
    ///     quick
    std::vector<CellResult> MeasureCosts(std::span<const CellId> ids, int rounds);
    /// Returns the bytes a second that the device copies. They are measured once, before the first
    /// cell of cost.
    double copyBandwidth();

private:
    struct Reference;

    /// Measures a cell of geometry: the drawn outline against the exact one.
    CellResult MeasureGeometry(const CellId& id);
    /// Measures a cell of kind Temporal: the flicker while the subject, a shape, moves by
    /// sixteenths of a pixel, for seventeen frames. The errors of neighbour frames are subtracted,
    /// so that the motion itself does not count.
    CellResult MeasureTemporal(const CellId& id);

    /// Returns the cell's subject with the cell's technique.
    std::unique_ptr<StudyPicture> Picture(const CellId& id, bool isBlack);
    Reference& ReferenceOf(const CellId& id);
    void WritePictures(const Coverage& alpha, const Coverage& exact, const Silhouette& silhouette,
                       CellResult& result);

    std::filesystem::path m_Scene;
    std::filesystem::path m_Folder;
    AssetContext& m_Assets;
    VulkanDevice& m_Device;
    NumericalBench m_Numerical;
    double m_CopyBandwidth = 0.0; ///< 0 = not measured yet
    /// The reference of the last cell, which its neighbours share.
    std::unique_ptr<Reference> m_Reference;
};

/// Returns why a cell's technique is not drawn at its width, or "" if it is drawn.
std::string WhyNotDrawn(const CellId& id, const AssetContext& assets);

} // namespace limn::study
