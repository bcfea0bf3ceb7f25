#include <limn/volume/AnimationCurveParameter.h>

#include <limn/volume/KeyframeUtility.h>

namespace limn
{

void AnimationCurveParameter::Interp(const AnimationCurve& from, const AnimationCurve& to, float t)
{
    if (&to == &m_Value)
    {
        const AnimationCurve target = to;
        m_Value = from;
        KeyframeUtility::InterpAnimationCurve(m_Value, target, t);
        return;
    }
    m_Value = from;
    KeyframeUtility::InterpAnimationCurve(m_Value, to, t);
}

} // namespace limn
