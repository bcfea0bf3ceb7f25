#pragma once

#include <limn/shaderlab/ShaderDatabase.h>

#include <array>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

/// The passes that are searched in the Fallback if the chosen SubShader lacks them.
inline constexpr std::array<std::string_view, 2> k_FallbackLightModes = {"ShadowCaster", "Meta"};

/// The criteria by which a SubShader is chosen.
struct ShaderCriteria
{
    /// The greatest LOD; SubShaders with a higher one are skipped. Unity: Shader.globalMaximumLOD.
    int maximumLod = std::numeric_limits<int>::max();
    /// The features (RequiredFeatures) that the device lacks.
    std::vector<std::string> missingFeatures = {};
    /// The versions that PackageRequirements are compared with; limn stands for these.
    std::map<std::string, std::string, std::less<>> packages = {
        {"unity", "2022.3.0f1"},
        {"com.unity.render-pipelines.core", "14.0.0"},
        {"com.unity.render-pipelines.universal", "14.0.0"}};
};

/// The SubShader that a shader draws with, ready to use.
struct ResolvedShader
{
    /// "" = the SubShader is the shader's own; otherwise the name of the shader that its Fallback
    /// led to.
    std::string fallback;
    int subShaderIndex = 0; ///< among those of that shader
    /// A copy of the SubShader. A UsePass is replaced by the pass it names; passes whose
    /// PackageRequirements do not hold are removed; a GrabPass stays, so that the indices of the
    /// others are Unity's, but is never drawn. Its own passes are followed by those of
    /// k_FallbackLightModes that only a Fallback has.
    ShaderLabSubShader subShader;
    /// The reasons why other SubShaders and passes were left out, in the order of the file;
    /// severity Note.
    std::vector<Diagnostic> notes;
    /// The errors of each UsePass that leads nowhere; it stays in the list of passes.
    std::vector<Diagnostic> errors;
};

/// Chooses the first SubShader for URP or for any pipeline whose LOD, PackageRequirements and
/// programs suit, then one of the Fallback. If everywhere only the programs do not suit, the
/// shader's first such SubShader is chosen nevertheless, and compiling reports why each pass cannot
/// be drawn. Pragmas behind `#include_with_pragmas` are ignored.
///
/// @param database  the shaders that UsePass and Fallback can name; may be null
/// @throws AssetError with the reason of every SubShader, if there is none to draw with
ResolvedShader ResolveShader(const ShaderLabDocument& document, const ShaderDatabase* database,
                             const ShaderCriteria& criteria = {});

/// Returns the pass that a UsePass of the document leads to, from the SubShader with which its
/// shader draws.
///
/// @param errors  receives the reason if there is none, at the place of the UsePass
std::optional<ShaderLabPass> ResolveUsePass(const ShaderLabDocument& document,
                                            const ShaderLabPass& usePass,
                                            const ShaderDatabase* database,
                                            std::vector<Diagnostic>& errors,
                                            const ShaderCriteria& criteria = {});

} // namespace limn
