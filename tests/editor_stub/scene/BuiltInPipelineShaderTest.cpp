#include "Mentions.h"
#include "SceneFolder.h"

#include <gmock/gmock.h>

namespace limn::test
{
namespace
{

TEST(BuiltInPipelineShader, IsNotedWhereNoPassOfItIsDrawn)
{
    SceneFolder folder;
    folder.Write("old.shader", "Shader \"Old\" { SubShader {\nCGPROGRAM\n"
                               "#pragma surface surf Lambert\nENDCG\n} }\n");
    const SceneAsset asset = folder.LoadWithCamera("materials:\n  red: {shader: old.shader}\n");
    ASSERT_EQ(asset.notes.size(), 1u);
    EXPECT_EQ(asset.notes[0].location.line, 3);
    EXPECT_THAT(asset.notes[0].message, Mentions("'red'", "surface shader", "features"));
}

} // namespace
} // namespace limn::test
