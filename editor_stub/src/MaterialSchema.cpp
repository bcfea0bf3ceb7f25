#include "MaterialSchema.h"

namespace limn
{

Json MaterialSchema()
{
    // Which properties there are is up to the shader, a file of its own; what one can be is not.
    Json texture{{"type", "string"}, {"pattern", "^(white|black|gray|bump|red)$|\\.png$"}};
    Json property{
        {"anyOf", {NumberSchema(), ColorSchema(), VectorSchema(4), std::move(texture)}},
        {"description", "A property of the shader: a number, a colour, four numbers or a texture"}};
    Json shader = TextSchema();
    shader["description"] = "A shader's name or a .shader file";
    return {{"type", {"object", "null"}},
            {"properties",
             {{"shader", std::move(shader)}, {"renderQueue", IntegerSchema({-1.0, 5000.0})}}},
            {"additionalProperties", std::move(property)}};
}

Json MaterialFileSchema()
{
    return RootSchema("limn material", MaterialSchema());
}

} // namespace limn
