#include "assets/OutputFiles.h"

#include "commands/WorkingFolder.h"

#include <gtest/gtest.h>
#include <limn/base/Diagnostic.h>

namespace limn::test
{

TEST(OutputFiles, AreOneFileByWhateverNameWhetherItIsThereOrNot)
{
    const WorkingFolder working;
    std::filesystem::create_directory("folder");
    std::filesystem::create_directory_symlink("folder", "link");
    std::filesystem::create_symlink("o.png", "name.png");
    std::filesystem::create_symlink("../name.png", "folder/again.png");
    const std::string pairs[][2] = {{"o.png", "o.png"},
                                    {"o.png", "./o.png"},
                                    {"o.png", (working.folder / "o.png").string()},
                                    {"folder/../o.png", "o.png"},
                                    {"folder/o.png", "link/o.png"},
                                    {"name.png", "o.png"},
                                    {"o.png", "name.png"},
                                    {"folder/again.png", (working.folder / "name.png").string()}};
    for (int i = 0; i < 2; ++i)
    {
        for (const auto& names : pairs)
        {
            EXPECT_THROW(RequireOwnFiles(names, {}), AssetError)
                << names[0] << " " << names[1] << " " << i;
            EXPECT_THROW(RequireOwnFiles({names, 1}, {names[1]}), AssetError) << names[1];
        }
        working.folder.Write("o.png", "");
        working.folder.Write("folder/o.png", "");
    }
    const std::string apart[] = {"o.png", "o.json", "folder/o.png", "", ""};
    EXPECT_NO_THROW(RequireOwnFiles(apart, {"s.scene.yaml", ""}));
}

} // namespace limn::test
