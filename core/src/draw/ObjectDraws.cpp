#include "draw/ObjectDraws.h"

#include "draw/PerDraw.h"
#include "draw/ProjectedBounds.h"
#include "scene/RendererTable.h"

#include <algorithm>
#include <limits>

namespace limn
{

namespace
{

/// A pass of a material, looked up once for all objects that are drawn with it.
struct ObjectPass
{
    std::shared_ptr<const Material> material;
    int shaderPass = 0;
    DrawCommand draw; ///< without mesh and instances
};

bool Compiles(const Material& material, int pass)
{
    try
    {
        material.Compile(pass);
        return true;
    }
    catch (const AssetError&)
    {
        return false;
    }
}

/// The passes of one DrawRenderers call.
class PassList
{
public:
    PassList(const DrawingSettings& drawing, const RenderStateBlock& stateBlock,
             DrawRecorder& recorder)
        : m_Drawing(drawing), m_StateBlock(stateBlock), m_Recorder(recorder)
    {
    }

    /// The passes that a renderer of this material draws.
    std::vector<std::uint32_t> Of(const std::shared_ptr<const Material>& material)
    {
        if (m_Drawing.overrideMaterial)
        {
            return {Add(m_Drawing.overrideMaterial, m_Drawing.overrideMaterialPassIndex)};
        }
        if (m_Drawing.overrideShader)
        {
            return {Add(m_Recorder.WithShader(material, m_Drawing.overrideShader),
                        m_Drawing.overrideShaderPassIndex)};
        }
        std::vector<std::uint32_t> passes;
        for (const ShaderTagId tag : m_Drawing.shaderTagIds)
        {
            const int pass = material->shader()->FindPassByLightMode(tag);
            if (pass >= 0 && m_Drawing.fallbackMaterial && !Compiles(*material, pass))
            {
                passes.push_back(Add(m_Drawing.fallbackMaterial, 0));
                break;
            }
            if (pass >= 0)
            {
                passes.push_back(Add(material, pass));
            }
        }
        return passes;
    }

    const std::vector<ObjectPass>& passes() const { return m_Passes; }

private:
    std::uint32_t Add(const std::shared_ptr<const Material>& material, int shaderPass)
    {
        const auto [known, isNew] = m_Index.try_emplace(
            {material.get(), shaderPass}, static_cast<std::uint32_t>(m_Passes.size()));
        if (isNew)
        {
            m_Passes.push_back({material, shaderPass,
                                m_Recorder.LookUp(*material, shaderPass, nullptr, m_StateBlock)});
        }
        return known->second;
    }

    const DrawingSettings& m_Drawing;
    const RenderStateBlock& m_StateBlock;
    DrawRecorder& m_Recorder;
    std::vector<ObjectPass> m_Passes;
    std::map<std::pair<const Material*, int>, std::uint32_t> m_Index;
};

bool Blends(const RenderTargetBlendState& target)
{
    return target.sourceColorBlendMode != BlendMode::One ||
           target.destinationColorBlendMode != BlendMode::Zero ||
           target.sourceAlphaBlendMode != BlendMode::One ||
           target.destinationAlphaBlendMode != BlendMode::Zero ||
           target.colorBlendOperation != BlendOp::Add || target.alphaBlendOperation != BlendOp::Add;
}

/// A number for passes whose draws give the same picture in any order, one with another too if
/// their numbers are equal; 0 if the order counts, or nobody wants equal states together. Known are two cases: the nearest wins; and
/// all write the same, because the fragment function looks at nothing but what is bound.
std::uint32_t Commutes(const ObjectPass& pass, std::uint32_t index, const SortingSettings& sorting,
                       bool hasDepth)
{
    constexpr std::uint32_t k_NearestWins = 0x10000;
    const PipelineState& state = pass.draw.state;
    if (!(sorting.criteria & SortingCriteria::OptimizeStateChanges) || state.stencilEnabled || state.alphaToMask || std::ranges::any_of(state.targets, Blends))
    {
        return 0;
    }
    const bool nearestWins =
        state.zTest == CompareFunction::LessEqual || state.zTest == CompareFunction::Less;
    const bool writesDepth = hasDepth && state.zWrite && state.zTest != CompareFunction::Disabled;
    if (!pass.draw.program->layout.fragmentHasInputs && (!writesDepth || nearestWins))
    {
        return 1 + index;
    }
    const bool isInOrder = sorting.criteria & SortingCriteria::BackToFront;
    return nearestWins && writesDepth && !isInOrder
               ? k_NearestWins + static_cast<std::uint32_t>(pass.material->renderQueue())
               : 0;
}

/// The box around the world boxes of rows, as per-draw data of a box mesh would place it: nothing
/// but relative to the origin.
std::optional<TargetRegion> RegionOf(const RendererTable& table, std::span<const std::uint32_t> rows,
                                     const DrawRecorder& recorder)
{
    glm::vec3 low(std::numeric_limits<float>::max());
    glm::vec3 high(-std::numeric_limits<float>::max());
    for (const std::uint32_t row : rows)
    {
        low = glm::min(low, table.center(row) - table.extent(row));
        high = glm::max(high, table.center(row) + table.extent(row));
    }
    const PerDrawData atOrigin =
        MakePerDrawData(glm::translate(glm::dmat4(1.0), table.origin()), {}, table.origin());
    return recorder.Project({(low + high) * 0.5f, (high - low) * 0.5f}, atOrigin);
}

/// Where a batch draws, if its pass promises to stay within the mesh. Few objects are looked at one
/// by one; many are seldom apart.
std::optional<TargetRegion> BoundsOf(const DrawCommand& draw, const RendererTable& table,
                                     std::span<const std::uint32_t> rows,
                                     const DrawRecorder& recorder)
{
    constexpr std::size_t k_OneByOne = 64;
    if (!draw.shader->staysWithinMesh(draw.shaderPass))
    {
        return std::nullopt;
    }
    if (rows.size() > k_OneByOne)
    {
        return RegionOf(table, rows, recorder);
    }
    std::optional<TargetRegion> region;
    for (const std::uint32_t row : rows)
    {
        const auto seen = recorder.Project(draw.mesh->bounds(), table.Get(table.objectOf()[row]));
        if (!seen)
        {
            return std::nullopt;
        }
        region = region ? Union(*region, *seen) : *seen;
    }
    return region;
}

} // namespace

ObjectBatches MakeBatches(const RendererItems& items,
                          const std::vector<std::vector<std::uint32_t>>& passesOf,
                          const std::vector<std::uint32_t>& commutes)
{
    // Batches of the current run of draws that may change places, by what they are of. Where there
    // are too many kinds for a table, only neighbours are put together.
    constexpr std::size_t k_MostKinds = 1 << 22;
    struct Seen
    {
        std::uint32_t run = 0;
        std::uint32_t batch = 0;
    };
    const RendererTable& table = *items.table();
    const std::size_t parts = table.meshParts().size();
    const std::size_t kinds = commutes.size() * parts * 2;
    std::vector<Seen> seen(kinds <= k_MostKinds ? kinds : 0);
    std::uint32_t run = 0;
    std::uint32_t number = 0;
    std::size_t last = kinds;
    ObjectBatches result;
    std::vector<std::uint32_t> batchOf;
    std::vector<std::uint32_t> rowOf;
    batchOf.reserve(items.size());
    rowOf.reserve(items.size());
    std::uint32_t batch = 0;
    for (const std::uint32_t row : items.rows())
    {
        const bool isMirrored = (table.flags()[row] & RendererTable::k_Mirrored) != 0;
        const bool isAgain = (table.flags()[row] & RendererTable::k_Again) != 0;
        for (const std::uint32_t pass : passesOf[table.classOf()[row]])
        {
            const std::size_t kind =
                (pass * parts + table.meshPartOf()[row]) * 2 + (isMirrored ? 1 : 0);
            if (kind != last)
            {
                const std::uint32_t own = isAgain ? 0 : commutes[pass];
                run += own == 0 || own != number || seen.empty();
                number = own;
                last = kind;
                const bool isKnown = !seen.empty() && seen[kind].run == run;
                batch = isKnown ? seen[kind].batch
                                : static_cast<std::uint32_t>(result.batches.size());
                if (!isKnown)
                {
                    result.batches.push_back({pass, table.meshPartOf()[row], isMirrored, 0, 0});
                }
                if (!seen.empty())
                {
                    seen[kind] = {run, batch};
                }
            }
            ++result.batches[batch].count;
            batchOf.push_back(batch);
            rowOf.push_back(row);
        }
    }
    std::vector<std::uint32_t> next;
    std::uint32_t first = 0;
    for (ObjectBatch& each : result.batches)
    {
        each.first = first;
        next.push_back(first);
        first += each.count;
    }
    result.rows.resize(rowOf.size());
    for (std::size_t i = 0; i < rowOf.size(); ++i)
    {
        result.rows[next[batchOf[i]]++] = rowOf[i];
    }
    return result;
}

void DrawObjects(const RendererItems& items, const DrawingSettings& drawing,
                 const RenderStateBlock& stateBlock, DrawRecorder& recorder)
{
    const RendererTable& table = *items.table();
    PassList passes(drawing, stateBlock, recorder);
    std::vector<std::vector<std::uint32_t>> passesOf(table.classes().size());
    std::vector<std::uint8_t> isKnown(table.classes().size());
    for (const std::uint32_t row : items.rows())
    {
        const std::uint32_t kind = table.classOf()[row];
        if (isKnown[kind] == 0)
        {
            isKnown[kind] = 1;
            passesOf[kind] = passes.Of(table.classes()[kind].material);
        }
    }
    std::vector<std::uint32_t> commutes;
    for (const ObjectPass& pass : passes.passes())
    {
        commutes.push_back(Commutes(pass, static_cast<std::uint32_t>(commutes.size()),
                                    drawing.sortingSettings, recorder.hasDepth()));
    }
    const ObjectBatches batches = MakeBatches(items, passesOf, commutes);

    FrameCommands& frame = recorder.frame();
    const auto offset = static_cast<std::uint32_t>(frame.instances.size());
    frame.objects = items.table();
    frame.instances.resize(offset + batches.rows.size());
    std::ranges::transform(batches.rows, frame.instances.begin() + offset,
                           [&](std::uint32_t row) { return table.objectOf()[row]; });
    for (const ObjectBatch& batch : batches.batches)
    {
        const RendererTable::MeshPart& part = table.meshParts()[batch.meshPart];
        DrawCommand draw = passes.passes()[batch.pass].draw;
        draw.drawsObjects = true;
        draw.mesh = part.mesh;
        draw.subMesh = part.subMesh;
        draw.state.frontFaceFlipped = batch.isMirrored;
        const std::uint32_t step = isInstanceable(*draw.program) ? batch.count : 1;
        for (std::uint32_t done = 0; done < batch.count; done += step)
        {
            draw.firstInstance = offset + batch.first + done;
            draw.instanceCount = step;
            draw.bounds = BoundsOf(draw, table,
                                   std::span(batches.rows).subspan(batch.first + done, step),
                                   recorder);
            frame.commands.emplace_back(draw);
        }
    }
}

} // namespace limn
