#pragma once

namespace limn
{

/// Must be called first by a program. Standard streams that are closed get their numbers taken, or
/// the next files to be opened would have them and get what is printed; they go on to fail as
/// closed ones do. A file that grows beyond what the system allows is an error with a name, not the
/// end.
void PrepareProcess();

} // namespace limn
