#include "schema/Schemas.h"

#include "settings/Keys.h"

#include <limn/core/BuiltinShaders.h>

namespace limn
{

namespace
{

/// A texture of several files, under one key.
Json SlicesSchema(const char* key, int least, const char* description)
{
    Json list = ListSchema({{"type", "string"}, {"pattern", "\\.png$"}});
    list["minItems"] = least;
    list["description"] = description;
    Json map = MapSchema({{key, std::move(list)}});
    map["required"] = Json::array({key});
    return map;
}

} // namespace

Json MaterialSchema()
{
    // Which properties there are is up to the shader, a file of its own; what one can be is not.
    std::string names;
    for (const std::string_view name : DefaultTextureNames())
    {
        names += (names.empty() ? "" : "|") + std::string(name);
    }
    const Json texture{{"type", "string"}, {"pattern", "^(" + names + ")$|\\.png$"}};
    Json property{{"anyOf",
                   {NumberSchema(), ColorSchema(), VectorSchema(4), texture,
                    SlicesSchema("faces", 6, "The faces of a cube in the order +X -X +Y -Y +Z -Z"),
                    SlicesSchema("slices", 1, "The slices of a 3D texture or an array")}},
                  {"description", "A property of the shader: a number, a colour, four numbers or "
                                  "a texture"}};
    Json shader = TextSchema();
    shader["description"] = "A shader's name or a .shader file";
    return {{"type", {"object", "null"}},
            {"properties",
             {{"shader", std::move(shader)}, {"renderQueue", IntegerSchema(k_RenderQueues)}}},
            {"additionalProperties", std::move(property)}};
}

Json MaterialFileSchema()
{
    return RootSchema("limn material", MaterialSchema());
}

} // namespace limn
