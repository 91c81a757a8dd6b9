// write_seeds FOLDER: writes the seeds of every fuzz target to FOLDER/<target>/, and prints the names of the targets.

#include <cstdio>
#include <filesystem>
#include <fstream>

#include "targets.h"

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: write_seeds FOLDER\n");
        return 1;
    }
    for (const fuzz::Target& target : fuzz::targets()) {
        const std::filesystem::path folder = std::filesystem::path(argv[1]) / target.name;
        std::filesystem::create_directories(folder);
        std::size_t number = 0;
        for (const fuzz::File& seed : fuzz::seedsOf(target)) {
            std::ofstream(folder / ("seed" + std::to_string(number++)), std::ios::binary) << seed.text;
        }
        std::puts(target.name);
    }
    return 0;
}
