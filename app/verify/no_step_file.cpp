// Stands in for step_file.cpp in builds without OpenCASCADE.
#include "app/verify/step_file.h"

namespace app {

struct StepFile::Shapes {};

base::Result<StepFile> StepFile::read(const std::filesystem::path&, bool) {
    return base::Error{base::ErrorCode::BadUsage,
                       "this build cannot read STEP files: it was made without OpenCASCADE (Debian: "
                       "libocct-data-exchange-dev)"};
}

StepFile::StepFile(std::unique_ptr<Shapes> shapes) : m_shapes(std::move(shapes)) {}
StepFile::StepFile(StepFile&&) noexcept = default;
StepFile::~StepFile() = default;

std::size_t StepFile::size() const {
    return 0;
}

StepSolid StepFile::solid(std::size_t) const {
    return {};
}

bool StepFile::contains(std::size_t, const std::array<double, 3>&) const {
    return false;
}

}  // namespace app
