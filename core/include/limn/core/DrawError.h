#pragma once

#include <limn/base/Diagnostic.h>

namespace limn
{

/// Thrown if something cannot be drawn: a shader or material does not fit the textures, meshes and
/// targets it is drawn with, or needs something that the device lacks. The mistake is in what the
/// program was given rather than in the program.
class DrawError : public ContractError
{
public:
    using ContractError::ContractError;
};

} // namespace limn
