#pragma once

#include <limn/base/Diagnostic.h>

namespace limn
{

/// The error that a program includes a file that is neither beside it, nor in the project, its
/// packages or limn's ShaderLibrary. Without the file nothing can be said about the program.
class MissingIncludeError : public AssetError
{
public:
    using AssetError::AssetError;
};

} // namespace limn
