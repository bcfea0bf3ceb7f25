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

/// ShaderLab documents by the name behind `Shader`, for Shader::Find, UsePass and Fallback. Const
/// members may be called from several threads at once.
class ShaderDatabase
{
public:
    /// Adds every .shader file below a folder, in the order of their paths. Files that cannot be
    /// read or have errors are passed over: who uses them by their path is told.
    void AddFolder(const std::filesystem::path& folder);

    /// Of documents of equal names the one that came first stays.
    void Add(std::shared_ptr<const ShaderLabDocument> document);

    /// Adds all of another database.
    void Add(const ShaderDatabase& other);

    /// Adds what is compiled into a program; the documents are called by the files' names.
    /// @throws AssetError if a file does not parse
    void Add(std::span<const EmbeddedFile> files);

    /// Null where there is none. Case counts, as in Unity.
    const ShaderLabDocument* Find(std::string_view name) const;

    /// A document that stands in a file of this name, "Toon.shader", in any folder; null if none
    /// does.
    const ShaderLabDocument* FindFile(std::string_view filename) const;

    std::vector<std::string_view> names() const; ///< sorted

    /// "'Toom'; did you mean 'Toon'?" for messages about a name that Find does not know.
    std::string UnknownShader(std::string_view name) const;

    std::size_t size() const { return m_Documents.size(); }

private:
    std::map<std::string, std::shared_ptr<const ShaderLabDocument>, std::less<>> m_Documents;
};

/// The .shader files below a folder, sorted by path; links to folders are not followed.
std::vector<std::filesystem::path> FindShaderFiles(const std::filesystem::path& folder);

} // namespace limn
