#pragma once

#include <QMap>
#include <QString>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "model/session/session.h"
#include "tests/unit/model/formats/odb/odb_testing.h"

/// What tests of sessions share: a board with a place for its session, and parts to write there.
namespace session_board {

inline const std::vector<model::ThicknessOverride> kOneThickness = {{"TOP", 70'000}};
inline const std::vector<model::ThicknessOverride> kNoThickness;

[[nodiscard]] inline model::session::SavedView viewNamed(const char* name) {
    return {
        name,           "pcb",       {{1.5, -2.25, 0.1}, 30.0, 0.0, -90.0, true}, {{0, 0, 0}, 80.5, 33.0, -40.0, false},
        {"TOP", "SMT"}, std::nullopt};
}

[[nodiscard]] inline model::Measurement measured(const char* name) {
    model::Measurement measurement{name, "pcb", model::MeasurementKind::Clearance};
    measurement.from = {1.5, -2, "TOP", "GND", "edge", "pad U1.7"};
    measurement.to = {4.5, 2, "SMT", "", "centre"};
    measurement.dz = 12.0;
    measurement.overlap = 0.25;
    measurement.notes = {"a remark"};
    measurement.isShown = false;
    return measurement;
}

/// A board beside which sessions may lie.
struct Location {
    odb_testing::Folder folder;
    std::filesystem::path board = folder.path() / "job.tgz";
    std::shared_ptr<const model::Document> document = odb_testing::read(odb_testing::dataJob("everything"));

    [[nodiscard]] model::session::LoadedSession load() const { return model::session::loadSession(board, *document); }
    [[nodiscard]] base::Status save(const std::vector<model::ThicknessOverride>& thicknesses,
                                    model::session::KnownPart* known = nullptr) const {
        return model::session::saveThicknesses(board, *document, thicknesses, known);
    }
    /// Those of the file.
    [[nodiscard]] QMap<QString, int> thicknesses() const {
        QMap<QString, int> byLayer;
        for (const model::ThicknessOverride& set : load().session.thicknesses) {
            byLayer[QString::fromStdString(set.layer)] = static_cast<int>(set.thickness);
        }
        return byLayer;
    }
    [[nodiscard]] base::Status save(const std::vector<model::session::SavedView>& views) const {
        return model::session::saveViews(board, *document, views);
    }
    [[nodiscard]] std::string file() const { return odb_testing::readFile(model::session::sessionPath(board)); }
    void write(const std::string& text) const { odb_testing::writeFile(model::session::sessionPath(board), text); }
};

}  // namespace session_board
