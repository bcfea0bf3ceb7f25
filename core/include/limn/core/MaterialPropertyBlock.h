#pragma once

#include <algorithm>
#include <glm/mat4x4.hpp>
#include <initializer_list>
#include <limn/core/Color.h>
#include <limn/core/GraphicsBuffer.h>
#include <limn/core/PooledAllocator.h>
#include <limn/core/RTHandle.h>
#include <limn/core/ShaderId.h>
#include <limn/core/Texture.h>
#include <memory>
#include <span>
#include <variant>
#include <vector>

namespace limn
{

/// The elements of an array property, copied from the values that it is made from.
template <typename T>
class PropertyArray
{
public:
    PropertyArray() = default;
    PropertyArray(std::initializer_list<T> values) : m_Values(values) {}
    PropertyArray(std::span<const T> values) : m_Values(values.begin(), values.end()) {}
    PropertyArray(const std::vector<T>& values) : PropertyArray(std::span<const T>(values)) {}

    std::size_t size() const { return m_Values.size(); }
    bool empty() const { return m_Values.empty(); }
    const T& operator[](std::size_t index) const { return m_Values[index]; }
    auto begin() const { return m_Values.begin(); }
    auto end() const { return m_Values.end(); }
    bool operator==(const PropertyArray&) const = default;

private:
    std::vector<T, PooledAllocator<T>> m_Values;
};

/// The components that ComputeShader::SetFloats and SetInts set, which are consecutive in memory.
struct ConsecutiveParams
{
    std::variant<std::vector<float>, std::vector<int>> values;
    bool operator==(const ConsecutiveParams&) const = default;
};

/// The value of a shader property. A Color is sRGB and reaches the shader in the colour space of
/// QualitySettings; a vec4 is passed as it is. There must be no more than eleven kinds: up to there
/// std::visit is a switch.
using ShaderPropertyValue =
    std::variant<float, int, glm::vec4, Color, glm::mat4, PropertyArray<float>,
                 PropertyArray<glm::vec4>, PropertyArray<glm::mat4>, std::shared_ptr<const Texture>,
                 BufferRange, ConsecutiveParams>;

/// Returns the range of a buffer for a cbuffer.
/// @throws ContractError unless the offset is a multiple of 256, both are not negative, and the end
///         lies in the buffer
BufferRange ConstantRange(std::shared_ptr<const GraphicsBuffer> buffer, int offset, int size);

/// Values of shader properties by name. Draws look values up in the block of the draw, then in the
/// material, then in the globals. Unity: UnityEngine.MaterialPropertyBlock (2022.3).
class MaterialPropertyBlock
{
public:
    void SetFloat(ShaderPropertyId id, float value) { Set(id, value); }
    void SetFloat(ShaderPropertyId id, detail::WholeNumber auto value)
    {
        SetFloat(id, static_cast<float>(value));
    }
    void SetInt(ShaderPropertyId id, int value) { Set(id, value); }
    void SetInteger(ShaderPropertyId id, int value) { Set(id, value); }
    void SetVector(ShaderPropertyId id, const glm::vec4& value) { Set(id, value); }
    void SetVector(ShaderPropertyId id, const detail::MadeVector4 auto& value)
    {
        SetVector(id, detail::ToVector4(value));
    }
    void SetColor(ShaderPropertyId id, const Color& value) { Set(id, value); } ///< sRGB
    void SetMatrix(ShaderPropertyId id, const glm::mat4& value) { Set(id, value); }
    // A shader gets as many elements as both its array and this one have; the rest of its own are
    // 0.
    void SetFloatArray(ShaderPropertyId id, std::vector<float> v) { Set(id, std::move(v)); }
    void SetVectorArray(ShaderPropertyId id, std::vector<glm::vec4> v) { Set(id, std::move(v)); }
    void SetMatrixArray(ShaderPropertyId id, std::vector<glm::mat4> v) { Set(id, std::move(v)); }
    void SetTexture(ShaderPropertyId id, std::shared_ptr<const Texture> v)
    {
        Set(id, std::move(v));
    }
    /// @throws ContractError for a handle that wraps an identifier: only command buffers know what
    ///         that stands for
    void SetTexture(ShaderPropertyId id, const RTHandle& value);
    /// Sets the buffer that a StructuredBuffer or ByteAddressBuffer of this name reads.
    void SetBuffer(ShaderPropertyId id, std::shared_ptr<const GraphicsBuffer> value)
    {
        Set(id, BufferRange{std::move(value), 0, 0});
    }
    /// Makes the cbuffer of this name read from the buffer, whatever its members are set to.
    /// @param offset, size  in bytes; the offset must be a multiple of 256; a size of 0 goes to the
    ///     end
    void SetConstantBuffer(ShaderPropertyId id, std::shared_ptr<const GraphicsBuffer> value,
                           int offset, int size)
    {
        Set(id, ConstantRange(std::move(value), offset, size));
    }
    /// @throws ContractError naming the property, if a number is not finite or an array has no
    ///     elements; all functions above throw it, too
    void Set(ShaderPropertyId id, ShaderPropertyValue value);
    /// Sets all values of another block.
    void SetAll(const MaterialPropertyBlock& other);

    /// Returns the value, or null if none was set. The pointer is valid until the next change.
    const ShaderPropertyValue* Find(ShaderPropertyId id) const
    {
        const std::uint32_t place = FindPlace(id);
        return place != 0 ? &m_Values[place - 1] : nullptr;
    }

    // These return the value that was set; zeros, an empty array or null if nothing was set, or
    // something of another kind.
    float GetFloat(ShaderPropertyId id) const;
    int GetInt(ShaderPropertyId id) const; ///< a float without its fraction
    int GetInteger(ShaderPropertyId id) const { return GetInt(id); }
    glm::vec4 GetVector(ShaderPropertyId id) const; ///< as shaders read it: a colour is linear
    Color GetColor(ShaderPropertyId id) const;      ///< sRGB
    glm::mat4 GetMatrix(ShaderPropertyId id) const { return Get<glm::mat4>(id); }
    std::shared_ptr<const Texture> GetTexture(ShaderPropertyId id) const
    {
        return Get<std::shared_ptr<const Texture>>(id);
    }
    std::vector<float> GetFloatArray(ShaderPropertyId id) const { return GetArray<float>(id); }
    std::vector<glm::vec4> GetVectorArray(ShaderPropertyId id) const
    {
        return GetArray<glm::vec4>(id);
    }
    std::vector<glm::mat4> GetMatrixArray(ShaderPropertyId id) const
    {
        return GetArray<glm::mat4>(id);
    }

    // These return whether a value of this kind was set.
    bool HasProperty(ShaderPropertyId id) const { return Find(id) != nullptr; }
    bool HasFloat(ShaderPropertyId id) const { return Has<float>(id); }
    bool HasInt(ShaderPropertyId id) const { return Has<int>(id); }
    bool HasInteger(ShaderPropertyId id) const { return HasInt(id); }
    bool HasVector(ShaderPropertyId id) const { return Has<glm::vec4>(id); }
    bool HasColor(ShaderPropertyId id) const { return Has<Color>(id); }
    bool HasMatrix(ShaderPropertyId id) const { return Has<glm::mat4>(id); }
    bool HasTexture(ShaderPropertyId id) const { return Has<std::shared_ptr<const Texture>>(id); }
    bool HasBuffer(ShaderPropertyId id) const { return Has<BufferRange>(id); }
    /// Returns whether a buffer is set for a cbuffer.
    bool HasConstantBuffer(ShaderPropertyId id) const;
    /// Returns the buffer that SetBuffer or SetConstantBuffer set; null = nothing.
    std::shared_ptr<const GraphicsBuffer> GetBuffer(ShaderPropertyId id) const
    {
        return Get<BufferRange>(id).buffer;
    }

    /// Calls `function` with the name and value of each property that was set.
    template <typename Function>
    void ForEach(const Function& function) const
    {
        for (const Slot& slot : m_Slots)
        {
            function(slot.id, m_Values[slot.value]);
        }
    }

    void Remove(ShaderPropertyId id);
    /// Removes all values and keeps the memory.
    void Clear();
    bool isEmpty() const { return m_Slots.empty(); }
    bool hasBuffers() const { return m_HasBuffers; } ///< returns whether one was set since Clear

private:
    struct Slot
    {
        ShaderPropertyId id;
        std::uint32_t value = 0; ///< in m_Values
    };
    template <typename Kind>
    bool Has(ShaderPropertyId id) const
    {
        return std::get_if<Kind>(Find(id)) != nullptr;
    }
    template <typename Kind>
    static Kind CopyOf(const ShaderPropertyValue* known)
    {
        const auto* value = std::get_if<Kind>(known);
        return value != nullptr ? *value : Kind{};
    }
    template <typename Kind>
    Kind Get(ShaderPropertyId id) const
    {
        return CopyOf<Kind>(Find(id));
    }
    template <typename Element>
    std::vector<Element> GetArray(ShaderPropertyId id) const
    {
        const auto* array = std::get_if<PropertyArray<Element>>(Find(id));
        return array != nullptr ? std::vector<Element>(array->begin(), array->end())
                                : std::vector<Element>();
    }
    /// Returns one more than the index of the value in m_Values; 0 = there is none.
    std::uint32_t FindPlace(ShaderPropertyId id) const
    {
        // This halves the range without branches, since nothing predicts which way they would go.
        const Slot* slot = m_Slots.data();
        for (std::size_t count = m_Slots.size(); count > 1; count -= count / 2)
        {
            slot += count / 2 * static_cast<std::size_t>(!(id < slot[count / 2].id));
        }
        return !m_Slots.empty() && slot->id == id ? slot->value + 1 : 0;
    }
    /// Sets a value as Set does, if it is known to be finite.
    void Put(ShaderPropertyId id, ShaderPropertyValue value);

    std::vector<Slot> m_Slots; ///< by id
    std::vector<ShaderPropertyValue> m_Values;
    bool m_HasBuffers = false;
};

} // namespace limn
