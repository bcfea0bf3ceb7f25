#include "port/Differs.h"

#include <cstring>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limn::test
{

namespace
{

using testing::SizeIs;

/// The _Width that a draw of this frame finds; `record` comes before it.
float WidthOfADraw(const std::function<void(CommandBuffer&)>& record,
                   const std::function<void()>& beforeExecute)
{
    // Without _Width in its Properties a global is what it finds.
    static const auto material = std::make_shared<const Material>(
        Shader::FromText("Shader \"Test/Global\" { SubShader { Pass {\n"
                         "HLSLPROGRAM\n"
                         "#pragma vertex vert\n"
                         "#pragma fragment frag\n"
                         "cbuffer Own { float _DiffersWidth; };\n"
                         "float4 vert(float4 p : POSITION) : SV_Position { return p; }\n"
                         "float4 frag() : SV_Target { return _DiffersWidth; }\n"
                         "ENDHLSL } } }",
                         "Global.shader", DiffersCompiler()));
    const RecordedFrame frame(
        [&](CommandBuffer& cmd)
        {
            cmd.SetRenderTarget(BuiltinRenderTextureType::CameraTarget);
            record(cmd);
            cmd.DrawProcedural(glm::mat4(1.0f), material, 0, 3);
        },
        beforeExecute);
    const DrawSetup& setup = frame.commands.Setup(frame.draws().at(0));
    for (const UniformBuffer& buffer : setup.program->layout.buffers)
    {
        for (const UniformMember& member : buffer.members)
        {
            for (const UniformSlice& slice : setup.bindings->uniforms)
            {
                if (member.name == "_DiffersWidth" && slice.binding == buffer.binding)
                {
                    float value = 0.0f;
                    std::memcpy(&value,
                                frame.commands.uniformData.data() + slice.offset + member.offset,
                                sizeof(value));
                    return value;
                }
            }
        }
    }
    ADD_FAILURE() << "no _DiffersWidth";
    return 0.0f;
}

void ExpectGlobalsToReachWhatIsExecutedAfterThem()
{
    const auto nothing = [](CommandBuffer&) {
    };
    const auto set = []
    {
        Shader::SetGlobalFloat("_DiffersWidth", 5.0f);
    };
    EXPECT_EQ(WidthOfADraw(nothing, set), 5.0f) << "set behind the recording";
    EXPECT_EQ(WidthOfADraw(nothing, {}), 5.0f) << "and still in the next frame";
    EXPECT_EQ(
        WidthOfADraw([](CommandBuffer& cmd) { cmd.SetGlobalFloat("_DiffersWidth", 6.0f); }, set),
        6.0f)
        << "a command buffer's wins";
    Shader::SetGlobalInt("_DiffersWidth", 7);
    EXPECT_EQ(Shader::GetGlobalInt("_DiffersWidth"), 7);
    Shader::SetGlobalInteger("_DiffersWidth", 8);
    EXPECT_EQ(Shader::GetGlobalInteger("_DiffersWidth"), 8);
    Shader::SetGlobalVector("_DiffersVector", glm::vec4(1, 2, 3, 4));
    EXPECT_EQ(Shader::GetGlobalVector("_DiffersVector"), glm::vec4(1, 2, 3, 4));
    Shader::SetGlobalColor("_DiffersColor", Color{0.5f, 0, 0, 1});
    EXPECT_EQ(Shader::GetGlobalColor("_DiffersColor"), (Color{0.5f, 0, 0, 1}));
    Shader::SetGlobalMatrix("_DiffersMatrix", glm::mat4(3.0f));
    EXPECT_EQ(Shader::GetGlobalMatrix("_DiffersMatrix"), glm::mat4(3.0f));
    Shader::SetGlobalFloatArray("_DiffersFloats", {1, 2});
    EXPECT_THAT(Shader::GetGlobalFloatArray("_DiffersFloats"), SizeIs(2));
    Shader::SetGlobalVectorArray("_DiffersVectors", {glm::vec4(1)});
    EXPECT_THAT(Shader::GetGlobalVectorArray("_DiffersVectors"), SizeIs(1));
    Shader::SetGlobalMatrixArray("_DiffersMatrices", {glm::mat4(1.0f)});
    EXPECT_THAT(Shader::GetGlobalMatrixArray("_DiffersMatrices"), SizeIs(1));
    Shader::SetGlobalTexture("_DiffersTexture", DefaultTexture("red"));
    EXPECT_EQ(Shader::GetGlobalTexture("_DiffersTexture"), DefaultTexture("red"));
}

void ExpectFunctionsOfAShader()
{
    const Shader& shader = *DiffersShader();
    EXPECT_EQ(shader.name(), "Test/Differs");
    EXPECT_EQ(shader.passCount(), 1);
    EXPECT_EQ(shader.renderQueue(), 3000);
    EXPECT_TRUE(shader.isSupported());
    const auto broken = Shader::FromText("Shader \"B\" { SubShader { Pass {\n"
                                         "HLSLPROGRAM\n"
                                         "#pragma vertex vert\n"
                                         "#pragma fragment frag\n"
                                         "float4 vert() : SV_Position { return nowhere; }\n"
                                         "float4 frag() : SV_Target { return 1; }\n"
                                         "ENDHLSL } } }",
                                         "B.shader", DiffersCompiler());
    EXPECT_TRUE(broken->isSupported()) << "it is found out when it is drawn";
    EXPECT_THROW(broken->Compile(0), AssetError);
}

void ExpectTheDocumentToHaveAllOfTheFile()
{
    const auto shader =
        Shader::FromText("Shader \"D\" {\n"
                         "Properties { [Header(Lines)] _Gap(\"Gap\", Range(1, 8)) = 3\n"
                         "_Steps(\"\", Integer) = 4  _Dir(\"\", Vector) = (1, 2, 3, 4)  _Map(\"\", "
                         "3D) = \"bump\" {} }\n"
                         "SubShader { Tags { \"RenderType\" = \"Opaque\" } LOD 200\n"
                         "Pass { Tags { \"LightMode\" = \"Outline\" } } }\n"
                         "SubShader { Pass { } Pass { } }\n"
                         "Dependency \"BaseMap\" = \"Other\" }",
                         "D.shader", DiffersCompiler());
    const ShaderLabDocument& document = shader->document();
    ASSERT_EQ(document.properties.size(), 4u);
    const ShaderProperty& gap = document.properties[0];
    EXPECT_EQ(gap.name, "_Gap");
    EXPECT_EQ(ShaderPropertyId(gap.name), Shader::PropertyToID("_Gap"));
    EXPECT_EQ(gap.displayName, "Gap");
    EXPECT_EQ(gap.type, ShaderPropertyType::Range);
    EXPECT_EQ(gap.rangeMin, 1.0f);
    EXPECT_EQ(gap.rangeMax, 8.0f);
    EXPECT_EQ(gap.defaultValue[0], 3.0f);
    EXPECT_TRUE(gap.HasAttribute("Header"));
    EXPECT_FALSE(gap.HasAttribute("HideInInspector"));
    EXPECT_EQ(document.properties[1].defaultValue[0], 4.0f);
    EXPECT_EQ(document.properties[2].defaultValue[3], 4.0f);
    EXPECT_EQ(document.properties[3].defaultTexture, "bump");
    EXPECT_EQ(document.properties[3].dimension, TextureDimension::Tex3D);
    ASSERT_EQ(document.subShaders.size(), 2u);
    EXPECT_EQ(document.subShaders[1].passes.size(), 2u);
    EXPECT_EQ(document.subShaders[0].lod, 200);
    EXPECT_EQ(*document.subShaders[0].tags.Find("RenderType"), "Opaque");
    EXPECT_EQ(document.subShaders[0].passes[0].lightMode(), "Outline");
    ASSERT_EQ(document.dependencies.size(), 1u);
    EXPECT_EQ(document.dependencies[0].name, "BaseMap");
}

void ExpectAKernelToReadAGlobalOnceItIsGiven()
{
    const auto compute = ComputeShader::FromText("#pragma kernel Fill\n"
                                                 "Texture2D _In; RWTexture2D<float4> _Out;\n"
                                                 "[numthreads(1, 1, 1)]\n"
                                                 "void Fill(uint3 id : SV_DispatchThreadID)\n"
                                                 "{ _Out[id.xy] = _In[id.xy]; }",
                                                 "Fill.compute", DiffersCompiler());
    RenderTextureDescriptor descriptor(8, 4, GraphicsFormat::R8G8B8A8_UNorm);
    descriptor.enableRandomWrite = true;
    Shader::SetGlobalTexture("_DiffersGlobal", DefaultTexture("blue"));
    compute->SetTexture(0, "_In", Shader::GetGlobalTexture("_DiffersGlobal"));
    compute->SetTexture(0, "_Out", RTHandles::Alloc(descriptor));
    const RecordedFrame frame([&](CommandBuffer& cmd)
                              { cmd.DispatchCompute(compute, 0, 8, 4, 1); });
    const auto dispatches = frame.Of<DispatchCommand>();
    ASSERT_EQ(dispatches.size(), 1u);
    const auto& textures = frame.commands.Setup(dispatches[0]).bindings->textures;
    ASSERT_EQ(textures.size(), 1u);
    EXPECT_EQ(textures[0].texture, DefaultTexture("blue"));
}

void ExpectShadersOfTheScopesSource()
{
    const auto none = Shader::Find("Hidden/ScreenSpaceOutline"); // outside of all features' code
    EXPECT_EQ(none, nullptr);
    const ShaderSourceScope scope(
        std::make_shared<ShaderSource>(&ShippedShaders, DiffersCompiler()));
    const auto found = Shader::Find("Hidden/ScreenSpaceOutline");
    ASSERT_NE(found, nullptr);
    EXPECT_EQ(found, Shader::Find("Hidden/ScreenSpaceOutline"));
    EXPECT_EQ(Shader::Find("No/Such"), nullptr);
    EXPECT_NE(Shader::Find("Hidden/ScreenSpaceOutline", ShippedShaders(), DiffersCompiler()),
              nullptr);
    EXPECT_EQ(Shader::Find("No/Such", ShippedShaders(), DiffersCompiler()), nullptr);
}

void ExpectKeywordsByFunctions()
{
    EXPECT_EQ(GlobalKeyword::Create("WET").name(), "WET");
    const auto compute = ComputeShader::FromText("#pragma kernel Fill\n"
                                                 "[numthreads(1, 1, 1)] void Fill() {}",
                                                 "Fill.compute", DiffersCompiler());
    compute->EnableKeyword("WET");
    EXPECT_EQ(compute->shaderKeywords(), std::vector<std::string>{"WET"});
}

void ExpectNamesOfATypeOfTheirOwn()
{
    static_assert(std::is_same_v<decltype(Shader::PropertyToID("_X")), ShaderPropertyId>);
    EXPECT_EQ(Shader::PropertyToID("_X"), ShaderPropertyId("_X"));
    Material material(DiffersShader());
    material.SetFloat("_Width", 3.0f); // and a string does
    EXPECT_EQ(material.GetFloat(Shader::PropertyToID("_Width")), 3.0f);
}

} // namespace

DiffersChecks ShaderDiffers()
{
    return {
        {Members("Shader", {"SetGlobalFloat", "SetGlobalInt", "SetGlobalInteger", "SetGlobalVector",
                            "SetGlobalColor", "SetGlobalMatrix", "SetGlobalTexture",
                            "SetGlobalFloatArray", "SetGlobalVectorArray", "SetGlobalMatrixArray"}),
         ExpectGlobalsToReachWhatIsExecutedAfterThem},
        {Members("Shader", {"name", "passCount", "renderQueue", "isSupported"}),
         ExpectFunctionsOfAShader},
        {Members("Shader",
                 {"maximumLOD", "subshaderCount", "FindPassTagValue", "FindSubshaderTagValue",
                  "GetDependency", "GetPassCountInSubshader", "GetPropertyAttributes",
                  "GetPropertyCount", "GetPropertyDefaultFloatValue", "GetPropertyDefaultIntValue",
                  "GetPropertyDefaultVectorValue", "GetPropertyDescription", "GetPropertyFlags",
                  "GetPropertyName", "GetPropertyNameId", "GetPropertyRangeLimits",
                  "GetPropertyTextureDefaultName", "GetPropertyTextureDimension",
                  "GetPropertyType"}),
         ExpectTheDocumentToHaveAllOfTheFile},
        {{"GlobalKeyword.name", "ComputeShader.shaderKeywords"}, ExpectKeywordsByFunctions},
        {{"ComputeShader.SetTextureFromGlobal"}, ExpectAKernelToReadAGlobalOnceItIsGiven},
        {{"Shader.Find"}, ExpectShadersOfTheScopesSource},
        {{"Shader.PropertyToID"}, ExpectNamesOfATypeOfTheirOwn}};
}

} // namespace limn::test
