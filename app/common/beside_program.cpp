#include "app/common/beside_program.h"

namespace app {

std::filesystem::path besideProgram(const std::filesystem::path& relative) {
    std::error_code error;
    const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
    return (program.parent_path() / relative).lexically_normal();
}

}  // namespace app
