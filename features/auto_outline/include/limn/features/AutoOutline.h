#pragma once

#include <limn/features/OutlineComponent.h>

namespace limn
{

/// What volumes set of an outline that chooses its technique.
class AutoOutline final : public OutlineComponent
{
};

} // namespace limn
