#pragma once

#include <exception>
#include <filesystem>
#include <limn/core/Color.h>
#include <limn/core/MaterialPropertyBlock.h>
#include <limn/core/ShaderId.h>
#include <limn/core/ShaderKeyword.h>
#include <limn/shaderlab/ShaderCompiler.h>
#include <limn/shaderlab/ShaderDatabase.h>
#include <limn/shaderlab/ShaderLabDocument.h>
#include <limn/shaderlab/ShaderProgram.h>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace limn
{

/// The promise of a pass for its draws without a mesh, made by the tag "LimnFullScreen", which
/// Unity ignores: they cover their target, and leave no texel as it was except by blending. limn
/// may leave such draws out, or draw a part of them, only as far as that is promised. The value is
/// one of
///
///     True
///     0 0 0 1 where _BlitTexture or _OutlineWidth is 0
///     0 0 0 1 where _BlitTexture or _OutlineWidth is 0 within _OutlineWidth texels
///     _BlitTexture with alpha 1
///
/// The second: the fragment function returns (0, 0, 0, 1) if every component of every texel of one
/// of these textures, or of a vector or number, is 0. The third: it is enough that this holds for
/// so many texels of the texture around its own place (a number or a property; the further texels
/// that bilinear filtering reads need not be counted). The last: it returns the texture's texel at
/// its own place.
struct FullScreenTag
{
    std::vector<ShaderPropertyId> zeroes;
    Color output; ///< linear
    std::optional<ShaderPropertyId> copied;
    /// The number in "within … texels", or else the property; neither = it may look anywhere.
    std::optional<float> reach;
    std::optional<ShaderPropertyId> reachProperty;
};

/// Returns whether the pass has the tag "LimnWithinMesh" = "True": the vertex function moves no
/// vertex from where the object's transform and the camera put it, so that nothing is drawn outside
/// of the object's bounds.
bool StaysWithinMesh(const ShaderLabPass& pass);

/// Returns the value of the pass's tag, or nothing if it has none.
/// @param file  for the message
/// @throws AssetError if the tag has another value, at its place
std::optional<FullScreenTag> ReadFullScreenTag(const ShaderLabPass& pass, const std::string& file);

/// The SubShader of a ShaderLab file that URP draws with (ResolveShader). Its passes are compiled
/// when they are first drawn. Unity: UnityEngine.Shader (2022.3).
class Shader
{
public:
    /// @param database  where UsePass and Fallback look; may be null, and is not needed after the
    ///     call
    /// @throws AssetError if the document has no SubShader to draw with, a UsePass leads nowhere,
    ///     or a LimnFullScreen tag is wrong
    Shader(ShaderLabDocument document, std::shared_ptr<ShaderCompiler> compiler,
           const ShaderDatabase* database = nullptr);

    /// @throws AssetError if the file is missing or does not parse
    static std::shared_ptr<const Shader> Load(const std::filesystem::path& path,
                                              std::shared_ptr<ShaderCompiler> compiler,
                                              const ShaderDatabase* database = nullptr);
    /// Returns the shader of this name, whose passes `compiler` compiles; null if the database has
    /// none. Unity: Shader.Find, which looks in the whole project.
    /// @throws AssetError as the constructor
    static std::shared_ptr<const Shader> Find(std::string_view name, const ShaderDatabase& database,
                                              std::shared_ptr<ShaderCompiler> compiler);
    /// Returns a shader of limn, of plug-ins, of a file that the scene names, or of the scene's
    /// Unity project. It works in a feature's Create and while a camera is rendered (see
    /// ShaderSource). If there is none, it returns null and logs a warning with the nearest name.
    /// @throws AssetError as the constructor
    static std::shared_ptr<const Shader> Find(std::string_view name);
    /// @param file  the name of the text in error messages
    static std::shared_ptr<const Shader> FromText(std::string_view text, std::string file,
                                                  std::shared_ptr<ShaderCompiler> compiler);

    /// Unity: Shader.PropertyToID.
    static ShaderPropertyId PropertyToID(std::string_view name) { return ShaderPropertyId(name); }

    // These set globals for all shaders of the process, until they are set again. They are used if
    // neither draws, materials nor CommandBuffer::SetGlobalFloat and its like in the frame have a
    // value. They hold for what is executed after the call. A value that is not finite and an array
    // without elements throw ContractError naming it. Any thread may call them.
    // Unity: Shader.SetGlobalFloat and its like (2022.3).
    static void SetGlobalFloat(ShaderPropertyId id, float value) { SetGlobal(id, value); }
    static void SetGlobalFloat(ShaderPropertyId id, detail::WholeNumber auto value)
    {
        SetGlobalFloat(id, static_cast<float>(value));
    }
    static void SetGlobalInt(ShaderPropertyId id, int value) { SetGlobal(id, value); }
    static void SetGlobalInteger(ShaderPropertyId id, int value) { SetGlobal(id, value); }
    static void SetGlobalVector(ShaderPropertyId id, const glm::vec4& v) { SetGlobal(id, v); }
    static void SetGlobalVector(ShaderPropertyId id, const detail::MadeVector4 auto& value)
    {
        SetGlobalVector(id, detail::ToVector4(value));
    }
    /// Sets the colour as it is, see CommandBuffer::SetGlobalColor.
    static void SetGlobalColor(ShaderPropertyId id, const Color& v) { SetGlobal(id, v.vector()); }
    static void SetGlobalMatrix(ShaderPropertyId id, const glm::mat4& v) { SetGlobal(id, v); }
    static void SetGlobalFloatArray(ShaderPropertyId id, std::vector<float> values)
    {
        SetGlobal(id, std::move(values));
    }
    static void SetGlobalVectorArray(ShaderPropertyId id, std::vector<glm::vec4> values)
    {
        SetGlobal(id, std::move(values));
    }
    static void SetGlobalMatrixArray(ShaderPropertyId id, std::vector<glm::mat4> values)
    {
        SetGlobal(id, std::move(values));
    }
    /// @param value  kept until another one is set; null = the shader's default
    static void SetGlobalTexture(ShaderPropertyId id, std::shared_ptr<const Texture> value)
    {
        SetGlobal(id, std::move(value));
    }
    static void SetGlobalTexture(ShaderPropertyId id, const RTHandle& value);
    // Buffers behave as those of MaterialPropertyBlock; null = none.
    static void SetGlobalBuffer(ShaderPropertyId id, std::shared_ptr<const GraphicsBuffer> value)
    {
        SetGlobal(id, BufferRange{std::move(value), 0, 0});
    }
    static void SetGlobalConstantBuffer(ShaderPropertyId id,
                                        std::shared_ptr<const GraphicsBuffer> value, int offset,
                                        int size)
    {
        SetGlobal(id, ConstantRange(std::move(value), offset, size));
    }

    // These return the value that those functions set last; zeros or null if they set nothing, or
    // something of another kind. They do not return what command buffers set, which belongs to a
    // frame. Unity: Shader.GetGlobalFloat and its like (2022.3).
    static float GetGlobalFloat(ShaderPropertyId id) { return LockedGlobals()->GetFloat(id); }
    static int GetGlobalInt(ShaderPropertyId id) { return LockedGlobals()->GetInt(id); }
    static int GetGlobalInteger(ShaderPropertyId id) { return GetGlobalInt(id); }
    static glm::vec4 GetGlobalVector(ShaderPropertyId id) { return LockedGlobals()->GetVector(id); }
    static Color GetGlobalColor(ShaderPropertyId id); ///< as it is
    static glm::mat4 GetGlobalMatrix(ShaderPropertyId id) { return LockedGlobals()->GetMatrix(id); }
    static std::shared_ptr<const Texture> GetGlobalTexture(ShaderPropertyId id)
    {
        return LockedGlobals()->GetTexture(id);
    }
    static std::vector<float> GetGlobalFloatArray(ShaderPropertyId id)
    {
        return LockedGlobals()->GetFloatArray(id);
    }
    static std::vector<glm::vec4> GetGlobalVectorArray(ShaderPropertyId id)
    {
        return LockedGlobals()->GetVectorArray(id);
    }
    static std::vector<glm::mat4> GetGlobalMatrixArray(ShaderPropertyId id)
    {
        return LockedGlobals()->GetMatrixArray(id);
    }

    /// Switches a keyword for all materials of the process. CommandBuffer::EnableShaderKeyword,
    /// which does the same, takes precedence in the frame.
    /// @source Unity: Shader.EnableKeyword and its like (2022.3)
    static void EnableKeyword(std::string_view keyword)
    {
        SetKeyword(GlobalKeyword(keyword), true);
    }
    static void DisableKeyword(std::string_view keyword)
    {
        SetKeyword(GlobalKeyword(keyword), false);
    }
    static void EnableKeyword(const GlobalKeyword& keyword) { SetKeyword(keyword, true); }
    static void DisableKeyword(const GlobalKeyword& keyword) { SetKeyword(keyword, false); }
    static void SetKeyword(const GlobalKeyword& keyword, bool value)
    {
        SetGlobal(keyword.id(), value ? 1 : 0);
    }
    /// Returns what EnableKeyword and DisableKeyword set last; command buffers do not change it.
    static bool IsKeywordEnabled(std::string_view keyword);

    std::uint64_t id() const { return m_Id; } ///< unique in the process
    const std::string& name() const { return m_Document.name; }
    const ShaderLabDocument& document() const { return m_Document; }
    int renderQueue() const { return m_RenderQueue; } ///< of the Queue tag, 0...5000
    int passCount() const { return static_cast<int>(m_SubShader.passes.size()); }
    /// Returns the SubShader that it draws with, in which each UsePass is replaced by the pass that
    /// it names. It lives as long as the shader.
    const ShaderLabSubShader& subShader() const { return m_SubShader; }

    /// Returns the index of the first pass of this LightMode, or -1. A pass without the tag counts
    /// as SRPDefaultUnlit.
    int FindPassByLightMode(ShaderTagId lightMode) const;
    /// Returns the index of the pass of this name (case does not matter), or -1.
    int FindPassByName(std::string_view passName) const;

    const RenderState& passState(int passIndex) const { return PassAt(passIndex).state; }
    const std::string& passName(int passIndex) const { return PassAt(passIndex).name; }
    /// Returns the pass's LightMode; "SRPDefaultUnlit" if it has none.
    std::string_view passLightMode(int passIndex) const { return PassAt(passIndex).lightMode(); }

    /// Returns the promise of the pass's tag LimnFullScreen; null = none. It lives as long as the
    /// shader.
    const FullScreenTag* fullScreenTag(int passIndex) const;
    /// Returns whether the pass has the tag LimnWithinMesh.
    bool staysWithinMesh(int passIndex) const
    {
        return m_StaysWithinMesh.at(static_cast<std::size_t>(passIndex));
    }

    /// Returns the compiler of the passes; other shaders may be made with it.
    const std::shared_ptr<ShaderCompiler>& compiler() const { return m_Compiler; }
    /// Returns the depth direction that it expects, see ShaderCompilerOptions.
    bool usesReversedZBuffer() const { return !m_Compiler || m_Compiler->usesReversedZBuffer(); }

    /// Returns the index of the property with this name; -1 = none.
    /// @source Unity: Shader.FindPropertyIndex (2022.3)
    int FindPropertyIndex(std::string_view propertyName) const;
    /// Returns true, since a SubShader was found; whether a pass compiles is known when it is
    /// drawn.
    bool isSupported() const { return true; }
    /// Returns the keywords that a new material has on, by the defaults of its properties.
    const std::vector<std::string>& initialKeywords() const { return m_InitialKeywords; }
    /// Returns whether a pass has this keyword. Unity: Shader.keywordSpace.
    bool HasKeyword(std::string_view keyword) const;

    /// Returns the keywords that Compile sets, sorted: of each set the first that is `enabled`,
    /// else its default. Without `enabled`, the initial keywords are used.
    /// @throws ContractError naming the shader, if there is no such pass
    std::vector<std::string> keywords(int passIndex, std::span<const std::string> enabled,
                                      std::span<const std::string> globalKeywords = {}) const;
    std::vector<std::string> keywords(int passIndex) const
    {
        return keywords(passIndex, m_InitialKeywords);
    }

    /// Returns the program of the pass, ready to draw; it is compiled on the first call. Any thread
    /// may call it. Equal variants are one object; a thread that needs one that is being compiled
    /// waits for that one only. Without `enabled`, the initial keywords are used. A variant that
    /// does not compile is not tried again: load the shader anew.
    /// @throws AssetError with the HLSL errors at their lines
    /// @throws ContractError naming the shader, if there is no such pass
    std::shared_ptr<const ShaderProgram> Compile(int passIndex) const;
    std::shared_ptr<const ShaderProgram>
    Compile(int passIndex, std::span<const std::string> enabled,
            std::span<const std::string> globalKeywords = {}) const;

private:
    /// One variant of one pass.
    struct Variant
    {
        std::mutex mutex; ///< held while it is compiled
        std::shared_ptr<const ShaderProgram> compiled;
        std::exception_ptr failure; ///< of the one attempt; a frame asks again for each object
    };

    /// The programs of a pass that keywords chose last, because choosing costs more than a draw
    /// should.
    struct LastChoices
    {
        struct Choice
        {
            std::vector<std::string> enabled;
            std::vector<std::string> globals;
            std::shared_ptr<const ShaderProgram> compiled;
        };
        mutable std::mutex mutex;
        std::vector<Choice> choices;
        std::size_t next = 0; ///< the next one to be replaced
    };

    static void SetGlobal(ShaderPropertyId id, ShaderPropertyValue value);
    struct LockedValues
    {
        std::unique_lock<std::mutex> lock;
        const MaterialPropertyBlock& values;
        const MaterialPropertyBlock* operator->() const { return &values; }
    };
    /// Returns the values of the process, which no other thread changes until the result is gone.
    static LockedValues LockedGlobals();
    const ShaderLabPass& PassAt(int passIndex) const;
    std::shared_ptr<const ShaderProgram>
    CompileVariant(int passIndex, const std::vector<std::string>& variant) const;
    std::shared_ptr<const ShaderProgram> Choose(int passIndex, std::span<const std::string> enabled,
                                                std::span<const std::string> globalKeywords) const;
    template <typename Compilation>
    static std::shared_ptr<const ShaderProgram> Once(Variant& variant, const Compilation& compile);

    std::uint64_t m_Id;
    ShaderLabDocument m_Document;
    std::shared_ptr<ShaderCompiler> m_Compiler;
    std::vector<std::string> m_InitialKeywords;
    ShaderLabSubShader m_SubShader;
    std::vector<ShaderTagId> m_LightModes;                  ///< by pass
    std::vector<std::optional<FullScreenTag>> m_FullScreen; ///< by pass
    std::vector<bool> m_StaysWithinMesh;                    ///< by pass
    int m_RenderQueue = 2000;
    mutable std::vector<Variant> m_Initial;         ///< by pass
    mutable std::vector<LastChoices> m_LastChoices; ///< by pass
    mutable std::mutex m_Mutex;                     ///< guards the map, not what is in it
    mutable std::map<std::pair<int, std::vector<std::string>>, Variant> m_Others;
};

} // namespace limn
