#include <limn/base/RunProgram.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <limn/base/TerminalText.h>
#include <memory>
#include <spawn.h>
#include <stdexcept>
#include <sys/wait.h>
#include <system_error>

extern char** environ;

namespace limn
{

namespace
{

struct CloseFile
{
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using ScratchFile = std::unique_ptr<std::FILE, CloseFile>;

ScratchFile OpenTemporary(const std::string& text = {})
{
    ScratchFile file(std::tmpfile());
    if (!file || std::fwrite(text.data(), 1, text.size(), file.get()) != text.size() ||
        std::fflush(file.get()) != 0)
    {
        throw std::system_error(errno, std::generic_category(), "a temporary file");
    }
    std::rewind(file.get());
    return file;
}

std::string ReadAll(std::FILE* file)
{
    std::string result;
    std::rewind(file);
    std::array<char, 65536> part{};
    for (std::size_t n = 0; (n = std::fread(part.data(), 1, part.size(), file)) > 0;)
    {
        result.append(part.data(), n);
    }
    return result;
}

} // namespace

std::string RunProgram(std::vector<std::string> words, const std::string& input,
                       const std::string& need)
{
    const ScratchFile in = OpenTemporary(input);
    const ScratchFile out = OpenTemporary();
    const ScratchFile complaints = OpenTemporary();
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, fileno(in.get()), 0);
    posix_spawn_file_actions_adddup2(&actions, fileno(out.get()), 1);
    posix_spawn_file_actions_adddup2(&actions, fileno(complaints.get()), 2);
    std::vector<char*> args;
    for (std::string& word : words)
    {
        args.push_back(word.data());
    }
    args.push_back(nullptr);
    pid_t child = 0;
    const int error = posix_spawnp(&child, args[0], &actions, nullptr, args.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0)
    {
        throw std::system_error(error, std::generic_category(), need);
    }
    int status = 0;
    while (waitpid(child, &status, 0) == -1 && errno == EINTR)
    {
    }
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    {
        throw std::runtime_error("the program '" + words[0] +
                                 "' failed: " + Sentence(ReadAll(complaints.get())));
    }
    return ReadAll(out.get());
}

} // namespace limn
