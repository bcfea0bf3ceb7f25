#include "port/ReadCSharp.h"

#include <algorithm>

namespace limn
{

namespace
{

CSharpFiles ReadFor(const std::vector<std::pair<std::string, std::string>>& texts,
                    const CSharpTarget& target)
{
    CSharpFiles files;
    for (const auto& [path, text] : texts)
    {
        auto file = std::make_unique<CSharpFile>();
        file->path = path;
        file->text = text;
        ParseCSharp(*file, target);
        files.push_back(std::move(file));
    }
    return files;
}

bool HasFeature(const CSharpFiles& files)
{
    return std::ranges::any_of(files,
                               [](const std::unique_ptr<CSharpFile>& file)
                               {
                                   return std::ranges::any_of(
                                       file->classes, [](const CSharpClass& one)
                                       { return one.Derives("ScriptableRendererFeature"); });
                               });
}

bool HasConditions(const CSharpFiles& files)
{
    return std::ranges::any_of(files,
                               [](const auto& file) { return !file->tokens.conditions.empty(); });
}

} // namespace

ReadCSharpFiles ReadCSharp(const std::vector<std::pair<std::string, std::string>>& texts)
{
    ReadCSharpFiles first{ReadFor(texts, {}), {}};
    if (HasFeature(first.files) || !HasConditions(first.files))
    {
        return first;
    }
    for (const CSharpTarget& target :
         {CSharpTarget{6000, 0, false}, CSharpTarget{2022, 3, true}, CSharpTarget{6000, 0, true}})
    {
        ReadCSharpFiles read{ReadFor(texts, target), target};
        if (HasFeature(read.files))
        {
            return read;
        }
    }
    return first;
}

} // namespace limn
