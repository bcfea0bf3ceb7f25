#include <limn/base/AppendedFile.h>
#include <limn/base/WriteFile.h>

#include "platform/posix/FileDescriptor.h"

#include <fcntl.h>

namespace limn
{

AppendedFile::AppendedFile(std::filesystem::path path)
    : m_Path(std::move(path)),
      m_Descriptor(open(m_Path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666))
{
    if (m_Descriptor < 0)
    {
        ThrowWriteError(m_Path, LastError());
    }
}

AppendedFile::~AppendedFile()
{
    close(m_Descriptor);
}

void AppendedFile::Append(std::string_view bytes)
{
    if (const std::error_code error = WriteToDescriptor(m_Descriptor, bytes))
    {
        ThrowWriteError(m_Path, error);
    }
    fdatasync(m_Descriptor); // where there is no disk behind it, nothing is lost either
}

} // namespace limn
