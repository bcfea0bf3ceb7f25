#pragma once

#include <limn/editor_stub/AssetContext.h>
#include <limn/volume/AssetDiagnostics.h>
#include <limn/volume/YamlRead.h>
#include <vector>

namespace limn
{

/// Where references may lead.
enum class ReferenceScope
{
    Roots,   ///< into the roots of the AssetContext and the file's own folder: those of files
    Anywhere ///< those that a person typed
};

/// What to do about a reference that leads out of the roots.
inline constexpr const char* k_OutsideRoots =
    "lies outside the folders that references may lead into; move it below the scene's folder, or "
    "name its folder by --root DIR";

/// Loads the files that a file refers to. What is wrong with one of them becomes an error at the
/// place that refers to it, and its own errors follow that one.
class References
{
public:
    /// @param folders      where relative paths start from; the first that has the file counts
    /// @param assets, diagnostics  must outlive this
    References(AssetContext& assets, std::vector<std::filesystem::path> folders,
               AssetDiagnostics& diagnostics, ReferenceScope scope = ReferenceScope::Roots);

    /// What `load` gives for the path in a node; an empty result, with an error, if it throws an
    /// AssetError, the node is no text or the path leads out of the roots.
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

    /// A shader by ShaderLab name, or by the path of a .shader file; null, with an error, if there
    /// is none.
    std::shared_ptr<const Shader> ReadShader(const YamlNode& node, const std::string& subject);

    std::filesystem::path Resolve(const std::string& text) const;

    /// Whether a reference may lead to this file; an error at the node if not.
    bool isAllowed(const std::filesystem::path& path, const YamlNode& node,
                   std::string_view subject);

    /// Returns whether a file is there, or no other has a name like its; else adds an error with
    /// the name that may be meant.
    bool isThere(const std::filesystem::path& path, const std::string& text, const YamlNode& node,
                 std::string_view subject);

    /// @throws AssetError with every error so far, those of a file behind the first reference to it
    void ThrowIfErrors() const;

    /// An error at `node`, a reference, for what is wrong with the file it stands for.
    void Report(const YamlNode& node, std::string_view subject, const AssetError& error);

    AssetContext& assets() { return m_Assets; }

    /// It says whether pictures are decoded. If not, a file that begins as a PNG file is right,
    /// and a stand-in of one texel is what is read.
    bool decodesPictures = true;

private:
    struct Failure
    {
        SourceLocation location; ///< of the reference
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
