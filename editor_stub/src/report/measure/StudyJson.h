#pragma once

#include "console/Json.h"
#include "report/measure/Study.h"

namespace limn::study
{

/// All but the cells.
Json ToJson(const Study& study);
/// NaN and infinities are the strings "nan", "inf" and "-inf", which JSON has no numbers for.
Json ToJson(const CellResult& cell);

/// @param file  what errors call it
/// @throws AssetError with the line and the column of every problem
Study StudyFromJson(std::string_view text, const std::string& file);
/// @param lineNumber  of the line in the file
/// @throws AssetError with the line and the column of every problem
CellResult CellFromJson(std::string_view line, const std::string& file, int lineNumber);

} // namespace limn::study
