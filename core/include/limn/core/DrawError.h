#pragma once

#include <limn/base/Diagnostic.h>

namespace limn
{

/// What is to be drawn cannot be: a shader or material that does not fit the textures, meshes and
/// targets it is drawn with, or asks for what the device lacks. A mistake in what the program was
/// given rather than in the program.
class DrawError : public ContractError
{
public:
    using ContractError::ContractError;
};

} // namespace limn
