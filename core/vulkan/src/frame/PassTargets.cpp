#include "frame/PassTargets.h"

#include "device/Translate.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <limn/base/NumberText.h>
#include <utility>

namespace limn::vulkan
{

namespace
{

std::string SizeText(int width, int height)
{
    return std::to_string(width) + "x" + std::to_string(height);
}

/// The texel behind the last; may fit no int.
std::int64_t Right(const ViewportRect& rect)
{
    return std::int64_t{rect.x} + rect.width;
}

std::int64_t Bottom(const ViewportRect& rect)
{
    return std::int64_t{rect.y} + rect.height;
}

/// Returns the fault of a texture as a target, "" if it has none.
std::string Objection(const CompiledRenderPass& pass, const RenderTexture& texture,
                      TextureUsage usage, TextureUsage needed)
{
    const bool isDepth = needed == TextureUsage::DepthStencilAttachment;
    if (IsDepthFormat(texture.graphicsFormat()) != isDepth)
    {
        return std::string(limn::ToString(texture.graphicsFormat())) + " is no " +
               (isDepth ? "depth" : "colour") + " format";
    }
    if (texture.width() < pass.width || texture.height() < pass.height)
    {
        return "it is " + SizeText(texture.width(), texture.height()) + ", the pass draws " +
               SizeText(pass.width, pass.height);
    }
    if (usage != needed)
    {
        return std::string("its use is ") + ToString(usage) + "; a barrier must make it " +
               ToString(needed);
    }
    return {};
}

/// Checks the texture as a target and returns its sample count.
int RequireTarget(const CompiledRenderPass& pass, const RenderTexture& texture, ImagePool& images,
                  TextureUsage needed)
{
    const TextureUsage usage = images.Find(texture)->use.usage;
    if (const std::string objection = Objection(pass, texture, usage, needed); !objection.empty())
    {
        throw ContractError("pass '" + pass.name + "': target '" + texture.name() +
                            "': " + objection);
    }
    return texture.descriptor().msaaSamples;
}

/// @param texture  of the attachment
void RequireResolve(const CompiledRenderPass& pass, const RenderTexture& texture,
                    const std::shared_ptr<const RenderTexture>& resolve, ImagePool& images,
                    TextureUsage needed)
{
    if (!resolve)
    {
        return;
    }
    const int samples = RequireTarget(pass, *resolve, images, needed);
    const std::string subject = "pass '" + pass.name + "': target '" + texture.name() +
                                "' cannot be resolved into '" + resolve->name() + "': ";
    if (texture.descriptor().msaaSamples == 1)
    {
        throw ContractError(subject + "it has one sample per texel");
    }
    if (resolve.get() != &texture &&
        (samples != 1 || resolve->graphicsFormat() != texture.graphicsFormat()))
    {
        throw ContractError(subject + "that must have one sample per texel and the same format");
    }
}

void RequireCount(const CompiledRenderPass& pass, const VkPhysicalDeviceLimits& limits)
{
    const std::size_t most = std::min<std::size_t>(8, limits.maxColorAttachments);
    if (pass.colors.size() > most)
    {
        throw ContractError("pass '" + pass.name + "' has " + std::to_string(pass.colors.size()) +
                            " colour targets; the device draws into at most " +
                            std::to_string(most));
    }
    if (pass.width <= 0 || pass.height <= 0)
    {
        throw ContractError("pass '" + pass.name + "' has the size " +
                            SizeText(pass.width, pass.height) + "; it must be positive");
    }
}

VkRenderingAttachmentInfo Attachment(VkImageView view, VkImageLayout layout, LoadOp load,
                                     StoreOp store, VkClearValue clear)
{
    auto info = Make<VkRenderingAttachmentInfo>(VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO);
    info.imageView = view;
    info.imageLayout = layout;
    info.loadOp = ToVkLoadOp(load);
    info.storeOp = ToVkStoreOp(store);
    info.clearValue = clear;
    return info;
}

void Resolve(VkRenderingAttachmentInfo& info, VkImageView view, VkResolveModeFlagBits mode)
{
    info.resolveMode = mode;
    info.resolveImageView = view;
    info.resolveImageLayout = info.imageLayout;
}

template <typename Integer>
void SetIntegers(Integer (&target)[4], const std::array<double, 4>& values)
{
    constexpr double k_Least = std::numeric_limits<Integer>::min();
    constexpr double k_Most = std::numeric_limits<Integer>::max();
    for (std::size_t i = 0; i < values.size(); ++i)
    {
        target[i] = static_cast<Integer>(std::clamp(std::round(values[i]), k_Least, k_Most));
    }
}

} // namespace

VkClearColorValue ColorClearValue(const Color& color, GraphicsFormat format)
{
    VkClearColorValue value{{color.r, color.g, color.b, color.a}};
    const std::array<double, 4> values{color.r, color.g, color.b, color.a};
    const UniformType type = ComponentType(format);
    if (type == UniformType::Int)
    {
        SetIntegers(value.int32, values);
    }
    else if (type == UniformType::UInt)
    {
        SetIntegers(value.uint32, values);
    }
    return value;
}

TargetFormats TargetsOf(const CompiledRenderPass& pass, ImagePool& images,
                        const VkPhysicalDeviceLimits& limits)
{
    RequireCount(pass, limits);
    TargetFormats formats;
    int samples = 0;
    const auto require = [&](const RenderTexture& texture, TextureUsage needed)
    {
        const int count = RequireTarget(pass, texture, images, needed);
        if (samples != 0 && samples != count)
        {
            throw ContractError("pass '" + pass.name + "': target '" + texture.name() + "' has " +
                                CountText(static_cast<std::size_t>(count), "sample") +
                                " per texel, but the one before it has " + std::to_string(samples));
        }
        samples = count;
    };
    for (const ColorAttachment& color : pass.colors)
    {
        require(*color.texture, TextureUsage::ColorAttachment);
        RequireResolve(pass, *color.texture, color.resolve, images, TextureUsage::ColorAttachment);
        formats.colors.push_back(ToVkFormat(color.texture->graphicsFormat()));
    }
    if (pass.depth)
    {
        const GraphicsFormat format = pass.depth->texture->graphicsFormat();
        require(*pass.depth->texture, TextureUsage::DepthStencilAttachment);
        RequireResolve(pass, *pass.depth->texture, pass.depth->resolve, images,
                       TextureUsage::DepthStencilAttachment);
        formats.depth = ToVkFormat(format);
        formats.stencil = HasStencil(format) ? formats.depth : VK_FORMAT_UNDEFINED;
    }
    formats.samples = static_cast<VkSampleCountFlagBits>(std::max(samples, 1));
    return formats;
}

void MarkSamples(const CompiledRenderPass& pass, ImagePool& images)
{
    ForEachAttachment(pass,
                      [&](const auto& attachment)
                      {
                          PooledImage& image = *images.Find(*attachment.texture);
                          image.use.isStale =
                              image.samples > 1 && attachment.resolve != attachment.texture;
                      });
}

void RecordBeginRendering(VkCommandBuffer commands, const CompiledRenderPass& pass,
                          ImagePool& images, bool usesReversedZBuffer)
{
    std::array<VkRenderingAttachmentInfo, 8> colors{};
    std::uint32_t count = 0;
    for (const ColorAttachment& color : pass.colors)
    {
        const PooledImage& image = *images.Find(*color.texture);
        constexpr VkImageLayout layout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
        VkClearValue clear{};
        clear.color = ColorClearValue(color.clearColor, color.texture->graphicsFormat());
        VkRenderingAttachmentInfo target =
            Attachment(image.view.get(), layout, color.load, color.store, clear);
        if (color.resolve)
        {
            Resolve(target, images.Find(*color.resolve)->read().view.get(),
                    VK_RESOLVE_MODE_AVERAGE_BIT);
        }
        colors.at(count++) = target;
    }
    auto info = Make<VkRenderingInfo>(VK_STRUCTURE_TYPE_RENDERING_INFO);
    info.renderArea = AreaOf(pass);
    info.layerCount = 1;
    info.colorAttachmentCount = count;
    info.pColorAttachments = colors.data();
    VkRenderingAttachmentInfo depth{};
    VkRenderingAttachmentInfo stencil{};
    if (pass.depth)
    {
        const DepthAttachment& target = *pass.depth;
        const PooledImage& image = *images.Find(*target.texture);
        const VkImageView view = image.view.get();
        const VkClearValue clear =
            DepthClearValue(target.clearDepth, target.clearStencil, usesReversedZBuffer);
        constexpr VkImageLayout layout = VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL;
        depth = Attachment(view, layout, target.load, target.store, clear);
        stencil = Attachment(view, layout, target.stencilLoad, target.stencilStore, clear);
        if (target.resolve)
        {
            const VkImageView resolved = images.Find(*target.resolve)->read().view.get();
            Resolve(depth, resolved, VK_RESOLVE_MODE_SAMPLE_ZERO_BIT);
            Resolve(stencil, resolved, VK_RESOLVE_MODE_SAMPLE_ZERO_BIT);
        }
        info.pDepthAttachment = &depth;
        info.pStencilAttachment = HasStencil(target.texture->graphicsFormat()) ? &stencil : nullptr;
    }
    vkCmdBeginRendering(commands, &info);
}

void RequireViewport(const ViewportRect& rect, const CompiledRenderPass& pass,
                     const VkPhysicalDeviceLimits& limits)
{
    if (rect.width <= 0 || rect.height <= 0)
    {
        throw ContractError("pass '" + pass.name + "': the viewport has the size " +
                            SizeText(rect.width, rect.height) + "; it must be positive");
    }
    const auto& most = limits.maxViewportDimensions;
    const auto [first, last] = limits.viewportBoundsRange;
    const bool fits = std::cmp_less_equal(rect.width, most[0]) &&
                      std::cmp_less_equal(rect.height, most[1]) &&
                      static_cast<float>(std::min(rect.x, rect.y)) >= first &&
                      static_cast<float>(std::max(Right(rect), Bottom(rect))) <= last;
    if (!fits)
    {
        throw ContractError("pass '" + pass.name + "': the viewport is " +
                            SizeText(rect.width, rect.height) + " at (" + std::to_string(rect.x) +
                            ", " + std::to_string(rect.y) + "); the device draws at most " +
                            std::to_string(most[0]) + "x" + std::to_string(most[1]) + " between " +
                            std::to_string(static_cast<std::int64_t>(first)) + " and " +
                            std::to_string(static_cast<std::int64_t>(last)));
    }
}

VkRect2D AreaOf(const CompiledRenderPass& pass)
{
    return {{0, 0},
            {static_cast<std::uint32_t>(pass.width), static_cast<std::uint32_t>(pass.height)}};
}

VkRect2D ClipTo(const VkRect2D& area, const ViewportRect& rect)
{
    const auto clip = [](std::int64_t value, int least, int most)
    {
        return static_cast<int>(std::clamp<std::int64_t>(value, least, most));
    };
    const auto& [offset, extent] = area;
    const int endX = offset.x + static_cast<int>(extent.width);
    const int endY = offset.y + static_cast<int>(extent.height);
    const int left = clip(rect.x, offset.x, endX);
    const int top = clip(rect.y, offset.y, endY);
    const int right = clip(Right(rect), left, endX);
    const int bottom = clip(Bottom(rect), top, endY);
    return {{left, top},
            {static_cast<std::uint32_t>(right - left), static_cast<std::uint32_t>(bottom - top)}};
}

VkViewport ToVkViewport(const ViewportRect& rect)
{
    return {static_cast<float>(rect.x),
            static_cast<float>(Bottom(rect)),
            static_cast<float>(rect.width),
            -static_cast<float>(rect.height),
            0.0f,
            1.0f};
}

VkClearValue DepthClearValue(float depth, int stencil, bool usesReversedZBuffer)
{
    VkClearValue value{};
    value.depthStencil = {usesReversedZBuffer ? 1.0f - depth : depth,
                          static_cast<std::uint32_t>(stencil) & 0xFFU};
    return value;
}

} // namespace limn::vulkan
