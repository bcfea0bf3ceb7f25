#pragma once

#include <string>

namespace limn::study
{

/// Returns a number as people read it: three significant digits without zeros at the end,
/// "0.00312", "0.1", "14.7". Whole digits stay, so 12345.6 is "12346". Below 0.0001 and from 1e9 on
/// it is "3.1e-05". Others are "NaN", "infinite" and "-infinite". Does not depend on the locale.
std::string Readable(double value);

/// Returns the shortest text that reads back as the same number: "0.1", "nan", "inf", "-inf".
std::string Exact(double value);

/// Returns a duration as text: "1 min 20 s", "3 h 5 min", "less than 1 s".
std::string Duration(double seconds);

} // namespace limn::study
