#pragma once

#include <array>
#include <filesystem>
#include <memory>

#include "model/base/progress.h"
#include "model/base/result.h"

namespace app {

/// A solid as another program understands it. Lengths in nm.
struct StepSolid {
    double volume = 0.0;          ///< nm³
    double tolerance = 0.0;       ///< the largest distance between a vertex or edge and what it bounds
    bool isValid = false;         ///< topology and geometry agree
    bool isClosed = false;        ///< one closed shell, each edge in two faces
    std::array<double, 6> box{};  ///< x, y, z of the least corner, then of the greatest
};

/// A STEP file read by OpenCASCADE, an optional package: an independent reader of what we write. Solids of placed
/// shapes count each time they are placed, in the order of the assembly tree.
class StepFile {
public:
    virtual ~StepFile() = default;

    /// Can STEP files be read here? To be asked before one is written to be read back. Errors: DeviceFailed where the
    /// module (app/step_reader) is missing or cannot be loaded.
    [[nodiscard]] static base::Status checkReader();
    /// `isStrict` reads without the repairs that readers make on their own, which hide wrong loops. Loads the module
    /// that reads. Stops late: a large file is taken apart before the reader asks. Errors: BadInput, Cancelled, those
    /// of checkReader, and strictly those of TemporaryFolder.
    [[nodiscard]] static base::Result<std::unique_ptr<StepFile>> read(const std::filesystem::path& path, bool isStrict,
                                                                      base::Progress& progress);

    [[nodiscard]] virtual std::size_t size() const = 0;
    [[nodiscard]] virtual StepSolid solid(std::size_t row) const = 0;
    /// Is the point (nm) in the solid? Points on the surface count as in it.
    [[nodiscard]] virtual bool contains(std::size_t row, const std::array<double, 3>& point) const = 0;
};

}  // namespace app
