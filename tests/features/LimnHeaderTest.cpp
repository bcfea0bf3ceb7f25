#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limn/limn.h>
#include <map>
#include <string>

#include "Paths.h"

namespace limn
{
namespace
{

/// Public headers by the name that programs include them with.
std::map<std::string, std::filesystem::path> PublicHeaders()
{
    std::map<std::string, std::filesystem::path> headers;
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(test::SourcePath("features")))
    {
        const std::string path = entry.path().generic_string();
        const std::size_t root = path.find("/include/limn/");
        if (root != std::string::npos && entry.path().extension() == ".h")
        {
            headers[path.substr(root + std::string("/include/").size())] = entry.path();
        }
    }
    for (const auto& entry :
         std::filesystem::directory_iterator(test::SourcePath("volume/include/limn/volume")))
    {
        headers["limn/volume/" + entry.path().filename().string()] = entry.path();
    }
    const std::string generated = "limn/features/AllFeatures.h";
    const auto build = std::filesystem::path(test::LimnExecutable()).parent_path().parent_path();
    headers[generated] = build / "features/include" / generated;
    return headers;
}

/// Adds what a header includes, and what those include.
void Follow(const std::string& header, std::map<std::string, std::filesystem::path>& notReached)
{
    const auto found = notReached.find(header);
    if (found == notReached.end())
    {
        return;
    }
    std::ifstream file(found->second);
    notReached.erase(found);
    const std::string start = "#include <";
    for (std::string line; std::getline(file, line);)
    {
        if (line.starts_with(start))
        {
            Follow(line.substr(start.size(), line.find('>') - start.size()), notReached);
        }
    }
}

TEST(LimnHeader, BringsEveryFeatureAndEveryKindOfParameter)
{
    std::map<std::string, std::filesystem::path> notReached = PublicHeaders();
    ASSERT_GT(notReached.size(), 20u);
    Follow("limn/limn.h", notReached);
    std::vector<std::string> missing;
    for (const auto& [header, path] : notReached)
    {
        if (header.starts_with("limn/features/") || header.ends_with("Parameter.h"))
        {
            missing.push_back(header);
        }
    }
    EXPECT_THAT(missing, testing::IsEmpty());
}

} // namespace
} // namespace limn
