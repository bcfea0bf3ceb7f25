#pragma once

#include <initializer_list>
#include <limn/core/PooledAllocator.h>
#include <span>
#include <vector>

namespace limn
{

/// The elements of an array property, a copy of what they are made of.
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

} // namespace limn
