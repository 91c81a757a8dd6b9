#include "app/common/resources.h"

namespace app {

namespace fs = std::filesystem;

fs::path sampleBoard() {
    const fs::path name = fs::path("sample") / "ocp_tap_sa45_odb.tgz";
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    const fs::path installed = program.parent_path().parent_path() / "share" / "copperscope" / name;
    return !error && fs::exists(installed, error) ? installed : fs::path(COPPERSCOPE_SOURCE_RESOURCES) / name;
}

}  // namespace app
