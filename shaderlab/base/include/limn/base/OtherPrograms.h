#pragma once

#include <chrono>

namespace limn
{

/// What other programs do while this lives.
class OtherPrograms
{
public:
    OtherPrograms();

    /// The mean number of processors that others kept busy, the host of a virtual machine among
    /// them; NaN where the system does not tell.
    double BusyProcessors() const;

private:
    double m_Seconds; ///< that others have used until this was made
    std::chrono::steady_clock::time_point m_Begin = std::chrono::steady_clock::now();
};

} // namespace limn
