#include <limn/core/Scene.h>

#include <algorithm>
#include <limn/core/Material.h>
#include <stdexcept>
#include <string>
#include <utility>

namespace limn
{

MaterialList::MaterialList(std::initializer_list<value_type> materials) : MaterialList()
{
    Assign(materials.begin(), materials.size());
}

MaterialList::MaterialList(const std::vector<value_type>& materials) : MaterialList()
{
    Assign(materials.data(), materials.size());
}

MaterialList::MaterialList(const MaterialList& other) : MaterialList()
{
    Assign(other.begin(), other.size());
}

MaterialList::MaterialList(MaterialList&& other) noexcept : MaterialList()
{
    Take(other);
}

MaterialList& MaterialList::operator=(MaterialList other) noexcept
{
    Free();
    std::construct_at(&m_One);
    m_Size = 0;
    Take(other);
    return *this;
}

const MaterialList::value_type& MaterialList::at(std::size_t index) const
{
    if (index >= m_Size)
    {
        throw std::out_of_range("MaterialList: there is no material " + std::to_string(index));
    }
    return begin()[index];
}

void MaterialList::resize(std::size_t count, const value_type& material)
{
    std::vector<value_type> materials(begin(), end());
    materials.resize(count, material);
    *this = MaterialList(materials);
}

bool MaterialList::operator==(const MaterialList& other) const
{
    return std::equal(begin(), end(), other.begin(), other.end());
}

/// @pre this is empty
void MaterialList::Assign(const value_type* materials, std::size_t count)
{
    if (count > 1)
    {
        std::unique_ptr<value_type[]> many(new value_type[count]);
        std::copy_n(materials, count, many.get());
        std::destroy_at(&m_One);
        m_Many = many.release();
    }
    else if (count == 1)
    {
        m_One = *materials;
    }
    m_Size = static_cast<std::uint32_t>(count);
}

/// @pre this is empty
/// @post the other is
void MaterialList::Take(MaterialList& other) noexcept
{
    if (other.isShort())
    {
        m_One = std::move(other.m_One);
    }
    else
    {
        std::destroy_at(&m_One);
        m_Many = other.m_Many;
        std::construct_at(&other.m_One);
    }
    m_Size = std::exchange(other.m_Size, 0);
}

void MaterialList::Free() noexcept
{
    if (isShort())
    {
        std::destroy_at(&m_One);
    }
    else
    {
        delete[] m_Many;
    }
}

} // namespace limn
