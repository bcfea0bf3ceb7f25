#include <algorithm>
#include <cmath>
#include <limn/features/OutlineComponent.h>

namespace limn
{

float OutlineComponent::WidthWithin(const glm::ivec2& picture) const
{
    return std::min(m_OutlineWidth.value(), std::ceil(std::hypot(static_cast<float>(picture.x),
                                                                 static_cast<float>(picture.y))));
}

std::string WhyInactive(const OutlineComponent* component, std::string_view name)
{
    const std::string type(name);
    if (component == nullptr)
    {
        return type + " was not registered when the camera's volume stack was made";
    }
    if (!component->m_Enable.overrideState() && !component->m_Enable.value())
    {
        return "no volume at the camera sets " + type + ".m_Enable, which is false by default";
    }
    if (!component->IsActive())
    {
        return "a volume sets " + type + ".m_Enable to false";
    }
    if (component->reach() <= 0.0f)
    {
        return type + ".m_OutlineWidth is 0";
    }
    if (component->m_OutlineColor.value().a <= 0.0f)
    {
        return type + ".m_OutlineColor has alpha 0";
    }
    return "";
}

} // namespace limn
