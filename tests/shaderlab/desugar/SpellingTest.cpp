#include "desugar/Rewrites.h"
#include "includes/IncludeResolver.h"

#include <gmock/gmock.h>

namespace limn
{
namespace
{

/// A fuzzer found that the search for the list which a `const` stands in went back over the first
/// token of the text, where that opens a bracket.
TEST(RespellForGlslang, StopsAtABracketThatBeginsTheText)
{
    const PassProgram program;
    const ShaderCompilerOptions options;
    IncludeResolver resolver(options, "s.shader");
    ColumnFinder lines(program, resolver);
    std::vector<Diagnostic> warnings;
    EXPECT_THAT(RespellForGlslang("{ float a; } float static const f(const float s) { return s; }",
                                  program, lines, warnings),
                testing::HasSubstr("static const f("));
}

} // namespace
} // namespace limn
