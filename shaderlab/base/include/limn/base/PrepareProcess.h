#pragma once

namespace limn
{

/// Prepares the process; a program must call it first. It occupies the descriptors of closed
/// standard streams, because the next opened files would otherwise get them and receive what is
/// printed; writing to these streams still fails. A file that grows beyond the system's limit
/// becomes an error with a name and does not end the process.
void PrepareProcess();

} // namespace limn
