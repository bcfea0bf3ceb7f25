#pragma once

#include <limn/base/EmbeddedFile.h>
#include <limn/shaderlab/ShaderLabDocument.h>

#include <filesystem>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

/// The ShaderLab documents by the name behind `Shader`, for Shader::Find, UsePass and Fallback.
/// Const members may be called from several threads at once.
class ShaderDatabase
{
public:
    /// Adds every .shader file below a folder, in the order of their paths. Files that cannot be
    /// read or have errors are skipped; using them by their path reports the errors.
    void AddFolder(const std::filesystem::path& folder);

    /// Adds a document. If there is already one with its name, that one stays.
    void Add(std::shared_ptr<const ShaderLabDocument> document);

    /// Adds all documents of another database.
    void Add(const ShaderDatabase& other);

    /// Adds files that are compiled into a program; the documents have the names of the files.
    /// @throws AssetError if a file does not parse
    void Add(std::span<const EmbeddedFile> files);

    /// Returns the document of that name, or null if there is none. Case counts, as in Unity.
    const ShaderLabDocument* Find(std::string_view name) const;

    /// Returns the document that lends its passes where UsePass or Fallback has this name, or null
    /// if there is none. For a shader of Unity's built-in pipeline ("Diffuse") that Find does not
    /// know, it is limn's document that casts the same shadow: "Hidden/Limn/VertexLit" or
    /// "Hidden/Limn/CutoutVertexLit".
    /// @source Unity: the built-in shaders and their Fallbacks (2022.3)
    const ShaderLabDocument* FindLender(std::string_view name) const;

    /// Returns a document whose file has this name ("Toon.shader"), in any folder, or null if there
    /// is none.
    const ShaderLabDocument* FindFile(std::string_view filename) const;

    std::vector<std::string_view> names() const; ///< sorted

    /// Returns "'Toom'; did you mean 'Toon'?" for messages about a name that Find does not know.
    std::string UnknownShader(std::string_view name) const;

    std::size_t size() const { return m_Documents.size(); }

private:
    std::map<std::string, std::shared_ptr<const ShaderLabDocument>, std::less<>> m_Documents;
};

/// Returns the .shader files below a folder, sorted by path; links to folders are not followed.
std::vector<std::filesystem::path> FindShaderFiles(const std::filesystem::path& folder);

} // namespace limn
