#include "commands/Commands.h"

#include <exception>
#include <iostream>
#include <limn/base/Diagnostic.h>

/// `first_picture SCENE FILE` draws as `limn render SCENE -o FILE` does.
int main(int argc, char** argv)
{
    limn::Console console(std::cout, std::cerr);
    try
    {
        if (argc != 3)
        {
            console.Error("first_picture takes a scene and the PNG to write");
            return 2;
        }
        limn::RenderOptions options;
        options.scene = argv[1];
        options.output = argv[2];
        return limn::RunRender(options, console);
    }
    catch (const limn::AssetError& error)
    {
        console.Print(error.diagnostics());
        return 1;
    }
    catch (const std::exception& error)
    {
        console.Error(error.what());
        return 1;
    }
}
