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

private:
    friend class FileWatcher;

    int m_Descriptor; ///< readable as soon as one of the signals came
};

} // namespace limn
