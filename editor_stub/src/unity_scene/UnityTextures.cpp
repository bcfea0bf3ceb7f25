#include "unity_scene/UnityTextures.h"

#include "assets/PictureFile.h"
#include "unity/TextTexture.h"

#include <limn/base/Case.h>

namespace limn
{

std::shared_ptr<const Texture> UnityTextures::Load(const UnityReference& texture,
                                                   TextureDimension dimension,
                                                   std::string_view guid, const char* otherwise,
                                                   std::string& problem)
{
    const std::filesystem::path* path = m_Database.Find(texture.guid);
    if (path == nullptr)
    {
        problem = m_Database.WhyNotFound(texture, guid);
        return nullptr;
    }
    const std::string extension = ToLower(path->extension().string());
    if (extension == ".rendertexture" && !m_Drawn.contains(texture))
    {
        problem = "no camera of the scene draws into " + path->filename().string();
        return nullptr;
    }
    if (extension == ".asset" || extension == ".rendertexture")
    {
        return LoadText(texture, *path, dimension, problem);
    }
    return LoadPicture(*path, dimension, otherwise, problem);
}

std::shared_ptr<const Texture>
UnityTextures::LoadForFeature(const UnityReference& texture,
                              const std::function<void(const std::string& reason)>& note)
{
    AddTarget(texture); // which the feature may draw into
    std::string problem;
    for (const TextureDimension dimension : {TextureDimension::Cube, TextureDimension::Tex3D,
                                             TextureDimension::Tex2DArray, TextureDimension::Tex2D})
    {
        auto loaded = Load(texture, dimension, "the texture's guid", "no picture", problem);
        if (loaded)
        {
            return loaded;
        }
    }
    note(problem);
    return nullptr;
}

std::shared_ptr<const RenderTexture> UnityTextures::FindTarget(const UnityReference& texture) const
{
    const auto found = m_OfText.find(texture);
    return found == m_OfText.end() ? nullptr
                                   : std::dynamic_pointer_cast<const RenderTexture>(found->second);
}

std::shared_ptr<const Texture> UnityTextures::LoadText(const UnityReference& texture,
                                                       const std::filesystem::path& path,
                                                       TextureDimension dimension,
                                                       std::string& problem)
{
    const auto [known, isNew] = m_OfText.try_emplace(texture);
    if (isNew)
    {
        known->second = ReadText(path, texture.fileID);
    }
    const Texture* found = known->second.get();
    if (found != nullptr && found->dimension() == dimension)
    {
        return known->second;
    }
    const std::string name = path.filename().string();
    problem = found == nullptr
                  ? name + " holds no texture that limn reads"
                  : name + " is a texture of the kind " + ToString(found->dimension()) +
                        ", and the shader takes one of the kind " + ToString(dimension);
    return nullptr;
}

std::shared_ptr<const Texture> UnityTextures::LoadPicture(const std::filesystem::path& path,
                                                          TextureDimension dimension,
                                                          const char* otherwise,
                                                          std::string& problem)
{
    const std::string name = path.filename().string();
    if (!IsPictureFile(path))
    {
        problem = name + " is no picture that limn reads";
        return nullptr;
    }
    std::shared_ptr<const Texture> texture;
    try
    {
        if (dimension == TextureDimension::Tex2D)
        {
            return m_Assets.LoadTexture(path);
        }
        if (dimension == TextureDimension::Cube)
        {
            texture = m_Assets.LoadCubemap(path);
        }
        problem = texture ? "" : name + " is " + otherwise;
    }
    catch (const AssetError& error)
    {
        m_Notes.Add(error.diagnostics());
    }
    return texture;
}

std::shared_ptr<const Texture> UnityTextures::ReadText(const std::filesystem::path& path,
                                                       std::int64_t fileID)
{
    const auto isTexture = [](const UnityHeader& header)
    {
        const auto classID = static_cast<UnityClass>(header.classID);
        return classID == UnityClass::Texture2D || classID == UnityClass::Texture3D ||
               classID == UnityClass::Texture2DArray || classID == UnityClass::RenderTexture;
    };
    try
    {
        const std::shared_ptr<const UnityFile> file = m_Database.LoadFile(path);
        const UnityHeader* found = nullptr;
        for (const UnityHeader& header : file ? file->headers() : std::span<const UnityHeader>())
        {
            found = isTexture(header) && (!found || header.fileID == fileID) ? &header : found;
        }
        if (found == nullptr)
        {
            return nullptr;
        }
        const UnityNode fields = file->Fields(*found);
        const auto classID = static_cast<UnityClass>(found->classID);
        if (classID == UnityClass::RenderTexture)
        {
            return ReadRenderTexture(fields, file->name());
        }
        return ReadTextTexture(classID, fields, file->name());
    }
    catch (const AssetError& error)
    {
        m_Notes.Add(error.diagnostics());
        return nullptr;
    }
}

} // namespace limn
