#include "frame/FrameDescriptors.h"

#include "device/Translate.h"
#include <algorithm>
#include <limn/base/NumberText.h>

namespace limn::vulkan
{

namespace
{

/// The bindings of a draw without bindings.
const DrawBindings k_NoBindings;

[[noreturn]] void RefuseMissing(const std::string& kind, const std::string& name,
                                std::uint32_t binding)
{
    throw ContractError("a draw binds no " + kind + " for '" + name + "' (binding " +
                        std::to_string(binding) + "), which its shader reads");
}

template <typename Slot>
const Slot& FindSlot(const std::vector<Slot>& slots, std::uint32_t binding, const char* kind,
                     const std::string& name)
{
    const auto found = std::ranges::find(slots, binding, &Slot::binding);
    if (found == slots.end())
    {
        RefuseMissing(kind, name, binding);
    }
    return *found;
}

/// Returns the draw's buffer at a binding, or null if it has none.
const BufferSlot* FindBuffer(const DrawBindings& bindings, std::uint32_t binding)
{
    const auto found = std::ranges::find(bindings.buffers, binding, &BufferSlot::binding);
    return found == bindings.buffers.end() ? nullptr : &*found;
}

void AddBuffer(SetContent& content, const BufferSlot& slot, DeviceResources& resources)
{
    content.AddBuffer(
        slot.binding,
        slot.isUniform ? VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER : VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
        {resources.buffers.Find(*slot.buffer)->buffer.handle.get(), slot.offset, slot.size});
}

/// @param verb  what the shader does: "read"
void RequireUsage(const PooledImage& image, const char* verb, const std::string& property,
                  TextureUsage needed)
{
    if (image.use.usage != needed)
    {
        throw ContractError("texture '" + image.name + "' is " + verb + " as '" + property +
                            "' while its use is " + ToString(image.use.usage) +
                            "; a barrier must make it " + ToString(needed));
    }
}

void AddStorageTextures(SetContent& content, const PropertyLayout& layout,
                        const DrawBindings& bindings, DeviceResources& resources)
{
    for (const StorageTextureBinding& texture : layout.storageTextures)
    {
        const StorageTextureSlot& slot =
            FindSlot(bindings.storageTextures, texture.binding, "texture", texture.name);
        const PooledImage& image = *resources.images.Find(*slot.texture);
        RequireUsage(image, "written to", texture.name, TextureUsage::RandomWrite);
        content.AddImage(texture.binding, VK_DESCRIPTOR_TYPE_STORAGE_IMAGE,
                         {VK_NULL_HANDLE, image.view.get(), VK_IMAGE_LAYOUT_GENERAL});
    }
}

void AddUniforms(SetContent& content, const PropertyLayout& layout, const DrawBindings& bindings,
                 const VkDescriptorBufferInfo& uploaded, DeviceResources& resources)
{
    for (const UniformBuffer& buffer : layout.buffers)
    {
        if (const BufferSlot* slot = FindBuffer(bindings, buffer.binding))
        {
            AddBuffer(content, *slot, resources);
            continue;
        }
        const UniformSlice& slice =
            FindSlot(bindings.uniforms, buffer.binding, "uniform data", buffer.name);
        const bool inside =
            slice.offset <= uploaded.range && slice.size <= uploaded.range - slice.offset;
        if (slice.size < buffer.size || !inside || slice.offset % k_UniformAlignment != 0)
        {
            throw ContractError(
                "the uniform data of '" + buffer.name + "' have " + CountText(slice.size, "byte") +
                " and begin at byte " + std::to_string(slice.offset) + "; the shader reads " +
                CountText(buffer.size, "byte") + ", which must begin at a multiple of " +
                std::to_string(k_UniformAlignment) + " and end within the frame's " +
                CountText(uploaded.range, "byte"));
        }
        content.AddBuffer(buffer.binding, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER,
                          {uploaded.buffer, uploaded.offset + slice.offset, slice.size});
    }
}

void RequireDimension(const Texture& texture, const TextureBinding& binding)
{
    if (texture.dimension() != binding.dimension)
    {
        throw ContractError("texture '" + texture.name() + "' is read as '" + binding.name +
                            "': it is a " + ToString(texture.dimension()) +
                            " texture; the shader reads a " + ToString(binding.dimension));
    }
}

void RequireReader(const PooledImage& image, const TextureBinding& binding)
{
    const ShaderStage readers = image.use.readers;
    if (readers != ShaderStage::None && !HasAll(readers, binding.stages))
    {
        throw ContractError("texture '" + image.name + "' is read as '" + binding.name +
                            "' by a function that its last barrier did not make it readable for");
    }
}

void RequireResolved(const PooledImage& image, const std::string& property)
{
    if (image.use.isStale)
    {
        throw ContractError("texture '" + image.name + "' is read as '" + property +
                            "': the last pass that drew into it did not resolve its " +
                            std::to_string(image.samples) + " samples per texel");
    }
}

void AddTextures(SetContent& content, const PropertyLayout& layout, const DrawBindings& bindings,
                 DeviceResources& resources, std::uint64_t number)
{
    for (const TextureBinding& texture : layout.textures)
    {
        const TextureSlot& slot =
            FindSlot(bindings.textures, texture.binding, "texture", texture.name);
        const PooledImage& image = *resources.images.Find(*slot.texture);
        RequireUsage(image, "read", texture.name, TextureUsage::ShaderRead);
        RequireReader(image, texture);
        RequireDimension(*slot.texture, texture);
        RequireResolved(image, texture.name);
        const SamplerState& state = slot.sampler ? *slot.sampler : slot.texture->sampler();
        content.AddImage(texture.binding,
                         texture.combinedSampler ? VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER
                                                 : VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE,
                         {texture.combinedSampler ? resources.samplers.Get(state, number)
                                                  : VkSampler{VK_NULL_HANDLE},
                          image.sampledView(), VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL});
    }
    for (const SamplerBinding& sampler : layout.samplers)
    {
        SamplerState state =
            FindSlot(bindings.samplers, sampler.binding, "sampler", sampler.name).state;
        state.comparison = sampler.comparison;
        content.AddImage(
            sampler.binding, VK_DESCRIPTOR_TYPE_SAMPLER,
            {resources.samplers.Get(state, number), VK_NULL_HANDLE, VK_IMAGE_LAYOUT_UNDEFINED});
    }
}

/// Returns the number of per-draw elements that are bound at once. It is such that the next ones
/// begin at an offset which a binding may have.
std::uint32_t PieceElements(const VkPhysicalDeviceLimits& limits)
{
    constexpr std::uint32_t k_Aligned = 8;
    static_assert(k_Aligned * sizeof(PerDrawData) % k_UniformAlignment == 0);
    const std::uint32_t most = limits.maxStorageBufferRange / std::uint32_t{sizeof(PerDrawData)};
    return most / k_Aligned * k_Aligned;
}

} // namespace

FrameDescriptors::FrameDescriptors(const VulkanContext& context, DeviceResources& resources,
                                   FrameSlot& slot, const CompiledFrame& frame,
                                   DescriptorLists& lists, std::uint64_t number)
    : m_Resources(resources),
      m_Slot(slot),
      m_Frame(frame),
      m_Lists(lists),
      m_Number(number),
      m_PieceElements(PieceElements(context.capabilities().limits))
{
    FrameRecording& recording = slot.recording();
    recording.data.emplace(frame, slot.data(), m_PieceElements, context.capabilities().limits);
    recording.objects = VK_NULL_HANDLE;
    m_Data = &*recording.data;
    const VkDescriptorBufferInfo& perDraw = m_Data->perDraw();
    m_Lists.sets.clear();
    AddPieces(perDraw.buffer, perDraw.offset, frame.perDraw.size(), m_Lists.pieces[0]);
    const std::size_t objects = frame.objects ? frame.objects->count() : 0;
    AddPieces(VK_NULL_HANDLE, 0, objects, m_Lists.pieces[1]); // see UseObjects
}

void FrameDescriptors::AddPieces(VkBuffer buffer, VkDeviceSize offset, std::size_t count,
                                 std::vector<VkDescriptorBufferInfo>& pieces) const
{
    constexpr VkDeviceSize k_Size = sizeof(PerDrawData);
    pieces.clear();
    for (std::size_t first = 0; first < count; first += m_PieceElements)
    {
        pieces.push_back({buffer, offset + first * k_Size,
                          std::min<std::size_t>(count - first, m_PieceElements) * k_Size});
    }
}

void FrameDescriptors::RequireInstances(const DrawCommand& draw) const
{
    const std::uint64_t end = std::uint64_t{draw.firstInstance} + draw.instanceCount;
    const std::size_t count =
        m_Frame.instances.empty() ? m_Frame.perDraw.size() : m_Frame.instances.size();
    if (end > count)
    {
        throw ContractError("a draw reads per-draw elements " + std::to_string(draw.firstInstance) +
                            " to " + std::to_string(end) + "; the frame has " +
                            std::to_string(count));
    }
}

InstanceRun FrameDescriptors::RunFrom(const DrawCommand& draw, std::uint32_t skipped) const
{
    const std::uint32_t first = draw.firstInstance + skipped;
    const std::uint32_t left = draw.instanceCount - skipped;
    if (m_Frame.Setup(draw).program->layout.storageBuffers.empty())
    {
        return {0, first, left, draw.firstInstance};
    }
    RequireInstances(draw);
    const std::size_t pieces = m_Lists.pieces[draw.drawsObjects ? 1 : 0].size();
    const std::uint32_t piece = m_Frame.Element(first) / m_PieceElements;
    if (piece >= pieces)
    {
        throw ContractError("a draw reads per-draw element " +
                            std::to_string(m_Frame.Element(first)) + ", which the frame lacks");
    }
    std::uint32_t count = pieces == 1 ? left : 1;
    while (count < left && m_Frame.Element(first + count) / m_PieceElements == piece)
    {
        ++count;
    }
    return {piece, first, count, draw.firstInstance};
}

VkDescriptorSet FrameDescriptors::Get(const DrawCommand& draw, const ProgramObjects& pass,
                                      std::size_t piece)
{
    const DrawSetup& setup = m_Frame.Setup(draw);
    return Get(setup.program->layout, setup.bindings ? *setup.bindings : k_NoBindings, pass,
               draw.drawsObjects, piece);
}

VkDescriptorSet FrameDescriptors::Get(const DispatchCommand& dispatch, const ProgramObjects& kernel)
{
    const DispatchSetup& setup = m_Frame.Setup(dispatch);
    return Get(setup.program->layout, *setup.bindings, kernel, false, 0);
}

VkDescriptorSet FrameDescriptors::Get(const PropertyLayout& layout, const DrawBindings& bindings,
                                      const ProgramObjects& program, bool readsObjects,
                                      std::size_t piece)
{
    VkDescriptorSet& set = m_Lists.sets[{&bindings, program.setLayout.get(), readsObjects, piece}];
    if (set == VK_NULL_HANDLE)
    {
        if (readsObjects)
        {
            UseObjects();
        }
        Use(bindings);
        set = Create(layout, bindings, program.setLayout.get(),
                     m_Lists.pieces[readsObjects ? 1 : 0], piece);
    }
    return set;
}

void FrameDescriptors::Use(const DrawBindings& bindings)
{
    for (const TextureSlot& slot : bindings.textures)
    {
        m_Resources.images.UseResolved(slot.texture, m_Number);
    }
    for (const StorageTextureSlot& slot : bindings.storageTextures)
    {
        m_Resources.images.Use(slot.texture, m_Number);
    }
    for (const BufferSlot& slot : bindings.buffers)
    {
        m_Resources.buffers.Use(slot.buffer, m_Number, m_Slot.uploads());
    }
}

VkBuffer FrameDescriptors::Use(const std::shared_ptr<const GraphicsBuffer>& buffer)
{
    return m_Resources.buffers.Use(buffer, m_Number, m_Slot.uploads()).buffer.handle.get();
}

void FrameDescriptors::UseObjects()
{
    FrameRecording& recording = m_Slot.recording();
    if (!m_Frame.objects || recording.objects != VK_NULL_HANDLE)
    {
        return;
    }
    recording.objects = m_Resources.objects.Update(m_Frame.objects, m_Number, m_Slot.uploads());
    recording.objectCount = m_Frame.objects->count();
    for (VkDescriptorBufferInfo& piece : m_Lists.pieces[1])
    {
        piece.buffer = recording.objects;
    }
}

VkDescriptorSet FrameDescriptors::Create(const PropertyLayout& layout, const DrawBindings& bindings,
                                         VkDescriptorSetLayout setLayout,
                                         const std::vector<VkDescriptorBufferInfo>& pieces,
                                         std::size_t piece)
{
    m_Lists.content.Clear(setLayout);
    AddUniforms(m_Lists.content, layout, bindings, m_Data->uniforms(), m_Resources);
    AddTextures(m_Lists.content, layout, bindings, m_Resources, m_Number);
    AddStorageTextures(m_Lists.content, layout, bindings, m_Resources);
    for (const StorageBufferBinding& buffer : layout.storageBuffers)
    {
        if (const BufferSlot* slot = FindBuffer(bindings, buffer.binding))
        {
            AddBuffer(m_Lists.content, *slot, m_Resources);
            continue;
        }
        const bool isInstances = buffer.name == "limn_Instances";
        if (!isInstances && bindings.perDrawBinding != buffer.binding)
        {
            RefuseMissing("structured buffer", buffer.name, buffer.binding);
        }
        m_Lists.content.AddBuffer(buffer.binding, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
                                  isInstances ? m_Data->instances() : pieces.at(piece));
    }
    return m_Slot.descriptors().Get(m_Lists.content);
}

} // namespace limn::vulkan
