#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <vector>

namespace limn
{

class Material;

/// The materials of a renderer: a vector, but the only one that most renderers have takes no memory
/// of its own. Iterators and references hold until the next change of the length.
class MaterialList
{
public:
    using value_type = std::shared_ptr<const Material>;
    using iterator = value_type*;
    using const_iterator = const value_type*;

    MaterialList() noexcept : m_One() {}
    MaterialList(std::initializer_list<value_type> materials);
    MaterialList(const std::vector<value_type>& materials);
    MaterialList(const MaterialList& other);
    MaterialList(MaterialList&& other) noexcept;
    MaterialList& operator=(MaterialList other) noexcept;
    ~MaterialList() { Free(); }

    std::size_t size() const { return m_Size; }
    bool empty() const { return m_Size == 0; }
    iterator begin() { return isShort() ? &m_One : m_Many; }
    iterator end() { return begin() + m_Size; }
    const_iterator begin() const { return isShort() ? &m_One : m_Many; }
    const_iterator end() const { return begin() + m_Size; }
    value_type& operator[](std::size_t index) { return begin()[index]; }
    const value_type& operator[](std::size_t index) const { return begin()[index]; }
    value_type& front() { return *begin(); }
    const value_type& front() const { return *begin(); }
    value_type& back() { return end()[-1]; }
    const value_type& back() const { return end()[-1]; }
    /// @throws std::out_of_range
    const value_type& at(std::size_t index) const;

    void push_back(value_type material) { resize(m_Size + std::size_t{1}, material); }
    /// @param material  of those that are added
    void resize(std::size_t count, const value_type& material = nullptr);
    void clear() { *this = MaterialList(); }

    bool operator==(const MaterialList& other) const;

private:
    bool isShort() const { return m_Size <= 1; }
    void Assign(const value_type* materials, std::size_t count);
    void Take(MaterialList& other) noexcept;
    void Free() noexcept;

    union
    {
        value_type m_One;   ///< null in an empty list
        value_type* m_Many; ///< of new[]
    };
    std::uint32_t m_Size = 0;
};

} // namespace limn
