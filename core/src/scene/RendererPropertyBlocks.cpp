#include <algorithm>
#include <limn/core/Scene.h>
#include <utility>

namespace limn
{

namespace
{

RendererPropertyBlocks::Block CopyOf(const MaterialPropertyBlock& block)
{
    return block.isEmpty() ? nullptr : std::make_shared<const MaterialPropertyBlock>(block);
}

} // namespace

const RendererPropertyBlocks::Block RendererPropertyBlocks::k_None;

RendererPropertyBlocks::RendererPropertyBlocks(const RendererPropertyBlocks& other)
    : m_Lists(other.m_Lists ? std::make_unique<Lists>(*other.m_Lists) : nullptr)
{
}

RendererPropertyBlocks& RendererPropertyBlocks::operator=(RendererPropertyBlocks other) noexcept
{
    m_Lists.swap(other.m_Lists);
    return *this;
}

void RendererPropertyBlocks::Set(const MaterialPropertyBlock& block)
{
    Own().ofRenderer = CopyOf(block);
    DropEmpty();
}

void RendererPropertyBlocks::Set(const MaterialPropertyBlock& block, std::size_t material)
{
    std::vector<Block>& blocks = Own().ofMaterials;
    blocks.resize(std::max(blocks.size(), material + 1));
    blocks[material] = CopyOf(block);
    DropEmpty();
}

RendererPropertyBlocks::Lists& RendererPropertyBlocks::Own()
{
    m_Lists = m_Lists ? std::move(m_Lists) : std::make_unique<Lists>();
    return *m_Lists;
}

void RendererPropertyBlocks::DropEmpty()
{
    const bool isAny =
        m_Lists->ofRenderer || std::ranges::any_of(m_Lists->ofMaterials, [](const Block& each)
                                                   { return each != nullptr; });
    m_Lists = isAny ? std::move(m_Lists) : nullptr;
}

} // namespace limn
