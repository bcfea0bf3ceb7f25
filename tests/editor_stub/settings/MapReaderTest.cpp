#include "core/ThrownMessage.h"

#include <gtest/gtest.h>
#include <limn/base/Diagnostic.h>
#include <settings/MapReader.h>

namespace limn::test
{

namespace
{

constexpr SceneKey k_Keys[] = {{"width", SceneValue::Number}, {"name", SceneValue::Text}};

} // namespace

TEST(SceneMapReader, RefusesToReadAKeyThatTheListLacks)
{
    AssetDiagnostics diagnostics("f");
    SceneMapReader map(YamlNode(), "box", k_Keys, diagnostics);
    EXPECT_EQ("box.height is read, and scene/Keys.h does not have the key",
              ThrownMessage<ContractError>([&] { map.Find("height"); }));
}

TEST(SceneMapReader, RefusesAListWithAKeyThatNothingReads)
{
    AssetDiagnostics diagnostics("f");
    SceneMapReader map(YamlNode(), "box", k_Keys, diagnostics);
    float width = 0.0f;
    map.Read("width", width);
    EXPECT_EQ("box.name is in scene/Keys.h, and nothing reads it",
              ThrownMessage<ContractError>([&] { map.Finish(); }));
}

} // namespace limn::test
