// The table of formats: each writes its file, and refuses what it does not know before there is one. What is in the
// files is tested beside their writers.
#include "model/export/files/export_file.h"

#include <QTemporaryDir>
#include <QtTest>
#include <fstream>
#include <functional>
#include <map>

#include "tests/unit/model/measure/measure_fixture.h"

using namespace model;
using namespace measuring;
namespace fs = std::filesystem;

namespace {

/// A pad with a hole, an area, and in line 7 of the file "features" a track without width, which is no solid.
std::shared_ptr<const Document> smallBoard() {
    DocumentBuilder builder;
    builder.job().name = "small";
    builder.job().step = "pcb";
    addLayers(builder);
    builder.layer(LayerId{Top}).file = "features";
    builder.layer(LayerId{Top}).side = LayerSide::Top;
    builder.beginLayer(LayerId{Top});
    builder.addCircle({{0, 0}, kMm, 0}, of(builder.addNet("N"), kPad));
    builder.addArea({builder.addShape(rectangle({2 * kMm, 0}, {5 * kMm, kMm})), {}}, {});
    DocumentBuilder::Origin line7;
    line7.line = 7;
    builder.addLine({{0, 0}, {3 * kMm, 0}, 0, 0}, line7);
    builder.beginLayer(LayerId{Drill});
    builder.addCircle({{0, 0}, 400'000, 300'000}, flagged(kHole | kPlated));
    builder.setProfile(builder.addShape(rectangle({-kMm, -kMm}, {6 * kMm, 2 * kMm})));
    return builder.finish();
}

std::string startOf(const fs::path& path, std::size_t count) {
    std::ifstream file(path, std::ios::binary);
    std::string start(count, '\0');
    file.read(start.data(), static_cast<std::streamsize>(count));
    return start;
}

/// Each choice that only some formats know, and whether a format is one of them.
struct Choice {
    const char* option;
    std::function<void(ExportRequest&)> choose;
    std::function<bool(const ExportFormat&)> isKnown;
};
const std::vector<Choice>& choices() {
    static const std::vector<Choice> kChoices = {
        {"--min-hole", [](ExportRequest& r) { r.choice.minHole = 1000; }, [](auto& f) { return f.isSolid; }},
        {"--outer-only",
         [](ExportRequest& r) {
             r.choice.isOuterOnly = true;
             r.choice.layers = {LayerId{Top}};
         },
         [](auto& f) { return f.isSolid; }},
        {"--merge", [](ExportRequest& r) { r.choice.isMerged = true; }, [](auto& f) { return f.isSolid; }},
        {"--as-designed", [](ExportRequest& r) { r.choice.isAsDesigned = true; }, [](auto& f) { return f.isSolid; }},
        {"--written-out", [](ExportRequest& r) { r.isWrittenOut = true; }, [](auto& f) { return f.isStep; }},
        {"--polylines", [](ExportRequest& r) { r.hasPolylines = true; }, [](auto& f) { return f.isStep; }},
        {"--one-page", [](ExportRequest& r) { r.isOnePage = true; }, [](auto& f) { return f.isPdf; }},
        {"--mirror-bottom", [](ExportRequest& r) { r.isMirrored = true; }, [](auto& f) { return f.isPdf; }},
        {"--compress", [](ExportRequest& r) { r.isCompressed = true; }, [](auto& f) { return f.isGlb; }},
        {"--instancing", [](ExportRequest& r) { r.isInstanced = true; }, [](auto& f) { return f.isGlb; }},
        {"--one-part", [](ExportRequest& r) { r.choice.isOnePart = true; }, [](auto& f) { return f.isTree; }},
    };
    return kChoices;
}

}  // namespace

class ExportFileTest : public QObject {
    Q_OBJECT

private slots:
    void formatsAreFoundByTheEnding() {
        QCOMPARE(exportFormatOf("a/board.STP")->name, std::string_view("STEP"));
        QCOMPARE(exportFormatOf("board.stpz")->name, std::string_view("Compressed STEP"));
        QVERIFY(exportFormatOf("board.step.bak") == nullptr);
        QVERIFY(exportFormatOf("step") == nullptr);
        QVERIFY(exportEndings().ends_with(".svg or .pdf"));
        QCOMPARE(otherFileOf("a/board.obj"), fs::path("a/board.mtl"));
        QVERIFY(otherFileOf("a/board.stl").empty());
    }

    void everyFormatWritesItsFile() {
        const std::map<std::string_view, std::string> starts = {{"STEP", "ISO-10303-21;"},
                                                                {"Compressed STEP", "\x1f\x8b"},
                                                                {"GLB", "glTF"},
                                                                {"STL", ""},
                                                                {"OBJ", "#"},
                                                                {"DXF", "  0\nSECTION"},
                                                                {"SVG", "<"},
                                                                {"PDF", "%PDF-"}};
        const QTemporaryDir folder;
        for (const ExportFormat& format : exportFormats()) {
            const fs::path path = pathOf(folder, format);
            base::Progress progress;
            const auto summary = exportBoard(*smallBoard(), format, {}, path, progress);
            QVERIFY2(summary, format.name.data());
            const std::uint64_t beside = summary->beside.empty() ? 0 : fs::file_size(summary->beside);
            QCOMPARE(summary->bytes, std::uint64_t{fs::file_size(path)} + beside);
            const std::string& start = starts.at(format.name);
            QCOMPARE(QByteArray::fromStdString(startOf(path, start.size())), QByteArray::fromStdString(start));
            QVERIFY2(!summary->content.empty() && std::isdigit(summary->content.front()) != 0, format.name.data());
        }
    }

    void whatIsNotInTheFileIsSaid() {
        const QTemporaryDir folder;
        const ExportFormat& step = exportFormats().front();
        base::Progress progress;
        const auto summary = exportBoard(*smallBoard(), step, {}, pathOf(folder, step), progress);
        QVERIFY(summary && summary->missing.size() == 1);
        const NotExported& missing = summary->missing.front();
        QCOMPARE(missing.layer, std::string("top"));
        QCOMPARE(missing.file, std::string("features"));
        QCOMPARE(missing.line, 7U);
        QVERIFY(!missing.reason.empty() && missing.element.isValid());
    }

    void choicesOfOtherFormatsAreRefused() {
        const QTemporaryDir folder;
        for (const ExportFormat& format : exportFormats()) {
            for (const Choice& choice : choices()) {
                const fs::path path = pathOf(folder, format);
                ExportRequest request;
                choice.choose(request);
                base::Progress progress;
                const auto summary = exportBoard(*smallBoard(), format, request, path, progress);
                const auto estimate = estimateExport(*smallBoard(), format, request, progress);
                const std::string what = std::string(format.name).append(" ").append(choice.option);
                QVERIFY2(bool{summary} == choice.isKnown(format), what.c_str());
                QVERIFY2(bool{estimate} == choice.isKnown(format), what.c_str());
                QVERIFY2(fs::exists(path) == choice.isKnown(format), what.c_str());
                if (!summary) {
                    QCOMPARE(summary.error().code, base::ErrorCode::BadUsage);
                    QVERIFY2(summary.error().text.find(choice.option) != std::string::npos, what.c_str());
                }
                fs::remove(path);
            }
        }
    }

    void cancelledExportsLeaveNothing() {
        const QTemporaryDir folder;
        for (const ExportFormat& format : exportFormats()) {
            base::Progress progress;
            progress.cancel();
            const auto summary = exportBoard(*smallBoard(), format, {}, pathOf(folder, format), progress);
            QVERIFY2(!summary && summary.error().code == base::ErrorCode::Cancelled, format.name.data());
            QVERIFY2(fs::is_empty(folder.path().toStdString()), format.name.data());
        }
    }

    void onlyStepIsEstimated() {
        base::Progress progress;
        std::vector<double> bytes;
        for (const ExportFormat& format : exportFormats()) {
            const auto estimate = estimateExport(*smallBoard(), format, {}, progress);
            QVERIFY(estimate);
            QCOMPARE(estimate->has_value(), format.isStep);
            if (format.isStep) {
                bytes.push_back(double((*estimate)->bytes));
            }
        }
        QVERIFY(bytes.size() == 2 && bytes[0] > bytes[1] && bytes[1] > 0);  // packed files are smaller
    }

private:
    static fs::path pathOf(const QTemporaryDir& folder, const ExportFormat& format) {
        const std::string ending(format.endings.substr(0, format.endings.find(' ')));
        return fs::path(folder.path().toStdString()) / ("board" + ending);
    }
};

QTEST_APPLESS_MAIN(ExportFileTest)
#include "export_file_test.moc"
