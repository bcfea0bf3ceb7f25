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

/// "discrete GPU", "software", ...
const char* ToString(VulkanDeviceType type);

/// What a device says of itself, and whether limn can draw with it.
struct VulkanDeviceInfo
{
    std::string name;
    VulkanDeviceType type = VulkanDeviceType::Other;
    std::string apiVersion; ///< "1.3.230"
    std::string driverName;
    std::string driverInfo;
    /// The bits behind the point of a vertex's place in the picture, in pixels; at least 4.
    int subPixelPrecisionBits = 0;
    std::vector<std::string> problems; ///< one sentence for each thing that limn needs and misses
    /// One for each thing that limn can use and that is not there, or less of it: "no
    /// geometryShader: geometry functions are refused …".
    std::vector<std::string> lacks = {};

    bool isUsable() const { return problems.empty(); }
    bool operator==(const VulkanDeviceInfo&) const = default;
};

/// Every device the loader offers, in its order: VulkanDeviceOptions::device counts in this list.
/// Empty where there is no driver.
/// @throws VulkanError if the loader fails for another reason
std::vector<VulkanDeviceInfo> EnumerateVulkanDevices();

struct VulkanDeviceOptions
{
    /// "" = the first real GPU, else the software device; "software"; a position in
    /// EnumerateVulkanDevices(); or part of a name, in any case.
    std::string device;
    /// Runs under the validation layer with synchronization validation; needs
    /// vulkan-validationlayers installed.
    bool validation = false;
    /// Keeps compiled pipelines between runs; made if absent; empty = nothing is kept.
    std::filesystem::path cacheFolder;
    /// false = only what Vulkan 1.3 guarantees, to test the ways around what a driver lacks.
    bool optionalExtensions = true;
};

/// What a validation layer objected to.
struct ValidationMessage
{
    Severity severity = Severity::Error;
    std::string id; ///< e.g. "VUID-vkCmdDraw-None-02859"
    std::string text;
};

/// What a device holds at the moment and has done so far.
struct VulkanDeviceStatistics
{
    std::uint64_t allocatedBytes = 0; ///< taken from the driver
    std::uint64_t usedBytes = 0;      ///< of these, in use by images and buffers
    std::uint64_t sharedBytes = 0;    ///< of these, in which textures take turns
    std::size_t images = 0;
    std::size_t meshes = 0;
    std::size_t pipelines = 0;
    std::size_t descriptorSets = 0;
    std::uint64_t descriptorWrites = 0; ///< sets written since construction
    std::uint64_t meshUploads = 0;      ///< since construction; grows by one for each mesh written
    /// Since construction; the other frames were submitted as an equal one had been recorded.
    std::uint64_t recordedFrames = 0;
};

/// Draws compiled frames with Vulkan 1.3, without a window. Two frames are in flight at most:
/// Execute() waits for the one before the last. Commands and data are kept of the last two frames,
/// and of up to four where as many structures take turns (CompiledFrame::structure). An image, mesh
/// or pipeline whose description nobody owns any more dies when the last frame that used it is
/// finished. Not for use by several threads at once.
class VulkanDevice final : public GraphicsDevice
{
public:
    /// @throws VulkanError if no device fits, with the reasons for each one; or validation is asked
    ///         for and not installed; or the cache folder cannot be made
    explicit VulkanDevice(const VulkanDeviceOptions& options = {});
    ~VulkanDevice() override; ///< waits for all frames

    /// @throws ContractError if the frame contradicts itself (a texture is not in the use that a
    ///         barrier or a pass says, a draw lacks what its shader reads); nothing of it is then
    ///         drawn
    /// @throws VulkanError   if the driver fails; nothing of the frame is then drawn, and the next
    ///         one may be tried, unless the device is lost (see UniversalRenderPipeline::SetDevice)
    void Execute(const CompiledFrame& frame) override;

    void Wait(); ///< returns when all frames so far are done

    /// Depth comes back as D32_SFloat, 1 = near; several samples a texel as what they were resolved
    /// to, see RenderTextureDescriptor::msaaSamples.
    /// @throws ContractError if the last frame did not leave the texture as CopySource, or resolved
    ///         its samples before it drew into them last
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
    /// Gets "wait for a slot", "prepare", "record commands", "submit", and of ReadBack "wait".
    void SetTimeline(Timeline* timeline) override;

    const std::string& deviceName() const;
    /// What `#pragma require` and `#pragma target` may ask for and this device lacks; for
    /// ShaderCompilerOptions::missingFeatures. As long as the device.
    const std::vector<std::string>& missingShaderFeatures() const;
    /// One line: which device draws and why it was chosen.
    const std::string& ChoiceSentence() const;
    /// All warnings and errors since construction; empty without VulkanDeviceOptions::validation.
    std::vector<ValidationMessage> validationMessages() const;
    VulkanDeviceStatistics statistics() const;
    /// How fast the device copies memory: bytes read and written a second, the best of a few
    /// copies of 64 MiB. Takes a tenth of a second and 128 MiB of the device's memory.
    /// @throws VulkanError
    double MeasureCopyBandwidth();

private:
    class Impl;
    std::unique_ptr<Impl> m_Impl;
};

} // namespace limn
