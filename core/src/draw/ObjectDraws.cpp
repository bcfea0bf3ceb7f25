#include "draw/ObjectDraws.h"

#include "draw/PerDraw.h"
#include "draw/ProjectedBounds.h"
#include "scene/RendererTable.h"

#include <algorithm>
#include <array>
#include <limits>
#include <unordered_map>
#include <utility>

namespace limn
{

namespace
{

/// A list that keeps its memory for the thread's next call of this file's functions. Each kind is
/// used by one at a time.
template <typename Value>
std::vector<Value>& Emptied()
{
    static thread_local std::vector<Value> list;
    list.clear();
    return list;
}

/// A pass of a material, looked up once for all objects that are drawn with it.
struct ObjectPass
{
    std::shared_ptr<const Material> material;
    int shaderPass = 0;
    DrawSetup draw; ///< not mirrored
    /// Not mirrored and mirrored: in the frame's table; none = not there yet.
    std::array<std::optional<std::uint32_t>, 2> setups;
};

bool Compiles(const Material& material, int pass, const std::vector<std::string>& globalKeywords)
{
    try
    {
        material.Compile(pass, globalKeywords);
        return true;
    }
    catch (const AssetError&)
    {
        return false;
    }
}

/// The passes of one DrawRenderers call. Its memory is kept for the thread's next one.
class PassList
{
public:
    PassList(const DrawingSettings& drawing, const RenderStateBlock& stateBlock,
             DrawRecorder& recorder)
        : m_Drawing(drawing), m_StateBlock(stateBlock), m_Recorder(recorder)
    {
    }
    ~PassList() { m_Passes.clear(); }
    PassList(const PassList&) = delete;
    PassList& operator=(const PassList&) = delete;

    /// Adds the passes that a renderer of this material draws.
    /// @param properties  of the renderer; null = none
    void AddOf(const std::shared_ptr<const Material>& material,
               const MaterialPropertyBlock* properties, std::vector<std::uint32_t>& passes)
    {
        m_Properties = properties;
        if (m_Drawing.overrideMaterial)
        {
            passes.push_back(Add(m_Drawing.overrideMaterial, m_Drawing.overrideMaterialPassIndex));
            return;
        }
        if (m_Drawing.overrideShader)
        {
            passes.push_back(Add(m_Recorder.WithShader(material, m_Drawing.overrideShader),
                                 m_Drawing.overrideShaderPassIndex));
            return;
        }
        for (const ShaderTagId tag : m_Drawing.shaderTagIds)
        {
            const int pass = material->FindEnabledPassByLightMode(tag);
            if (pass >= 0 && m_Drawing.fallbackMaterial &&
                !Compiles(*material, pass, m_Recorder.keywords()))
            {
                passes.push_back(Add(m_Drawing.fallbackMaterial, 0));
                break;
            }
            if (pass >= 0)
            {
                passes.push_back(Add(material, pass));
            }
        }
    }

    std::vector<ObjectPass>& passes() { return m_Passes; }

private:
    std::uint32_t Add(const std::shared_ptr<const Material>& material, int shaderPass)
    {
        Known& known = m_Index.known[{material.get(), m_Properties, shaderPass}];
        if (known.call != m_Index.call)
        {
            known = {m_Index.call, static_cast<std::uint32_t>(m_Passes.size())};
            m_Passes.push_back(
                {material,
                 shaderPass,
                 m_Recorder.LookUp(*material, shaderPass, m_Properties, m_StateBlock),
                 {}});
        }
        return known.index;
    }

    struct Known
    {
        std::uint64_t call = 0; ///< the last that had it
        std::uint32_t index = 0;
    };
    struct Key
    {
        const Material* material = nullptr;
        const MaterialPropertyBlock* properties = nullptr;
        int shaderPass = 0;

        bool operator==(const Key&) const = default;
    };
    struct HashKey
    {
        std::size_t operator()(const Key& key) const
        {
            const std::hash<const void*> hash;
            return (hash(key.material) * 31 + hash(key.properties)) * 31 +
                   static_cast<std::size_t>(key.shaderPass);
        }
    };
    /// Of all calls: an earlier one's entries are there for their memory only.
    struct Index
    {
        std::uint64_t call = 0;
        std::unordered_map<Key, Known, HashKey> known;
    };
    static Index& NextCall()
    {
        static thread_local Index index;
        constexpr std::size_t k_Most = 1 << 16;
        if (index.known.size() > k_Most)
        {
            index.known.clear();
        }
        ++index.call;
        return index;
    }

    const DrawingSettings& m_Drawing;
    const RenderStateBlock& m_StateBlock;
    DrawRecorder& m_Recorder;
    const MaterialPropertyBlock* m_Properties = nullptr; ///< of what is added
    std::vector<ObjectPass>& m_Passes = Emptied<ObjectPass>();
    Index& m_Index = NextCall();
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
/// their numbers are equal; 0 if the order counts, or nobody wants equal states together. Known are
/// two cases: the nearest wins; and all write the same, because the fragment function looks at
/// nothing but what is bound.
std::uint32_t Commutes(const ObjectPass& pass, std::uint32_t index, const SortingSettings& sorting,
                       bool hasDepth)
{
    constexpr std::uint32_t k_NearestWins = 0x10000;
    const PipelineState& state = pass.draw.state;
    if (!(sorting.criteria & SortingCriteria::OptimizeStateChanges) || state.stencilEnabled ||
        state.alphaToMask || std::ranges::any_of(state.targets, Blends))
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
std::optional<TargetRegion> RegionOf(const RendererTable& table,
                                     std::span<const std::uint32_t> rows,
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
    return recorder.Project({(low + high) * 0.5f, (high - low) * 0.5f},
                            std::numeric_limits<float>::infinity(), atOrigin);
}

/// Where a batch draws, if its pass promises to stay within the mesh. Few objects are looked at one
/// by one; many are seldom apart.
std::optional<TargetRegion> BoundsOf(const DrawSetup& draw, const Mesh& mesh,
                                     const RendererTable& table,
                                     std::span<const std::uint32_t> rows,
                                     const DrawRecorder& recorder)
{
    constexpr std::size_t k_OneByOne = 64;
    constexpr std::size_t k_Most = 4096;
    if (!draw.shader->staysWithinMesh(draw.shaderPass) || rows.size() > k_Most)
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
        const auto seen = recorder.Project(mesh.bounds(), mesh.boundingRadius(),
                                           table.Get(table.objectOf()[row]));
        if (!seen)
        {
            return std::nullopt;
        }
        region = region ? Union(*region, *seen) : *seen;
    }
    return region;
}

} // namespace

namespace
{

/// Puts runs of rows into batches.
class BatchMaker
{
public:
    BatchMaker(const RendererTable& table, const std::vector<std::uint32_t>& commutes)
        : m_Table(table), m_Commutes(commutes), m_Parts(table.meshParts().size())
    {
        const std::size_t kinds = commutes.size() * m_Parts * 2;
        m_Remembers = kinds <= k_MostKinds;
        if (m_Remembers && kinds > m_Memory.seen.size())
        {
            m_Memory.seen.resize(kinds);
        }
        constexpr std::uint32_t k_Most = std::uint32_t{1} << 31;
        if (m_Memory.stretch > k_Most)
        {
            std::ranges::fill(m_Memory.seen, Seen());
            m_Memory.stretch = 0;
        }
        ++m_Memory.stretch;
    }

    /// Rows of one class that follow upon each other, for one pass.
    void Add(std::uint32_t pass, std::uint32_t classIndex, std::uint32_t first, std::uint32_t count)
    {
        const RendererTable::RowClass& rowClass = m_Table.classes()[classIndex];
        const std::size_t kind =
            (pass * m_Parts + rowClass.meshPart) * 2 + (rowClass.isMirrored ? 1 : 0);
        if (m_Runs.empty() || kind != m_LastKind)
        {
            m_LastKind = kind;
            m_Batch = BatchOf(kind, pass, rowClass);
        }
        m_Batches[m_Batch].count += count;
        m_Runs.push_back({m_Batch, first, count});
    }

    /// @param rows     what the runs are of
    /// @param batched  those of the batches are appended
    std::span<const ObjectBatch> Take(const std::vector<std::uint32_t>& rows,
                                      std::vector<std::uint32_t>& batched)
    {
        std::uint32_t first = 0;
        for (ObjectBatch& batch : m_Batches)
        {
            batch.first = first;
            first += std::exchange(batch.count, 0);
        }
        const std::size_t offset = batched.size();
        batched.resize(offset + first);
        std::uint32_t* out = batched.data() + offset;
        for (const Run& run : m_Runs)
        {
            ObjectBatch& batch = m_Batches[run.batch];
            std::copy_n(rows.begin() + run.first, run.count, out + batch.first + batch.count);
            batch.count += run.count;
        }
        return m_Batches;
    }

private:
    struct Run
    {
        std::uint32_t batch = 0;
        std::uint32_t first = 0; ///< among the items
        std::uint32_t count = 0;
    };
    /// The batch of a kind, if it belongs to the current stretch of draws that may change places.
    struct Seen
    {
        std::uint32_t stretch = 0;
        std::uint32_t batch = 0;
    };
    /// Of all calls: each begins a stretch of its own, so that nothing has to be cleared for few
    /// draws out of many kinds.
    struct Memory
    {
        std::vector<Seen> seen; ///< by kind
        std::uint32_t stretch = 0;
    };
    static Memory& MemoryOfThread()
    {
        static thread_local Memory memory;
        return memory;
    }
    /// With more, only neighbours are put together.
    static constexpr std::size_t k_MostKinds = 1 << 22;

    std::uint32_t BatchOf(std::size_t kind, std::uint32_t pass,
                          const RendererTable::RowClass& rowClass)
    {
        const std::uint32_t number = rowClass.isAgain ? 0 : m_Commutes[pass];
        m_Memory.stretch += number == 0 || number != m_Number || !m_Remembers ? 1 : 0;
        m_Number = number;
        if (m_Remembers && m_Memory.seen[kind].stretch == m_Memory.stretch)
        {
            return m_Memory.seen[kind].batch;
        }
        m_Batches.push_back({pass, rowClass.meshPart, rowClass.isMirrored, 0, 0});
        const auto batch = static_cast<std::uint32_t>(m_Batches.size() - 1);
        if (m_Remembers)
        {
            m_Memory.seen[kind] = {m_Memory.stretch, batch};
        }
        return batch;
    }

    const RendererTable& m_Table;
    const std::vector<std::uint32_t>& m_Commutes;
    const std::size_t m_Parts;
    Memory& m_Memory = MemoryOfThread();
    bool m_Remembers = false; ///< kinds that were not the last
    std::vector<Run>& m_Runs = Emptied<Run>();
    std::vector<ObjectBatch>& m_Batches = Emptied<ObjectBatch>();
    std::size_t m_LastKind = 0;
    std::uint32_t m_Batch = 0;
    std::uint32_t m_Number = 0;
};

} // namespace

std::span<const ObjectBatch> MakeBatches(const RendererItems& items, std::span<const ClassRun> runs,
                                         const std::vector<std::vector<std::uint32_t>>& passesOf,
                                         const std::vector<std::uint32_t>& commutes,
                                         std::vector<std::uint32_t>& rows)
{
    BatchMaker maker(*items.table(), commutes);
    for (const ClassRun& run : runs)
    {
        const std::vector<std::uint32_t>& passes = passesOf[run.rowClass];
        if (passes.size() == 1)
        {
            maker.Add(passes.front(), run.rowClass, run.first, run.count);
            continue;
        }
        for (std::uint32_t row = run.first; row < run.first + run.count; ++row)
        {
            for (const std::uint32_t pass : passes)
            {
                maker.Add(pass, run.rowClass, row, 1);
            }
        }
    }
    return maker.Take(items.rows(), rows);
}

void DrawObjects(const RendererItems& items, std::span<const ClassRun> runs,
                 const DrawingSettings& drawing, const RenderStateBlock& stateBlock,
                 DrawRecorder& recorder)
{
    const RendererTable& table = *items.table();
    PassList passes(drawing, stateBlock, recorder);
    static thread_local std::vector<std::vector<std::uint32_t>> passesOf; // by class
    std::vector<std::uint8_t>& isKnown = Emptied<std::uint8_t>();
    passesOf.resize(std::max(passesOf.size(), table.classes().size()));
    isKnown.resize(table.classes().size());
    for (const ClassRun& run : runs)
    {
        if (std::exchange(isKnown[run.rowClass], std::uint8_t{1}) == 0)
        {
            passesOf[run.rowClass].clear();
            const RendererTable::RowClass& rowClass = table.classes()[run.rowClass];
            passes.AddOf(rowClass.material, rowClass.properties.get(), passesOf[run.rowClass]);
        }
    }
    std::vector<std::uint32_t>& commutes = Emptied<std::uint32_t>();
    for (const ObjectPass& pass : passes.passes())
    {
        commutes.push_back(Commutes(pass, static_cast<std::uint32_t>(commutes.size()),
                                    drawing.sortingSettings, recorder.hasDepth()));
    }
    FrameCommands& frame = recorder.frame();
    frame.objects = items.table();
    const auto offset = static_cast<std::uint32_t>(frame.instances.size());
    const auto batches = MakeBatches(items, runs, passesOf, commutes, frame.instances);
    const std::span<std::uint32_t> rows = std::span(frame.instances).subspan(offset);
    for (const ObjectBatch& batch : batches)
    {
        const RendererTable::MeshPart& part = table.meshParts()[batch.meshPart];
        const DrawSetup& pass = passes.passes()[batch.pass].draw;
        std::optional<std::uint32_t>& setup =
            passes.passes()[batch.pass].setups[batch.isMirrored ? 1 : 0];
        if (!setup)
        {
            DrawSetup turned = pass;
            turned.state.frontFaceFlipped = recorder.FlipsFrontFace(batch.isMirrored);
            setup = recorder.Add(std::move(turned));
        }
        DrawCommand draw;
        draw.drawsObjects = true;
        draw.scissor = recorder.commonState().scissor;
        draw.setup = *setup;
        draw.mesh = recorder.Add(part.mesh);
        draw.subMesh = part.subMesh;
        const std::uint32_t step = isInstanceable(*pass.program) ? batch.count : 1;
        for (std::uint32_t done = 0; done < batch.count; done += step)
        {
            draw.firstInstance = offset + batch.first + done;
            draw.instanceCount = step;
            draw.bounds =
                BoundsOf(pass, *part.mesh, table, rows.subspan(batch.first + done, step), recorder);
            frame.commands.emplace_back(draw);
        }
    }
    std::ranges::transform(rows, rows.begin(),
                           [&](std::uint32_t row) { return table.objectOf()[row]; });
}

} // namespace limn
