#pragma once

#include <limn/editor_stub/SceneFile.h>

namespace limn
{

/// Returns a sentence, without its end, about a shader that has a pass of the built-in pipeline and
/// none that URP draws. Returns "" for any other. Unity's editor draws the light modes that count
/// here in magenta (URP 14, RenderingUtils).
std::string BuiltInPassOf(const Shader& shader);

/// Returns a shader that draws any mesh in plain, unlit magenta. It replaces a shader that does not
/// compile. Unity: Hidden/Core/FallbackError (URP 14).
std::shared_ptr<const Shader> MakeErrorShader(const std::shared_ptr<ShaderCompiler>& compiler);

/// Returns a shader that draws any mesh in one colour, unlit.
/// @param color  four linear numbers: "1, 0, 1, 1"
std::shared_ptr<const Shader> MakePlainShader(const std::string& color,
                                              const std::shared_ptr<ShaderCompiler>& compiler);

/// Compiles what rendering a scene needs: the passes of objects' shaders that the renderer draws,
/// and every pass of the shaders of active features. Different shaders compile at the same time.
/// In a scene of Unity's, objects whose shader does not compile become magenta, as in Unity, and
/// features with such a shader become inactive.
/// @return notes about what became magenta or inactive
/// @throws AssetError with the errors of all shaders, in any other scene
std::vector<Diagnostic> CompileUsedShaders(SceneAsset& asset);

/// Compiles the same as CompileUsedShaders. Objects whose shader does not compile get the magenta
/// error shader, in their material's queue.
/// @return the errors of those shaders
/// @throws AssetError with the errors of all shaders if one is a feature's, since its draws would
///     show nothing useful in magenta
std::vector<Diagnostic> CompileOrReplaceShaders(SceneAsset& asset,
                                                const std::shared_ptr<ShaderCompiler>& compiler);

/// Does the rest of what CompileUsedShaders begins, for a scene of Unity's whose frame has ended
/// with an AssetError: compiles every pass of the objects' shaders with the keywords of their
/// materials. Objects whose shader does not compile become magenta.
/// @return notes about what became magenta
std::vector<Diagnostic> ReplaceBrokenShaders(SceneAsset& asset);

} // namespace limn
