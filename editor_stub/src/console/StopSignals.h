#pragma once

namespace limn
{

/// Turns SIGINT and SIGTERM into something to wait for, as long as it lives. Made before other
/// threads start: those inherit that the signals are held back.
class StopSignals
{
public:
    /// @throws std::system_error
    StopSignals();
    ~StopSignals();
    StopSignals(const StopSignals&) = delete;
    StopSignals& operator=(const StopSignals&) = delete;

    /// Readable, for poll(), as soon as one of the signals came.
    int descriptor() const { return m_Descriptor; }

private:
    int m_Descriptor;
};

} // namespace limn
