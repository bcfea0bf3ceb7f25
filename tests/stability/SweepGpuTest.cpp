#include "stability/Stability.h"

#include "../vulkan/GpuTestDevice.h"

#include <chrono>
#include <gtest/gtest.h>

namespace limn::study
{
namespace
{

TEST(Sweep, PrintsTemporarily)
{
    ExtremeLevels levels;
    if (!std::getenv("BIG"))
    {
        levels.sizes = {{96, 64}, {1, 1}, {3, 7}};
    }
    const char* only = std::getenv("ONLY");
    ShaderCompilerOptions options;
    options.cacheFolder = std::filesystem::temp_directory_path() / "limn_stab_cache";
    AssetContext assets(options);
    std::vector<CellId> cells = PlanStability(
        Techniques(), std::getenv("PAIR") ? SweepSize::Pairwise : SweepSize::Sampled, levels);
    std::map<std::string, int> failed;
    std::map<std::string, double> seconds;
    for (const CellId& cell : cells)
    {
        if (only && std::string(cell.technique).find(only) == std::string::npos)
        {
            continue;
        }
        const auto start = std::chrono::steady_clock::now();
        const CellResult result = MeasureStability(cell, assets, test::SharedDevice());
        seconds[cell.technique] +=
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        const std::string name = CellId(result.id).Name();
        if (result.Value("failures") > 0)
        {
            failed[cell.technique] += 1;
            printf("%s  mae %g bound %g growth %g px %g\n", name.c_str(),
                   result.Value("meanAbsoluteError"), result.Value("errorBound"),
                   result.Value("areaGrowth"), result.Value("bandPixels"));
            for (const std::string& note : result.notes)
            {
                printf("    %s\n", note.substr(0, 300).c_str());
            }
        }
        else if (std::getenv("ALL"))
        {
            printf("ok %s  mae %g bound %g growth %g px %g\n", name.c_str(),
                   result.Value("meanAbsoluteError"), result.Value("errorBound"),
                   result.Value("areaGrowth"), result.Value("bandPixels"));
        }
        fflush(stdout);
    }
    printf("%zu cells\n", cells.size());
    for (const auto& [name, s] : seconds)
    {
        printf("%-30s %6.2f s, %d failed\n", name.c_str(), s, failed[name]);
    }
}

} // namespace
} // namespace limn::study
