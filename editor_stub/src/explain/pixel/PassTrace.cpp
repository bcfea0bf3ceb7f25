#include "explain/pixel/PassTrace.h"

#include "explain/ExplainedFrame.h"
#include "explain/pixel/PassProbe.h"

#include <algorithm>
#include <cstdlib>
#include <limn/core/ComputeShader.h>
#include <map>

namespace limn
{

namespace
{

constexpr GraphicsFormat k_DepthFormat = GraphicsFormat::D32_SFloat;
constexpr GraphicsFormat k_StencilFormat = GraphicsFormat::R8_UInt;

/// Returns whether the pass has the light's view, not the camera's.
bool ShowsShadows(const CompiledRenderPass& pass, const FrameTables& tables)
{
    const auto isCaster = [&](const PassCommand& command)
    {
        const auto* draw = std::get_if<DrawCommand>(&command);
        const DrawSetup* setup = draw != nullptr ? &tables.Setup(*draw) : nullptr;
        return setup != nullptr &&
               setup->shader->passLightMode(setup->shaderPass) == "ShadowCaster";
    };
    return std::ranges::any_of(pass.commands, isCaster);
}

bool HasDraws(const CompiledRenderPass& pass)
{
    return std::ranges::any_of(pass.commands, [](const PassCommand& command)
                               { return std::holds_alternative<DrawCommand>(command); });
}

bool Clears(const CompiledRenderPass& pass)
{
    const auto isCleared = [](const ColorAttachment& color)
    {
        return color.load == LoadOp::Clear;
    };
    return std::ranges::any_of(pass.colors, isCleared) ||
           (pass.depth &&
            (pass.depth->load == LoadOp::Clear || pass.depth->stencilLoad == LoadOp::Clear));
}

bool SamePlace(const PerDrawData& a, const PerDrawData& b)
{
    return std::ranges::equal(a.objectToWorld, b.objectToWorld) &&
           std::ranges::equal(a.worldTransformParams, b.worldTransformParams);
}

bool IsChanged(const PixelEvent& event)
{
    return std::ranges::any_of(event.colors, &PixelValue::isChanged) ||
           (event.colors.empty() && ((event.depth && event.depth->isChanged()) ||
                                     (event.stencil && event.stencil->isChanged())));
}

bool HoldsNothing(const CompiledRenderPass& pass)
{
    return !pass.colors.empty() && std::ranges::all_of(pass.colors, [](const ColorAttachment& color)
                                                       { return color.load == LoadOp::DontCare; });
}

/// Takes out of an event what its colours, which held nothing, seem to have held.
/// @return whether they still hold nothing
bool MindUndefined(PixelEvent& event)
{
    if (event.fate == PixelFate::Same || event.fate == PixelFate::Blend)
    {
        event.fate = PixelFate::Drawn; // the first to write there, if only 0
        event.reason.clear();
    }
    if (event.fate != PixelFate::Drawn && event.fate != PixelFate::Cleared)
    {
        event.colors.clear();
        return true;
    }
    for (PixelValue& color : event.colors)
    {
        color.before.clear();
    }
    return false;
}

/// Goes through a frame's passes.
class FrameTrace
{
public:
    FrameTrace(const TracedScene& scene, const std::shared_ptr<ShaderCompiler>& compiler,
               VulkanDevice& device, PixelHistory& history)
        : m_Scene(scene),
          m_Frame(*scene.result.frame),
          m_Device(device),
          m_History(history),
          m_Covers(compiler)
    {
        FindRun();
    }

    TracedObjects Run(const std::function<void(const std::string&)>& progress)
    {
        const std::vector<CompiledRenderPass>& passes = m_Frame.passes;
        for (std::size_t i = 0; i < passes.size(); ++i)
        {
            if (progress)
            {
                progress("pass " + std::to_string(i + 1) + " of " + std::to_string(passes.size()) +
                         ": " + passes[i].Title());
            }
            if (passes[i].isCompute())
            {
                TraceDispatches(i);
            }
            else if (!IsElsewhere(passes[i]))
            {
                TraceDraws(i);
            }
        }
        return std::move(m_Objects);
    }

private:
    using Texels = std::vector<std::byte>;
    /// The texel of a texture at the pixel's place.
    struct Known
    {
        Texels texel;
        Texels stencil;
    };

    void FindRun()
    {
        FrameReplay all(m_Frame);
        for (const CompiledRenderPass& pass : m_Frame.passes)
        {
            all.AddPass(pass);
        }
        const CompiledFrame run = all.Compile(std::span(&m_Scene.result.output.rt(), 1));
        for (const CompiledRenderPass& pass : run.passes)
        {
            for (const PassCommand& command : pass.commands)
            {
                if (const auto* draw = std::get_if<DrawCommand>(&command))
                {
                    m_Run[draw->firstInstance] = draw->scissor;
                }
            }
        }
    }

    /// Returns whether it has the picture's shape, as far as whole texels can.
    bool IsPicture(const Texture& texture) const
    {
        const std::int64_t across = std::int64_t{texture.width()} * m_History.height;
        const std::int64_t down = std::int64_t{texture.height()} * m_History.width;
        return std::abs(across - down) <= std::max(m_History.width, m_History.height);
    }

    /// Returns the texel in which the pixel's middle lies.
    std::pair<int, int> PlaceIn(const Texture& texture) const
    {
        const auto place = [](int pixel, int pixels, int texels)
        {
            return static_cast<int>((2 * std::int64_t{pixel} + 1) * texels /
                                    (2 * std::int64_t{pixels}));
        };
        return {place(m_History.x, m_History.width, texture.width()),
                place(m_History.y, m_History.height, texture.height())};
    }

    bool IsElsewhere(const CompiledRenderPass& pass)
    {
        const auto target = TargetTextures(pass).front();
        if (IsPicture(*target) && !ShowsShadows(pass, m_Frame))
        {
            return false;
        }
        if (HasDraws(pass))
        {
            m_History.elsewhere.push_back({pass.Title(), target->name(), target->DescribeSize()});
        }
        return true;
    }

    /// Returns what is known of the pass's targets; nothing of those that no pass was seen to
    /// write.
    TargetTexels KnownOf(const CompiledRenderPass& pass)
    {
        TargetTexels known;
        for (const ColorAttachment& color : pass.colors)
        {
            known.colors.push_back(m_Known[color.texture->id()].texel);
        }
        if (pass.depth)
        {
            const Known& depth = m_Known[pass.depth->texture->id()];
            known.depth = depth.texel;
            known.stencil = depth.stencil;
        }
        return known;
    }

    void Remember(const CompiledRenderPass& pass, const TargetTexels& texels)
    {
        for (std::size_t i = 0; i < pass.colors.size(); ++i)
        {
            m_Known[pass.colors[i].texture->id()] = {texels.colors[i], {}};
        }
        if (pass.depth)
        {
            m_Known[pass.depth->texture->id()] = {texels.depth, texels.stencil};
        }
    }

    void TraceDraws(std::size_t index)
    {
        const CompiledRenderPass& pass = m_Frame.passes[index];
        const auto [x, y] = PlaceIn(*TargetTextures(pass).front());
        const PassProbe probe(m_Frame, index, x, y, m_Device, m_Covers);
        CountSteps(pass, probe);
        if (probe.reaching().empty() && !Clears(pass))
        {
            return;
        }
        TargetTexels before = KnownOf(pass);
        const bool areAllKnown = !(pass.depth && before.depth.empty()) &&
                                 std::ranges::none_of(before.colors, &Texels::empty);
        if (Clears(pass))
        {
            const TargetTexels cleared = probe.After(0);
            PixelEvent& event = m_History.events.emplace_back();
            event.fate = PixelFate::Cleared;
            event.pass = pass.name;
            AddValues(pass, before, cleared, event, true);
            before = cleared;
        }
        else if (!areAllKnown)
        {
            before = probe.After(0);
        }
        bool isUndefined = HoldsNothing(pass);
        for (std::size_t which = 0; which < probe.reaching().size(); ++which)
        {
            const TargetTexels after = probe.After(which + 1);
            PixelEvent event = EventOf(pass, probe, which);
            AddValues(pass, before, after, event, false);
            if (event.fate == PixelFate::Drawn && !IsChanged(event))
            {
                ExplainUnchanged(probe, which, before, event);
            }
            isUndefined = isUndefined && MindUndefined(event);
            m_History.events.push_back(std::move(event));
            before = after;
        }
        Remember(pass, before);
    }

    /// Notes the objects that are drawn, and the draws of no object, which are few, that do not
    /// reach the pixel.
    void CountSteps(const CompiledRenderPass& pass, const PassProbe& probe)
    {
        for (std::size_t i = 0; i < probe.steps().size(); ++i)
        {
            const PassStep& step = probe.steps()[i];
            const auto* draw = std::get_if<DrawCommand>(&pass.commands[step.command]);
            if (draw == nullptr)
            {
                continue;
            }
            const std::set<std::uint32_t> objects = ObjectsOf(*draw, step);
            m_Objects.drawn.insert(objects.begin(), objects.end());
            if (objects.empty() && !std::ranges::binary_search(probe.reaching(), i))
            {
                AddUncovered(step, m_Frame.Setup(*draw));
            }
        }
    }

    void AddUncovered(const PassStep& step, const DrawSetup& setup)
    {
        PixelUncovered own{step.sample, setup.shader->name(),
                           setup.shader->passName(setup.shaderPass), 1};
        for (PixelUncovered& known : m_History.uncoveredDraws)
        {
            if (known.pass == own.pass && known.shader == own.shader &&
                known.shaderPassName == own.shaderPassName)
            {
                ++known.count;
                return;
            }
        }
        m_History.uncoveredDraws.push_back(std::move(own));
    }

    /// Adds the reason for which the draw changes nothing.
    void ExplainUnchanged(const PassProbe& probe, std::size_t which, const TargetTexels& before,
                          PixelEvent& event) const
    {
        const DrawCommand& draw = probe.DrawAt(which);
        const auto run = m_Run.find(draw.firstInstance);
        const bool isOutside =
            run != m_Run.end() && run->second && !draw.scissor && !probe.LiesIn(*run->second);
        std::tie(event.fate, event.reason) = WhyUnchanged(probe, which, before, isOutside);
    }

    PixelEvent EventOf(const CompiledRenderPass& pass, const PassProbe& probe, std::size_t which)
    {
        const PassStep& step = probe.steps()[probe.reaching()[which]];
        const auto* draw = std::get_if<DrawCommand>(&pass.commands[step.command]);
        PixelEvent event;
        event.pass = step.sample;
        event.fate = draw != nullptr ? PixelFate::Drawn : PixelFate::Cleared;
        if (draw == nullptr)
        {
            return event;
        }
        const DrawSetup& setup = m_Frame.Setup(*draw);
        const std::set<std::uint32_t> objects = ObjectsOf(*draw, step);
        m_Objects.reaching.insert(objects.begin(), objects.end());
        for (const std::uint32_t object : objects)
        {
            event.objects.push_back(m_Scene.objects[object]->name);
        }
        const std::shared_ptr<const Mesh>& mesh = m_Frame.MeshOf(*draw);
        event.mesh = mesh ? mesh->name() : "";
        event.shader = setup.shader->name();
        event.shaderPass = setup.shaderPass;
        event.shaderPassName = setup.shader->passName(setup.shaderPass);
        event.material = MaterialOf(setup, *draw, step.sample, objects);
        event.isRun = m_Run.contains(draw->firstInstance);
        return event;
    }

    PixelValue ValueIn(const RenderTexture& texture, GraphicsFormat format, const Texels& before,
                       const Texels& after) const
    {
        const auto [x, y] = PlaceIn(texture);
        return {texture.name(),
                x,
                y,
                texture.width(),
                texture.height(),
                before.empty() ? std::vector<float>() : TexelValue(before, format),
                TexelValue(after, format)};
    }

    /// @param isOfClears  true for the values of targets alone that the pass begins with clearing
    void AddValues(const CompiledRenderPass& pass, const TargetTexels& before,
                   const TargetTexels& after, PixelEvent& event, bool isOfClears) const
    {
        for (std::size_t i = 0; i < pass.colors.size(); ++i)
        {
            const RenderTexture& texture = *pass.colors[i].texture;
            if (!isOfClears || pass.colors[i].load == LoadOp::Clear)
            {
                event.colors.push_back(
                    ValueIn(texture, texture.graphicsFormat(), before.colors[i], after.colors[i]));
            }
        }
        if (pass.depth && (!isOfClears || pass.depth->load == LoadOp::Clear))
        {
            event.depth = ValueIn(*pass.depth->texture, k_DepthFormat, before.depth, after.depth);
        }
        if (pass.depth && (!isOfClears || pass.depth->stencilLoad == LoadOp::Clear) &&
            !after.stencil.empty())
        {
            event.stencil =
                ValueIn(*pass.depth->texture, k_StencilFormat, before.stencil, after.stencil);
        }
    }

    /// Returns the objects of the scene that the step draws, by their places: also where a command
    /// draws a mesh where an object is that has it.
    std::set<std::uint32_t> ObjectsOf(const DrawCommand& draw, const PassStep& step) const
    {
        std::set<std::uint32_t> found;
        for (std::uint32_t i = 0; i < step.instanceCount && draw.drawsObjects; ++i)
        {
            found.insert(m_Frame.Element(draw.firstInstance + step.firstInstance + i));
        }
        const std::shared_ptr<const Mesh>& mesh = m_Frame.MeshOf(draw);
        if (draw.drawsObjects || !mesh || !m_Frame.objects)
        {
            return found;
        }
        const PerDrawData own = m_Frame.PerDraw(draw, step.firstInstance);
        for (std::uint32_t i = 0; i < m_Scene.objects.size(); ++i)
        {
            const auto& renderer = m_Scene.objects[i]->renderer;
            if (renderer && renderer->mesh == mesh && SamePlace(m_Frame.objects->Get(i), own))
            {
                found.insert(i);
            }
        }
        return found.size() == 1 ? found : std::set<std::uint32_t>();
    }

    std::string MaterialOf(const DrawSetup& setup, const DrawCommand& draw, const std::string& pass,
                           const std::set<std::uint32_t>& objects) const
    {
        for (const std::uint32_t place : objects)
        {
            const MeshRenderer& renderer = *m_Scene.objects[place]->renderer;
            const int last = renderer.mesh->subMeshCount() - 1;
            for (std::size_t slot = 0; slot < renderer.sharedMaterials.size(); ++slot)
            {
                const std::shared_ptr<const Material>& material = renderer.sharedMaterials[slot];
                if (material && material->shader() == setup.shader &&
                    std::min(static_cast<int>(slot), last) == draw.subMesh)
                {
                    return material->name();
                }
            }
        }
        for (const DrawRenderersReport& report : m_Scene.result.report.draws)
        {
            const std::shared_ptr<const Material>& material = report.drawing.overrideMaterial;
            if (draw.drawsObjects && material && report.pass == pass &&
                material->shader() == setup.shader)
            {
                return material->name();
            }
        }
        return {};
    }

    void TraceDispatches(std::size_t index)
    {
        const CompiledRenderPass& pass = m_Frame.passes[index];
        for (const PassCommand& command : pass.commands)
        {
            const auto* dispatch = std::get_if<DispatchCommand>(&command);
            if (dispatch == nullptr)
            {
                continue;
            }
            const DispatchSetup& setup = m_Frame.Setup(*dispatch);
            for (const StorageTextureSlot& slot : setup.bindings->storageTextures)
            {
                if (IsPicture(*slot.texture))
                {
                    TraceWrite(index, setup, slot.texture);
                }
                else
                {
                    m_History.elsewhere.push_back(
                        {pass.Title(), slot.texture->name(), slot.texture->DescribeSize()});
                }
            }
        }
    }

    /// Adds the texel that the pass's kernel leaves in a texture.
    void TraceWrite(std::size_t index, const DispatchSetup& setup,
                    const std::shared_ptr<const RenderTexture>& texture)
    {
        FrameReplay replay(m_Frame);
        for (std::size_t i = 0; i <= index; ++i)
        {
            replay.AddPass(m_Frame.passes[i]);
        }
        const auto [x, y] = PlaceIn(*texture);
        Texels& known = m_Known[texture->id()].texel;
        const Texels after = TexelAt(replay.Run(m_Device, std::span(&texture, 1)).front(), x, y);
        PixelEvent event;
        event.pass = m_Frame.passes[index].name;
        event.shader = setup.shader->name();
        event.shaderPass = setup.kernel;
        event.shaderPassName = setup.shader->kernelName(setup.kernel);
        event.colors.push_back(ValueIn(*texture, texture->graphicsFormat(), known, after));
        const bool isChanged = event.colors.front().isChanged();
        event.fate = isChanged ? PixelFate::Dispatched : PixelFate::Same;
        event.reason = isChanged ? "" : "the kernel leaves the texel as it was";
        known = after;
        m_History.events.push_back(std::move(event));
    }

    const TracedScene& m_Scene;
    const CompiledFrame& m_Frame;
    VulkanDevice& m_Device;
    PixelHistory& m_History;
    CoverPrograms m_Covers;
    std::map<std::uint64_t, Known> m_Known; ///< by Texture::id
    /// The draws that the device runs for `limn render`, by DrawCommand::firstInstance, with the
    /// part of the target that each is drawn into.
    std::map<std::uint32_t, std::optional<ViewportRect>> m_Run;
    TracedObjects m_Objects;
};

} // namespace

TracedObjects TraceFrame(const TracedScene& scene, const std::shared_ptr<ShaderCompiler>& compiler,
                         VulkanDevice& device, PixelHistory& history,
                         const std::function<void(const std::string&)>& progress)
{
    return FrameTrace(scene, compiler, device, history).Run(progress);
}

} // namespace limn
