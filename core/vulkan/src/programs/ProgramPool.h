#pragma once

#include "programs/PipelineCacheFile.h"
#include "programs/RewriteSpirv.h"
#include "resources/MeshPool.h"
#include <deque>
#include <exception>
#include <limn/core/PipelineState.h>
#include <limn/shaderlab/ShaderProgram.h>

namespace limn::vulkan
{

/// The formats of the targets into which a pipeline draws.
struct TargetFormats
{
    FixedList<VkFormat, k_MostColors> colors;
    VkFormat depth = VK_FORMAT_UNDEFINED;
    VkFormat stencil = VK_FORMAT_UNDEFINED;
    VkSampleCountFlagBits samples = VK_SAMPLE_COUNT_1_BIT;

    bool operator==(const TargetFormats&) const = default;
};

/// Everything that distinguishes two pipelines of one program: the state that is not dynamic.
struct PipelineKey
{
    TargetFormats formats;
    bool alphaToMask = false;
    bool depthClamp = false;
    bool conservative = false;
    /// One topology of the class; the actual one is dynamic.
    VkPrimitiveTopology topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
    std::optional<VkLogicOp> logicOp;
    bool dynamicBlend = false;
    std::array<RenderTargetBlendState, 8> blend; ///< default values if blending is dynamic

    bool operator==(const PipelineKey&) const = default;
};

inline bool isOfPoints(const PipelineKey& key)
{
    return key.topology == VK_PRIMITIVE_TOPOLOGY_POINT_LIST;
}

/// A vertex input and where its values come from.
struct VertexFetch
{
    /// An index of VertexAttributes(), or their number if no mesh has the semantic; it then reads
    /// as zero.
    std::size_t attribute = k_VertexAttributeCount;
    std::uint32_t location = 0;
    VkFormat format = VK_FORMAT_UNDEFINED;
};

/// The Vulkan objects of one ShaderProgram. Vertex input i is binding i, its stride dynamic.
struct ProgramObjects
{
    UniqueShaderModule vertex;
    UniqueShaderModule points;   ///< `vertex` WithPointSize; null until points are drawn
    UniqueShaderModule geometry; ///< null if the program has no such function
    UniqueShaderModule fragment;
    /// The pipelines of a kernel, which has none of the other functions. The key is the formats of
    /// the textures that it reads and writes, if the device must know them.
    std::map<ImageFormats, UniquePipeline> kernels;
    UniqueSetLayout setLayout;
    UniquePipelineLayout layout;
    VkShaderStageFlags pushStages = 0; ///< the stages that read the DrawConstants
    std::vector<VertexFetch> fetches;
    bool readsVertexIndex = false; ///< true if the vertex function reads SV_VertexID
    /// A null pipeline is one that FinishPipelines is yet to compile. Elements keep their
    /// addresses.
    std::deque<std::pair<PipelineKey, UniquePipeline>> pipelines;
    std::uint64_t lastUse = 0;
};

/// Returns Vulkan's blend state of target `index`. A target that the fragment function does not
/// write keeps its contents, because the written values would be undefined.
VkPipelineColorBlendAttachmentState ToBlendAttachment(const RenderTargetBlendState& blend,
                                                      std::size_t index, int colorOutputs);

UniquePipeline BuildPipeline(const VulkanContext& context, VkPipelineCache cache,
                             const ProgramObjects& pass, int colorOutputs, const PipelineKey& key);

UniquePipeline BuildComputePipeline(const VulkanContext& context, VkPipelineCache cache,
                                    VkShaderModule kernel, VkPipelineLayout layout);

/// The pipelines of all passes. A pipeline is compiled by the first FinishPipelines after its first
/// use and freed when its ShaderProgram is gone.
class ProgramPool
{
public:
    ProgramPool(const VulkanContext& context, const std::filesystem::path& cacheFolder);

    /// @throws ContractError if the layout needs something that limn does not have
    ProgramObjects& Use(const std::shared_ptr<const ShaderProgram>& program, std::uint64_t number);
    /// Returns a pipeline, which is null until FinishPipelines.
    /// @lifetime  the reference holds as long as `program`, unless FinishPipelines fails
    const UniquePipeline& Pipeline(ProgramObjects& program, const ShaderProgram& compiled,
                                   const PipelineKey& key);
    /// Compiles the new pipelines, several at a time: a driver takes milliseconds for each.
    /// @throws what the first that failed throws; Rollback then forgets all that are not compiled
    void FinishPipelines();
    /// Returns the pipeline of a kernel.
    VkPipeline KernelPipeline(ProgramObjects& program, const ShaderProgram& compiled,
                              const ImageFormats& formats);
    /// Adds the ProgramObjects::lastUse of the programs that submission `number` uses.
    void AddUses(std::uint64_t number, std::vector<std::uint64_t*>& uses)
    {
        AddPooledUses(m_Programs, number, uses);
    }
    void Rollback(std::uint64_t number) noexcept; ///< the submission will never happen
    void Sweep(std::uint64_t finished);
    std::size_t pipelineCount() const;
    std::uint64_t freedCount() const { return m_Freed; } ///< the number of programs freed so far

private:
    /// An identity that outlives the program: its owner's control block, which is never reused
    /// while the weak pointer lives, and the address within the owned object.
    struct Identity
    {
        std::weak_ptr<const ShaderProgram> owner;
        const ShaderProgram* program = nullptr;

        bool operator<(const Identity& other) const
        {
            return owner.owner_before(other.owner) ||
                   (!other.owner.owner_before(owner) && std::less<>{}(program, other.program));
        }
    };

    /// A pipeline that FinishPipelines is yet to compile. It stands at the end of its program's
    /// list, with no compiled one behind it but those of the same frame.
    struct NewPipeline
    {
        ProgramObjects* program = nullptr;
        std::pair<PipelineKey, UniquePipeline>* entry = nullptr;
        int colorOutputs = 0;
        std::exception_ptr error;
    };

    UniqueShaderModule CreateModule(const std::vector<std::uint32_t>& spirv,
                                    VkShaderStageFlagBits stage) const;
    void CreateLayouts(ProgramObjects& objects, const PropertyLayout& layout) const;

    const VulkanContext& m_Context;
    PipelineCacheFile m_Cache;
    std::map<Identity, ProgramObjects> m_Programs;
    std::vector<NewPipeline> m_New;
    std::uint64_t m_Freed = 0;
};

} // namespace limn::vulkan
