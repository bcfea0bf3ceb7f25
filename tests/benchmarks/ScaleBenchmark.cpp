// What a frame of many renderers costs the CPU, against plain loops over arrays that do the least
// that has to be done. Both take turns in one run. No device draws.
//
//   cmake --preset release -DLIMN_BUILD_TESTS=ON
//   cmake --build --preset release --target scale_benchmark
//   build/release/tests/scale_benchmark [--quick] [COUNT...]

#include "CountAllocations.h"
#include "CountDraws.h"
#include "NoDevice.h"
#include "Samples.h"
#include "renderers/SortEntries.h"
#include "scale/PlainLoops.h"

#include <cstdlib>
#include <cstring>
#include <limn/core/BuiltinShaders.h>
#include <limn/core/RecordingDevice.h>
#include <limn/core/UniversalRenderPipeline.h>
#include <limn/limn.h>
#include <malloc.h>
#include <numeric>
#include <random>
#include <string>

namespace limn::benchmarks
{

namespace
{

/// Draws the camera's opaque objects once more in a raster pass of a render graph, and into a
/// texture whose name is longer than what a std::string holds without asking for memory.
class GraphFeature final : public ScriptableRendererFeature
{
public:
    void Create() override { m_Pass.renderPassEvent = RenderPassEvent::AfterRenderingOpaques; }
    void AddRenderPasses(ScriptableRenderer& renderer, RenderingData&) override
    {
        renderer.EnqueuePass(m_Pass);
    }

private:
    class Pass final : public ScriptableRenderPass
    {
    public:
        void RecordRenderGraph(RenderGraph& graph, ContextContainer& frameData) override
        {
            struct PassData
            {
                RendererListHandle list;
            };
            const auto& camera = frameData.Get<UniversalCameraData>();
            const auto& resources = frameData.Get<UniversalResourceData>();
            const auto& rendering = frameData.Get<UniversalRenderingData>();
            PassData* data = nullptr;
            auto builder = graph.AddRasterRenderPass<PassData>("Again", data);
            data->list = graph.CreateRendererList(RendererListParams(
                rendering.cullResults(),
                RenderingUtils::CreateDrawingSettings(ShaderTagId("UniversalForward"), rendering,
                                                      camera, frameData.Get<UniversalLightData>(),
                                                      SortingCriteria::CommonOpaque),
                FilteringSettings(RenderQueueRange::opaque)));
            builder.UseRendererList(data->list);
            builder.SetRenderAttachment(resources.activeColorTexture(), 0);
            builder.SetRenderAttachmentDepth(resources.activeDepthTexture());
            builder.SetRenderFunc([](const PassData& own, RasterGraphContext& context)
                                  { context.cmd.DrawRendererList(own.list); });
            AddOwnTexture(graph);
        }

    private:
        static void AddOwnTexture(RenderGraph& graph)
        {
            struct PassData
            {
            };
            TextureDesc desc(glm::vec2(0.5f));
            desc.name = "_TextureOfTheBenchmarkWithAQuiteLongName";
            PassData* data = nullptr;
            auto builder = graph.AddRasterRenderPass<PassData>("Own texture", data);
            builder.SetRenderAttachment(graph.CreateTexture(desc), 0);
            builder.AllowPassCulling(false);
            builder.SetRenderFunc([](const PassData&, RasterGraphContext& context)
                                  { context.cmd.ClearRenderTarget(ClearFlag::Color, Color::red); });
        }
    };
    Pass m_Pass;
};

/// Cubes and quads of ten materials; the outline of every hundredth is drawn.
class ManyRenderers
{
public:
    explicit ManyRenderers(std::size_t count)
    {
        const auto compiler = std::make_shared<ShaderCompiler>();
        std::vector<std::shared_ptr<const Mesh>> meshes;
        for (std::size_t i = 0; i < k_MeshCount; ++i)
        {
            meshes.push_back(
                CreatePrimitive(i % 2 != 0 ? PrimitiveType::Cube : PrimitiveType::Quad));
        }
        std::vector<std::shared_ptr<const Material>> materials;
        for (std::size_t i = 0; i < k_MaterialCount; ++i)
        {
            materials.push_back(
                std::make_shared<Material>(FindShippedShader("Limn/Half Lambert", compiler)));
        }
        for (std::size_t i = 0; i < count; ++i)
        {
            GameObject& object = m_Scene.Add("object");
            const std::array<float, 3> place = PlaceOf(i);
            object.layer = static_cast<int>(i % 8);
            object.transform.localPosition = {place[0], place[1], place[2]};
            object.renderer = MeshRenderer{meshes[i % k_MeshCount],
                                           {materials[i / k_MeshCount % k_MaterialCount]},
                                           RenderingLayerMask{1u | (i % 100 == 0 ? 256u : 0u)}};
        }
        ScreenSpaceOutlineSettings settings;
        settings.m_ScreenSpaceOutlineShader =
            FindShippedShader("Hidden/ScreenSpaceOutline", compiler);
        settings.m_LayerMask = LayerMask::Everything();
        settings.m_RenderingLayerMask = 8;
        m_Renderer = std::make_unique<UniversalRenderer>(compiler);
        m_Renderer->AddFeature(std::make_unique<ScreenSpaceOutlineRenderFeature>(settings));
        RegisterVolumeComponents(m_Components);
        m_Volumes = std::make_unique<VolumeManager>(m_Components);
        m_Stack = std::make_unique<VolumeStack>(m_Volumes->CreateStack());
        auto profile = std::make_shared<VolumeProfile>();
        profile->Add<ScreenSpaceOutline>().m_Enable.Override(true);
        m_Volume.sharedProfile = std::move(profile);
        m_Volumes->Register(&m_Volume);
        m_Volumes->Update(*m_Stack, glm::vec3(0.0f), m_Camera.volumeLayerMask);
        m_Request.scene = &m_Scene;
        m_Request.camera = &m_Camera;
        m_Request.width = 1920;
        m_Request.height = 1080;
        m_Request.volumeStack = m_Stack.get();
    }

    CullingResults Cull() { return limn::Cull(m_Scene, m_Camera, 16.0f / 9.0f); }
    /// Until the next call.
    const RenderResult& Frame()
    {
        m_Pipeline.RenderSingleCamera(*m_Renderer, m_Request, m_Result);
        return m_Result;
    }

    /// More of them than an object may have; some throw shadows, as the main one does.
    void AddLights()
    {
        m_Pipeline.shadows.shadowDistance = 300.0f; // nothing is nearer than the default
        m_Pipeline.shadows.shadowCascadeCount = 4;
        m_Scene.mainLight.shadows = LightShadows::Soft;
        for (int i = 0; i < 12; ++i)
        {
            Light& light = m_Scene.additionalLights.emplace_back();
            light.type = i % 2 != 0 ? LightType::Spot : LightType::Point;
            light.transform.localPosition = {static_cast<float>(i) * 8.0f - 48.0f, 1.0f, 80.0f};
            light.range = 60.0f;
            light.shadows = i < 3 ? LightShadows::Hard : LightShadows::None;
        }
    }

    std::size_t passCount() const { return m_Result.frame->passes.size(); } ///< of the last frame

    /// One that draws over the whole picture.
    void AddGraphPass() { m_Renderer->AddFeature(std::make_unique<GraphFeature>()); }

    /// To and fro, so that what is seen differs from frame to frame.
    void MoveCamera()
    {
        m_Camera.transform.localPosition.x = ++m_Steps % 2 == 0 ? 0.0f : 0.5f;
        m_Camera.transform.localPosition.y = static_cast<float>(m_Steps % 7) * 0.1f;
    }

    /// Moves all of them a little to and fro, so that none leaves the place where it began.
    void MoveAll()
    {
        ++m_MovesOfAll;
        std::size_t i = 0;
        for (const auto& object : m_Scene.objects())
        {
            object->transform.localPosition.y += (++i + m_MovesOfAll) % 2 == 0 ? 0.01f : -0.01f;
        }
    }

    /// A hundredth of the objects, others each time.
    void Move()
    {
        const auto& objects = m_Scene.objects();
        for (std::size_t i = 0; i < objects.size() / 100 + 1; ++i)
        {
            objects[m_Random() % objects.size()]->transform.localPosition.y += 0.01f;
        }
    }

private:
    Scene m_Scene;
    Camera m_Camera;
    VolumeComponentRegistry m_Components;
    Volume m_Volume;
    std::unique_ptr<VolumeManager> m_Volumes;
    std::unique_ptr<VolumeStack> m_Stack;
    std::unique_ptr<UniversalRenderer> m_Renderer;
    NoDevice m_Device;
    UniversalRenderPipeline m_Pipeline{m_Device};
    RenderRequest m_Request;
    RenderResult m_Result; ///< of the last frame
    std::minstd_rand m_Random{1};
    unsigned m_Steps = 0;
    std::size_t m_MovesOfAll = 0;
};

/// Judging against summing what is judged: as FilterItem for each, and as the table holds it.
void CompareJudging(ManyRenderers& scene, int pairs)
{
    const CullingResults culled = scene.Cull();
    const FilteringSettings filtering(RenderQueueRange::opaque, LayerMask::Everything(),
                                      RenderingLayerMask{256u});
    DrawingSettings drawing;
    drawing.shaderTagIds = {ShaderTagId("UniversalForward")};
    std::vector<FilterItem> items;
    for (const RendererItem& item : culled.items)
    {
        items.push_back(item.filter);
    }
    std::vector<std::uint32_t> words(items.size() * sizeof(FilterItem) / sizeof(std::uint32_t));
    std::memcpy(words.data(), items.data(), words.size() * sizeof(std::uint32_t));
    Comparison comparison;
    std::uint32_t sum = 0;
    int drawn = 0;
    for (int pair = 0; pair < pairs; ++pair)
    {
        const double a = Time([&] { drawn += Judge(culled.items, filtering, drawing).counts[0]; });
        const double b = Time([&] { sum = std::accumulate(words.begin(), words.end(), sum); });
        comparison.Add(a, b);
    }
    comparison.Print("judging / summing their 24 bytes each");
    std::printf("%s", sum == 1 && drawn == 1 ? " " : "");
}

void CompareSorting(std::size_t count, int pairs)
{
    PlainLoops plain(count);
    plain.Cull();
    std::vector<SortEntry> source(plain.visibleCount());
    for (std::size_t i = 0; i < source.size(); ++i)
    {
        const std::array<float, 3> place = PlaceOf(i);
        const glm::vec3 offset(place[0], place[1], place[2]);
        source[i] = {SortKey(SortingCriteria::CommonOpaque, 2000,
                             SortDistance(offset, SortingSettings()), 0),
                     static_cast<std::uint32_t>(i % 100), static_cast<std::uint32_t>(i)};
    }
    std::vector<SortEntry> spare;
    Comparison comparison;
    for (int pair = 0; pair < pairs; ++pair)
    {
        std::vector<SortEntry> entries = source;
        plain.MakeKeys();
        const double a = Time([&] { RadixSort(entries, spare); });
        comparison.Add(a, Time([&] { plain.Sort(); }));
    }
    comparison.Print("sorting / the plain radix loop");
}

/// Counts how often frames asked for memory that came behind enough of their kind.
struct Allocations
{
    long still = 0;
    long cameraMoves = 0;
    long someMove = 0; ///< a hundredth of the objects
    long allMove = 0;

    long Sum() const { return still + cameraMoves + someMove + allMove; }
};

Allocations CountSteadyAllocations(ManyRenderers& scene)
{
    const auto count = [&](auto&& move)
    {
        constexpr int k_FramesUntilSteady = 16;
        for (int i = 0; i < k_FramesUntilSteady; ++i)
        {
            move();
            scene.Frame();
        }
        move();
        const long counted = AllocationCount();
        scene.Frame();
        return AllocationCount() - counted;
    };
    Allocations result;
    result.still = count([] {});
    result.cameraMoves = count([&] { scene.MoveCamera(); });
    result.someMove = count([&] { scene.Move(); });
    result.allMove = count([&] { scene.MoveAll(); });
    return result;
}

/// @return how often steady frames asked for memory
long CompareFrames(std::size_t count, int pairs)
{
    std::printf("\n%zu renderers: limn, the plain loops, ratio [tenth-ninetieth part]\n", count);
    ManyRenderers(1).Frame(); // what compiling the shaders takes once is no renderer's
    malloc_trim(0);           // else these would lie where those of the table before have lain
    const double before = ResidentBytes();
    ManyRenderers scene(count);
    const RenderResult& result = scene.Frame();
    const double bytes = ResidentBytes() - before;
    PlainLoops plain(count);
    plain.Frame();
    Comparison still;
    Comparison camera;
    Comparison some;
    Comparison all;
    Comparison cull;
    for (int pair = 0; pair < pairs; ++pair)
    {
        const auto compare = [&](Comparison& comparison)
        {
            const double frame = Time([&] { scene.Frame(); });
            comparison.Add(frame, Time([&] { plain.Frame(); }));
        };
        scene.Frame(); // what moved last is another's
        compare(still);
        cull.Add(Time([&] { scene.Cull(); }), Time([&] { plain.Cull(); }));
        scene.MoveCamera();
        compare(camera);
        scene.Move();
        compare(some);
        scene.MoveAll();
        compare(all);
    }
    still.Print("a frame in which nothing moves / all loops");
    camera.Print("the camera moves / all loops");
    some.Print("a hundredth moves / all loops");
    all.Print("all objects move / all loops");
    cull.Print("keeping the table and culling / culling");
    CompareJudging(scene, pairs);
    CompareSorting(count, pairs);
    const auto print = [](const char* what, const Allocations& n)
    {
        std::printf("allocations in a frame %s: still %ld, camera moves %ld, a hundredth moves "
                    "%ld, all move %ld\n",
                    what, n.still, n.cameraMoves, n.someMove, n.allMove);
    };
    const Allocations plainly = CountSteadyAllocations(scene);
    print("", plainly);
    ManyRenderers lit(count);
    lit.AddLights();
    const Allocations withLights = CountSteadyAllocations(lit);
    print("with lights and shadows", withLights);
    ManyRenderers graph(count);
    graph.AddGraphPass();
    const Allocations withGraph = CountSteadyAllocations(graph);
    print("with a render graph pass", withGraph);
    std::printf("%zu visible, %zu draws of %zu instances; %.0f bytes a renderer\n",
                plain.visibleCount(), CountDraws(*result.frame), result.frame->instances.size(),
                bytes / static_cast<double>(count));
    return plainly.Sum() + withLights.Sum() + withGraph.Sum();
}

} // namespace

} // namespace limn::benchmarks

int main(int argc, char** argv)
{
    std::vector<std::size_t> counts;
    bool isQuick = false;
    for (int i = 1; i < argc; ++i)
    {
        const std::string argument = argv[i];
        isQuick = isQuick || argument == "--quick";
        if (argument != "--quick")
        {
            counts.push_back(std::stoul(argument));
        }
    }
    if (counts.empty())
    {
        counts = isQuick ? std::vector<std::size_t>{1000}
                         : std::vector<std::size_t>{1'000, 10'000, 100'000, 1'000'000};
    }
    for (const std::size_t count : counts)
    {
        const long allocations = limn::benchmarks::CompareFrames(count, isQuick ? 2 : 21);
        if (isQuick && allocations > 0)
        {
            std::fprintf(stderr, "a steady frame asks for no memory\n");
            return 1;
        }
    }
}
