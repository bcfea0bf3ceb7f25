#pragma once

#include <limn/base/Diagnostic.h>

namespace limn
{

/// A program is well formed as far as limn can tell, and asks for what limn does not do: a surface
/// shader, another stage, another renderer, another pipeline. Holds one diagnostic, the reason.
class UnsupportedProgramError : public AssetError
{
public:
    explicit UnsupportedProgramError(Diagnostic reason) : AssetError({std::move(reason)}) {}
};

} // namespace limn
