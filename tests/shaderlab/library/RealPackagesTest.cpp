#include "CorpusSupport.h"

#include <nlohmann/json.hpp>

#include <fstream>

namespace limn::test
{

namespace
{

/// The packages below a folder, by the names in their package.json.
std::map<std::string, std::filesystem::path> PackagesIn(const std::filesystem::path& folder)
{
    std::map<std::string, std::filesystem::path> packages;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    {
        if (entry.path().filename() == "package.json")
        {
            std::ifstream file(entry.path());
            packages[nlohmann::json::parse(file).at("name")] = entry.path().parent_path();
        }
    }
    return packages;
}

} // namespace

// Unity's own packages are not limn's to ship: a folder that holds them, a project's
// Library/PackageCache say, is named by LIMN_PACKAGES_DIR.
TEST(RealPackages, CompileAsTheImporterTakesThem)
{
    constexpr const char* k_Universal = "com.unity.render-pipelines.universal";
    constexpr double k_LeastShare = 0.97;
    const std::string folder = FolderOf("LIMN_PACKAGES_DIR");
    if (folder.empty())
    {
        GTEST_SKIP() << "LIMN_PACKAGES_DIR names no folder with Unity's packages";
    }
    for (const bool halfIs16Bit : {false, true})
    {
        ShaderCompilerOptions options;
        options.packages = PackagesIn(folder);
        options.halfIs16Bit = halfIs16Bit;
        ASSERT_TRUE(options.packages.contains(k_Universal)) << "below " << folder;
        ShaderCompiler compiler(options);
        PassCounts passes;
        for (const auto& entry :
             std::filesystem::recursive_directory_iterator(options.packages[k_Universal]))
        {
            if (entry.path().extension() == ".shader")
            {
                CompilePasses(compiler, LoadShaderLab(entry.path()), passes);
            }
        }
        const int all = passes.tried.all + passes.missingInclude;
        std::cout << "packages" << (halfIs16Bit ? " with 16-bit half" : "") << ": "
                  << passes.tried.good << " of " << all << " passes compile, " << passes.refused
                  << " refused\n";
        EXPECT_GT(all, 0) << "no pass below " << folder;
        EXPECT_GE(passes.tried.good, k_LeastShare * all);
    }
}

} // namespace limn::test
