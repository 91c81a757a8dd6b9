#pragma once

#include <QFile>
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "model/formats/ipc2581/ipc_reader.h"
#include "tests/locations.h"

/// Files of IPC-2581 that tests make, and what is asked of the job that is read from them.
namespace ipc_files {

inline constexpr model::Nm kMm = 1'000'000;

[[nodiscard]] inline base::Result<model::formats::DrawnJob> parse(const std::string& text,
                                                                  const std::string& step = {}) {
    base::Progress progress;
    return model::ipc2581::parseJob(text, "board.xml", {step, false}, progress);
}

/// A file with two copper layers in millimetres around what is in its step, its dictionaries and its CadData.
[[nodiscard]] inline std::string fileWith(const std::string& step, const std::string& content = {},
                                          const std::string& cadData = {}) {
    return "<IPC-2581 revision='C'><Content>" + content +
           "</Content><Ecad><CadHeader units='MILLIMETER'/><CadData>"
           "<Layer name='T' layerFunction='CONDUCTOR' side='TOP'/>"
           "<Layer name='B' layerFunction='CONDUCTOR' side='BOTTOM'/>" +
           cadData + "<Step name='s'>" + step + "</Step></CadData></Ecad></IPC-2581>";
}

[[nodiscard]] inline std::string onTop(const std::string& sets) {
    return "<LayerFeature layerRef='T'>" + sets + "</LayerFeature>";
}

[[nodiscard]] inline std::string features(const std::string& shape) {
    return onTop("<Set net='A'><Features><Location x='0' y='0'/>" + shape + "</Features></Set>");
}

[[nodiscard]] inline std::size_t layerNamed(const model::formats::DrawnJob& job, std::string_view name) {
    const auto found = std::ranges::find(job.layers, name, &model::formats::DrawnLayer::name);
    return static_cast<std::size_t>(found - job.layers.begin());
}

[[nodiscard]] inline const std::vector<model::formats::DrawnFeature>& featuresOn(const model::formats::DrawnJob& job,
                                                                                 std::string_view layer) {
    return job.steps[0].features[layerNamed(job, layer)];
}

[[nodiscard]] inline const model::formats::PadShape& shapeOf(const model::formats::DrawnJob& job,
                                                             const model::formats::DrawnFeature& feature) {
    return job.steps[0].symbols[static_cast<std::size_t>(feature.symbol)].shape;
}

/// Is there a message with these words? Messages begin with a capital, so the first letter is not compared.
[[nodiscard]] inline bool reports(const model::formats::DrawnJob& job, const std::string& words,
                                  std::uint32_t line = 0) {
    const std::string part = words.substr(1);
    return std::ranges::any_of(job.diagnostics.entries(), [&](const model::Diagnostic& d) {
        return d.text.find(part) != std::string::npos && (line == 0 || d.line == line);
    });
}

[[nodiscard]] inline std::string corpusFile(const char* name) {
    QFile file(QString::fromStdString((std::filesystem::path(locations::kFuzzCorpus) / "ipc2581" / name).string()));
    return file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : std::string();
}

}  // namespace ipc_files
