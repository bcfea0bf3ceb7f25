#include "cull/ProjectedBounds.h"
#include "frame/FrameNode.h"

#include <algorithm>

namespace limn
{

namespace
{

constexpr double k_FilterReach = 2.0;    ///< texels that bilinear filtering takes, and one more
constexpr double k_RoundingReach = 2.0;  ///< texels of the target, for edges rounded elsewhere
constexpr double k_WorthwhilePart = 0.6; ///< of a target; above, all of it is drawn

ViewportRect ToTexels(const TargetRegion& region, const RenderTexture& target)
{
    const auto texel = [](double part, int size, double reach)
    {
        return static_cast<int>(std::clamp(part * size + reach, 0.0, static_cast<double>(size)));
    };
    const int left = texel(region.left, target.width(), -k_RoundingReach);
    const int top = texel(region.top, target.height(), -k_RoundingReach);
    const int right = texel(region.right, target.width(), k_RoundingReach + 1.0);
    const int bottom = texel(region.bottom, target.height(), k_RoundingReach + 1.0);
    return {left, top, std::max(right - left, 0), std::max(bottom - top, 0)};
}

bool IsWorthwhile(const ViewportRect& rect, const RenderTexture& target)
{
    return static_cast<double>(rect.width) * rect.height <
           k_WorthwhilePart * target.width() * target.height();
}

/// Draws and clears of the whole target only.
bool IsPlain(const FrameNode& node)
{
    return node.targets.colors.size() == 1 && !Has<SetViewportCommand>(node) &&
           !Has<ClearCommand>(node);
}

/// Goes through a frame in its order and knows of textures where they may be other than 0.
class RegionLimiter
{
public:
    RegionLimiter(const FrameTables& tables, const FrameAllocator& memory)
        : m_Tables(tables), m_Regions(memory)
    {
    }

    void Limit(FrameNode& node)
    {
        if (!IsPlain(node))
        {
            ForEachTarget(node, [&](const auto& target) { m_Regions.erase(target->id()); });
            return;
        }
        const RenderTexture& target = *node.targets.colors.front();
        std::optional<TargetRegion> region = Begin(node, target);
        bool isFirst = true;
        for (PassCommand& command : node.commands)
        {
            if (auto* draw = std::get_if<DrawCommand>(&command))
            {
                region = Draw(node, *draw, isFirst, region);
                isFirst = false;
            }
        }
        m_Regions.erase(target.id());
        if (region)
        {
            m_Regions[target.id()] = *region;
        }
    }

private:
    static constexpr TargetRegion k_Empty{1.0, 1.0, 0.0, 0.0};

    std::optional<TargetRegion> Begin(const FrameNode& node, const RenderTexture& target) const
    {
        if (Clears(node, ClearFlag::Color))
        {
            return IsZero(node.clear->color, target.graphicsFormat()) ? std::optional(k_Empty)
                                                                      : std::nullopt;
        }
        const auto known = m_Regions.find(target.id());
        return node.coversColor || known == m_Regions.end() ? std::nullopt
                                                            : std::optional(known->second);
    }

    /// Limits the draw.
    /// @return where the target may be other than 0 then
    std::optional<TargetRegion> Draw(FrameNode& node, DrawCommand& draw, bool isFirst,
                                     const std::optional<TargetRegion>& before) const
    {
        const auto join = [&](const TargetRegion& added)
        {
            return before ? std::optional(Union(*before, added)) : std::nullopt;
        };
        const DrawSetup& setup = m_Tables.Setup(draw);
        if (!setup.fullScreen)
        {
            return draw.bounds ? join(*draw.bounds) : std::nullopt;
        }
        const std::optional<TargetRegion> seen = SeenBy(*setup.fullScreen);
        const RenderTexture& target = *node.targets.colors.front();
        if (!seen || (node.targets.depth && UsesDepth(setup.state)))
        {
            return std::nullopt;
        }
        const ViewportRect rect = ToTexels(*seen, target);
        const Color& output = setup.fullScreen->output;
        if (LeavesTargetAsItIs(setup.state.targets[0], output))
        {
            draw.scissor = IsWorthwhile(rect, target) ? std::optional(rect) : std::nullopt;
            return join(*seen);
        }
        if (!node.coversColor || !isFirst)
        {
            return std::nullopt;
        }
        if (IsWorthwhile(rect, target))
        {
            node.coversColor = false;
            AddClear(node, {ClearFlag::Color, output});
            draw.scissor = rect;
        }
        return IsZero(output, target.graphicsFormat()) ? seen : std::nullopt;
    }

    /// Returns the region in which the pass gives another output than the one for zeros.
    std::optional<TargetRegion> SeenBy(const FullScreenPromise& promise) const
    {
        for (const auto& texture : promise.zeroTextures)
        {
            const auto found = m_Regions.find(texture->id());
            // Texels of a coarse mip level reach as far as they like.
            if (promise.reach >= 0.0f && found != m_Regions.end() && texture->mipmapCount() == 1)
            {
                const double x = (promise.reach + k_FilterReach) / texture->width();
                const double y = (promise.reach + k_FilterReach) / texture->height();
                const TargetRegion& region = found->second;
                return TargetRegion{region.left - x, region.top - y, region.right + x,
                                    region.bottom + y};
            }
        }
        return std::nullopt;
    }

    const FrameTables& m_Tables;
    std::pmr::unordered_map<std::uint64_t, TargetRegion> m_Regions; ///< by Texture::id
};

} // namespace

void ScissorFullScreenPasses(FrameNodes& nodes, const FrameTables& tables)
{
    RegionLimiter limiter(tables, nodes.get_allocator());
    for (FrameNode& node : nodes)
    {
        limiter.Limit(node);
    }
}

} // namespace limn
