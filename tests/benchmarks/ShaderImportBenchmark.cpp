#include <limn/base/WorkerProcess.h>
#include <limn/shaderlab/ShaderCompiler.h>
#include <limn/shaderlab/ShaderLabParser.h>

#include "TemporaryFolder.h"
#include "lowering/StageLowering.h"
#include "preprocess/GlslangSession.h"
#include "preprocess/Preprocessor.h"
#include "spirv/SpirvBuilder.h"
#include "spirv/SpirvReflection.h"

#include <benchmark/benchmark.h>
#include <glslang/Public/ResourceLimits.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <ctime>
#include <fstream>
#include <map>
#include <stdexcept>
#include <thread>

namespace limn
{

namespace
{

constexpr const char* k_UnlitBody = R"(
            half4 frag(Varyings input) : SV_Target
            {
                return SAMPLE_TEXTURE2D(_BaseMap, sampler_BaseMap, input.uv) * _BaseColor;
            }
)";

constexpr const char* k_LitBody = R"(
            #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Lighting.hlsl"
            half4 frag(Varyings input) : SV_Target
            {
                InputData inputData = (InputData)0;
                inputData.positionWS = input.positionWS;
                inputData.normalWS = normalize(input.normalWS);
                inputData.viewDirectionWS = GetWorldSpaceNormalizeViewDir(input.positionWS);
                inputData.shadowCoord = TransformWorldToShadowCoord(input.positionWS);
                SurfaceData surface = (SurfaceData)0;
                surface.albedo =
                    SAMPLE_TEXTURE2D(_BaseMap, sampler_BaseMap, input.uv).rgb * _BaseColor.rgb;
                surface.smoothness = 0.5;
                surface.occlusion = 1.0;
                surface.alpha = 1.0;
                return UniversalFragmentPBR(inputData, surface);
            }
)";

/// A pass as URP projects write them, with the fragment function of `body`.
std::string ShaderText(const std::string& name, const std::string& body)
{
    return "Shader \"Bench/" + name + R"("
{
    Properties
    {
        _BaseMap ("Albedo", 2D) = "white" {}
        _BaseColor ("Color", Color) = (1, 1, 1, 1)
    }
    SubShader
    {
        Tags { "RenderPipeline" = "UniversalPipeline" }
        Pass
        {
            Tags { "LightMode" = "UniversalForward" }
            HLSLPROGRAM
            #pragma vertex vert
            #pragma fragment frag
            #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
            struct Attributes
            {
                float4 positionOS : POSITION;
                float3 normalOS : NORMAL;
                float2 uv : TEXCOORD0;
            };
            struct Varyings
            {
                float4 positionCS : SV_POSITION;
                float2 uv : TEXCOORD0;
                float3 positionWS : TEXCOORD1;
                float3 normalWS : TEXCOORD2;
            };
            TEXTURE2D(_BaseMap);
            SAMPLER(sampler_BaseMap);
            CBUFFER_START(UnityPerMaterial)
                float4 _BaseMap_ST;
                half4 _BaseColor;
            CBUFFER_END
            Varyings vert(Attributes input)
            {
                Varyings output;
                output.positionWS = TransformObjectToWorld(input.positionOS.xyz);
                output.positionCS = TransformWorldToHClip(output.positionWS);
                output.normalWS = TransformObjectToWorldNormal(input.normalOS);
                output.uv = TRANSFORM_TEX(input.uv, _BaseMap);
                return output;
            }
)" + body + "            ENDHLSL\n        }\n    }\n}\n";
}

PassProgram OnlyProgram(const std::string& body)
{
    const ShaderLabParseResult result =
        ParseShaderLab(ShaderText("One", body), "/nowhere/bench.shader");
    return result.document.subShaders.at(0).passes.at(0).program.value();
}

/// Milliseconds of each step over all iterations, for medians: one slow or lucky run moves none.
class StepTimes
{
public:
    template <typename Function>
    double Measure(const std::string& step, Function&& function)
    {
        const auto start = std::chrono::steady_clock::now();
        function();
        const std::chrono::duration<double, std::milli> taken =
            std::chrono::steady_clock::now() - start;
        Add(step, taken.count());
        return taken.count();
    }
    void Add(const std::string& step, double value) { m_Values[step].push_back(value); }

    /// The median of each step as a counter, and the quartiles of those named.
    void Report(benchmark::State& state, const std::vector<std::string>& spreads)
    {
        for (auto& [step, values] : m_Values)
        {
            std::sort(values.begin(), values.end());
            state.counters[step] = values[values.size() / 2];
        }
        for (const std::string& step : spreads)
        {
            const std::vector<double>& values = m_Values.at(step);
            state.counters[step + "_q1"] = values[values.size() / 4];
            state.counters[step + "_q3"] = values[values.size() * 3 / 4];
        }
    }

private:
    std::map<std::string, std::vector<double>> m_Values;
};

/// What glslang by itself does with HLSL that includes nothing, with limn's options.
///
/// @param legalize  glslang's own call of the optimiser, which makes the SPIR-V of HLSL legal
void RunGlslang(const std::string& hlsl, std::string_view entry, ShaderStage stage, bool legalize)
{
    const char* const text = hlsl.c_str();
    glslang::TShader shader(GlslangStage(stage));
    shader.setStrings(&text, 1);
    SetEnvironment(shader, stage);
    shader.setPreamble(HalfPreamble(false));
    shader.setEntryPoint("main");
    shader.setSourceEntryPoint(std::string(entry).c_str());
    shader.setAutoMapBindings(true);
    const bool parsed = shader.parse(GetDefaultResources(), 500, false, k_GlslangMessages);
    glslang::TProgram program;
    program.addShader(&shader);
    if (!parsed || !program.link(k_GlslangMessages) || !program.mapIO())
    {
        throw std::runtime_error(shader.getInfoLog());
    }
    glslang::SpvOptions options;
    options.disableOptimizer = !legalize;
    std::vector<std::uint32_t> spirv;
    glslang::GlslangToSpv(*program.getIntermediate(GlslangStage(stage)), spirv, &options);
    benchmark::DoNotOptimize(spirv.data());
}

/// The steps of an import one by one, each with its time.
struct Steps
{
    std::string text;       ///< preprocessed
    std::string vertexHlsl; ///< rewritten: what nothing reaches is gone
    std::string fragmentHlsl;

    void Run(const PassProgram& program, StepTimes& times)
    {
        const ShaderCompilerOptions options;
        IncludeResolver resolver(options, program.file);
        ColumnFinder lines(program, resolver);
        ShaderProgram pass;
        times.Measure("ms_preprocess",
                      [&]
                      {
                          PreprocessedHlsl hlsl = PreprocessHlsl(program, ShaderStage::Vertex, {},
                                                                 resolver, lines, pass.diagnostics);
                          if (hlsl.namesStages)
                          {
                              throw std::runtime_error("the stages do not share their text");
                          }
                          text = std::move(hlsl.text);
                      });
        const auto start = std::chrono::steady_clock::now();
        const HlslSource source(text);
        const StageInterface vertexInterface = ReadStageInterface(
            source.declarations, *source.declarations.FindDefinition("vert"), ShaderStage::Vertex);
        const StageInterface fragmentInterface =
            ReadStageInterface(source.declarations, *source.declarations.FindDefinition("frag"),
                               ShaderStage::Fragment);
        const StageLinkage linkage = LinkStages(vertexInterface, nullptr, fragmentInterface);
        vertexHlsl = RewriteStage(source, ShaderStage::Vertex, vertexInterface, linkage).text;
        fragmentHlsl = RewriteStage(source, ShaderStage::Fragment, fragmentInterface, linkage).text;
        const std::chrono::duration<double, std::milli> rewriting =
            std::chrono::steady_clock::now() - start;
        times.Add("ms_rewrite", rewriting.count());
        times.Measure("ms_build",
                      [&]
                      {
                          pass.vertexSpirv = BuildSpirv(vertexHlsl, ShaderStage::Vertex,
                                                        program.file, false, pass.diagnostics);
                          pass.fragmentSpirv = BuildSpirv(fragmentHlsl, ShaderStage::Fragment,
                                                          program.file, false, pass.diagnostics);
                      });
        std::vector<std::string> messages;
        times.Measure("ms_reflect",
                      [&] { ReflectLayout(pass, linkage, source.declarations.objects, messages); });
    }
};

/// Importing a pass without a cache, and glslang by itself: on the HLSL that limn gives to it, as
/// it is and made legal, and on the whole preprocessed HLSL, made legal; and the import in a
/// process of its own. In turn, so that what else the machine does hits all.
void ImportAgainstGlslang(benchmark::State& state, const char* body)
{
    const PassProgram program = OnlyProgram(body);
    ShaderCompilerOptions isolation;
    isolation.process = std::make_shared<WorkerProcess>();
    ShaderCompiler isolated(isolation);
    ShaderCompiler compiler;
    StepTimes times;
    StepTimes unused;
    Steps steps;
    steps.Run(program, unused);
    compiler.Compile(program);
    isolated.Compile(program);
    for (auto _ : state)
    {
        const double import = times.Measure("ms_import", [&] { compiler.Compile(program); });
        const double apart = times.Measure("ms_isolated", [&] { isolated.Compile(program); });
        times.Add("ratio_isolated", apart / import);
        const auto glslang = [&](bool legalize)
        {
            RunGlslang(steps.vertexHlsl, k_EntryName, ShaderStage::Vertex, legalize);
            RunGlslang(steps.fragmentHlsl, k_EntryName, ShaderStage::Fragment, legalize);
        };
        const double plain = times.Measure("ms_glslang", [&] { glslang(false); });
        const double legal = times.Measure("ms_glslang_legal", [&] { glslang(true); });
        const double whole =
            times.Measure("ms_glslang_whole",
                          [&]
                          {
                              RunGlslang(steps.text, "vert", ShaderStage::Vertex, true);
                              RunGlslang(steps.text, "frag", ShaderStage::Fragment, true);
                          });
        times.Add("ratio_whole", import / whole);
        times.Add("ratio", import / plain);
        times.Add("ratio_legal", import / legal);
        steps.Run(program, times);
    }
    times.Report(state, {"ratio", "ratio_legal", "ratio_whole", "ratio_isolated"});
    state.counters["kb_hlsl"] =
        static_cast<double>(steps.vertexHlsl.size() + steps.fragmentHlsl.size()) / 1024.0;
}
BENCHMARK_CAPTURE(ImportAgainstGlslang, unlit, k_UnlitBody)
    ->Iterations(31)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(ImportAgainstGlslang, lit, k_LitBody)
    ->Iterations(31)
    ->Unit(benchmark::kMillisecond);

/// The same import with an empty cache folder and with one that has the pass.
void ImportColdAgainstWarm(benchmark::State& state, const char* body)
{
    const test::TemporaryFolder folder;
    const PassProgram program = OnlyProgram(body);
    StepTimes times;
    ShaderCompiler().Compile(program);
    for (auto _ : state)
    {
        ShaderCompilerOptions options;
        options.cacheFolder = folder.path() / "cache";
        std::filesystem::remove_all(options.cacheFolder);
        const double cold =
            times.Measure("ms_cold", [&] { ShaderCompiler(options).Compile(program); });
        ShaderCompiler second(options);
        const double warm = times.Measure("ms_warm", [&] { second.Compile(program); });
        times.Add("ratio", cold / warm);
        if (second.statistics().loadedFromCache != 1)
        {
            state.SkipWithError("the cache did not have the pass");
        }
    }
    times.Report(state, {"ratio"});
}
BENCHMARK_CAPTURE(ImportColdAgainstWarm, unlit, k_UnlitBody)
    ->Iterations(31)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(ImportColdAgainstWarm, lit, k_LitBody)
    ->Iterations(31)
    ->Unit(benchmark::kMillisecond);

std::vector<std::filesystem::path> WriteShaders(const std::filesystem::path& folder, int count)
{
    std::vector<std::filesystem::path> files;
    for (int i = 0; i < count; ++i)
    {
        const std::string n = std::to_string(i);
        const std::string body =
            "            half4 frag(Varyings input) : SV_Target\n            {\n"
            "                return _BaseColor * " +
            n + ".5 + half4(frac(input.uv), 0.0, 1.0);\n            }\n";
        files.push_back(folder / ("Shader" + n + ".shader"));
        std::ofstream(files.back()) << ShaderText("Many" + n, body);
    }
    return files;
}

/// Reads and compiles all files on a number of threads, without a cache.
void ImportAll(const std::vector<std::filesystem::path>& files, int threadCount)
{
    ShaderCompiler compiler;
    std::atomic<std::size_t> next{0};
    const auto work = [&]
    {
        for (std::size_t i = next++; i < files.size(); i = next++)
        {
            const ShaderLabDocument document = LoadShaderLab(files[i]);
            compiler.Compile(*document.subShaders.at(0).passes.at(0).program);
        }
    };
    std::vector<std::jthread> threads;
    for (int i = 0; i < threadCount; ++i)
    {
        threads.emplace_back(work);
    }
}

/// Milliseconds that all threads of the process have run: what other processes take does not count.
double ProcessorTime()
{
    return 1000.0 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// A folder of 1 000 files, imported with one thread and with two in turn. Where the machine does
/// something else as well, processor times say more of what threads cost than the speedup does.
void ImportFolder(benchmark::State& state)
{
    const test::TemporaryFolder folder;
    const std::vector<std::filesystem::path> files =
        WriteShaders(folder.path(), static_cast<int>(state.range(0)));
    StepTimes times;
    for (auto _ : state)
    {
        const double begin = ProcessorTime();
        const double one = times.Measure("ms_1_thread", [&] { ImportAll(files, 1); });
        const double middle = ProcessorTime();
        const double two = times.Measure("ms_2_threads", [&] { ImportAll(files, 2); });
        times.Add("ms_processor_1", middle - begin);
        times.Add("ms_processor_2", ProcessorTime() - middle);
        times.Add("speedup", one / two);
    }
    times.Report(state, {"speedup"});
}
BENCHMARK(ImportFolder)->Arg(1000)->Iterations(3)->UseRealTime()->Unit(benchmark::kMillisecond);

} // namespace

} // namespace limn
