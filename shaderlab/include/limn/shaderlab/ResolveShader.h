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

/// Passes that are looked for in the Fallback where the chosen SubShader lacks them.
inline constexpr std::array<std::string_view, 2> k_FallbackLightModes = {"ShadowCaster", "Meta"};

/// What a SubShader is chosen by.
struct ShaderCriteria
{
    /// SubShaders of a higher LOD are passed over. Unity: Shader.globalMaximumLOD.
    int maximumLod = std::numeric_limits<int>::max();
    /// Features (RequiredFeatures) that the device lacks.
    std::vector<std::string> missingFeatures = {};
    /// Versions that PackageRequirements are held against; limn stands for these.
    std::map<std::string, std::string, std::less<>> packages = {
        {"unity", "2022.3.0f1"},
        {"com.unity.render-pipelines.core", "14.0.0"},
        {"com.unity.render-pipelines.universal", "14.0.0"}};
};

/// The SubShader that a shader draws with, ready to use.
struct ResolvedShader
{
    /// "" = the shader's own; else the name of the shader that its Fallback led to.
    std::string fallback;
    int subShaderIndex = 0; ///< among those of that shader
    /// A copy. A UsePass has become the pass it names; passes whose PackageRequirements do not hold
    /// are left out; a GrabPass stays, so that the indices of the others are Unity's, and is never
    /// drawn. Behind its own passes stand those of k_FallbackLightModes that only a Fallback has.
    ShaderLabSubShader subShader;
    /// Why other SubShaders and passes were left out, in the order of the file; severity Note.
    std::vector<Diagnostic> notes;
    /// Of each UsePass that leads nowhere; it stays in the list of passes.
    std::vector<Diagnostic> errors;
};

/// Chooses the first SubShader that is for URP or for any pipeline, whose LOD, PackageRequirements
/// and programs suit; then those of the Fallback. If only the programs stand in the way everywhere,
/// the shader's first such SubShader is taken all the same: compiling tells why each pass cannot be
/// drawn. Pragmas behind `#include_with_pragmas` are not looked at.
///
/// @param database  where UsePass and Fallback look; may be null
/// @throws AssetError with the reason of every SubShader, if there is none to draw with
ResolvedShader ResolveShader(const ShaderLabDocument& document, const ShaderDatabase* database,
                             const ShaderCriteria& criteria = {});

/// The pass that a UsePass of the document leads to, taken from the SubShader that its shader draws
/// with.
///
/// @param errors  gets why there is none, at the place of the UsePass
std::optional<ShaderLabPass> ResolveUsePass(const ShaderLabDocument& document,
                                            const ShaderLabPass& usePass,
                                            const ShaderDatabase* database,
                                            std::vector<Diagnostic>& errors,
                                            const ShaderCriteria& criteria = {});

} // namespace limn
