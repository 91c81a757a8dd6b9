#include "model/export/drawings/dxf_drawing.h"

#include <QtTest>
#include <map>
#include <set>
#include <sstream>

#include "tests/unit/model/export/drawings/drawn_board.h"

namespace {

struct Group {
    int code = 0;
    std::string value;
};

/// A small reader: the entities of a drawing, each from its name on, and its layers.
struct Dxf {
    std::vector<Group> groups;
    std::vector<std::vector<Group>> entities;
    std::map<std::string, int> layers;  ///< name and colour

    explicit Dxf(const std::string& text) {
        std::istringstream lines(text);
        std::string code;
        std::string value;
        while (std::getline(lines, code) && std::getline(lines, value)) {
            groups.push_back({std::stoi(code), value});
        }
        std::string section;
        for (std::size_t i = 0; i < groups.size(); ++i) {
            if (groups[i].code == 2 && groups[i - 1].value == "SECTION") {
                section = groups[i].value;
            } else if (groups[i].code == 0 && section == "ENTITIES" && groups[i].value != "ENDSEC") {
                entities.emplace_back();
            } else if (groups[i].code == 0) {
                section = groups[i].value == "ENDSEC" ? "" : section;
            } else if (groups[i].value == "AcDbLayerTableRecord") {
                layers[groups[i + 1].value] = std::stoi(groups[i + 3].value);
            }
            if (section == "ENTITIES" && !entities.empty()) {
                entities.back().push_back(groups[i]);
            }
        }
    }

    static std::string text(const std::vector<Group>& entity, int code) {
        const auto found = std::ranges::find(entity, code, &Group::code);
        return found == entity.end() ? "" : found->value;
    }
    static double real(const std::vector<Group>& entity, int code) { return std::stod(text(entity, code)); }

    /// Counter-clockwise positive.
    static double areaOf(const std::vector<Group>& entity) {
        if (text(entity, 0) == "CIRCLE") {
            return std::numbers::pi * real(entity, 40) * real(entity, 40);
        }
        std::vector<std::array<double, 3>> corners;
        for (const Group& group : entity) {
            if (group.code == 10) {
                corners.push_back({std::stod(group.value), 0.0, 0.0});
            } else if (group.code == 20 || group.code == 42) {
                corners.back()[group.code == 20 ? 1 : 2] = std::stod(group.value);
            }
        }
        double area = 0.0;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const auto& a = corners[i];
            const auto& b = corners[(i + 1) % corners.size()];
            area += drawn_board::underChord(a[0], a[1], b[0], b[1]);
            if (a[2] != 0.0) {
                area += drawn_board::besideChord(std::hypot(b[0] - a[0], b[1] - a[1]), 4 * std::atan(a[2]));
            }
        }
        return area;
    }

    /// Of outlines and holes, in the order they are written.
    [[nodiscard]] std::vector<double> areasOn(const std::string& layer) const {
        std::vector<double> areas;
        for (const auto& entity : entities) {
            if (text(entity, 8) == layer) {
                areas.push_back(areaOf(entity));
            }
        }
        return areas;
    }
};

Dxf dxfOf(const model::Document& board, const model::DrawingOptions& options) {
    return Dxf(drawn_board::written(
        [&](model::FileWriter& file, base::Progress& progress) { return writeDxf(board, options, file, progress); }));
}

void compare(const std::vector<double>& areas, const std::vector<double>& expected) {
    QCOMPARE(areas.size(), expected.size());
    for (std::size_t i = 0; i < areas.size(); ++i) {
        QVERIFY2(std::abs(areas[i] - expected[i]) < 1e-6, std::to_string(areas[i]).c_str());
    }
}

}  // namespace

class DxfDrawingTest : public QObject {
    Q_OBJECT

private slots:
    void layersHaveTheirNamesAndColours() {
        model::DrawingOptions options;
        options.colours = {0xFF0000, 0x0000FF};
        const Dxf dxf = dxfOf(*drawn_board::board(), options);
        const std::map<std::string, int> expected{{"0", 7},
                                                  {"board outline", dxf.layers.at("drill")},
                                                  {"bottom", 5},
                                                  {"drill", dxf.layers.at("drill")},
                                                  {"top _1_", 1}};
        QCOMPARE(dxf.layers, expected);
        QCOMPARE(dxf.groups.back().value, std::string("EOF"));
    }

    void bodiesHaveTheirDesignators() {
        const Dxf dxf = dxfOf(*drawn_board::boardOfBodies(), {});
        std::vector<std::vector<std::string>> names;
        for (const auto& entity : dxf.entities) {
            if (Dxf::text(entity, 0) == "TEXT") {
                names.emplace_back();
                for (const int code : {1, 8, 11, 21, 40, 50, 72, 73}) {
                    names.back().push_back(Dxf::text(entity, code));
                }
            }
        }
        const std::vector<std::vector<std::string>> expected{{"R1", "bodies", "2", "1", "1.008", "0", "1", "2"},
                                                             {"U<10>", "bodies", "10.5", "4", "0.504", "90", "1", "2"}};
        QCOMPARE(names, expected);
    }

    /// In millimetres, arcs as bulges.
    void outlinesCoverWhatTheElementsDo() {
        const Dxf dxf = dxfOf(*drawn_board::board(), {});
        using namespace drawn_board;
        const double pi = std::numbers::pi;
        compare(dxf.areasOn("top _1_"), {kDisc, 4 * pi, pi, kTrack, kBend});
        compare(dxf.areasOn("bottom"), {400.0, 4 * pi});
        compare(dxf.areasOn("drill"), {pi / 4, pi});
        compare(dxf.areasOn("board outline"), {2400.0});
        const auto& disc = dxf.entities.front();
        QCOMPARE(Dxf::text(disc, 0), std::string("CIRCLE"));
        QCOMPARE(Dxf::text(disc, 10), std::string("3"));
        QCOMPARE(Dxf::text(disc, 20), std::string("4"));
    }

    void handlesAreUnique() {
        const Dxf dxf = dxfOf(*drawn_board::board(), {});
        std::set<std::string> handles;
        for (const Group& group : dxf.groups) {
            QVERIFY(group.code != 5 || group.value == "7FFFFFFF" || handles.insert(group.value).second);
        }
        QVERIFY(handles.size() > 20);
    }

    /// The copy that is turned over has the plane on top, mirrored.
    void copiesLieWhereTheyArePlaced() {
        const Dxf dxf = dxfOf(*drawn_board::panel(), {});
        compare(dxf.areasOn("board outline"), {2400.0, 2400.0});
        const std::vector<double> top = dxf.areasOn("top _1_");
        QCOMPARE(top.size(), std::size_t{7});
        QVERIFY(std::abs(top[5] - 400.0) < 1e-6);  // mirrored, and still counter-clockwise
        QCOMPARE(Dxf::real(dxf.entities.front(), 10), 103.0);
    }

    void whatIsNotDrawnIsListed() {
        const QTemporaryDir folder;
        model::FileWriter file(folder.filePath("drawing").toStdString());
        base::Progress progress;
        const auto report = model::writeDxf(*drawn_board::panel(), {}, file, progress);
        QVERIFY(report);
        QCOMPARE(report->notDrawn.size(), std::size_t{1});  // once, though its step is placed twice
        const model::NotDrawn& line = report->notDrawn.front();
        QCOMPARE(line.layer, std::string("top <1>"));
        QCOMPARE(line.file, std::string("layers/top/features"));
        QCOMPARE(line.line, 77U);
        QCOMPARE(line.reason, std::string_view("it has no width"));
        QCOMPARE(report->layers.size(), std::size_t{4});
        QCOMPARE(report->regions, std::uint64_t{16});
        QCOMPARE(progress.fraction(), 1.0F);
    }

    void failuresLeaveNothing() { drawn_board::checkFailures(model::writeDxf); }
};

QTEST_GUILESS_MAIN(DxfDrawingTest)
#include "dxf_drawing_test.moc"
