#pragma once

#include <filesystem>
#include <limn/core/ShaderId.h>
#include <limn/shaderlab/CompiledPass.h>
#include <limn/shaderlab/ShaderCompiler.h>
#include <limn/shaderlab/ShaderLabDocument.h>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace limn
{

/// A ShaderLab file's first usable SubShader, its passes compiled when first drawn.
/// Unity: UnityEngine.Shader (2022.3).
class Shader
{
public:
    /// @throws AssetError if the document has no SubShader with a pass
    Shader(ShaderLabDocument document, std::shared_ptr<ShaderCompiler> compiler);

    /// @throws AssetError if the file is missing or does not parse
    static std::shared_ptr<const Shader> Load(const std::filesystem::path& path,
                                              std::shared_ptr<ShaderCompiler> compiler);
    /// @param file  what error messages call the text
    static std::shared_ptr<const Shader> FromText(std::string_view text, std::string file,
                                                  std::shared_ptr<ShaderCompiler> compiler);

    /// Unity: Shader.PropertyToID.
    static ShaderPropertyId PropertyToID(std::string_view name) { return ShaderPropertyId(name); }

    std::uint64_t id() const { return m_Id; } ///< unique in the process
    const std::string& name() const { return m_Document.name; }
    const ShaderLabDocument& document() const { return m_Document; }
    int renderQueue() const { return m_RenderQueue; } ///< of the Queue tag, 0...5000
    int passCount() const { return static_cast<int>(m_Passes.size()); }

    /// The index of the first pass of this LightMode, or -1. A pass without the tag counts as
    /// SRPDefaultUnlit.
    int FindPassByLightMode(ShaderTagId lightMode) const;
    /// The index of the pass of this name (case does not matter), or -1.
    int FindPassByName(std::string_view passName) const;

    const RenderState& passState(int passIndex) const;
    const std::string& passName(int passIndex) const;
    /// The pass's LightMode; "SRPDefaultUnlit" where it has none.
    std::string_view passLightMode(int passIndex) const;

    /// What compiles the passes; other shaders may be made with it.
    const std::shared_ptr<ShaderCompiler>& compiler() const { return m_Compiler; }

    /// The pass ready to draw; compiled on the first call, any thread.
    /// @throws AssetError with the HLSL errors at their lines
    /// @throws ContractError naming the shader, if there is no such pass
    std::shared_ptr<const CompiledPass> Compile(int passIndex) const;

private:
    struct Pass
    {
        const ShaderLabPass* declaration = nullptr;
        ShaderTagId lightMode;
    };
    const Pass& PassAt(int passIndex) const;

    std::uint64_t m_Id;
    ShaderLabDocument m_Document;
    std::shared_ptr<ShaderCompiler> m_Compiler;
    int m_RenderQueue = 2000;
    std::vector<Pass> m_Passes;
    mutable std::mutex m_Mutex;
    mutable std::vector<std::shared_ptr<const CompiledPass>> m_Compiled;
};

} // namespace limn
