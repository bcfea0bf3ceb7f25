#pragma once

#include <filesystem>
#include <limn/base/Diagnostic.h>
#include <limn/core/GraphicsDevice.h>
#include <string>
#include <vector>

namespace limn
{

enum class VulkanDeviceType
{
    Other,
    IntegratedGpu,
    DiscreteGpu,
    VirtualGpu,
    Software ///< runs on the CPU, e.g. Mesa's llvmpipe
};

/// Returns "discrete GPU", "software", ...
const char* ToString(VulkanDeviceType type);

/// The properties of a device, and whether limn can draw with it.
struct VulkanDeviceInfo
{
    std::string name;
    VulkanDeviceType type = VulkanDeviceType::Other;
    std::string apiVersion; ///< "1.3.230"
    std::string driverName;
    std::string driverInfo;
    /// The number of fractional bits of a vertex's position in the picture, which is in pixels; at
    /// least 4.
    int subPixelPrecisionBits = 0;
    /// One sentence for each thing that limn needs and the device lacks.
    std::vector<std::string> problems;
    /// One sentence for each thing that limn can use and that the device lacks or has less of: "it
    /// has no geometryShader: geometry functions are refused …".
    std::vector<std::string> lacks = {};

    bool isUsable() const { return problems.empty(); }
    bool operator==(const VulkanDeviceInfo&) const = default;
};

/// Returns every device that the loader offers, in its order; VulkanDeviceOptions::device is a
/// position in this list. The list is empty if there is no driver.
/// @throws VulkanError if the loader fails for another reason
std::vector<VulkanDeviceInfo> EnumerateVulkanDevices();

struct VulkanDeviceOptions
{
    /// "" = the first real GPU, else the software device; "software"; a position in
    /// EnumerateVulkanDevices(); or part of a name, in any case.
    std::string device;
    /// Uses the validation layer with synchronization validation; requires that
    /// vulkan-validationlayers is installed.
    bool validation = false;
    /// The folder that keeps compiled pipelines between runs. It is made if absent; empty = nothing
    /// is kept.
    std::filesystem::path cacheFolder;
    /// false = uses only what Vulkan 1.3 guarantees, to test the fallbacks for drivers that lack
    /// the rest.
    bool optionalExtensions = true;
};

/// A message of the validation layer.
struct ValidationMessage
{
    Severity severity = Severity::Error;
    std::string id; ///< e.g. "VUID-vkCmdDraw-None-02859"
    std::string text;
};

/// The objects that a device holds at the moment, and counts of what it has done so far.
struct VulkanDeviceStatistics
{
    std::uint64_t allocatedBytes = 0; ///< taken from the driver
    std::uint64_t usedBytes = 0;      ///< the part of these that images and buffers use
    std::size_t images = 0;
    std::size_t meshes = 0;
    std::size_t pipelines = 0;
    std::uint64_t descriptorWrites = 0; ///< sets written since construction
    std::uint64_t meshUploads = 0;      ///< since construction; grows by one for each mesh written
    /// The number of frames recorded since construction; the other frames reused the commands of an
    /// equal frame.
    std::uint64_t recordedFrames = 0;
};

/// Draws compiled frames with Vulkan 1.3, without a window. Two frames are in flight at most:
/// Execute() waits for the one before the last. It keeps the commands and data of the last two
/// frames, or of up to four if so many structures alternate (CompiledFrame::structure). An image,
/// mesh or pipeline whose description has no owner any more is destroyed when the last frame that
/// used it is finished. Must not be used by several threads at once.
class VulkanDevice final : public GraphicsDevice
{
public:
    /// @throws VulkanError if no device fits, with the reasons for each one; if validation is
    ///     requested but not installed; or if the cache folder cannot be made
    explicit VulkanDevice(const VulkanDeviceOptions& options = {});
    ~VulkanDevice() override; ///< waits for all frames

    /// @throws ContractError if the frame contradicts itself (a texture is not in the use that a
    ///     barrier or a pass states, a draw lacks what its shader reads); nothing of it is then
    ///     drawn
    /// @throws VulkanError   if the driver fails; nothing of the frame is then drawn, and the next
    ///         one may be tried, unless the device is lost (see UniversalRenderPipeline::SetDevice)
    void Execute(const CompiledFrame& frame) override;

    void Wait(); ///< returns when all frames so far are done

    /// Reads a texture back. Depth is returned as D32_SFloat, 1 = near. Several samples per texel
    /// are returned as the result of their resolve, see RenderTextureDescriptor::msaaSamples.
    /// @throws ContractError if the last frame did not leave the texture as CopySource, or drew
    ///     into its samples after it resolved them
    Image ReadBack(const RenderTexture& texture) override;

    std::vector<std::byte> ReadBackBuffer(const GraphicsBuffer& buffer) override;

    std::shared_ptr<PendingReadback> BeginReadBack(const RenderTexture& texture) override;
    std::shared_ptr<PendingReadback> BeginReadBack(const GraphicsBuffer& buffer) override;

    /// Returns the stencil of a D32_SFloat_S8_UInt texture as R8_UNorm, the top row of the picture
    /// first: a byte is the stored value.
    /// @throws ContractError as ReadBack, or if the texture has no stencil
    Image ReadBackStencil(const RenderTexture& texture);

    const TextureStates& textureStates() const override;
    TextureFootprint Footprint(const RenderTexture& texture) override;
    int GetRenderTextureSupportedMSAASampleCount(
        const RenderTextureDescriptor& descriptor) const override;
    bool IsFormatSupported(GraphicsFormat format, FormatUsage usage) const override;
    std::vector<PassTiming> LastFrameTimings() override;
    /// Sets a timeline. It receives "wait for a slot", "prepare", "record commands", "submit", and
    /// "wait" from ReadBack.
    void SetTimeline(Timeline* timeline) override;

    const std::string& deviceName() const;
    /// Returns the features that `#pragma require` and `#pragma target` can ask for and this device
    /// lacks, for ShaderCompilerOptions::missingFeatures. The list lives as long as the device.
    const std::vector<std::string>& missingShaderFeatures() const;
    /// Returns one line that says which device draws and why it was chosen.
    const std::string& ChoiceSentence() const;
    /// Returns all warnings and errors since construction; empty without
    /// VulkanDeviceOptions::validation.
    std::vector<ValidationMessage> validationMessages() const;
    VulkanDeviceStatistics statistics() const;
    /// Measures how fast the device copies memory. Returns the bytes read and written per second in
    /// the fastest of a few copies of 64 MiB. Takes a tenth of a second and 128 MiB of the device's
    /// memory.
    /// @throws VulkanError
    double MeasureCopyBandwidth();

private:
    class Impl;
    std::unique_ptr<Impl> m_Impl;
};

} // namespace limn
