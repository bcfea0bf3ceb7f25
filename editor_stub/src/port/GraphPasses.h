#pragma once

#include "port/csharp/CSharpFile.h"

#include <string>
#include <string_view>
#include <vector>

namespace limn
{

/// renderGraph.AddRasterRenderPass<PassData>("Name", out var passData), AddUnsafePass or
/// AddComputePass, and the block of its builder.
struct CSharpGraphPass
{
    std::string call; ///< "AddRasterRenderPass"
    SourceLocation location;
    CSharpWords name;      ///< the first argument; empty where there is none
    std::string problem;   ///< why the rest is not known; "" = it is
    std::string graph;     ///< "renderGraph"
    std::string data;      ///< its type
    std::string dataName;  ///< "passData"
    CSharpWords sampler;   ///< the third argument; empty where there is none
    std::string builder;   ///< its name
    CSharpWords body;      ///< behind the call, as far as the builder lives
    std::size_t begin = 0; ///< in the file's text, of its statement
    std::size_t end = 0;   ///< behind it
};

/// builder.SetRenderFunc(...) of a body.
struct CSharpRenderFunction
{
    std::vector<std::string> parameters; ///< two, or none where they are not known
    CSharpWords body;                    ///< what it does; of `{ ... }` without the braces
    SourceLocation location;
    std::size_t begin = 0; ///< in the file's text, of the statement
    std::size_t end = 0;   ///< behind its ;
};

/// In their order. Those that stand under a condition or in a loop have a problem.
std::vector<CSharpGraphPass> FindGraphPasses(const CSharpMethod& method);

/// The ones among the statements of the body.
std::vector<CSharpRenderFunction> FindRenderFunctions(const CSharpGraphPass& pass);

/// `builder.AllowPassCulling(false);` and its like, whose arguments are true or false: the words.
std::vector<CSharpWords> FindSwitches(const CSharpGraphPass& pass);

} // namespace limn
