#include <limn/base/WriteFile.h>

#include "platform/posix/FileDescriptor.h"

#include <limn/base/Diagnostic.h>

#include <algorithm>
#include <fcntl.h>
#include <optional>
#include <poll.h>
#include <random>
#include <string>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/xattr.h>

namespace limn
{

namespace
{

/// The contents of a file that is to be written, and its path.
struct Writing
{
    std::filesystem::path path; ///< no link
    std::string_view bytes;
    const std::function<void()>& beforeReplace;
    bool isDurable;

    void CallBeforeReplace() const
    {
        if (beforeReplace)
        {
            beforeReplace();
        }
    }

    std::error_code Finish(FileDescriptor& file) const
    {
        return isDurable && fsync(file.get()) != 0 ? LastError() : file.Close();
    }
};

/// Removes a file when it goes, unless it has been moved away.
struct TemporaryFile
{
    std::filesystem::path path;

    explicit TemporaryFile(std::filesystem::path p) : path(std::move(p)) {}
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile() { unlink(path.c_str()); }
};

/// A name that nobody else has; short, whatever that of the file is.
std::filesystem::path TemporaryBeside(const std::filesystem::path& path)
{
    std::random_device random;
    const std::uint64_t number = (std::uint64_t{random()} << 32) | random();
    return path.parent_path() / (".limn-" + std::to_string(number));
}

/// Standard output or error, where it is this very file; else -1.
int StandardStream(const struct stat& status)
{
    for (const int stream : {STDOUT_FILENO, STDERR_FILENO})
    {
        struct stat other = {};
        if (fstat(stream, &other) == 0 && other.st_dev == status.st_dev &&
            other.st_ino == status.st_ino)
        {
            return stream;
        }
    }
    return -1;
}

std::error_code WriteToSpecial(const std::filesystem::path& path, const struct stat& status,
                               std::string_view bytes)
{
    if (S_ISBLK(status.st_mode))
    {
        return std::make_error_code(std::errc::operation_not_permitted);
    }
    // A pipe that nobody reads is an error, not something to wait for.
    FileDescriptor file(open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY));
    if (!file.isOpen())
    {
        return LastError();
    }
    const std::error_code failure = WriteToDescriptor(file.get(), bytes);
    return failure ? failure : file.Close();
}

/// Writes into the file that is there. What it grows by is taken from the disk first: after that,
/// there is room for everything.
std::error_code Overwrite(const Writing& writing, const struct stat& old)
{
    FileDescriptor file(open(writing.path.c_str(), O_WRONLY | O_CLOEXEC));
    if (!file.isOpen())
    {
        return LastError();
    }
    writing.CallBeforeReplace();
    const auto size = static_cast<off_t>(writing.bytes.size());
    if (size > old.st_size)
    {
        if (const int failure = posix_fallocate(file.get(), 0, size))
        {
            static_cast<void>(ftruncate(file.get(), old.st_size) == 0);
            return {failure, std::generic_category()};
        }
    }
    if (const std::error_code failure = WriteToDescriptor(file.get(), writing.bytes))
    {
        return failure;
    }
    return ftruncate(file.get(), size) == 0 ? writing.Finish(file) : LastError();
}

/// Returns the bytes of a call that tells the size if it gets no room, or nothing if the call
/// fails.
template <typename Call>
std::optional<std::string> BytesOf(Call&& call)
{
    std::string bytes;
    ssize_t size = call(nullptr, 0);
    if (size > 0)
    {
        bytes.resize(static_cast<std::size_t>(size));
        size = call(bytes.data(), bytes.size());
    }
    bytes.resize(static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
    return size < 0 ? std::nullopt : std::optional(std::move(bytes));
}

/// The names of the attributes of an open file, each with its end; none where there can be none.
std::string AttributesOf(const FileDescriptor& file)
{
    return BytesOf([&](char* bytes, std::size_t room)
                   { return flistxattr(file.get(), bytes, room); })
        .value_or("");
}

std::optional<std::string> AttributeOf(const FileDescriptor& file, const char* name)
{
    return BytesOf([&](char* bytes, std::size_t room)
                   { return fgetxattr(file.get(), name, bytes, room); });
}

/// Returns whether the new file could be given the extended attributes of the old one, access
/// control lists among them, and no others.
bool TakeOverAttributes(const FileDescriptor& file, const std::filesystem::path& path)
{
    const FileDescriptor old(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    const std::string names = AttributesOf(old);
    const auto next = [](const std::string& list, std::size_t at)
    {
        return list.find('\0', at) + 1;
    };
    for (std::size_t at = 0; at < names.size(); at = next(names, at))
    {
        const char* name = names.c_str() + at;
        const std::optional<std::string> value = AttributeOf(old, name);
        if (!value || (AttributeOf(file, name) != value &&
                       fsetxattr(file.get(), name, value->data(), value->size(), 0) != 0))
        {
            return false;
        }
    }
    const std::string fresh = AttributesOf(file); // from its folder
    for (std::size_t at = 0; at < fresh.size(); at = next(fresh, at))
    {
        const char* name = fresh.c_str() + at;
        if (!AttributeOf(old, name) && fremovexattr(file.get(), name) != 0)
        {
            return false;
        }
    }
    return old.isOpen();
}

/// Returns whether the new file could be given owner, permissions and extended attributes of the
/// old one.
bool TakeOver(const FileDescriptor& file, const std::filesystem::path& path, const struct stat& old)
{
    struct stat fresh = {};
    const bool isOwner =
        fstat(file.get(), &fresh) == 0 && fresh.st_uid == old.st_uid && fresh.st_gid == old.st_gid;
    return (isOwner || fchown(file.get(), old.st_uid, old.st_gid) == 0) &&
           fchmod(file.get(), old.st_mode & 07777) == 0 && TakeOverAttributes(file, path);
}

int OpenFolderOf(const std::filesystem::path& file)
{
    return open((BehindLinks(file).parent_path() / ".").c_str(),
                O_RDONLY | O_DIRECTORY | O_CLOEXEC);
}

/// Puts a new name of a file onto the disk; nothing where the file system cannot.
std::error_code SyncFolder(const std::filesystem::path& path)
{
    const FileDescriptor folder(OpenFolderOf(path));
    const bool isDone = !folder.isOpen() || fsync(folder.get()) == 0 || errno == EINVAL;
    return isDone ? std::error_code() : LastError();
}

/// @param old  null if there is no such file yet
std::error_code Replace(const Writing& writing, const struct stat* old)
{
    const TemporaryFile temporary(TemporaryBeside(writing.path));
    FileDescriptor file(
        open(temporary.path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (!file.isOpen())
    {
        return LastError();
    }
    if (old && !TakeOver(file, writing.path, *old))
    {
        return Overwrite(writing, *old);
    }
    std::error_code failure = WriteToDescriptor(file.get(), writing.bytes);
    failure = failure ? failure : writing.Finish(file);
    if (failure)
    {
        return failure;
    }
    writing.CallBeforeReplace();
    if (rename(temporary.path.c_str(), writing.path.c_str()) != 0)
    {
        return LastError();
    }
    return writing.isDurable ? SyncFolder(writing.path) : failure;
}

std::error_code Write(const std::filesystem::path& path, std::string_view bytes,
                      const std::function<void()>& beforeReplace, bool isDurable)
{
    const Writing writing{BehindLinks(path), bytes, beforeReplace, isDurable};
    struct stat old = {};
    if (stat(path.c_str(), &old) != 0)
    {
        return errno == ENOENT ? Replace(writing, nullptr) : LastError();
    }
    if (S_ISDIR(old.st_mode))
    {
        return std::make_error_code(std::errc::is_a_directory);
    }
    // A new file could take the place of one that is protected, and root may write to any.
    constexpr mode_t k_Writable = S_IWUSR | S_IWGRP | S_IWOTH;
    if ((old.st_mode & k_Writable) == 0 || access(path.c_str(), W_OK) != 0)
    {
        return std::make_error_code(std::errc::permission_denied);
    }
    const int stream = StandardStream(old);
    if (stream >= 0 || !S_ISREG(old.st_mode))
    {
        writing.CallBeforeReplace();
        return stream >= 0 ? WriteToDescriptor(stream, bytes) : WriteToSpecial(path, old, bytes);
    }
    return old.st_nlink > 1 ? Overwrite(writing, old) : Replace(writing, &old);
}

[[noreturn]] void ThrowWriteError(const std::filesystem::path& path, const std::error_code& reason)
{
    constexpr int k_OfMachine[] = {ENOSPC, EDQUOT, EFBIG, EIO, EMFILE, ENFILE, ENOMEM};
    const std::string message = "the file cannot be written: " + reason.message();
    if (std::ranges::find(k_OfMachine, reason.value()) != std::end(k_OfMachine))
    {
        throw MachineError(path.string(), {}, message);
    }
    throw AssetError(path.string(), {}, message);
}

} // namespace

std::filesystem::path BehindLinks(std::filesystem::path path)
{
    constexpr int k_MaxLinks = 40; // as the kernel has it
    std::error_code error;
    for (int i = 0; i < k_MaxLinks && std::filesystem::is_symlink(path, error); ++i)
    {
        path = path.parent_path() / std::filesystem::read_symlink(path, error);
    }
    return path;
}

std::error_code TryWriteFile(const std::filesystem::path& path, std::string_view bytes,
                             const std::function<void()>& beforeReplace)
{
    return Write(path, bytes, beforeReplace, false);
}

void WriteFile(const std::filesystem::path& path, std::string_view bytes,
               const std::function<void()>& beforeReplace)
{
    const std::error_code failure = Write(path, bytes, beforeReplace, true);
    if (failure == std::errc::no_such_device_or_address && std::filesystem::is_fifo(path))
    {
        throw AssetError(path.string(), {}, "the file cannot be written: nobody reads this pipe");
    }
    if (failure)
    {
        ThrowWriteError(path, failure);
    }
}

void AppendToFile(const std::filesystem::path& path, std::string_view bytes)
{
    const FileDescriptor file(open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666));
    const std::error_code failure =
        file.isOpen() ? WriteToDescriptor(file.get(), bytes) : LastError();
    if (failure)
    {
        ThrowWriteError(path, failure);
    }
    fdatasync(file.get()); // where there is no disk behind it, nothing is lost either
}

std::error_code WriteToDescriptor(int descriptor, std::string_view bytes)
{
    while (!bytes.empty())
    {
        const ssize_t count = write(descriptor, bytes.data(), bytes.size());
        if (count < 0 && errno == EAGAIN)
        {
            pollfd room{descriptor, POLLOUT, 0};
            poll(&room, 1, -1);
        }
        else if (count < 0 && errno != EINTR)
        {
            return LastError();
        }
        bytes.remove_prefix(count < 0 ? 0 : static_cast<std::size_t>(count));
    }
    return {};
}

FileLock::FileLock(const std::filesystem::path& file) : m_Descriptor(OpenFolderOf(file))
{
    Lock(LOCK_EX);
}

FileLock::FileLock(const std::filesystem::path& file, std::try_to_lock_t)
    : m_Descriptor(OpenFolderOf(file))
{
    Lock(LOCK_EX | LOCK_NB);
}

void FileLock::Lock(int operation)
{
    while (m_Descriptor >= 0 && flock(m_Descriptor, operation) != 0)
    {
        if (errno != EINTR)
        {
            m_IsHeldElsewhere = errno == EWOULDBLOCK;
            return;
        }
    }
}

FileLock::~FileLock()
{
    if (m_Descriptor >= 0)
    {
        close(m_Descriptor);
    }
}

} // namespace limn
