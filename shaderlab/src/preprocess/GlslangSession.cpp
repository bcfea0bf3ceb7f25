#include "preprocess/GlslangSession.h"

#include "tokens/Lines.h"
#include <limn/base/Text.h>

#include <algorithm>
#include <charconv>
#include <mutex>
#include <optional>

namespace limn
{

namespace
{

struct Place
{
    std::string file;
    int line = 0;
    std::size_t end = 0; ///< offset of the message
};

/// Reads "name:12: " at the start of a line; the name may hold colons itself.
std::optional<Place> ReadPlace(std::string_view line)
{
    for (std::size_t i = line.find(':'); i != line.npos; i = line.find(':', i + 1))
    {
        int number = 0;
        const char* const begin = line.data() + i + 1;
        const auto [end, error] = std::from_chars(begin, line.data() + line.size(), number);
        const auto offset = static_cast<std::size_t>(end - line.data());
        if (error == std::errc{} && line.substr(offset, 2) == ": ")
        {
            return Place{std::string(line.substr(0, i)), number, offset + 2};
        }
    }
    return std::nullopt;
}

bool Consume(std::string_view& text, std::string_view start)
{
    const bool starts = text.starts_with(start);
    text.remove_prefix(starts ? start.size() : 0);
    return starts;
}

/// " const 3-component vector of float" becomes "float3", " temp 4X4 matrix of float" "float4x4".
std::string HlslTypeName(std::string_view type)
{
    type = Trim(type);
    for (const std::string_view qualifier :
         {"temp ", "const ", "global ", "uniform ", "in ", "out ", "inout "})
    {
        Consume(type, qualifier);
    }
    constexpr std::string_view k_Vector = "-component vector of ";
    constexpr std::string_view k_Matrix = " matrix of ";
    if (type.size() > 1 && type.substr(1, k_Vector.size()) == k_Vector)
    {
        return std::string(type.substr(1 + k_Vector.size())) + type[0];
    }
    if (type.size() > 3 && type.substr(3, k_Matrix.size()) == k_Matrix)
    {
        return std::string(type.substr(3 + k_Matrix.size())) + type[0] + 'x' + type[2];
    }
    return std::string(type);
}

/// Spells what stands in quotes as a type of HLSL.
std::string SpellTypes(std::string_view text)
{
    std::string result;
    while (!text.empty())
    {
        const std::size_t open = text.find('\'');
        const std::size_t close = open == text.npos ? open : text.find('\'', open + 1);
        if (close == text.npos)
        {
            break;
        }
        result += text.substr(0, open + 1);
        result += HlslTypeName(text.substr(open + 1, close - open - 1)) + "'";
        text.remove_prefix(close + 1);
    }
    return result.append(text);
}

/// "'token' : reason extra" becomes "'token': reason extra".
std::string CleanMessage(std::string_view message)
{
    message = Trim(message);
    const std::size_t separator = message.find("' : ");
    if (separator == message.npos || message[0] != '\'')
    {
        return std::string(message);
    }
    std::string_view token = message.substr(1, separator - 1);
    Consume(token, "__BI_"); // methods of textures
    std::string_view reason = Trim(message.substr(separator + 4));
    if (Consume(reason, "Expected"))
    {
        const bool isMark = token.size() <= 2;
        return (isMark ? "'" + std::string(token) + "'" : std::string(token)) + " expected" +
               std::string(reason);
    }
    return (token.empty() ? "" : "'" + std::string(token) + "': ") + SpellTypes(reason);
}

bool isSummary(std::string_view line)
{
    return line.find("compilation errors.  No code generated") != line.npos ||
           line.find("compilation terminated") != line.npos ||
           line.find("HLSL parsing failed") != line.npos;
}

/// Returns whether glslang reports the error only because of a mistake before it.
bool isConsequence(const Diagnostic& diagnostic, const std::vector<Diagnostic>& earlier)
{
    const bool isAboutReturn =
        diagnostic.message.find("function does not return a value") != std::string::npos;
    return std::ranges::any_of(
        earlier,
        [&](const Diagnostic& known)
        {
            return known.severity == Severity::Error &&
                   (isAboutReturn ||
                    (known.file == diagnostic.file && known.location == diagnostic.location));
        });
}

/// Returns a description of the line behind "Recursion detected:", which is "    f(f1; calling
/// g(f1;".
std::string DescribeRecursion(std::string_view line)
{
    constexpr std::string_view k_Calling = " calling ";
    const auto name = [](std::string_view text)
    {
        text = Trim(text);
        Consume(text, "@");
        return "'" + std::string(text.substr(0, text.find('('))) + "'";
    };
    const std::size_t calling = std::min(line.find(k_Calling), line.size());
    const std::string first = name(line.substr(0, calling));
    const std::string second = name(line.substr(std::min(calling + k_Calling.size(), line.size())));
    return first + ": the HLSL compiler takes it for a function that calls itself" +
           (first == second || second == "''" ? "" : " by way of " + second) +
           "; HLSL has no recursion";
}

} // namespace

void StartGlslang()
{
    static std::once_flag started;
    std::call_once(started, [] { glslang::InitializeProcess(); });
}

EShLanguage GlslangStage(ShaderStage stage)
{
    return stage == ShaderStage::Vertex     ? EShLangVertex
           : stage == ShaderStage::Geometry ? EShLangGeometry
           : stage == ShaderStage::Compute  ? EShLangCompute
                                            : EShLangFragment;
}

void SetEnvironment(glslang::TShader& shader, ShaderStage stage)
{
    shader.setEnvInput(glslang::EShSourceHlsl, GlslangStage(stage), glslang::EShClientVulkan, 100);
    shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_1);
    shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_3);
}

const char* HalfPreamble(bool halfIs16Bit)
{
    static const auto write = [](const std::string& type)
    {
        std::string text;
        for (const std::string size : {"", "1", "2", "3", "4"})
        {
            text += "#define half" + size + " " + type + size + "\n";
        }
        for (const std::string rows : {"1", "2", "3", "4"})
        {
            for (const std::string columns : {"1", "2", "3", "4"})
            {
                const std::string size = rows + "x" + columns;
                text += "#define half" + size + " float" + size + "\n";
            }
        }
        return text;
    };
    static const std::string s_Float = write("float");
    static const std::string s_Half = write("min16float");
    return (halfIs16Bit ? s_Half : s_Float).c_str();
}

std::vector<Diagnostic> ReadGlslangLog(std::string_view log, const std::string& fallbackFile)
{
    constexpr std::ptrdiff_t k_MaxTold = 100; // finding the place of each takes its time
    bool hasMore = false;
    std::vector<Diagnostic> diagnostics;
    while (!log.empty())
    {
        const std::size_t size = std::min(log.find('\n'), log.size());
        std::string_view line = log.substr(0, size);
        log.remove_prefix(std::min(size + 1, log.size()));
        const bool isWarning = Consume(line, "WARNING: ");
        if (!(isWarning || Consume(line, "ERROR: ")) || isSummary(line))
        {
            continue;
        }
        const auto place = ReadPlace(line);
        const bool hasFile = place && place->line > 0;
        Diagnostic diagnostic{isWarning ? Severity::Warning : Severity::Error,
                              hasFile ? SwapMarks(place->file) : fallbackFile,
                              SourceLocation{place ? place->line : 0, 0},
                              CleanMessage(line.substr(place ? place->end : 0))};
        if (diagnostic.message.ends_with("Recursion detected:"))
        {
            diagnostic.message = DescribeRecursion(log.substr(0, log.find('\n')));
        }
        const auto told =
            std::ranges::count(diagnostics, diagnostic.severity, &Diagnostic::severity);
        hasMore = hasMore || told == k_MaxTold;
        if (told < k_MaxTold && !isConsequence(diagnostic, diagnostics))
        {
            diagnostics.push_back(std::move(diagnostic));
        }
    }
    if (hasMore)
    {
        diagnostics.back().message += "; more like it are not shown";
    }
    return diagnostics;
}

} // namespace limn
