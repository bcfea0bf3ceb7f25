#include "TreeTestSupport.h"

#include <gtest/gtest.h>

#include <utility>

namespace limn::test
{

namespace
{

/// The tree as text, operators first: "(+ a (* b c))".
std::string Describe(const HlslTokens& tokens, const HlslNode& node)
{
    if (!node.child)
    {
        return std::string(tokens.Span(node.first, node.end));
    }
    const bool isCall = node.kind == HlslNodeKind::Call || node.kind == HlslNodeKind::Method;
    const bool isOfType = node.kind == HlslNodeKind::Cast || node.kind == HlslNodeKind::Construct;
    std::string text = "(";
    text += isOfType                            ? node.type.Spelling()
            : isCall                            ? std::string(tokens.Text(node.token)) + "()"
            : node.kind == HlslNodeKind::Member ? "." + std::string(tokens.Text(node.token))
                                                : std::string(tokens.Text(node.token));
    for (const HlslNode* child = node.child; child; child = child->next)
    {
        text += " " + Describe(tokens, *child);
    }
    return text + ")";
}

std::string Describe(const std::string& expression)
{
    const HlslSource source(
        "struct S { float a; }; typedef float3x3 Basis; float x = " + expression + ";");
    HlslNodes nodes;
    HlslTreeParser parser(source.tokens, source.declarations, nodes);
    const HlslVariable& variable = source.declarations.uniforms.front();
    return Describe(source.tokens, *parser.ParseValue(variable.valueToken, variable.valueEnd));
}

std::string TypeText(const HlslType& type)
{
    const std::string array = type.dimensions > 0 ? "[]" : "";
    switch (type.kind)
    {
    case HlslType::Kind::Number:
        return (type.scalar == HlslScalar::Half ? "half " : "") + type.Spelling() + array;
    case HlslType::Kind::Struct:
    case HlslType::Kind::Object:
        return std::string(type.name) + array;
    case HlslType::Kind::Void:
        return "void";
    default:
        return "?";
    }
}

constexpr const char* k_Names = R"(
    struct Inner { float2 uv; int ids[2]; };
    struct Outer { Inner inner; float4x4 matrices[3]; half3 color; };
    typedef matrix<half, 2, 3> Wide;
    Texture2D _Map; SamplerState sampler_Map; Texture2D<float2> _Pair; sampler2D _Old;
    StructuredBuffer<Outer> _All; ByteAddressBuffer _Bytes;
    float4 _Color; static const int k_Count = 3; Wide _Wide;
    half3 Light(half3 n) { return n; } float3 Light(float3 n) { return n; } void Nothing() {}
    float4 Of(Inner i, float2 p[2]) { return 0; }
)";

std::string TypeIn(const std::string& expression)
{
    const HlslSource source(std::string(k_Names) +
                            "void f(Outer o, float3 v, half h, uint k, bool b) { " + expression +
                            "; }");
    ResolvedBody body(source, source.declarations.functions.back());
    const HlslNode& statement = *body.root().child;
    return TypeText(statement.child->type);
}

} // namespace

TEST(HlslTree, BindsOperatorsAsTheLanguageDoes)
{
    const std::pair<const char*, const char*> k_Cases[] = {
        {"a + b * c - d", "(- (+ a (* b c)) d)"},
        {"a < b == c > d && e || f", "(|| (&& (== (< a b) (> c d)) e) f)"},
        {"a & b | c ^ d << 1 + 2", "(| (& a b) (^ c (<< d (+ 1 2))))"},
        {"-a.x++ * !b[1].y", "(* (- (++ (.x a))) (! (.y ([ b 1))))"},
        {"a ? b : c ? d : e", "(? a b (? c d e))"},
        {"f(a, g(b), (c, d)).xy", "(.xy (f() a (g() b) (( (, c d))))"},
        {"(float3x3)-m[0]", "(float3x3 (- ([ m 0)))"},
        {"(Basis)a * (unsigned int)b", "(* (float3x3 a) (uint b))"},
        {"float4(a, 1) + half3(b).x", "(+ (float4 a 1) (.x (float3 b)))"},
        {"(a) - b", "(- (( a) b)"},
        {"(matrix<float, 2, 3>)a", "(float2x3 a)"},
        {"t.Sample(s, uv).r", "(.r (Sample() t s uv))"},
        {"S::Make(1)", "(Make() 1)"},
    };
    for (const auto& [text, tree] : k_Cases)
    {
        EXPECT_EQ(tree, Describe(text)) << text;
    }
}

TEST(HlslTree, KnowsTheTypesOfExpressions)
{
    const std::pair<const char*, const char*> k_Cases[] = {
        {"v.xy", "float2"},
        {"v.zyx.x", "float"},
        {"o.inner.uv * 2", "float2"},
        {"o.inner.ids", "int[]"},
        {"o.inner.ids[0]", "int"},
        {"o.matrices[1][2].xy", "float2"},
        {"o.matrices[1]._m00_m11", "float2"},
        {"o.color", "half float3"},
        {"o.color * 0.5", "half float3"},
        {"o.color * v", "float3"},
        {"h * 0.5f", "float"},
        {"v + _Color", "float3"},
        {"k + 1", "uint"},
        {"b + b", "int"},
        {"v > 1", "bool3"},
        {"!v", "bool3"},
        {"b ? v : _Color", "float3"},
        {"mul(o.matrices[0], _Color)", "float4"},
        {"mul(v, (float3x3)o.matrices[0])", "float3"},
        {"mul(_Wide, v)", "float2"},
        {"transpose(_Wide)", "half float3x2"},
        {"dot(v, _Color)", "float"},
        {"cross(v, o.color)", "float3"},
        {"any(v)", "bool"},
        {"asuint(v)", "uint3"},
        {"max(k, 2)", "uint"},
        {"sqrt(k)", "float"},
        {"Light(o.color)", "half float3"},
        {"Light(v)", "float3"},
        {"Nothing()", "void"},
        {"_Map.Sample(sampler_Map, v.xy)", "float4"},
        {"_Pair.Load(0)", "float2"},
        {"_Pair[k]", "float2"},
        {"tex2D(_Old, v.xy).rgb", "float3"},
        {"_All[k].inner.uv", "float2"},
        {"_All.Load(0).color", "half float3"},
        {"_Bytes.Load3(4)", "uint3"},
        {"k_Count", "int"},
        {"v.x = k", "float"},
        {"(int2)v", "int2"},
        {"unknown + 1", "?"},
        {"unknown(v)", "?"},
        {"v.xq", "?"},
    };
    for (const auto& [expression, type] : k_Cases)
    {
        EXPECT_EQ(type, TypeIn(expression)) << expression;
    }
}

TEST(HlslTree, TakesTheTypeOfTheNewestOfAName)
{
    const HlslSource source("float4 a; float f(float2 a) { a; { int a = 1; a; } a; "
                            "for (uint a = 0; a < 2; a++) a; a; }");
    ResolvedBody body(source, source.declarations.functions.back());
    std::string types;
    const HlslNode* statement = body.root().child;
    types += TypeText(statement->child->type);
    types += " " + TypeText(statement->next->Child(1)->child->type);
    types += " " + TypeText(statement->next->next->child->type);
    const HlslNode* loop = statement->next->next->next;
    types += " " + TypeText(loop->Child(3)->child->type);
    types += " " + TypeText(loop->next->child->type); // as Unity's compilers, which go on with it
    EXPECT_EQ("float2 int float2 uint uint", types);
}

TEST(HlslTree, LeavesWhatItDoesNotKnowToTheNextStatement)
{
    // None of this is HLSL; all of it is kept, and what follows is read.
    for (const std::string text :
         {"@ @;", "a b c d;", "if;", "for (;;", "x = ;", "= 3;", "do", "switch { } ;", "case;",
          "float;", "(", ") )", "[unroll", "return return;", "a ? b;", "f(,,);", "float x = {;"})
    {
        const std::string whole = "void f() { " + text + " y = 1; }";
        EXPECT_EQ(whole, Lowered(whole));
    }
}

} // namespace limn::test
