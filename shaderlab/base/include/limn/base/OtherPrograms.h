#pragma once

#include <chrono>

namespace limn
{

/// Measures how busy other programs are during its lifetime.
class OtherPrograms
{
public:
    OtherPrograms();

    /// Returns the mean number of processors that others kept busy, the host of a virtual machine
    /// included; NaN if the system does not report it.
    double BusyProcessors() const;

private:
    double m_Seconds; ///< processor time that others had used when this was made
    std::chrono::steady_clock::time_point m_Begin = std::chrono::steady_clock::now();
};

} // namespace limn
