#pragma once

#include <cstddef>
#include <string>

namespace limn::study
{

/// As people read it: three significant digits without zeros at the end, "0.00312", "0.1", "14.7";
/// whole digits stay, so 12345.6 is "12346"; below 0.0001 and from 1e9 on "3.1e-05"; "NaN",
/// "infinite", "-infinite". Independent of the locale.
std::string Readable(double value);

/// As short as it reads back as the same number: "0.1", "nan", "inf", "-inf".
std::string Exact(double value);

/// "1 min 20 s", "3 h 5 min", "less than 1 s".
std::string Duration(double seconds);

} // namespace limn::study
