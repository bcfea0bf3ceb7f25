#include "Mentions.h"
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
    EXPECT_THAT(ThrownMessage<ContractError>([&] { map.Find("height"); }),
                Mentions("box.height", "is read", "settings/Keys.h"));
}

TEST(SceneMapReader, RefusesAListWithAKeyThatNothingReads)
{
    AssetDiagnostics diagnostics("f");
    SceneMapReader map(YamlNode(), "box", k_Keys, diagnostics);
    float width = 0.0f;
    map.Read("width", width);
    EXPECT_THAT(ThrownMessage<ContractError>([&] { map.Finish(); }),
                Mentions("box.name", "settings/Keys.h", "nothing reads"));
}

} // namespace limn::test
