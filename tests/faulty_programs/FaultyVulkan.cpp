// Lets a call to Vulkan of a whole program fail: LD_PRELOAD of the module that this file and
// FaultyLoader's make. LIMN_FAULT_CALL=17 with LIMN_FAULT_RESULT=VK_ERROR_DEVICE_LOST: the 17th
// call that may return that does so. LIMN_FAULT_REPORT=FILE gets the function that failed and the
// kinds of objects that are left when the program ends, and of each result how many calls may
// return it.

#include "vulkan/faults/FaultyLoader.h"

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <unistd.h>

namespace
{

using namespace limn::test::faulty_loader;

#define LIMN_RESULT(result)                                                                        \
    {                                                                                              \
#result, result                                                                            \
    }
const std::map<std::string, VkResult> k_Results = {LIMN_RESULT(VK_ERROR_OUT_OF_HOST_MEMORY),
                                                   LIMN_RESULT(VK_ERROR_OUT_OF_DEVICE_MEMORY),
                                                   LIMN_RESULT(VK_ERROR_DEVICE_LOST),
                                                   LIMN_RESULT(VK_ERROR_INITIALIZATION_FAILED),
                                                   LIMN_RESULT(VK_ERROR_FORMAT_NOT_SUPPORTED),
                                                   LIMN_RESULT(VK_ERROR_EXTENSION_NOT_PRESENT),
                                                   LIMN_RESULT(VK_ERROR_INCOMPATIBLE_DRIVER),
                                                   LIMN_RESULT(VK_ERROR_TOO_MANY_OBJECTS),
                                                   LIMN_RESULT(VK_ERROR_OUT_OF_POOL_MEMORY),
                                                   LIMN_RESULT(VK_INCOMPLETE),
                                                   LIMN_RESULT(VK_TIMEOUT),
                                                   LIMN_RESULT(VK_NOT_READY)};

/// Lives as long as the program. It comes behind FaultyLoader's state, as its file does in the
/// module, and so goes before it.
class FaultOfTheProgram
{
public:
    FaultOfTheProgram()
    {
        const char* call = std::getenv("LIMN_FAULT_CALL");
        const char* result = std::getenv("LIMN_FAULT_RESULT");
        if (call == nullptr || result == nullptr)
        {
            return;
        }
        const auto found = k_Results.find(result);
        if (found == k_Results.end())
        {
            std::cerr << "LIMN_FAULT_RESULT: no such result: " << result << std::endl;
            _exit(2);
        }
        FailCall(std::atoi(call), found->second);
    }
    ~FaultOfTheProgram()
    {
        const char* file = std::getenv("LIMN_FAULT_REPORT");
        if (file == nullptr || getpid() != m_Process) // a compiler's process, which calls no Vulkan
        {
            return;
        }
        std::ofstream report(file);
        const std::string failed = FailedFunction();
        report << (failed.empty() ? "nothing" : failed);
        for (const auto& [kind, count] : LiveObjects())
        {
            report << ' ' << kind << '=' << count;
        }
        for (const auto& [name, result] : k_Results)
        {
            report << '\n' << name << ' ' << CallsThatMay(result).size();
        }
    }
    FaultOfTheProgram(const FaultOfTheProgram&) = delete;
    FaultOfTheProgram& operator=(const FaultOfTheProgram&) = delete;

private:
    pid_t m_Process = getpid();
};

const FaultOfTheProgram s_Fault;

} // namespace
