#include "stages/StageInterface.h"

#include "hlsl/Tree.h"
#include "hlsl/Types.h"
#include <limn/base/WordList.h>

#include <algorithm>
#include <array>
#include <charconv>

namespace limn
{

namespace
{

struct Semantic
{
    std::string name;
    int index = 0;
};

Semantic SplitSemantic(std::string_view text)
{
    const std::size_t size = text.find_last_not_of("0123456789") + 1;
    Semantic semantic;
    for (const char c : text.substr(0, size))
    {
        semantic.name += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    }
    std::from_chars(text.data() + size, text.data() + text.size(), semantic.index);
    return semantic;
}

/// The old names that Direct3D 9 shaders use for system values.
std::string ModernName(const std::string& name, int index, ShaderStage stage, bool isOutput)
{
    const bool isPosition = name == "POSITION" && index == 0;
    if (stage == ShaderStage::Geometry)
    {
        return isPosition ? "SV_POSITION" : name;
    }
    if (stage == ShaderStage::Vertex)
    {
        if (isOutput)
        {
            return isPosition ? "SV_POSITION" : name;
        }
        return name == "SV_POSITION" ? "POSITION" : name;
    }
    if (isOutput)
    {
        return name == "COLOR" ? "SV_TARGET" : name == "DEPTH" ? "SV_DEPTH" : name;
    }
    if (isPosition || name == "VPOS")
    {
        return "SV_POSITION";
    }
    return name == "VFACE" || name == "FACE" ? "SV_ISFRONTFACE" : name;
}

/// Returns whether the pipeline makes or takes this value at this border.
bool isPipelineValue(std::string_view name, ShaderStage stage, bool isOutput)
{
    static const WordList s_VertexInputs("SV_VERTEXID SV_INSTANCEID");
    static const WordList s_VertexOutputs(
        "SV_POSITION SV_CLIPDISTANCE SV_CULLDISTANCE SV_RENDERTARGETARRAYINDEX "
        "SV_VIEWPORTARRAYINDEX PSIZE");
    static const WordList s_FragmentInputs(
        "SV_POSITION SV_ISFRONTFACE SV_SAMPLEINDEX SV_COVERAGE SV_CLIPDISTANCE SV_PRIMITIVEID "
        "SV_RENDERTARGETARRAYINDEX SV_VIEWPORTARRAYINDEX");
    static const WordList s_FragmentOutputs(
        "SV_TARGET SV_DEPTH SV_DEPTHLESSEQUAL SV_DEPTHGREATEREQUAL SV_COVERAGE");
    static const WordList s_GeometryInputs(
        "SV_POSITION SV_CLIPDISTANCE SV_CULLDISTANCE SV_PRIMITIVEID SV_GSINSTANCEID");
    static const WordList s_GeometryOutputs(
        "SV_POSITION SV_CLIPDISTANCE SV_CULLDISTANCE SV_PRIMITIVEID SV_RENDERTARGETARRAYINDEX "
        "SV_VIEWPORTARRAYINDEX");
    const WordList& inputs = stage == ShaderStage::Geometry ? s_GeometryInputs
                             : stage == ShaderStage::Vertex ? s_VertexInputs
                                                            : s_FragmentInputs;
    const WordList& outputs = stage == ShaderStage::Geometry ? s_GeometryOutputs
                              : stage == ShaderStage::Vertex ? s_VertexOutputs
                                                             : s_FragmentOutputs;
    return (isOutput ? outputs : inputs).Has(name);
}

[[noreturn]] void Fail(const HlslVariable& variable, const std::string& message)
{
    throw StageInterfaceError{"'" + std::string(variable.name) + message, variable.token};
}

class InterfaceReader
{
public:
    InterfaceReader(const HlslDeclarations& declarations, ShaderStage stage)
        : m_Declarations(declarations), m_Stage(stage)
    {
    }

    /// The values of a parameter of a geometry function, into the list that they belong to.
    void ExpandGeometry(HlslVariable parameter, std::size_t index, StageInterface& result)
    {
        const std::string argument = ArgumentName(index);
        if (const auto primitive = PrimitiveOf(parameter))
        {
            const std::string_view known = result.geometry->primitive;
            if (!known.empty() && known != primitive->name)
            {
                Fail(parameter, "': '" + std::string(primitive->name) + "' after an array of '" +
                                    std::string(known) +
                                    "'; a geometry function takes one primitive");
            }
            result.geometry->primitive = primitive->name;
            result.geometry->inputVertices = primitive->vertices;
            RequireVertices(parameter, *primitive);
            parameter.dimensions.clear();
            Expand(parameter, argument + "[" + std::string(k_InputIndex) + "]", false,
                   result.inputs);
        }
        else if (isStream(parameter.type))
        {
            if (!result.geometry->stream.empty())
            {
                Fail(parameter,
                     "': a geometry function with more than one stream is not supported");
            }
            result.geometry->stream = parameter.type;
            result.geometry->outputType = parameter.templateArgument;
            parameter.type = parameter.templateArgument;
            Expand(parameter, std::string(k_OutputVertex), true, result.outputs);
        }
        else
        {
            Expand(parameter, argument, false, result.primitiveInputs);
        }
    }

    void Expand(const HlslVariable& variable, const std::string& expression, bool isOutput,
                std::vector<StageValue>& values)
    {
        const std::string_view typeName = m_Declarations.ResolveAlias(variable.type);
        if (const HlslStruct* type = m_Declarations.FindStruct(typeName))
        {
            // Structs may hold themselves, or so many that nobody waits for the end.
            constexpr int k_MaximumNesting = 16;
            constexpr std::size_t k_MaximumValues = 256;
            if (m_Depth == k_MaximumNesting)
            {
                Fail(variable, "': type '" + std::string(variable.type) +
                                   "' contains itself or is nested more than " +
                                   std::to_string(k_MaximumNesting) +
                                   " structs deep, so no stage can pass it on");
            }
            if (values.size() > k_MaximumValues)
            {
                Fail(variable, "': with type '" + std::string(variable.type) +
                                   "' there are more than " + std::to_string(k_MaximumValues) +
                                   " values, the most that a stage can pass on");
            }
            ++m_Depth;
            ExpandMembers(variable, *type, expression, isOutput, values);
            --m_Depth;
            return;
        }
        const bool isTemplate = typeName == "vector" || typeName == "matrix";
        const auto type = NumberType(
            isTemplate ? TypeOf(m_Declarations, variable.type, variable.templateArgument).Spelling()
                       : std::string(typeName));
        if (!type)
        {
            Fail(variable, (isObjectType(typeName) ? "': type '" : "': unknown type '") +
                               std::string(variable.type) +
                               (isObjectType(typeName) ? "' cannot cross the border of a stage"
                                                       : "'; no file declares it"));
        }
        if (variable.semantic.empty())
        {
            Fail(variable, "' has no semantic; write one behind it, as in ': TEXCOORD0'");
        }
        ExpandElements(variable, *type, expression, isOutput, values);
    }

private:
    /// A semantic of the struct itself is that of its first member without one; the next ones have
    /// the numbers that follow.
    void ExpandMembers(const HlslVariable& variable, const HlslStruct& type,
                       const std::string& expression, bool isOutput,
                       std::vector<StageValue>& values)
    {
        const Semantic given = SplitSemantic(variable.semantic);
        int next = given.index;
        for (HlslVariable member : type.members)
        {
            const bool isNamed = given.name.empty() || !member.semantic.empty();
            const std::string semantic = given.name + std::to_string(next);
            member.semantic = isNamed ? member.semantic : semantic;
            const std::size_t first = values.size();
            Expand(member, expression + "." + std::string(member.name), isOutput, values);
            next += isNamed ? 0 : static_cast<int>(values.size() - first);
        }
    }

    struct Primitive
    {
        std::string_view name;
        int vertices;
    };

    static std::optional<Primitive> PrimitiveOf(const HlslVariable& parameter)
    {
        static constexpr std::array<Primitive, 5> k_Primitives = {
            {{"point", 1}, {"line", 2}, {"lineadj", 4}, {"triangle", 3}, {"triangleadj", 6}}};
        const auto found = std::ranges::find_if(
            k_Primitives, [&](std::string_view name) { return parameter.Has(name); },
            &Primitive::name);
        return found == k_Primitives.end() ? std::nullopt : std::optional(*found);
    }

    void RequireVertices(const HlslVariable& parameter, const Primitive& primitive) const
    {
        const bool isRight = parameter.dimensions.size() == 1 &&
                             EvaluateInteger(parameter.dimensions[0], m_Declarations.constants) ==
                                 primitive.vertices;
        if (!isRight)
        {
            Fail(parameter, "': '" + std::string(primitive.name) + "' needs an array of " +
                                std::to_string(primitive.vertices));
        }
    }

    void ExpandElements(const HlslVariable& variable, const HlslType& type,
                        const std::string& expression, bool isOutput,
                        std::vector<StageValue>& values)
    {
        const Semantic semantic = SplitSemantic(variable.semantic);
        StageValue value;
        value.semantic = ModernName(semantic.name, semantic.index, m_Stage, isOutput);
        value.index = semantic.index;
        value.token = variable.token;
        value.isSystemValue = isPipelineValue(value.semantic, m_Stage, isOutput);
        RequireKnown(variable, value, isOutput);
        // Stages hand over floats: a device need not know smaller or larger ones.
        const HlslType scalar = type.isFloating() ? type.Of(HlslScalar::Float) : type;
        value.scalar = scalar.As(1).Spelling();
        value.components = type.columns;
        for (const std::string_view modifier :
             {"nointerpolation", "noperspective", "centroid", "sample"})
        {
            value.interpolation += variable.Has(modifier) ? std::string(modifier) + " " : "";
        }
        const int rows = std::max<int>(type.rows, 1);
        const int count = variable.dimensions.empty() ? 1 : ArraySize(variable);
        for (int element = 0; element < count; ++element)
        {
            for (int row = 0; row < rows; ++row)
            {
                value.expression = expression;
                value.expression +=
                    variable.dimensions.empty() ? "" : "[" + std::to_string(element) + "]";
                value.expression += type.isMatrix() ? "[" + std::to_string(row) + "]" : "";
                values.push_back(value);
                ++value.index;
            }
        }
    }

    void RequireKnown(const HlslVariable& variable, const StageValue& value, bool isOutput) const
    {
        // An instance id that travels to the fragment function is a varying like any other. A
        // target or depth that the function takes is one that nobody writes: Unity's compiler takes
        // `Outputs frag(v2f i, Outputs o)`.
        const bool isFragment = m_Stage == ShaderStage::Fragment;
        const bool isReserved =
            value.semantic.starts_with("SV_") && value.semantic != "SV_INSTANCEID" &&
            !(isFragment && isPipelineValue(value.semantic, ShaderStage::Fragment, true));
        const bool isFree = !isReserved && !(isFragment && isOutput);
        if (!value.isSystemValue && !isFree)
        {
            Fail(variable, "': semantic '" + std::string(variable.semantic) +
                               "' is not possible at this place");
        }
    }

    int ArraySize(const HlslVariable& variable) const
    {
        constexpr std::int64_t k_MostVaryings = 32;
        const std::int64_t size = EvaluateInteger(variable.dimensions[0], m_Declarations.constants);
        if (variable.dimensions.size() > 1 || size < 1 || size > k_MostVaryings)
        {
            Fail(variable, "': an array between stages needs one size, a number from 1 "
                           "to 32");
        }
        return static_cast<int>(size);
    }

    const HlslDeclarations& m_Declarations;
    ShaderStage m_Stage;
    int m_Depth = 0; ///< structs around what is being expanded
};

StageInterface ReadGeometryInterface(const HlslDeclarations& declarations,
                                     const HlslFunction& function)
{
    StageInterface result;
    result.function = &function;
    result.geometry.emplace();
    InterfaceReader reader(declarations, ShaderStage::Geometry);
    for (std::size_t i = 0; i < function.parameters.size(); ++i)
    {
        reader.ExpandGeometry(function.parameters[i], i, result);
    }
    const bool hasMaximum =
        std::ranges::any_of(function.attributes, [](std::string_view text)
                            { return text.find("maxvertexcount") != text.npos; });
    if (result.geometry->primitive.empty() || result.geometry->stream.empty() || !hasMaximum)
    {
        throw StageInterfaceError{
            "a geometry function needs [maxvertexcount(N)] before it, an array of vertices as in "
            "'triangle v2g input[3]', and a stream as in 'inout TriangleStream<g2f> stream'"};
    }
    return result;
}

} // namespace

std::string StageValue::semanticName() const
{
    const bool isNumbered = semantic == "TEXCOORD" || index > 0;
    return isNumbered ? semantic + std::to_string(index) : semantic;
}

std::string ArgumentName(std::size_t index)
{
    return "limn_argument" + std::to_string(index);
}

std::string TypeName(const std::string& scalar, int components)
{
    return components == 1 ? scalar : scalar + std::to_string(components);
}

bool isStream(std::string_view type)
{
    return type == "PointStream" || type == "LineStream" || type == "TriangleStream";
}

StageInterface ReadStageInterface(const HlslDeclarations& declarations,
                                  const HlslFunction& function, ShaderStage stage)
{
    if (stage == ShaderStage::Geometry)
    {
        return ReadGeometryInterface(declarations, function);
    }
    StageInterface result;
    result.function = &function;
    InterfaceReader reader(declarations, stage);
    for (std::size_t i = 0; i < function.parameters.size(); ++i)
    {
        const HlslVariable& parameter = function.parameters[i];
        const bool isOutput = parameter.Has("out") || parameter.Has("inout");
        if (!parameter.Has("out"))
        {
            reader.Expand(parameter, ArgumentName(i), false, result.inputs);
        }
        if (isOutput)
        {
            reader.Expand(parameter, ArgumentName(i), true, result.outputs);
        }
    }
    if (function.returnType != "void")
    {
        HlslVariable returned;
        returned.name = function.name;
        returned.type = function.returnType;
        returned.semantic = function.semantic;
        reader.Expand(returned, std::string(k_ResultName), true, result.outputs);
    }
    return result;
}

} // namespace limn
