#pragma once

#include <limn/base/Diagnostic.h>

namespace limn
{

/// The error that a program is well formed as far as limn can tell, but asks for something that
/// limn does not support: a surface shader, another stage, another renderer, another pipeline. It
/// holds one diagnostic, the reason.
class UnsupportedProgramError : public AssetError
{
public:
    explicit UnsupportedProgramError(Diagnostic reason) : AssetError({std::move(reason)}) {}
};

} // namespace limn
