#pragma once

#include <string>
#include <string_view>

#include "model/formats/kicad/board_drawing.h"
#include "model/text/whole_file.h"
#include "tests/locations.h"

/// What tests of boards of KiCad read.
namespace kicad_testing {

using namespace model;
using formats::DrawnFeature;
using formats::DrawnJob;
using formats::DrawnKind;

inline constexpr Nm kMm = 1'000'000;

/// A file of tests/data/kicad.
[[nodiscard]] inline std::string fileText(const char* name) {
    return *readWholeFile(std::filesystem::path(locations::kTestData) / "kicad" / name);
}

[[nodiscard]] inline DrawnJob drawn(std::string_view text, const kicad::Project& project = {}) {
    base::Progress progress;
    auto job = kicad::drawBoard(text, "board.kicad_pcb", project, progress);
    return job ? std::move(*job) : DrawnJob();
}

/// A board of two copper layers with mask and paste that holds these items.
[[nodiscard]] inline DrawnJob boardWith(std::string_view items, std::string_view setup = "",
                                        std::string_view version = "20241229") {
    return drawn("(kicad_pcb (version " + std::string(version) +
                 ") (layers (0 \"F.Cu\" signal) (4 \"In1.Cu\" signal) (2 \"B.Cu\" signal) (1 \"F.Mask\" user) (3 "
                 "\"B.Mask\" user) (13 \"F.Paste\" user) (25 \"Edge.Cuts\" user)) (setup " +
                 std::string(setup) + ") (net 1 \"GND\")\n" + std::string(items) + ")");
}

[[nodiscard]] inline std::size_t rowOf(const DrawnJob& job, std::string_view name) {
    for (std::size_t row = 0; row < job.layers.size(); ++row) {
        if (job.layers[row].name == name) {
            return row;
        }
    }
    qFatal("there is no layer %s", std::string(name).c_str());
}

[[nodiscard]] inline const std::vector<DrawnFeature>& on(const DrawnJob& job, std::string_view name) {
    return job.steps[0].features[rowOf(job, name)];
}

[[nodiscard]] inline const formats::PadShape& shapeOf(const DrawnJob& job, const DrawnFeature& feature) {
    return job.steps[0].symbols[static_cast<std::size_t>(feature.symbol)].shape;
}

[[nodiscard]] inline std::string netOf(const DrawnJob& job, const DrawnFeature& feature) {
    return feature.net == formats::kNoRow ? std::string()
                                          : job.steps[0].nets[static_cast<std::size_t>(feature.net)].name;
}

/// How often a message was given whose text holds these words.
[[nodiscard]] inline std::uint32_t messages(const Diagnostics& diagnostics, std::string_view words) {
    std::uint32_t count = 0;
    for (const Diagnostic& entry : diagnostics.entries()) {
        count += entry.text.find(words) != std::string::npos ? entry.count : 0;
    }
    return count;
}

}  // namespace kicad_testing
