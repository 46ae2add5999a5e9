#include <iostream>

#include <unistd.h>

#include "core/cli/run.h"

int main(int argc, char** argv) {
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    return kumite::cli::run(arguments, std::cout, std::cerr, ::isatty(STDERR_FILENO) != 0);
}
