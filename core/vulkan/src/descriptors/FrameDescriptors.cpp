#include "descriptors/FrameDescriptors.h"

#include "device/Translate.h"
#include <algorithm>

namespace limn::vulkan
{

namespace
{

/// What a draw without bindings binds.
const DrawBindings k_NoBindings;
const std::vector<TextureSlot> k_NoTextures;

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
    const auto found = std::find_if(slots.begin(), slots.end(),
                                    [&](const Slot& slot) { return slot.binding == binding; });
    if (found == slots.end())
    {
        RefuseMissing(kind, name, binding);
    }
    return *found;
}

void AddUniforms(SetContent& content, const PropertyLayout& layout, const DrawBindings& bindings,
                 const UploadedBytes& uploaded, std::size_t uploadedSize)
{
    for (const UniformBuffer& buffer : layout.buffers)
    {
        const UniformSlice& slice =
            FindSlot(bindings.uniforms, buffer.binding, "uniform data", buffer.name);
        const bool inside =
            slice.offset <= uploadedSize && slice.size <= uploadedSize - slice.offset;
        if (slice.size < buffer.size || !inside || slice.offset % k_UniformAlignment != 0)
        {
            throw ContractError("the uniform data of '" + buffer.name + "' are " +
                                std::to_string(slice.size) + " bytes at " +
                                std::to_string(slice.offset) + "; the shader reads " +
                                std::to_string(buffer.size) + ", at a multiple of " +
                                std::to_string(k_UniformAlignment) + ", of the frame's " +
                                std::to_string(uploadedSize));
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

void RequireResolved(const PooledImage& image, const std::string& property)
{
    if (image.isStale)
    {
        throw ContractError("texture '" + image.name + "' is read as '" + property +
                            "': the last pass that drew into it did not resolve its " +
                            std::to_string(image.samples) + " samples a texel");
    }
}

void AddTextures(SetContent& content, const PropertyLayout& layout, const DrawBindings& bindings,
                 DeviceResources& resources)
{
    for (const TextureBinding& texture : layout.textures)
    {
        const TextureSlot& slot =
            FindSlot(bindings.textures, texture.binding, "texture", texture.name);
        const PooledImage& image = *resources.images.Find(*slot.texture);
        if (image.usage != TextureUsage::ShaderRead)
        {
            throw ContractError("texture '" + image.name + "' is read as '" + texture.name +
                                "' while its use is " + ToString(image.usage) +
                                "; a barrier must make it ShaderRead");
        }
        RequireDimension(*slot.texture, texture);
        RequireResolved(image, texture.name);
        const SamplerState& state = slot.sampler ? *slot.sampler : slot.texture->sampler();
        content.AddImage(
            texture.binding,
            texture.combinedSampler ? VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER
                                    : VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE,
            {texture.combinedSampler ? resources.samplers.Get(state) : VkSampler{VK_NULL_HANDLE},
             image.sampledView(), VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL});
    }
    for (const SamplerBinding& sampler : layout.samplers)
    {
        SamplerState state =
            FindSlot(bindings.samplers, sampler.binding, "sampler", sampler.name).state;
        state.comparison = sampler.comparison;
        content.AddImage(
            sampler.binding, VK_DESCRIPTOR_TYPE_SAMPLER,
            {resources.samplers.Get(state), VK_NULL_HANDLE, VK_IMAGE_LAYOUT_UNDEFINED});
    }
}

} // namespace

FrameDescriptors::FrameDescriptors(const VulkanContext& context, DeviceResources& resources,
                                   FrameSlot& slot, const CompiledFrame& frame)
    : m_Context(context),
      m_Resources(resources),
      m_Slot(slot),
      m_Frame(frame),
      m_PieceElements(context.capabilities().limits.maxStorageBufferRange /
                      std::uint32_t{sizeof(PerDrawData)})
{
    if (!frame.uniformData.empty())
    {
        m_Uniforms = slot.upload().Upload(frame.uniformData);
    }
    for (std::span rest{frame.perDraw}; !rest.empty();)
    {
        const auto piece = rest.first(std::min<std::size_t>(rest.size(), m_PieceElements));
        const UploadedBytes bytes = slot.upload().Upload(std::as_bytes(piece));
        m_PerDraw.push_back({bytes.buffer, bytes.offset, piece.size_bytes()});
        rest = rest.subspan(piece.size());
    }
}

InstanceRun FrameDescriptors::RunFrom(const DrawCommand& draw, std::uint32_t skipped) const
{
    const std::uint32_t element = draw.firstInstance + skipped;
    const std::uint32_t left = draw.instanceCount - skipped;
    if (draw.program->layout.storageBuffers.empty())
    {
        return {0, element, left, draw.firstInstance};
    }
    const std::uint32_t first = element % m_PieceElements;
    // May lie before the piece; SV_InstanceID, the difference, wraps around to what it should be.
    const std::uint32_t base = first - skipped;
    return {element / m_PieceElements, first, std::min(left, m_PieceElements - first), base};
}

VkDescriptorSet FrameDescriptors::Get(const DrawCommand& draw, const ProgramObjects& pass,
                                      std::size_t piece, std::uint64_t number)
{
    VkDescriptorSet& set = m_Sets[{draw.bindings.get(), pass.setLayout.get(), piece}];
    if (set == VK_NULL_HANDLE)
    {
        for (const TextureSlot& slot : draw.bindings ? draw.bindings->textures : k_NoTextures)
        {
            m_Resources.images.UseResolved(slot.texture, number);
        }
        set = Create(draw.program->layout, draw.bindings ? *draw.bindings : k_NoBindings,
                     pass.setLayout.get(), piece);
    }
    return set;
}

VkDescriptorSet FrameDescriptors::Create(const PropertyLayout& layout, const DrawBindings& bindings,
                                         VkDescriptorSetLayout setLayout, std::size_t piece)
{
    m_Content.Clear(setLayout);
    AddUniforms(m_Content, layout, bindings, m_Uniforms, m_Frame.uniformData.size());
    AddTextures(m_Content, layout, bindings, m_Resources);
    for (const StorageBufferBinding& buffer : layout.storageBuffers)
    {
        if (bindings.perDrawBinding != buffer.binding)
        {
            RefuseMissing("structured buffer", buffer.name, buffer.binding);
        }
        m_Content.AddBuffer(buffer.binding, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, m_PerDraw.at(piece));
    }
    return m_Slot.descriptors().Get(m_Content);
}

} // namespace limn::vulkan
