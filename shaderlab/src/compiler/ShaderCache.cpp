#include "compiler/ShaderCache.h"

#include "compiler/ProgramBytes.h"

#include <algorithm>
#include <string>

namespace limn
{

ShaderCache::ShaderCache(std::filesystem::path folder, std::uintmax_t limit)
    : m_Files(std::move(folder), ".limnpass", "limn pass 6\n", limit)
{
}

std::optional<ShaderProgram> ShaderCache::Load(const std::string& key,
                                               std::vector<IncludeDependency>& dependencies) const
{
    dependencies.clear();
    const std::optional<FileCache::Entry> entry = m_Files.Load(key);
    if (!entry)
    {
        return std::nullopt;
    }
    try
    {
        ByteReader reader(entry->payload());
        Transfer(reader, dependencies);
        const bool isCurrent =
            std::all_of(dependencies.begin(), dependencies.end(),
                        [](const IncludeDependency& dependency)
                        { return HashFile(dependency.path) == dependency.contentHash; });
        ShaderProgram pass;
        Transfer(reader, pass);
        if (!isCurrent)
        {
            return std::nullopt;
        }
        m_Files.Touch(key);
        return pass;
    }
    catch (const std::out_of_range&)
    {
        return std::nullopt; // an entry of another format with a good hash: rebuilt like a torn one
    }
}

void ShaderCache::Store(const std::string& key, const ShaderProgram& pass,
                        const std::vector<IncludeDependency>& dependencies) const
{
    if (isEnabled())
    {
        ByteWriter payload;
        Transfer(payload, dependencies);
        Transfer(payload, pass);
        m_Files.Store(key, payload.bytes());
    }
}

} // namespace limn
