#include "Mentions.h"
#include "hlsl/DialectTestSupport.h"

#include <gmock/gmock.h>

namespace limn
{
namespace
{

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using namespace test;

TEST(HlslNamespaces, TakesNamesOfNamespacesThatAreUsed)
{
    const std::string declared = "namespace A { static const float k = 3; struct S { float v; };\n"
                                 "float F(float x) { return x * 2; }\n"
                                 "namespace B { float F(float x) { return x * 5; } } }\n"
                                 "namespace C { using namespace A; float G() { return F(k); } }\n";
    const std::string fragment = "float4 frag(v2f i) : SV_Target { return i.uv.x * f(); }";
    for (const auto& [function, product] :
         {std::pair("using namespace A; float f() { S s; s.v = k; return F(s.v); }", "6"),
          std::pair("float f() { using namespace A::B; return F(A::k); }", "15"),
          std::pair("float F(float x) { return x * 7; } float g() { using namespace A::B; "
                    "return A::k; } float f() { return F(g()); }",
                    "21"),
          std::pair("using namespace A; float f() { return B::F(k); }", "15"),
          std::pair("float f() { return C::G(); }", "6")})
    {
        SCOPED_TRACE(function);
        const auto pass = CompileFragment(declared + function + fragment);
        EXPECT_THAT(Disassemble(pass->fragmentSpirv),
                    HasSubstr("OpConstant %float " + std::string(product) + "\n"));
    }
}

TEST(HlslNamespaces, TakesNamesThatMethodsCall)
{
    const auto pass = CompileFragment(
        "namespace A { float F(float x) { return x * 2; } }\n"
        "namespace B { float F(float x) { return x * 5; } }\n"
        "struct M { struct N { float w; } n; float v; float Get() { return A::F(v) + B::F(n.w); } "
        "};\n"
        "float4 frag(v2f i) : SV_Target { M m; m.v = 3; m.n.w = 4; return m.Get(); }");
    EXPECT_THAT(Disassemble(pass->fragmentSpirv), HasSubstr("OpConstant %float 26\n"));
}

TEST(HlslNamespaces, RefusesToUseNamespacesThatAreNot)
{
    EXPECT_THAT(test::CompileMessages(test::Program(
                    k_Vertex + "namespace A { float F() { return 1; } }\nusing namespace D;\n"
                               "float4 frag(v2f i) : SV_Target { return i.uv.x; }")),
                ElementsAre(test::Mentions("error: 'D'", "no such namespace")));
    EXPECT_THAT(test::CompileMessages(
                    test::Program(k_Vertex + "using namespace D;\n"
                                             "float4 frag(v2f i) : SV_Target { return i.uv.x; }")),
                ElementsAre(test::Mentions("error: 'D'", "no such namespace")));
}

TEST(HlslNamespaces, RefusesUsingWithoutItsEnd)
{
    EXPECT_THAT(test::CompileMessages(test::Program(
                    k_Vertex + "namespace A { float F() { return 1; } }\nusing namespace A\n"
                               "float4 frag(v2f i) : SV_Target { return i.uv.x; }")),
                Contains(HasSubstr("error: 'using': ")));
}

} // namespace
} // namespace limn
