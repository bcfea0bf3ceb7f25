#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <gmock/gmock.h>

namespace limn::test
{

/// Matches a place that is less than 0.01 mm away.
MATCHER_P(IsNear, place, "")
{
    return glm::distance(arg, place) < 1e-5f;
}

} // namespace limn::test
