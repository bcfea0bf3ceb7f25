#pragma once

#include <cerrno>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace limn
{

inline std::error_code LastError()
{
    return {errno, std::generic_category()};
}

/// An open file, which the destructor closes.
class FileDescriptor
{
public:
    explicit FileDescriptor(int descriptor) : m_Descriptor(descriptor) {}
    FileDescriptor(const FileDescriptor&) = delete;
    FileDescriptor& operator=(const FileDescriptor&) = delete;
    ~FileDescriptor() { static_cast<void>(Close()); }

    bool isOpen() const { return m_Descriptor >= 0; }
    int get() const { return m_Descriptor; }

    /// Closes the file. Returns an error, which may be one of an earlier write.
    [[nodiscard]] std::error_code Close()
    {
        const int descriptor = std::exchange(m_Descriptor, -1);
        return descriptor < 0 || close(descriptor) == 0 ? std::error_code{} : LastError();
    }

private:
    int m_Descriptor;
};

} // namespace limn
