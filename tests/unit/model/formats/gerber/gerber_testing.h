#pragma once

#include <QDir>
#include <QFileInfo>
#include <QTemporaryDir>
#include <algorithm>
#include <fstream>
#include <map>
#include <string>

#include "model/formats/registry.h"

/// Small Gerber jobs, written into a folder and opened as any board is.
namespace gerber_testing {

using Files = std::map<std::string, std::string>;
using Board = base::Result<std::shared_ptr<const model::Document>>;

inline constexpr const char* kHead = "%FSLAX46Y46*%\n%MOMM*%\n";

inline std::string image(const std::string& body, const std::string& function = "") {
    return (function.empty() ? "" : "%TF.FileFunction," + function + "*%\n") + kHead + body + "M02*\n";
}

/// Two pads joined by a track, and a third one.
inline const std::string kCopper =
    "%ADD10C,1.5*%%ADD11C,0.3*%D10*X2000000Y2000000D03*X8000000D03*Y8000000D03*D11*"
    "X2000000Y2000000D02*X8000000D01*\n";
/// Pads near the corners of a square of 10 mm.
inline const std::string kWideCopper =
    "%ADD10C,1.5*%%ADD11C,0.3*%D10*X1000000Y1000000D03*X9000000D03*Y9000000D03*X1000000D03*D11*"
    "X1000000Y1000000D02*X9000000D01*\n";
inline const std::string kNamedCopper =
    "%TA.AperFunction,ComponentPad*%%ADD10C,1.5*%%TD*%%TO.N,A*%%TO.P,J1,1*%D10*X2000000Y2000000D03*"
    "%TO.P,J1,2*%X8000000D03*%TO.N,B*%%TO.P,J1,3*%Y8000000D03*%TD*%\n";
/// A square of 10 mm, its sides in any order.
inline const std::string kOutline =
    "%ADD10C,0.1*%D10*X0Y0D02*X10000000D01*X0Y10000000D02*Y0D01*X10000000D02*"
    "Y10000000D01*X0D01*\n";
inline constexpr const char* kDrills = "M48\nMETRIC\nT1C0.8\n%\nT1\nX2.0Y2.0\nX8.0Y2.0\nX8.0Y8.0\nM30\n";

class Job {
public:
    explicit Job(const Files& files) {
        for (const auto& [name, text] : files) {
            QDir(m_folder.path()).mkpath(QFileInfo(QString::fromStdString(name)).path());
            std::ofstream(path(name), std::ios::binary) << text;
        }
    }
    [[nodiscard]] std::string path(const std::string& name = "") const {
        return (m_folder.path() + "/").toStdString() + name;
    }
    [[nodiscard]] Board open(const std::string& name = "", const model::ReadOptions& options = {}) const {
        base::Progress progress;
        return model::readBoard(path(name), options, progress);
    }

private:
    QTemporaryDir m_folder;
};

inline bool isReported(const model::Document& board, const std::string& words) {
    return std::ranges::any_of(board.diagnostics.entries(),
                               [&](const auto& entry) { return entry.text.find(words) != std::string::npos; });
}

}  // namespace gerber_testing
