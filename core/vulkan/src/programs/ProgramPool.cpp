#include "programs/ProgramPool.h"

#include "device/Check.h"
#include "device/Translate.h"
#include <algorithm>
#include <atomic>
#include <limn/core/DrawError.h>
#include <thread>

namespace limn::vulkan
{

namespace
{

VertexFetch FetchFor(const VertexInput& input)
{
    if (input.type != UniformType::Float)
    {
        throw DrawError("vertex input '" + input.semantic +
                        "' is of an integer type; meshes carry floats");
    }
    constexpr VkFormat k_FetchFormats[] = {VK_FORMAT_UNDEFINED, VK_FORMAT_R32_SFLOAT,
                                           VK_FORMAT_R32G32_SFLOAT, VK_FORMAT_R32G32B32_SFLOAT,
                                           VK_FORMAT_R32G32B32A32_SFLOAT};
    const auto& known = VertexAttributes();
    const auto found = std::ranges::find(known, input.semantic, &VertexAttribute::semantic);
    return {static_cast<std::size_t>(found - known.begin()), input.location,
            k_FetchFormats[found == known.end() ? 4 : found->components]};
}

void RequireOneSample(const TextureBinding& texture)
{
    if (texture.multisampled)
    {
        throw DrawError(
            "texture '" + texture.name +
            "' of the shader has several samples per texel; limn does not support that yet");
    }
}

std::vector<VkDescriptorSetLayoutBinding> Bindings(const PropertyLayout& layout)
{
    std::vector<VkDescriptorSetLayoutBinding> bindings;
    const auto add = [&bindings](VkDescriptorType type, const auto& binding)
    {
        bindings.push_back({binding.binding, type, 1, ToVkStages(binding.stages), nullptr});
    };
    const auto addAll = [&add](VkDescriptorType type, const auto& list)
    {
        std::ranges::for_each(list, [&](const auto& binding) { add(type, binding); });
    };
    addAll(VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, layout.buffers);
    for (const TextureBinding& texture : layout.textures)
    {
        RequireOneSample(texture);
        add(texture.combinedSampler ? VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER
                                    : VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE,
            texture);
    }
    addAll(VK_DESCRIPTOR_TYPE_SAMPLER, layout.samplers);
    addAll(VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, layout.storageBuffers);
    addAll(VK_DESCRIPTOR_TYPE_STORAGE_IMAGE, layout.storageTextures);
    return bindings;
}

/// A kind of resource, and how many of it a device binds.
struct Kind
{
    const char* noun;
    std::uint32_t mostOfAStage;
    std::uint32_t mostOfAll;
    std::vector<VkDescriptorType> types;
};

std::vector<Kind> Kinds(const VkPhysicalDeviceLimits& limits)
{
    constexpr VkDescriptorType k_Uniform = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
    constexpr VkDescriptorType k_Texture = VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE;
    constexpr VkDescriptorType k_Both = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
    constexpr VkDescriptorType k_Buffer = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    constexpr VkDescriptorType k_Writable = VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
    return {{"uniform buffers",
             limits.maxPerStageDescriptorUniformBuffers,
             limits.maxDescriptorSetUniformBuffers,
             {k_Uniform}},
            {"textures",
             limits.maxPerStageDescriptorSampledImages,
             limits.maxDescriptorSetSampledImages,
             {k_Texture, k_Both}},
            {"samplers",
             limits.maxPerStageDescriptorSamplers,
             limits.maxDescriptorSetSamplers,
             {VK_DESCRIPTOR_TYPE_SAMPLER, k_Both}},
            {"structured buffers",
             limits.maxPerStageDescriptorStorageBuffers,
             limits.maxDescriptorSetStorageBuffers,
             {k_Buffer}},
            {"writable textures",
             limits.maxPerStageDescriptorStorageImages,
             limits.maxDescriptorSetStorageImages,
             {k_Writable}},
            {"targets, textures and buffers",
             limits.maxPerStageResources,
             ~0U,
             {k_Uniform, k_Texture, k_Both, k_Buffer, k_Writable}}};
}

void RequireRoom(const char* who, std::ptrdiff_t count, const char* noun, std::uint32_t most)
{
    if (count > std::ptrdiff_t{most})
    {
        throw DrawError(std::string(who) + " " + std::to_string(count) + " " + noun +
                        "; the device binds at most " + std::to_string(most));
    }
}

/// Drivers that are given more than they bind may crash.
/// @param colorOutputs  targets count as what a fragment function uses
void RequireRoom(const std::vector<VkDescriptorSetLayoutBinding>& bindings, int colorOutputs,
                 const VkPhysicalDeviceLimits& limits)
{
    for (const Kind& kind : Kinds(limits))
    {
        const auto count = [&](VkShaderStageFlags stages)
        {
            return std::ranges::count_if(bindings,
                                         [&](const VkDescriptorSetLayoutBinding& binding)
                                         {
                                             return (binding.stageFlags & stages) != 0 &&
                                                    std::ranges::count(kind.types,
                                                                       binding.descriptorType) > 0;
                                         });
        };
        for (const VkShaderStageFlagBits stage :
             {VK_SHADER_STAGE_VERTEX_BIT, VK_SHADER_STAGE_GEOMETRY_BIT,
              VK_SHADER_STAGE_FRAGMENT_BIT, VK_SHADER_STAGE_COMPUTE_BIT})
        {
            const bool drawsToo = stage == VK_SHADER_STAGE_FRAGMENT_BIT && kind.types.size() > 2;
            RequireRoom("a function of the shader reads",
                        count(stage) + (drawsToo ? colorOutputs : 0), kind.noun, kind.mostOfAStage);
        }
        RequireRoom("the functions of the shader read", count(VK_SHADER_STAGE_ALL), kind.noun,
                    kind.mostOfAll);
    }
}

/// Vertex, geometry and fragment functions write to buffers and textures where the device lets
/// them.
void RequireStores(const PropertyLayout& layout, const DeviceCapabilities& can)
{
    ShaderStage writers = ShaderStage::None;
    int written = 0;
    const auto add = [&](const auto& binding)
    {
        writers = writers | binding.stages;
        written += HasAll(binding.stages, ShaderStage::Fragment) ? 1 : 0;
    };
    for (const StorageBufferBinding& buffer : layout.storageBuffers)
    {
        if (buffer.isWritten)
        {
            add(buffer);
        }
    }
    std::ranges::for_each(layout.storageTextures, add);
    const VkShaderStageFlags stages = ToVkStages(writers);
    const bool isFragment = (stages & VK_SHADER_STAGE_FRAGMENT_BIT) != 0;
    const bool isBefore =
        (stages & (VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_GEOMETRY_BIT)) != 0;
    if ((isFragment && !can.features.fragmentStoresAndAtomics) ||
        (isBefore && !can.features.vertexPipelineStoresAndAtomics))
    {
        throw DrawError(
            std::string("a program needs ") +
            (isFragment ? "fragmentStoresAndAtomics" : "vertexPipelineStoresAndAtomics") +
            ", which the device lacks: it writes to a buffer or a texture");
    }
    RequireRoom("the fragment function writes to", written + layout.colorOutputs,
                "targets, buffers and textures", can.limits.maxFragmentCombinedOutputResources);
}

void RequireInputs(const PropertyLayout& layout, const VkPhysicalDeviceLimits& limits)
{
    RequireRoom("the vertex function reads", std::ssize(layout.vertexInputs), "vertex inputs",
                std::min(limits.maxVertexInputBindings, limits.maxVertexInputAttributes));
}

/// Calls `work` on as many threads as there are processors, but on no more than `most`.
template <typename Work>
void RunOnThreads(const Work& work, std::size_t most)
{
    std::vector<std::jthread> threads;
    const std::size_t count = std::min<std::size_t>(std::thread::hardware_concurrency(), most);
    try
    {
        for (std::size_t i = 1; i < count; ++i)
        {
            threads.emplace_back(work);
        }
    }
    catch (const std::exception&)
    {
        // There is no room for a thread: this one does what is left.
    }
    work();
}

bool HasUncompiled(const ProgramObjects& program)
{
    return std::ranges::any_of(program.pipelines, [](const auto& entry) { return !entry.second; });
}

} // namespace

ProgramPool::ProgramPool(const VulkanContext& context, const std::filesystem::path& cacheFolder)
    : m_Context(context), m_Cache(context, cacheFolder)
{
}

ProgramObjects& ProgramPool::Use(const std::shared_ptr<const ShaderProgram>& program,
                                 std::uint64_t number)
{
    if (ProgramObjects* found = FindPooled(m_Programs, Identity{program, program.get()}))
    {
        found->lastUse = number;
        return *found;
    }
    ProgramObjects objects;
    objects.lastUse = number;
    for (const VertexInput& input : program->layout.vertexInputs)
    {
        objects.fetches.push_back(FetchFor(input));
    }
    objects.pushStages = ToVkStages(program->layout.pushStages);
    if (!program->geometrySpirv.empty())
    {
        objects.geometry = CreateModule(program->geometrySpirv, VK_SHADER_STAGE_GEOMETRY_BIT);
    }
    CreateLayouts(objects, program->layout);
    if (program->computeSpirv.empty())
    {
        objects.vertex = CreateModule(program->vertexSpirv, VK_SHADER_STAGE_VERTEX_BIT);
        objects.readsVertexIndex = HasBuiltIn(program->vertexSpirv, spv::BuiltInVertexIndex);
        objects.fragment = CreateModule(program->fragmentSpirv, VK_SHADER_STAGE_FRAGMENT_BIT);
    }
    return m_Programs.emplace(Identity{program, program.get()}, std::move(objects)).first->second;
}

const UniquePipeline& ProgramPool::Pipeline(ProgramObjects& program, const ShaderProgram& compiled,
                                            const PipelineKey& key)
{
    for (const auto& [known, pipeline] : program.pipelines)
    {
        if (known == key)
        {
            return pipeline;
        }
    }
    if (isOfPoints(key) && !program.geometry && !program.points)
    {
        program.points =
            CreateModule(WithPointSize(compiled.vertexSpirv), VK_SHADER_STAGE_VERTEX_BIT);
    }
    m_New.emplace_back(); // first, so that no entry is without it if there is no memory
    auto& entry = program.pipelines.emplace_back(key, UniquePipeline{});
    m_New.back() = {&program, &entry, compiled.layout.colorOutputs, nullptr};
    return entry.second;
}

void ProgramPool::FinishPipelines()
{
    std::atomic<std::size_t> next = 0;
    const auto work = [&]
    {
        for (std::size_t i = next++; i < m_New.size(); i = next++)
        {
            NewPipeline& fresh = m_New[i];
            try
            {
                fresh.entry->second = BuildPipeline(m_Context, m_Cache.get(), *fresh.program,
                                                    fresh.colorOutputs, fresh.entry->first);
            }
            catch (...)
            {
                fresh.error = std::current_exception();
            }
        }
    };
    RunOnThreads(work, m_New.size());
    for (const NewPipeline& fresh : m_New)
    {
        if (fresh.error)
        {
            std::rethrow_exception(fresh.error);
        }
    }
    m_New.clear();
}

VkPipeline ProgramPool::KernelPipeline(ProgramObjects& program, const ShaderProgram& compiled,
                                       const ImageFormats& formats)
{
    UniquePipeline& pipeline = program.kernels[formats];
    if (!pipeline)
    {
        const UniqueShaderModule module =
            CreateModule(WithFormats(compiled.computeSpirv, formats), VK_SHADER_STAGE_COMPUTE_BIT);
        pipeline =
            BuildComputePipeline(m_Context, m_Cache.get(), module.get(), program.layout.get());
    }
    return pipeline.get();
}

void ProgramPool::Rollback(std::uint64_t number) noexcept
{
    // A program's pipelines that are not compiled stand behind all others of its own, or behind
    // new ones of this frame, which go as well.
    for (const NewPipeline& fresh : m_New)
    {
        while (fresh.program != nullptr && !fresh.program->pipelines.empty() &&
               HasUncompiled(*fresh.program))
        {
            fresh.program->pipelines.pop_back();
        }
    }
    m_New.clear();
    UndoPooledUses(m_Programs, number);
}

void ProgramPool::Sweep(std::uint64_t finished)
{
    m_Freed +=
        std::erase_if(m_Programs, [&](const auto& entry)
                      { return entry.first.owner.expired() && entry.second.lastUse <= finished; });
}

std::size_t ProgramPool::pipelineCount() const
{
    std::size_t count = 0;
    for (const auto& [identity, objects] : m_Programs)
    {
        count += objects.pipelines.size() + objects.kernels.size();
    }
    return count;
}

UniqueShaderModule ProgramPool::CreateModule(const std::vector<std::uint32_t>& spirv,
                                             VkShaderStageFlagBits stage) const
{
    RequireCapabilities(spirv, m_Context.capabilities().missingCapabilities.at(stage));
    auto info = Make<VkShaderModuleCreateInfo>(VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO);
    info.codeSize = spirv.size() * sizeof(std::uint32_t);
    info.pCode = spirv.data();
    return {m_Context.device(), vkCreateShaderModule, info, "vkCreateShaderModule"};
}

void ProgramPool::CreateLayouts(ProgramObjects& objects, const PropertyLayout& layout) const
{
    const std::vector<VkDescriptorSetLayoutBinding> bindings = Bindings(layout);
    RequireRoom(bindings, layout.colorOutputs, m_Context.capabilities().limits);
    RequireStores(layout, m_Context.capabilities());
    RequireInputs(layout, m_Context.capabilities().limits);
    VkDescriptorSetLayoutCreateInfo setInfo{};
    setInfo.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
    setInfo.bindingCount = static_cast<std::uint32_t>(bindings.size());
    setInfo.pBindings = bindings.data();
    objects.setLayout = UniqueSetLayout{m_Context.device(), vkCreateDescriptorSetLayout, setInfo,
                                        "vkCreateDescriptorSetLayout"};
    const VkDescriptorSetLayout set = objects.setLayout.get();

    static_assert(sizeof(DrawConstants) <= 128); // which every device has
    const VkPushConstantRange constants{objects.pushStages, 0, sizeof(DrawConstants)};
    auto info = Make<VkPipelineLayoutCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO);
    info.setLayoutCount = 1;
    info.pSetLayouts = &set;
    info.pushConstantRangeCount = objects.pushStages != 0 ? 1 : 0;
    info.pPushConstantRanges = &constants;
    objects.layout = UniquePipelineLayout{m_Context.device(), vkCreatePipelineLayout, info,
                                          "vkCreatePipelineLayout"};
}

} // namespace limn::vulkan
