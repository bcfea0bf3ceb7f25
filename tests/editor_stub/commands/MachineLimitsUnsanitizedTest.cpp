#include "Mentions.h"
#include "commands/CommandRun.h"
#include "commands/WorkingFolder.h"

#include <fstream>
#include <gmock/gmock.h>
#include <sys/resource.h>

// What limn says where the machine gives it too little: exit code 3 and a sentence.

namespace limn::test
{

namespace
{

/// While it lives, the process can open nothing more.
class NoDescriptors
{
public:
    NoDescriptors()
    {
        getrlimit(RLIMIT_NOFILE, &m_Before);
        const rlimit limit{3, m_Before.rlim_max};
        setrlimit(RLIMIT_NOFILE, &limit);
    }
    ~NoDescriptors() { setrlimit(RLIMIT_NOFILE, &m_Before); }
    NoDescriptors(const NoDescriptors&) = delete;
    NoDescriptors& operator=(const NoDescriptors&) = delete;

private:
    rlimit m_Before{};
};

/// stdout and stderr of a shell that does this, then runs `limn ARGUMENTS`, and "exit N" behind
/// them.
std::string RunAfter(const std::string& preparation, const std::string& arguments)
{
    return RunInPipe("(" + preparation + "; '" + LimnExecutable() + "' " + arguments +
                     ") 2>&1; echo exit $?");
}

} // namespace

TEST(MachineLimits, NoDescriptorForAFileThatIsReadEndsWith3)
{
    const WorkingFolder working;
    WriteProject(working.folder);
    working.folder.Write("F.cs", "class F : ScriptableRendererFeature { }\n");
    for (const auto& [verb, file] :
         {std::pair("inspect", "s.scene.yaml"), std::pair("inspect", "p.profile.yaml"),
          std::pair("explain", "s.scene.yaml"), std::pair("shader", "a.shader"),
          std::pair("port", "F.cs")})
    {
        std::vector<std::string> words{verb, file};
        if (words[0] == "port")
        {
            words.insert(words.end(), {"-o", "out"});
        }
        RunCommand({"version"}); // makes the cache folder
        CommandRun run;
        {
            const NoDescriptors none;
            run = RunCommand(words);
        }
        EXPECT_EQ(3, run.exitCode) << verb << " " << file;
        EXPECT_THAT(LinesOf(run.err),
                    testing::ElementsAre(Mentions(words[1], "read", "Too many open files")));
        EXPECT_FALSE(std::filesystem::exists("out"));
    }
}

TEST(MachineLimits, TooLittleMemoryIsSaidInWords)
{
    const WorkingFolder working;
    WriteProject(working.folder);
    std::ofstream("vast.png").close();
    std::filesystem::resize_file("vast.png", std::uintmax_t{500} << 20); // of which none is on disk
    working.folder.Write("m.shader",
                         "Shader \"M\" { Properties { _Map (\"\", 2D) = \"\" {} } SubShader "
                         "{ Pass { } } }");
    working.folder.Write("vast.scene.yaml",
                         "camera: {}\nmaterials: {m: {shader: m.shader, _Map: vast.png}}\n");
    EXPECT_EQ("error: there is not enough memory\nexit 3\n",
              RunAfter("ulimit -v 400000", "inspect vast.scene.yaml"));
}

TEST(MachineLimits, AFileLargerThanMayBeIsSaidInWords)
{
    const WorkingFolder working;
    EXPECT_EQ("fog/DepthFogRendererFeature.cpp: error: the file cannot be written: File too "
              "large\nexit 3\n",
              RunAfter("ulimit -f 2", "new feature DepthFog -o fog"));
    EXPECT_FALSE(std::filesystem::exists("fog"));
}

TEST(MachineLimits, AWorkingFolderThatIsGoneIsSaidInWords)
{
    const WorkingFolder working;
    for (const std::string arguments :
         {"schema scene", "inspect s.scene.yaml", "new feature A -o a"})
    {
        std::filesystem::create_directory("gone");
        EXPECT_EQ("error: the working directory is not there any more; change into one that is\n"
                  "exit 3\n",
                  RunAfter("cd gone; rmdir ../gone", arguments));
    }
}

} // namespace limn::test
