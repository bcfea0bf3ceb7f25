#include "assets/OutputFiles.h"

#include <algorithm>
#include <limn/base/Diagnostic.h>
#include <limn/base/WriteFile.h>

namespace limn
{

namespace
{

bool isSameFile(const std::filesystem::path& a, const std::filesystem::path& b)
{
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(a, error);
    if (std::filesystem::exists(status))
    {
        return std::filesystem::is_regular_file(status) && std::filesystem::equivalent(a, b, error);
    }
    // weakly_canonical leaves a relative path relative where nothing of it is there.
    const auto real = [&error](const std::filesystem::path& path)
    {
        return std::filesystem::weakly_canonical(std::filesystem::absolute(BehindLinks(path)),
                                                 error);
    };
    const std::filesystem::path first = real(a);
    return !error && first == real(b);
}

} // namespace

void RequireOwnFiles(std::span<const std::string> outputs,
                     const std::set<std::filesystem::path>& inputs)
{
    for (std::size_t i = 0; i < outputs.size(); ++i)
    {
        if (outputs[i].empty())
        {
            continue;
        }
        const auto isIt = [&output = outputs[i]](const std::filesystem::path& other)
        {
            return !other.empty() && isSameFile(output, other);
        };
        const auto input = std::ranges::find_if(inputs, isIt);
        if (input != inputs.end())
        {
            throw AssetError(outputs[i], {},
                             "the file cannot be written: the scene is drawn from " +
                                 input->string() + ", which is this file; give another name");
        }
        const auto rest = outputs.subspan(i + 1);
        if (std::ranges::any_of(rest, isIt))
        {
            throw AssetError(outputs[i], {},
                             "the file is to be written twice; give each output a name of its own");
        }
    }
}

} // namespace limn
