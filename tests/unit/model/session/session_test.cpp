#include "model/session/session.h"

#include <QtTest>
#include <atomic>
#include <cstring>
#include <thread>

#include "model/base/thickness_units.h"
#include "model/board/stackup.h"
#include "model/board/thickness_override.h"
#include "tests/unit/model/session/session_board.h"

using namespace session_board;
using model::Measurement;
using model::session::colourFrom;
using model::session::colourText;
using model::session::findNets;
using model::session::KnownPart;
using model::session::LoadedSession;
using model::session::loadSession;
using model::session::SavedNet;
using model::session::SavedView;
using model::session::saveMeasurements;
using model::session::saveNets;
using model::session::saveThicknesses;
using model::session::saveViews;
using model::session::Session;
using model::session::sessionPath;
namespace fs = std::filesystem;

namespace {

model::session::Desk desk() {
    return {"pcb",
            {{1.5, -2.25, 0.1}, 30.0, 0.0, -90.0, true, model::Point{50'000'001, -40'000'000}},
            {{0, 0, 0}, 80.5, 33.0, -40.0, false},
            "mil",
            {{"TOP", false, 40, 0x0a80ffU}, {"SMT", true, 100, std::nullopt}},
            "SMT"};
}

SavedView selectionOf(std::vector<model::session::SavedElement> elements) {
    SavedView kept;
    kept.name = "Clocks";
    kept.step = "pcb";
    kept.selection = {{{"pcb", "CLK"}}, std::move(elements)};
    return kept;
}

Measurement measuredAngle() {
    Measurement angle = measured("angle");
    angle.kind = model::MeasurementKind::Angle;
    angle.corner = {7.0, -8.5, "TOP", "GND", "end"};
    return angle;
}

Measurement measuredLength() {
    Measurement length = measured("length");
    length.kind = model::MeasurementKind::Length;
    length.path = {{{"TOP", 4.0, {{0, 0}, {3, 0}, {3, 0.5}}}, {"SMT", 1e10, {{3, 0.5}, {4.25, -7}}}}, 1, 13.0};
    return length;
}

/// Of a session with one view whose poses say `more`.
std::vector<SavedView> viewsWith(const Location& location, const std::string& more) {
    const std::string pose = R"({"target_mm": [1, 2, 3], "distance_mm": 5, "yaw_deg": 0, "pitch_deg": 0, )"
                             R"("parallel": true)" +
                             more + "}";
    location.write(R"({"copperscope_session": 1, "job": "everything", "views": [{"name": "a", "step": "pcb",)"
                   R"("layers": [], "flat": )" +
                   pose + R"(, "solid": )" + pose + "}]}");
    return location.load().session.views;
}

}  // namespace

class SessionTest : public QObject {
    Q_OBJECT

private slots:
    // ---- thicknesses as text ----

    void thicknessesAreReadInAllUnits_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<int>("nm");
        QTest::newRow("um") << "35um" << 35'000;
        QTest::newRow("µm with a blank") << " 17.5 µm " << 17'500;
        QTest::newRow("mm") << "0.2mm" << 200'000;
        QTest::newRow("mil") << "4 mil" << 101'600;
        QTest::newRow("inch") << "0.062inch" << 1'574'800;
        QTest::newRow("in") << ".01 in" << 254'000;
        QTest::newRow("oz") << "2oz" << 69'600;
        QTest::newRow("comma") << "1,5mm" << 1'500'000;
        QTest::newRow("comma below one") << "0,125 mm" << 125'000;
    }
    void thicknessesAreReadInAllUnits() {
        QFETCH(QString, text);
        QFETCH(int, nm);
        const auto read = model::parseThickness(text.toStdString(), true);
        QVERIFY2(read.ok(), read.ok() ? "" : read.error().text.c_str());
        QCOMPARE(*read, nm);
    }

    void whatIsNoThicknessIsRefused() {
        for (const char* text : {"", "35", "um", "35 km", "-5um", "0mm", "0.5um", "11mm", "nan mm", "inf um", "1e9mm",
                                 "35umm", "35 um um", "1,000 um", "1,5,2mm", "1,5.2mm", "1.5,2mm", ",5mm", "1,mm"}) {
            const auto read = model::parseThickness(text, true);
            QVERIFY2(!read, text);
            QCOMPARE(read.error().code, base::ErrorCode::BadUsage);
        }
        QVERIFY(!model::parseThickness("1oz", false));
    }

    void textIsReadBackAsItWas() {
        for (const model::Nm nm : {1'000, 17'399, 35'000, 999'999, 1'000'000, 1'574'803, 10'000'000}) {
            QCOMPARE(*model::parseThickness(model::thicknessText(nm), false), nm);
        }
        QCOMPARE(model::thicknessText(35'000), "35 µm");
        QCOMPARE(model::thicknessText(1'200'000), "1.2 mm");
    }

    void overridesNameARowOfTheStack() {
        const Location location;
        const auto good = model::parseOverride("core1 = 0.3mm", location.document->stackup);
        QVERIFY(good.ok());
        QCOMPARE(good->layer, "CORE1");
        QCOMPARE(good->thickness, 300'000);
        const auto bad = model::parseOverride("CORE9=0.3mm", location.document->stackup);
        QVERIFY(!bad && bad.error().text.find("CORE1, Inner Plane") != std::string::npos);
        QVERIFY(!model::parseOverride("CORE1=1oz", location.document->stackup));
        QVERIFY(!model::parseOverride("CORE1", location.document->stackup));
    }

    // ---- the file ----

    void theFileLiesBesideTheJob() {
        QCOMPARE(sessionPath("/a/b/job.tgz"), fs::path("/a/b/job.tgz.copperscope.json"));
        QCOMPARE(sessionPath("/a/b/job/"), fs::path("/a/b/job.copperscope.json"));
        QCOMPARE(sessionPath("/a/b/../job"), fs::path("/a/job.copperscope.json"));
    }

    void whatIsSavedIsLoaded() {
        const Location location;
        QVERIFY(location.load().session == Session() && location.load().ignored.empty());
        const Session session{{{"TOP", 70'000}, {"CORE1", 300'000}},
                              {viewNamed("Über \"U1\""), viewNamed("")},
                              {},
                              std::nullopt,
                              {measured("gap"), measured("")}};
        QVERIFY(location.save(session.thicknesses).ok());
        QVERIFY(location.save(session.views).ok());
        QVERIFY(saveMeasurements(location.board, *location.document, session.measurements).ok());
        QVERIFY(location.load().session == session);
        QVERIFY(location.load().ignored.empty());
        const auto document = model::session::applyThicknesses(location.document, session.thicknesses);
        QCOMPARE(model::findRow(document->stackup, "CORE1")->thickness, 300'000);
        QCOMPARE(model::findRow(document->stackup, "CORE1")->source, model::Source::Session);
        QVERIFY(model::session::applyThicknesses(location.document, {}) == location.document);
    }

    void setsOfLayersAreReadBack() {
        const Location location;
        const std::vector<model::session::LayerSet> sets = {{"Power", {"GND", "VCC"}}, {"None", {}}};
        QVERIFY(model::session::saveLayerSets(location.board, *location.document, sets).ok());
        QVERIFY(location.load().session.layerSets == sets && location.load().ignored.empty());
        location.write(R"({"copperscope_session": 1, "job": "everything", "layer_sets": [{"name": 7, "layers": []}]})");
        QCOMPARE(location.load().ignored.size(), std::size_t{1});
    }

    void rulesAndWaiversAreReadBack() {
        const Location location;
        model::RuleTable rules = model::defaultRules();
        rules.classes = {{"power", {"V*"}}};
        rules.rules[0].classes = {"power", ""};
        model::Waiver waiver{model::RuleKind::HoleToHole,
                             model::FindingReason::TooClose,
                             "pcb",
                             "drill",
                             {1, 2},
                             {3, 4},
                             2.5,
                             {{{"A", "U1.1", "via"}, {"(board edge)", "", ""}}},
                             "fine",
                             "Me",
                             "2026-11-23"};
        QVERIFY(model::session::saveDesignRules(location.board, *location.document, rules).ok());
        QVERIFY(model::session::saveWaivers(location.board, *location.document, {waiver}).ok());
        const LoadedSession found = location.load();
        QVERIFY(found.ignored.empty());
        QVERIFY(found.session.designRules == rules);
        QVERIFY(found.session.waivers == std::vector{waiver});
        QVERIFY(model::session::saveDesignRules(location.board, *location.document, std::nullopt).ok());
        QVERIFY(model::session::saveWaivers(location.board, *location.document, {}).ok());
        QVERIFY(!fs::exists(sessionPath(location.board)));
        location.write(R"({"copperscope_session": 1, "job": "everything", "waivers": [{"kind": "hole-hole"}],)"
                       R"("design_rules": {"copperscope_rules": 1, "rules": [{"kind": "hole-sky", "least_um": 1}]}})");
        QCOMPARE(location.load().ignored.size(), std::size_t{2});
        QVERIFY(location.load().ignored[1].find("hole-sky") != std::string::npos);
    }

    void nothingChangedIsNoFile() {
        const Location location;
        QVERIFY(location.save(kOneThickness).ok());
        QVERIFY(location.save(std::vector{viewNamed("a")}).ok());
        QVERIFY(location.save(kNoThickness).ok());
        QCOMPARE(location.load().session.views.size(), std::size_t{1});
        QVERIFY(location.save(std::vector<SavedView>()).ok());
        QVERIFY(!fs::exists(sessionPath(location.board)));
        QVERIFY(location.save(kNoThickness).ok());
        QVERIFY(fs::is_empty(location.folder.path()));
    }

    void unknownPartsAreNamedAndKept() {
        const Location location;
        location.write(R"({"copperscope_session": 1, "job": "everything", "bookmarks": [1, 2],)"
                       R"("thickness_nm": {"TOP": 70000, "GONE": 5000, "CORE1": "thick", "CORE2": 5, "SMT": 1e99}})");
        const LoadedSession found = location.load();
        QVERIFY((found.session == Session{kOneThickness, {}, {}, std::nullopt, {}}));
        QCOMPARE(found.ignored.size(), std::size_t{5});
        for (const char* part : {"bookmarks", "GONE", "CORE1", "CORE2", "SMT"}) {
            QVERIFY2(std::ranges::any_of(found.ignored,
                                         [&](const std::string& text) { return text.find(part) != std::string::npos; }),
                     part);
        }
        QVERIFY(location.save(kNoThickness).ok());
        QVERIFY(location.file().find("bookmarks") != std::string::npos);
        QVERIFY(location.file().find("thickness_nm") == std::string::npos);
    }

    void whatIsNoViewIsNamed() {
        const Location location;
        const std::string pose =
            R"({"target_mm": [1, 2, 3], "distance_mm": 5, "yaw_deg": 0, "pitch_deg": 0, "parallel": true})";
        const std::string far =
            R"({"target_mm": [1, 2, 1e300], "distance_mm": 5, "yaw_deg": 0, "pitch_deg": 0, "parallel": true})";
        const std::string inside =
            R"({"target_mm": [1, 2, 3], "distance_mm": 0, "yaw_deg": 0, "pitch_deg": 0, "parallel": true})";
        const auto view = [](const std::string& flat, const std::string& solid, const char* layers = "[]") {
            return R"({"name": "a", "step": "pcb", "layers": )" + std::string(layers) + R"(, "flat": )" + flat +
                   R"(, "solid": )" + solid + "}";
        };
        location.write(R"({"copperscope_session": 1, "job": "everything", "views": [)" + view(pose, pose) + ", 7, " +
                       view(far, pose) + ", " + view(pose, inside) + ", " + view(pose, "[]") + ", " +
                       view(pose, pose, "[1]") + "]}");
        const LoadedSession found = location.load();
        QCOMPARE(found.session.views.size(), std::size_t{1});
        QCOMPARE(found.ignored.size(), std::size_t{5});
        QVERIFY(found.ignored[0].find("view 2") != std::string::npos);
        location.write(R"({"copperscope_session": 1, "job": "everything", "views": {"name": "a"}})");
        QCOMPARE(location.load().ignored.size(), std::size_t{1});
    }

    void whatTheWindowShowedIsLoaded() {
        const Location location;
        QVERIFY(model::session::saveDesk(location.board, *location.document, desk()).ok());
        QVERIFY(location.save(kOneThickness).ok());
        const LoadedSession found = location.load();
        QVERIFY(found.session.desk == desk());
        QCOMPARE(found.session.thicknesses, kOneThickness);
        QVERIFY(found.ignored.empty());
    }

    /// Those of older versions have neither.
    void camerasSayWhereTheMiddleOfTheBoardWasAndHowWideTheirViewWas() {
        const Location location;
        QCOMPARE(viewsWith(location, "").size(), std::size_t{1});
        QVERIFY(!viewsWith(location, "").front().flat.origin && !viewsWith(location, "").front().flat.aspect);
        const std::vector<SavedView> found = viewsWith(location, R"(, "origin_nm": [5000000, -7], "aspect": 1.5)");
        QCOMPARE(found.size(), std::size_t{1});
        QVERIFY(found.front().solid.origin == std::optional(model::Point{5'000'000, -7}));
        QCOMPARE(found.front().solid.aspect.value_or(0.0), 1.5);
        for (const char* wrong : {"7", "[1]", "[1, 2, 3]", "[0.5, 0]", R"(["1", 0])", "[1, 1000000000000000000]"}) {
            QVERIFY2(viewsWith(location, std::string(R"(, "origin_nm": )") + wrong).empty(), wrong);
        }
        for (const char* wrong : {"0", "-1", "[1]", R"("1")", "1e9"}) {
            QVERIFY2(viewsWith(location, std::string(R"(, "aspect": )") + wrong).empty(), wrong);
        }
    }

    void coloursOfTheBoardAreKept() {
        const Location location;
        const model::BoardColourChoice chosen{model::BoardColour::Purple, std::nullopt, model::SurfaceFinish::Tin};
        QVERIFY(model::session::saveBoardColours(location.board, *location.document, chosen).ok());
        const LoadedSession found = location.load();
        QVERIFY(found.session.boardColours == chosen);
        QVERIFY(found.ignored.empty());
        QVERIFY(model::session::saveBoardColours(location.board, *location.document, {}).ok());
        QVERIFY(!fs::exists(sessionPath(location.board)));
        location.write(R"({"copperscope_session": 1, "job": "everything", "board_colours": {"finish": "pink"}})");
        QCOMPARE(location.load().ignored.size(), std::size_t{1});
        QVERIFY(location.load().session.boardColours == model::BoardColourChoice{});
    }

    void layersThatAreGoneAreNamed() {
        const Location location;
        model::session::Desk other = desk();
        other.layers.push_back({"INNER9", true, 100, std::nullopt});
        other.layers.push_back({"INNER7", true, 100, std::nullopt});
        QVERIFY(model::session::saveDesk(location.board, *location.document, other).ok());
        const LoadedSession found = location.load();
        QVERIFY(found.session.desk == desk());
        QCOMPARE(found.ignored.size(), std::size_t{1});
        QVERIFY(found.ignored[0].find("INNER9, INNER7") != std::string::npos);
    }

    void whatIsNoDeskIsNamed() {
        const Location location;
        QVERIFY(model::session::saveDesk(location.board, *location.document, desk()).ok());
        const std::string good = location.file();
        const std::pair<const char*, const char*> faults[] = {{"\"mil\"", "\"furlong\""},
                                                              {"#0a80ff", "#0a80f"},
                                                              {"#0a80ff", "#0a80fff"},
                                                              {"#0a80ff", "orange"},
                                                              {": 40", ": 101"},
                                                              {": 40", ": \"40\""},
                                                              {"false", "0"},
                                                              {": 80.5", ": 0"},
                                                              {"\"TOP\"", "7"}};
        for (const auto& [from, to] : faults) {
            std::string bad = good;
            const std::size_t at = bad.find(from);
            QVERIFY2(at != std::string::npos, from);
            location.write(bad.replace(at, std::string(from).size(), to));
            QVERIFY2(!location.load().session.desk, to);
            QCOMPARE(location.load().ignored.size(), std::size_t{1});
        }
    }

    void selectionsAreKeptAmongTheViews() {
        const Location location;
        const std::vector<SavedView> both{viewNamed("a"),
                                          selectionOf({{"TOP", model::ElementKind::Trail, {{-5, 0}, {1'000'000, 7}}}})};
        QVERIFY(location.save(both).ok());
        QVERIFY(location.load().session.views == both);
        std::string bad = location.file();
        location.write(bad.replace(bad.find("trail"), 5, "snail"));
        QCOMPARE(location.load().session.views.size(), std::size_t{1});
        QCOMPARE(location.load().ignored.size(), std::size_t{1});
    }

    /// Views of older versions have no nets: their text is what it was.
    void viewsKeepTheNamesOfHighlightedNets() {
        const Location location;
        std::vector<SavedView> views{viewNamed("a"), viewNamed("b")};
        QVERIFY(location.save(views).ok());
        QVERIFY(location.file().find("nets") == std::string::npos);
        views[1].nets = {{"pcb", "GND"}, {"pcb", "CLK"}};
        QVERIFY(location.save(views).ok());
        QVERIFY(location.load().session.views == views);
        std::string bad = location.file();
        location.write(bad.replace(bad.find("\"CLK\""), 5, "7"));
        QCOMPARE(location.load().session.views.size(), std::size_t{1});
        QCOMPARE(location.load().ignored.size(), std::size_t{1});
    }

    /// As with nets.
    void viewsKeepThePlacesOfSelectedElements() {
        const Location location;
        std::vector<SavedView> views{viewNamed("a"), viewNamed("b")};
        QVERIFY(location.save(views).ok());
        QVERIFY(location.file().find("elements") == std::string::npos);
        views[1].elements = {{"TOP", model::ElementKind::Trail, {{-5, 0}, {1'000'000, 7}}}};
        QVERIFY(location.save(views).ok());
        QVERIFY(location.load().session.views == views);
        std::string bad = location.file();
        location.write(bad.replace(bad.find("trail"), 5, "snail"));
        QCOMPARE(location.load().session.views.size(), std::size_t{1});
        QCOMPARE(location.load().ignored.size(), std::size_t{1});
    }

    void elementsAreFoundWhereTheyWere_data() {
        QTest::addColumn<QString>("job");
        QTest::newRow("board") << "everything";
        QTest::newRow("panel") << "panel";
    }
    void elementsAreFoundWhereTheyWere() {
        QFETCH(QString, job);
        const auto document = odb_testing::read(odb_testing::dataJob(job.toStdString().c_str()));
        const model::StepTree tree = model::unfoldCopies(*document);
        std::vector<model::BoardElement> some;
        for (std::uint32_t copy = 0; copy < tree.copies.size(); ++copy) {
            const std::size_t count = tree.steps[tree.copies[copy].step]->elements.size();
            for (std::size_t i = 0; i < count; ++i) {
                some.push_back({copy, model::ElementId{i}});
            }
        }
        QVERIFY(some.size() > 5);
        model::session::SavedSelection kept = model::session::saveSelection(tree, some, {});
        QCOMPARE(kept.elements.size(), some.size());
        QCOMPARE(model::session::findSelection(tree, kept).elements, some);
        kept.elements[0].box.min.x -= 1;
        kept.elements[1].layer = "NO_SUCH";
        const model::session::FoundSelection found = model::session::findSelection(tree, kept);
        QCOMPARE(found.missingElements, std::size_t{2});
        QCOMPARE(found.elements.size(), some.size() - 2);
    }

    void netsAreFoundByTheirNames() {
        const auto document = odb_testing::read(odb_testing::dataJob("everything"));
        const model::StepTree tree = model::unfoldCopies(*document);
        const std::vector<model::BoardNet> nets{{0, model::NetId{std::size_t{0}}}, {0, model::NetId{std::size_t{1}}}};
        model::session::SavedSelection kept = model::session::saveSelection(tree, {}, nets);
        QCOMPARE(model::session::findSelection(tree, kept).nets, nets);
        kept.nets[0].name = "NO_SUCH";
        kept.nets.push_back({"another step", kept.nets[1].name});
        const model::session::FoundSelection found = model::session::findSelection(tree, kept);
        QCOMPARE(found.nets, std::vector{nets[1]});
        QCOMPARE(found.missingNets, (std::vector<std::string>{"NO_SUCH", kept.nets[1].name}));
    }

    void everyKindOfMeasurementIsReadBack() {
        const Location location;
        Measurement planar = measured("planar");
        planar.kind = model::MeasurementKind::Spacing;
        planar.isPlanar = true;
        const std::vector all{measured("gap"), measuredAngle(), measuredLength(), planar};
        QVERIFY(saveMeasurements(location.board, *location.document, all).ok());
        QVERIFY(location.load().session.measurements == all);
    }

    void oldNamesOfPartsAreStillRead() {
        const Location location;
        QVERIFY(saveMeasurements(location.board, *location.document, {measuredLength()}).ok());
        std::string text = location.file();
        text.replace(text.find("\"path\""), 6, "\"way\"");
        text.replace(text.find("\"notes\""), 7, "\"remarks\"");
        location.write(text);
        QCOMPARE(location.load().session.measurements, std::vector{measuredLength()});
        model::session::Desk other = desk();
        other.layers.front().layer = "SMT coat";
        QVERIFY(model::session::saveDesk(location.board, *location.document, other).ok());
        QCOMPARE(location.load().session.desk->layers.front().layer, std::string("SMT solder mask"));
    }

    void aLayerOfTheJobMayHaveANameThatMasksHad() {
        Location location;
        const auto board = std::make_shared<model::Document>(*location.document);
        board->layers.front().name = "conformal coat";
        location.document = board;
        model::session::Desk styled = desk();
        styled.layers.front().layer = "conformal coat";
        QVERIFY(model::session::saveDesk(location.board, *board, styled).ok());
        SavedView view = viewNamed("a");
        view.layers = {"conformal coat", "SMT coat"};
        QVERIFY(location.save(std::vector{view}).ok());
        QVERIFY(model::session::saveLayerSets(location.board, *board, {{"Coats", view.layers}}).ok());
        const Session found = location.load().session;
        QCOMPARE(found.desk->layers.front().layer, std::string("conformal coat"));
        const std::vector<std::string> now{"conformal coat", "SMT solder mask"};
        QCOMPARE(found.views.front().layers, now);
        QCOMPARE(found.layerSets.front().layers, now);
    }

    void whatLacksItsPartsIsNoMeasurement() {
        const Location location;
        QVERIFY(saveMeasurements(location.board, *location.document, {measuredAngle(), measuredLength()}).ok());
        const std::string good = location.file();
        const std::pair<const char*, const char*> wrongs[] = {{"\"corner\"", "\"other\""},
                                                              {"\"kind\": \"angle\"", "\"kind\": \"angel\""},
                                                              {"\"path\"", "\"patch\""},
                                                              {"\"holes\": 1", "\"holes\": -1"},
                                                              {"\"length_nm\": 4", "\"length_nm\": -4"},
                                                              {"\"a remark\"", "7"}};
        for (const auto& [right, wrong] : wrongs) {
            std::string text = good;
            QVERIFY2(text.find(right) != std::string::npos, right);
            text.replace(text.find(right), std::strlen(right), wrong);
            location.write(text);
            const LoadedSession found = location.load();
            QVERIFY2(found.session.measurements.size() == 1 && found.ignored.size() == 1, right);
        }
    }

    void whatIsNoMeasurementIsNamed() {
        const Location location;
        QVERIFY(
            saveMeasurements(location.board, *location.document, {measured("a"), measured("b"), measured("c")}).ok());
        std::string text = location.file();
        text.replace(text.find("\"overlap_nm\": 0.25"), 18, "\"overlap_nm\": -5.0");
        text.replace(text.rfind("\"TOP\""), 5, "99999");
        location.write(text);
        const LoadedSession found = location.load();
        QCOMPARE(found.session.measurements, std::vector{measured("b")});
        QCOMPARE(found.ignored.size(), std::size_t{2});
        QVERIFY(found.ignored[1].find("measurement 3") != std::string::npos);
    }

    void measurementsAreATableForOthers() {
        const std::string csv =
            model::measurementsCsv({measured("a,b"), measuredAngle(), measuredLength(), measured("c")});
        QCOMPARE(std::ranges::count(csv, '\n'), 5);
        QStringList lines = QString::fromStdString(csv).split('\n');
        // 3, 4 and 12 nm: 13 nm in all.
        QVERIFY2(lines[1].startsWith("\"a,b\",pcb,edge to edge,0.000013,0.0005,,0.000003,0.000004,0.000012,"),
                 csv.c_str());
        QVERIFY2(lines[1].endsWith(",a remark,pad U1.7,"), csv.c_str());
        QVERIFY2(lines[2].startsWith("angle,pcb,angle,,,"), csv.c_str());
        QVERIFY2(lines[3].startsWith("length,pcb,along a net,10000.000017,"), csv.c_str());
        QVERIFY2(lines[3].contains("TOP 0.000004; SMT 10000.000000; 1 holes 0.000013"), csv.c_str());
        for (int row : {0, 2, 3, 4}) {
            QCOMPARE(lines[row].count(','), lines[0].count(','));
        }
    }

    void anotherBoardsSessionIsIgnored() {
        const Location location;
        location.write(R"({"copperscope_session": 1, "job": "other", "thickness_nm": {"TOP": 70000}})");
        const LoadedSession found = location.load();
        QVERIFY(found.session == Session());
        QCOMPARE(found.ignored.size(), std::size_t{1});
        QVERIFY(found.ignored[0].find("other") != std::string::npos);
        const auto saved = location.save(kNoThickness);
        QVERIFY(!saved);
        QVERIFY2(saved.error().text.ends_with("the file there is the session of another board, \"other\""),
                 saved.error().text.c_str());
    }

    void looksOfNetsAreKeptByName() {
        const Location location;
        const std::vector<SavedNet> nets = {{"GND", "BOARD", 0x00e69f00, false},
                                            {"LOST", "BOARD", std::nullopt, true},
                                            {"GND", "another step", 0x00000001, true}};
        QVERIFY(saveNets(location.board, *location.document, nets).ok());
        LoadedSession found = location.load();
        QCOMPARE(found.session.nets, nets);
        QVERIFY2(found.ignored.empty(), "nets of steps that are not shown are no matter");
        model::StepTree tree = model::unfoldCopies(*location.document);
        const auto at = findNets(tree, nets);
        QCOMPARE(at[0], std::optional(model::BoardNet{0, location.document->findNet("GND")}));
        QVERIFY(at[1] && !at[2]);
        QVERIFY(saveNets(location.board, *location.document, {}).ok());
        QVERIFY(!fs::exists(sessionPath(location.board)));
    }

    void netsThatAreNotThereAreToldAndNotLost() {
        const Location location;
        std::string text =
            "{'copperscope_session': 1, 'job': 'everything', 'nets': ["
            "{'name': 'GONE', 'step': 'BOARD', 'hidden': true}, {'name': 'GND'}, 7,"
            "{'name': 'GND', 'step': 'BOARD', 'colour': 'red'},"
            "{'name': 'GND', 'step': 'BOARD', 'colour': '#12345g'}]}";
        std::ranges::replace(text, '\'', '"');
        location.write(text);
        const LoadedSession found = location.load();
        QCOMPARE(found.session.nets, (std::vector<SavedNet>{{"GONE", "BOARD", std::nullopt, true}}));
        QCOMPARE(found.ignored.size(), std::size_t{5});
        QVERIFY(found.ignored.back().find("GONE") != std::string::npos);
    }

    void coloursAreWrittenAsTheyAreRead() {
        for (const std::uint32_t colour : {0x000000U, 0x000001U, 0xe69f00U, 0xffffffU}) {
            QCOMPARE(colourFrom(colourText(colour)), std::optional(colour));
        }
        for (const char* text : {"", "#", "#12345", "#1234567", "1234567", "#-12345", "#00000x"}) {
            QVERIFY(!colourFrom(text));
        }
    }
};

QTEST_APPLESS_MAIN(SessionTest)
#include "session_test.moc"
