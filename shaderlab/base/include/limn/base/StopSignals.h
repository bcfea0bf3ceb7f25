#pragma once

namespace limn
{

/// Turns SIGINT and SIGTERM into events to wait for, as long as it lives. Must be made before other
/// threads start, because they inherit that the signals are blocked.
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
