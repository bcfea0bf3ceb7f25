#include <limn/core/Scene.h>

#include <algorithm>
#include <limn/core/Material.h>
#include <stdexcept>

namespace limn
{

MaterialList::MaterialList(const value_type* materials, std::size_t count)
{
    if (count == 1)
    {
        m_Materials = *materials;
    }
    else if (count > 1)
    {
        m_Materials = std::make_unique<std::vector<value_type>>(materials, materials + count);
    }
}

const MaterialList::value_type& MaterialList::at(std::size_t index) const
{
    if (index >= size())
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

} // namespace limn
