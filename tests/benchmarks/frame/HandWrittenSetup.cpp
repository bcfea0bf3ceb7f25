#include "frame/HandWrittenFrame.h"

#include "device/Check.h"
#include "device/Translate.h"
#include <algorithm>
#include <cstring>
#include <limn/core/Mesh.h>

namespace limn::benchmarks
{

namespace
{

using vulkan::Check;

constexpr std::size_t k_FramesInFlight = 2;

VulkanDeviceOptions OptionsFor(const std::string& device)
{
    VulkanDeviceOptions options;
    options.device = device;
    return options;
}

template <typename Slots>
const auto& SlotOf(const Slots& slots, std::uint32_t binding)
{
    return *std::ranges::find_if(slots, [&](const auto& slot) { return slot.binding == binding; });
}

void ChangeLayout(VkCommandBuffer commands, VkImage image, VkImageLayout before,
                  VkImageLayout after)
{
    VkImageMemoryBarrier2 barrier{};
    barrier.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2;
    barrier.srcStageMask = VK_PIPELINE_STAGE_2_COPY_BIT;
    barrier.srcAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT;
    barrier.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    barrier.dstAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT | VK_ACCESS_2_SHADER_SAMPLED_READ_BIT;
    barrier.oldLayout = before;
    barrier.newLayout = after;
    barrier.srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = image;
    barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    VkDependencyInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO;
    info.imageMemoryBarrierCount = 1;
    info.pImageMemoryBarriers = &barrier;
    vkCmdPipelineBarrier2(commands, &info);
}

} // namespace

std::size_t ObjectsOffset(const ArticleNumbers& numbers)
{
    return (numbers.uniforms.size() + k_UniformAlignment - 1) / k_UniformAlignment *
           k_UniformAlignment;
}

std::size_t InstancesOffset(const ArticleNumbers& numbers)
{
    const std::size_t end = ObjectsOffset(numbers) + numbers.objects.size() * sizeof(PerDrawData);
    return (end + k_UniformAlignment - 1) / k_UniformAlignment * k_UniformAlignment;
}

HandWrittenFrame::HandWrittenFrame(const ArticleNumbers& numbers, const std::string& device)
    : m_Numbers(numbers),
      m_Scene(numbers),
      m_Context(OptionsFor(device)),
      m_Allocator(m_Context.device(), m_Context.physicalDevice()),
      m_Samplers(m_Context)
{
    VkSemaphoreTypeCreateInfo type{};
    type.sType = VK_STRUCTURE_TYPE_SEMAPHORE_TYPE_CREATE_INFO;
    type.semaphoreType = VK_SEMAPHORE_TYPE_TIMELINE;
    VkSemaphoreCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO;
    info.pNext = &type;
    VkSemaphore semaphore = VK_NULL_HANDLE;
    Check(vkCreateSemaphore(m_Context.device(), &info, nullptr, &semaphore), "vkCreateSemaphore");
    m_Timeline = vulkan::UniqueSemaphore{m_Context.device(), semaphore};
    CreateTargets();
    CreateStages();
    CreateMeshes();
    for (std::size_t i = 0; i < k_FramesInFlight; ++i)
    {
        CreateSlot(m_Slots.emplace_back(m_Context.device()));
    }
}

HandWrittenFrame::~HandWrittenFrame()
{
    vkDeviceWaitIdle(m_Context.device());
}

void HandWrittenFrame::CreateTargets()
{
    const VkExtent2D full{static_cast<std::uint32_t>(m_Numbers.width),
                          static_cast<std::uint32_t>(m_Numbers.height)};
    const VkExtent2D half{full.width / 2, full.height / 2};
    constexpr VkImageUsageFlags drawn =
        VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT;
    m_Mask = CreateTarget(VK_FORMAT_R8_UNORM, half, drawn);
    m_Edge = CreateTarget(VK_FORMAT_R8_UNORM, half, drawn);
    m_Color = CreateTarget(VK_FORMAT_R16G16B16A16_SFLOAT, full, drawn);
    m_Depth = CreateTarget(VK_FORMAT_D32_SFLOAT, full, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT);
    m_Output = CreateTarget(VK_FORMAT_R8G8B8A8_SRGB, full,
                            VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT);
}

HandWrittenFrame::Target HandWrittenFrame::CreateTarget(VkFormat format, VkExtent2D extent,
                                                        VkImageUsageFlags usage)
{
    Target target;
    target.format = format;
    target.extent = extent;
    VkImageCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO;
    info.imageType = VK_IMAGE_TYPE_2D;
    info.format = format;
    info.extent = {extent.width, extent.height, 1};
    info.mipLevels = 1;
    info.arrayLayers = 1;
    info.samples = VK_SAMPLE_COUNT_1_BIT;
    info.usage = usage;
    VkImage image = VK_NULL_HANDLE;
    Check(vkCreateImage(m_Context.device(), &info, nullptr, &image), "vkCreateImage");
    target.image = vulkan::UniqueImage{m_Context.device(), image};
    VkMemoryRequirements needs{};
    vkGetImageMemoryRequirements(m_Context.device(), image, &needs);
    target.memory = m_Allocator.Allocate(needs, vulkan::MemoryUse::Gpu,
                                         vulkan::MemoryContent::Images, "target");
    Check(vkBindImageMemory(m_Context.device(), image, target.memory.memory(),
                            target.memory.offset()),
          "vkBindImageMemory");
    VkImageViewCreateInfo view{};
    view.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO;
    view.image = image;
    view.viewType = VK_IMAGE_VIEW_TYPE_2D;
    view.format = format;
    const bool isDepth = format == VK_FORMAT_D32_SFLOAT;
    view.subresourceRange = {static_cast<VkImageAspectFlags>(isDepth ? VK_IMAGE_ASPECT_DEPTH_BIT
                                                                     : VK_IMAGE_ASPECT_COLOR_BIT),
                             0, 1, 0, 1};
    VkImageView handle = VK_NULL_HANDLE;
    Check(vkCreateImageView(m_Context.device(), &view, nullptr, &handle), "vkCreateImageView");
    target.view = vulkan::UniqueImageView{m_Context.device(), handle};
    return target;
}

void HandWrittenFrame::CreateMeshes()
{
    // Array by array, mesh by mesh; then all indices.
    std::map<std::uint64_t, std::shared_ptr<const Mesh>> meshes;
    for (const ArticleGroup& group : m_Numbers.groups)
    {
        meshes.emplace(group.mesh->id(), group.mesh);
    }
    std::vector<std::byte> bytes;
    const auto append = [&](std::span<const std::byte> more)
    {
        bytes.insert(bytes.end(), more.begin(), more.end());
    };
    for (const VertexInput& input : m_Numbers.lit->layout.vertexInputs)
    {
        const auto& attribute =
            *std::ranges::find(VertexAttributes(), input.semantic, &VertexAttribute::semantic);
        m_Arrays.push_back(bytes.size());
        for (const auto& [id, mesh] : meshes)
        {
            append(std::as_bytes(attribute.values(mesh->data())));
        }
    }
    m_Indices = bytes.size();
    PlacedMesh next;
    for (const auto& [id, mesh] : meshes)
    {
        next.indexCount = static_cast<std::uint32_t>(mesh->data().triangles.size());
        m_PlacedMeshes[id] = next;
        append(std::as_bytes(std::span(mesh->data().triangles)));
        next.index += next.indexCount;
        next.vertex += static_cast<std::int32_t>(mesh->data().vertices.size());
    }
    m_Meshes = vulkan::Buffer{m_Context.device(),
                              m_Allocator,
                              bytes.size(),
                              VK_BUFFER_USAGE_VERTEX_BUFFER_BIT | VK_BUFFER_USAGE_INDEX_BUFFER_BIT |
                                  VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                              vulkan::MemoryUse::Gpu,
                              "meshes"};
    vulkan::Buffer staging{
        m_Context.device(),        m_Allocator, bytes.size(), VK_BUFFER_USAGE_TRANSFER_SRC_BIT,
        vulkan::MemoryUse::Upload, "staging"};
    std::memcpy(staging.memory.mapped(), bytes.data(), bytes.size());
    RunNow(
        [&](VkCommandBuffer commands)
        {
            const VkBufferCopy copy{0, 0, bytes.size()};
            vkCmdCopyBuffer(commands, staging.handle.get(), m_Meshes.handle.get(), 1, &copy);
        });
}

VkCommandBuffer HandWrittenFrame::CreateCommands(vulkan::UniqueCommandPool& pool) const
{
    VkCommandPoolCreateInfo poolInfo{};
    poolInfo.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
    poolInfo.flags = VK_COMMAND_POOL_CREATE_TRANSIENT_BIT;
    poolInfo.queueFamilyIndex = m_Context.queueFamily();
    VkCommandPool handle = VK_NULL_HANDLE;
    Check(vkCreateCommandPool(m_Context.device(), &poolInfo, nullptr, &handle),
          "vkCreateCommandPool");
    pool = vulkan::UniqueCommandPool{m_Context.device(), handle};
    VkCommandBufferAllocateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
    info.commandPool = handle;
    info.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
    info.commandBufferCount = 1;
    VkCommandBuffer commands = VK_NULL_HANDLE;
    Check(vkAllocateCommandBuffers(m_Context.device(), &info, &commands),
          "vkAllocateCommandBuffers");
    return commands;
}

void HandWrittenFrame::RunNow(const std::function<void(VkCommandBuffer)>& record) const
{
    vulkan::UniqueCommandPool pool;
    VkCommandBuffer commands = CreateCommands(pool);
    VkCommandBufferBeginInfo begin{};
    begin.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
    Check(vkBeginCommandBuffer(commands, &begin), "vkBeginCommandBuffer");
    record(commands);
    Check(vkEndCommandBuffer(commands), "vkEndCommandBuffer");
    VkCommandBufferSubmitInfo buffer{};
    buffer.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO;
    buffer.commandBuffer = commands;
    VkSubmitInfo2 info{};
    info.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO_2;
    info.commandBufferInfoCount = 1;
    info.pCommandBufferInfos = &buffer;
    Check(vkQueueSubmit2(m_Context.queue(), 1, &info, VK_NULL_HANDLE), "vkQueueSubmit2");
    vkDeviceWaitIdle(m_Context.device());
}

void HandWrittenFrame::CreateSlot(Slot& slot)
{
    VkDevice device = m_Context.device();
    slot.commands = CreateCommands(slot.pool);
    VkQueryPoolCreateInfo queryInfo{};
    queryInfo.sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO;
    queryInfo.queryType = VK_QUERY_TYPE_TIMESTAMP;
    queryInfo.queryCount = 16;
    VkQueryPool queries = VK_NULL_HANDLE;
    Check(vkCreateQueryPool(device, &queryInfo, nullptr, &queries), "vkCreateQueryPool");
    slot.queries = vulkan::UniqueQueryPool{device, queries};
    slot.data = vulkan::Buffer{
        device,
        m_Allocator,
        InstancesOffset(m_Numbers) + m_Numbers.objects.size() * sizeof(std::uint32_t),
        VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT | VK_BUFFER_USAGE_STORAGE_BUFFER_BIT,
        vulkan::MemoryUse::Upload,
        "frame data"};
    for (const auto& bindings : m_Numbers.materials)
    {
        slot.materials.push_back(CreateSet(slot, m_LitStage, *bindings));
    }
    slot.mask = CreateSet(slot, m_MaskStage, *m_Numbers.maskBindings);
    slot.edge = CreateSet(slot, m_EdgeStage, *m_Numbers.edge.bindings);
    slot.composite = CreateSet(slot, m_CompositeStage, *m_Numbers.composite.bindings);
    slot.final = CreateSet(slot, m_FinalStage, *m_Numbers.final.bindings);
}

VkDescriptorSet HandWrittenFrame::CreateSet(Slot& slot, const Stage& stage,
                                            const DrawBindings& bindings)
{
    VkDescriptorSet set = slot.descriptors.Allocate(stage.setLayout.get());
    const auto write = [&](std::uint32_t binding, VkDescriptorType type,
                           const VkDescriptorBufferInfo* buffer, const VkDescriptorImageInfo* image)
    {
        VkWriteDescriptorSet info{};
        info.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
        info.dstSet = set;
        info.dstBinding = binding;
        info.descriptorCount = 1;
        info.descriptorType = type;
        info.pBufferInfo = buffer;
        info.pImageInfo = image;
        vkUpdateDescriptorSets(m_Context.device(), 1, &info, 0, nullptr);
    };
    const PropertyLayout& layout = stage.program->layout;
    for (const UniformBuffer& buffer : layout.buffers)
    {
        const UniformSlice& slice = SlotOf(bindings.uniforms, buffer.binding);
        const VkDescriptorBufferInfo info{slot.data.handle.get(), slice.offset, slice.size};
        write(buffer.binding, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, &info, nullptr);
    }
    for (const TextureBinding& texture : layout.textures)
    {
        const TextureSlot& bound = SlotOf(bindings.textures, texture.binding);
        const VkDescriptorImageInfo info{
            m_Samplers.Get(bound.sampler.value_or(bound.texture->sampler()), 0),
            ViewOf(*bound.texture), VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
        write(texture.binding, DescriptorTypeOf(texture), nullptr, &info);
    }
    for (const SamplerBinding& sampler : layout.samplers)
    {
        const VkDescriptorImageInfo info{
            m_Samplers.Get(SlotOf(bindings.samplers, sampler.binding).state, 0), VK_NULL_HANDLE,
            VK_IMAGE_LAYOUT_UNDEFINED};
        write(sampler.binding, VK_DESCRIPTOR_TYPE_SAMPLER, nullptr, &info);
    }
    for (const StorageBufferBinding& buffer : layout.storageBuffers)
    {
        const std::size_t objectBytes = m_Numbers.objects.size() * sizeof(PerDrawData);
        const VkDescriptorBufferInfo info =
            buffer.name == "limn_Instances"
                ? VkDescriptorBufferInfo{slot.data.handle.get(), InstancesOffset(m_Numbers),
                                         VK_WHOLE_SIZE}
                : VkDescriptorBufferInfo{slot.data.handle.get(), ObjectsOffset(m_Numbers),
                                         objectBytes};
        write(buffer.binding, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, &info, nullptr);
    }
    return set;
}

VkImageView HandWrittenFrame::ViewOf(const Texture& texture)
{
    const std::pair<const char*, const Target*> targets[] = {{"_RendererDrawingTexture", &m_Mask},
                                                             {"_OutlineTexture", &m_Edge},
                                                             {"_CameraColorAttachmentA", &m_Color}};
    for (const auto& [name, target] : targets)
    {
        if (texture.name() == name)
        {
            return target->view.get();
        }
    }
    Target& target = m_Textures[texture.id()];
    if (!target.image)
    {
        UploadTexels(dynamic_cast<const TexelTexture&>(texture), target);
    }
    return target.view.get();
}

void HandWrittenFrame::UploadTexels(const TexelTexture& texture, Target& target)
{
    target = CreateTarget(
        vulkan::ToVkFormat(texture.graphicsFormat()),
        {static_cast<std::uint32_t>(texture.width()), static_cast<std::uint32_t>(texture.height())},
        VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT);
    const std::vector<std::byte>& texels = texture.texels();
    vulkan::Buffer staging{
        m_Context.device(),        m_Allocator, texels.size(), VK_BUFFER_USAGE_TRANSFER_SRC_BIT,
        vulkan::MemoryUse::Upload, "staging"};
    std::memcpy(staging.memory.mapped(), texels.data(), texels.size());
    RunNow(
        [&](VkCommandBuffer commands)
        {
            ChangeLayout(commands, target.image.get(), VK_IMAGE_LAYOUT_UNDEFINED,
                         VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
            VkBufferImageCopy copy{};
            copy.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
            copy.imageExtent = {target.extent.width, target.extent.height, 1};
            vkCmdCopyBufferToImage(commands, staging.handle.get(), target.image.get(),
                                   VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &copy);
            ChangeLayout(commands, target.image.get(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                         VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
        });
}

Image HandWrittenFrame::ReadBack()
{
    Image result;
    result.width = m_Numbers.width;
    result.height = m_Numbers.height;
    result.format = GraphicsFormat::R8G8B8A8_SRGB;
    const auto size = static_cast<std::size_t>(result.width * result.height) * 4;
    vulkan::Buffer buffer{
        m_Context.device(),          m_Allocator, size, VK_BUFFER_USAGE_TRANSFER_DST_BIT,
        vulkan::MemoryUse::ReadBack, "read-back"};
    RunNow(
        [&](VkCommandBuffer commands)
        {
            VkBufferImageCopy copy{};
            copy.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
            copy.imageExtent = {m_Output.extent.width, m_Output.extent.height, 1};
            vkCmdCopyImageToBuffer(commands, m_Output.image.get(),
                                   VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, buffer.handle.get(), 1,
                                   &copy);
        });
    const auto rowSize = static_cast<std::ptrdiff_t>(result.width) * 4;
    for (int row = result.height; row-- > 0;) // the picture's bottom row is stored first
    {
        const std::byte* texels = buffer.memory.mapped() + row * rowSize;
        result.texels.insert(result.texels.end(), texels, texels + rowSize);
    }
    return result;
}

} // namespace limn::benchmarks
