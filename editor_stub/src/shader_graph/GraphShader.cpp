#include "shader_graph/GraphShader.h"

#include "console/Texts.h"
#include "shader_graph/GraphProperties.h"
#include "shader_graph/GraphTarget.h"
#include "unity/UnityProject.h"

#include <limn/base/Case.h>
#include <limn/base/Diagnostic.h>

namespace limn
{

namespace
{

constexpr const char* k_Universal = "Packages/com.unity.render-pipelines.universal/";
constexpr const char* k_Includes =
    "Packages/com.unity.render-pipelines.universal/Editor/ShaderGraph/Includes/";
constexpr const char* k_SpriteIncludes =
    "Packages/com.unity.render-pipelines.universal/Editor/2D/ShaderGraph/Includes/";
constexpr const char* k_ScreenIncludes =
    "Packages/com.unity.shadergraph/Editor/Generation/Targets/Fullscreen/Includes/";

/// A value that a pass takes from a graph.
struct SurfaceField
{
    const char* name;
    const char* type;
    const char* otherwise; ///< where the graph has no such block
};

const std::vector<SurfaceField> k_CutFields{{"Alpha", "float", "1.0"},
                                            {"AlphaClipThreshold", "float", "0.5"}};
const std::vector<SurfaceField> k_PlainFields{{"BaseColor", "float3", "float3(0.5, 0.5, 0.5)"},
                                              {"Alpha", "float", "1.0"},
                                              {"AlphaClipThreshold", "float", "0.5"}};
const std::vector<SurfaceField> k_LitFields{{"BaseColor", "float3", "float3(0.5, 0.5, 0.5)"},
                                            {"Alpha", "float", "1.0"},
                                            {"AlphaClipThreshold", "float", "0.5"},
                                            {"Emission", "float3", "float3(0, 0, 0)"},
                                            {"Metallic", "float", "0.0"},
                                            {"Specular", "float3", "float3(0.5, 0.5, 0.5)"},
                                            {"Smoothness", "float", "0.5"},
                                            {"Occlusion", "float", "1.0"},
                                            {"CoatMask", "float", "0.0"},
                                            {"CoatSmoothness", "float", "1.0"}};
const std::vector<SurfaceField> k_ScreenFields{{"BaseColor", "float3", "float3(0.5, 0.5, 0.5)"},
                                               {"Alpha", "float", "1.0"},
                                               {"FullscreenEyeDepth", "float", "0.0"},
                                               {"FullscreenLinear01Depth", "float", "0.0"},
                                               {"FullscreenRawDepth", "float", "0.0"}};

/// A pass of a kind of graph.
struct GraphPass
{
    std::string name;
    std::string lightMode; ///< "" for none
    std::string kind;      ///< the end of SHADERPASS_...
    std::string include;   ///< the file of its entry points
    std::vector<SurfaceField> fields;
    std::vector<std::string> varyings{}; ///< those that the entry points take
    std::string state{};                 ///< in place of what the graph sets; without the cull mode
    std::string lines{};                 ///< the first of its program
    bool takesNormal = false;
};

/// A value between the vertex and the pixel, or of a vertex.
struct StageMember
{
    const char* name;
    const char* type;
    const char* macro; ///< the end of VARYINGS_NEED_... or ATTRIBUTES_NEED_..., or ""
    const char* from;  ///< the attribute that a varying comes from, or an attribute's semantic
};
constexpr StageMember k_Varyings[] = {
    {"positionWS", "float3", "POSITION_WS", ""},
    {"normalWS", "float3", "NORMAL_WS", "normalOS"},
    {"tangentWS", "float4", "TANGENT_WS", "tangentOS"},
    {"texCoord0", "float4", "TEXCOORD0", "uv0"},
    {"texCoord1", "float4", "TEXCOORD1", "uv1"},
    {"texCoord2", "float4", "TEXCOORD2", "uv2"},
    {"texCoord3", "float4", "TEXCOORD3", "uv3"},
    {"color", "float4", "COLOR", "color"},
    {"sh", "float3", "", "normalOS"},
    {"fogFactorAndVertexLight", "float4", "FOG_AND_VERTEX_LIGHT", "normalOS"}};
constexpr StageMember k_Attributes[] = {
    {"normalOS", "float3", "NORMAL", "NORMAL"},  {"tangentOS", "float4", "TANGENT", "TANGENT"},
    {"uv0", "float4", "TEXCOORD0", "TEXCOORD0"}, {"uv1", "float4", "TEXCOORD1", "TEXCOORD1"},
    {"uv2", "float4", "TEXCOORD2", "TEXCOORD2"}, {"uv3", "float4", "TEXCOORD3", "TEXCOORD3"},
    {"color", "float4", "COLOR", "COLOR"}};

std::string Include(const std::string& path)
{
    return GraphLine("#include \"" + path + "\"");
}

std::string Structure(const std::string& name, const std::string& members)
{
    return "        struct " + name + "\n        {\n" + members + "        };\n";
}

std::vector<GraphPass> PassesOf(const GraphTarget& target)
{
    if (target.IsScreen())
    {
        return {{"DrawProcedural", "", "",
                 std::string(k_ScreenIncludes) + "FullscreenDrawProcedural.hlsl", k_ScreenFields},
                {"Blit", "", "", std::string(k_ScreenIncludes) + "FullscreenBlit.hlsl",
                 k_ScreenFields}};
    }
    if (target.IsSprite())
    {
        return {{"Sprite Forward",
                 "UniversalForward",
                 "SPRITEFORWARD",
                 std::string(k_SpriteIncludes) + "SpriteForwardPass.hlsl",
                 k_PlainFields,
                 {"positionWS", "texCoord0", "color"}}};
    }
    const std::string folder = k_Includes;
    std::vector<GraphPass> passes;
    if (target.IsLit())
    {
        passes.push_back({"Universal Forward",
                          "UniversalForward",
                          "FORWARD",
                          folder + "PBRForwardPass.hlsl",
                          k_LitFields,
                          {"positionWS", "normalWS", "sh", "fogFactorAndVertexLight"},
                          "",
                          GraphLine("#include_with_pragmas \"limn/LightVariants.hlsl\""),
                          true});
    }
    else
    {
        passes.push_back({"Universal Forward",
                          "",
                          "UNLIT",
                          folder + "UnlitPass.hlsl",
                          k_PlainFields,
                          {"positionWS"},
                          "",
                          GraphLine("#pragma multi_compile_fog"),
                          false});
    }
    const std::string depthState = GraphLine("ZTest LEqual") + GraphLine("ZWrite On");
    if (target.CastsShadows())
    {
        passes.push_back(
            {"ShadowCaster",
             "ShadowCaster",
             "SHADOWCASTER",
             folder + "ShadowCasterPass.hlsl",
             k_CutFields,
             {"normalWS"},
             depthState + GraphLine("ColorMask 0"),
             GraphLine("#pragma multi_compile_vertex _ _CASTING_PUNCTUAL_LIGHT_SHADOW"),
             false});
    }
    if (target.WritesDepth() || target.IsOverridden())
    {
        const std::string normals = target.IsLit() ? "DepthNormals" : "DepthNormalsOnly";
        passes.push_back({"DepthOnly",
                          "DepthOnly",
                          "DEPTHONLY",
                          folder + "DepthOnlyPass.hlsl",
                          k_CutFields,
                          {},
                          depthState + GraphLine("ColorMask R"),
                          "",
                          false});
        passes.push_back({normals,
                          normals,
                          "DEPTHNORMALSONLY",
                          folder + "DepthNormalsOnlyPass.hlsl",
                          k_CutFields,
                          {"normalWS"},
                          depthState,
                          "",
                          true});
    }
    return passes;
}

/// Returns the members of `input` that the values of a stage's inputs name.
std::set<std::string> MembersIn(const GraphCode& code, GraphStage stage)
{
    std::set<std::string> members;
    for (const std::string& input : code.inputs())
    {
        const std::optional<StageInput> found = FindStageInput(input, stage);
        const std::string text = found ? found->text : "";
        for (std::size_t at = text.find("input."); at != std::string::npos;
             at = text.find("input.", at + 1))
        {
            members.insert(GraphWordAt(text, at + 6));
        }
    }
    return members;
}

/// Returns the structure of what a stage's code asks for, and the function that fills it.
std::string InputsText(const std::string& name, const std::string& from, const GraphCode& code,
                       GraphStage stage)
{
    std::string members;
    std::string filled;
    for (const std::string& input : code.inputs())
    {
        if (const std::optional<StageInput> found = FindStageInput(input, stage))
        {
            members += GraphLine(found->type + " " + input + ";");
            filled += GraphLine("output." + input + " = " +
                                Replaced(found->text, "IN.", "output.") + ";");
        }
    }
    return Structure(name, members.empty() ? GraphLine("float nothing;") : members) + "        " +
           name + " Build" + name + "(" + from + " input)\n        {\n" +
           GraphLine(name + " output = (" + name + ")0;") + filled + GraphLine("return output;") +
           "        }\n";
}

/// Writes the ShaderLab of a graph.
class GraphWriter
{
public:
    GraphWriter(const std::filesystem::path& path, const GraphFiles& files)
        : m_File(path), m_Target(m_File), m_Around{files}
    {
    }

    TranslatedGraph Write();

private:
    /// The code of a pass, and what it needs.
    struct PassCode
    {
        std::string text;
        std::set<std::string> varyings;
        std::set<std::string> attributes;
        std::string defines;
    };

    void ReadBlocks();
    /// Returns the block of this name, or null if the graph has none.
    const GraphNode* FindBlock(const std::string& name) const;
    bool IsConnected(const std::string& block) const;
    /// Returns the end of the block's name that bends normals: TS, OS, WS, or "" for none.
    std::string NormalSpace() const;
    std::string PassText(const GraphPass& pass);
    PassCode CodeOf(const GraphPass& pass);
    void AddSurface(const GraphPass& pass, PassCode& code);
    void AddVertex(PassCode& code);
    std::string StructuresText(const GraphPass& pass, PassCode& code) const;
    std::string FunctionsText() const;
    void RequireNoProblems() const;

    GraphFile m_File;
    GraphTarget m_Target;
    GraphSurroundings m_Around;
    std::map<std::string, const GraphNode*> m_Blocks; ///< by "SurfaceDescription.BaseColor"
};

void GraphWriter::ReadBlocks()
{
    for (const char* context : {"m_VertexContext", "m_FragmentContext"})
    {
        for (const Json& reference : PartOf(PartOf(m_File.graph(), context), "m_Blocks"))
        {
            const GraphNode* block = m_File.FindNode(reference);
            if (block != nullptr && !block->slots.empty())
            {
                m_Blocks[TextIn(*block->fields, "m_SerializedDescriptor")] = block;
            }
        }
    }
}

const GraphNode* GraphWriter::FindBlock(const std::string& name) const
{
    const auto found = m_Blocks.find(name);
    return found == m_Blocks.end() ? nullptr : found->second;
}

bool GraphWriter::IsConnected(const std::string& block) const
{
    const GraphNode* node = FindBlock(block);
    return node != nullptr && m_File.SourceOf(*node, node->slots.front().id);
}

std::string GraphWriter::NormalSpace() const
{
    for (const char* space : {"TS", "OS", "WS"})
    {
        if (IsConnected(std::string("SurfaceDescription.Normal") + space))
        {
            return space;
        }
    }
    return "";
}

/// Adds the function that computes a pass's surface, with the structures around it.
void GraphWriter::AddSurface(const GraphPass& pass, PassCode& code)
{
    const GraphStage stage = m_Target.IsScreen() ? GraphStage::Screen : GraphStage::Fragment;
    GraphCode surface(m_File, stage, m_Around);
    std::vector<SurfaceField> fields = pass.fields;
    const std::string space = pass.takesNormal ? NormalSpace() : "";
    const std::string normal = "Normal" + space;
    if (!space.empty())
    {
        fields.push_back({normal.c_str(), "float3", ""});
        code.defines += GraphLine("#define _NORMALMAP 1") +
                        GraphLine("#define _NORMAL_DROPOFF_" + space + " 1");
        code.varyings.insert(space == "TS" ? "tangentWS" : "normalWS");
    }
    std::string members;
    std::string results;
    for (const SurfaceField& field : fields)
    {
        const GraphNode* block = FindBlock(std::string("SurfaceDescription.") + field.name);
        const std::string value =
            block != nullptr
                ? ConvertGraphValue(surface.InputOf(*block, block->slots.front()), field.type)
                : field.otherwise;
        members += GraphLine(std::string(field.type) + " " + field.name + ";");
        results += GraphLine(std::string("surface.") + field.name + " = " + value + ";");
    }
    code.varyings.merge(MembersIn(surface, stage));
    code.text += InputsText("SurfaceDescriptionInputs", "Varyings", surface, stage) +
                 Structure("SurfaceDescription", members) +
                 "        SurfaceDescription SurfaceDescriptionFunction(SurfaceDescriptionInputs "
                 "IN)\n        {\n" +
                 surface.body() + GraphLine("SurfaceDescription surface;") + results +
                 GraphLine("return surface;") + "        }\n";
}

/// Adds the function that moves a vertex, with the structures around it, if the graph does.
void GraphWriter::AddVertex(PassCode& code)
{
    const std::pair<const char*, const char*> fields[] = {
        {"Position", "positionOS"}, {"Normal", "normalOS"}, {"Tangent", "tangentOS"}};
    if (std::ranges::none_of(
            fields, [&](const auto& field)
            { return IsConnected("VertexDescription." + std::string(field.first)); }))
    {
        return;
    }
    GraphCode vertex(m_File, GraphStage::Vertex, m_Around);
    std::string members;
    std::string results;
    for (const auto& [name, attribute] : fields)
    {
        const GraphNode* block = FindBlock(std::string("VertexDescription.") + name);
        const bool isNeeded = attribute == fields[0].second || code.attributes.contains(attribute);
        const std::string value = isNeeded && block != nullptr
                                      ? vertex.InputOf(*block, block->slots.front()).text
                                      : "float3(0, 0, 0)";
        members += GraphLine(std::string("float3 ") + name + ";");
        results += GraphLine(std::string("vertex.") + name + " = " + value + ";");
    }
    code.attributes.merge(MembersIn(vertex, GraphStage::Vertex));
    code.defines += GraphLine("#define FEATURES_GRAPH_VERTEX");
    code.text += InputsText("VertexDescriptionInputs", "Attributes", vertex, GraphStage::Vertex) +
                 Structure("VertexDescription", members) +
                 "        VertexDescription VertexDescriptionFunction(VertexDescriptionInputs "
                 "IN)\n        {\n" +
                 vertex.body() + GraphLine("VertexDescription vertex;") + results +
                 GraphLine("return vertex;") + "        }\n";
}

/// Returns what a vertex and a pixel have, and adds the macros that tell it.
std::string GraphWriter::StructuresText(const GraphPass& pass, PassCode& code) const
{
    std::string attributes = GraphLine(m_Target.IsScreen() ? "uint vertexID : VERTEXID_SEMANTIC;"
                                                           : "float3 positionOS : POSITION;");
    std::string varyings = GraphLine("float4 positionCS : SV_POSITION;");
    int interpolator = 0;
    for (const StageMember& member : k_Varyings)
    {
        if (code.varyings.contains(member.name))
        {
            varyings += GraphLine(std::string(member.type) + " " + member.name + " : INTERP" +
                                  std::to_string(interpolator++) + ";");
            code.defines += *member.macro == '\0' || m_Target.IsScreen()
                                ? ""
                                : GraphLine(std::string("#define VARYINGS_NEED_") + member.macro);
        }
    }
    for (const StageMember& member : k_Attributes)
    {
        if (code.attributes.contains(member.name) && !m_Target.IsScreen())
        {
            attributes +=
                GraphLine(std::string(member.type) + " " + member.name + " : " + member.from + ";");
            code.defines += GraphLine(std::string("#define ATTRIBUTES_NEED_") + member.macro);
        }
    }
    if (code.varyings.contains("cullFace"))
    {
        varyings += GraphLine("#if defined(SHADER_STAGE_FRAGMENT)") +
                    GraphLine("FRONT_FACE_TYPE cullFace : FRONT_FACE_SEMANTIC;") +
                    GraphLine("#endif");
    }
    if (!pass.kind.empty())
    {
        code.defines += GraphLine("#define SHADERPASS SHADERPASS_" + pass.kind);
    }
    return Structure("Attributes", attributes) + Structure("Varyings", varyings) +
           GraphLine("#define PackedVaryings Varyings") +
           GraphLine("Varyings PackVaryings(Varyings v) { return v; }") +
           GraphLine("Varyings UnpackVaryings(Varyings v) { return v; }");
}

/// Returns the custom functions of a pass.
std::string GraphWriter::FunctionsText() const
{
    std::string text;
    for (const std::string& file : m_Around.includes)
    {
        text += Include(std::filesystem::path(file)
                            .lexically_relative(m_File.path().parent_path())
                            .generic_string());
    }
    for (const std::string& function : m_Around.functions)
    {
        text += function;
    }
    return text;
}

/// Returns the #define lines of what code asks of the scene behind it.
std::string RequirementsText(const std::string& code)
{
    std::set<std::string> lines;
    for (const auto& [word, texture] : {std::pair{"SAMPLE_SCENE_DEPTH", "DEPTH"},
                                        {"SceneEyeDepth", "DEPTH"},
                                        {"SAMPLE_SCENE_COLOR", "OPAQUE"},
                                        {"SAMPLE_SCENE_NORMAL", "NORMAL"}})
    {
        if (code.find(word) != std::string::npos)
        {
            lines.insert(GraphLine(std::string("#define REQUIRE_") + texture + "_TEXTURE"));
        }
    }
    std::string text;
    for (const std::string& line : lines)
    {
        text += line;
    }
    return text;
}

/// Returns the lines that include what the code of any graph calls.
std::string LibrariesText()
{
    const std::string library = std::string(k_Universal) + "ShaderLibrary/";
    return Include(library + "Core.hlsl") + Include(library + "Lighting.hlsl") +
           Include(library + "ShaderGraphFunctions.hlsl") +
           Include(std::string(k_Includes) + "ShaderPass.hlsl") +
           Include("Packages/com.unity.render-pipelines.core/ShaderLibrary/Texture.hlsl") +
           Include("limn/GraphNodes.hlsl");
}

GraphWriter::PassCode GraphWriter::CodeOf(const GraphPass& pass)
{
    m_Around.functions.clear();
    m_Around.includes.clear();
    PassCode code;
    code.varyings.insert(pass.varyings.begin(), pass.varyings.end());
    if (m_Target.IsScreen())
    {
        code.varyings.insert({"texCoord0", "texCoord1"});
    }
    AddSurface(pass, code);
    for (const StageMember& member : k_Varyings)
    {
        if (code.varyings.contains(member.name))
        {
            code.attributes.insert(member.from);
        }
    }
    AddVertex(code);
    code.text = StructuresText(pass, code) + code.text;
    code.defines += RequirementsText(code.text);
    return code;
}

std::string GraphWriter::PassText(const GraphPass& pass)
{
    const PassCode code = CodeOf(pass);
    const bool isScreen = m_Target.IsScreen();
    const std::string mode = "Tags { \"LightMode\" = \"" + pass.lightMode + "\" }";
    return "        Pass\n        {\n" + GraphLine("Name \"" + pass.name + "\"") +
           (pass.lightMode.empty() ? "" : GraphLine(mode)) + m_Target.CullText() +
           (pass.state.empty() ? m_Target.StateText() : pass.state) + GraphLine("HLSLPROGRAM") +
           GraphLine("#pragma vertex vert") + GraphLine("#pragma fragment frag") + pass.lines +
           m_Target.DefinesText() + GraphKeywordsText(m_Around) + code.defines +
           (isScreen ? Include(std::string(k_ScreenIncludes) + "FullscreenShaderPass.cs.hlsl")
                     : "") +
           LibrariesText() + GraphUniformsText(m_File, m_Around) +
           (isScreen ? GraphLine("float _FlipY;") : "") + FunctionsText() + code.text +
           Include(isScreen ? std::string(k_ScreenIncludes) + "FullscreenCommon.hlsl"
                            : std::string(k_Includes) + "Varyings.hlsl") +
           Include(pass.include) + GraphLine("ENDHLSL") + "        }\n";
}

void GraphWriter::RequireNoProblems() const
{
    std::vector<Diagnostic> problems;
    for (const std::string& problem : m_Around.problems)
    {
        problems.push_back({Severity::Error, m_File.path().generic_string(), {}, problem});
    }
    if (!problems.empty())
    {
        throw AssetError(std::move(problems));
    }
}

TranslatedGraph GraphWriter::Write()
{
    ReadBlocks();
    for (const Json* keyword : m_File.FindAll(PartOf(m_File.graph(), "m_Keywords")))
    {
        m_Around.keywords[GraphReferenceName(*keyword)] = keyword;
    }
    const std::vector<GraphPass> passes = PassesOf(m_Target);
    for (const GraphPass& pass : passes)
    {
        CodeOf(pass); // finds the textures, samplers and keywords that all passes declare
    }
    RequireNoProblems();
    std::string body;
    for (const GraphPass& pass : passes)
    {
        body += PassText(pass);
    }
    const std::string folder = TextIn(m_File.graph(), "m_Path");
    TranslatedGraph translated;
    translated.shaderLab = "Shader \"" + (folder.empty() ? "Shader Graphs" : folder) + "/" +
                           m_File.path().stem().string() + "\"\n{\n    Properties\n    {\n" +
                           GraphPropertiesText(m_File, m_Around) + m_Target.PropertiesText() +
                           "    }\n    SubShader\n    {\n" + m_Target.TagsText() + body +
                           "    }\n}\n";
    for (const auto& [name, texture] : m_Around.textures)
    {
        if (!texture.guid.empty())
        {
            translated.textures.push_back(texture);
        }
    }
    return translated;
}

} // namespace

TranslatedGraph TranslateGraph(const std::filesystem::path& path, const GraphFiles& files)
{
    try
    {
        return GraphWriter(path, files).Write();
    }
    catch (const Json::exception& error)
    {
        throw AssetError(path.generic_string(), {},
                         std::string("the graph is broken: ") + error.what());
    }
}

bool IsShaderGraph(const std::filesystem::path& path)
{
    return ToLower(path.extension().string()) == ".shadergraph";
}

ShaderLabParseResult LoadShaderFile(const std::filesystem::path& path)
{
    if (!IsShaderGraph(path))
    {
        return LoadShaderLabWithDiagnostics(path);
    }
    const UnityProject project(path);
    const auto find = [&](const std::string& guid)
    {
        const std::filesystem::path* found = project.Find(guid);
        return found != nullptr ? *found : std::filesystem::path();
    };
    return ParseShaderLab(TranslateGraph(path, find).shaderLab, path.string());
}

} // namespace limn
