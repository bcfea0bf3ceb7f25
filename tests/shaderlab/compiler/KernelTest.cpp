#include "Mentions.h"
#include "ShaderTestSupport.h"
#include "SpirvTestSupport.h"

#include <limn/base/WorkerProcess.h>
#include <limn/shaderlab/ComputeDocument.h>
#include <limn/shaderlab/InitialKeywords.h>
#include <limn/shaderlab/UnsupportedProgramError.h>

#include <algorithm>

namespace limn::test
{

namespace
{

constexpr const char* k_Sum = R"(#pragma kernel Sum
StructuredBuffer<float> _In;
RWStructuredBuffer<float> _Out;
groupshared float parts[8];
[numthreads(4 * 2, 1, 1)]
void Sum(uint3 id : SV_DispatchThreadID, uint index : SV_GroupIndex)
{
    parts[index] = _In[id.x];
    GroupMemoryBarrierWithGroupSync();
    _Out[id.x] = parts[7 - index];
}
)";

std::shared_ptr<const ShaderProgram> CompileKernel(const std::string& text,
                                                   std::span<const std::string> keywords = {},
                                                   std::size_t kernel = 0)
{
    ShaderCompiler compiler;
    return compiler.Compile(ParseCompute(text, "t.compute").kernels.at(kernel), keywords);
}

std::vector<std::string> ParseErrors(const std::string& text)
{
    try
    {
        ParseCompute(text, "t.compute");
    }
    catch (const AssetError& error)
    {
        return Messages(error.diagnostics());
    }
    return {};
}

std::vector<std::string> KernelErrors(const std::string& text)
{
    return CompileMessages(ParseCompute(text, "t.compute").kernels.at(0));
}

template <typename Binding>
const Binding& Named(const std::vector<Binding>& bindings, const std::string& name,
                     bool isCounter = false)
{
    for (const Binding& binding : bindings)
    {
        bool fits = binding.name == name;
        if constexpr (std::is_same_v<Binding, StorageBufferBinding>)
        {
            fits = fits && binding.isCounter == isCounter;
        }
        if (fits)
        {
            return binding;
        }
    }
    throw std::runtime_error("there is no " + name);
}

/// A kernel of one thread whose body is `body`.
std::string Kernel(const std::string& declarations, const std::string& body)
{
    return "#pragma kernel K\n" + declarations +
           "\n[numthreads(1, 1, 1)]\nvoid K(uint3 id : " + "SV_DispatchThreadID)\n{\n" + body +
           "\n}\n";
}

} // namespace

TEST(ComputeDocument, HasAKernelForEachPragma)
{
    const ComputeDocument document = ParseCompute(
        "#pragma kernel First WIDE SIZE=8\n#pragma kernel Second\n", "some/folder/Blur.compute");
    EXPECT_EQ(document.name, "Blur");
    EXPECT_EQ(document.file, "some/folder/Blur.compute");
    ASSERT_EQ(document.kernels.size(), 2u);
    EXPECT_EQ(document.kernels[0].kernel.name, "First");
    EXPECT_EQ(document.kernels[0].kernel.location.line, 1);
    EXPECT_EQ(document.kernels[0].chunks.at(0).text, "#define WIDE 1\n#define SIZE 8\n");
    EXPECT_EQ(document.kernels[1].kernel.name, "Second");
    EXPECT_EQ(document.kernels[1].chunks.size(), 1u);
}

TEST(ComputeDocument, IsRefusedWithAllMistakesAtOnce)
{
    EXPECT_THAT(ParseErrors("#pragma kernel\n#pragma kernel A\n  #pragma kernel A\n"),
                testing::ElementsAre(Mentions("1:1: error: #pragma kernel", "names no function",
                                              "#pragma kernel Name"),
                                     Mentions("3:3: error: #pragma kernel", "'A' already")));
    EXPECT_THAT(ParseErrors("float4 x;\n"),
                testing::ElementsAre(Mentions(" error: file", "no kernel", "#pragma kernel Name")));
}

TEST(Kernel, CompilesToValidSpirvWithTheSizeOfItsGroups)
{
    const auto program = CompileKernel(k_Sum);
    EXPECT_EQ(ValidationMessages(program->computeSpirv), "");
    EXPECT_EQ(program->threadGroupSize, (std::array<std::uint32_t, 3>{8, 1, 1}));
    EXPECT_TRUE(program->vertexSpirv.empty());
    EXPECT_TRUE(program->diagnostics.empty());
    const StorageBufferBinding& in = Named(program->layout.storageBuffers, "_In");
    const StorageBufferBinding& out = Named(program->layout.storageBuffers, "_Out");
    EXPECT_FALSE(in.isWritten);
    EXPECT_TRUE(out.isWritten);
    EXPECT_EQ(in.stride, 4u);
    EXPECT_EQ(out.stages, ShaderStage::Compute);
    EXPECT_NE(in.binding, out.binding);
}

TEST(Kernel, MayBeCalledMain)
{
    const auto program = CompileKernel("#pragma kernel main\nRWStructuredBuffer<uint> _Out;\n"
                                       "[numthreads(2, 3, 4)] void main(uint i : SV_GroupIndex)\n"
                                       "{ _Out[i] = i; }\n");
    EXPECT_EQ(ValidationMessages(program->computeSpirv), "");
    EXPECT_EQ(program->threadGroupSize, (std::array<std::uint32_t, 3>{2, 3, 4}));
}

TEST(Kernel, TakesItsSystemValuesInAStruct)
{
    const auto program = CompileKernel(
        "#pragma kernel K\nRWStructuredBuffer<uint> _Out;\n"
        "struct Ids { uint3 id : SV_DispatchThreadID; uint index : SV_GroupIndex; };\n"
        "[numthreads(2, 2, 1)] void K(Ids ids) { _Out[ids.id.x] = ids.index; }\n");
    EXPECT_EQ(ValidationMessages(program->computeSpirv), "");
}

TEST(Kernel, DefinesWhatItsPragmaNamesForItselfOnly)
{
    const std::string text = "#pragma kernel A WIDE N=16\n#pragma kernel B\n"
                             "RWStructuredBuffer<uint> _Out;\n"
                             "#if defined(WIDE)\n#define THREADS N\n#else\n#define THREADS 2\n"
                             "#endif\n"
                             "[numthreads(THREADS, 1, 1)] void A(uint i : SV_GroupIndex)\n"
                             "{ _Out[i] = i; }\n"
                             "[numthreads(THREADS, 1, 1)] void B(uint i : SV_GroupIndex)\n"
                             "{ _Out[i] = i; }\n";
    EXPECT_EQ(CompileKernel(text, {}, 0)->threadGroupSize[0], 16u);
    EXPECT_EQ(CompileKernel(text, {}, 1)->threadGroupSize[0], 2u);
}

TEST(Kernel, HasVariantsByKeywords)
{
    const std::string text = "#pragma kernel K\n#pragma multi_compile _ BIG HUGE_ONE\n"
                             "#pragma multi_compile_local _ TALL\n"
                             "RWStructuredBuffer<uint> _Out;\n"
                             "#if defined(BIG)\n#define X 8\n#elif defined(HUGE_ONE)\n"
                             "#define X 16\n#else\n#define X 4\n#endif\n"
                             "#ifdef TALL\n#define Y 2\n#else\n#define Y 1\n#endif\n"
                             "[numthreads(X, Y, 1)] void K(uint i : SV_GroupIndex)\n"
                             "{ _Out[i] = i; }\n";
    const PassProgram kernel = ParseCompute(text, "t.compute").kernels.at(0);
    const auto sizeWith = [&](std::vector<std::string> local, std::vector<std::string> global)
    {
        return CompileKernel(text, SelectVariant(kernel, local, global))->threadGroupSize;
    };
    using Size = std::array<std::uint32_t, 3>;
    EXPECT_EQ(sizeWith({}, {}), (Size{4, 1, 1}));
    EXPECT_EQ(sizeWith({"BIG"}, {}), (Size{8, 1, 1}));
    EXPECT_EQ(sizeWith({}, {"HUGE_ONE"}), (Size{16, 1, 1}));
    EXPECT_EQ(sizeWith({"TALL"}, {"BIG"}), (Size{8, 2, 1}));
    EXPECT_EQ(sizeWith({}, {"TALL"}), (Size{4, 1, 1})) << "a local keyword is no global one";
}

TEST(Kernel, PacksStructuredBuffersAsDirect3DDoes)
{
    const auto strideOf = [](const std::string& type)
    {
        const auto program =
            CompileKernel(Kernel("struct A { float3 a; float3 b; float c; };\n"
                                 "struct B { float a; float2 b; int3 c[2]; };\n"
                                 "struct C { float4x4 m; float3 v; };\n"
                                 "struct D { float3x4 m; float3x3 n; row_major float2x3 o; };\n"
                                 "struct E { A a[2]; B b; uint c; };\n"
                                 "StructuredBuffer<" +
                                     type + "> _In; RWStructuredBuffer<" + type + "> _Out;",
                                 "_Out[id.x] = _In[id.y];"));
        EXPECT_EQ(ValidationMessages(program->computeSpirv), "") << type;
        EXPECT_EQ(Named(program->layout.storageBuffers, "_In").stride,
                  Named(program->layout.storageBuffers, "_Out").stride);
        return Named(program->layout.storageBuffers, "_In").stride;
    };
    EXPECT_EQ(strideOf("float"), 4u);
    EXPECT_EQ(strideOf("float3"), 12u);
    EXPECT_EQ(strideOf("uint2"), 8u);
    EXPECT_EQ(strideOf("float4x4"), 64u);
    EXPECT_EQ(strideOf("A"), 28u);
    EXPECT_EQ(strideOf("B"), 36u);
    EXPECT_EQ(strideOf("C"), 76u);
    EXPECT_EQ(strideOf("D"), 108u);
    EXPECT_EQ(strideOf("E"), 96u);
}

TEST(Kernel, LeavesConstantBuffersAsTheyAre)
{
    const auto program =
        CompileKernel(Kernel("cbuffer Params { float3 _A; float _B; float3 _C; float3 _D; float "
                             "_E[3]; }; float3 _Loose; int _Number;\n"
                             "RWStructuredBuffer<float3> _Out;",
                             "_Out[0] = _A * _B + _C + _D * _E[_Number] + _Loose;"));
    const UniformBuffer& params = Named(program->layout.buffers, "Params");
    const std::uint32_t offsets[] = {0, 12, 16, 32, 48};
    ASSERT_EQ(params.members.size(), 5u);
    for (std::size_t i = 0; i < 5; ++i)
    {
        EXPECT_EQ(params.members[i].offset, offsets[i]) << params.members[i].name;
    }
    EXPECT_EQ(params.members[4].arrayStride, 16u);
    EXPECT_EQ(Named(program->layout.buffers, "$Global").members.size(), 2u);
}

TEST(Kernel, WritesTexturesOfAnyFormat)
{
    const auto program = CompileKernel(
        Kernel("RWTexture2D<float4> _Four; RWTexture2D<float> _One; RWTexture3D<float2> _Volume;\n"
               "RWTexture2DArray<float3> _Array; RWTexture2D<uint> _Count; RWTexture2D<int2> _Pair;"
               "\nTexture2D<float4> _Source; SamplerState sampler_LinearClamp;",
               "_Four[id.xy] = _Source.SampleLevel(sampler_LinearClamp, 0.5, 0) + _One[id.xy];\n"
               "_One[id.xy] = _Source.Load(int3(id.xy, 0)).x; _Volume[id] = float2(1, 2);\n"
               "_Array[id] = 3; InterlockedAdd(_Count[id.xy], 1); _Pair[id.xy] = int2(id.xy);"));
    EXPECT_EQ(ValidationMessages(program->computeSpirv), "");
    const auto& textures = program->layout.storageTextures;
    EXPECT_EQ(Named(textures, "_Four").dimension, TextureDimension::Tex2D);
    EXPECT_EQ(Named(textures, "_Four").type, UniformType::Float);
    EXPECT_TRUE(Named(textures, "_One").isRead);
    EXPECT_FALSE(Named(textures, "_Four").isRead);
    EXPECT_EQ(Named(textures, "_Volume").dimension, TextureDimension::Tex3D);
    EXPECT_EQ(Named(textures, "_Array").dimension, TextureDimension::Tex2DArray);
    EXPECT_EQ(Named(textures, "_Count").type, UniformType::UInt);
    EXPECT_EQ(Named(textures, "_Pair").type, UniformType::Int);
    EXPECT_EQ(Named(program->layout.textures, "_Source").stages, ShaderStage::Compute);
    const std::string text = Disassemble(program->computeSpirv);
    EXPECT_EQ(text.find("Rgba32f"), std::string::npos);
    EXPECT_NE(text.find("R32ui"), std::string::npos) << "atomic functions ask for it";
}

TEST(Kernel, ReadsAndWritesBuffersOfBytes)
{
    const auto program = CompileKernel(
        Kernel("ByteAddressBuffer _In; RWByteAddressBuffer _Out;",
               "uint old; _Out.Store(8, _In.Load(4)); _Out.InterlockedAdd(0, 1, old);\n"
               "_Out.Store2(16, _In.Load2(16));"));
    EXPECT_EQ(ValidationMessages(program->computeSpirv), "");
    EXPECT_EQ(Named(program->layout.storageBuffers, "_In").stride, 0u);
    EXPECT_FALSE(Named(program->layout.storageBuffers, "_In").isWritten);
    EXPECT_TRUE(Named(program->layout.storageBuffers, "_Out").isWritten);
}

TEST(Kernel, HasACounterBesideWhatItAppendsTo)
{
    const auto program = CompileKernel(
        Kernel("AppendStructuredBuffer<float3> _Found; ConsumeStructuredBuffer<uint> _Given;",
               "_Found.Append(_Given.Consume());"));
    EXPECT_EQ(ValidationMessages(program->computeSpirv), "");
    const auto& buffers = program->layout.storageBuffers;
    EXPECT_EQ(buffers.size(), 4u);
    EXPECT_EQ(Named(buffers, "_Found").stride, 12u);
    EXPECT_TRUE(Named(buffers, "_Found", true).isWritten);
    EXPECT_TRUE(Named(buffers, "_Given", true).isCounter);
}

TEST(Kernel, ConvertsWhatAtomicFunctionsAreGiven)
{
    const auto program =
        CompileKernel(Kernel("RWStructuredBuffer<uint> _U; RWStructuredBuffer<int> _I;\n"
                             "groupshared uint g;",
                             "InterlockedAdd(_U[0], 1); InterlockedMax(_I[0], (int)id.x);\n"
                             "int i = 3; uint old; InterlockedMin(_U[1], i);\n"
                             "InterlockedAdd(g, 1, old); InterlockedCompareExchange(_U[2], 0, 1, "
                             "old);\nInterlockedExchange(_U[3], i, old); _U[4] = old + g;"));
    EXPECT_EQ(ValidationMessages(program->computeSpirv), "");
}

TEST(Kernel, IncludesTheShaderLibrary)
{
    const auto program = CompileKernel(Kernel(
        "#include \"Packages/com.unity.render-pipelines.core/ShaderLibrary/Common.hlsl\"\n"
        "#include \"Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl\"\n"
        "RWTexture2D<half4> _Result;",
        "_Result[id.xy] = half4(Max3(1, 2, 3), _Time.x, 0, 1);"));
    EXPECT_EQ(ValidationMessages(program->computeSpirv), "");
}

TEST(Kernel, ReportsMistakesAtTheirPlace)
{
    const std::string head = "#pragma kernel K SIZE=4\nRWStructuredBuffer<float> _Out;\n"
                             "[numthreads(1, 1, 1)]\nvoid K(uint3 id : SV_DispatchThreadID)\n{\n";
    EXPECT_EQ(KernelErrors(head + "    _Out[0] = missing;\n}\n"),
              (std::vector<std::string>{"t.compute:6:15: error: 'missing': unknown variable"}));
    EXPECT_THAT(KernelErrors(head + "    _Out[0] = SIZE;\n    absent(2);\n}\n"),
                testing::ElementsAre(Mentions("t.compute:7:5: error: 'absent'", "no matching")));
    EXPECT_EQ(
        KernelErrors(head + "#include \"nowhere.hlsl\"\n#include \"either.hlsl\"\n}\n").size(), 2u)
        << "all at once";
}

TEST(Kernel, IsMissedByItsName)
{
    EXPECT_THAT(KernelErrors("#pragma kernel Blurr\n[numthreads(1, 1, 1)] void Blur() {}\n"),
                testing::ElementsAre(Mentions("t.compute:1:1: error: #pragma kernel",
                                              "no function 'Blurr'", "'Blur'")));
}

TEST(Kernel, SaysHowManyThreadsItsGroupsHave)
{
    EXPECT_THAT(KernelErrors("#pragma kernel K\nRWStructuredBuffer<float> _Out;\n"
                             "void K(uint3 id : SV_DispatchThreadID) { _Out[0] = 1; }\n"),
                testing::ElementsAre(Mentions("t.compute:3:6: error: 'K'", "number of threads",
                                              "[numthreads(8, 8, 1)]")));
}

// Direct3D 11, cs_5_0: at most 1024 along x and y, 64 along z, and 1024 in all.
TEST(Kernel, HasGroupsOfAConstantNumberOfThreadsWithinDirect3DsLimits)
{
    const auto text = [](const std::string& threads)
    {
        return "#pragma kernel K\nuint _N;\nstatic const int k_Two = 2;\n"
               "RWStructuredBuffer<float> _Out;\n[numthreads(" +
               threads + ")]\nvoid K(uint3 id : SV_DispatchThreadID) { _Out[_N] = 1; }\n";
    };
    using Size = std::array<std::uint32_t, 3>;
    const std::map<std::string, Size> sizes{{"1024, 1, 1", {1024, 1, 1}},
                                            {"1, 1024, 1", {1, 1024, 1}},
                                            {"4, 4, 64", {4, 4, 64}},
                                            {"k_Two * 8u, (4), 0x2", {16, 4, 2}}};
    for (const auto& [threads, size] : sizes)
    {
        EXPECT_EQ(CompileKernel(text(threads))->threadGroupSize, size) << threads;
    }
    for (const char* threads : {"_N, 1, 1", "- 1, 1, 1", "0, 1, 1", "1, 1, 0", "1025, 1, 1",
                                "1, 1025, 1", "1, 1, 65", "64, 32, 1", "8, 8", "8, 8, 1, 1"})
    {
        EXPECT_THAT(KernelErrors(text(threads)),
                    testing::ElementsAre(Mentions("t.compute:6:6: error: 'K'",
                                                  "[numthreads(" + std::string(threads) + ")]",
                                                  "1 to 1024", "1 to 64", "1024")));
    }
}

// It shows only where the generated entry function calls the kernel.
TEST(Kernel, CannotTakeASystemValueInAnArray)
{
    const std::vector<std::string> errors =
        KernelErrors("RWStructuredBuffer<float> _Out;\n  #pragma kernel K\n[numthreads(1, 1, 1)] "
                     "void K(uint3 id[2] : SV_DispatchThreadID) { _Out[0] = 1; }\n");
    EXPECT_THAT(errors,
                testing::ElementsAre(Mentions("t.compute:2:3: error: K", "cannot be called")));
}

TEST(Kernel, HasNoObjectOfItsOwn)
{
    const std::vector<std::string> errors = KernelErrors(Kernel(
        "#include \"Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl\"\n"
        "RWStructuredBuffer<float4> _Out;",
        "_Out[0] = mul(unity_ObjectToWorld, float4(0, 0, 0, 1));"));
    EXPECT_THAT(errors,
                testing::ElementsAre(Mentions("'K'", "belongs to a draw", "unity_ObjectToWorld")));
}

TEST(Kernel, IsRefusedInAPassOfAShader)
{
    ShaderCompiler compiler;
    PassProgram program = Program("#pragma kernel K\n");
    program.pragmas = {{{1, 1}, "kernel", "K"}};
    EXPECT_THROW(compiler.Compile(program), UnsupportedProgramError);
}

TEST(Kernel, IsRefusedInASentenceWhereTheDeviceHasNone)
{
    ShaderCompilerOptions options;
    options.missingFeatures = {"compute"};
    ShaderCompiler compiler(options);
    try
    {
        compiler.Compile(ParseCompute(k_Sum, "t.compute").kernels.at(0));
        FAIL();
    }
    catch (const UnsupportedProgramError& error)
    {
        EXPECT_THAT(ToString(error.diagnostics().at(0)),
                    Mentions("t.compute:1:1: error: program", "'compute'", "device"));
    }
}

TEST(Kernel, IsJudgedByTheWaveOperationsOfKernelsAndNotOfFragmentFunctions)
{
    const std::string text = std::string("#pragma require WaveBasic\n") + k_Sum;
    const PassProgram kernel = ParseCompute(text, "t.compute").kernels.at(0);
    ShaderCompilerOptions options;
    options.missingFeatures = {"wavebasic"};
    EXPECT_NO_THROW(ShaderCompiler(options).Compile(kernel));
    options.missingFeatures = {"compute wavebasic"};
    EXPECT_THROW(ShaderCompiler(options).Compile(kernel), UnsupportedProgramError);
}

TEST(Kernel, IsFoundAgainInTheCache)
{
    const TemporaryFolder folder;
    ShaderCompilerOptions options;
    options.cacheFolder = folder.path();
    const PassProgram kernel = ParseCompute(k_Sum, "t.compute").kernels.at(0);
    ShaderCompiler first(options);
    const auto compiled = first.Compile(kernel);
    ShaderCompiler second(options);
    EXPECT_EQ(*second.Compile(kernel), *compiled);
    EXPECT_EQ(second.statistics().loadedFromCache, 1);
}

TEST(Kernel, CompilesInAProcessOfItsOwn)
{
    ShaderCompilerOptions options;
    options.process = std::make_shared<WorkerProcess>();
    ShaderCompiler isolated(options);
    const PassProgram kernel = ParseCompute(k_Sum, "t.compute").kernels.at(0);
    EXPECT_EQ(*isolated.Compile(kernel), *CompileKernel(k_Sum));
}

} // namespace limn::test
