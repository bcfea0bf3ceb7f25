#include "scene/RendererTable.h"

#include <algorithm>
#include <limn/core/Scene.h>

namespace limn
{

void MeshRenderer::SetPropertyBlock(const MaterialPropertyBlock& block, int materialIndex)
{
    const auto index = static_cast<std::size_t>(materialIndex);
    if (materialIndex < 0 || index >= sharedMaterials.size())
    {
        throw ContractError("SetPropertyBlock: there is no material " +
                            std::to_string(materialIndex) + "; the renderer has " +
                            std::to_string(sharedMaterials.size()));
    }
    propertyBlocks.Set(block, index);
}

void MeshRenderer::GetPropertyBlock(MaterialPropertyBlock& block, int materialIndex) const
{
    const auto index = static_cast<std::size_t>(materialIndex);
    const auto& own = propertyBlocks.OfMaterial(index); // of a number below 0 there is none
    block = own ? *own : MaterialPropertyBlock();
}

GameObject& Scene::Add(std::string name)
{
    m_Objects->push_back(std::make_unique<GameObject>());
    m_Objects->back()->name = std::move(name);
    return *m_Objects->back();
}

GameObject* Scene::Find(std::string_view name)
{
    const auto it = std::ranges::find(*m_Objects, name, &GameObject::name);
    return it == m_Objects->end() ? nullptr : it->get();
}

std::shared_ptr<const RendererTable> Scene::UpdateRenderers(const glm::dvec3& origin) const
{
    if (!m_Renderers)
    {
        m_Renderers = std::make_shared<RendererTable>(m_Objects);
    }
    m_Renderers->Update(origin);
    return m_Renderers;
}

} // namespace limn
