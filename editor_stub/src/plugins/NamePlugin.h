#pragma once

#include <string>

namespace limn
{

/// From now on what the code of the module that `symbol` lies in throws, as a feature, a pass or a
/// volume component, is an AssetError that names it, but for lack of memory and failures of the
/// driver. An AssetError, which names another file, gets a note.
void NamePlugin(const void* symbol, const std::string& name);

} // namespace limn
