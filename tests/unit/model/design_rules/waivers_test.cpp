// Waivers: which findings they hold for, whatever the rows of the job, and what a file of them must be.
#include "model/clearance/waivers.h"

#include <QtTest>
#include <algorithm>
#include <map>

#include "model/board/document_builder.h"
#include "model/design_rules/waived_check.h"
#include "tests/unit/model/hand_made.h"

using namespace hand_made;
using model::Nm;
using model::Rule;
using model::RuleKind;
using model::RuleReport;
using model::RuleTable;
using model::Waiver;
using State = model::WaiverNote::State;
using Notes = std::vector<model::WaiverNote>;
using Board = std::shared_ptr<const model::Document>;

namespace {

struct Track {
    const char* net;
    model::Point from;
    model::Point to;
};

/// Tracks of 100 um on one layer, in the order of the list.
Board boardOf(const std::vector<Track>& tracks) {
    model::DocumentBuilder builder;
    builder.job().step = "pcb";
    const model::LayerId top = addLayer(builder, "top");
    std::map<std::string, model::NetId> nets;
    for (const Track& track : tracks) {
        if (!nets.contains(track.net)) {
            nets[track.net] = builder.addNet(track.net);
        }
    }
    builder.beginLayer(top);
    for (const Track& track : tracks) {
        builder.addLine({track.from, track.to, 100 * kUm, 0}, of(nets[track.net]));
    }
    return builder.finish();
}

/// Two tracks side by side, so far apart.
std::vector<Track> sideBySide(Nm apart) {
    return {{"A", {0, 0}, {5 * kMm, 0}}, {"B", {0, apart + 100 * kUm}, {5 * kMm, apart + 100 * kUm}}};
}

const RuleTable kRules{{}, {{RuleKind::CopperToCopper, 100 * kUm, {}}}};

RuleReport check(const Board& board, const std::vector<Waiver>& waivers, const RuleTable& rules = kRules,
                 const model::RuleScope& scope = {}) {
    base::Progress progress;
    return *model::checkRules(*board, rules, waivers, progress, scope);
}

Waiver said() {
    Waiver waiver;
    waiver.reason = "looked at";
    waiver.author = "Me";
    waiver.date = "2026-11-23";
    return waiver;
}

/// Of all findings.
std::vector<Waiver> waiversOf(const Board& board, const RuleTable& rules = kRules) {
    const model::SideNames names(*board);
    std::vector<Waiver> waivers;
    for (const model::RuleFinding& finding : check(board, {}, rules).findings) {
        waivers.push_back(model::waiverOf(*board, names, rules, finding, said()));
    }
    return waivers;
}

Notes notesOf(const RuleReport& report, State state) {
    Notes notes = report.waiverNotes;
    std::erase_if(notes, [&](const model::WaiverNote& note) { return note.state != state; });
    return notes;
}

}  // namespace

class WaiversTest : public QObject {
    Q_OBJECT

private slots:
    void waivedFindingsDoNotCount() {
        const Board board = boardOf(sideBySide(80 * kUm));
        const std::vector<Waiver> waivers = waiversOf(board);
        QCOMPARE(waivers.size(), std::size_t{1});
        QCOMPARE(waivers[0].distance, 80.0 * kUm);
        const RuleReport report = check(board, waivers);
        QVERIFY(report.isPassed() && report.waiverNotes.empty());
        QCOMPARE(report.waived.size(), std::size_t{1});
        QCOMPARE(report.waived[0].reason, std::string("looked at (Me, 2026-11-23)"));
        QVERIFY(model::verdictOf(kRules, report, 0) == model::Verdict::Passed);
        QCOMPARE(model::waivedOf(report, 0), std::size_t{1});
    }

    void everyFaultIsReadAgain() {
        const std::vector<Waiver> some = waiversOf(boardOf(sideBySide(80 * kUm)));
        for (std::size_t fault = 0; fault < model::kFindingReasonCount; ++fault) {
            std::vector<Waiver> waivers{some.front()};
            waivers[0].fault = static_cast<model::FindingReason>(fault);
            waivers[0].depth = waivers[0].fault == model::FindingReason::TooDeep ? 1.6e6 : 0.0;
            const auto again = model::parseWaivers(model::toJson(waivers));
            QVERIFY2(again, again ? "" : again.error().text.c_str());
            QVERIFY(*again == waivers);
        }
    }

    /// Rows, directions and names of nets may change: the location counts, also along tracks side by side.
    void rowsDoNotMatter() {
        const std::vector<Waiver> waivers = waiversOf(boardOf(sideBySide(80 * kUm)));
        std::vector<Track> tracks = sideBySide(80 * kUm);
        std::ranges::reverse(tracks);
        QVERIFY(check(boardOf(tracks), waivers).isPassed());
        std::swap(tracks[0].from, tracks[0].to);
        QVERIFY(check(boardOf(tracks), waivers).isPassed());
        tracks.insert(tracks.begin(), {"C", {0, 9 * kMm}, {kMm, 9 * kMm}});
        tracks[1].net = "GND";
        const RuleReport renamed = check(boardOf(tracks), waivers);
        QVERIFY(renamed.isPassed());
        QCOMPARE(notesOf(renamed, State::Renamed).size(), std::size_t{1});
        QVERIFY(renamed.waiverNotes[0].text.find("the nets are A and GND now") != std::string::npos);
    }

    void aFindingThatGotWorseCounts() {
        const std::vector<Waiver> waivers = waiversOf(boardOf(sideBySide(80 * kUm)));
        QVERIFY(check(boardOf(sideBySide(79'500)), waivers).isPassed());  // within the tolerance
        QVERIFY(check(boardOf(sideBySide(85 * kUm)), waivers).isPassed());
        const RuleReport worse = check(boardOf(sideBySide(79 * kUm)), waivers);
        QCOMPARE(worse.findings.size(), std::size_t{1});
        QCOMPARE(notesOf(worse, State::Worse).size(), std::size_t{1});
        QVERIFY2(worse.waiverNotes[0].text.find("only 79.000 um are left") != std::string::npos,
                 worse.waiverNotes[0].text.c_str());
    }

    void aFindingElsewhereCountsAndTheWaiverIsSaidToBeGone() {
        const std::vector<Waiver> waivers = waiversOf(boardOf(sideBySide(80 * kUm)));
        std::vector<Track> moved = sideBySide(80 * kUm);
        for (Track& track : moved) {
            track.from.y += 20 * kUm;
            track.to.y += 20 * kUm;
        }
        const RuleReport report = check(boardOf(moved), waivers);
        QCOMPARE(report.findings.size(), std::size_t{1});
        QCOMPARE(notesOf(report, State::Gone).size(), std::size_t{1});
        QVERIFY(report.waiverNotes[0].text.ends_with(": no finding there any more"));
        QCOMPARE(notesOf(check(boardOf(sideBySide(200 * kUm)), waivers), State::Gone).size(), std::size_t{1});
    }

    /// One finding stands for two nets on a layer; its waiver does not.
    void otherLocationsOfTheSameNetsCount() {
        std::vector<Track> tracks = sideBySide(80 * kUm);
        tracks.push_back({"A", {9 * kMm, 0}, {9 * kMm, kMm}});
        tracks.push_back({"B", {9 * kMm + 190 * kUm, 0}, {9 * kMm + 190 * kUm, kMm}});  // 90 um
        const Board board = boardOf(tracks);
        std::vector<Waiver> waivers = waiversOf(board);
        QCOMPARE(waivers.size(), std::size_t{1});
        const RuleReport second = check(board, waivers);
        QCOMPARE(second.waived.size(), std::size_t{1});
        QCOMPARE(second.findings.size(), std::size_t{1});
        QCOMPARE(second.findings[0].spacing.distance, 90.0 * kUm);
        const model::SideNames names(*board);
        waivers.push_back(model::waiverOf(*board, names, kRules, second.findings[0], said()));
        QCOMPARE(check(board, waivers).waived.size(), std::size_t{2});
        waivers.erase(waivers.begin());  // of the closer location
        const RuleReport first = check(board, waivers);
        QCOMPARE(first.waived.size(), std::size_t{1});
        QCOMPARE(first.findings[0].spacing.distance, 80.0 * kUm);
    }

    /// Who accepts every location gets all of them, also beside waivers that are there.
    void waiversLeaveAcceptedWhatWasAcceptedBefore() {
        std::vector<Track> tracks{{"C", {0, 20 * kMm}, {kMm, 20 * kMm}},
                                  {"D", {0, 20 * kMm + 170 * kUm}, {kMm, 20 * kMm + 170 * kUm}}};
        const std::vector<Waiver> old = waiversOf(boardOf(tracks));
        QCOMPARE(old.size(), std::size_t{1});
        std::ranges::copy(sideBySide(80 * kUm), std::back_inserter(tracks));
        for (const Nm x : {9 * kMm, 12 * kMm}) {
            tracks.push_back({"A", {x, 0}, {x, kMm}});
            tracks.push_back({"B", {x + 190 * kUm, 0}, {x + 190 * kUm, kMm}});
        }
        model::RuleScope scope;
        scope.isAccepted = [](const model::RuleFinding&) { return true; };
        const RuleReport report = check(boardOf(tracks), old, kRules, scope);
        QCOMPARE(report.waived.size(), std::size_t{1});
        QCOMPARE(report.findings.size(), std::size_t{3});
    }

    void whatWasNotLookedAtIsSaid() {
        const Board board = boardOf(sideBySide(80 * kUm));
        std::vector<Waiver> waivers = waiversOf(board);
        QVERIFY(model::waiversElsewhere(waivers, std::vector{board.get()}).empty());
        waivers[0].layer = "gone";
        QCOMPARE(notesOf(check(board, waivers), State::Unknown).size(), std::size_t{1});
        waivers = waiversOf(board);
        const RuleTable others{{}, {{RuleKind::HoleToHole, 100 * kUm, {}}}};
        QCOMPARE(notesOf(check(board, waivers, others), State::Unknown).size(), std::size_t{1});
        model::RuleScope scope;
        scope.between = {board->findNet("A"), board->findNet("B")};
        QVERIFY(check(boardOf(sideBySide(300 * kUm)), waivers, kRules, scope).waiverNotes.empty());
        waivers[0].step = "panel";
        QVERIFY(check(board, waivers).waiverNotes.empty());
        QCOMPARE(model::waiversElsewhere(waivers, std::vector{board.get()}).size(), std::size_t{1});
    }

    void waiversOutliveTheirFile() {
        std::vector<Waiver> waivers = waiversOf(boardOf(sideBySide(80 * kUm)));
        waivers.push_back(waivers[0]);
        waivers[1].fault = model::FindingReason::PadRemoved;
        waivers[1].kind = RuleKind::AnnularRing;
        waivers[1].sides[0].pin = "U1.3";
        waivers[1].reason = "\"Über\" <b>&";
        const auto again = model::parseWaivers(model::toJson(waivers));
        QVERIFY2(again, again ? "" : again.error().text.c_str());
        QVERIFY(*again == waivers);
        QVERIFY(model::parseWaivers("// none yet\n{\"copperscope_waivers\": 1, \"waivers\": []}"));
        QVERIFY(!model::readWaivers("/nowhere.json"));
    }

    void badWaiversAreNamed_data() {
        QTest::addColumn<QString>("from");
        QTest::addColumn<QString>("to");
        QTest::addColumn<QString>("word");
        QTest::newRow("reason") << R"("looked at")"
                                << R"(" ")"
                                << "line 12, waiver 1: \"reason\" must not be empty";
        QTest::newRow("author") << R"("Me")"
                                << "7"
                                << "line 13, waiver 1: \"author\" must be a text";
        QTest::newRow("date") << "2026-11-23"
                              << "2026-13-01"
                              << "line 14, waiver 1: \"date\"";
        QTest::newRow("kind") << R"("copper-copper")"
                              << R"("copper-sky")"
                              << "copper-sky";
        QTest::newRow("key") << R"("author")"
                             << R"("writer")"
                             << "line 13: unknown key \"writer\"";
        QTest::newRow("key of a side") << R"("net": "A")"
                                       << R"("net": "A", "nett": "A")"
                                       << "unknown key \"nett\"";
        QTest::newRow("no net") << R"("net": "A")"
                                << R"("pin": "A")"
                                << "\"sides/0\" needs a \"net\"";
        QTest::newRow("place") << R"("from_nm": [0, )"
                               << R"("from_nm": [0, 1, )"
                               << "\"from_nm\" must be two numbers";
        QTest::newRow("distance") << "80000"
                                  << "-1"
                                  << "line 9, waiver 1: \"distance_nm\"";
        QTest::newRow("no JSON") << "]"
                                 << ""
                                 << "no file of JSON: parse error at line";
        QTest::newRow("version") << R"("copperscope_waivers": 1)"
                                 << R"("copperscope_waivers": 2)"
                                 << "version 1";
        QTest::newRow("list") << R"("waivers": [)"
                              << R"("waivers": {}, "waivers": [)"
                              << "waivers is there twice";
    }
    void badWaiversAreNamed() {
        QFETCH(QString, from);
        QFETCH(QString, to);
        QFETCH(QString, word);
        QString text = R"({
"copperscope_waivers": 1,
"waivers": [{
"kind": "copper-copper",
"step": "pcb",
"layer": "top",
"from_nm": [0, 50000],
"to_nm": [0, 130000],
"distance_nm": 80000,
"sides": [{"net": "A", "kind": "track"},
          {"net": "B", "kind": "track"}],
"reason": "looked at",
"author": "Me",
"date": "2026-11-23"}]})";
        QVERIFY(model::parseWaivers(text.toStdString()));
        text.replace(text.indexOf(from), from.size(), to);
        const auto waivers = model::parseWaivers(text.toStdString());
        QVERIFY(!waivers);
        QVERIFY2(QString::fromStdString(waivers.error().text).contains(word), waivers.error().text.c_str());
    }

    void twoWaiversOfOneLocationAreAnError() {
        std::vector<Waiver> waivers = waiversOf(boardOf(sideBySide(80 * kUm)));
        waivers.push_back(waivers[0]);
        std::swap(waivers[1].from, waivers[1].to);
        waivers[1].from.x += 9 * kUm;
        waivers[1].reason = "another reason";
        const auto twice = model::parseWaivers(model::toJson(waivers));
        QVERIFY(!twice);
        QVERIFY2(twice.error().text.find("the location of waiver 1 again") != std::string::npos,
                 twice.error().text.c_str());
        waivers[1].from.x += 2 * kUm;
        QVERIFY(model::parseWaivers(model::toJson(waivers)));
    }
};

QTEST_GUILESS_MAIN(WaiversTest)
#include "waivers_test.moc"
