#include "port/Differs.h"
#include "port/HeaderWords.h"
#include "port/PortingTable.h"

#include <gtest/gtest.h>
#include <iostream>
#include <limn/core/BuiltinShaders.h>
#include <limn/core/RenderTexturePool.h>
#include <set>

namespace limn::test
{

const std::shared_ptr<ShaderCompiler>& DiffersCompiler()
{
    static const auto compiler = std::make_shared<ShaderCompiler>();
    return compiler;
}

std::shared_ptr<const Shader> DiffersShader()
{
    static const std::shared_ptr<const Shader> shader = Shader::FromText(
        "Shader \"Test/Differs\" {\n"
        "Properties { _Width(\"Width\", Float) = 2  _Color(\"\", Color) = (1, 0, 0, 1)\n"
        "_MainTex(\"\", 2D) = \"white\" {} }\n"
        "SubShader { Tags { \"Queue\" = \"Transparent\" } Pass { Name \"One\"\n"
        "HLSLPROGRAM\n"
        "#pragma vertex vert\n"
        "#pragma fragment frag\n"
        "#pragma multi_compile _ WET\n"
        "float _Width;\n"
        "float4 vert(float4 p : POSITION) : SV_Position { return p; }\n"
        "float4 frag() : SV_Target { return _Width; }\n"
        "ENDHLSL } } }",
        "Differs.shader", DiffersCompiler());
    return shader;
}

RecordedFrame::RecordedFrame(const std::function<void(CommandBuffer&)>& record,
                             const std::function<void()>& beforeExecute)
    : color(RTHandles::Alloc(RenderTextureDescriptor(8, 4, GraphicsFormat::R8G8B8A8_UNorm))),
      depth(RTHandles::Alloc(RenderTextureDescriptor(8, 4, GraphicsFormat::None, 32)))
{
    RenderTexturePool pool;
    ScriptableRenderContext context(report);
    context.BeginCamera({color, depth, &pool,
                         std::make_shared<const Material>(
                             FindBuiltinShader("Hidden/Universal/CoreBlit", DiffersCompiler()))});
    CommandBuffer cmd;
    record(cmd);
    if (beforeExecute)
    {
        beforeExecute();
    }
    context.ExecuteCommandBuffer(cmd);
    commands = context.TakeCommands();
}

std::vector<DrawCommand> RecordedFrame::draws() const
{
    return Of<DrawCommand>();
}

namespace
{

DiffersChecks AllDiffers()
{
    DiffersChecks all;
    for (const DiffersChecks& checks :
         {CommandDiffers(), MaterialDiffers(), ShaderDiffers(), TargetDiffers(), CameraDiffers(),
          GraphDiffers(), PipelineDiffers()})
    {
        all.insert(all.end(), checks.begin(), checks.end());
    }
    return all;
}

/// "`Material.name`, …" of a generated table: what stands below "### Type, Version".
std::set<std::string> CoveredMembersThatDiffer()
{
    std::istringstream lines(ReadText(SourcePath("samples/porting/COVERAGE.md")));
    std::set<std::string> keys;
    std::string type;
    for (std::string line; std::getline(lines, line);)
    {
        if (line.starts_with("### "))
        {
            type = line.substr(4, line.find(',') - 4);
        }
        const std::size_t end = line.find("` | differs | ");
        if (line.starts_with("| `") && end != std::string::npos)
        {
            keys.insert(type + "." + line.substr(3, end - 3));
        }
    }
    return keys;
}

} // namespace

TEST(Differs, AsThePortingTableSays)
{
    for (const DiffersCheck& check : AllDiffers())
    {
        SCOPED_TRACE(check.keys.front());
        try
        {
            check.check();
        }
        catch (const std::exception& error)
        {
            ADD_FAILURE() << error.what();
        }
    }
}

TEST(Differs, IsTheVerdictOfWhatIsChecked)
{
    std::set<std::string> seen;
    for (const DiffersCheck& check : AllDiffers())
    {
        for (const std::string& key : check.keys)
        {
            EXPECT_TRUE(seen.insert(key).second) << key << " is checked twice";
            const std::size_t dot = key.rfind('.');
            const PortEntry* entry =
                UnityPortingTable().Find(key.substr(0, dot), key.substr(dot + 1));
            ASSERT_NE(entry, nullptr) << key;
            EXPECT_EQ(entry->verdict, PortVerdict::Differs) << key;
        }
    }
}

// Who adds a member that differs adds a check, or says here why there is none.
TEST(Differs, IsCheckedOfAllMembersButThese)
{
    const std::set<std::string> notHere{
        "GraphicsBuffer.CopyCount", // on a device, by BufferGpu
        "GraphicsBuffer.GetData",
        "AsyncGPUReadback.Request", // on a device, by AsyncReadback
        "AsyncGPUReadbackRequest.GetData",
        "AsyncGPUReadbackRequest.done",
        "AsyncGPUReadbackRequest.hasError",
        "AsyncGPUReadbackRequest.width",
        "AsyncGPUReadbackRequest.height",
        "AsyncGPUReadbackRequest.layerDataSize",
        "ScriptableRenderContext.Submit", // a port leaves these out: there is nothing to call
        "ScriptableRenderContext.StartMultiEye",
        "ScriptableRenderContext.StopMultiEye",
        "SystemInfo.graphicsUVStartsAtTop",
        "SystemInfo.copyTextureSupport", // there is one device, and no call
        "SystemInfo.graphicsDeviceType",
        "SystemInfo.usesReversedZBuffer", // of cameraData, by RenderingData and its tests
        "SystemInfo.supports2DArrayTextures",
        "SystemInfo.supports3DTextures",
        "SystemInfo.supportsComputeShaders",
        "SystemInfo.supportsIndirectArgumentsBuffer",
        "SystemInfo.supportsInstancing",
        "SystemInfo.supportsShadows",
    };
    std::set<std::string> unchecked = CoveredMembersThatDiffer();
    const std::size_t all = unchecked.size();
    ASSERT_GT(all, 200u);
    for (const DiffersCheck& check : AllDiffers())
    {
        for (const std::string& key : check.keys)
        {
            unchecked.erase(key);
        }
    }
    std::cout << "of " << all << " members that differ, " << all - unchecked.size()
              << " are checked; not:";
    for (const std::string& key : unchecked)
    {
        std::cout << " " << key;
    }
    std::cout << "\n";
    RecordProperty("unchecked", static_cast<int>(unchecked.size()));
    EXPECT_EQ(unchecked, notHere);
}

} // namespace limn::test
