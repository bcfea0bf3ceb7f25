#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limn/limn.h>
#include <map>
#include <regex>
#include <string>
#include <vector>

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

std::string ContentOf(const std::filesystem::path& file)
{
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// Returns true if the text has the type ("class Mesh") with its members.
bool IsDefined(const std::string& type, const std::string& text)
{
    for (std::size_t at = text.find("\n" + type); at != std::string::npos;
         at = text.find("\n" + type, at + 1))
    {
        const std::size_t end = at + 1 + type.size();
        const bool isWholeName = std::string_view(" \n").find(text[end]) != std::string_view::npos;
        if (isWholeName && text[text.find_first_of(";{", end)] == '{')
        {
            return true;
        }
    }
    return false;
}

TEST(LimnForwardHeader, DeclaresWhatPublicHeadersDefineAndIncludesNothing)
{
    std::string definitions;
    for (const char* package : {"core", "volume", "features"})
    {
        for (const auto& entry :
             std::filesystem::recursive_directory_iterator(test::SourcePath(package)))
        {
            const bool isPublic =
                entry.path().generic_string().find("/include/limn/") != std::string::npos;
            definitions += isPublic && entry.is_regular_file() ? ContentOf(entry.path()) : "";
        }
    }
    const std::string header = ContentOf(test::SourcePath("features/include/limn/limn_fwd.h"));
    EXPECT_THAT(header, testing::Not(testing::HasSubstr("#include")));

    const std::regex declaration("(class|struct) [A-Za-z0-9]+(?=;)");
    const std::vector<std::string> declared(
        std::sregex_token_iterator(header.begin(), header.end(), declaration), {});
    ASSERT_GT(declared.size(), 40u);
    for (const std::string& type : declared)
    {
        EXPECT_TRUE(IsDefined(type, definitions)) << type;
    }
}

} // namespace
} // namespace limn
