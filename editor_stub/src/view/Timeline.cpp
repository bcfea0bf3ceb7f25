#include "view/Timeline.h"

namespace limn
{

double Timeline::Total(const std::string& name) const
{
    double total = 0.0;
    for (const Span& span : m_Spans)
    {
        total += span.name == name ? span.duration : 0.0;
    }
    return total;
}

double Timeline::now() const
{
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - m_Begin)
        .count();
}

} // namespace limn
