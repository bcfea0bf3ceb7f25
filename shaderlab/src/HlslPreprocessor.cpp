#include "HlslPreprocessor.h"

#include "GlslangLog.h"
#include "GlslangSession.h"
#include "Text.h"

#include <glslang/Public/ResourceLimits.h>

#include <list>
#include <memory>
#include <set>

namespace limn
{

namespace
{

constexpr std::string_view k_ByteOrderMark = "\xEF\xBB\xBF";

bool StartsWith(std::string_view text, std::string_view start)
{
    return text.substr(0, start.size()) == start;
}

/// Replaces directives that only Unity's preprocessor knows; the number of lines stays.
std::string TranslateDirectives(std::string_view text)
{
    if (StartsWith(text, k_ByteOrderMark))
    {
        text.remove_prefix(k_ByteOrderMark.size());
    }
    std::string result;
    result.reserve(text.size() + 1);
    while (!text.empty())
    {
        const std::size_t size = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, size);
        const std::string_view trimmed = Trim(line);
        constexpr std::string_view k_WithPragmas = "#include_with_pragmas";
        if (StartsWith(trimmed, k_WithPragmas))
        {
            result.append("#include").append(trimmed.substr(k_WithPragmas.size()));
        }
        else if (!StartsWith(trimmed, "#warning"))
        {
            result.append(line);
        }
        result += '\n';
        text.remove_prefix(std::min(size + 1, text.size()));
    }
    return result;
}

bool HasPragmaOnce(std::string_view text)
{
    const std::size_t pragma = text.find("#pragma once");
    return pragma != std::string_view::npos && (pragma == 0 || text[pragma - 1] == '\n');
}

/// Hands files to glslang and keeps them until it is done.
class Includer final : public glslang::TShader::Includer
{
public:
    explicit Includer(IncludeResolver& resolver) : m_Resolver(resolver) {}

    IncludeResult* includeLocal(const char* header, const char* includer, std::size_t) override
    {
        return Include(header, includer);
    }
    IncludeResult* includeSystem(const char* header, const char* includer, std::size_t) override
    {
        return Include(header, includer);
    }
    void releaseInclude(IncludeResult*) override {}

private:
    struct Loaded
    {
        std::string text;
        std::unique_ptr<IncludeResult> result;
    };

    IncludeResult* Include(const char* header, const char* includer)
    {
        auto file = m_Resolver.Find(header, includer);
        if (!file)
        {
            return nullptr;
        }
        if (HasPragmaOnce(file->text) && !m_Once.insert(file->name).second)
        {
            file->text.clear();
        }
        Loaded& loaded = m_Loaded.emplace_back();
        // glslang reads the last character of a header unasked.
        loaded.text = TranslateDirectives(file->text.empty() ? "\n" : file->text);
        loaded.result = std::make_unique<IncludeResult>(file->name, loaded.text.c_str(),
                                                        loaded.text.size(), nullptr);
        return loaded.result.get();
    }

    IncludeResolver& m_Resolver;
    std::list<Loaded> m_Loaded;
    std::set<std::string> m_Once; ///< files with `#pragma once` that were included
};

void Define(std::string& source, std::string_view name, std::string_view value = "1")
{
    source.append("#define ").append(name).append(" ").append(value).append("\n");
}

std::string AssembleSource(const PassProgram& program, ShaderStage stage,
                           std::span<const std::string> keywords)
{
    std::string source;
    Define(source, stage == ShaderStage::Vertex ? "SHADER_STAGE_VERTEX" : "SHADER_STAGE_FRAGMENT");
    Define(source, "SHADER_TARGET", std::to_string(program.target));
    for (const std::string& keyword : keywords)
    {
        Define(source, keyword);
    }
    source += "#include \"limn/Prelude.hlsl\"\n";
    if (program.language == ProgramLanguage::Cg)
    {
        source += "#include \"HLSLSupport.cginc\"\n#include \"UnityShaderVariables.cginc\"\n";
    }
    for (const SourceChunk& chunk : program.chunks)
    {
        source += "#line " + std::to_string(chunk.firstLine) + " \"" + program.file + "\"\n";
        source += TranslateDirectives(chunk.text);
    }
    return source;
}

void ExplainMissingIncludes(std::vector<Diagnostic>& diagnostics)
{
    constexpr std::string_view k_Glslang =
        "'#include': Could not process include directive for header name: ";
    for (Diagnostic& diagnostic : diagnostics)
    {
        if (StartsWith(diagnostic.message, k_Glslang))
        {
            diagnostic.message = "#include: no such file \"" +
                                 diagnostic.message.substr(k_Glslang.size()) +
                                 "\"; it was looked for beside this file, in the project, its "
                                 "packages and the built-in ShaderLibrary";
        }
    }
}

/// Blanks the pragmas, which are Unity's; matrix packing alone is the compiler's business.
void RemovePragmas(std::string& text)
{
    for (std::size_t line = 0; line < text.size();)
    {
        const std::size_t end = std::min(text.find('\n', line), text.size());
        const std::string_view trimmed = Trim(std::string_view(text).substr(line, end - line));
        if (StartsWith(trimmed, "#pragma") && trimmed.find("pack_matrix") == trimmed.npos)
        {
            text.replace(line, end - line, end - line, ' ');
        }
        line = end + 1;
    }
}

} // namespace

std::string PreprocessHlsl(const PassProgram& program, ShaderStage stage,
                           std::span<const std::string> keywords, IncludeResolver& resolver)
{
    StartGlslang();
    const std::string source = AssembleSource(program, stage, keywords);
    const char* const text = source.c_str();
    const char* const name = program.file.c_str();
    const int size = static_cast<int>(source.size());
    glslang::TShader shader(GlslangStage(stage));
    shader.setStringsWithLengthsAndNames(&text, &size, &name, 1);
    SetEnvironment(shader, stage);
    Includer includer(resolver);
    std::string result;
    const bool good = shader.preprocess(GetDefaultResources(), 500, ENoProfile, false, false,
                                        k_GlslangMessages, &result, includer);
    std::vector<Diagnostic> diagnostics = ReadGlslangLog(shader.getInfoLog(), program.file);
    if (!good || !diagnostics.empty())
    {
        ExplainMissingIncludes(diagnostics);
        if (diagnostics.empty())
        {
            diagnostics.push_back({Severity::Error, program.file, program.location,
                                   "program: the preprocessor failed without a message"});
        }
        throw AssetError(std::move(diagnostics));
    }
    RemovePragmas(result);
    return result;
}

} // namespace limn
