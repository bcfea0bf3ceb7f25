#include "renderers/ObjectDraws.h"

#include "cull/ProjectedBounds.h"
#include "scene/PerDraw.h"
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

/// Returns where lists that stay from call to call get their memory, many pieces at a time: objects
/// that move meet lights that no frame before has had beside them, and each such pair is an entry.
std::pmr::memory_resource& MemoryOfThread()
{
    static thread_local std::pmr::unsynchronized_pool_resource memory;
    return memory;
}

/// The numbers that a DrawRenderers call gives to keys. Those of an earlier call only keep their
/// memory.
template <typename Key, typename Hash = std::hash<Key>>
class NumbersOfCall
{
public:
    /// Returns the numbers of the thread's next call, none yet.
    static NumbersOfCall& Begin()
    {
        static thread_local NumbersOfCall numbers;
        constexpr std::size_t k_Most = 1 << 16;
        if (numbers.m_Known.size() > k_Most)
        {
            numbers.m_Known.clear();
        }
        ++numbers.m_Call;
        return numbers;
    }

    /// Gives the key this number unless it has one.
    /// @return the number that it has, and whether it is new
    std::pair<std::uint32_t, bool> TryAdd(const Key& key, std::size_t number)
    {
        Known& known = m_Known[key];
        const bool isNew = std::exchange(known.call, m_Call) != m_Call;
        known.number = isNew ? static_cast<std::uint32_t>(number) : known.number;
        return {known.number, isNew};
    }

private:
    struct Known
    {
        std::uint64_t call = 0; ///< the last that had it
        std::uint32_t number = 0;
    };
    std::uint64_t m_Call = 0;
    std::pmr::unordered_map<Key, Known, Hash> m_Known{&MemoryOfThread()};
};

/// A pass of a material, looked up once for all objects that are drawn with it.
struct ObjectPass
{
    std::shared_ptr<const Material> material;
    const MaterialPropertyBlock* properties = nullptr; ///< of the renderer; null = none
    int shaderPass = 0;
    DrawSetup draw; ///< not mirrored
    /// Not mirrored and mirrored: in the frame's table; none = not there yet.
    std::array<std::optional<std::uint32_t>, 2> setups;
};

bool Compiles(const Material& material, int pass, std::span<const std::string> globalKeywords)
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
               const MaterialPropertyBlock* properties, PassNumbers& passes)
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

    /// The same pass for objects with these lights, if it looks at them.
    /// @param lights  of ObjectLights
    std::uint32_t WithLights(std::uint32_t index, const MaterialPropertyBlock& lights)
    {
        if (!ReadsObjectLights(*m_Passes[index].draw.program))
        {
            return index;
        }
        const std::shared_ptr<const Material> material = m_Passes[index].material;
        m_Properties = m_Passes[index].properties;
        return Add(material, m_Passes[index].shaderPass, &lights);
    }

    std::vector<ObjectPass>& passes() { return m_Passes; }

private:
    std::uint32_t Add(const std::shared_ptr<const Material>& material, int shaderPass,
                      const MaterialPropertyBlock* lights = nullptr)
    {
        const auto [number, isNew] =
            m_Numbers.TryAdd({material.get(), m_Properties, lights, shaderPass}, m_Passes.size());
        if (isNew)
        {
            m_Passes.push_back(
                {material,
                 m_Properties,
                 shaderPass,
                 m_Recorder.LookUp(*material, shaderPass, {m_Properties, lights}, m_StateBlock),
                 {}});
        }
        return number;
    }

    struct Key
    {
        const Material* material = nullptr;
        const MaterialPropertyBlock* properties = nullptr;
        const MaterialPropertyBlock* lights = nullptr;
        int shaderPass = 0;

        bool operator==(const Key&) const = default;
    };
    struct HashKey
    {
        std::size_t operator()(const Key& key) const
        {
            const std::hash<const void*> hash;
            const std::size_t blocks = hash(key.properties) * 31 + hash(key.lights);
            return (hash(key.material) * 31 + blocks) * 31 +
                   static_cast<std::size_t>(key.shaderPass);
        }
    };
    const DrawingSettings& m_Drawing;
    const RenderStateBlock& m_StateBlock;
    DrawRecorder& m_Recorder;
    const MaterialPropertyBlock* m_Properties = nullptr; ///< of what is added
    std::vector<ObjectPass>& m_Passes = ThreadScratch<ObjectPass>();
    NumbersOfCall<Key, HashKey>& m_Numbers = NumbersOfCall<Key, HashKey>::Begin();
};

bool Blends(RenderTargetBlendState target)
{
    target.writeMask = ColorWriteMask::All; // the defaults mean no blending
    return target != RenderTargetBlendState();
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

/// Returns the region in which a batch draws, if its pass promises to stay within the mesh. A few
/// objects are examined one by one; many are seldom far apart.
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

/// Cuts runs where the lights of their rows change, if what they draw looks at them.
class LightSplitter
{
public:
    /// @param passesOf  by class; what is drawn with lights is appended
    LightSplitter(const RendererItems& items, PassList& passes,
                  std::pmr::vector<PassNumbers>& passesOf, ObjectLights& lights)
        : m_Items(items),
          m_Passes(passes),
          m_PassesOf(passesOf),
          m_Lights(lights),
          m_Next(static_cast<std::uint32_t>(items.table()->classes().size()))
    {
    }

    /// Until the thread's next call.
    std::span<const ClassRun> Split(std::span<const ClassRun> runs)
    {
        for (const ClassRun& run : runs)
        {
            const auto& passes = m_PassesOf[run.passes];
            if (std::ranges::none_of(
                    passes, [&](std::uint32_t pass)
                    { return ReadsObjectLights(*m_Passes.passes()[pass].draw.program); }))
            {
                m_Runs.push_back(run);
                continue;
            }
            for (std::uint32_t i = run.first; i < run.first + run.count; ++i)
            {
                Add(run.rowClass, i);
            }
        }
        return m_Runs;
    }

private:
    void Add(std::uint32_t rowClass, std::uint32_t item)
    {
        const RendererTable& table = *m_Items.table();
        const std::uint32_t row = m_Items.rows()[item];
        const ObjectLights::Set set = m_Lights.Find(table.origin() + glm::dvec3(table.center(row)),
                                                    glm::dvec3(table.extent(row)));
        const std::uint32_t passes = PassesOf(rowClass, set);
        if (!m_Runs.empty() && m_Runs.back().passes == passes &&
            m_Runs.back().first + m_Runs.back().count == item)
        {
            ++m_Runs.back().count;
            return;
        }
        m_Runs.push_back({rowClass, item, 1, passes});
    }

    std::uint32_t PassesOf(std::uint32_t rowClass, ObjectLights::Set set)
    {
        const auto [number, isNew] = m_Numbers.TryAdd(std::uint64_t{rowClass} << 32 | set, m_Next);
        if (isNew)
        {
            m_PassesOf.resize(std::max(m_PassesOf.size(), std::size_t{m_Next} + 1));
            PassNumbers& lit = m_PassesOf[m_Next++];
            lit.clear();
            for (const std::uint32_t pass : m_PassesOf[rowClass])
            {
                lit.push_back(m_Passes.WithLights(pass, m_Lights.ValuesOf(set)));
            }
        }
        return number;
    }

    const RendererItems& m_Items;
    PassList& m_Passes;
    std::pmr::vector<PassNumbers>& m_PassesOf;
    ObjectLights& m_Lights;
    std::uint32_t m_Next;
    NumbersOfCall<std::uint64_t>& m_Numbers = NumbersOfCall<std::uint64_t>::Begin();
    std::vector<ClassRun>& m_Runs = ThreadScratch<ClassRun>();
};

} // namespace

void DrawObjects(const RendererItems& items, std::span<const ClassRun> runs,
                 const DrawingSettings& drawing, const RenderStateBlock& stateBlock,
                 DrawRecorder& recorder)
{
    const RendererTable& table = *items.table();
    PassList passes(drawing, stateBlock, recorder);
    static thread_local std::pmr::vector<PassNumbers> passesOf(&MemoryOfThread()); // by class
    std::vector<std::uint8_t>& isKnown = ThreadScratch<std::uint8_t>();
    passesOf.resize(std::max(passesOf.size(), table.classes().size()));
    isKnown.resize(table.classes().size());
    for (const ClassRun& run : runs)
    {
        if (std::exchange(isKnown[run.rowClass], std::uint8_t{1}) == 0)
        {
            passesOf[run.rowClass].clear();
            const RendererTable::DrawKey& rowClass = table.classes()[run.rowClass];
            passes.AddOf(rowClass.material, rowClass.properties.get(), passesOf[run.rowClass]);
        }
    }
    if (recorder.objectLights().isNeeded())
    {
        runs = LightSplitter(items, passes, passesOf, recorder.objectLights()).Split(runs);
    }
    std::vector<std::uint32_t>& commutes = ThreadScratch<std::uint32_t>();
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
        const std::uint32_t mesh = recorder.Add(part.mesh);
        const std::uint32_t step = isInstanceable(*pass.program) ? batch.count : 1;
        for (std::uint32_t done = 0; done < batch.count; done += step)
        {
            // Filled where it stays: a copy would have to wait for each of these small writes.
            auto& draw =
                std::get<DrawCommand>(frame.commands.emplace_back(std::in_place_type<DrawCommand>));
            draw.drawsObjects = true;
            draw.scissor = recorder.commonState().scissor;
            draw.setup = *setup;
            draw.mesh = mesh;
            draw.subMesh = part.subMesh;
            draw.firstInstance = offset + batch.first + done;
            draw.instanceCount = step;
            draw.bounds =
                BoundsOf(pass, *part.mesh, table, rows.subspan(batch.first + done, step), recorder);
        }
    }
    std::ranges::transform(rows, rows.begin(),
                           [&](std::uint32_t row) { return table.objectOf()[row]; });
}

} // namespace limn
