#include "benchmarks/CountAllocations.h"

#include <limn/shaderlab/PrintShaderLab.h>
#include <limn/shaderlab/ShaderLabParser.h>

#include <benchmark/benchmark.h>

#include <cstdlib>
#include <string>

namespace
{

using namespace limn;

/// A shader as projects have them: a dozen properties, three passes with state, 12 KB of HLSL.
std::string TypicalShader()
{
    std::string text = "Shader \"Bench/Typical\"\n{\n    Properties\n    {\n";
    for (int i = 0; i < 12; ++i)
    {
        const std::string n = std::to_string(i);
        text += "        [HideInInspector] _Value" + n + " (\"Value " + n +
                "\", Range(0.0, 1.0)) = 0.5\n";
    }
    text +=
        "        _MainTex (\"Albedo\", 2D) = \"white\" {}\n    }\n    SubShader\n    {\n"
        "        Tags { \"RenderType\" = \"Opaque\" \"RenderPipeline\" = \"UniversalPipeline\" }\n"
        "        LOD 300\n";
    std::string hlsl = "\n            #pragma vertex vert\n            #pragma fragment frag\n"
                       "            #pragma multi_compile _ _MAIN_LIGHT_SHADOWS\n";
    while (hlsl.size() < 4096)
    {
        hlsl += "            // what the next line is good for\n"
                "            output.color.rgb += SampleShadow(input.positionWS, 0.25) * _Tint;\n";
    }
    for (const char* mode : {"UniversalForward", "ShadowCaster", "DepthOnly"})
    {
        text += "        Pass\n        {\n            Name \"" + std::string(mode) +
                "\"\n            Tags { \"LightMode\" = \"" + mode +
                "\" }\n            Blend [_Src] [_Dst]\n            ZWrite On\n            Cull "
                "[_Cull]\n            Stencil\n            {\n                Ref 1\n              "
                "  Comp Always\n                Pass Replace\n            }\n            "
                "HLSLPROGRAM" +
                hlsl + "            ENDHLSL\n        }\n";
    }
    return text + "    }\n    Fallback \"Hidden/InternalError\"\n}\n";
}

/// The properties and passes of TypicalShader() repeated up to a size, in one shader.
std::string LargeShader(std::size_t size)
{
    const std::string typical = TypicalShader();
    const std::size_t begin = typical.find("    SubShader");
    const std::string subShader = typical.substr(begin, typical.find("    Fallback") - begin);
    std::string text = typical.substr(0, begin);
    while (text.size() + subShader.size() + 2 <= size)
    {
        text += subShader;
    }
    return text + "}\n";
}

void Parse(benchmark::State& state, const std::string& text)
{
    long allocations = 0;
    for (auto _ : state)
    {
        const long before = limn::benchmarks::AllocationCount();
        ShaderLabParseResult result = ParseShaderLab(text, "bench.shader");
        allocations = limn::benchmarks::AllocationCount() - before;
        benchmark::DoNotOptimize(result);
        if (result.hasErrors())
        {
            state.SkipWithError("the text has errors");
        }
    }
    state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) *
                            static_cast<std::int64_t>(text.size()));
    state.counters["allocations"] = static_cast<double>(allocations);
    state.counters["file_bytes"] = static_cast<double>(text.size());
}

void ParseTypicalShader(benchmark::State& state)
{
    Parse(state, TypicalShader());
}
BENCHMARK(ParseTypicalShader);

void ParseLargeShader(benchmark::State& state)
{
    Parse(state, LargeShader(static_cast<std::size_t>(state.range(0)) << 20));
}
BENCHMARK(ParseLargeShader)->Arg(1)->Arg(8)->Arg(64)->Unit(benchmark::kMillisecond);

void ParseCommandsOnly(benchmark::State& state)
{
    std::string text = "Shader \"x\" { SubShader {\n";
    for (int i = 0; i < 1000; ++i)
    {
        text += "Pass { Name \"N\" Cull Off ZWrite Off ZTest [_ZTest] Blend One One, Zero One\n"
                "Offset -1, 0.5 ColorMask RGB Tags { \"LightMode\" = \"Meta\" }\n"
                "Stencil { Ref 1 Comp Equal Pass Replace } } // comment\n";
    }
    Parse(state, text + "} }");
}
BENCHMARK(ParseCommandsOnly);

/// Texts made to be slow; the time must grow with the size and not with its square.
void ParseHostileText(benchmark::State& state, const char* piece)
{
    std::string text = "Shader \"x\" { SubShader {";
    while (text.size() < static_cast<std::size_t>(state.range(0)) << 20)
    {
        text += piece;
    }
    for (auto _ : state)
    {
        ShaderLabParseResult result = ParseShaderLab(text, "bench.shader");
        benchmark::DoNotOptimize(result);
    }
    state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) *
                            static_cast<std::int64_t>(text.size()));
}
BENCHMARK_CAPTURE(ParseHostileText, braces, "{")->Arg(4)->Arg(63)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(ParseHostileText, quotes, "\"")->Arg(4)->Arg(63)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(ParseHostileText, comments, "/* /* */")
    ->Arg(4)
    ->Arg(63)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(ParseHostileText, brackets, "[")->Arg(4)->Arg(63)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(ParseHostileText, words, "Shader ")
    ->Arg(4)
    ->Arg(63)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(ParseHostileText, passes, "Pass{}")
    ->Arg(4)
    ->Arg(63)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(ParseHostileText, blocks, "CGPROGRAM // ENDCG ")
    ->Arg(4)
    ->Arg(63)
    ->Unit(benchmark::kMillisecond);

void PrintTypicalShader(benchmark::State& state)
{
    const std::string text = TypicalShader();
    const ShaderLabDocument document = ParseShaderLab(text, "bench.shader").document;
    for (auto _ : state)
    {
        benchmark::DoNotOptimize(PrintShaderLab(document));
    }
    state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) *
                            static_cast<std::int64_t>(text.size()));
}
BENCHMARK(PrintTypicalShader);

} // namespace
