#pragma once

#include "port/csharp/CSharpFile.h"

#include <string>
#include <vector>

namespace limn
{

/// A call of AddRasterRenderPass, AddUnsafePass or AddComputePass with the block of its builder:
/// renderGraph.AddRasterRenderPass<PassData>("Name", out var passData).
struct CSharpGraphPass
{
    std::string call; ///< "AddRasterRenderPass"
    SourceLocation location;
    CSharpWords name;      ///< the first argument; empty where there is none
    std::string problem;   ///< why the rest is not known; "" if it is known
    std::string graph;     ///< "renderGraph"
    std::string data;      ///< the type of the pass's data
    std::string dataName;  ///< "passData"
    CSharpWords sampler;   ///< the third argument; empty where there is none
    std::string builder;   ///< the builder's name
    CSharpWords body;      ///< the words behind the call, until the builder's scope ends
    std::size_t begin = 0; ///< where its statement begins in the file's text
    std::size_t end = 0;   ///< the place behind its statement
};

/// A call builder.SetRenderFunc(...) in a body.
struct CSharpRenderFunction
{
    std::vector<std::string> parameters; ///< two, or none if they are not known
    CSharpWords body;                    ///< the function's body; for `{ ... }` without the braces
    SourceLocation location;
    std::size_t begin = 0; ///< where the statement begins in the file's text
    std::size_t end = 0;   ///< the place behind its ;
};

/// Returns the graph passes of a method in their order. A pass under a condition or in a loop has a
/// problem.
std::vector<CSharpGraphPass> FindGraphPasses(const CSharpMethod& method);

/// Returns the render functions among the statements of the pass's body.
std::vector<CSharpRenderFunction> FindRenderFunctions(const CSharpGraphPass& pass);

/// Returns the words of each statement like `builder.AllowPassCulling(false);`, whose argument is
/// true or false.
std::vector<CSharpWords> FindSwitches(const CSharpGraphPass& pass);

} // namespace limn
