#include <limn/base/OtherPrograms.h>

#include <fstream>
#include <limits>
#include <string>
#include <sys/resource.h>
#include <unistd.h>

namespace limn
{

namespace
{

double SecondsOf(const timeval& time)
{
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// Seconds of processors that were not idle since the system began, and not this program's; NaN
/// where there is no /proc/stat.
double SecondsOfOthers()
{
    std::ifstream file("/proc/stat");
    std::string name;
    double user = 0.0, nice = 0.0, system = 0.0, idle = 0.0, wait = 0.0, irq = 0.0, softIrq = 0.0,
           steal = 0.0;
    if (!(file >> name >> user >> nice >> system >> idle >> wait >> irq >> softIrq >> steal))
    {
        return std::numeric_limits<double>::quiet_NaN();
    }
    rusage own{};
    getrusage(RUSAGE_SELF, &own);
    const double ticks = user + nice + system + irq + softIrq + steal;
    return ticks / static_cast<double>(sysconf(_SC_CLK_TCK)) - SecondsOf(own.ru_utime) -
           SecondsOf(own.ru_stime);
}

} // namespace

OtherPrograms::OtherPrograms() : m_Seconds(SecondsOfOthers()) {}

double OtherPrograms::BusyProcessors() const
{
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - m_Begin;
    const double others = (SecondsOfOthers() - m_Seconds) / elapsed.count();
    return others < 0.0 ? 0.0 : others; // ticks are coarse
}

} // namespace limn
