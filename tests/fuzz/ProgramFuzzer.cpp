#include <limn/shaderlab/InitialKeywords.h>
#include <limn/shaderlab/ProgramRequirements.h>
#include <limn/shaderlab/VariantCount.h>

#include "desugar/Rewrites.h"
#include "includes/IncludeResolver.h"
#include "keywords/PragmaScanner.h"
#include "lowering/StageLowering.h"
#include "preprocess/GlslangIncluder.h"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

namespace
{

using namespace limn;

void Require(bool holds, const char* what)
{
    if (!holds)
    {
        std::fprintf(stderr, "ProgramFuzzer: %s\n", what);
        std::abort();
    }
}

std::size_t Lines(std::string_view text)
{
    std::size_t lines = 0;
    for (const char c : text)
    {
        lines += c == '\n' ? 1 : 0;
    }
    return lines;
}

/// Pragmas, with the bytes as a file behind #include_with_pragmas, too.
PassProgram ScanAll(const std::string& text)
{
    PassProgram program;
    program.file = "fuzz.shader";
    program.location = {1, 1};
    program.chunks = {{text, 1}};
    ScanPragmas(program,
                [&](std::string_view include, std::string_view) {
                    return IncludedFile{std::string(include), text};
                });
    Require(!CountVariants(program).ToString().empty(), "no count of variants");
    SelectVariant(program, {});
    RequiredFeatures(program);
    CheckPragmas(program);
    ReasonNotSupported(program);
    return program;
}

/// Everything between the preprocessor and the compiler, with each function as the entry.
void Rewrite(const std::string& text, ColumnFinder& lines, ShaderStage stage)
{
    const HlslSource source(text, &lines);
    for (const std::size_t token : {source.tokens.size() / 2, source.tokens.size() - 1})
    {
        Require(token >= source.tokens.size() || source.tokens.Place(token).location.column >= 0,
                "a column below 0");
    }
    int left = 8;
    for (const HlslFunction& function : source.declarations.functions)
    {
        if (!function.hasBody || left-- == 0)
        {
            continue;
        }
        try
        {
            const StageInterface interface =
                ReadStageInterface(source.declarations, function, stage);
            const StageInterface other;
            const StageLinkage linkage =
                LinkStages(stage == ShaderStage::Vertex ? interface : other,
                           stage == ShaderStage::Geometry ? &interface : nullptr,
                           stage == ShaderStage::Fragment ? interface : other);
            Require(!RewriteStage(source, stage, interface, linkage).text.empty(),
                    "nothing was written");
        }
        catch (const StageInterfaceError& error)
        {
            Require(!error.message.empty(), "an empty complaint");
        }
        catch (const AssetError& error)
        {
            Require(!error.diagnostics().empty(), "an empty complaint");
        }
    }
}

void Resolve(const std::string& text)
{
    static const ShaderCompilerOptions options;
    IncludeResolver resolver(options, "fuzz.shader");
    const std::size_t size = text.find('\n');
    const std::string name =
        text.substr(0, size == text.npos ? 200 : std::min<std::size_t>(size, 200));
    const auto file = resolver.Find(name, "fuzz.shader");
    Require(!file || !file->name.empty(), "a file without a name");
}

} // namespace

/// Any bytes as HLSL: pragmas are read, directives translated, names spelt and entry functions
/// written, or there is a complaint; never an exception of another kind.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string text(reinterpret_cast<const char*>(data), size);
    ScanAll(text);
    Resolve(text);
    const std::string translated = TranslateDirectives(text);
    Require(Lines(translated) >= Lines(text), "lines were lost");
    std::vector<Diagnostic> warnings;
    try
    {
        PassProgram program;
        program.chunks = {{"\n" + text, 0}};
        static const ShaderCompilerOptions options;
        IncludeResolver resolver(options, "fuzz.shader");
        ColumnFinder lines(program, resolver);
        const std::string spelt = RespellForGlslang(translated, program, lines, warnings);
        Rewrite(spelt, lines, ShaderStage::Vertex);
        Rewrite(spelt, lines, ShaderStage::Geometry);
        Rewrite(spelt, lines, ShaderStage::Fragment);
    }
    catch (const AssetError& error) // nested too deeply
    {
        Require(!error.diagnostics().empty(), "an empty complaint");
    }
    return 0;
}
