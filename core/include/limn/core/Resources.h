#pragma once

#include <limn/core/ComputeShader.h>
#include <limn/core/Shader.h>
#include <limn/core/Texture.h>
#include <memory>
#include <string_view>
#include <type_traits>

namespace limn
{

/// The folders that Resources::Load looks in. Each returns null if there is no such file, and
/// throws AssetError if it cannot be read.
class ResourceFolders
{
public:
    virtual ~ResourceFolders() = default;
    virtual std::shared_ptr<const Shader> FindShader(std::string_view path) = 0;
    virtual std::shared_ptr<const Texture> FindTexture(std::string_view path) = 0;
    virtual std::shared_ptr<ComputeShader> FindComputeShader(std::string_view path) = 0;
};

/// Files that code of features loads by their names. Unity: UnityEngine.Resources (2022.3).
class Resources
{
public:
    /// Loads a file of a folder "Resources" of the Unity project that is drawn, while code of a
    /// feature runs.
    /// @tparam T    Shader, Texture, Texture2D or ComputeShader
    /// @param path  within the folder, without what the file's name ends in: "Effects/Blur"
    /// @return null, with a warning, if there is no such file
    /// @throws AssetError if the file cannot be read
    template <typename T>
    static auto Load(std::string_view path)
    {
        if constexpr (std::is_same_v<T, Shader>)
        {
            return LoadShader(path);
        }
        else if constexpr (std::is_same_v<T, ComputeShader>)
        {
            return LoadComputeShader(path);
        }
        else
        {
            static_assert(std::is_same_v<T, Texture> || std::is_same_v<T, Texture2D>);
            return LoadTexture(path);
        }
    }

private:
    template <typename Asset>
    static std::shared_ptr<Asset>
    Find(std::string_view path, std::shared_ptr<Asset> (ResourceFolders::*find)(std::string_view));
    static std::shared_ptr<const Shader> LoadShader(std::string_view path);
    static std::shared_ptr<const Texture> LoadTexture(std::string_view path);
    static std::shared_ptr<ComputeShader> LoadComputeShader(std::string_view path);
};

} // namespace limn
