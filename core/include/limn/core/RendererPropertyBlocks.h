#pragma once

#include <limn/core/MaterialPropertyBlock.h>
#include <memory>
#include <vector>

namespace limn
{

/// What a renderer was given by SetPropertyBlock, for itself and for single materials. Copies have
/// lists of their own of the same blocks. A renderer without any, as most are, has one pointer
/// here.
class RendererPropertyBlocks
{
public:
    using Block = std::shared_ptr<const MaterialPropertyBlock>;

    RendererPropertyBlocks() = default;
    RendererPropertyBlocks(const RendererPropertyBlocks& other);
    RendererPropertyBlocks(RendererPropertyBlocks&& other) noexcept = default;
    RendererPropertyBlocks& operator=(RendererPropertyBlocks other) noexcept;
    ~RendererPropertyBlocks() = default;

    /// @param block  copied; an empty one takes what there is away
    void Set(const MaterialPropertyBlock& block);
    void Set(const MaterialPropertyBlock& block, std::size_t material);

    bool isEmpty() const { return m_Lists == nullptr; }
    // Null = none was set. Until the next change.
    const Block& ofRenderer() const { return m_Lists ? m_Lists->ofRenderer : k_None; }
    const Block& OfMaterial(std::size_t material) const
    {
        return material < materialCount() ? m_Lists->ofMaterials[material] : k_None;
    }
    /// Materials behind these have none.
    std::size_t materialCount() const { return m_Lists ? m_Lists->ofMaterials.size() : 0; }

private:
    struct Lists
    {
        Block ofRenderer;
        std::vector<Block> ofMaterials; ///< by index
    };
    /// To be changed; freed again by DropEmpty.
    Lists& Own();
    void DropEmpty();

    static const Block k_None;
    std::unique_ptr<Lists> m_Lists; ///< null, or not without any block
};

} // namespace limn
