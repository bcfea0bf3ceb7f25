#pragma once

#include "reports/Json.h"
#include "study/Study.h"

namespace limn::study
{

/// All but the cells.
Json ToJson(const Study& study);
/// NaN and infinities are the strings "nan", "inf" and "-inf", which JSON has no numbers for.
Json ToJson(const CellResult& cell);

/// @throws nlohmann::json::exception, std::invalid_argument
Study StudyFromJson(const Json& json);
CellResult CellFromJson(const Json& json);

} // namespace limn::study
