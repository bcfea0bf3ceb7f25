#pragma once

#include "console/Console.h"
#include "view/SceneView.h"

#include <map>
#include <span>
#include <string>
#include <vector>

namespace limn
{

/// Draws the scene into a PNG.
/// @return an ExitCode: BadInput if a validation layer reported errors
/// @throws AssetError, VulkanError; nothing is then written
int RunRender(const RenderOptions& options, Console& console);

/// Draws the scene into a PNG, and again whenever a file that it reaches changes, until SIGINT or
/// SIGTERM. What is wrong with a file is printed and the last good picture stays. `frames`, `stats`
/// and `trace` of the options play no role.
/// @return ExitCode::Done
/// @throws AssetError if the scene file or the output's folder is missing when it starts
/// @throws VulkanError
int RunWatch(const RenderOptions& options, Console& console);

/// `limn inspect`, as the command line has it.
struct InspectOptions
{
    /// A scene, a profile, or a renderer, pipeline or material of Unity's; or the name of a volume
    /// component, a feature's type or a shader.
    std::string file;
    bool json = false;
    std::vector<std::string> plugins; ///< modules with features of other people
    std::vector<std::string> roots;
};

/// Prints what the file sets: the parameters of volumes' components and the settings of features,
/// each with value, default and range; or what can be set of a component, feature or shader. Needs
/// no device and compiles nothing.
/// @return ExitCode::Done
/// @throws AssetError
int RunInspect(const InspectOptions& options, Console& console);

/// `limn explain`, as the command line has it.
struct ExplainOptions
{
    RenderOptions rendering; ///< its device draws where a pixel is asked about
    std::string object;      ///< "": all
    std::string pixel;       ///< as ParsePixel takes it; "": none is asked about
    bool json = false;
    std::string graph; ///< file for the frame as a picture; "": none
};

/// Prints what a scene's frame draws and why: volume values, passes, textures, variants, objects;
/// or what becomes of the draws at one pixel.
/// @return an ExitCode
/// @throws AssetError, also if the scene has no object of that name with a mesh
/// @throws VulkanError where a pixel is asked about
int RunExplain(const ExplainOptions& options, Console& console);

/// `limn check`, as the command line has it.
struct CheckOptions
{
    RenderOptions rendering;
    std::string expectations; ///< the file that states them
    std::string junit;        ///< file for the results as JUnit XML; "": none
    bool json = false;
    bool isUpdate = false; ///< write what does not hold anew
};

/// Compares a scene's frame with what a file expects of it, and prints what differs. Needs no
/// device.
/// @return an ExitCode: BadInput if an expectation does not hold
/// @throws AssetError, also for unknown names in the expectations; nothing is then written
int RunCheck(const CheckOptions& options, Console& console);

/// `limn report`, as the command line has it.
struct ReportCommandOptions
{
    std::vector<std::string> paths; ///< the scene, or folders of studies
    std::string output;             ///< the study's folder
    bool isQuick = false;
    bool isFull = false; ///< every combination of extreme inputs
    bool hasStability = false;
    std::vector<std::string> techniques;
    double budget = 0.0; ///< milliseconds; 0 = none
    int shard = 1;       ///< 1...shards
    int shards = 1;
    bool isMerge = false;
    bool isCompare = false;
};

/// Measures the error and the cost of outline techniques in a scene, and writes a report.
/// @param render  the picture's size, the device, caches, packages and roots
/// @return an ExitCode: BadInput if merged parts lack cells, or compared ones differ
/// @throws AssetError, VulkanError; what was measured until then stays in the folder
int RunReport(RenderOptions render, const ReportCommandOptions& options, Console& console);

/// `limn set`, as the command line has it.
struct SetOptions
{
    std::string file;               ///< a scene, or a profile or renderer of limn's or Unity's form
    std::vector<std::string> edits; ///< "NAME.path=value"; empty with `undo`
    std::vector<std::string> plugins; ///< modules with features of other people
    bool undo = false;
};

/// Changes a profile's parameters, or the settings of a scene's or renderer's features, in place,
/// all of them or none, and prints what they were. With `undo` it brings back the text from before
/// the last change of the file, which it keeps in the user's cache folder.
/// @return an ExitCode
/// @throws AssetError as SetScalars and SetFeatureSettings do, and where nothing can be undone
int RunSet(const SetOptions& options, Console& console);

/// Prints the JSON Schema (draft 2020-12) of one kind of file.
/// @param kind     "scene", "profile" or "material"
/// @param plugins  modules whose features and components are in it
/// @return an ExitCode
/// @throws AssetError if a plug-in cannot be used
int RunSchema(const std::string& kind, std::span<const std::string> plugins, Console& console);

/// `limn shader`, as the command line has it.
struct ShaderOptions
{
    std::vector<std::string> paths;    ///< files, and folders for the .shader files below them;
                                       ///< or .compute files
    std::string emit;                  ///< "", "spirv", "glsl", "glsles", "msl" or "hlsl"
    std::string outputFolder;          ///< of what is emitted
    std::vector<std::string> keywords; ///< on; empty = those of a new material
    int jobs = 0;                      ///< threads; 0 = one a core
    bool parseOnly = false;
    bool variants = false; ///< count them, compile nothing
    bool print = false;    ///< the files as canonical text, nothing else
    bool json = false;
    std::map<std::string, std::string> packages;
    std::vector<std::string> roots;
};

/// Checks ShaderLab files and describes them; compiles the kernels of .compute files.
/// @return an ExitCode: BadInput if a file has an error
/// @throws AssetError if a path is missing or something cannot be written
int RunShader(const ShaderOptions& options, Console& console);

/// `limn new`, as the command line has it.
struct NewOptions
{
    std::string kind;                  ///< "feature", "scene", "profile" or "material"
    std::string name;                  ///< of a feature's classes, or of the file
    std::vector<std::string> contents; ///< a profile's components, or the material's one shader
    std::string folder;                ///< of a feature: made, if it is not there
    std::string style; ///< of a feature: urp14 ("" as well): Execute; unity6: RecordRenderGraph
};

/// Writes the folder of a render feature that builds and draws at once (component, feature, pass,
/// shader, scene, test), or a scene with its profile, a profile or a material. No file is replaced.
/// @return an ExitCode: WrongUsage for a name that cannot be a class, and for options of other
/// kinds
/// @throws AssetError if a file cannot be written or is there already, the folder is not empty, or
///     a component or shader is unknown
int RunNew(const NewOptions& options, Console& console);

/// `limn port`, as the command line has it.
struct PortOptions
{
    std::vector<std::string> files; ///< C#, not empty
    std::string folder;             ///< made, if it is not there
};

/// Writes the folder of a plug-in in which a render feature of Unity's is begun in C++, and says
/// what of the C# limn does not have or know.
/// @return an ExitCode
/// @throws AssetError if a file is no C#, none has a feature, or the folder cannot be written
int RunPort(const PortOptions& options, Console& console);

/// Says what limn finds on this machine.
/// @param device  which device is asked for, as VulkanDeviceOptions::device
/// @return an ExitCode: MachineLacksIt if no device can be used
int RunDoctor(const std::string& device, Console& console);

} // namespace limn
