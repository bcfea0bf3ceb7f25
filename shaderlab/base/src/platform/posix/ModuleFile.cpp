#include <limn/base/ModuleFile.h>

#include "platform/posix/FileDescriptor.h"

#include <cstdlib>
#include <cstring>
#include <cxxabi.h>
#include <dlfcn.h>
#include <limn/base/Diagnostic.h>
#include <limn/base/ReadFile.h>
#include <limn/base/WriteFile.h>
#include <link.h>
#include <memory>
#include <optional>

namespace limn
{

namespace
{

using ElfHeader = ElfW(Ehdr);
using ElfSegment = ElfW(Phdr);

constexpr char k_NativeClass = sizeof(void*) == 8 ? ELFCLASS64 : ELFCLASS32;

/// A part of a module's file, as its headers have it.
struct Part
{
    std::uint64_t offset = 0;
    std::uint64_t size = 0;

    bool isWithin(std::string_view bytes) const
    {
        return offset <= bytes.size() && size <= bytes.size() - offset;
    }
};

bool IsWhole(const ElfHeader& header, std::string_view bytes)
{
    const Part segments{header.e_phoff, std::uint64_t{header.e_phnum} * header.e_phentsize};
    const Part sections{header.e_shoff, std::uint64_t{header.e_shnum} * header.e_shentsize};
    if (!segments.isWithin(bytes) || !sections.isWithin(bytes) ||
        header.e_phentsize != sizeof(ElfSegment))
    {
        return false;
    }
    for (std::size_t i = 0; i < header.e_phnum; ++i)
    {
        ElfSegment segment;
        std::memcpy(&segment, bytes.data() + segments.offset + i * sizeof(segment),
                    sizeof(segment));
        if (!Part{segment.p_offset, segment.p_filesz}.isWithin(bytes))
        {
            return false;
        }
    }
    return true;
}

/// Returns whether the part is there that linkers write last: they make the file as long as it will
/// be, of zeros, and the system's loader crashes on these.
bool IsWritten(const ElfHeader& header, std::string_view bytes)
{
    ElfW(Shdr) names;
    if (header.e_shstrndx >= header.e_shnum || header.e_shentsize != sizeof(names))
    {
        return header.e_shnum == 0; // a module without a table of sections
    }
    std::memcpy(&names, bytes.data() + header.e_shoff + header.e_shstrndx * sizeof(names),
                sizeof(names));
    return names.sh_type == SHT_STRTAB;
}

[[noreturn]] void Refuse(const std::string& name, const std::string& reason)
{
    throw AssetError(name, {}, "the file cannot be loaded: " + reason);
}

/// A file with these bytes, until the end of the scope.
class ModuleCopy
{
public:
    ModuleCopy(const std::string& name, std::string_view bytes)
        : m_Path(std::filesystem::temp_directory_path() / "limn-XXXXXX.so")
    {
        FileDescriptor file(mkstemps(m_Path.data(), 3));
        if (!file.isOpen())
        {
            Refuse(name, m_Path + " cannot be made: " + LastError().message());
        }
        if (WriteToDescriptor(file.get(), bytes) || file.Close())
        {
            unlink(m_Path.c_str());
            Refuse(name, "its copy " + m_Path + " cannot be written: the disk may be full");
        }
    }
    ~ModuleCopy() { unlink(m_Path.c_str()); }
    ModuleCopy(const ModuleCopy&) = delete;
    ModuleCopy& operator=(const ModuleCopy&) = delete;

    const std::string& path() const { return m_Path; }

private:
    std::string m_Path;
};

std::string Demangled(const std::string& symbol)
{
    int status = 0;
    const std::unique_ptr<char, decltype(&std::free)> text(
        abi::__cxa_demangle(symbol.c_str(), nullptr, nullptr, &status), &std::free);
    return text ? text.get() : symbol;
}

/// Returns the loader's message without the path at its beginning.
std::string LoaderText(const std::string& path)
{
    const char* error = dlerror();
    std::string text = error ? error : "the system gives no reason";
    if (text.starts_with(path + ": "))
    {
        text.erase(0, path.size() + 2);
    }
    constexpr std::string_view k_Undefined = "undefined symbol: ";
    const std::size_t at = text.find(k_Undefined);
    if (at == std::string::npos)
    {
        return text;
    }
    const std::string symbol = text.substr(at + k_Undefined.size());
    return "it uses " + Demangled(symbol) +
           ", which neither it nor limn has; add the source that "
           "defines it, or build it again with this limn";
}

/// Returns what is wrong if the bytes are those of a module that ends too early, and "" otherwise.
/// The system's loader would map the missing rest and crash; it reports all other problems itself.
std::string ModuleProblem(std::string_view bytes)
{
    ElfHeader header;
    if (bytes.size() < sizeof(header) || !bytes.starts_with(ELFMAG) ||
        bytes[EI_CLASS] != k_NativeClass)
    {
        return {};
    }
    std::memcpy(&header, bytes.data(), sizeof(header));
    const std::string problem =
        !IsWhole(header, bytes)
            ? "the file ends too early, after " + std::to_string(bytes.size()) + " bytes"
        : !IsWritten(header, bytes) ? "the end of the file is not there yet"
                                    : "";
    return problem.empty() ? "" : problem + "; is it being written, or was the linker stopped?";
}

} // namespace

bool IsWholeModule(const std::filesystem::path& path)
{
    const FileContent content = TryReadFile(path, k_MaxDataBytes);
    return content.isRead() && content.bytes.size() >= sizeof(ElfHeader) &&
           ModuleProblem(content.bytes).empty();
}

const void* OpenModule(const std::filesystem::path& path, const std::string& name, bool isCopied,
                       const char* symbol)
{
    const FileContent content = TryReadFile(path, k_MaxDataBytes);
    const std::string problem = content.isRead() ? ModuleProblem(content.bytes) : content.problem;
    if (!problem.empty())
    {
        Refuse(name, problem);
    }
    std::optional<ModuleCopy> copy;
    if (isCopied)
    {
        copy.emplace(name, content.bytes);
    }
    const std::string file = copy ? copy->path() : path.string();
    dlerror();
    void* module = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
    if (!module)
    {
        Refuse(name, LoaderText(file));
    }
    return dlsym(module, symbol);
}

const void* ModuleOf(const void* symbol)
{
    Dl_info info{};
    return dladdr(symbol, &info) != 0 ? info.dli_fbase : nullptr;
}

} // namespace limn
