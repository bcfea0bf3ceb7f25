#pragma once

#include <limn/editor_stub/AssetContext.h>
#include <limn/volume/AssetDiagnostics.h>
#include <limn/volume/YamlRead.h>
#include <vector>

namespace limn
{

/// The places that references may lead to.
enum class ReferenceScope
{
    Roots,   ///< the roots of the AssetContext and the file's own folder, for references in files
    Anywhere ///< anywhere, for references that a person typed
};

/// The end of a message about a reference that leads out of the roots, with the remedy.
inline constexpr const char* k_OutsideRoots =
    "lies outside the folders that references may lead into; move it below the scene's folder, or "
    "name its folder by --root DIR";

/// Loads the files that a file refers to. If something is wrong with one of them, that becomes an
/// error at the place that refers to it, and the file's own errors follow that error.
class References
{
public:
    /// @param folders      the folders that relative paths start from; the first one that has the
    ///     file counts
    /// @param assets, diagnostics  must outlive this
    References(AssetContext& assets, std::vector<std::filesystem::path> folders,
               AssetDiagnostics& diagnostics, ReferenceScope scope = ReferenceScope::Roots);

    /// Returns what `load` returns for the path in a node. Returns an empty result and adds an
    /// error if `load` throws an AssetError, the node is no text or the path leads out of the
    /// roots.
    template <typename Load>
    auto Read(const YamlNode& node, std::string_view subject, Load&& load)
        -> decltype(load(std::filesystem::path()))
    {
        const std::optional<std::string> text = ReadString(node, subject, m_Diagnostics);
        try
        {
            const std::filesystem::path path = text ? Resolve(*text) : std::filesystem::path();
            return text && isAllowed(path, node, subject) && isThere(path, *text, node, subject)
                       ? load(path)
                       : decltype(load(std::filesystem::path()))();
        }
        catch (const AssetError& error)
        {
            Report(node, subject, error);
            return {};
        }
    }

    /// Returns a shader by its ShaderLab name or by the path of a .shader file. Returns null and
    /// adds an error if there is none.
    std::shared_ptr<const Shader> ReadShader(const YamlNode& node, const std::string& subject);

    /// Returns the picture of a file. Returns null and adds an error if there is none.
    std::shared_ptr<const Texture2D> ReadPicture(const YamlNode& node, const std::string& subject);

    /// Returns a new compute shader of a .compute file. Returns null and adds an error if there is
    /// none.
    std::shared_ptr<const ComputeShader> ReadComputeShader(const YamlNode& node,
                                                           const std::string& subject);

    std::filesystem::path Resolve(const std::string& text) const;

    /// Returns whether a reference may lead to this file, and adds an error at the node if not.
    bool isAllowed(const std::filesystem::path& path, const YamlNode& node,
                   std::string_view subject);

    /// Returns true if a file is there, or if no other file has a similar name. Otherwise adds an
    /// error with the name that may be meant, and returns false.
    bool isThere(const std::filesystem::path& path, const std::string& text, const YamlNode& node,
                 std::string_view subject);

    /// @throws AssetError with every error so far; the errors of a file come behind the first
    ///     reference to it
    void ThrowIfErrors() const;

    /// Adds an error at `node`, a reference, for what is wrong with the file that it stands for.
    void Report(const YamlNode& node, std::string_view subject, const AssetError& error);

    AssetContext& assets() { return m_Assets; }

    /// If this is set, pictures are decoded. Otherwise a file that begins as a PNG file counts as
    /// right, and a stand-in of one texel is read in its place.
    bool decodesPictures = true;

private:
    struct Failure
    {
        SourceLocation location; ///< the place of the reference
        std::vector<Diagnostic> errors;
    };

    AssetContext& m_Assets;
    std::vector<std::filesystem::path> m_Folders;
    FileRoots m_OwnRoots; ///< m_Folders
    AssetDiagnostics& m_Diagnostics;
    ReferenceScope m_Scope;
    std::vector<Failure> m_Failures;
};

} // namespace limn
