#pragma once

#include "report/measure/Study.h"
#include "report/measure/StudyPicture.h"
#include "report/measure/StudyScene.h"
#include "report/measure/Techniques.h"
#include "report/truth/OutlineReference.h"

#include <limn/editor_stub/AssetContext.h>
#include <limn/vulkan/VulkanDevice.h>
#include <map>
#include <memory>
#include <span>

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

/// Measures cells, one after the other, on one device.
class StudyBench
{
public:
    /// @param scene   the file of the subject "scene"
    /// @param folder  of the study; pictures are written below it, "" writes none
    /// @param assets, device  must outlive this
    StudyBench(std::filesystem::path scene, std::filesystem::path folder, AssetContext& assets,
               VulkanDevice& device);
    ~StudyBench();

    /// A cell of any kind but cost.
    CellResult Measure(const CellId& id);
    /// A cell of geometry: the drawn outline against the exact one.
    CellResult MeasureGeometry(const CellId& id);
    /// A cell of temporal: what flickers while the subject, a shape, moves by sixteenths of a
    /// pixel, seventeen frames long. The errors of neighbour frames are subtracted, so that the
    /// motion itself counts for nothing.
    CellResult MeasureTemporal(const CellId& id);
    /// Cells of cost that differ in their techniques only. Frames of all of them take turns,
    /// each between two without an outline (TurnsOf).
    /// @param rounds  how many frames of each are measured at least; more, if they are quick
    std::vector<CellResult> MeasureCosts(std::span<const CellId> ids, int rounds);
    /// Bytes a second that the device copies: measured once, before the first cell of cost.
    double copyBandwidth();

private:
    struct Reference;

    /// The subject with the technique of the cell.
    std::unique_ptr<StudyPicture> Picture(const CellId& id, bool isBlack);
    Reference& ReferenceOf(const CellId& id);
    void WritePictures(const Coverage& alpha, const Coverage& exact, const Silhouette& silhouette,
                       CellResult& result);

    std::filesystem::path m_Scene;
    std::filesystem::path m_Folder;
    AssetContext& m_Assets;
    VulkanDevice& m_Device;
    NumericalBench m_Numerical;
    double m_CopyBandwidth = 0.0;           ///< 0 = not measured yet
    std::unique_ptr<Reference> m_Reference; ///< of the last cell: neighbours share it
};

/// Why a cell's technique is not drawn at its width; "" if it is.
std::string WhyNotDrawn(const CellId& id, const AssetContext& assets);

/// Bytes that the frame's passes load, store and read, each texture whole; and those it draws into.
struct FrameBytes
{
    double moved = 0.0;
    double targets = 0.0;
};
FrameBytes BytesOf(const CompiledFrame& frame);

} // namespace limn::study
