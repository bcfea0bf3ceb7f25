#include <algorithm>
#include <cmath>
#include <limn/features/OutlineComponent.h>
#include <limn/volume/YamlRead.h>

namespace limn
{

float OutlineComponent::WidthWithin(const glm::ivec2& picture) const
{
    return std::min(m_OutlineWidth.value(), std::ceil(std::hypot(static_cast<float>(picture.x),
                                                                 static_cast<float>(picture.y))));
}

std::string WhyOff(const BoolParameter* enable, bool isActive, std::string_view name)
{
    if (enable == nullptr)
    {
        return std::string(name) + " was not registered when the camera's volume stack was made";
    }
    return isActive                  ? ""
           : enable->overrideState() ? "a volume sets " + std::string(name) + ".m_Enable to false"
                                     : "no volume at the camera sets " + std::string(name) +
                                           ".m_Enable, which is false by default";
}

std::string WhyInactive(const OutlineComponent* component, std::string_view name)
{
    const bool isActive = component != nullptr && component->IsActive();
    std::string off = WhyOff(component != nullptr ? &component->m_Enable : nullptr, isActive, name);
    if (!isActive)
    {
        return off;
    }
    if (component->reach() <= 0.0f)
    {
        const double width = static_cast<double>(component->m_OutlineWidth.value());
        return std::string(name) + ".m_OutlineWidth is " +
               (width > 0.0 ? NumberText(width) + ", which rounds to no pixel" : "0");
    }
    if (component->m_OutlineColor.value().a <= 0.0f)
    {
        return std::string(name) + ".m_OutlineColor has alpha 0";
    }
    return "";
}

} // namespace limn
