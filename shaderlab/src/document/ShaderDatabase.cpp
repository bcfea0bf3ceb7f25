#include <limn/shaderlab/ShaderDatabase.h>

#include <limn/shaderlab/ShaderLabParser.h>

#include <algorithm>

namespace limn
{

namespace
{

/// Returns the name of limn's shader that has the passes which URP draws of a shader of Unity's
/// built-in pipeline, or "" where it would draw none, as of transparent ones.
std::string_view NameOfLender(std::string_view name)
{
    static constexpr std::string_view k_Folder = "Legacy Shaders/";
    name.remove_prefix(name.starts_with(k_Folder) ? k_Folder.size() : 0);
    if (name.starts_with("Transparent/Cutout/"))
    {
        return "Hidden/Limn/CutoutVertexLit";
    }
    static constexpr std::string_view k_Opaque[] = {"VertexLit",
                                                    "Diffuse",
                                                    "Diffuse Fast",
                                                    "Diffuse Detail",
                                                    "Decal",
                                                    "Specular",
                                                    "Bumped Diffuse",
                                                    "Bumped Specular",
                                                    "Parallax Diffuse",
                                                    "Parallax Specular",
                                                    "Standard",
                                                    "Standard (Specular setup)",
                                                    "Mobile/VertexLit",
                                                    "Mobile/Diffuse",
                                                    "Mobile/Bumped Diffuse",
                                                    "Mobile/Bumped Specular"};
    static constexpr std::string_view k_OpaqueFolders[] = {"Reflective/", "Self-Illumin/",
                                                           "Lightmapped/"};
    const bool isOpaque = std::ranges::find(k_Opaque, name) != std::end(k_Opaque) ||
                          std::ranges::any_of(k_OpaqueFolders, [name](std::string_view folder)
                                              { return name.starts_with(folder); });
    return isOpaque ? "Hidden/Limn/VertexLit" : "";
}

} // namespace

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

const ShaderLabDocument* ShaderDatabase::FindLender(std::string_view name) const
{
    const ShaderLabDocument* found = Find(name);
    return found != nullptr ? found : Find(NameOfLender(name));
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
