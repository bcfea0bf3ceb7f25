#include <iostream>
#include <limn/editor_stub/RunLimn.h>
#include <vector>

int main(int argc, char** argv)
{
    const std::vector<std::string> args(argv + (argc > 0 ? 1 : 0), argv + argc);
    return limn::RunLimn(args, std::cout, std::cerr);
}
