#include <limn/core/MaterialPropertyBlock.h>

#include "material/PropertyValues.h"

#include <algorithm>
#include <cmath>
#include <limn/base/Diagnostic.h>
#include <limn/core/CoreUtils.h>
#include <limn/core/Mathf.h>

namespace limn
{

namespace
{

struct AllFinite
{
    bool operator()(float number) const { return std::isfinite(number); }
    bool operator()(int) const { return true; }
    bool operator()(const std::shared_ptr<const Texture>&) const { return true; }
    bool operator()(const BufferRange&) const { return true; }
    bool operator()(const ConsecutiveParams& params) const
    {
        const auto* floats = std::get_if<std::vector<float>>(&params.values);
        return floats == nullptr || std::ranges::all_of(*floats, *this);
    }
    bool operator()(const Color& color) const { return (*this)(color.vector()); }
    bool operator()(const glm::vec4& v) const
    {
        return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) && std::isfinite(v.w);
    }
    bool operator()(const glm::mat4& m) const
    {
        return (*this)(m[0]) && (*this)(m[1]) && (*this)(m[2]) && (*this)(m[3]);
    }
    template <typename Element>
    bool operator()(const PropertyArray<Element>& array) const
    {
        return std::all_of(array.begin(), array.end(), *this);
    }
};

struct HasNoElements
{
    template <typename Element>
    bool operator()(const PropertyArray<Element>& array) const
    {
        return array.empty();
    }
    bool operator()(const ConsecutiveParams& params) const
    {
        return std::visit([](const auto& values) { return values.empty(); }, params.values);
    }
    template <typename Other>
    bool operator()(const Other&) const
    {
        return false;
    }
};

} // namespace

bool isFinite(const ShaderPropertyValue& value)
{
    return std::visit(AllFinite(), value);
}

bool isEmptyArray(const ShaderPropertyValue& value)
{
    return std::visit(HasNoElements(), value);
}

std::shared_ptr<const Texture> TextureOf(const RTHandle& handle, ShaderPropertyId id,
                                         std::string_view owner)
{
    if (handle && !handle.rt())
    {
        throw ContractError(std::string(owner) + "property '" + id.name() +
                            "' is set to a handle around an identifier, which only a command "
                            "buffer can look up; use SetGlobalTexture");
    }
    return handle.rt();
}

void RequireFinite(const ShaderPropertyValue& value, ShaderPropertyId id, std::string_view owner)
{
    if (std::visit([](const auto& one) { return AllFinite()(one) && !HasNoElements()(one); },
                   value))
    {
        return;
    }
    if (isEmptyArray(value))
    {
        throw ContractError(std::string(owner) + "property '" + id.name() +
                            "' is set to an array without elements");
    }
    throw ContractError(std::string(owner) + "property '" + id.name() +
                        "' is not finite; NaN and infinity reach no shader");
}

BufferRange ConstantRange(std::shared_ptr<const GraphicsBuffer> buffer, int offset, int size)
{
    constexpr int k_Alignment = 256; // the most that a device asks for
    if (buffer &&
        (offset < 0 || size < 0 || offset % k_Alignment != 0 ||
         static_cast<std::size_t>(offset) + static_cast<std::size_t>(size) > buffer->size()))
    {
        throw ContractError(
            "SetConstantBuffer: the part is " + std::to_string(size) + " bytes from byte " +
            std::to_string(offset) + " of '" + buffer->name() + "', which has " +
            std::to_string(buffer->size()) +
            " bytes; a part must begin at a multiple of 256 and end within the buffer");
    }
    return {std::move(buffer), static_cast<std::uint32_t>(offset),
            static_cast<std::uint32_t>(size)};
}

void MaterialPropertyBlock::Put(ShaderPropertyId id, ShaderPropertyValue value)
{
    m_HasBuffers = m_HasBuffers || std::holds_alternative<BufferRange>(value);
    if (const std::uint32_t place = FindPlace(id))
    {
        m_Values[place - 1] = std::move(value);
        return;
    }
    const Slot slot{id, static_cast<std::uint32_t>(m_Values.size())};
    m_Values.push_back(std::move(value));
    m_Slots.insert(std::ranges::lower_bound(m_Slots, id, {}, &Slot::id), slot);
}

void MaterialPropertyBlock::Set(ShaderPropertyId id, ShaderPropertyValue value)
{
    RequireFinite(value, id);
    Put(id, std::move(value));
}

void MaterialPropertyBlock::SetTexture(ShaderPropertyId id, const RTHandle& value)
{
    Set(id, TextureOf(value, id));
}

void MaterialPropertyBlock::SetAll(const MaterialPropertyBlock& other)
{
    for (const Slot& slot : other.m_Slots)
    {
        Put(slot.id, other.m_Values[slot.value]);
    }
}

void MaterialPropertyBlock::Remove(ShaderPropertyId id)
{
    const auto removed = std::ranges::lower_bound(m_Slots, id, {}, &Slot::id);
    if (removed == m_Slots.end() || removed->id != id)
    {
        return;
    }
    // The last value takes the place of the removed one.
    const auto last = static_cast<std::uint32_t>(m_Values.size() - 1);
    const auto moved = std::ranges::find(m_Slots, last, &Slot::value);
    moved->value = removed->value;
    if (removed->value != last)
    {
        m_Values[removed->value] = std::move(m_Values.back());
    }
    m_Values.pop_back();
    m_Slots.erase(removed);
}

void MaterialPropertyBlock::Clear()
{
    m_Slots.clear();
    m_Values.clear();
    m_HasBuffers = false;
}

float MaterialPropertyBlock::GetFloat(ShaderPropertyId id) const
{
    const ShaderPropertyValue* value = Find(id);
    const int* number = std::get_if<int>(value);
    return number != nullptr ? static_cast<float>(*number) : CopyOf<float>(value);
}

int MaterialPropertyBlock::GetInt(ShaderPropertyId id) const
{
    const ShaderPropertyValue* value = Find(id);
    const float* number = std::get_if<float>(value);
    return number != nullptr ? Mathf::ToInt(*number) : CopyOf<int>(value);
}

glm::vec4 MaterialPropertyBlock::GetVector(ShaderPropertyId id) const
{
    const ShaderPropertyValue* value = Find(id);
    const Color* color = std::get_if<Color>(value);
    return color != nullptr ? CoreUtils::ConvertSRGBToActiveColorSpace(*color).vector()
                            : CopyOf<glm::vec4>(value);
}

Color MaterialPropertyBlock::GetColor(ShaderPropertyId id) const
{
    if (const auto* vector = std::get_if<glm::vec4>(Find(id)))
    {
        return FromActiveColorSpace({vector->x, vector->y, vector->z, vector->w});
    }
    return Has<Color>(id) ? Get<Color>(id) : Color::clear;
}

bool MaterialPropertyBlock::HasConstantBuffer(ShaderPropertyId id) const
{
    const std::shared_ptr<const GraphicsBuffer> buffer = GetBuffer(id);
    return buffer && buffer->Has(GraphicsBuffer::Target::Constant);
}

} // namespace limn
