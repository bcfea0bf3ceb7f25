#pragma once

#include "report/measure/StudyPicture.h"
#include "report/measure/StudyScene.h"

#include <array>
#include <limn/vulkan/VulkanDevice.h>
#include <map>
#include <memory>
#include <span>

namespace limn::study
{

inline constexpr const char* k_HalfVariant = "half";
inline constexpr const char* k_StandardZVariant = "standard Z";
inline constexpr const char* k_SmallTargetVariant = "R8 targets";
/// The variants that a cell of kind Numerical may have. "" compares with the technique's twin in
/// double precision (truth/twins). The others compare two pictures of the device: half of 16 bits,
/// depth that is not reversed, a camera of 8 bits (a value above 1 counts as 1).
inline constexpr std::array k_NumericalVariants{"", k_HalfVariant, k_StandardZVariant,
                                                k_SmallTargetVariant};

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

    /// Measures a cell of geometry, a cell of kind Numerical of a shape, or one of kind Temporal.
    /// @throws ContractError for any other kind, and for an unknown technique, subject or variant
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
    /// Measures the errors of a technique by rounding.
    CellResult MeasureNumerical(const CellId& id);
    AssetContext& AssetsFor(const std::string& variant);
    Coverage DrawShape(const CellId& id, AssetContext& assets, bool allowHDR);

    /// Returns the cell's subject with the cell's technique.
    std::unique_ptr<StudyPicture> Picture(const CellId& id, bool isBlack);
    Reference& ReferenceOf(const CellId& id);
    void WritePictures(const Coverage& alpha, const Coverage& exact, const Silhouette& silhouette,
                       CellResult& result);

    std::filesystem::path m_Scene;
    std::filesystem::path m_Folder;
    AssetContext& m_Assets;
    VulkanDevice& m_Device;
    std::map<std::string, std::unique_ptr<AssetContext>> m_Others; ///< by numerical variant
    double m_CopyBandwidth = 0.0;                                  ///< 0 = not measured yet
    /// The reference of the last cell, which its neighbours share.
    std::unique_ptr<Reference> m_Reference;
};

} // namespace limn::study
