#pragma once

#include "schema/ValueSchema.h"

namespace limn
{

/// A material as scenes write it.
Json MaterialSchema();

/// What a .material.yaml file may hold: the same, on its own.
Json MaterialFileSchema();

} // namespace limn
