#include "resolve/StorageSlots.h"

#include "material/PropertyValues.h"

namespace limn
{

namespace
{

using Target = GraphicsBuffer::Target;

void ExpectValid(const GraphicsBuffer& buffer, const std::string& name,
                 const PropertySources& sources)
{
    if (!buffer.IsValid())
    {
        throw DrawError(sources.Subject(name) + " is set to buffer '" + buffer.name() +
                        "', which is released");
    }
}

/// Returns the targets for which a buffer must be made.
Target TargetsFor(const StorageBufferBinding& declared)
{
    constexpr Target k_Elements =
        Target::Structured | Target::Append | Target::Counter | Target::IndirectArguments;
    return declared.isCounter     ? Target::Append | Target::Counter
           : declared.stride == 0 ? Target::Raw | Target::IndirectArguments
                                  : k_Elements;
}

const char* NamesOf(const StorageBufferBinding& declared)
{
    return declared.isCounter     ? "GraphicsBuffer::Target::Append or Counter"
           : declared.stride == 0 ? "GraphicsBuffer::Target::Raw"
                                  : "GraphicsBuffer::Target::Structured";
}

} // namespace

std::shared_ptr<const Texture> FindTexture(ShaderPropertyId id, const PropertySources& sources)
{
    const ShaderPropertyValue* value = sources.Find(id);
    if (value == nullptr)
    {
        return nullptr;
    }
    const auto* texture = std::get_if<std::shared_ptr<const Texture>>(value);
    if (texture == nullptr)
    {
        const bool isBuffer = std::holds_alternative<BufferRange>(*value);
        throw DrawError(sources.Subject(id.name()) + " is a texture in the shader but is set to " +
                        (isBuffer ? "a buffer" : "a number"));
    }
    return *texture;
}

const BufferRange* FindBuffer(ShaderPropertyId id, const PropertySources& sources)
{
    const ShaderPropertyValue* value = sources.Find(id);
    const auto* range = std::get_if<BufferRange>(value);
    if (value != nullptr && range == nullptr)
    {
        throw DrawError(sources.Subject(id.name()) +
                        " is a buffer in the shader but is set to something else");
    }
    return range != nullptr && range->buffer ? range : nullptr;
}

BufferSlot UniformSlot(const UniformBuffer& declared, const BufferRange& range,
                       const PropertySources& sources)
{
    const GraphicsBuffer& buffer = *range.buffer;
    ExpectValid(buffer, declared.name, sources);
    const std::size_t size = range.size != 0 ? range.size : buffer.size() - range.offset;
    if (!buffer.Has(Target::Constant))
    {
        throw DrawError(sources.Subject(declared.name) + " is a cbuffer, but buffer '" +
                        buffer.name() + "' is not made with GraphicsBuffer::Target::Constant");
    }
    if (size < declared.size)
    {
        throw DrawError(sources.Subject(declared.name) + " is a cbuffer of " +
                        std::to_string(declared.size) + " bytes in the shader, but has " +
                        std::to_string(size) + " of buffer '" + buffer.name() + "'");
    }
    return {declared.binding, range.buffer, range.offset, declared.size,
            declared.stages,  true,         false};
}

BufferSlot StorageSlot(const StorageBufferBinding& declared, ShaderPropertyId id,
                       const PropertySources& sources)
{
    const BufferRange* range = FindBuffer(id, sources);
    if (range == nullptr)
    {
        FailUnset<GraphicsBuffer>(id, "buffer", sources);
    }
    const GraphicsBuffer& buffer = *range->buffer;
    ExpectValid(buffer, declared.name, sources);
    if (sources.isCopy)
    {
        const auto all = static_cast<std::uint32_t>((buffer.bytes().size() + 3) / 4 * 4);
        return {declared.binding,  range->buffer, 0, all, declared.stages, false,
                declared.isWritten};
    }
    if (!buffer.Has(TargetsFor(declared)))
    {
        throw DrawError(sources.Subject(declared.name) + " is set to buffer '" + buffer.name() +
                        "', which the shader uses otherwise than it is made for; make it with " +
                        NamesOf(declared));
    }
    const auto stride = static_cast<std::uint32_t>(buffer.stride());
    if (!declared.isCounter && declared.stride != 0 && declared.stride != stride)
    {
        throw DrawError(sources.Subject(declared.name) + " has elements of " +
                        std::to_string(declared.stride) + " bytes in the shader, but buffer '" +
                        buffer.name() + "' of " + std::to_string(stride));
    }
    const std::size_t offset = declared.isCounter ? buffer.counterOffset() : 0;
    const std::size_t size = declared.isCounter ? sizeof(std::uint32_t) : buffer.size();
    return {declared.binding,
            range->buffer,
            static_cast<std::uint32_t>(offset),
            static_cast<std::uint32_t>(size),
            declared.stages,
            false,
            declared.isWritten};
}

BufferSlot ArgumentsSlot(const BufferRange& arguments, const PropertySources& sources)
{
    if (!arguments.buffer->IsValid())
    {
        throw DrawError(sources.Subject() + ": its arguments come from buffer '" +
                        arguments.buffer->name() + "', which is released");
    }
    return {k_ArgumentsBinding,
            arguments.buffer,
            arguments.offset,
            arguments.size,
            ShaderStage::Indirect,
            false,
            false};
}

void ExpectFits(UniformType declared, TextureDimension dimension, const Texture& texture,
                ShaderPropertyId id, const PropertySources& sources)
{
    if (texture.dimension() != dimension)
    {
        throw DrawError(sources.Subject(id.name()) + " is a " + ToString(dimension) +
                        " texture in the shader but is set to the " +
                        ToString(texture.dimension()) + " texture '" + texture.name() + "'");
    }
    const auto text = [](UniformType type)
    {
        return type == UniformType::Int ? "int" : type == UniformType::UInt ? "uint" : "float";
    };
    const UniformType type = ComponentType(texture.graphicsFormat());
    if (type != declared)
    {
        throw DrawError(sources.Subject(id.name()) + " is a texture of " + text(declared) +
                        " in the shader, but '" + texture.name() + "' of " +
                        ToString(texture.graphicsFormat()) + " is one of " + text(type));
    }
}

StorageTextureSlot WritableSlot(const StorageTextureBinding& declared, ShaderPropertyId id,
                                const PropertySources& sources)
{
    const std::shared_ptr<const Texture> texture = FindTexture(id, sources);
    if (!texture)
    {
        FailUnset<Texture>(id, "texture", sources);
    }
    auto target = std::dynamic_pointer_cast<const RenderTexture>(texture);
    if (!target || !target->descriptor().enableRandomWrite)
    {
        throw DrawError(sources.Subject(declared.name) + " is written to, but texture '" +
                        texture->name() + "' is " +
                        (target ? "made without enableRandomWrite" : "no render texture"));
    }
    ExpectFits(declared.type, declared.dimension, *target, id, sources);
    return {declared.binding, std::move(target)};
}

} // namespace limn
