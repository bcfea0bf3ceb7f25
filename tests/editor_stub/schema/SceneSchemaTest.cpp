#include "SceneFolder.h"

#include <gmock/gmock.h>
#include <limn/features/Features.h>
#include <schema/Schemas.h>
#include <set>

namespace limn::test
{

namespace
{

using Keys = std::set<std::string>;

Json SchemaOfScenes()
{
    FeatureRegistry features;
    VolumeComponentRegistry components;
    RegisterFeatures(features, components);
    return SceneSchema(features);
}

/// The keys that the reader of a map knows, by what it says of `zzz`, which it does not.
Keys KeysRead(const std::string& text)
{
    const std::string start = "unknown key 'zzz' (known: ";
    SceneFolder folder;
    for (const std::string& problem : folder.ProblemsOf(text))
    {
        const std::size_t at = problem.find(start);
        if (at != std::string::npos)
        {
            const std::size_t list = at + start.size();
            std::istringstream words(problem.substr(list, problem.rfind(')') - list));
            Keys keys;
            for (std::string word; std::getline(words >> std::ws, word, ',');)
            {
                keys.insert(word);
            }
            return keys;
        }
    }
    ADD_FAILURE() << "zzz was accepted in " << text;
    return {};
}

Keys KeysOf(const Json& map)
{
    Keys keys;
    for (const auto& [key, value] : map["properties"].items())
    {
        keys.insert(key);
    }
    return keys;
}

/// Collects the keys of a schema that have no description: of all maps in it, but for the parts of
/// a value such as the `r` of a colour, which stand in an `anyOf`.
void AddUndescribed(const Json& schema, const std::string& place, std::vector<std::string>& keys)
{
    if (!schema.is_structured())
    {
        return;
    }
    if (schema.is_object() && schema.contains("properties"))
    {
        for (const auto& [key, value] : schema["properties"].items())
        {
            const std::string text = value.value("description", "");
            if (text.empty() || text.back() == '.')
            {
                keys.push_back(place + "." + key);
            }
        }
    }
    for (const auto& [key, value] : schema.items())
    {
        if (key != "anyOf" && key != "if")
        {
            AddUndescribed(value, place + "." + key, keys);
        }
    }
}

} // namespace

TEST(SceneSchema, DescribesEachKey)
{
    std::vector<std::string> keys;
    AddUndescribed(SchemaOfScenes(), "", keys);
    EXPECT_THAT(keys, testing::IsEmpty());
    const Json broken = Json::parse(R"({"items": {"properties": {"a": {"description": ""}}}})");
    AddUndescribed(broken, "", keys);
    EXPECT_THAT(keys, testing::ElementsAre(".items.a"));
}

TEST(SceneSchema, HasTheKeysThatScenesAreReadBy)
{
    const Json schema = SchemaOfScenes();
    const Json& scene = schema["properties"];
    EXPECT_EQ(KeysRead("camera: {}\nzzz: 1\n"), KeysOf(schema));
    EXPECT_EQ(KeysRead("camera: {zzz: 1}\n"), KeysOf(scene["camera"]));
    EXPECT_EQ(KeysRead("camera: {cameraStack: [{zzz: 1}]}\n"),
              KeysOf(scene["camera"]["properties"]["cameraStack"]["items"]));
    EXPECT_EQ(KeysRead("camera: {}\nlight: {zzz: 1}\n"), KeysOf(scene["light"]));
    EXPECT_EQ(KeysRead("camera: {}\nrenderSettings: {zzz: 1}\n"), KeysOf(scene["renderSettings"]));
    EXPECT_EQ(KeysRead("camera: {}\nrenderer: {zzz: 1}\n"), KeysOf(scene["renderer"]));
    EXPECT_EQ(KeysRead("camera: {}\nvolumes: [{profile: on.profile.yaml, zzz: 1}]\n"),
              KeysOf(scene["volumes"]["items"]));
    EXPECT_EQ(KeysRead("camera: {}\nobjects: [{name: A, zzz: 1}]\n"),
              KeysOf(schema["$defs"]["object"]));
}

TEST(SceneSchema, HasTheKeysThatCollidersAreReadBy)
{
    const Json schema = SchemaOfScenes();
    const Json& collider =
        schema["properties"]["volumes"]["items"]["properties"]["colliders"]["items"];
    std::size_t index = 0;
    for (const char* type : {"box", "sphere", "capsule", "mesh"})
    {
        const std::string mesh = type == std::string("mesh") ? "mesh: cube, " : "";
        EXPECT_EQ(KeysRead("camera: {}\nvolumes: [{profile: on.profile.yaml, colliders: [{type: " +
                           std::string(type) + ", " + mesh + "zzz: 1}]}]\n"),
                  KeysOf(collider["allOf"][index++]["then"]))
            << type;
    }
}

} // namespace limn::test
