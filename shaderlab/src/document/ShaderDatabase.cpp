#include <limn/shaderlab/ShaderDatabase.h>

#include <limn/shaderlab/ShaderLabParser.h>

#include <algorithm>

namespace limn
{

void ShaderDatabase::AddFolder(const std::filesystem::path& folder)
{
    for (const std::filesystem::path& file : FindShaderFiles(folder))
    {
        try
        {
            Add(std::make_shared<const ShaderLabDocument>(LoadShaderLab(file)));
        }
        catch (const AssetError&)
        {
            continue; // see the header
        }
    }
}

void ShaderDatabase::Add(std::shared_ptr<const ShaderLabDocument> document)
{
    if (!document)
    {
        throw ContractError("a document is null");
    }
    m_Documents.emplace(document->name, document);
}

void ShaderDatabase::Add(const ShaderDatabase& other)
{
    m_Documents.insert(other.m_Documents.begin(), other.m_Documents.end());
}

void ShaderDatabase::Add(std::span<const EmbeddedFile> files)
{
    for (const EmbeddedFile& file : files)
    {
        const std::filesystem::path path(file.path);
        Add(std::make_shared<const ShaderLabDocument>(
            ParseShaderLab(file.text, path.filename().string()).TakeDocument()));
    }
}

const ShaderLabDocument* ShaderDatabase::Find(std::string_view name) const
{
    const auto found = m_Documents.find(name);
    return found == m_Documents.end() ? nullptr : found->second.get();
}

const ShaderLabDocument* ShaderDatabase::FindFile(std::string_view filename) const
{
    const auto found = std::ranges::find_if(
        m_Documents, [filename](const auto& entry)
        { return std::filesystem::path(entry.second->file).filename() == filename; });
    return found == m_Documents.end() ? nullptr : found->second.get();
}

std::vector<std::string_view> ShaderDatabase::names() const
{
    std::vector<std::string_view> names;
    for (const auto& [name, document] : m_Documents)
    {
        names.push_back(name);
    }
    return names;
}

std::string ShaderDatabase::UnknownShader(std::string_view name) const
{
    const std::string meant = DidYouMean(name, names());
    return "'" + std::string(name) + "'" +
           (meant.empty() ? "; no shader of a name like it is among the " + std::to_string(size()) +
                                " known ones"
                          : meant);
}

std::vector<std::filesystem::path> FindShaderFiles(const std::filesystem::path& folder)
{
    std::vector<std::filesystem::path> files;
    const auto options = std::filesystem::directory_options::skip_permission_denied;
    std::error_code error;
    auto entry = std::filesystem::recursive_directory_iterator(folder, options, error);
    while (!error && entry != std::filesystem::recursive_directory_iterator())
    {
        std::error_code unreadable;
        if (entry->path().extension() == ".shader" && entry->is_regular_file(unreadable))
        {
            files.push_back(entry->path());
        }
        entry.increment(error);
    }
    if (error)
    {
        throw AssetError(folder.string(), {},
                         "the folder cannot be searched for shaders: " + error.message());
    }
    std::ranges::sort(files);
    return files;
}

} // namespace limn
