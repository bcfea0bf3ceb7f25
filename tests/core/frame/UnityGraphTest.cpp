#include "frame/FrameBuilder.h"
#include "scene/TestScene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <regex>

// The tests of Unity's render graph (SRP core 17.5, NativePassCompilerRenderGraphTests and
// RenderGraphTests), each as commands that passes record, with what Unity says becomes of it. There
// passes declare what they use; here nothing is declared.
//
// Without a counterpart, since what they are about does not exist here:
//
// | Unity's test | why |
// | --- | --- |
// | NonRasterBreaksPass | no compute passes |
// | WriteToImportedComputeBufferNotCulled | no buffers that passes write |
// | FencesWork | no second queue |
// | FragmentAfterSamplingBreaksPassWithInputAttachment | no input attachments |
// | ChangingGlobalStateDisablesCulling | globals are looked up while passes record, before any is
//   left out, so that none takes a global with it |
// | TransientTexturesCantBeReused, UseTransientOutsidePassRaiseException | no textures that belong
//   to a pass |
// | UseTextureValidation, SetRenderAttachmentValidation | nothing is declared, so nothing twice;
//   sampling a target is refused: FrameCompilerPasses.CannotSampleTheirOwnColor; one texture as two
//   colours: CommandBufferTest |
// | ComputeHash… (five) | frames are compiled anew, no graph is looked up by a hash |
// | RenderPassCullingTests, RenderGraphConstraintsTests | about allocations and names inside Unity
// |

namespace limn
{
namespace
{

using test::FrameBuilder;
using test::RenderTexturePtr;

/// T0…T9 and D live in the frame only (Unity: made by the graph), Out and Kept are looked at
/// afterwards (imported).
struct GraphTextures
{
    std::vector<RenderTexturePtr> t;
    RenderTexturePtr d = test::DepthTarget("D", 8, 4, true);
    RenderTexturePtr otherD = test::Target("D2", 8, 4, true, GraphicsFormat::D32_SFloat);
    RenderTexturePtr out = test::Target("Out");
    RenderTexturePtr kept = test::Target("Kept");
    RenderTexturePtr samples4 = Samples("C4", GraphicsFormat::R8G8B8A8_UNorm);
    RenderTexturePtr depth4 = Samples("D4", GraphicsFormat::D32_SFloat_S8_UInt);

    GraphTextures()
    {
        for (int i = 0; i < 10; ++i)
        {
            t.push_back(test::Target("T" + std::to_string(i), 8, 4, true));
        }
    }

    /// The colours from `first` on.
    std::vector<RenderTexturePtr> Colors(std::size_t first, std::size_t count) const
    {
        const auto begin = t.begin() + static_cast<std::ptrdiff_t>(first);
        return {begin, begin + static_cast<std::ptrdiff_t>(count)};
    }

private:
    static RenderTexturePtr Samples(const char* name, GraphicsFormat format)
    {
        RenderTextureDescriptor descriptor(8, 4, format);
        descriptor.msaaSamples = 4;
        return std::make_shared<const RenderTexture>(name, descriptor, SamplerState{}, true);
    }
};

/// One of Unity's tests.
struct UnityGraph
{
    const char* name;
    std::function<void(FrameBuilder&, const GraphTextures&)> record;
    std::vector<std::string> unity;     ///< its passes: "targets with load and store: draws"
    std::vector<std::string> limn = {}; ///< empty = the same
    const char* why = "";               ///< what is better about it
    /// Of the textures that passes draw into, those that are read after the frame; by default Out.
    std::function<std::vector<RenderTexturePtr>(const GraphTextures&)> outputs =
        [](const GraphTextures& g)
    {
        return std::vector{g.out};
    };
};

void PrintTo(const UnityGraph& graph, std::ostream* out)
{
    *out << graph.name;
}

constexpr const char* k_Unread = "a colour that nothing reads is not even cleared";

/// A draw of the whole target: Unity's AccessFlags.WriteAll.
void WriteAll(FrameBuilder& frame, std::uint32_t number)
{
    frame.Blit(number, {}, "True");
}

/// Of a color or depth attachment.
template <typename Attachment>
std::string OpsText(const Attachment& attachment)
{
    constexpr const char* k_Loads[] = {"load", "clear", "-"};
    const bool isStored = attachment.store == StoreOp::Store;
    return attachment.texture->name() + " " + k_Loads[static_cast<int>(attachment.load)] + ">" +
           (isStored && attachment.resolve ? "store and resolve"
            : isStored                     ? "store"
            : attachment.resolve           ? "resolve"
                                           : "-");
}

/// "T0 clear>store, D clear>-: 1 2", and with textures that draws sample "Out ->store: 1(T0)".
std::string PassText(const FrameTables& tables, const CompiledRenderPass& pass)
{
    std::string text;
    for (const auto& color : pass.colors)
    {
        text += (text.empty() ? "" : ", ") + OpsText(color);
    }
    if (pass.depth)
    {
        text += (text.empty() ? "" : ", ") + OpsText(*pass.depth);
    }
    text += ":";
    for (const PassCommand& command : pass.commands)
    {
        if (const auto* draw = std::get_if<DrawCommand>(&command))
        {
            text += " " + std::to_string(draw->firstInstance);
            for (const TextureSlot& slot : tables.Setup(*draw).bindings->textures)
            {
                text += "(" + slot.texture->name() + ")";
            }
        }
    }
    return text;
}

/// How much a frame costs: passes, what it loads and stores, and draws.
struct GraphCost
{
    std::size_t passes = 0;
    std::ptrdiff_t loads = 0;
    std::ptrdiff_t clears = 0;
    std::ptrdiff_t stores = 0;
    std::ptrdiff_t draws = 0;
};

GraphCost CostOf(const std::vector<std::string>& passes)
{
    GraphCost cost{passes.size()};
    for (const std::string& pass : passes)
    {
        const auto count = [&](const char* what)
        {
            const std::regex wanted(what);
            return std::distance(std::sregex_iterator(pass.begin(), pass.end(), wanted), {});
        };
        cost.loads += count(" load>");
        cost.clears += count(" clear>");
        cost.stores += count(">store");
        cost.draws += count("[:0-9)] [0-9]+");
    }
    return cost;
}

class UnityGraphTest : public testing::TestWithParam<UnityGraph>
{
};

TEST_P(UnityGraphTest, ComesToTheSameOrToLess)
{
    const UnityGraph& graph = GetParam();
    const GraphTextures textures;
    FrameBuilder builder;
    test::FrameCompiler compiler(true);
    // What is kept was drawn and read by a frame before.
    builder.Bind(textures.kept).Draw(90);
    compiler.Compile(builder.Take(), {textures.kept});
    builder.Bind(textures.kept).Draw(91);
    compiler.Compile(builder.Take(), {textures.kept});

    graph.record(builder, textures);
    const CompiledFrame frame = compiler.Compile(builder.Take(), graph.outputs(textures));
    std::vector<std::string> passes;
    std::transform(frame.passes.begin(), frame.passes.end(), std::back_inserter(passes),
                   [&](const CompiledRenderPass& pass) { return PassText(frame, pass); });
    EXPECT_THAT(frame.notes, testing::IsEmpty());
    if (graph.limn.empty())
    {
        EXPECT_EQ(passes, graph.unity);
        return;
    }
    EXPECT_EQ(passes, graph.limn);
    EXPECT_STRNE(graph.why, "");
    const GraphCost mine = CostOf(graph.limn);
    const GraphCost unity = CostOf(graph.unity);
    EXPECT_LE(mine.passes, unity.passes);
    EXPECT_LE(mine.loads, unity.loads);
    EXPECT_LE(mine.clears, unity.clears);
    EXPECT_LE(mine.stores, unity.stores);
    EXPECT_LE(mine.draws, unity.draws);
}

const std::vector<UnityGraph>& MergedGraphs()
{
    static const std::vector<UnityGraph> k_Graphs{
        {"SimpleMergePasses",
         [](FrameBuilder& f, const GraphTextures& g)
         {
             f.Bind(g.Colors(0, 2), g.d).Clear(ClearFlag::All).Draw(1);
             f.Bind(g.t[0], g.d).Draw(2);
             f.Bind(g.t[2]).Clear(ClearFlag::Color).Bind(g.Colors(0, 3), g.d).Draw(3);
         },
         {"T0 clear>store, T1 clear>store, T2 clear>store, D clear>-: 1 2 3"},
         {},
         "",
         [](const GraphTextures& g)
         {
             return g.Colors(0, 3);
         }},
        {"MergeDepthPassWithNoDepthPass",
         [](FrameBuilder& f, const GraphTextures& g)
         {
             f.Bind(g.out, g.d).Clear(ClearFlag::All).Draw(1);
             f.Bind(g.out).Draw(2);
         },
         {"Out clear>store, D clear>-: 1 2"}},
        {"MergeDepthPassWithNoDepthPass_NothingShared",
         [](FrameBuilder& f, const GraphTextures& g)
         {
             f.Bind(nullptr, g.d).Clear(ClearFlag::All).Draw(1);
             f.Bind(g.out).Clear(ClearFlag::Color).Draw(2);
         },
         {"Out clear>store, D clear>-: 1 2"},
         {"Out clear>store: 2"},
         "nothing reads the depth"},
        {"MergeNoDepthPassWithDepthPass",
         [](FrameBuilder& f, const GraphTextures& g)
         {
             f.Bind(g.out).Clear(ClearFlag::Color).Draw(1);
             f.Bind(g.out, g.d).Clear(ClearFlag::DepthStencil).Draw(2);
         },
         {"Out clear>store, D clear>-: 1 2"}},
        {"MergeMultiplePassesDifferentDepth",
         [](FrameBuilder& f, const GraphTextures& g)
         {
             f.Bind(nullptr, g.d).Clear(ClearFlag::DepthStencil).Draw(1);
             f.Bind(g.out).Clear(ClearFlag::Color).Draw(2);
             f.Bind(g.out, g.d).Draw(3).Bind(g.out).Draw(4).Bind(nullptr, g.d).Draw(5);
             f.Bind(g.out, g.d).Draw(6);
         },
         {"Out clear>store, D clear>-: 1 2 3 4 5 6"}},
        {"MergeDifferentDepthFormatsBreaksPass",
         [](FrameBuilder& f, const GraphTextures& g)
         {
             f.Bind(g.out, g.d).Clear(ClearFlag::All).Draw(1);
             f.Bind(g.out, g.otherD).Clear(ClearFlag::Depth).Draw(2);
         },
         {"Out clear>store, D clear>-: 1", "Out load>store, D2 clear>-: 2"}},
        {"MergePassWithWriteAllPass",
         [](FrameBuilder& f, const GraphTextures& g)
         {
             f.Bind(nullptr, g.d).Clear(ClearFlag::All).Draw(1);
             WriteAll(f.Bind(g.out), 2);
             f.Bind(g.out, g.d).Draw(3);
         },
         {"Out ->store, D clear>-: 1 2 3"}},
        {"MergeWriteAllPassWithReadPass",
         [](FrameBuilder& f, const GraphTextures& g)
         {
             WriteAll(f.Bind(g.out), 1);
             f.Bind(g.out, g.d).Clear(ClearFlag::DepthStencil).Draw(2);
         },
         {"Out ->store, D clear>-: 1 2"}},
        {"MergeReadPassWithWriteAllPass",
         [](FrameBuilder& f, const GraphTextures& g)
         {
             f.Bind(g.out, g.d).Clear(ClearFlag::All).Draw(1);
             WriteAll(f.Bind(g.out), 2);
         },
         {"Out clear>store, D clear>-: 1 2"},
         {"Out ->store: 2"},
         "nothing is left of what the first one draws"},
        {"MergeDiscardPassWithWrite",
         [](FrameBuilder& f, const GraphTextures& g)
         {
             f.Bind(g.t[0]).Draw(1).Bind(g.t[1]).Draw(2, {g.t[0]});
             f.Bind(g.t[0]).Draw(3).Bind(g.out).Draw(4, {g.t[0], g.t[1]});
         },
         {"T0 ->store: 1", "T1 ->store: 2(T0)", "T0 load>store: 3", "Out ->store: 4(T0)(T1)"}},
        {"NonFragmentSamplingBreaksPass",
         [](FrameBuilder& f, const GraphTextures& g)
         {
             f.Bind(g.t[0]).Clear(ClearFlag::Color).Draw(1);
             f.Bind(g.out).Clear(ClearFlag::Color).Draw(2, {g.t[0]});
         },
         {"T0 clear>store: 1", "Out clear>store: 2(T0)"}},
        {"FragmentAfterSamplingBreaksPass",
         [](FrameBuilder& f, const GraphTextures& g)
         {
             f.Bind(g.out, g.d).Clear(ClearFlag::All).Draw(1, {g.kept});
             f.Bind(g.kept).Draw(2).Bind(g.out, g.d).Draw(3, {g.kept});
         },
         {"Out clear>store, D clear>store: 1(Kept)", "Kept load>store: 2",
          "Out load>store, D load>-: 3(Kept)"}},
        {"TooManyAttachmentsBreaksPass",
         [](FrameBuilder& f, const GraphTextures& g)
         {
             f.Bind(g.Colors(0, 6), g.d).Clear(ClearFlag::All).Draw(1);
             f.Bind(g.Colors(6, 3), nullptr).Clear(ClearFlag::Color).Draw(2);
         },
         {"T0 clear>store, T1 clear>store, T2 clear>store, T3 clear>store, T4 clear>store, "
          "T5 clear>store, D clear>-: 1",
          "T6 clear>store, T7 clear>store, T8 clear>store: 2"},
         {},
         "",
         [](const GraphTextures& g)
         {
             return g.Colors(0, 9);
         }},
        {"NativeSubPassesLimitNotExceeded",
         [](FrameBuilder& f, const GraphTextures& g)
         {
             f.Bind(g.Colors(0, 2), g.d).Clear(ClearFlag::All).Draw(1);
             for (std::uint32_t number = 2; number <= 9; number += 2)
             {
                 f.Bind(g.t[0]).Draw(number).Bind(g.Colors(0, 2), g.d).Draw(number + 1);
             }
         },
         {"T0 clear>store, T1 clear>store, D clear>store: 1 2 3 4 5 6 7 8",
          "T0 load>store, T1 load>store, D load>-: 9"},
         {"T0 clear>store, T1 clear>store, D clear>-: 1 2 3 4 5 6 7 8 9"},
         "there are no sub-passes whose number is limited",
         [](const GraphTextures& g)
         {
             return g.Colors(0, 2);
         }},
    };
    return k_Graphs;
}

const std::vector<UnityGraph>& StoredGraphs()
{
    static const std::vector<UnityGraph> k_Graphs{
        {"ImportParametersWork_Plain",
         [](FrameBuilder& f, const GraphTextures& g) { f.Bind(g.kept).Draw(1); },
         {"Kept load>store: 1"}},
        {"ImportParametersWork_ClearOnFirstUse",
         [](FrameBuilder& f, const GraphTextures& g)
         { f.Bind(g.kept).Clear(ClearFlag::Color).Draw(1); },
         {"Kept clear>store: 1"}},
        {"ImportParametersWork_DiscardOnLastUse",
         [](FrameBuilder& f, const GraphTextures& g)
         { f.Bind(g.out, g.d).Clear(ClearFlag::All).Draw(1); },
         {"Out clear>store, D clear>-: 1"}},
        {"ResolveMSAAImportColor",
         [](FrameBuilder& f, const GraphTextures& g)
         {
             f.Bind(g.samples4, g.depth4).Clear(ClearFlag::All).Draw(1);
             f.Bind(g.out).Draw(2, {g.samples4});
         },
         {"C4 clear>resolve, D4 clear>-: 1", "Out ->store: 2(C4)"}},
        {"SimpleCreateReleaseTexture",
         [](FrameBuilder& f, const GraphTextures& g)
         {
             f.Bind(g.t[0]).Clear(ClearFlag::Color).Draw(1);
             f.Bind(g.t[1]).Clear(ClearFlag::Color).Draw(2, {g.t[0]});
             f.Bind(g.t[2]).Clear(ClearFlag::Color).Draw(3, {g.t[0], g.t[1]});
             f.Bind(g.out).Clear(ClearFlag::Color).Draw(4, {g.t[0], g.t[2]});
         },
         {"T0 clear>store: 1", "T1 clear>store: 2(T0)", "T2 clear>store: 3(T0)(T1)",
          "Out clear>store: 4(T0)(T2)"}},
        {"TransientCreateReleaseInSamePass",
         [](FrameBuilder& f, const GraphTextures& g)
         {
             f.Bind({g.out, g.t[0]}, g.d).Clear(ClearFlag::All).Draw(1);
             f.Bind(g.t[1]).Draw(2).Bind(g.kept).Draw(3, {g.t[1]});
         },
         {"Out clear>store, T0 clear>-, D clear>-: 1", "T1 ->store: 2", "Kept load>store: 3(T1)"},
         {"Out clear>store, T0 ->-, D clear>-: 1", "T1 ->store: 2", "Kept load>store: 3(T1)"},
         k_Unread},
    };
    return k_Graphs;
}

const std::vector<UnityGraph>& CulledGraphs()
{
    static const std::vector<UnityGraph> k_Graphs{
        {"DecreaseResourceVersion_WhenAllProducersExceptFirstAreCulled",
         [](FrameBuilder& f, const GraphTextures& g)
         {
             f.Bind({g.out, g.t[0]}, nullptr).Draw(1);
             f.Bind(g.t[0]).Draw(2).Draw(3).Bind(g.t[0], g.d).Clear(ClearFlag::All).Draw(4);
         },
         {"Out ->store, T0 ->-: 1"}},
        {"CullProducer_WhenVersionsAreNotExplicitlyRead",
         [](FrameBuilder& f, const GraphTextures& g)
         {
             for (std::uint32_t number = 1; number <= 5; ++number)
             {
                 f.Bind(number == 4 ? std::vector{g.t[0], g.out} : std::vector{g.t[0]}, nullptr);
                 f.Draw(number);
             }
         },
         {"T0 ->-, Out ->store: 4"}},
        {"CullProducer_WhenNoneOfItsWrittenResourcesAreExplicitlyRead",
         [](FrameBuilder& f, const GraphTextures& g)
         {
             f.Bind(g.Colors(0, 2), nullptr).Draw(1);
             f.Bind({g.t[0], g.t[2]}, nullptr).Draw(2).Bind(g.out).Draw(3, {g.t[2]});
         },
         {"T0 ->-, T2 ->store: 2", "Out ->store: 3(T2)"}},
        {"DoNotCullProducer_WhenOneOfItsWrittenResourcesIsExplicitlyRead",
         [](FrameBuilder& f, const GraphTextures& g)
         {
             f.Bind(g.Colors(0, 2), nullptr).Draw(1);
             f.Bind({g.t[0], g.t[2]}, nullptr).Draw(2, {g.t[1]}).Bind(g.out).Draw(3, {g.t[2]});
         },
         {"T0 ->store, T1 ->store: 1", "T0 load>-, T2 ->store: 2(T1)", "Out ->store: 3(T2)"},
         {"T0 ->-, T1 ->store: 1", "T0 ->-, T2 ->store: 2(T1)", "Out ->store: 3(T2)"},
         "nothing reads T0, so that none of it is stored or loaded"},
        {"CullProducer_WhenNextVersionOfProducedResourceIsWrittenAll",
         [](FrameBuilder& f, const GraphTextures& g)
         {
             f.Bind(g.t[0]).Draw(1).Bind(g.t[1]).Draw(2, {g.t[0]});
             f.Bind(g.t[0]).Draw(3, {g.t[1]});
             WriteAll(f.Bind(g.t[0]), 4);
             f.Bind(g.out).Draw(5, {g.t[0]});
         },
         {"T0 ->store: 4", "Out ->store: 5(T0)"}},
        {"WriteToBackBufferNotCulled",
         [](FrameBuilder& f, const GraphTextures& g) { f.Bind(g.out).Draw(1); },
         {"Out ->store: 1"}},
        {"NoWriteToBackBufferCulled",
         [](FrameBuilder& f, const GraphTextures& g)
         { f.Bind(g.out).Draw(1).Bind(g.t[0]).Draw(2).Bind(g.t[1]).Draw(3, {g.t[0]}); },
         {"Out ->store: 1"}},
        {"WriteToImportedTextureNotCulled",
         [](FrameBuilder& f, const GraphTextures& g) { f.Bind(g.kept).Draw(1); },
         {"Kept load>store: 1"}},
        {"PassWriteResourcePartialNotReadAfterNotCulled",
         [](FrameBuilder& f, const GraphTextures& g)
         {
             f.Bind(g.Colors(0, 2), nullptr).Clear(ClearFlag::Color).Draw(1);
             f.Bind(g.out).Draw(2, {g.t[0]});
         },
         {"T0 clear>store, T1 clear>-: 1", "Out ->store: 2(T0)"},
         {"T0 clear>store, T1 ->-: 1", "Out ->store: 2(T0)"},
         k_Unread},
        {"PartialUnusedProductNotCulled",
         [](FrameBuilder& f, const GraphTextures& g)
         {
             f.Bind(g.Colors(0, 2), g.d).Clear(ClearFlag::All).Draw(1);
             f.Bind(g.t[1]).Draw(2).Bind(g.out).Draw(3, {g.t[0]});
         },
         {"T0 clear>store, T1 clear>-, D clear>-: 1", "Out ->store: 3(T0)"},
         {"T0 clear>store, T1 ->-, D clear>-: 1", "Out ->store: 3(T0)"},
         k_Unread},
    };
    return k_Graphs;
}

std::string NameOf(const testing::TestParamInfo<UnityGraph>& info)
{
    return info.param.name;
}

INSTANTIATE_TEST_SUITE_P(Merging, UnityGraphTest, testing::ValuesIn(MergedGraphs()), NameOf);
INSTANTIATE_TEST_SUITE_P(LoadAndStore, UnityGraphTest, testing::ValuesIn(StoredGraphs()), NameOf);
INSTANTIATE_TEST_SUITE_P(Culling, UnityGraphTest, testing::ValuesIn(CulledGraphs()), NameOf);

} // namespace
} // namespace limn
