#pragma once

#include "check/Expectations.h"

namespace limn
{

/// Returns one line for each expectation that fails, with its differences below it, and a summary:
/// "5 expectations, 1 failed".
/// @param failed  the summary's word for expectations that do not hold
std::string CheckText(const std::vector<Expectation>& expectations, const std::string& file,
                      const std::string& failed, bool isLong);

/// Returns {scene, file, expectations: [{name, line, column, holds, diff}], failed}.
std::string CheckJson(const std::vector<Expectation>& expectations, const std::string& file,
                      const std::string& scene);

/// Returns the XML that continuous integration reads as the results of tests.
std::string JUnitXml(const std::vector<Expectation>& expectations, const std::string& file,
                     const std::string& scene);

} // namespace limn
