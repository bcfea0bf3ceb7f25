#include <limn/shaderlab/ProgramRequirements.h>

#include "keywords/DynamicKeywords.h"
#include "keywords/PragmaScanner.h"
#include <limn/base/Text.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <set>
#include <string_view>

namespace limn
{

namespace
{

struct ShaderModel
{
    int target;
    std::string_view features; ///< without those of shader model 3.5, which all above it have
};
constexpr std::string_view k_Model35 =
    "derivatives interpolators10 samplelod fragcoord interpolators15 mrt4 integers 2darray "
    "instancing";
constexpr std::array<ShaderModel, 8> k_ShaderModels = {{
    {0, ""},
    {25, "derivatives"},
    {30, "derivatives interpolators10 samplelod fragcoord"},
    {35, ""},
    {40, "geometry"},
    {45, "compute randomwrite msaatex"},
    {46, "geometry cubearray tesshw tessellation msaatex"},
    {50, "geometry compute randomwrite msaatex tesshw tessellation"},
}};

// Vulkan has no way to fetch from the target that fits HLSL's, and limn streams no textures.
constexpr std::array<std::string_view, 4> k_NeverThere = {"fbfetch", "framebufferfetch",
                                                          "inlineraytracing", "sparsetex"};

/// The words of a text up to a ":" in it.
std::vector<std::string> Words(std::string_view text)
{
    std::vector<std::string> words;
    text = text.substr(0, text.find(':'));
    while (!(text = Trim(text)).empty())
    {
        const std::string_view word = text.substr(0, text.find_first_of(" \t\r\f\v,"));
        words.push_back(ToLower(word));
        text.remove_prefix(std::min(word.size() + 1, text.size()));
    }
    std::erase(words, "");
    return words;
}

const std::vector<std::string> k_Features =
    Words("interpolators10 interpolators15 interpolators32 integers mrt4 mrt8 derivatives "
          "samplelod fragcoord 2darray cubearray instancing geometry compute randomwrite uav "
          "tesshw tessellation msaatex sparsetex framebufferfetch fbfetch "
          "setrtarrayindexfromanyshader wavevote waveballot wavebasic wavemath wavemultiprefix "
          "quadshuffle native16bit int64bufferatomics int64groupsharedatomics barycentrics "
          "multiview inlineraytracing");

const std::vector<std::string> k_Renderers =
    Words("d3d11 d3d12 glcore gles gles3 metal vulkan webgpu ps4 ps5 xboxone xboxseries "
          "gamecorexboxone gamecorexboxseries playstation switch switch2 d3d9 d3d11_9x xbox360 "
          "ps3 psp2 psm wiiu n3ds flash nomrt opengl glcore32 d3d11_50 stadia ggp");

const std::vector<std::string> k_Pragmas = []
{
    std::vector<std::string> names = Words(
        "vertex fragment geometry hull domain surface lighting raytracing kernel target require "
        "skip_variants only_renderers exclude_renderers instancing_options enable_cbuffer "
        "enable_d3d11_debug_symbols skip_optimizations hlslcc_bytecode_disassembly "
        "disable_fastmath glsl_es2 glsl hardware_tier_variants prefer_hlslcc fragmentoption "
        "profileoption glsl_no_auto_normalization use_dxc never_use_dxc editor_sync_compilation "
        "include_with_pragmas warning pack_matrix once rendertarget_format_hint disablepc "
        "option regcount optimize debug def");
    std::ranges::move(KeywordDirectives(), std::back_inserter(names));
    return names;
}();

void AddModel(int target, std::set<std::string>& features)
{
    const auto above = std::ranges::upper_bound(k_ShaderModels, target, {}, &ShaderModel::target);
    for (const std::string_view list : {std::prev(above)->features, target >= 35 ? k_Model35 : ""})
    {
        const auto words = Words(list);
        features.insert(words.begin(), words.end());
    }
}

bool Contains(const std::vector<std::string>& list, std::string_view word)
{
    return std::ranges::find(list, word) != list.end();
}

bool Contains(const PassProgram& program, std::string_view pragma)
{
    return std::ranges::find(program.pragmas, pragma, &ProgramPragma::name) !=
           program.pragmas.end();
}

/// The sentence for a pragma that asks for something limn never does.
std::optional<std::string> ReasonOf(const PassProgram& program, const ProgramPragma& pragma)
{
    if (pragma.name == "surface")
    {
        return "#pragma surface: surface shaders are not supported; write a vertex and a fragment "
               "function";
    }
    if (pragma.name == "raytracing")
    {
        return "#pragma raytracing: ray tracing is not supported; limn draws with a vertex and a "
               "fragment function";
    }
    if (pragma.name == "kernel" && program.kernel.name.empty())
    {
        return "#pragma kernel: a pass of a .shader file draws with a vertex and a fragment "
               "function; kernels stand in a .compute file";
    }
    if (pragma.name == "hull" || pragma.name == "domain")
    {
        const std::string other = pragma.name == "hull" ? "domain" : "hull";
        if (!Contains(program, other))
        {
            return "#pragma " + pragma.name + ": there is no #pragma " + other +
                   "; tessellation needs both";
        }
    }
    const std::vector<std::string> words = Words(pragma.arguments);
    if (pragma.name == "exclude_renderers" && Contains(words, "vulkan"))
    {
        return "#pragma exclude_renderers: Vulkan is among the renderers that this program is not "
               "for; remove 'vulkan'";
    }
    // The picture that people know is often that of Unity's editor on Windows.
    if (pragma.name == "only_renderers" && !Contains(words, "vulkan") && !Contains(words, "d3d11"))
    {
        return "#pragma only_renderers: neither Vulkan nor Direct3D 11 is among the renderers that "
               "this program is for; add 'vulkan'";
    }
    return std::nullopt;
}

void CheckWords(const PassProgram& program, const ProgramPragma& pragma,
                const std::vector<std::string>& known, std::string_view kind,
                std::vector<Diagnostic>& warnings)
{
    for (const std::string& word : Words(pragma.arguments))
    {
        if (Contains(known, word))
        {
            continue;
        }
        warnings.push_back({Severity::Warning, program.file, pragma.location,
                            "#pragma " + pragma.name + ": there is no " + std::string(kind) + " '" +
                                word + "'" + DidYouMean(word, {known.begin(), known.end()})});
    }
}

} // namespace

std::vector<std::string> RequiredFeatures(const PassProgram& program)
{
    std::set<std::string> features;
    AddModel(program.target, features);
    if (!program.kernel.name.empty())
    {
        features = {"compute"}; // models say the most of what stages can, and it has one
    }
    if (!program.geometry.name.empty())
    {
        AddModel(40, features);
    }
    for (const ProgramPragma& pragma : program.pragmas)
    {
        if (pragma.name == "require" && pragma.arguments.find(':') == std::string::npos)
        {
            const auto words = Words(pragma.arguments);
            features.insert(words.begin(), words.end());
        }
    }
    return {features.begin(), features.end()};
}

std::optional<Diagnostic> ReasonNotSupported(const PassProgram& program,
                                             std::span<const std::string> missingFeatures)
{
    if (program.language == ProgramLanguage::Glsl)
    {
        return Diagnostic{Severity::Error, program.file, program.location,
                          "GLSLPROGRAM: it is not supported; write the pass in HLSL"};
    }
    for (const ProgramPragma& pragma : program.pragmas)
    {
        if (const auto reason = ReasonOf(program, pragma))
        {
            return Diagnostic{Severity::Error, program.file, pragma.location, *reason};
        }
    }
    for (const std::string& feature : RequiredFeatures(program))
    {
        const bool isNever = std::ranges::find(k_NeverThere, feature) != k_NeverThere.end();
        const bool isOfKernels = !program.kernel.name.empty() &&
                                 (feature.starts_with("wave") || feature == "quadshuffle");
        const bool isMissing =
            std::ranges::count(missingFeatures, isOfKernels ? "compute " + feature : feature) > 0;
        if (isNever || isMissing)
        {
            return Diagnostic{Severity::Error, program.file, program.location,
                              "program: it requires '" + feature + "', which " +
                                  (isNever ? "limn does not offer" : "this device does not have")};
        }
    }
    return std::nullopt;
}

std::vector<Diagnostic> CheckPragmas(const PassProgram& program)
{
    std::vector<Diagnostic> warnings = CheckDynamicKeywords(program);
    for (const ProgramPragma& pragma : program.pragmas)
    {
        if (pragma.name == "require")
        {
            CheckWords(program, pragma, k_Features, "feature", warnings);
        }
        else if (pragma.name == "only_renderers" || pragma.name == "exclude_renderers")
        {
            CheckWords(program, pragma, k_Renderers, "renderer", warnings);
        }
        else if (pragma.name == "target")
        {
            warnings.push_back({Severity::Warning, program.file, pragma.location,
                                "#pragma target: '" + pragma.arguments +
                                    "' is no shader model; write a number from 2.0 to 5.0"});
        }
        else if (!Contains(k_Pragmas, pragma.name) && pragma.name.substr(0, 5) != "PSSL_")
        {
            const std::string meant = DidYouMean(pragma.name, {k_Pragmas.begin(), k_Pragmas.end()});
            warnings.push_back({Severity::Warning, program.file, pragma.location,
                                "#pragma " + pragma.name + ": there is no such pragma" +
                                    (meant.empty() ? "; it has no effect" : meant)});
        }
    }
    return warnings;
}

} // namespace limn
