#include <limn/features/WideOutline.h>

namespace limn
{

float WideOutline::reach() const
{
    const float width = m_OutlineWidth.value();
    if (width <= 0.0f)
    {
        return 0.0f;
    }
    switch (m_Side.value())
    {
    case WideOutlineSide::Outer:
        return m_Gap.value() + width;
    case WideOutlineSide::Centred:
        return m_Gap.value() + 0.5f * width;
    case WideOutlineSide::Inner:
        break;
    }
    return 1.0f; // what is smoothed at the edge
}

} // namespace limn
