#pragma once

#include <limn/features/OutlineComponent.h>

namespace limn
{

/// The volume parameters of an outline that chooses its technique.
class AutoOutline final : public OutlineComponent
{
};

} // namespace limn
