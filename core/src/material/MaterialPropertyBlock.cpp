#include <limn/core/MaterialPropertyBlock.h>

#include "material/RequireFinite.h"

#include <algorithm>
#include <cmath>
#include <limn/shaderlab/Diagnostic.h>

namespace limn
{

namespace
{

struct AllFinite
{
    bool operator()(float number) const { return std::isfinite(number); }
    bool operator()(int) const { return true; }
    bool operator()(const std::shared_ptr<const Texture>&) const { return true; }
    bool operator()(const Color& color) const { return (*this)(color.vector()); }
    bool operator()(const glm::vec4& v) const
    {
        return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) && std::isfinite(v.w);
    }
    bool operator()(const glm::mat4& m) const
    {
        return (*this)(m[0]) && (*this)(m[1]) && (*this)(m[2]) && (*this)(m[3]);
    }
    bool operator()(const std::vector<glm::vec4>& array) const
    {
        return std::all_of(array.begin(), array.end(), *this);
    }
};

} // namespace

bool isFinite(const ShaderPropertyValue& value)
{
    return std::visit(AllFinite(), value);
}

void RequireFinite(const ShaderPropertyValue& value, ShaderPropertyId id, std::string_view owner)
{
    if (!isFinite(value))
    {
        throw ContractError(std::string(owner) + "property '" + id.name() +
                            "' is not finite; NaN and infinity reach no shader");
    }
}

void MaterialPropertyBlock::Set(ShaderPropertyId id, ShaderPropertyValue value)
{
    RequireFinite(value, id);
    m_Values[id] = std::move(value);
}

} // namespace limn
