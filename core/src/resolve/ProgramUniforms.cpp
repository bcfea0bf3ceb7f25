#include "resolve/DrawResolver.h"

#include <algorithm>
#include <cstring>
#include <limn/core/CoreUtils.h>

namespace limn
{

namespace
{

/// Finds the properties of a shader that are declared [Gamma]; `ids` gets them.
void FindGammaProperties(const Shader& shader, std::vector<ShaderPropertyId>& ids)
{
    ids.clear();
    for (const ShaderProperty& property : shader.document().properties)
    {
        if (property.HasAttribute("Gamma"))
        {
            ids.emplace_back(property.name);
        }
    }
}

/// Returns a number or vector that is sRGB in the active colour space, and another value as it is.
ShaderPropertyValue InActiveSpace(const ShaderPropertyValue& value)
{
    if (const auto* number = std::get_if<float>(&value))
    {
        return CoreUtils::ConvertSRGBToActiveColorSpace({*number, 0.0f, 0.0f}).r;
    }
    if (const auto* v = std::get_if<glm::vec4>(&value))
    {
        return CoreUtils::ConvertSRGBToActiveColorSpace({v->x, v->y, v->z, v->w}).vector();
    }
    return value;
}

} // namespace

ProgramUniforms::ProgramUniforms(const PropertyLayout& layout, FrameGlobals& globals)
{
    std::uint32_t end = 0;
    for (const UniformBuffer& buffer : layout.buffers)
    {
        const std::uint32_t offset =
            (end + k_UniformAlignment - 1) / k_UniformAlignment * k_UniformAlignment;
        const bool isOfKeywords = buffer.name == k_DynamicKeywordBuffer; // those are no properties
        for (const UniformMember& member :
             isOfKeywords ? std::span<const UniformMember>() : std::span(buffer.members))
        {
            UniformPlace& added = m_Members.emplace_back(member);
            added.offset += offset;
            GlobalSource& source = m_Sources.emplace_back();
            source.value = globals.PlaceOf(added.id);
            source.texture = source.value;
            const auto number = static_cast<std::uint32_t>(m_Members.size() - 1);
            m_Readers.push_back({added.id, number});
            if (added.unset == UniformPlace::Unset::TexelSize)
            {
                source.texture = globals.PlaceOf(added.texture);
                m_Readers.push_back({added.texture, number});
            }
        }
        end = offset + buffer.size;
        m_Buffers.push_back({buffer.name, offset, static_cast<std::uint32_t>(m_Members.size())});
    }
    std::ranges::sort(m_Readers, {}, &Reader::id);
    m_Globals.resize(end);
}

bool ProgramUniforms::Reads(ShaderPropertyId id) const
{
    return std::ranges::binary_search(m_Readers, id, {}, &Reader::id) ||
           std::ranges::find(m_Buffers, id, &Buffer::id) != m_Buffers.end();
}

bool ProgramUniforms::Write(const PropertySources& sources, MaterialLayer& layer,
                            std::uint64_t globalsVersion, std::span<std::byte> bytes)
{
    if (std::exchange(m_GlobalsVersion, globalsVersion) != globalsVersion)
    {
        WriteGlobals(*sources.globals);
    }
    if (layer.version != sources.material->version())
    {
        WriteLayer(*sources.material, layer);
    }
    if (!m_Unfit.empty() || !layer.fits)
    {
        return false;
    }
    std::ranges::copy(m_Globals, bytes.begin());
    const std::byte* from = layer.bytes.data();
    for (const MaterialLayer::Run& run : layer.runs)
    {
        std::memcpy(bytes.data() + run.offset, from, run.size);
        from += run.size;
    }
    for (const std::uint32_t member : layer.texelSizes)
    {
        WriteUniform(m_Members[member], sources, bytes);
    }
    WriteOwn(sources.block, sources, bytes);
    WriteOwn(sources.lights, sources, bytes);
    return true;
}

void ProgramUniforms::WriteGlobals(const FrameGlobals& globals)
{
    for (std::uint32_t i = 0; i < m_Sources.size(); ++i)
    {
        GlobalSource& source = m_Sources[i];
        const std::uint64_t value = globals.VersionAt(source.value);
        const std::uint64_t texture = globals.VersionAt(source.texture);
        if (source.valueVersion == value && source.textureVersion == texture)
        {
            continue;
        }
        source.valueVersion = value;
        source.textureVersion = texture;
        std::erase(m_Unfit, i);
        if (!WriteUniform(m_Members[i], globals.At(source.value), globals.At(source.texture),
                          m_Globals))
        {
            m_Unfit.push_back(i);
        }
    }
}

void ProgramUniforms::WriteLayer(const Material& material, MaterialLayer& layer)
{
    layer.version = material.version();
    layer.runs.clear();
    layer.bytes.clear();
    layer.texelSizes.clear();
    layer.fits = true;
    m_Layer.resize(m_Globals.size());
    FindGammaProperties(*material.shader(), m_Gamma);
    for (std::uint32_t i = 0; i < m_Members.size(); ++i)
    {
        const UniformPlace& place = m_Members[i];
        const ShaderPropertyValue* value = material.Find(place.id);
        if (value == nullptr)
        {
            if (place.unset == UniformPlace::Unset::TexelSize &&
                material.Find(place.texture) != nullptr)
            {
                layer.texelSizes.push_back(i);
            }
            continue;
        }
        const bool isGamma = std::ranges::find(m_Gamma, place.id) != m_Gamma.end();
        const ShaderPropertyValue converted = isGamma ? InActiveSpace(*value) : 0;
        layer.fits =
            WriteUniform(place, isGamma ? &converted : value, nullptr, m_Layer) && layer.fits;
        if (layer.runs.empty() || layer.runs.back().offset + layer.runs.back().size != place.offset)
        {
            layer.runs.push_back({place.offset, 0});
        }
        layer.runs.back().size += place.size;
        const auto begin = m_Layer.begin() + place.offset;
        layer.bytes.insert(layer.bytes.end(), begin, begin + place.size);
    }
}

/// Writes what the values of a block change.
void ProgramUniforms::WriteOwn(const MaterialPropertyBlock* own, const PropertySources& sources,
                               std::span<std::byte> bytes) const
{
    if (own == nullptr)
    {
        return;
    }
    own->ForEach(
        [&](ShaderPropertyId id, const ShaderPropertyValue&)
        {
            auto reader = std::ranges::lower_bound(m_Readers, id, {}, &Reader::id);
            for (; reader != m_Readers.end() && reader->id == id; ++reader)
            {
                WriteUniform(m_Members[reader->member], sources, bytes);
            }
        });
}

void ProgramUniforms::WriteBuffer(std::size_t buffer, const PropertySources& sources,
                                  std::span<std::byte> bytes) const
{
    const std::uint32_t begin = buffer == 0 ? 0 : m_Buffers[buffer - 1].memberEnd;
    for (std::uint32_t i = begin; i < m_Buffers[buffer].memberEnd; ++i)
    {
        WriteUniform(m_Members[i], sources, bytes);
    }
}

} // namespace limn
